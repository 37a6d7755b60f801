package lancer.mesures.vitesse;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import lancer.atelier.FichierCsv;
import lancer.atelier.PagesMesurees;
import lancer.mesures.stabilite.Stabilite;
import lancer.mesures.trace.Planche;
import lancer.mesures.trace.Style;

/** Des mesures d'un dossier aux courbes, aux tableaux et aux pages. */
final class Rapport {

    /** Ce que « make mesures » réécrit dans le projet. */
    static final Path[] PAGES = {Paths.get("README.md"), Paths.get("docs/vitesse-et-precision.md"), Paths.get("docs/stabilite.md"),
        Paths.get("docs/auto.md"), Paths.get("docs/classe.md"), Paths.get("mesures/resultats/besoins.md")};

    /** Celui de {@code make mesure-auto}. */
    private static final String AUTO = "auto.csv";

    /** Celui de {@code make mesure-corriger}. */
    private static final String CORRIGER = "corriger.csv";

    private final Path dossier;
    private final PrintStream sortie;
    private final Constats constats;

    /** @param dossier où sont les mesures, et où vont les courbes */
    Rapport(Path dossier, PrintStream sortie) throws IOException {
        this.dossier = dossier;
        this.sortie = sortie;
        constats = new Constats(Releves.lire(dossier),
                FichierCsv.lire(dossier.resolve(Vitesse.BESOINS)));
    }

    /** Ce que montrent les pages, par leurs noms. */
    Map<String, String> valeurs() throws IOException {
        Map<String, String> valeurs = new TreeMap<>(constats.pages());
        valeurs.putAll(Stabilite.pages(dossier));
        if (Files.exists(dossier.resolve(AUTO))) {
            valeurs.putAll(promesses(FichierCsv.lire(dossier.resolve(AUTO))));
        }
        if (Files.exists(dossier.resolve(CORRIGER))) {
            Map<String, String> c = FichierCsv.lire(dossier.resolve(CORRIGER)).get(0);
            valeurs.put("corriger", c.get("secondes") + " s sur " + c.get("coeurs") + " cœurs, et " + c.get("mo") + " Mo");
        }
        return valeurs;
    }

    /** Ce que {@code --auto} a tenu de ce qu'il avait promis, sur les scènes livrées puis sur celles tirées au sort. */
    static Map<String, String> promesses(List<Map<String, String>> toutes) {
        Map<Boolean, List<Map<String, String>>> auSort = toutes.stream()
                .collect(Collectors.partitioningBy(p -> p.get("scene").startsWith("sort-")));
        Map<String, String> valeurs = new TreeMap<>();
        valeurs.put("auto.livrees", compte(auSort.get(false), p -> p.get("tenue").equals("oui")));
        valeurs.put("auto.sort", compte(auSort.get(true), p -> p.get("tenue").equals("oui")));
        valeurs.put("auto.prix", compte(auSort.get(true), p -> Math.abs(quotient(p, "rayons_attendus", "rayons") - 1) <= 0.1));
        valeurs.put("auto.pire", Style.nombre(toutes.stream().filter(p -> p.get("promise").equals("oui"))
                .mapToDouble(p -> quotient(p, "erreur", "erreur_voulue")).max().orElse(0)));
        // permis : la moitié du dessin, ou 550 000 rayons
        valeurs.put("auto.plus_cher", Style.nombre(toutes.stream().mapToDouble(p -> Math.min(
                2 * quotient(p, "rayons_des_essais", "rayons"),
                Constats.nombre(p, "rayons_des_essais") * MesureAuto.TAILLE.pixels() / 550_000)).max().orElse(0)));
        return valeurs;
    }

    private static String compte(List<Map<String, String>> promesses, Predicate<Map<String, String>> condition) {
        return promesses.stream().filter(condition).count() + " fois sur " + promesses.size();
    }

    private static double quotient(Map<String, String> promesse, String colonne, String autre) {
        return Constats.nombre(promesse, colonne) / Constats.nombre(promesse, autre);
    }

    /** @param pages vrai pour réécrire aussi les nombres des pages du projet */
    void ecrire(boolean pages) throws IOException {
        Planches planches = new Planches(constats);
        for (String scene : constats.releves.de(Catalogue.METHODES).scenes()) {
            ecrire(planches.scene(scene), scene);
        }
        if (!constats.releves.de(Catalogue.SPHERES).get().isEmpty()) {
            ecrire(planches.spheres(), "spheres");
        }
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
