package lancer.mesures.vitesse;

import java.util.List;
import java.util.Map;
import lancer.Constantes;
import lancer.mesures.trace.Style;

/** Du CSV des besoins au tableau que l'on lit. */
final class TableBesoins {

    private TableBesoins() {
    }

    static String markdown(List<Map<String, String>> besoins) {
        StringBuilder s = new StringBuilder("<!-- écrit par « make mesures » : ne rien changer ici -->\n"
                + "# Ce que demande chaque scène, et ce que le programme fait pour elle\n\n"
                + "En " + besoins.get(0).get("largeur") + " × " + besoins.get(0).get("hauteur")
                + ", un rayon par pixel ; rien n'est chronométré, tout est compté.\n\n"
                + "| scène | sphères | lampes qui changent au moins un pixel | réflexions qui changent au moins un pixel "
                + "| sphères essayées par rayon | rayons non lancés | rayons lancés de trop |\n"
                + "|---|---|---|---|---|---|---|\n");
        for (Map<String, String> b : besoins) {
            s.append("| ").append(String.join(" | ", "`" + b.get("scene") + "`", nombre(b, "spheres"),
                    b.get("lampes_utiles") + " sur " + b.get("lampes"), b.get("profondeur_utile"), nombre(b, "tests_par_rayon"),
                    Style.arrondi(100 * economie(b)) + " %", Style.arrondi(100 * exces(b)) + " %")).append(" |\n");
        }
        return s.append("\nUne réflexion compte si, sans elle, l'image de l'écran ne serait pas celle de mille réflexions sans seuil.\n"
                + "Le programme en fait " + Constantes.MAX_REFLETS
                + " si on ne lui dit rien : là où il en faudrait plus, un pixel au moins n'a pas sa couleur.\n\n"
                + "Les rayons non lancés le seraient par qui suivrait partout les reflets jusqu'à la cinquième réflexion, et\n"
                + "demanderait à chaque contact si chaque lampe y est cachée : reflets d'un Ks nul, ou d'un produit des Ks trop\n"
                + "petit ; ombres dans le dos d'un objet, ou là où la lampe n'éclairerait rien. Les rayons lancés de trop\n"
                + "suivent, dans leur pixel, la dernière réflexion qui change sa couleur à l'écran.\n").toString();
    }

    private static String nombre(Map<String, String> b, String colonne) {
        return Style.nombre(Double.parseDouble(b.get(colonne)));
    }

    /** La part des rayons qui n'ont pas été lancés. */
    static double economie(Map<String, String> b) {
        return 1 - Double.parseDouble(b.get("rayons")) / Double.parseDouble(b.get("rayons_sans_economie"));
    }

    /** La part des rayons lancés qui ne changent rien à l'écran. */
    static double exces(Map<String, String> b) {
        return 1 - Double.parseDouble(b.get("rayons_utiles")) / Double.parseDouble(b.get("rayons"));
    }
}
