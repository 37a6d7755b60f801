package lancer.mesures.vitesse;

import java.util.Arrays;
import lancer.mesures.Intervalle;
import lancer.mesures.trace.FormeDePoint;
import lancer.mesures.trace.Style;

/** Comment écrire dans une phrase, ou près d'un point, ce que le CSV nomme sèchement ; et comment dire un rapport. */
final class Noms {

    private static final Intervalle UN = Intervalle.exact(1);

    /** Au-delà, une hausse se dit en « fois », non en pour cent. */
    private static final double EN_FOIS = 1.5;

    /** Au-delà, une borne ne dit rien. */
    private static final double INCONNU = 100;

    /** De chaque méthode, son nom dans le CSV, dans la légende et dans une phrase, et l'apparence de ses points. */
    static final Object[][] METHODES = {
        {Catalogue.BROUILLON, "brouillon", "le brouillon", Style.GRIS, FormeDePoint.POINTE},
        {Catalogue.UN_RAYON, "un rayon", "un rayon par pixel", Style.NOIR, FormeDePoint.ROND},
        {Catalogue.PROFONDEUR, "un rayon, tant de réflexions", "un rayon à %s réflexions",
            Style.VERMILLON, FormeDePoint.ROND},
        {Catalogue.SEUIL, "un rayon, jusqu'à ce seuil", "un rayon jusqu'au seuil %s",
            Style.POURPRE, FormeDePoint.CROIX},
        {Catalogue.GRILLE, "grille complète", "la grille %s", Style.BLEU, FormeDePoint.CARRE},
        {Catalogue.COINS, "« coins » (n ; seuil)", "« coins » (%s)", Style.ORANGE, FormeDePoint.TRIANGLE},
        {Catalogue.PARTAGE, "« partage » (n ; seuil)", "« partage » (%s)", Style.VERT, FormeDePoint.LOSANGE},
        {Catalogue.ENSEMBLE, "« partage » (4 ; 0,1), jusqu'à ce seuil", "« partage » (4 ; 0,1) jusqu'au seuil %s",
            Style.VERMILLON, FormeDePoint.LOSANGE},
        {Catalogue.AUTO, "--auto, pour cette erreur", "le choix de --auto erreur=%s", Style.NOIR, FormeDePoint.ETOILE},
        {Catalogue.POVRAY, "POV-Ray et ses options", "POV-Ray (%s)", Style.CIEL, FormeDePoint.TRIANGLE}};

    private Noms() {
    }

    /** Un nom de scène en tête de phrase. */
    static String scene(String scene) {
        return scene.equals("scene1") ? "Scène du cours" : Character.toUpperCase(scene.charAt(0)) + scene.substring(1);
    }

    /** Dans une phrase. */
    static String methode(Releve r) {
        Object[] noms = Arrays.stream(METHODES).filter(m -> m[0].equals(r.methode)).findFirst().get();
        return String.format((String) noms[2], etiquette(r));
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
