package lancer.mesures.vitesse;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lancer.Constantes;
import lancer.mesures.trace.Style;

/** Du CSV des besoins au tableau que l'on lit. */
final class TableBesoins {

    private static final Map<String, String> STRUCTURES = new HashMap<>();

    static {
        STRUCTURES.put("Carte", "une carte vue de l'œil");
        STRUCTURES.put("Grille", "une grille");
        STRUCTURES.put("CarteLampe", "une carte");
        STRUCTURES.put("Arbre", "un arbre");
        STRUCTURES.put("Masques", "des masques");
        STRUCTURES.put("Ombres", "des masques");
    }

    private TableBesoins() {
    }

    static String markdown(List<Map<String, String>> besoins) {
        StringBuilder s = new StringBuilder("<!-- écrit par « make mesures » : ne rien changer ici -->\n"
                + "# Ce que demande chaque scène, et ce que le programme fait pour elle\n\n"
                + "En " + besoins.get(0).get("largeur") + " × " + besoins.get(0).get("hauteur")
                + ", un rayon par pixel ; rien n'est chronométré, tout est compté.\n\n"
                + "## Ce qu'elle demande\n\n"
                + "| scène | sphères | lampes qui changent au moins un pixel | réflexions qui changent au moins un pixel "
                + "| pixels à plus de quatre rayons |\n"
                + "|---|---|---|---|---|\n");
        for (Map<String, String> b : besoins) {
            s.append("| `").append(b.get("scene")).append("` | ").append(entier(b.get("spheres"))).append(" | ").append(lampes(b))
                    .append(" | ").append(profondeur(b)).append(" | ")
                    .append(Style.arrondi(100 * Double.parseDouble(b.get("part_antialias")))).append(" % |\n");
        }
        s.append("\nUne réflexion compte si, sans elle, l'image de l'écran ne serait pas celle de mille réflexions sans seuil.\n"
                + "Le programme en fait " + Constantes.MAX_REFLETS
                + " si on ne lui dit rien : là où il en faudrait plus, un pixel au moins n'a pas\n"
                + "sa couleur. La dernière colonne est celle de l'anticrénelage du cours, à ses réglages par défaut.\n\n"
                + "## Ce que le programme fait pour elle\n\n"
                + "| scène | premiers rayons | rayons réfléchis | ombres, lampe par lampe "
                + "| sphères essayées par rayon | rayons non lancés | rayons lancés de trop |\n"
                + "|---|---|---|---|---|---|---|\n");
        for (Map<String, String> b : besoins) {
            String[] noms = b.get("structures").split(" ");
            s.append("| `").append(b.get("scene")).append("` | ").append(STRUCTURES.get(noms[0])).append(" | ")
                    .append(STRUCTURES.get(noms[1])).append(" | ").append(ombres(noms)).append(" | ")
                    .append(Style.nombre(Double.parseDouble(b.get("tests_par_rayon")))).append(" | ")
                    .append(Style.arrondi(100 * economie(b))).append(" % | ").append(Style.arrondi(100 * exces(b))).append(" % |\n");
        }
        return s.append("\nLes rayons non lancés le seraient par qui suivrait partout les reflets jusqu'à la cinquième réflexion, et\n"
                + "demanderait à chaque contact si chaque lampe y est cachée : reflets d'un Ks nul, ou d'un produit des Ks trop\n"
                + "petit ; ombres dans le dos d'un objet, ou là où la lampe n'éclairerait rien. Les rayons lancés de trop\n"
                + "suivent, dans leur pixel, la dernière réflexion qui change sa couleur à l'écran.\n").toString();
    }

    /** La part des rayons qui n'ont pas été lancés. */
    static double economie(Map<String, String> b) {
        return 1 - Double.parseDouble(b.get("rayons")) / Double.parseDouble(b.get("rayons_sans_economie"));
    }

    /** La part des rayons lancés qui ne changent rien à l'écran. */
    static double exces(Map<String, String> b) {
        return 1 - Double.parseDouble(b.get("rayons_utiles")) / Double.parseDouble(b.get("rayons"));
    }

    private static String lampes(Map<String, String> b) {
        String toutes = b.get("lampes");
        String utiles = b.get("lampes_utiles");
        return utiles.equals(toutes) ? "toutes, " + toutes : utiles + " sur " + toutes;
    }

    private static String profondeur(Map<String, String> b) {
        return b.get("profondeur_utile").equals("0") ? "aucune" : b.get("profondeur_utile");
    }

    private static String entier(String texte) {
        return Style.nombre(Double.parseDouble(texte));
    }

    /** La même structure pour toutes les lampes n'est dite qu'une fois. */
    private static String ombres(String[] noms) {
        List<String> siennes = new ArrayList<>();
        boolean memes = true;
        for (int k = 2; k < noms.length; k++) {
            siennes.add(STRUCTURES.get(noms[k]));
            memes &= noms[k].equals(noms[2]);
        }
        return siennes.isEmpty() ? "aucune lampe" : memes ? siennes.get(0) + (siennes.size() > 1 ? " chacune" : "")
                : String.join(", ", siennes);
    }
}
