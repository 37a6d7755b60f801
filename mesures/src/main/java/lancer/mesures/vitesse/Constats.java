package lancer.mesures.vitesse;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import lancer.Constantes;
import lancer.mesures.Intervalle;
import lancer.mesures.trace.Style;

/**
 * Phrases que disent les mesures : les titres des courbes, et ce que montrent les pages, par leurs noms. Tout est calculé ; aucune
 * différence n'est dite qu'{@link Intervalle#nettementSous} ne porte.
 */
final class Constats {

    /** Erreur quadratique moyenne de l'arrondi de l'écran. */
    static final double ARRONDI = 1 / Math.sqrt(12);

    /** Centre, rayon, Kd, Ks et ns, en doubles. */
    private static final int OCTETS_D_UNE_SPHERE = 11 * Double.BYTES;

    final Releves releves;
    final List<Map<String, String>> besoins;

    Constats(Releves releves, List<Map<String, String>> besoins) {
        this.releves = releves;
        this.besoins = besoins;
    }

    Releves methodes(String scene) {
        return releves.de(Catalogue.METHODES).scene(scene);
    }

    Releves spheres(String methode) {
        return releves.de(Catalogue.SPHERES).methode(methode);
    }

    /** Textes que montrent les pages, par leurs noms ; sans les temps, là où ils n'ont pas été pris. */
    Map<String, String> pages() {
        Map<String, String> valeurs = new TreeMap<>();
        for (String scene : releves.de(Catalogue.METHODES).scenes()) {
            valeurs.put(scene + ".titre", titre(scene));
            valeurs.put(scene + ".coins", duel(scene, methodes(scene).le(Catalogue.COINS, Catalogue.COINS_DEFAUT)));
            valeurs.put(scene + ".povray", povray(scene));
            valeurs.put(scene + ".paliers", paliers(scene));
            valeurs.put(scene + ".pentes", pentes(scene));
            for (Releve r : methodes(scene).aNous().get()) {
                valeurs.put(scene + "." + r.nom(), description(r));
            }
            methodes(scene).tels(r -> r.parametres.equals("8 × 8")).get().forEach(r -> valeurs.put(scene + ".8x8", duel(scene, r)));
        }
        for (Releve r : releves.de(Catalogue.DEMANDES).get()) {
            valeurs.put("demandes." + r.nom(), Noms.rapport(r.rapport()));
        }
        if (!releves.de(Catalogue.SPHERES).get().isEmpty()) {
            valeurs.put("spheres.titre", titreDesSpheres());
            valeurs.put("spheres.povray", plusViteQue(Catalogue.POVRAY));
            valeurs.put("spheres.embree", plusViteQue(Catalogue.EMBREE));
            valeurs.put("spheres.boucles", plusViteQue(Catalogue.BOUCLES));
        }
        valeurs.put("besoins.tableau", besoins.stream().map(this::table).collect(Collectors.joining("", "\n", "\n")));
        DoubleSummaryStatistics exces = besoins.stream().mapToDouble(Constats::exces).summaryStatistics();
        valeurs.put("parcimonie", "de " + Style.arrondi(100 * exces.getMin()) + " à " + Style.arrondi(100 * exces.getMax()) + " %");
        valeurs.put("besoins.taille", besoins.get(0).get("largeur") + " × " + besoins.get(0).get("hauteur"));
        valeurs.put("marge", Style.arrondi(100 * (releves.marge() - 1)) + " %");
        valeurs.put("machine", circonstances());
        return valeurs;
    }

    /** Machine sur laquelle, et moment où, les temps ont été pris. */
    String circonstances() {
        return releves.get().stream().filter(r -> !r.texte("machine").isEmpty()).findFirst().map(Releve::circonstances)
                .orElse("aucun temps n'a été pris");
    }

    // ---- une scène

    /** Réglage à choisir : le moins cher sous l'arrondi de l'écran ou, si rien n'y est, le plus juste. */
    Releve choix(String scene) {
        Releves siens = methodes(scene);
        List<Releve> front = siens.front();
        return siens.leMoinsCher(ARRONDI).orElse(front.get(front.size() - 1));
    }

