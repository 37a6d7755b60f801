package lancer.mesures.stabilite;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;
import lancer.Point;
import lancer.Tuple;

/**
 * L'intersection d'un rayon et d'une sphère sans arrondi, qui juge les autres : les doubles donnés sont pris tels quels, les sommes
 * et les produits sont exacts, la racine et les quotients ont 70 chiffres. La direction est la différence exacte de deux points.
 */
final class Exacte {

    private static final int CHIFFRES = 70;
    private static final MathContext PRECIS = new MathContext(CHIFFRES);

    /** La plus petite distance strictement positive, arrondie au double le plus proche ; +∞ s'il n'y a pas de contact. */
    final double distance;

    /** La demi-corde h, +∞ si la droite ne touche pas la sphère. */
    final double demiCorde;

    /** De combien la droite entre dans la sphère, r − l, l étant sa distance au centre ; négatif si elle passe à côté. */
    final double enfoncement;

    /** Le rayon part de {@code P} vers {@code vers}. */
    Exacte(Point P, Point vers, Point C, double rayon) {
        BigDecimal[] d = difference(P, vers);
        BigDecimal[] f = difference(P, C);
        BigDecimal r = new BigDecimal(rayon);
        BigDecimal a = scalaire(d, d);
        BigDecimal b = scalaire(f, d);
        BigDecimal f2 = scalaire(f, f);
        BigDecimal c = f2.subtract(r.multiply(r));
        BigDecimal discriminant = b.multiply(b).subtract(a.multiply(c));
        BigDecimal l = racine(f2.multiply(a).subtract(b.multiply(b)).divide(a, PRECIS));
        enfoncement = r.subtract(l).doubleValue();
        if (discriminant.signum() < 0) {
            demiCorde = Double.POSITIVE_INFINITY;
            distance = Double.POSITIVE_INFINITY;
            return;
        }
        BigDecimal racine = racine(discriminant);
        BigDecimal norme = racine(a);
        demiCorde = racine.divide(norme, PRECIS).doubleValue();
        BigDecimal t = premiere(a, b, c, racine);
        distance = t == null ? Double.POSITIVE_INFINITY : t.multiply(norme, PRECIS).doubleValue();
    }

    /** La première racine strictement positive de a t² − 2 b t + c, {@code null} s'il n'y en a pas. */
    private static BigDecimal premiere(BigDecimal a, BigDecimal b, BigDecimal c, BigDecimal racine) {
        if (c.signum() > 0) {
            return b.signum() > 0 ? c.divide(b.add(racine), PRECIS) : null;
        }
        if (b.signum() > 0) {
            return b.add(racine).divide(a, PRECIS);
        }
        return c.signum() < 0 ? c.divide(b.subtract(racine), PRECIS) : null;
    }

    private static BigDecimal[] difference(Tuple a, Tuple b) {
        return new BigDecimal[] {new BigDecimal(b.x).subtract(new BigDecimal(a.x)),
            new BigDecimal(b.y).subtract(new BigDecimal(a.y)), new BigDecimal(b.z).subtract(new BigDecimal(a.z))};
    }

    private static BigDecimal scalaire(BigDecimal[] u, BigDecimal[] v) {
        return u[0].multiply(v[0]).add(u[1].multiply(v[1])).add(u[2].multiply(v[2]));
    }

    /** La racine carrée, à {@link #CHIFFRES} chiffres, par la méthode de Newton sur les entiers : Java 8 n'en a pas. */
    static BigDecimal racine(BigDecimal x) {
        if (x.signum() == 0) {
            return BigDecimal.ZERO;
        }
        int k = CHIFFRES + 5 - (x.precision() - x.scale()) / 2;
        BigInteger n = x.scaleByPowerOfTen(2 * k).toBigInteger();
        // partir des seize chiffres que donnent les doubles, par excès : la suite décroît alors jusqu'à la racine entière
        int bits = Math.max(0, n.bitLength() - 100) / 2 * 2;
        BigInteger s = BigInteger.valueOf((long) Math.ceil(Math.sqrt(n.shiftRight(bits).doubleValue()) * (1 + 1e-14)) + 1)
                .shiftLeft(bits / 2);
        for (BigInteger t = moyenne(s, n); t.compareTo(s) < 0; t = moyenne(s, n)) {
            s = t;
        }
        return new BigDecimal(s).scaleByPowerOfTen(-k);
    }

    private static BigInteger moyenne(BigInteger s, BigInteger n) {
        return s.add(n.divide(s)).shiftRight(1);
    }
}
