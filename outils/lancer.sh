#!/bin/sh
# Le programme de « make application » : sans UTF-8, Java ne trouverait pas ses fichiers dans un dossier accentué.
[ "$(locale charmap 2>/dev/null)" = UTF-8 ] || export LC_ALL=C.UTF-8
exec "$(dirname "$(readlink -f "$0")")/lanceur" "$@"
