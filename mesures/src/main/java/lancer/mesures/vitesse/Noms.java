package lancer.mesures.vitesse;

import java.util.Arrays;
import lancer.mesures.Intervalle;
import lancer.mesures.trace.FormeDePoint;
import lancer.mesures.trace.Style;

/** Façon d'écrire dans une phrase, ou près d'un point, ce que le CSV nomme sèchement ; et comment dire un rapport. */
final class Noms {

    private static final Intervalle UN = Intervalle.exact(1);

    /** Rapport au-delà duquel une hausse se dit en « fois », non en pour cent. */
    private static final double EN_FOIS = 1.5;

    /** Rapport au-delà duquel une borne ne dit rien. */
    private static final double INCONNU = 100;

    /** Noms de chaque méthode : dans le CSV, au bout de sa ligne, dans une phrase, près d'un point, et l'apparence de ses points. */
    static final Object[][] METHODES = {
        {Catalogue.UN_RAYON, "", "un rayon par pixel", "un rayon par pixel", Style.NOIR, FormeDePoint.ROND},
        {Catalogue.PROFONDEUR, "un rayon, moins de reflets ou plus", "un rayon à %s reflets", "%s reflets", Style.VERMILLON,
            FormeDePoint.ROND},
        {Catalogue.SEUIL, "", "un rayon, aux reflets coupés sous %s", "reflets coupés sous %s", Style.POURPRE, FormeDePoint.CROIX},
        {Catalogue.GRILLE, "grille, partout", "la grille %s, partout", "%s partout", Style.BLEU, FormeDePoint.CARRE},
        {Catalogue.COINS, "coins", "coins, %s", "coins, %s", Style.ORANGE, FormeDePoint.TRIANGLE},
        {Catalogue.PARTAGE, "partage", "partage, %s", "partage, %s", Style.VERT, FormeDePoint.LOSANGE},
        {Catalogue.ENSEMBLE, "partage, tous les reflets", "partage, %s", "partage, %s", Style.VERT, FormeDePoint.LOSANGE},
        {Catalogue.AUTO, "", "--auto, %s", "--auto, %s voulu", Style.POURPRE, FormeDePoint.POINTE},
        {Catalogue.POVRAY, "", "POV-Ray, %s", "POV-Ray, %s", Style.CIEL, FormeDePoint.TRIANGLE}};

    private Noms() {
    }

    private static Object[] de(Releve r) {
        return Arrays.stream(METHODES).filter(m -> m[0].equals(r.methode)).findFirst().get();
    }

    /** Un nom de scène en tête de phrase. */
    static String scene(String scene) {
        return scene.equals("scene1") ? "Scène du cours" : Character.toUpperCase(scene.charAt(0)) + scene.substring(1);
    }

    /** Nom dans une phrase. */
    static String methode(Releve r) {
        return String.format((String) de(r)[2], parametres(r, "$1 rayons là où c'est utile (seuil $2)",
                "$1 × $1 où quatre coins diffèrent")).replaceFirst("\\b1 reflets", "1 reflet");
    }

    /** Près d'un point. */
    static String etiquette(Releve r) {
        return String.format((String) de(r)[3], parametres(r, "$1 rayons, seuil $2", "$1 × $1")).replaceFirst("\\b1 reflets", "1 reflet");
    }

    private static String parametres(Releve r, String partage, String coins) {
        return r.parametres.replace('.', ',')
                .replaceFirst("^n=(\\d+) seuil=([\\d,]+)", r.methode.equals(Catalogue.COINS) ? coins : partage)
                .replaceFirst(" reflets=\\d+ jusqu'à ", ", tous les reflets jusqu'à ").replaceFirst("^\\w+=", "");
    }

    /** Prix en nombre de fois les rayons d'un rayon par pixel : « × 4 ». */
    static String prix(double fois) {
        return "× " + Style.arrondi(fois);
    }

    static String niveaux(double erreur) {
        return Style.arrondi(erreur) + (erreur < 2 ? " niveau" : " niveaux");
    }

    static String visibles(Releve r) {
        return Style.arrondi(100 * r.nombre("visibles")) + " % visiblement faux";
    }

    /** Le temps, à celui d'un rayon, s'il est connu : « temps × 2,6 (de 2,4 à 2,9) » ; vide sinon. */
    static String temps(Releve r) {
        Intervalle i = r.rapport();
        return !(i.max < INCONNU * i.valeur) || r.methode.equals(Catalogue.UN_RAYON) ? ""
                : "temps × " + Style.arrondi(i.valeur) + " (de " + Style.arrondi(i.min) + " à " + Style.arrondi(i.max) + ")";
    }

    /** Écart : de combien c'est plus que 1, et entre quoi ; ou qu'on ne sait pas le dire. */
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
