package lancer.mesures.stabilite;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;

/** Vecteurs de nombres décimaux. Chaque opération est suivie de l'arrondi {@code a}. Racines et quotients ont 140 chiffres. */
final class Decimaux {

    static final MathContext PRECIS = new MathContext(140);

    /** Aucun arrondi : sommes et produits sont exacts. */
    static final UnaryOperator<BigDecimal> EXACT = x -> x;

    private static final BigDecimal DEMI = new BigDecimal("0.5");

    /** Nombre de pas de Newton qui mènent de seize chiffres justes à 140. */
    private static final int PAS_DE_NEWTON = 4;

    private Decimaux() {
    }

    /** u + k v. */
    static BigDecimal[] ajouter(BigDecimal[] u, BigDecimal[] v, BigDecimal k, UnaryOperator<BigDecimal> a) {
        return IntStream.range(0, 3).mapToObj(i -> a.apply(u[i].add(a.apply(v[i].multiply(k))))).toArray(BigDecimal[]::new);
    }

    static BigDecimal[] difference(BigDecimal[] u, BigDecimal[] v, UnaryOperator<BigDecimal> a) {
        return ajouter(u, v, BigDecimal.ONE.negate(), a);
    }

    static BigDecimal scalaire(BigDecimal[] u, BigDecimal[] v, UnaryOperator<BigDecimal> a) {
        return a.apply(a.apply(a.apply(u[0].multiply(v[0])).add(a.apply(u[1].multiply(v[1])))).add(a.apply(u[2].multiply(v[2]))));
    }

    static BigDecimal racine(BigDecimal x) {
        if (x.signum() == 0) {
            return x;
        }
        // l'exposant, pair, est mis à part : le reste est un double ordinaire
        int e = (x.precision() - x.scale()) / 2;
        BigDecimal reste = x.scaleByPowerOfTen(-2 * e);
        BigDecimal s = new BigDecimal(Math.sqrt(reste.doubleValue()));
        for (int k = 0; k < PAS_DE_NEWTON; k++) {
            s = s.add(reste.divide(s, PRECIS)).multiply(DEMI, PRECIS);
        }
        return s.scaleByPowerOfTen(e);
    }
}
