#!/bin/sh
# Installe ce que demandent « make » et « make test » sur un Debian ou un Ubuntu, et rien si tout est là. sudo ne sert qu'à qui n'est pas root.
set -eu

paquets=
demander() {
    paquets="$paquets $1"
}
command -v mvn >/dev/null || demander maven
command -v make >/dev/null || demander make
if [ "$(uname)" = Linux ]; then
    # un JDK sans partie graphique a javac, mais n'ouvre pas de fenêtre
    javac=$(readlink -f "$(command -v javac)" || true)
    [ -e "${javac%/*/*}/lib/libawt_xawt.so" ] || demander default-jdk
    command -v xvfb-run >/dev/null || demander xvfb
    command -v xauth >/dev/null || demander xauth
    command -v setxkbmap >/dev/null || demander x11-xkb-utils
    # sans lui, la correction d'une classe n'est essayée que sans confinement
    command -v bwrap >/dev/null || demander bubblewrap
else
    # le javac d'un Mac sans JDK est un programme qui propose d'en installer un
    javac -version >/dev/null 2>&1 || demander default-jdk
fi
[ -n "$paquets" ] || exit 0

command -v apt-get >/dev/null || { echo "Il manque$paquets : à installer comme docs/construire.md le dit, car ce système n'a pas apt-get" >&2; exit 1; }
root=
if [ "$(id -u)" != 0 ]; then
    root=sudo
    command -v sudo >/dev/null || { echo "Il manque$paquets : à faire installer par root, avec « apt-get install$paquets »" >&2; exit 1; }
fi
echo "Installation de$paquets"
$root apt-get update -qq
# shellcheck disable=SC2086
$root env DEBIAN_FRONTEND=noninteractive DEBCONF_NOWARNINGS=yes apt-get install -y -qq --no-install-recommends $paquets >/dev/null