    /** La décision : de quelle méthode, à quel prix. */
    String titre(String scene) {
        Releve r = choix(scene);
        return Noms.scene(scene) + " : " + (r.erreur().max <= ARRONDI ? "sous l'arrondi de l'écran" : Noms.niveaux(r.erreur().valeur))
                + " pour " + Style.arrondi(prix(r)) + " fois le prix d'un rayon : " + Noms.methode(r);
    }

    /** Prix en nombre de fois les rayons d'un rayon par pixel. */
    double prix(Releve r) {
        return r.rayons() / methodes(r.scene).le(Catalogue.UN_RAYON, "").rayons();
    }

    /** La pente d'une méthode, en logarithmes, d'un rayon par pixel à ses réglages : ce que rapporte un prix dix fois plus grand. */
    double pente(String scene, String methode) {
        Releves siens = methodes(scene);
        double[] xy = new double[4];
        List<Releve> points = siens.methode(methode, Catalogue.UN_RAYON).get();
        for (Releve r : points) {
            double x = Math.log(r.rayons());
            double y = Math.log(r.erreur().valeur);
            xy[0] += x;
            xy[1] += y;
            xy[2] += x * x;
            xy[3] += x * y;
        }
        int n = points.size();
        return (n * xy[3] - xy[0] * xy[1]) / (n * xy[2] - xy[0] * xy[0]);
    }

    /** Facteur par lequel l'erreur se divise quand le prix est dix fois plus grand. */
    private String pentes(String scene) {
        return "la grille la divise par " + Style.arrondi(Math.pow(10, -pente(scene, Catalogue.GRILLE))) + ", « coins » par "
                + Style.arrondi(Math.pow(10, -pente(scene, Catalogue.COINS))) + ", « partage » par "
                + Style.arrondi(Math.pow(10, -pente(scene, Catalogue.PARTAGE)));
    }

    /** Résultat d'un réglage, et ce qui le bat. */
    private String duel(String scene, Releve r) {
        return description(r) + " ; " + methodes(scene).vainqueur(r).map(mieux -> "battu par " + Noms.methode(mieux) + " : "
                + Noms.niveaux(mieux.erreur().valeur) + " " + prixDit(mieux)).orElse("rien de ce qui est mesuré ne le bat à coup sûr");
    }

    private String prixDit(Releve r) {
        return "pour " + Style.arrondi(prix(r)) + " fois les rayons";
    }

    private String description(Releve r) {
        Intervalle e = r.erreur();
        String temps = Noms.temps(r);
        return Style.nombre(e.valeur) + (e.valeur < 2 ? " niveau" : " niveaux") + " (de " + Style.nombre(e.min) + " à "
                + Style.nombre(e.max) + ") et " + Noms.visibles(r) + ", " + prixDit(r) + (temps.isEmpty() ? "" : ", " + temps);
    }

    /** Le plus juste de POV-Ray, et ce qui le bat chez nous. */
    private String povray(String scene) {
        return methodes(scene).methode(Catalogue.POVRAY).get().stream().min(Comparator.comparingDouble(r -> r.erreur().valeur))
                .map(r -> Noms.methode(r) + " : " + duel(scene, r)).orElse("POV-Ray n'était pas installé");
    }

    /** Une ligne de tableau : pour chaque erreur à ne pas dépasser, le moins cher des réglages qui la tiennent à coup sûr. */
    String paliers(String scene) {
        return DoubleStream.of(4, 2, 1, 0.5, ARRONDI).mapToObj(palier -> methodes(scene).leMoinsCher(palier)
                .map(r -> Noms.methode(r) + " : " + Noms.prix(prix(r))).orElse("rien")).collect(Collectors.joining(" | "));
    }

    // ---- le nombre de sphères

