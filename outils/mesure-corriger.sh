#!/usr/bin/env bash
# Trente rendus différents, en une archive comme Moodle la donne, puis ce que coûte de les noter : durée, temps de
# processeur, et la plus grande mémoire que le correcteur et ses machines virtuelles aient occupée ensemble.
set -euo pipefail
cd "$(dirname "$0")/.."
JAVA=${JAVA:-java}
essais=correction/src/test/resources
ici=target/trente
CORRIGER=${CORRIGER:-$JAVA -jar correction/target/correction.jar}
rm -rf $ici && mkdir -p $ici/rendus
$CORRIGER --corrige $ici/corrige > $ici/sortie.txt
n=0
# suivi de +, un commit n'est pas exactement celui des sources, comme dans vitesse.csv
commit=$(git describe --always --exclude='*' --dirty=+)

# rendre NUMÉRO [FAUTE…] : le rendu d'essai de ce numéro, avec les classes de ces fautes à la place des siennes
rendre() {
    local de=$1 lui
    shift
    n=$((n + 1))
    lui="$ici/rendus/Étudiant ${n}_$((200 + n))_assignsubmission_file"
    cp -r $essais/classe/*_10"$de"_* "$lui"
    lui=$(find "$lui" -path '*lancer-base/src/main/java/lancer')
    for faute in "$@"; do
        grep "^$faute|" $essais/fautes.txt | cut -d'|' -f2 | sort -u | while read -r classe; do
            cp $ici/corrige/src/main/java/lancer/"$classe".java "$lui"/
        done
        grep "^$faute|" $essais/fautes.txt | while IFS='|' read -r _ classe avant apres; do
            texte=$(<"$lui/$classe.java")
            printf '%s\n' "${texte//"$avant"/"$apres"}" > "$lui/$classe.java"
        done
    done
}

fautes=$(grep -v '^#' $essais/fautes.txt | cut -d'|' -f1 | sort -u)
for k in 1 2 3 4 5 6; do rendre $k; done
for f in $fautes; do rendre 6 "$f"; done
for f in racine-negative image-renversee plus-loin normale-a-l-envers; do rendre 5 "$f"; rendre 4 "$f"; done
for f in $fautes; do [ "$f" = image-renversee ] || [ $n = 30 ] || rendre 6 "$f" image-renversee; done
jar --create --no-manifest --file=$ici/rendus.zip -C $ici/rendus .

$CORRIGER --sortie $ici/classe $ici/rendus.zip > $ici/sortie.txt 2>&1 &
pid=$!
debut=$(date +%s.%N)
max=0
while kill -0 $pid 2>/dev/null; do
    # la mémoire partagée par plusieurs processus n'est comptée qu'une fois (Pss)
    tous=$pid
    nouveaux=$pid
    while nouveaux=$(pgrep -d, -P "$nouveaux"); do tous=$tous,$nouveaux; done
    total=$(for p in ${tous//,/ }; do sed -n 's/^Pss: *\([0-9]*\) kB/\1/p' /proc/$p/smaps_rollup 2>/dev/null || true; done |
        awk '{ s += $1 } END { print int(s / 1024) }')
    [ "$total" -le $max ] || max=$total
    sleep 0.5
done
fin=$(date +%s.%N)
wait $pid || { cat $ici/sortie.txt >&2; exit 1; }
{
    echo coeurs,rendus,secondes,mo,jvm,date,commit
    LC_ALL=C awk "BEGIN { printf \"%d,%d,%.0f,%d,\", $(nproc), $n, $fin - $debut, $max }"
    $JAVA -XshowSettings:properties -version 2>&1 | awk -F ' = ' -v ORS=, '/java.vm.name/ { nom = $2 } / java.version =/ { v = $2 }
        END { print nom " " v }'
    echo "$(date -u +%FT%T),$commit"
} > mesures/resultats/corriger.csv
cat mesures/resultats/corriger.csv
