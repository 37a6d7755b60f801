package lancer.mesures.vitesse;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.DoubleSummaryStatistics;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import lancer.atelier.Scenes;
import lancer.mesures.Intervalle;
import lancer.mesures.trace.Style;

/**
 * Ce que disent les mesures, en phrases : les titres des courbes, et ce que montrent les pages, par leurs noms. Tout est calculé ; aucune
 * différence n'est dite qu'{@link Intervalle#nettementSous} ne porte.
 */
final class Constats {

    /** Ce que vaut, en moyenne quadratique, d'arrondir à l'écran. */
    static final double ARRONDI = 1 / Math.sqrt(12);

    final Releves releves;
    final List<Map<String, String>> besoins;

    Constats(Releves releves, List<Map<String, String>> besoins) {
        this.releves = releves;
        this.besoins = besoins;
    }

    Releves methodes(String scene) {
        return releves.de(Catalogue.METHODES).scene(scene);
    }

    Releves demandes() {
        return releves.de(Catalogue.DEMANDES);
    }

    Releves spheres(String famille, String methode) {
        return releves.de(Catalogue.SPHERES).methode(methode).tels(r -> r.scene.startsWith(famille + "-"));
    }

    /** Ce que montrent les pages, par leurs noms. */
    Map<String, String> pages() {
        Map<String, String> valeurs = new TreeMap<>();
        for (String scene : releves.de(Catalogue.METHODES).scenes()) {
            valeurs.put(scene + ".titre", titre(scene));
            valeurs.put(scene + ".coins", duel(scene, methodes(scene).le(Catalogue.COINS, Catalogue.COINS_DEFAUT)));
            valeurs.put(scene + ".povray", povray(scene));
            valeurs.put(scene + ".paliers", paliers(scene));
            valeurs.put(scene + ".p=1000", description(methodes(scene).le(Catalogue.PROFONDEUR, "p=1000")));
            methodes(scene).methode(Catalogue.GRILLE).tels(r -> r.parametres.equals("8 × 8")).get()
                    .forEach(r -> valeurs.put(scene + ".8x8", duel(scene, r)));
            valeurs.put(scene + ".unrayon", Style.nombre(methodes(scene).le(Catalogue.UN_RAYON, "").erreur().valeur));
        }
        valeurs.put("demandes.titre", "Le temps d'une lampe de plus : "
                + Noms.rapport(demandes().le("lampe", "une de plus").rapport()));
        for (Releve r : demandes().get()) {
            valeurs.put("demandes." + r.nom(), Noms.rapport(r.rapport()));
        }
        valeurs.put("spheres.titre", titreDesSpheres());
        valeurs.put("spheres.povray", plusViteQue(Catalogue.POVRAY));
        valeurs.put("spheres.boucles", plusViteQue(Catalogue.BOUCLES));
        valeurs.put("spheres.etoiles", etoiles());
        valeurs.put("parcimonie.titre", titreDeLaParcimonie());
        valeurs.put("besoins.tableau", tableauDesBesoins());
        valeurs.put("besoins.taille", besoins.get(0).get("largeur") + " × " + besoins.get(0).get("hauteur"));
        valeurs.put("marge", Style.arrondi(100 * (releves.marge() - 1)) + " %");
        valeurs.put("machine", releves.get().get(0).circonstances());
        return valeurs;
    }

    // ---- une scène

    /** Ce qui bat de plus loin un réglage que l'on prendrait d'abord, une grille ou « coins », et de combien. */
    String titre(String scene) {
        Releves siens = methodes(scene);
        Map<Releve, Releve> vainqueurs = new LinkedHashMap<>();
        siens.methode(Catalogue.GRILLE, Catalogue.COINS).get()
                .forEach(r -> siens.vainqueur(r).ifPresent(v -> vainqueurs.put(r, v)));
        return Noms.scene(scene) + " : " + vainqueurs.keySet().stream()
                .max(Comparator.comparingDouble(r -> r.rapport().valeur / vainqueurs.get(r).rapport().valeur))
                .map(r -> Noms.methode(vainqueurs.get(r)) + " bat " + Noms.methode(r) + ", "
                        + fois(vainqueurs.get(r), r) + " moins de temps")
                .orElse("aucune différence que la mesure porte entre grilles, « coins » et les autres");
    }

    /** Combien de fois plus vite, d'après le moins que portent les deux intervalles, et le plus. */
    private static String fois(Releve gagnant, Releve battu) {
        return "de " + Style.nombre(battu.rapport().min / gagnant.rapport().max) + " à "
                + Style.nombre(battu.rapport().max / gagnant.rapport().min) + " fois";
    }

    /** Ce que coûte un réglage, et ce qui le bat. */
    private String duel(String scene, Releve r) {
        return description(r) + " ; " + methodes(scene).vainqueur(r).map(mieux -> "battu par " + Noms.methode(mieux)
                + ", " + fois(mieux, r) + " moins de temps et " + Style.nombre(mieux.erreur().valeur) + " pas d'erreur")
                .orElse("rien de ce qui est mesuré ne le bat à coup sûr");
    }

    private static String description(Releve r) {
        Intervalle e = r.erreur();
        return Style.nombre(e.valeur) + " pas d'erreur (de " + Style.nombre(e.min) + " à " + Style.nombre(e.max) + "), pour le temps : "
                + Noms.rapport(r.rapport());
    }

