package lancer.limites;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.RoundingMode;
import lancer.Couleur;
import lancer.Vecteur;
import lancer.essai.Rangee;
import org.junit.jupiter.api.Test;

/** Où les petites fonctions de tous les jours échouent : normaliser, arrondir, limiter, convertir. */
class LimitesNombresTest {

    private static final double U = 0x1p-53;

    /** {@code v / √(v·v)} : le carré d'une longueur de 1e-200 est 0, celui de 1e200 est infini. */
    private static Vecteur diviseParSaNorme(Vecteur v) {
        return v.div(Math.sqrt(v.norme2()));
    }

    /** La parade courante : un vecteur trop court est laissé tel quel. */
    private static Vecteur saufSIlEstCourt(Vecteur v) {
        return v.norme2() < 1e-12 ? v : diviseParSaNorme(v);
    }

    @Test
    void unVecteurCourtOuLongNeSeNormalisePasParSonCarre() {
        for (double longueur : new double[] {1e-300, 1e-200, 1e200, 1e300}) {
            Vecteur v = new Vecteur(0, 3 * longueur, -4 * longueur);
            Vecteur naif = diviseParSaNorme(v);
            assertFalse(Math.abs(naif.norme() - 1) < 0.1, longueur + " : " + naif);
            assertEquals(1, v.normalized().norme(), 4 * U, "longueur " + longueur);
            if (longueur == 1e-200) {
                Rangee.montre("unVecteurCourtOuLongNeSeNormalisePasParSonCarre", naif.norme(), v.normalized().norme(), 1);
            }
            assertEquals(0.6, v.normalized().y, 2 * U);
        }
    }

    @Test
    void unVecteurCourtLaisseTelQuelFausseToutCeQuiLeCroitUnitaire() {
        // la direction d'une lampe à un dix-millionième du contact : une scène d'insectes y tient tout entière
        Vecteur versLampe = new Vecteur(0, 0, -1e-7);
        double cosinus = new Vecteur(0, 0, -1).dot(saufSIlEstCourt(versLampe));
        assertEquals(1e-7, cosinus, 1e-20, "dix millions de fois trop sombre");
        assertEquals(1, new Vecteur(0, 0, -1).dot(versLampe.normalized()), 2 * U);
        Vecteur pas = new Vecteur(3e-9, 4e-9, 0);
        assertEquals(5e-9, saufSIlEstCourt(pas).norme(), 1e-20);
        assertEquals(1, pas.normalized().norme(), 4 * U);
    }

    /**
     * {@code floor(x + 1/2)} arrondit deux fois : la somme d'abord, qui peut atteindre l'entier du dessus. Aucun produit 255·c ne
     * tombe sur ce x-là : ici le piège est évité par chance ; autour de chaque moitié, la nôtre est l'arrondi exact du produit.
     */
    @Test
    void arrondirParLaPartieEntiereDeXPlusUnDemiArronditDeuxFois() {
        double x = 0.49999999999999994;
        assertTrue(x < 0.5);
        assertEquals(1, Math.floor(x + 0.5));
        assertEquals(0, Math.round(x));
        for (int niveau = 0; niveau < 255; niveau++) {
            double c = (niveau + 0.5) / 255;
            for (int k = 0; k < 20; k++) {
                c = Math.nextDown(c);
            }
            for (int k = 0; k < 40; k++, c = Math.nextUp(c)) {
                int attendu = new BigDecimal(c * 255).setScale(0, RoundingMode.HALF_UP).intValueExact();
                assertEquals(attendu, new Couleur(0, 0, c).getCode() & 0xFF, "composante " + c);
            }
        }
    }

    /** Convertie sans être limitée, une composante trop forte déborde dans sa voisine. */
    @Test
    void uneComposanteNonLimiteeDebordeDansLaVoisine() {
        int naif = 0xFF000000 | (int) (0.2 * 255 + 0.5) << 16 | (int) (1.5 * 255 + 0.5) << 8 | (int) (0.3 * 255 + 0.5);
        assertEquals(0xFF337F4D, naif, "vert : 127 au lieu de 255 ; le bit de trop tombe dans le rouge, qui l'avait déjà");
        int pairs = 0xFF000000 | (int) (0.4 * 255 + 0.5) << 16 | (int) (1.5 * 255 + 0.5) << 8;
        assertEquals(0xFF677F00, pairs, "rouge : 103 au lieu de 102");
        assertEquals(0xFF66FF00, new Couleur(0.4, 1.5, 0).getCode());
        Rangee.montre("uneComposanteNonLimiteeDebordeDansLaVoisine", pairs >> 16 & 0xFF, new Couleur(0.4, 1.5, 0).getCode() >> 16 & 0xFF,
                0.4 * 255);
        assertEquals(Integer.MAX_VALUE, (int) (Double.POSITIVE_INFINITY * 255 + 0.5));
        assertEquals(0xFFFF0000, new Couleur(Double.POSITIVE_INFINITY, 0, 0).getCode());
        assertEquals(0xFF00FF00, new Couleur(-0.1, 2, -1e300).getCode());
    }

    /** NaN ne se voit pas : il passe les limites, et devient 0 à la conversion, partie entière, plafond ou arrondi. */
    @Test
    void nanDevientZeroSansUnMot() {
        double nan = 0.0 / 0;
        assertTrue(Double.isNaN(Math.min(1, Math.max(0, nan))), "limité à [0, 1], il n'y est pas");
        assertEquals(0, (int) Math.ceil(nan), "le rang d'une case : la première");
        assertEquals(0, (int) Math.floor(nan));
        assertEquals(0, Math.round(nan));
        assertFalse(nan < 0, "un test de refus ne le refuse pas");
        assertTrue(!(nan >= 0), "écrit ainsi, il le refuse");
        // une image n'en a jamais ; la dernière conversion en a tout de même une réponse écrite
        assertEquals(0xFF000000, new Couleur(nan).getCode());
        assertThrows(ArithmeticException.class, () -> new Vecteur(nan, 0, 1).normalized());
    }

    /** Deux lampes égales vues dans l'ordre inverse : la somme de flottants dépend de l'ordre, donc les fils ne somment rien entre eux. */
    @Test
    void uneSommeDependDeSonOrdre() {
        double[] apports = {0.1, 0.2, 0.3};
        assertFalse(apports[0] + apports[1] + apports[2] == apports[2] + apports[1] + apports[0]);
        // ajouter pixel par pixel, dans l'ordre du fichier, ne dépend d'aucun partage : voir
        // DessinTest.leNombreDeFilsNeChangeNiUnBitNiUnCompte
        Couleur dansLOrdre = new Couleur(0.1).add(new Couleur(0.2)).add(new Couleur(0.3));
        assertEquals(0.1 + 0.2 + 0.3, dansLOrdre.r, 0);
    }
}
