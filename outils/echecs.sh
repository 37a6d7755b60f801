#!/usr/bin/env bash
# Une partie de docs/etendre.md, suivie à la lettre dans une copie du dépôt : les tests qu'elle fait échouer.
# outils/echecs.sh "Le ciel" [options de Maven] ; voir la cible echecs d'outils/Makefile
set -euo pipefail
cd "$(dirname "$0")/.."
partie=$1
shift
copie=target/echecs
rm -rf $copie
mkdir -p $copie
git ls-files -z | xargs -0 cp --parents -t $copie
cd $copie

# les mêmes règles que ChangerLaBaseTest
PARTIE="$partie" perl -0777 -e '
    sub texte { open(my $f, "<", $_[0]) or die "$_[0] : $!\n"; return <$f> }
    my ($partie) = texte("docs/etendre.md") =~ /\n### \Q$ENV{PARTIE}\E\n(.*?)(?=\n##)/s or die "partie inconnue\n";
    while ($partie =~ /Dans `([^`]+)`, (sous|à la place de)\s`([^`]+)` :\n\n((?: {4}.*\n|\n(?= {4}))+)/g) {
        my ($fichier, $sous, $lieu, $lignes) = ($1, $2 eq "sous", $3, $4);
        $lignes =~ s/^ {4}//mg;
        (my $seules = $lignes) =~ s/^\s+|\s+$//g;
        my $texte = texte($fichier);
        my ($avant, $apres) = $texte =~ /^(.*)\Q$lieu\E(.*)\n/m or die "$fichier : $lieu\n";
        my $nouveau = $sous ? "$avant$lieu$apres\n$lignes" : "$avant$apres" =~ /\S/ ? "$avant$seules$apres\n" : $lignes;
        $texte =~ s/^\Q$avant$lieu$apres\E\n/$nouveau/m;
        open(my $f, ">", $fichier) or die;
        print $f $texte;
    }'

${MVN:-mvn -B -ntp} -q -fae -Pgroupes -Dmaven.test.failure.ignore=true "$@" package > ../echecs.log 2>&1 || { tail -20 ../echecs.log >&2; exit 1; }
find . -name 'TEST-*.xml' -exec perl -0777 -ne '
    my ($classe) = $ARGV =~ /(\w+)\.xml$/;
    print "$classe.$1\n" while /<testcase name="(\w+)[^>]*>\s*<(?:failure|error)/g' {} + | sort -u
