package lancer.blinn;

import static lancer.essai.Tirages.direction;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.Random;
import lancer.Camera;
import lancer.Vecteur;
import lancer.essai.Essai;
import lancer.essai.EssaiVariante;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BlinnTest extends EssaiVariante {

    private static final double PRECISION = 1e-6;

    @Tag("reference")
    @ParameterizedTest
    @CsvSource({"p1-quatre.ini, p1-quatre.blinn.pfm, [Blinn], facteur=1", "p1-quatre.ini, p1-quatre.blinn.pfm, [Blinn], ''",
        "p1-quatre.ini, p1-quatre.blinn.pfm, '', ''", "p2-sol.ini, p2-sol.blinn-2.pfm, [Blinn], facteur=2"})
    void lesImagesDeReferenceSontRetrouvees(String ini, String pfm, String section, String facteur) throws IOException {
        verifierReference(pfm, ini, section, facteur);
    }

    @Test
    void lEclatEstLaPuissanceDeLaBaseEtDeLExposantQuIlDit() {
        Blinn blinn = new Blinn(3);
        Vecteur V = new Vecteur(0, 0, 1);
        Vecteur N = new Vecteur(0, 0, -1);
        Vecteur L = new Vecteur(0, 0.6, -0.8);
        double base = L.add(N).normalized().dot(N);
        assertEquals("(N·H " + base + ")^60", blinn.dire(V, N, L, N, 20, Double::toString));
        assertEquals(Math.pow(base, 60), blinn.eclat(V, N, L, N, 20), 1e-12);
    }

    /**
     * La lampe dans l'œil : V = −L, donc H = L et N·H = N·L = c = √(1 − (D/r)²·sin²ψ), ψ étant l'angle du rayon et de l'axe et
     * D la distance de l'œil au centre. La couleur est Kd·c + Ks·c^(facteur·ns) sur toute la sphère.
     */
    @ParameterizedTest
    @CsvSource({"1, 0", "1, 1", "1, 10", "2, 35", "4, 12.5", "0.5, 1000"})
    void laLampeDansLOeilAUneFormeClose(double facteur, double ns) throws IOException {
        int cote = 61;
        double r = 1.2;
        float[] image = Essai.dessiner(dossier, scene("[Sphere 1]", "centre=0 0 6", "rayon=" + r, "Kd=0.25 0.5 0", "Ks=0.5 0.25 1",
                "ns=" + ns, "[Lampe 1]", "position=0 0 " + -Camera.FOCALE, "couleur=1 1 1", "[Blinn]", "facteur=" + facteur),
                "--taille", cote + "x" + cote, "--reflets", "0");
        Camera camera = new Camera(cote, cote);
        int vus = 0;
        for (int k = 0; k < cote * cote; k++) {
            Vecteur V = camera.getRayon(k % cote + 0.5, k / cote + 0.5).getV();
            double D = 6 + Camera.FOCALE;
            double c2 = 1 - D * D / (r * r) * (V.x * V.x + V.y * V.y);
            if (c2 > 0) {
                double c = Math.sqrt(c2);
                double eclat = Math.pow(c, facteur * ns);
                double[] attendu = {0.25 * c + 0.5 * eclat, 0.5 * c + 0.25 * eclat, eclat};
                for (int composante = 0; composante < 3; composante++) {
                    assertEquals(attendu[composante], image[3 * k + composante], PRECISION, "pixel " + k);
                }
                vus++;
            }
        }
        assertTrue(vus > 500, "la sphère doit occuper l'image : " + vus);
    }

    @Test
    void sansBissectriceIlNYAPasDeReflet() {
        Vecteur V = new Vecteur(0, 0, 1);
        assertEquals(0, new Blinn(1).eclat(V, new Vecteur(0, 0, 1), V, V, 10));
        assertEquals(0, new Blinn(1).eclat(V, new Vecteur(0, 0, 1), V, V, 0));
    }

    @Test
    void derriereLaSurfaceRienNeBrilleSaufExposantNul() {
        Vecteur V = new Vecteur(0, 0, 1);
        Vecteur L = new Vecteur(1, 0, 0);
        Vecteur N = new Vecteur(0, 0, 1);
        assertEquals(0, new Blinn(1).eclat(V, N, L, V, 10), "N·H < 0");
        assertEquals(1, new Blinn(1).eclat(V, N, L, V, 0), "x^0 = 1");
    }

    /** Un cosinus qu'un arrondi met au-dessus de 1 ne compte que pour 1, si grand que soit l'exposant. */
    @Test
    void leRefletNeDepasseJamaisUn() {
        Random hasard = new Random(28);
        for (int essai = 0; essai < 20_000; essai++) {
            Vecteur L = direction(hasard);
            Vecteur N = direction(hasard);
            for (double facteur : new double[] {1e-300, 1, 1e8, Double.MAX_VALUE}) {
                double deFace = new Blinn(facteur).eclat(L.neg(), L, L, L, 1e9);
                double ailleurs = new Blinn(facteur).eclat(direction(hasard), N, L, L, 1e9);
                assertTrue(deFace >= 0 && deFace <= 1 && ailleurs >= 0 && ailleurs <= 1, () -> deFace + " et " + ailleurs);
            }
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "facteur=0    | facteur | hors limites : « 0 » ; attendu : un nombre plus grand que 0",
        "facteur=-1   | facteur | hors limites : « -1 » ; attendu : un nombre plus grand que 0",
        "facteur=1e999| facteur | nombre trop grand : « 1e999 » ; attendu : un nombre plus grand que 0",
        "facteur=deux | facteur | n'est pas un nombre : « deux » ; attendu : un nombre plus grand que 0",
        "facteur=1 2  | facteur | 2 nombres au lieu de 1 : « 1 2 » ; attendu : un nombre plus grand que 0",
        "ns=10        | ns | clé inconnue ; attendu : facteur"})
    void uneValeurImpossibleEstRefuseeEnUneLigne(String ligne, String cle, String faute) throws IOException {
        verifierRefus("ligne 2, [Blinn], " + cle + " : " + faute, "[Blinn]", ligne);
    }

    @Test
    void ceQuiSeRegleALaSourisEstAccepteParLaSection() {
        verifierParametres(new Blinn(), "facteur");
    }
}
