package lancer.blinn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import lancer.Vecteur;
import org.junit.jupiter.api.Test;

/** Où la formule de Blinn, recopiée telle quelle, échoue. */
class LimitesBlinnTest {

    /** {@code max(0, N·H)^ns}, H = (L − V)/‖L − V‖. */
    private static double naif(Vecteur V, Vecteur N, Vecteur L, double ns) {
        Vecteur somme = L.sub(V);
        Vecteur H = somme.div(Math.sqrt(somme.dot(somme)));
        return Math.pow(Math.max(0, N.dot(H)), ns);
    }

    /** Vue du dedans d'une sphère, une lampe peut être droit derrière la paroi : L = V, et la bissectrice est 0/0. */
    @Test
    void uneLampeDroitDerriereLaParoiNAPasDeBissectrice() {
        Vecteur V = new Vecteur(0, 0, 1);
        Vecteur N = new Vecteur(0, 0, 1);
        assertTrue(Double.isNaN(naif(V, N, V, 10)), "NaN dans l'image");
        assertEquals(1, naif(V, N, V, 0), "et NaN^0 = 1 : un reflet entier, qui ne vient de nulle part");
        // les nôtres valent 0 : BlinnTest.sansBissectriceIlNYAPasDeReflet ; à un arrondi de là, la réponse est encore un nombre
        Vecteur presque = new Vecteur(1e-200, 0, 1);
        double eclat = new Blinn(1).eclat(V, new Vecteur(1, 0, 0), presque, V, 10);
        assertEquals(1, eclat, 1e-12, "H = (1, 0, 0)");
        assertTrue(Double.isNaN(naif(V, new Vecteur(1, 0, 0), presque, 10)), "dont le carré est nul");
    }
}
