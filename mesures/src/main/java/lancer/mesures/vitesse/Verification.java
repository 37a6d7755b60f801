package lancer.mesures.vitesse;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.Lancer;
import lancer.dessin.Dessin;
import lancer.mesures.Circonstances;
import lancer.mesures.FichierCsv;
import lancer.mesures.Nombres;
import lancer.mesures.scenes.Scenes;

/** Ce qui est publié est-il encore d'aujourd'hui ? Deux réglages de chaque scène sont comptés de nouveau, et les dates comparées. */
final class Verification {

    /** Ce dont le changement rend une mesure ancienne : le programme et l'anticrénelage, ou la correction. */
    private static final String[] PROGRAMME = {"src/main/java", "antialias/src/main/java"};
    private static final String[] CORRECTION = {"src/main/java", "correction/src/main"};

    private final Path resultats;
    private final Path dossier;
    private final PrintStream sortie;

    /** @param resultats le dossier des mesures publiées @param dossier celui des fichiers provisoires */
    Verification(Path resultats, Path dossier, PrintStream sortie) {
        this.resultats = resultats;
        this.dossier = dossier;
        this.sortie = sortie;
    }

    /** @throws IOException si un compte n'est plus le même */
    void faire() throws IOException {
        Resultats publies = Resultats.lire(resultats).volet(Catalogue.CHOIX);
        List<String> autres = new ArrayList<>();
        Mesureur mesureur = new Mesureur(dossier, null, sortie, Taille.PUBLIEE, true, r -> Collections.emptyList());
        for (String scene : publies.scenes()) {
            Lancer prepare = Dessin.lancer(Scenes.lire(Scenes.fichier(scene, dossier)), Taille.PUBLIEE.largeur, Taille.PUBLIEE.hauteur,
                    false);
            for (Reglage reglage : Arrays.asList(Reglage.UN_RAYON, Catalogue.UN_NIVEAU)) {
                Mesure publiee = publies.scene(scene).de(reglage)
                        .orElseThrow(() -> new IOException("pas de " + reglage.nom() + " de " + scene));
                Mesure neuve = new Mesure(publiee.volet, scene, publiee.methode, publiee.parametres, publiee.x);
                mesureur.compter(reglage, prepare, neuve);
                if (!comptes(neuve).equals(comptes(publiee))) {
                    autres.add(scene + ", " + reglage.nom() + " : " + comptes(neuve) + " au lieu de " + comptes(publiee));
                }
            }
        }
        direLesAnciennes();
        if (!autres.isEmpty()) {
            throw new IOException("des comptes ne sont plus ceux de " + Resultats.CSV + " (make mesures les refait) : "
                    + String.join(" ; ", autres));
        }
        sortie.println("Les rayons et les examens de " + 2 * publies.scenes().size() + " mesures sont ceux d'aujourd'hui");
    }

    private static String comptes(Mesure m) {
        return Nombres.champ(m.rayons) + " rayons et " + Nombres.champ(m.examens) + " examens";
    }

    /** Dit une fois, de chaque fichier, les commits plus anciens que le dernier changement de ce qu'ils mesurent ; rien sans git. */
    private void direLesAnciennes() throws IOException {
        List<Mesure> mesures = Resultats.lire(resultats).toutes;
        dire("comptes de mesures.csv", mesures.stream().map(m -> m.compte), PROGRAMME);
        dire("temps de mesures.csv", mesures.stream().map(m -> m.chronometre), PROGRAMME);
        dire("auto.csv", colonne("auto.csv", 11), PROGRAMME);
        dire("juge.csv", colonne("juge.csv", 11), PROGRAMME);
        dire("stabilite.csv", colonne("stabilite.csv", 7), PROGRAMME);
        dire("corriger.csv", colonne("corriger.csv", 6), CORRECTION);
    }

    private Stream<String> colonne(String fichier, int rang) throws IOException {
        return FichierCsv.lire(resultats.resolve(fichier)).stream().map(champs -> champs[rang]);
    }

    private void dire(String quoi, Stream<String> commits, String... mesure) {
        List<String> anciens = commits.map(c -> c.replaceFirst("[+ ].*", "")).filter(c -> !c.isEmpty()).distinct()
                .filter(c -> !Circonstances.changements(c, mesure).matches("|0")).collect(Collectors.toList());
        if (!anciens.isEmpty()) {
            sortie.println("Plus anciens que ce qu'ils mesurent : " + quoi + ", commit " + String.join(", ", anciens));
        }
    }
}