    /** Taille d'où le programme va plus vite que les boucles du cours, et de combien à la plus grande foule où elles se comparent. */
    String titreDesSpheres() {
        List<Releve> boucles = spheres(Catalogue.BOUCLES).tels(r -> r.rapport().max < Double.POSITIVE_INFINITY).get();
        Releve des = null;
        for (Releve r : boucles) {
            des = !Intervalle.exact(1).nettementSous(r.rapport()) ? null : des == null ? r : des;
        }
        return des == null ? "Aucune foule où la mesure porte que le programme aille plus vite que les boucles du cours"
                : "Dès " + nombre(des) + " sphères, le programme va plus vite que les boucles du cours : à "
                + nombre(boucles.get(boucles.size() - 1)) + ", " + fois(boucles.get(boucles.size() - 1));
    }

    private static String fois(Releve r) {
        return "de " + Style.arrondi(r.rapport().min) + " à " + Style.arrondi(r.rapport().max) + " fois";
    }

    /** Nombre de sphères où le programme va plus vite que cette méthode, ou moins vite, à coup sûr, et combien de fois. */
    private String plusViteQue(String methode) {
        List<String> phrases = new ArrayList<>();
        for (Releve lui : spheres(methode).get()) {
            Intervalle i = lui.rapport();
            if (Intervalle.exact(1).nettementSous(i)) {
                phrases.add(nombre(lui) + " (" + fois(lui) + " plus vite)");
            } else if (i.nettementSous(Intervalle.exact(1))) {
                phrases.add(nombre(lui) + " (de " + Style.arrondi(1 / i.max) + " à " + Style.arrondi(1 / i.min) + " fois moins vite)");
            }
        }
        return phrases.isEmpty() ? "aucune différence que la mesure porte" : "le programme dessine " + String.join(", ", phrases)
                + " sphères";
    }

    static String nombre(Releve r) {
        return Style.nombre(r.nombre("spheres"));
    }

    // ---- la parcimonie

    /** Tableau de ce que demande une scène, et de ce que fait le programme. */
    private String table(Map<String, String> b) {
        double pixels = nombre(b, "largeur") * nombre(b, "hauteur");
        double ms = releves.scene(b.get("scene")).tels(r -> r.nombre("reference_ms") > 0).referenceMs();
        String[][] lignes = {{"rayons par pixel", Style.nombre(nombre(b, "rayons_utiles") / pixels) + " qui changent l'écran",
            Style.nombre(nombre(b, "rayons") / pixels) + ", dont " + Style.arrondi(100 * exces(b)) + " % pour rien ("
            + Style.arrondi(100 * nombre(b, "ombres_inutiles") / nombre(b, "rayons")) + " % d'ombre)"},
            {"lampes", b.get("lampes_utiles") + " qui changent l'écran", b.get("lampes")},
            {"reflets à la suite", b.get("profondeur_utile"), Math.min(Constantes.MAX_REFLETS, Integer.parseInt(b.get("profondeur_utile")))
                + " (" + Constantes.MAX_REFLETS + " au plus)"},
            {"structures", Style.nombre(nombre(b, "spheres")) + (b.get("spheres").equals("1") ? " sphère" : " sphères"),
                b.get("structures") + " ; " + Style.nombre(nombre(b, "tests_par_rayon")) + " sphères essayées par rayon"},
            {"octets", Style.arrondi(nombre(b, "spheres") * OCTETS_D_UNE_SPHERE) + " de sphères, " + Style.arrondi(4 * pixels)
                + " d'image", Style.arrondi(nombre(b, "octets")) + " gardés par la recherche"},
            {"millisecondes", "", Double.isNaN(ms) ? "non mesurées" : Style.arrondi(ms) + " par dessin, à chaud"}};
        return "\n### `" + b.get("scene") + "`\n\n| | demandé par la scène | fait par le programme |\n|---|---|---|\n"
                + Arrays.stream(lignes).map(l -> "| " + String.join(" | ", l) + " |\n").collect(Collectors.joining());
    }

    static double nombre(Map<String, String> b, String colonne) {
        return Double.parseDouble(b.get(colonne));
    }

    /** La part des rayons lancés qui ne changent rien à l'écran. */
    private static double exces(Map<String, String> b) {
        return 1 - nombre(b, "rayons_utiles") / nombre(b, "rayons");
    }
}
