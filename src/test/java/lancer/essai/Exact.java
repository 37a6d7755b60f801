package lancer.essai;

import java.math.BigDecimal;
import java.math.MathContext;
import lancer.Point;
import lancer.Tuple;
import lancer.Vecteur;

/**
 * L'intersection d'un rayon et d'une sphère sans arrondi : les doubles du cas sont pris tels quels, les sommes et les produits
 * sont exacts, les racines et les quotients ont 60 chiffres. Lent, et seul juge des méthodes rapides.
 */
public final class Exact {

    private static final MathContext PRECIS = new MathContext(60);
    private static final double U = 0x1p-53;

    /** La distance exacte, arrondie au double le plus proche ; +∞ s'il n'y a pas de contact. */
    public final double distance;

    /** De combien la droite entre dans la sphère, r − l, l étant sa distance au centre ; négatif si elle passe à côté. */
    public final double enfoncement;

    /** Vrai si arrondir la direction suffit à changer la réponse : moins de 8 u au-delà, ou en deçà, de la tangente. */
    public final boolean ambigu;

    /** La distance, sans arrondi, divisée par 2^{@code echelle} ; {@code null} s'il n'y a pas de contact. */
    private final BigDecimal exacte;
    private final int echelle;

    private final double conditionnement;

    /** Le rayon part de {@code p} vers {@code vers} ; sa direction est la différence exacte, que rien n'arrondit. */
    public Exact(Point p, Point vers, Point centre, double rayon) {
        // une puissance de deux ramène la scène près de 1 : rien n'en change, et les nombres s'écrivent en peu de chiffres
        int e = Math.getExponent(Math.max(Math.max(norme(p), norme(vers)), Math.max(norme(centre), rayon)));
        echelle = e;
        BigDecimal[] d = difference(p, vers, e);
        BigDecimal[] f = difference(p, centre, e);
        BigDecimal r = nombre(rayon, e);
        BigDecimal a = scalaire(d, d);
        BigDecimal b = scalaire(f, d);
        BigDecimal c = scalaire(f, f).subtract(r.multiply(r));
        BigDecimal discriminant = b.multiply(b).subtract(a.multiply(c));
        BigDecimal l = scalaire(f, f).multiply(a).subtract(b.multiply(b)).divide(a, PRECIS).sqrt(PRECIS);
        enfoncement = reel(r.subtract(l), e);
        BigDecimal norme = a.sqrt(PRECIS);
        BigDecimal douteux = r.multiply(b.abs()).multiply(norme).multiply(new BigDecimal(16 * U));
        ambigu = c.signum() > 0 && b.signum() > 0 && discriminant.abs().compareTo(douteux) <= 0;
        if (discriminant.signum() < 0) {
            distance = Double.POSITIVE_INFINITY;
            conditionnement = 1;
            exacte = null;
            return;
        }
        BigDecimal racine = discriminant.sqrt(PRECIS);
        BigDecimal t = null;
        if (c.signum() > 0) {
            t = b.signum() > 0 ? c.divide(b.add(racine), PRECIS) : null;
        } else if (b.signum() > 0) {
            t = b.add(racine).divide(a, PRECIS);
        } else if (c.signum() < 0) {
            t = c.divide(b.subtract(racine), PRECIS);
        }
        exacte = t == null ? null : t.multiply(norme, PRECIS);
        distance = exacte == null ? Double.POSITIVE_INFINITY : reel(exacte, e);
        // près de la tangente, où la demi-corde est nulle, un chiffre perdu sur les données en coûte beaucoup au résultat
        conditionnement = 1 + rayon / reel(racine.divide(norme, PRECIS), e);
    }

    /**
     * L'écart d'une réponse, en unités de 8 u (1 + r/h) t ; +∞ si elle n'est pas du bon genre.
     *
     * @param reponse une distance, +∞ pour dire qu'il n'y a pas de contact
     */
    public double ecart(double reponse) {
        boolean rien = reponse == Double.POSITIVE_INFINITY;
        if (exacte == null || rien || !(reponse > 0)) {
            return exacte == null && rien ? 0 : Double.POSITIVE_INFINITY;
        }
        return nombre(reponse, echelle).subtract(exacte).abs().divide(exacte, PRECIS).doubleValue() / (8 * U * conditionnement);
    }

    /** La distance d'un point à la surface d'une sphère. */
    public static double ecartALaSurface(Point x, Point centre, double rayon) {
        BigDecimal[] n = difference(centre, x, 0);
        return scalaire(n, n).sqrt(PRECIS).subtract(new BigDecimal(rayon)).abs().doubleValue();
    }

    /** La longueur d'un vecteur, moins 1. */
    public static double ecartALUnite(Vecteur v) {
        BigDecimal[] n = difference(new Point(), new Point(v.x, v.y, v.z), 0);
        return scalaire(n, n).sqrt(PRECIS).subtract(BigDecimal.ONE).doubleValue();
    }

    private static double norme(Tuple t) {
        return Math.max(Math.abs(t.x), Math.max(Math.abs(t.y), Math.abs(t.z)));
    }

    /** Le nombre x/2^e, sans arrondi. */
    private static BigDecimal nombre(double x, int e) {
        double petit = Math.scalb(x, -e);
        if (Math.scalb(petit, e) == x) {
            return new BigDecimal(petit);
        }
        // trop petit auprès du reste pour rester un double
        BigDecimal puissance = BigDecimal.valueOf(2).pow(Math.abs(e));
        return e < 0 ? new BigDecimal(x).multiply(puissance) : new BigDecimal(x).divide(puissance);
    }

    private static double reel(BigDecimal x, int e) {
        return Math.scalb(x.doubleValue(), e);
    }

    private static BigDecimal[] difference(Point a, Point b, int e) {
        return new BigDecimal[] {nombre(b.x, e).subtract(nombre(a.x, e)), nombre(b.y, e).subtract(nombre(a.y, e)),
            nombre(b.z, e).subtract(nombre(a.z, e))};
    }

    private static BigDecimal scalaire(BigDecimal[] u, BigDecimal[] v) {
        return u[0].multiply(v[0]).add(u[1].multiply(v[1])).add(u[2].multiply(v[2]));
    }
}
