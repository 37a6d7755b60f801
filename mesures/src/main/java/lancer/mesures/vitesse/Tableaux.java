package lancer.mesures.vitesse;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import lancer.Constantes;
import lancer.mesures.Intervalle;
import lancer.mesures.trace.Style;

/** Tableaux des pages, par leurs noms. */
final class Tableaux {

    private static final Intervalle UN = Intervalle.exact(1);

    private final Releves releves;
    private final List<Map<String, String>> besoins;

    /** @param besoins lignes de {@code besoins.csv} */
    Tableaux(Releves releves, List<Map<String, String>> besoins) {
        this.releves = releves;
        this.besoins = besoins;
    }

    /** Tous les tableaux ; les temps manquent s'ils n'ont pas été mesurés. */
    Map<String, String> pages() {
        Map<String, String> pages = new TreeMap<>();
        pages.put("choisir", choisir());
        pages.put("comptes", comptes());
        pages.put("demandes", table(Arrays.asList("sur la scène du cours", "temps, à celui de la scène telle quelle"),
                releves.de(Catalogue.DEMANDES).get().stream().map(r -> Arrays.asList(r.nom(), rapport(r.rapport())))
                .collect(Collectors.toList())));
        pages.put("besoins", besoins());
        pages.put("machine", releves.get().stream().filter(r -> !r.texte("machine").isEmpty()).findFirst().map(r -> table(
                Arrays.asList("machine", "cœurs", "machine virtuelle", "commit", "date"), Arrays.asList(Arrays.asList(r.texte("machine"),
                r.texte("coeurs"), r.texte("jvm"), r.texte("commit"), r.texte("date").replace('T', ' '))))).orElse(""));
        return pages;
    }

    /** Un tableau Markdown. */
    static String table(List<String> titres, List<List<String>> lignes) {
        List<List<String>> toutes = new ArrayList<>(Arrays.asList(titres, titres.stream().map(t -> "---").collect(Collectors.toList())));
        toutes.addAll(lignes);
        return toutes.stream().map(l -> "| " + l.stream().map(c -> c.replace("|", "\\|")).collect(Collectors.joining(" | ")) + " |")
                .collect(Collectors.joining("\n", "\n", "\n"));
    }

    /** Tableau des conseils : le besoin, ce qu'il faut écrire, l'erreur, le temps. */
    private String choisir() {
        Releves cours = releves.de(Catalogue.METHODES).scene("scene1");
        Releves miroirs = releves.de(Catalogue.METHODES).scene("miroirs");
        Object[][] lignes = {{"aller vite", cours, cours.methode(Catalogue.UN_RAYON).get().stream().findFirst()},
            {"un niveau au plus", cours, cours.lePlusRapide(1)},
            {"moins que l'arrondi de l'écran", cours, cours.lePlusRapide(Planches.ARRONDI)},
            {"un niveau, entre des miroirs face à face", miroirs, miroirs.lePlusRapide(1)},
            {"ne pas choisir", cours, cours.methode(Catalogue.AUTO).get().stream().findFirst()}};
        List<List<String>> cases = new ArrayList<>();
        for (Object[] l : lignes) {
            Releve r = (Releve) ((Optional<?>) l[2]).orElse(null);
            cases.add(r == null ? Arrays.asList((String) l[0], "rien de ce qui est mesuré", "", "", "")
                    : Arrays.asList((String) l[0], ecrit(r), Style.niveaux(r.erreur().valeur),
                    Style.nombre(((Releves) l[1]).secondes() * r.rapport().valeur) + " s", fois(r.rapport())));
        }
        return table(Arrays.asList("je veux", "j'écris", "erreur", "temps", "au temps d'un rayon par pixel"), cases);
    }

    private static String ecrit(Releve r) {
        String ecrit = Catalogue.methode(r.famille, r.scene, r.methode + "/" + r.parametres).ecrit();
        return ecrit.isEmpty() ? "rien de plus" : ecrit;
    }

    /** Tableau de chaque réglage de chaque scène : rayons, erreur, pixels visiblement faux, temps. */
    private String comptes() {
        return table(Arrays.asList("scène", "réglage", "rayons", "erreur, en niveaux", "pixels visiblement faux", "temps",
                "plus rapide et plus juste"),
                releves.de(Catalogue.METHODES).get().stream().map(r -> Arrays.asList("`" + r.scene + "`", r.nom(),
                "× " + Style.arrondi(r.rayons() / releves.de(Catalogue.METHODES).scene(r.scene).le(Catalogue.UN_RAYON, "").rayons()),
                Style.nombre(r.erreur().valeur) + " (de " + Style.nombre(r.erreur().min) + " à " + Style.nombre(r.erreur().max) + ")",
                Style.arrondi(100 * r.nombre("visibles")) + " %", fois(r.rapport()),
                releves.de(Catalogue.METHODES).scene(r.scene).vainqueur(r).map(Releve::nom).orElse(""))).collect(Collectors.toList()));
    }

    /** « × 2,6 (de 2,4 à 2,9) » ; vide si le rapport n'est pas mesuré. */
    private static String fois(Intervalle i) {
        return i.valeur > 0 ? "× " + Style.nombre(i.valeur) + " (de " + Style.nombre(i.min) + " à " + Style.nombre(i.max) + ")" : "";
    }

    /** Facteur, ou phrase qui dit qu'aucune différence n'est sûre. */
    static String rapport(Intervalle i) {
        return UN.nettementSous(i) || i.nettementSous(UN) ? fois(i)
                : "autant, à l'intervalle près (de " + Style.nombre(i.min) + " à " + Style.nombre(i.max) + ")";
    }

    /** Tableau des besoins de chaque scène, et des structures que le programme choisit. */
    private String besoins() {
        return table(Arrays.asList("scène", "rayons par pixel", "qui changent l'écran", "ombres pour rien", "lampes", "utiles",
                "reflets qui changent l'écran", "sphères", "essayées par rayon", "structures", "première image", "alloué", "mémoire"),
                besoins.stream().map(b -> {
                    double pixels = nombre(b, "largeur") * nombre(b, "hauteur");
                    Releves temps = releves.scene(b.get("scene")).methode(Catalogue.UN_RAYON);
                    double memoire = temps.get().stream().mapToDouble(r -> r.nombre("memoire_mo")).findFirst().orElse(Double.NaN);
                    return Arrays.asList("`" + b.get("scene") + "`", Style.nombre(nombre(b, "rayons") / pixels),
                            Style.nombre(nombre(b, "rayons_utiles") / pixels), Style.arrondi(100 * nombre(b, "ombres_inutiles")
                            / nombre(b, "rayons")) + " %", b.get("lampes"), b.get("lampes_utiles"), b.get("profondeur_utile")
                            + (nombre(b, "profondeur_utile") > Constantes.MAX_REFLETS ? ", " + Constantes.MAX_REFLETS + " suivis" : ""),
                            Style.nombre(nombre(b, "spheres")), Style.nombre(nombre(b, "tests_par_rayon")),
                            b.get("structures").toLowerCase(Locale.ROOT), Double.isNaN(temps.secondes()) ? ""
                            : Style.nombre(temps.secondes()) + " s", b.get("alloues_mo") + " Mo",
                            Double.isNaN(memoire) ? "" : Style.arrondi(memoire) + " Mo");
                }).collect(Collectors.toList()));
    }

    private static double nombre(Map<String, String> b, String colonne) {
        return Double.parseDouble(b.get(colonne));
    }
}
