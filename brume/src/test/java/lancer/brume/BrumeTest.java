package lancer.brume;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import lancer.Constantes;
import lancer.Couleur;
import lancer.essai.Essai;
import lancer.essai.EssaiVariante;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BrumeTest extends EssaiVariante {

    private static final double PRECISION = 1e-6;

    @Tag("reference")
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "p1-quatre.ini | p1-quatre.brume.pfm        | [Brume];couleur=0.8 0.8 0.8;debut=0;fin=30",
        "p1-quatre.ini | p1-quatre.brume.pfm        | [Brume]",
        "p1-quatre.ini | p1-quatre.brume.pfm        | ''",
        "p2-sol.ini    | p2-sol.brume-densite.pfm   | [Brume];couleur=0.7 0.75 0.8;debut=2;densite=0.08"})
    void lesImagesDeReferenceSontRetrouvees(String ini, String pfm, String section) throws IOException {
        verifierReference(pfm, ini, section.split(";"));
    }

    /**
     * Deux miroirs face à face, contacts sur l'axe à ±4, lampe en (0, 3, 0) : N·L = R·L = 4/5, la couleur locale c est la même
     * à chaque contact. Le premier rayon a 4 unités, chaque rayon réfléchi 8 : une brume oubliée sur les reflets, ou une
     * distance cumulée, donnent un autre nombre.
     */
    @ParameterizedTest
    @CsvSource({"0, fin=20", "1, fin=20", "5, fin=20", "20, fin=20", "0, densite=0.1", "1, densite=0.1", "5, densite=0.1",
            "20, densite=0.1"})
    void laBrumeEntreDeuxMiroirsAUneFormeClose(int n, String loi) throws IOException {
        float[] image = Essai.dessiner(dossier, scene("[Sphere 1]", "centre=0 0 7", "rayon=3", "Kd=0.5 0.5 0.5", "Ks=0.5 0.5 0.5", "ns=2",
                "[Sphere 2]", "centre=0 0 -7", "rayon=3", "Kd=0.5 0.5 0.5", "Ks=0.5 0.5 0.5", "ns=2",
                "[Lampe 1]", "position=0 3 0", "couleur=1 1 1", "[Brume]", "couleur=0.9 0.6 0.3", loi),
                "--taille", "1x1", "--reflets", String.valueOf(n), "--seuil", "0");
        double k4 = loi.startsWith("fin") ? 0.2 : 1 - Math.exp(-0.4);
        double k8 = loi.startsWith("fin") ? 0.4 : 1 - Math.exp(-0.8);
        double c = 0.5 * 0.8 + 0.5 * 0.64;
        double[] brume = {0.9, 0.6, 0.3};
        for (int composante = 0; composante < 3; composante++) {
            double F = brume[composante];
            double v = 0;
            for (int p = 0; p < n; p++) {
                v = k8 * F + (1 - k8) * (c + (p == 0 ? 0 : 0.5 * v));
            }
            double attendu = k4 * F + (1 - k4) * (c + 0.5 * v);
            assertEquals(attendu, image[composante], PRECISION);
        }
    }

    @Test
    void uneBrumeSansDensiteNeChangePasLesObjets() throws IOException {
        String boule = "[Sphere 1]\ncentre=0 0 6\nrayon=1\nKd=0.5 0.25 0.125\n[Lampe 1]\nposition=0 0 -10\ncouleur=1 1 1";
        assertArrayEquals(new float[] {0.5f, 0.25f, 0.125f},
                Essai.dessiner(dossier, scene(boule, "[Brume]", "densite=0"), "--taille", "1x1"), 1e-7f);
        assertArrayEquals(new float[] {0.8f, 0.8f, 0.8f},
                Essai.dessiner(dossier, scene(boule, "[Brume]", "debut=1", "fin=5"), "--taille", "1x1"), 1e-7f, "d = fin : brume seule");
        assertArrayEquals(new float[] {0.5f, 0.25f, 0.125f},
                Essai.dessiner(dossier, scene(boule, "[Brume]", "debut=5"), "--taille", "1x1"), 1e-7f, "d = debut : pas de brume");
    }

    @Test
    void kResteEntreZeroEtUnEtNEstJamaisNaN() {
        double[] valeurs = {0, Double.MIN_VALUE, 1e-300, 1e-9, 0.1, 1, 30, 1e9, 1e100, 1e300, Double.MAX_VALUE};
        for (double debut : valeurs) {
            for (double parametre : valeurs) {
                List<Brume> brumes = new ArrayList<>();
                brumes.add(new Brume(new Couleur(1e6), debut, Double.NaN, parametre));
                if (parametre > debut) {
                    brumes.add(new Brume(new Couleur(1e6), debut, parametre, 0));
                }
                for (Brume brume : brumes) {
                    double precedent = 0;
                    for (double d : valeurs) {
                        double k = brume.k(d);
                        String loi = brume == brumes.get(0) ? "densite " : "fin ";
                        assertTrue(k >= precedent && k <= 1, () -> loi + debut + " " + parametre + " en " + d + " : " + k);
                        precedent = k;
                    }
                    Couleur vue = brume.traverser(new Couleur(0.5), Constantes.INFINI);
                    assertEquals(new Couleur(1e6), vue);
                }
            }
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "debut=30             | 2 | debut   | la brume commencerait à « 30 » et finirait à « 30 » ; attendu : debut plus petit "
                + "que fin (à défaut, 0 et 30)",
        "fin=0                | 2 | fin     | la brume commencerait à « 0 » et finirait à « 0 » ; attendu : debut plus petit "
                + "que fin (à défaut, 0 et 30)",
        "fin=4~debut=5        | 3 | debut   | la brume commencerait à « 5 » et finirait à « 4 » ; attendu : debut plus petit "
                + "que fin (à défaut, 0 et 30)",
        "fin=20~densite=1     | 3 | densite | donnée en même temps que fin ; attendu : fin ou densite, pas les deux",
        "densite=-0.1         | 2 | densite | hors limites : « -0.1 » ; attendu : un nombre d'au moins 0",
        "densite=1e999        | 2 | densite | nombre trop grand : « 1e999 » ; attendu : un nombre d'au moins 0",
        "densite=NaN          | 2 | densite | n'est pas un nombre : « NaN » ; attendu : un nombre d'au moins 0",
        "debut=-1             | 2 | debut   | hors limites : « -1 » ; attendu : un nombre d'au moins 0",
        "fin=-1               | 2 | fin     | hors limites : « -1 » ; attendu : un nombre d'au moins 0",
        "couleur=1 1          | 2 | couleur | 2 nombres au lieu de 3 : « 1 1 » ; attendu : 3 nombres séparés par des blancs, "
                + "chacun de 0 à 1000000",
        "couleur=1 1 2e6      | 2 | couleur | hors limites : « 2e6 » ; attendu : 3 nombres séparés par des blancs, chacun de 0 à 1000000",
        "densité=1            | 2 | densité | clé inconnue ; attendu : couleur, debut, densite, fin",
        "densite=1~epaisseur=2| 3 | epaisseur | clé inconnue ; attendu : couleur, debut, densite, fin"})
    void uneValeurImpossibleEstRefuseeEnUneLigne(String lignes, int ligne, String cle, String faute) throws IOException {
        verifierRefus("ligne " + ligne + ", [Brume], " + cle + " : " + faute, "[Brume]", lignes.replace('~', '\n'));
    }

    @Test
    void deuxBrumesSontRefusees() throws IOException {
        verifierRefus("ligne 2, [Brume 2] : section déjà donnée, ligne 1 ; attendu : une seule section Brume", "[Brume]", "[Brume 2]");
    }

    @Test
    void ceQuiSeRegleALaSourisEstAccepteParLaSection() {
        verifierParametres(new Brume(), "couleur", "debut", "fin", "densite");
    }
}
