package lancer.mesures.vitesse;

import java.util.HashMap;
import java.util.Map;
import lancer.mesures.Intervalle;
import lancer.mesures.trace.Style;

/** Comment écrire dans une phrase, ou près d'un point, ce que le CSV nomme sèchement ; et comment dire un rapport. */
final class Noms {

    private static final Intervalle UN = Intervalle.exact(1);

    /** Au-delà, une hausse se dit en « fois », non en pour cent. */
    private static final double EN_FOIS = 1.5;

    /** Au-delà, une borne ne dit rien. */
    private static final double INCONNU = 100;

    private static final Map<String, String> DANS_UNE_PHRASE = new HashMap<>();

    static {
        DANS_UNE_PHRASE.put(Catalogue.GRILLE, "la grille %s");
        DANS_UNE_PHRASE.put(Catalogue.UN_RAYON, "un rayon par pixel");
        DANS_UNE_PHRASE.put(Catalogue.BROUILLON, "le brouillon");
        DANS_UNE_PHRASE.put(Catalogue.PROFONDEUR, "un rayon à %s réflexions");
        DANS_UNE_PHRASE.put(Catalogue.SEUIL, "un rayon jusqu'au seuil %s");
        DANS_UNE_PHRASE.put(Catalogue.ENSEMBLE, "« partage » (4 ; 0,1) jusqu'au seuil %s");
        DANS_UNE_PHRASE.put(Catalogue.AUTO, "le choix de --auto erreur=%s");
        DANS_UNE_PHRASE.put(Catalogue.POVRAY, "POV-Ray (%s)");
    }

    private Noms() {
    }

    /** Un nom de scène en tête de phrase. */
    static String scene(String scene) {
        return scene.equals("scene1") ? "Scène du cours" : Character.toUpperCase(scene.charAt(0)) + scene.substring(1);
    }

    /** Dans une phrase. */
    static String methode(Releve r) {
        return String.format(DANS_UNE_PHRASE.getOrDefault(r.methode, "« " + r.methode + " » (%s)"), etiquette(r));
    }

    /** Près d'un point. */
    static String etiquette(Releve r) {
        String court = r.parametres.replaceFirst(".* jusqu'à ", "").replaceFirst("^n=(\\d+) seuil=", "$1 ; ").replaceFirst("^\\w+=", "");
        return r.methode.equals(Catalogue.UN_RAYON) ? "1 rayon" : r.methode.equals(Catalogue.BROUILLON) ? r.methode
                : r.methode.equals(Catalogue.POVRAY) ? court : court.replace('.', ',');
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
