package lancer.mesures.vitesse;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import lancer.atelier.FichierCsv;
import lancer.atelier.PagesMesurees;
import lancer.mesures.stabilite.Stabilite;
import lancer.mesures.trace.Planche;

/** Des mesures d'un dossier aux courbes, aux tableaux et aux pages. */
final class Rapport {

    /** Ce que « make mesures » réécrit dans le projet. */
    static final Path[] PAGES = {Paths.get("README.md"), Paths.get("docs/vitesse-et-precision.md"), Paths.get("docs/stabilite.md"),
        Paths.get("mesures/resultats/besoins.md")};

    /** Celles que le README montre l'une près de l'autre, sous la courbe de la scène du cours. */
    private static final List<String> VIGNETTES = Arrays.asList("miroirs", "tournesol");

    private final Path dossier;
    private final PrintStream sortie;
    private final Releves releves;
    private final List<Map<String, String>> besoins;

    /** @param dossier où sont les mesures, et où vont les courbes */
    Rapport(Path dossier, PrintStream sortie) throws IOException {
        this.dossier = dossier;
        this.sortie = sortie;
        releves = Releves.lire(dossier.resolve(Vitesse.CSV));
        besoins = FichierCsv.lire(dossier.resolve(Vitesse.BESOINS));
    }

    /** Ce que montrent les pages, par leurs noms. */
    Map<String, String> valeurs() throws IOException {
        Map<String, String> valeurs = new TreeMap<>(new Constats(releves, besoins).pages());
        valeurs.putAll(Stabilite.pages(dossier));
        return valeurs;
    }

    /** @param pages vrai pour réécrire aussi les nombres des pages du projet */
    void ecrire(boolean pages) throws IOException {
        Planches planches = new Planches(releves, besoins);
        for (String scene : releves.de(Catalogue.METHODES).scenes()) {
            ecrire(planches.scene(scene, false), scene);
            if (VIGNETTES.contains(scene)) {
                ecrire(planches.scene(scene, true), scene + "-vignette");
            }
        }
        ecrire(planches.demandes(), "demandes");
        ecrire(planches.spheres(), "spheres");
        ecrire(planches.parcimonie(), "parcimonie");
        Stabilite.dessiner(dossier);
        Map<String, String> valeurs = valeurs();
        valeurs.forEach((nom, valeur) -> sortie.println(nom + " : " + valeur));
        for (Path page : pages ? PAGES : new Path[0]) {
            PagesMesurees.reecrire(page, valeurs);
        }
    }

    private void ecrire(Planche planche, String nom) throws IOException {
        planche.ecrire(dossier.resolve(nom + ".png"));
    }
}
