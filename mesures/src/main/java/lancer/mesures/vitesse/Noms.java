package lancer.mesures.vitesse;

import lancer.mesures.Intervalle;
import lancer.mesures.trace.Style;

/** Comment écrire dans une phrase, ou près d'un point, ce que le CSV nomme sèchement ; et comment dire un rapport. */
final class Noms {

    private static final Intervalle UN = new Intervalle(1, 1, 1);

    /** Au-delà, une hausse se dit en « fois », non en pour cent. */
    private static final double EN_FOIS = 1.5;

    /** Au-delà, une borne ne dit rien. */
    private static final double INCONNU = 100;

    private Noms() {
    }

    /** Un nom de scène en tête de phrase. */
    static String scene(String scene) {
        return scene.equals("scene1") ? "Scène du cours" : Character.toUpperCase(scene.charAt(0)) + scene.substring(1);
    }

    /** Dans une phrase. */
    static String methode(Releve r) {
        switch (r.methode) {
            case Catalogue.GRILLE:
                return "la grille " + r.parametres;
            case Catalogue.UN_RAYON:
                return "un rayon par pixel";
            case Catalogue.BROUILLON:
                return "le brouillon";
            case Catalogue.PROFONDEUR:
                return "un rayon à " + etiquette(r) + " réflexions";
            case Catalogue.SEUIL:
                return "un rayon jusqu'au seuil " + etiquette(r);
            case Catalogue.ENSEMBLE:
                return "« partage » (4 ; 0,1) jusqu'au seuil " + etiquette(r);
            case Catalogue.AUTO:
                return "le choix de --auto erreur=" + etiquette(r);
            case Catalogue.POVRAY:
                return "POV-Ray (" + r.parametres + ")";
            default:
                return "« " + r.methode + " » (" + etiquette(r) + ")";
        }
    }

    /** Près d'un point. */
    static String etiquette(Releve r) {
        switch (r.methode) {
            case Catalogue.UN_RAYON:
                return "1 rayon";
            case Catalogue.BROUILLON:
                return "brouillon";
            case Catalogue.COINS:
            case Catalogue.PARTAGE:
                return r.parametres.replaceAll("n=(\\d+) seuil=(.*)", "$1 ; $2").replace('.', ',');
            case Catalogue.ENSEMBLE:
                return r.parametres.substring(r.parametres.lastIndexOf(' ') + 1);
            default:
                return r.parametres.substring(r.parametres.indexOf('=') + 1).replace('.', ',');
        }
    }

    /** Une série, pour la légende. */
    static String serie(String methode) {
        switch (methode) {
            case Catalogue.GRILLE:
                return "grille complète";
            case Catalogue.COINS:
            case Catalogue.PARTAGE:
                return "« " + methode + " » (n ; seuil)";
            case Catalogue.PROFONDEUR:
                return "un rayon, tant de réflexions";
            case Catalogue.SEUIL:
                return "un rayon, jusqu'à ce seuil";
            case Catalogue.ENSEMBLE:
                return "« partage » (4 ; 0,1), jusqu'à ce seuil";
            case Catalogue.AUTO:
                return "--auto, pour cette erreur";
            case Catalogue.POVRAY:
                return "POV-Ray et ses options";
            default:
                return methode;
        }
    }

    /** De combien c'est plus que 1, et entre quoi ; ou qu'on ne sait pas le dire. */
    static String rapport(Intervalle i) {
        if (!UN.nettementSous(i) && !i.nettementSous(UN)) {
            return "aucune différence que la mesure porte (de " + pourCent(i.min) + " à " + pourCent(i.max) + ")";
        }
        return i.valeur < EN_FOIS ? pourCent(i.valeur) + " (de " + pourCent(i.min) + " à " + pourCent(i.max) + ")"
                : "× " + Style.nombre(i.valeur) + " (de " + Style.nombre(i.min) + " à " + Style.nombre(i.max) + ")";
    }

    /** « + 12 % ». */
    static String pourCent(double facteur) {
        return !(facteur > 1 / INCONNU && facteur < INCONNU) ? "on ne sait"
                : (facteur < 1 ? "\u2212" : "+") + "\u00A0" + Style.arrondi(Math.abs(100 * (facteur - 1))) + "\u00A0%";
    }
}
