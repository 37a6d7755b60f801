package lancer;

import java.math.BigDecimal;
import java.math.MathContext;

/**
 * L'intersection d'un rayon et d'une sphère calculée sur les nombres décimaux exacts que sont les doubles : sommes et produits sans
 * arrondi, racines et quotients à 60 chiffres. La direction est P2 − P, exacte, et non ce qu'un arrondi en garde.
 */
final class IntersectionExacte {

    private static final MathContext CHIFFRES = new MathContext(60);
    private static final BigDecimal U = exact(0x1p-53);

    /** La distance, arrondie au double le plus proche ; +∞ si le rayon ne rencontre rien. */
    final double t;

    /** Le conditionnement 1 + r/h, h étant la demi-corde ; 1 si le rayon ne rencontre rien. */
    final double conditionnement;

    /** Vrai si arrondir la direction suffit à changer la réponse : moins de 8 u au-delà, ou en deçà, de la tangente. */
    final boolean ambigu;

    private final BigDecimal exacte;

    IntersectionExacte(Point p, Point p2, Point c, double r) {
        BigDecimal[] d = difference(p2, p);
        BigDecimal[] f = difference(c, p);
        BigDecimal d2 = produit(d, d);
        BigDecimal fd = produit(f, d);
        BigDecimal puissance = produit(f, f).subtract(exact(r).multiply(exact(r)));
        // h² = discriminant / d2, b = fd / √d2
        BigDecimal discriminant = fd.multiply(fd).subtract(d2.multiply(puissance));
        BigDecimal norme = racine(d2);
        BigDecimal doute = exact(16 * r).multiply(U).multiply(fd.abs()).multiply(norme);
        ambigu = puissance.signum() > 0 && fd.signum() > 0 && discriminant.abs().compareTo(doute) <= 0;
        if (discriminant.signum() < 0 || fd.signum() <= 0 && puissance.signum() >= 0) {
            exacte = null;
            t = Constantes.INFINI;
            conditionnement = 1;
            return;
        }
        BigDecimal racine = racine(discriminant);
        // la racine qui soustrairait s'obtient par le produit des deux
        BigDecimal fois = puissance.signum() > 0 ? puissance.multiply(norme).divide(fd.add(racine), CHIFFRES)
                : fd.signum() > 0 ? fd.add(racine).divide(norme, CHIFFRES)
                : puissance.multiply(norme).divide(fd.subtract(racine), CHIFFRES);
        exacte = fois;
        t = fois.doubleValue();
        conditionnement = racine.signum() == 0 ? Double.POSITIVE_INFINITY : 1 + r / racine.divide(norme, CHIFFRES).doubleValue();
    }

    /** L'écart d'une réponse, en unités de 8 u · conditionnement · t ; +∞ si elle n'est pas du bon genre. */
    double ecart(double reponse) {
        if (exacte == null || reponse == Constantes.INFINI) {
            return exacte == null && reponse == Constantes.INFINI ? 0 : Constantes.INFINI;
        }
        if (!(reponse > 0)) {
            return Constantes.INFINI;
        }
        return exact(reponse).subtract(exacte).abs().divide(exacte, CHIFFRES).doubleValue() / (8 * 0x1p-53 * conditionnement);
    }

    /** La distance exacte d'un point à la surface d'une sphère. */
    static double ecartALaSurface(Point x, Point c, double r) {
        BigDecimal[] n = difference(x, c);
        return racine(produit(n, n)).subtract(exact(r)).abs().doubleValue();
    }

    /** La norme d'un vecteur, moins 1. */
    static double ecartALUnite(Vecteur v) {
        BigDecimal[] n = {exact(v.x), exact(v.y), exact(v.z)};
        return racine(produit(n, n)).subtract(BigDecimal.ONE).doubleValue();
    }

    private static BigDecimal exact(double x) {
        return new BigDecimal(x);
    }

    private static BigDecimal[] difference(Point a, Point b) {
        return new BigDecimal[] {exact(a.x).subtract(exact(b.x)), exact(a.y).subtract(exact(b.y)), exact(a.z).subtract(exact(b.z))};
    }

    private static BigDecimal produit(BigDecimal[] a, BigDecimal[] b) {
        return a[0].multiply(b[0]).add(a[1].multiply(b[1])).add(a[2].multiply(b[2]));
    }

    /** La racine carrée, par la méthode de Newton depuis celle de l'arrondi ({@code BigDecimal.sqrt} n'est venue qu'avec Java 9). */
    private static BigDecimal racine(BigDecimal x) {
        if (x.signum() == 0) {
            return x;
        }
        // ramené à une puissance de dix près entre 1 et 100, dont un double tient la racine
        int dizaines = (x.precision() - x.scale() - 1) & ~1;
        BigDecimal a = x.scaleByPowerOfTen(-dizaines);
        BigDecimal s = exact(Math.sqrt(a.doubleValue()));
        for (int k = 0; k < 2; k++) {
            s = s.add(a.divide(s, CHIFFRES)).divide(BigDecimal.valueOf(2), CHIFFRES);
        }
        return s.scaleByPowerOfTen(dizaines / 2);
    }
}
