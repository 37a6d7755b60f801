package lancer.mesures.vitesse;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;
import lancer.mesures.FichierCsv;
import lancer.mesures.pages.PagesMesurees;
import lancer.mesures.stabilite.Bilan;
import lancer.mesures.stabilite.Figures;
import lancer.mesures.trace.Style;

/** Courbes, tableaux et pages, d'après les mesures d'un dossier. */
final class Rapport {

    /** Pages du projet que « make mesures » réécrit. */
    static final Path[] PAGES = {Paths.get("README.md"), Paths.get("docs/vitesse-et-precision.md"), Paths.get("docs/stabilite.md"),
        Paths.get("docs/classe.md"), Paths.get("docs/auto.md"), Paths.get("docs/etendre.md"),
        Paths.get("mesures/resultats/reglages.md")};

    private final Path dossier;
    private final PrintStream sortie;
    private final Releves releves;
    private final Bilan bilan;

    /** {@code null} si les temps des intersections n'ont pas été mesurés. */
    private final Methodes methodes;

    /** @param dossier celui des mesures et des courbes */
    Rapport(Path dossier, PrintStream sortie) throws IOException {
        this.dossier = dossier;
        this.sortie = sortie;
        releves = Releves.lire(dossier);
        bilan = new Bilan(dossier);
        Releves temps = new Releves(Releves.lignes(dossier.resolve(Methodes.CSV)));
        methodes = temps.get().isEmpty() ? null : new Methodes(temps, bilan);
    }

    /** Textes à écrire dans les pages, par leurs noms. */
    Map<String, String> valeurs() throws IOException {
        Map<String, String> valeurs = new TreeMap<>(new Tableaux(releves, FichierCsv.lire(dossier.resolve(Vitesse.BESOINS))).pages());
        if (methodes != null) {
            valeurs.put("methodes", methodes.tableau());
        }
        valeurs.put("lyapunov", Style.arrondi(bilan.exposantDeLyapunov()));
        Path auto = dossier.resolve("auto.csv");
        valeurs.put("auto", Files.exists(auto) ? MesureAuto.tableau(FichierCsv.lire(auto)) + Tableaux.source(Releves.lignes(auto))
                : "pas encore mesuré");
        if (Files.exists(dossier.resolve("corriger.csv"))) {
            Map<String, String> c = FichierCsv.lire(dossier.resolve("corriger.csv")).get(0);
            valeurs.put("corriger", Tableaux.table(Arrays.asList("rendus", "cœurs", "secondes", "Mo"),
                    Arrays.asList(Arrays.asList(c.get("rendus"), c.get("coeurs"), c.get("secondes"), c.get("mo"))))
                    + Tableaux.source(Collections.singletonList(new Releve(c))));
        }
        return valeurs;
    }

    /** @param pages vrai pour réécrire aussi les pages du projet */
    void ecrire(boolean pages) throws IOException {
        Planches planches = new Planches(releves);
        if (planches.scenes().contains(Catalogue.COURS)) {
            planches.scenes(Collections.singletonList(Catalogue.COURS)).ecrire(dossier.resolve("scene1.png"));
            planches.scenes(planches.scenes()).ecrire(dossier.resolve("scenes.png"));
            Decoupe.ecrire(releves, dossier);
        }
        if (!releves.de(Catalogue.SPHERES).get().isEmpty()) {
            Planches.spheres(releves.de(Catalogue.SPHERES)).ecrire(dossier.resolve("spheres.png"));
        }
        Figures.ecrire(dossier);
        if (methodes != null) {
            methodes.planche().ecrire(dossier.resolve("methodes.png"));
        }
        Map<String, String> valeurs = valeurs();
        valeurs.forEach((nom, valeur) -> sortie.println(nom + " : " + valeur.trim()));
        for (Path page : pages ? PAGES : new Path[0]) {
            PagesMesurees.reecrire(page, valeurs);
        }
    }
}
