#!/usr/bin/env bash
# Ce que coûte --auto, et ce qu'il donne, dans une machine virtuelle qui démarre à chaque image. Médianes de TOURS tours (5).
# - Une erreur voulue : le temps de tout le programme, moins celui du même qui dessine l'image avec les réglages qu'il a choisis,
#   tour à tour ; l'image doit être la même. C'est ce que l'on paie en plus ; « dits » est ce que le programme en écrit.
# - Un temps voulu : l'erreur mesurée, et le temps des essais et du dessin.
set -euo pipefail
cd "$(dirname "$0")/.."
JAVA=${JAVA:-java}
TOURS=${TOURS:-5}
jar=antialias/target/antialias.jar
dossier=$(mktemp -d)
trap 'rm -rf "$dossier"' EXIT

# lancer OPTIONS… : secondes de tout le programme ; ce qu'il dit est dans $dossier/dit
lancer() {
    local debut=$EPOCHREALTIME
    $JAVA -jar $jar "$@" 2> "$dossier/dit" || { cat "$dossier/dit" >&2; exit 1; }
    awk -v a="$debut" -v b="$EPOCHREALTIME" 'BEGIN { printf "%.4f", b - a }'
}

# dit MOTIF : ce que le motif, une expression avec un groupe, trouve dans ce qui est dit
dit() {
    sed -nE "s/.*$1.*/\1/p" "$dossier/dit"
}

# medianes : celle de chaque colonne de l'entrée
medianes() {
    awk '{ for (c = 1; c <= NF; c++) v[c, NR] = $c }
        END { for (c = 1; c <= NF; c++) {
            for (i = 2; i <= NR; i++) for (j = i; j > 1 && v[c, j] < v[c, j - 1]; j--) {
                t = v[c, j]; v[c, j] = v[c, j - 1]; v[c, j - 1] = t
            }
            printf "%.2f ", (v[c, int((NR + 1) / 2)] + v[c, int(NR / 2) + 1]) / 2
        } }'
}

echo "Une erreur voulue : secondes, programme entier (avec --auto, à la main, et de plus) ; dessin, essais permis, essais dits"
for scene in scenes/*.ini; do
    for voulu in 0.5 1 2 4; do
        for _ in $(seq "$TOURS"); do
            avec=$(lancer --auto erreur=$voulu --image "$dossier/a.png" "$scene")
            essais="$(dit 'dessin en ([0-9.]+) s') $(dit 'essais en ([0-9.]+) s')"
            choix=$(dit 'choisi : (.*)')
            # « [Antialias] n=… …, --reflets … » : la section à écrire, et les options
            { cat "$scene"; printf '\n[Antialias]\n%s\n' "$(sed 's/^\[Antialias\] //; s/,.*//; s/ /\n/g' <<< "$choix")"; } > "$dossier/a.ini"
            # shellcheck disable=SC2086 : plusieurs options
            main=$(lancer ${choix#*, } --image "$dossier/b.png" "$dossier/a.ini")
            cmp -s "$dossier/a.png" "$dossier/b.png" || { echo "$scene $voulu : les deux images diffèrent" >&2; exit 1; }
            echo "$avec $main $(awk "BEGIN { print $avec - $main }") $essais"
        done | medianes | awk -v nom="$(basename "$scene" .ini)" -v voulu=$voulu '{
            permis = $4 / 2 > 0.2 ? $4 / 2 : 0.2
            printf "%-10s %3s  %.2f %.2f %.2f ; %.2f %.2f %.2f%s\n", nom, voulu, $1, $2, $3, $4, permis, $5,
                ($3 > permis ? "  plus que permis" : $5 > permis ? "  dits plus que permis" : "") }'
    done
done | tee "$dossier/table"
printf 'De plus que permis : %d fois sur %d\n\n' "$(grep -c '  plus que' "$dossier/table" || true)" "$(wc -l < "$dossier/table")"

echo "Un temps voulu : erreur mesurée, secondes des essais, du dessin, des deux ; combien de fois le temps est tenu"
for scene in scenes/*.ini; do
    for voulu in 0.5 1 2 5; do
        for _ in $(seq "$TOURS"); do
            lancer --auto temps=${voulu}s --image "$dossier/a.png" "$scene" > /dev/null
            essais=$(dit 'essais en ([0-9.]+) s')
            dessin=$(dit 'dessin en ([0-9.]+) s')
            echo "$(dit 'mesuré : erreur de ([0-9.]+)') $essais $dessin $(awk "BEGIN { print $essais + $dessin }")"
            { grep 'temps voulu tenu' "$dossier/dit" || true; } >> "$dossier/tenus"
        done | medianes | awk -v nom="$(basename "$scene" .ini)" -v voulu=$voulu '{ printf "%-10s %3s  %s", nom, voulu, $0 }'
        echo " $(wc -l < "$dossier/tenus") sur $TOURS"
        rm "$dossier/tenus"
    done
done
