package lancer.texte;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** L'écriture des nombres : la grammaire, toute la grammaire, rien que la grammaire. */
class NombreTest {

    private static final int ESSAIS = 60_000;

    /** La grammaire de la spécification, écrite autrement que dans {@link Nombre}. */
    private static final Pattern GRAMMAIRE = Pattern.compile("[+-]?([0-9]+(\\.[0-9]+)?|[0-9]+\\.|\\.[0-9]+)([eE][+-]?[0-9]+)?");

    private static void verifier(String texte, long graine) {
        double lu = Nombre.lire(texte);
        if (GRAMMAIRE.matcher(texte).matches()) {
            assertEquals(Double.doubleToRawLongBits(Double.parseDouble(texte)), Double.doubleToRawLongBits(lu),
                    "« " + texte + " », graine " + graine);
        } else {
            assertTrue(Double.isNaN(lu), "« " + texte + " » vaut " + lu + ", graine " + graine);
        }
    }

    @Test
    void arrondieUneBaseDonneEncoreSaPuissanceATroisChiffres() {
        Random hasard = new Random(31);
        for (int k = 0; k < 20_000; k++) {
            double base = 1 - Math.pow(10, -12 * hasard.nextDouble());
            double exposant = -Math.log(hasard.nextDouble()) / -Math.log(base);
            double puissance = Math.pow(base, exposant);
            assertEquals(puissance, Math.pow(Double.parseDouble(Nombre.arrondir(base)), exposant), 1e-3 * puissance,
                    base + " : " + Nombre.arrondir(base) + ", puissance " + exposant);
        }
        assertEquals("1.0000", Nombre.arrondir(1));
        assertEquals("0.9999987300", Nombre.arrondir(0.99999873));
        assertEquals("0.87000", Nombre.arrondir(0.87));
        assertEquals("1.5900e-45", Nombre.arrondir(1.59e-45));
        assertEquals("2.0000e-5", Nombre.arrondir(2e-5));
        assertEquals("0", Nombre.arrondir(0));
    }

    @Test
    void uneComposanteArrondieATroisDecimalesOuUnSeulChiffre() {
        assertEquals("0.445", Nombre.arrondirComposante(0.4449));
        assertEquals("1.120", Nombre.arrondirComposante(1.12));
        assertEquals("2e-45", Nombre.arrondirComposante(1.59e-45));
        assertEquals("3e-4", Nombre.arrondirComposante(3e-4));
        assertEquals("0", Nombre.arrondirComposante(0));
    }

    @Test
    void unNombreValideEstLuAuBitPresCommeParJava() {
        long graine = 20_260;
        Random hasard = new Random(graine);
        for (int k = 0; k < ESSAIS; k++) {
            String texte = valide(hasard);
            assertTrue(GRAMMAIRE.matcher(texte).matches(), texte);
            verifier(texte, graine);
        }
    }

    private static String valide(Random hasard) {
        String[] signes = {"", "", "+", "-"};
        StringBuilder s = new StringBuilder(signes[hasard.nextInt(4)]);
        int forme = hasard.nextInt(4);
        if (forme != 3) {
            chiffres(s, hasard);
        }
        if (forme != 0) {
            s.append('.');
        }
        if (forme >= 2) {
            chiffres(s, hasard);
        }
        if (hasard.nextInt(3) == 0) {
            s.append(hasard.nextBoolean() ? 'e' : 'E').append(signes[hasard.nextInt(4)]);
            s.append(hasard.nextInt(hasard.nextBoolean() ? 30 : 350));
        }
        return s.toString();
    }

    private static void chiffres(StringBuilder s, Random hasard) {
        int n = 1 + hasard.nextInt(hasard.nextInt(20) == 0 ? 40 : 9);
        boolean zeros = hasard.nextInt(10) == 0;
        for (int k = 0; k < n; k++) {
            s.append((char) ('0' + (zeros ? 0 : hasard.nextInt(10))));
        }
    }

    /** Tous les textes de cinq caractères au plus, sur ceux qui comptent. */
    @Test
    void lesTextesCourtsSontTousBienJuges() {
        char[] alphabet = {'0', '7', '.', 'e', 'E', '+', '-', ' ', 'd'};
        for (int n = 0; n <= 5; n++) {
            char[] texte = new char[n];
            for (int k = 0; k < Math.pow(alphabet.length, n); k++) {
                for (int i = 0, reste = k; i < n; i++, reste /= alphabet.length) {
                    texte[i] = alphabet[reste % alphabet.length];
                }
                verifier(new String(texte), 0);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "-0", ".5", "5.", "+1", "1E+2", "1e-2", "-.5e-3", "007", "4.9e-324", "2.4703282292062327e-324",
        "2.4703282292062328e-324", "1e-400", "-1e-400", "1.7976931348623157e308", "1.7976931348623158e308", "1.7976931348623159e308",
        "1e400", "-1e400", "0e999999999999", "1e999999999999", "1e-999999999999", "9007199254740993", "999999999999999",
        "9999999999999999", "0.000000000000001", "0.0000000000000001", "123456789012345.", ".123456789012345", "1e22", "1e23",
        "8.5e-309", "2.2250738585072012e-308"})
    void lesBordsSontLusCommeParJava(String texte) {
        assertTrue(GRAMMAIRE.matcher(texte).matches(), texte);
        verifier(texte, 0);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", " ", ".", "+", "-", "e5", ".e5", "1e", "1e+", "+-1", "1 ", " 1", "1d", "1f", "1D", "0x1", "0x1p3",
        "NaN", "Infinity", "+Infinity", "-NaN", "1,5", "1_0", "1..2", "1.2.", "1e1.5", "1e1e1", "\u0661", "\uff11", "\u22121", "∞", "1L",
        "0b1"})
    void ceQueJavaAccepteraitEnTropEstRefuse(String texte) {
        assertTrue(Double.isNaN(Nombre.lire(texte)), texte);
    }

    @Test
    void unNombreSEcritCommeALaMain() {
        assertEquals("0", Nombre.ecrire(0));
        assertEquals("0.05", Nombre.ecrire(0.05));
        assertEquals("0.0009765625", Nombre.ecrire(1.0 / 1024));
        assertEquals("-0.0002", Nombre.ecrire(-2e-4));
        assertEquals("2e-6", Nombre.ecrire(2e-6));
        assertEquals("64", Nombre.ecrire(64));
        assertEquals("-1e100", Nombre.ecrire(-1e100));
        assertEquals("1e-100", Nombre.ecrire(1e-100));
        assertEquals("1e9", Nombre.ecrire(1e9));
        assertEquals("1e7", Nombre.ecrire(1e7));
        assertEquals("9999999", Nombre.ecrire(9_999_999));
    }
}
