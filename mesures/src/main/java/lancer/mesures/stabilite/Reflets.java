package lancer.mesures.stabilite;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Perte de précision d'un rayon réfléchi plusieurs fois entre de petites sphères. Chaque reflet multiplie l'erreur par deux fois la
 * distance des sphères divisée par leur rayon, quelle que soit la méthode. Chaque arithmétique fait le même calcul, et arrondit chaque
 * opération à sa façon.
 */
final class Reflets {

    static final String FIGURE = "reflets";

    /** Nombre maximal de reflets. */
    static final int MAX = 25;

    /** Bornes des distances entre deux sphères de rayon 1 : celles d'une foule. */
    private static final double PRES = 5;
    private static final double LOIN = 40;

    /** Arrondi des rayons de référence. */
    private static final UnaryOperator<BigDecimal> PRECIS = x -> x.round(Decimaux.PRECIS);

    private final Random hasard;

    /** Centres des sphères, dans l'ordre où toutes les arithmétiques les rencontrent. */
    private final List<BigDecimal[]> centres = new ArrayList<>();

    private Reflets(long graine) {
        hasard = new Random(graine);
    }

    /** L'arrondi de chaque arithmétique, par nom. */
    private static Map<String, UnaryOperator<BigDecimal>> facons() {
        Map<String, UnaryOperator<BigDecimal>> facons = new LinkedHashMap<>();
        facons.put("float", x -> new BigDecimal(x.floatValue()));
        facons.put("double", x -> new BigDecimal(x.doubleValue()));
        facons.put("compensee", x -> new BigDecimal(x.doubleValue()));
        facons.put("deux_doubles", x -> {
            BigDecimal haut = new BigDecimal(x.doubleValue());
            return haut.add(new BigDecimal(x.subtract(haut).doubleValue()));
        });
        return facons;
    }

    /** Erreur médiane du contact sur tant de chaînes, par arithmétique et par nombre de reflets, en rayons de la sphère. */
    static List<Exactitude> mesurer(int chaines) {
        Map<String, double[][]> erreurs = new LinkedHashMap<>();
        facons().keySet().forEach(nom -> erreurs.put(nom, new double[MAX][chaines]));
        IntStream.range(0, chaines).parallel().forEach(c -> new Reflets(c).suivre(erreurs, c));
        List<Exactitude> exactitudes = new ArrayList<>();
        erreurs.forEach((nom, parReflet) -> {
            for (int k = 0; k < MAX; k++) {
                double[] triees = Arrays.stream(parReflet[k]).sorted().toArray();
                int perdues = (int) Arrays.stream(triees).filter(e -> e >= 1).count();
                exactitudes.add(new Exactitude(FIGURE, nom, k + 1, chaines, perdues, triees[chaines / 2], 0));
            }
        });
        return exactitudes;
    }

    /** Suit une chaîne : chaque sphère est placée devant le rayon de référence, puis chaque arithmétique suit les mêmes sphères. */
    private void suivre(Map<String, double[][]> erreurs, int c) {
        BigDecimal[] depart = tirer();
        BigDecimal[] direction = unite(tirer(), PRECIS);
        BigDecimal[][] rayon = {depart, direction};
        List<BigDecimal[]> justes = new ArrayList<>();
        for (int k = 0; k <= MAX; k++) {
            BigDecimal distance = new BigDecimal(PRES * Math.pow(LOIN / PRES, hasard.nextDouble()));
            BigDecimal[] centre = tirer();
            for (int i = 0; i < 3; i++) {
                centre[i] = new BigDecimal(rayon[0][i].add(rayon[1][i].multiply(distance)).add(centre[i]).doubleValue());
            }
            centres.add(centre);
            rayon = reflechir(rayon, centre, PRECIS);
            justes.add(rayon[0]);
        }
        for (Map.Entry<String, UnaryOperator<BigDecimal>> facon : facons().entrySet()) {
            UnaryOperator<BigDecimal> arrondi = facon.getValue();
            boolean attend = facon.getKey().equals("compensee");
            UnaryOperator<BigDecimal> sien = attend ? PRECIS : arrondi;
            BigDecimal[][] suivi = {arrondir(depart, arrondi), arrondir(direction, arrondi)};
            for (int k = 0; k <= MAX; k++) {
                suivi = suivi == null ? null : reflechir(suivi, centres.get(k), sien);
                if (suivi != null && attend) {
                    suivi = new BigDecimal[][] {arrondir(suivi[0], arrondi), arrondir(suivi[1], arrondi)};
                }
                if (k > 0) {
                    // le premier contact n'est pas un reflet ; une sphère manquée compte pour une erreur de 1
                    erreurs.get(facon.getKey())[k - 1][c] = suivi == null ? 1 : Math.min(1, distance(suivi[0], justes.get(k)));
                }
            }
        }
    }

    private static BigDecimal[] arrondir(BigDecimal[] v, UnaryOperator<BigDecimal> arrondi) {
        return Arrays.stream(v).map(arrondi).toArray(BigDecimal[]::new);
    }

    /** Coordonnées entre −1/2 et 1/2 : un rayon qui vise ce point près du centre d'une sphère de rayon 1 la touche. */
    private BigDecimal[] tirer() {
        return Stream.generate(() -> new BigDecimal(hasard.nextDouble() - 0.5)).limit(3).toArray(BigDecimal[]::new);
    }

    /** Le contact d'un rayon et d'une sphère de rayon 1, et la direction réfléchie ; {@code null} sans contact. */
    private static BigDecimal[][] reflechir(BigDecimal[][] rayon, BigDecimal[] centre, UnaryOperator<BigDecimal> a) {
        BigDecimal[] v = rayon[1];
        BigDecimal[] f = Decimaux.difference(centre, rayon[0], a);
        BigDecimal b = Decimaux.scalaire(f, v, a);
        BigDecimal[] l = Decimaux.ajouter(f, v, b.negate(), a);
        BigDecimal h2 = a.apply(BigDecimal.ONE.subtract(Decimaux.scalaire(l, l, a)));
        if (h2.signum() < 0) {
            return null;
        }
        BigDecimal[] p = Decimaux.ajouter(rayon[0], v, a.apply(b.subtract(a.apply(Decimaux.racine(h2)))), a);
        BigDecimal[] n = unite(Decimaux.difference(p, centre, a), a);
        BigDecimal retour = a.apply(new BigDecimal(-2).multiply(Decimaux.scalaire(v, n, a)));
        return new BigDecimal[][] {p, unite(Decimaux.ajouter(v, n, retour, a), a)};
    }

    private static BigDecimal[] unite(BigDecimal[] v, UnaryOperator<BigDecimal> a) {
        BigDecimal norme = a.apply(Decimaux.racine(Decimaux.scalaire(v, v, a)));
        return Arrays.stream(v).map(x -> a.apply(x.divide(norme, Decimaux.PRECIS))).toArray(BigDecimal[]::new);
    }

    private static double distance(BigDecimal[] u, BigDecimal[] v) {
        BigDecimal[] d = Decimaux.difference(u, v, PRECIS);
        return Decimaux.racine(Decimaux.scalaire(d, d, PRECIS)).doubleValue();
    }
}
