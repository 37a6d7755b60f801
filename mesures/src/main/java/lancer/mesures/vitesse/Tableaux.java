package lancer.mesures.vitesse;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
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
        Releves methodes = releves.de(Catalogue.METHODES);
        Releves cours = methodes.scene(Catalogue.COURS);
        Map<String, String> pages = new TreeMap<>();
        pages.put("choisir", choisir(methodes) + source(cours));
        pages.put("resultat", resultat(cours));
        pages.put("comptes", comptes(methodes) + source(methodes));
        Releves demandes = new Releves(Stream.of(cours.methode(Catalogue.UN_RAYON), releves.de(Catalogue.DEMANDES),
                cours.methode(Catalogue.SANS_SECTION), cours.methode(Catalogue.REFLETS).tels(r -> r.parametres.equals("0")),
                cours.methode(Catalogue.BOUCLES)).flatMap(r -> r.get().stream()).filter(r -> r.nombre("rapport") > 0)
                .collect(Collectors.toList()));
        pages.put("demandes", table(Arrays.asList("ce qui change", "temps, divisé par celui de la scène du cours", "processeurs",
                "mémoire"), demandes.get().stream().map(r -> Arrays.asList(r.nom(), r.methode.equals(Catalogue.UN_RAYON) ? "l'unité"
                : rapport(r.rapport()), processeurs(r), memoire(r))).collect(Collectors.toList()))
                + source(demandes));
        pages.put("options", demandes.methode(Catalogue.MAKE).get().isEmpty() ? "pas encore mesuré"
                : couts(demandes.le(Catalogue.MAKE, "")) + " au lieu de " + couts(demandes.le(Catalogue.UN_RAYON, "")));
        pages.put("besoins", besoins() + source(besoins.stream().map(Releve::new).collect(Collectors.toList())));
        pages.put("machine", releves.get().stream().filter(r -> !r.texte("machine").isEmpty()).findFirst().map(r -> table(
                Arrays.asList("machine", "cœurs", "machine virtuelle", "commit", "date"), Arrays.asList(Arrays.asList(r.texte("machine"),
                r.texte("coeurs"), r.texte("jvm"), r.texte("commit"), r.texte("date").replace('T', ' '))))).orElse(""));
        pages.put("lui-meme", methodes.methode(Catalogue.UN_RAYON).tels(r -> r.nombre("rapport") > 0).get().stream()
                .map(r -> fois(r.mesure()) + " sur `" + r.scene + "`").collect(Collectors.joining(", ")));
        return pages;
    }

    private static String couts(Releve r) {
        return processeurs(r) + " de processeur et " + memoire(r);
    }

    private static String processeurs(Releve r) {
        return avec(r.nombre("processeur_ms") / 1000, " s");
    }

    private static String memoire(Releve r) {
        return avec(r.nombre("memoire_mo"), " Mo");
    }

    /** Le nombre et son unité ; vide s'il n'est pas mesuré. */
    private static String avec(double nombre, String unite) {
        return Double.isNaN(nombre) ? "" : Style.nombre(nombre) + unite;
    }

    private static String source(Releves mesures) {
        return source(mesures.get());
    }

    /** Ligne sous un tableau : le commit et le jour de ses mesures ; vide s'ils ne sont pas connus. */
    static String source(List<Releve> mesures) {
        String sources = mesures.stream().filter(r -> !r.texte("commit").isEmpty()).map(r -> r.texte("commit") + ", le "
                + r.texte("date").replaceFirst("T.*", "")).distinct().collect(Collectors.joining(" ; "));
        return sources.isEmpty() ? "" : "\nMesures du commit " + sources + ".\n";
    }

    /** Un tableau Markdown. */
    static String table(List<String> titres, List<List<String>> lignes) {
        List<List<String>> toutes = new ArrayList<>(Arrays.asList(titres, titres.stream().map(t -> "---").collect(Collectors.toList())));
        toutes.addAll(lignes);
        return toutes.stream().map(l -> "| " + l.stream().map(c -> c.replace("|", "\\|")).collect(Collectors.joining(" | ")) + " |")
                .collect(Collectors.joining("\n", "\n", "\n"));
    }

    /** Tableau des conseils : le besoin, l'erreur sur la scène du cours et sur la pire, le temps ; dessous, ce qu'il faut écrire. */
    private static String choisir(Releves methodes) {
        Releves cours = methodes.scene(Catalogue.COURS);
        Map<String, Optional<Releve>> lignes = new LinkedHashMap<>();
        lignes.put("aller vite", cours.methode(Catalogue.UN_RAYON).get().stream().findFirst());
        lignes.put("deux niveaux au plus", methodes.lePlusRapide(Catalogue.COURS, 2));
        lignes.put("un niveau au plus", methodes.lePlusRapide(Catalogue.COURS, 1));
        lignes.put("moins que l'arrondi de l'écran", methodes.lePlusRapide(Catalogue.COURS, Planches.ARRONDI));
        lignes.put("ne pas choisir", cours.methode(Catalogue.AUTO).get().stream().findFirst());
        StringBuilder table = new StringBuilder("\n<table>\n<tr><th>je veux</th><th>erreur, sur la scène du cours</th><th>erreur, sur la "
                + "pire scène</th><th>temps, sur la scène du cours</th></tr>\n");
        lignes.forEach((besoin, choisi) -> {
            table.append("<tr><td>" + besoin + "</td>");
            if (!choisi.isPresent()) {
                table.append("<td colspan=\"3\">rien de ce qui est mesuré</td></tr>\n");
                return;
            }
            Releve r = choisi.get();
            Methode methode = Catalogue.methode(r.famille, r.scene, r.methode + "/" + r.parametres);
            table.append("<td>" + Style.niveaux(r.erreur().valeur) + "</td><td>" + methodes.pire(r).map(p ->
                    Style.niveaux(p.erreur().valeur) + " (" + p.scene + ")").orElse("") + "</td><td>" + secondes(cours, r)
                    + "</td></tr>\n<tr><td colspan=\"4\">\n" + bloc("dans la scène", methode.section)
                    + bloc("dans un terminal", methode.commande()) + "\n</td></tr>\n");
        });
        return table.append("</table>\n").toString();
    }

    /** Un bloc à copier, sous son titre ; vide s'il n'y a rien à écrire. */
    private static String bloc(String titre, String texte) {
        return texte.isEmpty() ? "" : titre + " :\n\n" + texte.trim().replaceAll("(?m)^", "    ") + "\n\n";
    }

    /** Deux réglages dont l'erreur est voisine, et leurs rayons ; vide s'ils ne sont pas mesurés. */
    private static String resultat(Releves cours) {
        List<Releve> deux = cours.tels(r -> (r.methode + " " + r.parametres).matches("partage n=8 seuil=0.1|grille 4 × 4")).get();
        return deux.size() < 2 ? "" : Style.niveaux(deux.get(0).erreur().valeur) + ". La grille de 4 × 4 rayons par pixel lance "
                + Style.arrondi(deux.get(1).rayons() / deux.get(0).rayons()) + " fois plus de rayons, pour une erreur de "
                + Style.niveaux(deux.get(1).erreur().valeur);
    }

    private static String secondes(Releves siens, Releve r) {
        double secondes = siens.secondes() * r.rapport().valeur;
        return Double.isNaN(secondes) ? "" : Style.nombre(secondes) + " s, " + (r.methode.equals(Catalogue.UN_RAYON) ? "l'unité"
                : fois(r.rapport()));
    }

    /** Tableau de chaque réglage de chaque scène : rayons, erreur, pixels visiblement faux, temps. */
    private static String comptes(Releves methodes) {
        return table(Arrays.asList("scène", "réglage", "rayons", "erreur, en niveaux", "pixels visiblement faux", "temps",
                "plus rapide et plus juste"), methodes.get().stream().map(r -> Arrays.asList("`" + r.scene + "`", r.nom(),
                "× " + Style.arrondi(r.rayons() / methodes.scene(r.scene).le(Catalogue.UN_RAYON, "").rayons()),
                Style.nombre(r.erreur().valeur) + " (de " + Style.nombre(r.erreur().min) + " à " + Style.nombre(r.erreur().max) + ")",
                Style.arrondi(100 * r.nombre("visibles")) + " %", r.methode.equals(Catalogue.UN_RAYON) ? "1" : fois(r.rapport()),
                methodes.scene(r.scene).vainqueur(r).map(Releve::nom).orElse(""))).collect(Collectors.toList()));
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
        return table(Arrays.asList("scène", "rayons par pixel", "lampes", "reflets qui changent l'écran", "sphères",
                "essayées par rayon", "structures", "première image", "mémoire"), besoins.stream().map(b -> {
                    Releves temps = releves.scene(b.get("scene")).tels(r -> !r.famille.equals(Catalogue.DEMANDES));
                    return Arrays.asList("`" + b.get("scene") + "`", Style.nombre(nombre(b, "rayons") / nombre(b, "largeur")
                            / nombre(b, "hauteur")), b.get("lampes"), b.get("profondeur_utile")
                            + (nombre(b, "profondeur_utile") > Constantes.MAX_REFLETS ? ", " + Constantes.MAX_REFLETS + " suivis" : ""),
                            Style.nombre(nombre(b, "spheres")), Style.nombre(nombre(b, "tests_par_rayon")),
                            b.get("structures").toLowerCase(Locale.ROOT), avec(temps.secondes(), " s"),
                            temps.methode(Catalogue.UN_RAYON).get().stream().findFirst().map(Tableaux::memoire).orElse(""));
                }).collect(Collectors.toList()));
    }

    private static double nombre(Map<String, String> b, String colonne) {
        return Double.parseDouble(b.get(colonne));
    }
}
