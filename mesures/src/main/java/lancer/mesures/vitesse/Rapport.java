package lancer.mesures.vitesse;

import java.io.IOException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import lancer.mesures.FichierCsv;
import lancer.mesures.Nombres;
import lancer.mesures.pages.PagesMesurees;
import lancer.mesures.stabilite.Bilan;
import lancer.mesures.stabilite.Figures;
import lancer.mesures.trace.Planche;

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
                    + Tableaux.source(c[6] + " " + c[5].replaceFirst("T.*", "")));
        }
        return valeurs;
    }

    /** Les planches dont les mesures sont là, par leurs noms de fichier. */
    Map<String, Planche> planches() throws IOException {
        Map<String, Planche> planches = new TreeMap<>(Figures.planches(dossier));
        Planches vitesse = new Planches(resultats);
        if (vitesse.aDesTemps(Catalogue.CHOIX)) {
            planches.put("scene1.png", vitesse.cours());
            planches.put("scenes.png", vitesse.scenes());
        }
        if (vitesse.aDesTemps(Catalogue.FILS)) {
            planches.put("fils.png", vitesse.fils());
        }
        if (vitesse.aDesTemps(Catalogue.SPHERES)) {
            planches.put("spheres.png", vitesse.spheres());
        }
        planches.put("reflets.png", vitesse.reflets());
        return planches;
    }

    /** Dessine les courbes dont les mesures sont là. @param pages vrai pour réécrire aussi les pages du projet */
    void ecrire(boolean pages) throws IOException {
        for (Map.Entry<String, Planche> planche : planches().entrySet()) {
            planche.getValue().ecrire(dossier.resolve(planche.getKey()));
        }
        Map<String, String> valeurs = valeurs();
        for (Path page : pages ? PAGES : new Path[0]) {
            PagesMesurees.reecrire(page, valeurs);
        }
    }
}
