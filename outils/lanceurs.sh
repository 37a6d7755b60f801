#!/usr/bin/env bash
# lancer.Tests par les lanceurs JUnit que portent les environnements de développement, et par les consoles des mêmes versions.
# Les premiers sont mis au bout du chemin des classes, comme le fait un environnement ; chacun doit lancer tous les tests.
set -euo pipefail
cd "$(dirname "$0")/.."
MVN=${MVN:-mvn -B -ntp}
JAVA=${JAVA:-java}
VERSIONS=${VERSIONS:-1.9.3 1.10.2 1.11.4 1.12.2 1.13.4 1.14.4}
jars=target/lanceurs
mkdir -p $jars

# prendre ARTEFACT VERSION : org.junit.platform:ARTEFACT:VERSION dans $jars
prendre() {
    [ -e "$jars/$1-$2.jar" ] || $MVN -q dependency:copy -Dartifact="org.junit.platform:$1:$2" -DoutputDirectory="$jars"
}

$MVN -q -pl :lancer test-compile dependency:build-classpath -DincludeScope=test \
    -Dmdep.outputFile="$PWD/$jars/chemin"
chemin=target/test-classes:target/classes:$(cat $jars/chemin)
sortie=$jars/sortie.txt
tests=0
echecs=0
nombre=

# essayer NOM COMMANDE… : la commande doit réussir, et en lancer autant que les autres
essayer() {
    local nom=$1
    shift
    tests=$((tests + 1))
    if "$@" > $sortie 2>&1 && reussis=$(sed -n 's/.*\[ *\([1-9][0-9]*\) tests successful.*/\1/p' $sortie) && [ -n "$reussis" ] \
        && [ "${nombre:=$reussis}" = "$reussis" ]; then
        echo "$nom : $reussis tests"
    else
        echecs=$((echecs + 1))
        echo "$nom : échec"
        sed 's/^/    /' $sortie | head -20
    fi
}

for v in $VERSIONS; do
    prendre junit-platform-launcher $v
    prendre junit-platform-console-standalone $v
    essayer "lanceur $v" $JAVA -cp "$chemin:$jars/junit-platform-launcher-$v.jar" outils/Lanceur.java lancer.Tests
    essayer "console $v" $JAVA -jar "$jars/junit-platform-console-standalone-$v.jar" -cp "$chemin" --select-class lancer.Tests \
        --details summary --disable-banner
done
echo "$((tests - echecs)) lanceurs sur $tests"
[ $echecs = 0 ]
