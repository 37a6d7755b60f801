package lancer.mesures.vitesse;

import java.io.IOException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import lancer.mesures.FichierCsv;
import lancer.mesures.Nombres;
import lancer.mesures.pages.PagesMesurees;
import lancer.mesures.stabilite.Bilan;
import lancer.mesures.stabilite.Figures;

/** Courbes, tableaux et pages, d'après les mesures d'un dossier. */
final class Rapport {

    /** Pages du projet que « make mesures » réécrit. */
    static final Path[] PAGES = {Paths.get("README.md"), Paths.get("docs/vitesse-et-precision.md"), Paths.get("docs/stabilite.md"),
        Paths.get("docs/classe.md"), Paths.get("docs/auto.md")};

    private final Path dossier;
    private final Resultats resultats;
    private final Bilan bilan;

    /** @param dossier celui des mesures et des courbes */
    Rapport(Path dossier) throws IOException {
        this.dossier = dossier;
        resultats = Resultats.lire(dossier);
        bilan = new Bilan(dossier);
    }

    /** Textes à écrire dans les pages, par leurs noms. */
    Map<String, String> valeurs() throws IOException {
        Map<String, String> valeurs = new TreeMap<>(new Tableaux(resultats).pages());
        valeurs.put("lyapunov", Nombres.arrondi(bilan.exposantDeLyapunov()));
        valeurs.put("auto", MesureAuto.tableau(FichierCsv.lire(dossier.resolve("auto.csv"))));
        List<String[]> corriger = FichierCsv.lire(dossier.resolve("corriger.csv"));
        for (String[] c : corriger) {
            // cœurs, rendus, secondes, Mo, machine virtuelle, date, commit
            valeurs.put("corriger", Tableaux.table(Arrays.asList("rendus", "cœurs", "secondes", "Mo"),
                    Arrays.asList(Arrays.asList(c[1], c[0], c[2], c[3])))
                    + Tableaux.source(Collections.singletonList(c[6] + " " + c[5].replaceFirst("T.*", ""))));
        }
        return valeurs;
    }

    /** Dessine les courbes dont les mesures sont là. @param pages vrai pour réécrire aussi les pages du projet */
    void ecrire(boolean pages) throws IOException {
        Planches planches = new Planches(resultats);
        if (planches.aDesTemps(Catalogue.CHOIX)) {
            planches.cours().ecrire(dossier.resolve("scene1.png"));
            planches.scenes().ecrire(dossier.resolve("scenes.png"));
        }
        if (planches.aDesTemps(Catalogue.FILS)) {
            planches.couts().ecrire(dossier.resolve("couts.png"));
        }
        if (planches.aDesTemps(Catalogue.SPHERES)) {
            planches.spheres().ecrire(dossier.resolve("spheres.png"));
        }
        planches.reflets().ecrire(dossier.resolve("reflets.png"));
        Figures.ecrire(dossier);
        Map<String, String> valeurs = valeurs();
        for (Path page : pages ? PAGES : new Path[0]) {
            PagesMesurees.reecrire(page, valeurs);
        }
    }
}