    /** Le plus juste de POV-Ray, et ce qui le bat chez nous. */
    private String povray(String scene) {
        return methodes(scene).methode(Catalogue.POVRAY).get().stream()
                .min(Comparator.comparingDouble(r -> r.erreur().valeur))
                .map(r -> Noms.methode(r) + " : " + duel(scene, r)).orElse("POV-Ray n'était pas installé");
    }

    /** Une ligne de tableau : pour chaque erreur à ne pas dépasser, le réglage le plus rapide qui la tient à coup sûr. */
    String paliers(String scene) {
        return DoubleStream.of(4, 2, 1, 0.5, ARRONDI).mapToObj(palier -> methodes(scene).get().stream()
                .filter(r -> !r.methode.equals(Catalogue.POVRAY) && r.erreur().max <= palier)
                .min(Comparator.comparingDouble(r -> r.rapport().valeur))
                .map(r -> Noms.methode(r) + " : " + Noms.rapport(r.rapport())).orElse("rien")).collect(Collectors.joining(" | "));
    }

    // ---- le nombre de sphères

    String titreDesSpheres() {
        List<Releve> siens = spheres(Scenes.FOULE, Catalogue.PROGRAMME).get();
        Releve petit = siens.get(siens.size() > 2 ? 1 : 0);
        Releve grand = siens.get(siens.size() - 1);
        return "De " + nombre(petit) + " à " + nombre(grand) + " sphères, tout compris, " + (petit.rapport().nettementSous(grand.rapport())
                ? "le programme prend " + fois(petit, grand) + " plus de temps" : "aucune différence que la mesure porte");
    }

    /** À combien de sphères le programme va plus vite que cette méthode, à coup sûr, et combien de fois. */
    private String plusViteQue(String methode) {
        List<String> phrases = new ArrayList<>();
        for (Releve lui : spheres(Scenes.FOULE, methode).get()) {
            Releve nous = releves.de(Catalogue.SPHERES).scene(lui.scene).le(Catalogue.PROGRAMME, "");
            if (nous.rapport().nettementSous(lui.rapport())) {
                phrases.add(nombre(nous) + " (" + fois(nous, lui) + ")");
            }
        }
        return phrases.isEmpty() ? "à aucun nombre de sphères la mesure ne porte que le programme soit le plus rapide"
                : "le programme est le plus rapide à " + String.join(", ", phrases) + " sphères";
    }

    /** Ce que neuf étoiles ajoutent aux sphères et aux cases examinées : un compte, non un temps. */
    private String etoiles() {
        List<Releve> siennes = spheres(Scenes.ETOILES, Catalogue.PROGRAMME).get();
        Releve avec = siennes.get(siennes.size() - 1);
        Releve sans = releves.de(Catalogue.SPHERES).scene(avec.scene.replace(Scenes.ETOILES, Scenes.FOULE)).le(Catalogue.PROGRAMME, "");
        return "neuf étoiles à 10¹² d'une foule de " + nombre(sans) + " multiplient ce qu'examinent ses rayons par "
                + Style.nombre(examens(avec) / examens(sans));
    }

    static double examens(Releve r) {
        return r.nombre("tests") + (Double.isNaN(r.nombre("noeuds")) ? 0 : r.nombre("noeuds"));
    }

    static String nombre(Releve r) {
        return Style.nombre(r.nombre("spheres"));
    }

    // ---- la parcimonie

    private String tableauDesBesoins() {
        return "\n\n| scène | sphères | lampes qui changent au moins un pixel | réflexions qui changent au moins un pixel "
                + "| sphères essayées par rayon | rayons non lancés | rayons lancés de trop |\n|---|---|---|---|---|---|---|\n"
                + besoins.stream().map(b -> "| " + String.join(" | ", "`" + b.get("scene") + "`",
                Style.nombre(nombre(b, "spheres")), b.get("lampes_utiles") + " sur " + b.get("lampes"), b.get("profondeur_utile"),
                Style.nombre(nombre(b, "tests_par_rayon")), Style.arrondi(100 * economie(b)) + " %",
                Style.arrondi(100 * exces(b)) + " %") + " |\n").collect(Collectors.joining()) + "\n";
    }

    static double nombre(Map<String, String> b, String colonne) {
        return Double.parseDouble(b.get(colonne));
    }

    /** La part des rayons qui n'ont pas été lancés. */
    private static double economie(Map<String, String> b) {
        return 1 - nombre(b, "rayons") / nombre(b, "rayons_sans_economie");
    }

    /** La part des rayons lancés qui ne changent rien à l'écran. */
    private static double exces(Map<String, String> b) {
        return 1 - nombre(b, "rayons_utiles") / nombre(b, "rayons");
    }

    String titreDeLaParcimonie() {
        DoubleSummaryStatistics economies = besoins.stream().mapToDouble(Constats::economie).summaryStatistics();
        Map<String, String> prodigue = besoins.stream().max(Comparator.comparingDouble(Constats::exces)).get();
        return "De " + Style.arrondi(100 * economies.getMin()) + " à " + Style.arrondi(100 * economies.getMax())
                + " % des rayons ne sont pas lancés ; il en reste jusqu'à "
                + Style.arrondi(100 * exces(prodigue)) + " % (" + prodigue.get("scene") + ") qui ne changent rien à l'écran";
    }
}
