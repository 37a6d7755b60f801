package lancer.promesses;

import static lancer.essai.Ressources.boule;
import static lancer.essai.Ressources.image;
import static lancer.essai.Ressources.scene;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.locks.LockSupport;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.contrat.Toile;
import lancer.essai.Essai;
import lancer.essai.Ressources;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Ce qui ne doit changer l'image d'aucun bit, et ce qu'en font le brouillon et l'arrêt. */
class DessinTest {

    @Test
    void uneSceneSymetriqueDonneUneImageSymetriqueAuBit() {
        List<Sphere> boules = new ArrayList<>();
        boules.add(boule(0, 0.3, 6, 1, 0.5, 0.4, 20));
        for (int cote = -1; cote <= 1; cote += 2) {
            boules.add(boule(cote * 1.3, -0.2, 5, 0.6, 0.6, 0.3, 40));
            boules.add(boule(cote * 0.8, 0.9, 4, 0.3, 0.2, 0.7, 90));
        }
        Ressources.Image image = image(scene(boules, new Lampe(new Point(0, 5, -2), new Couleur(0.8))), 101, 77, 5, 2);
        for (int j = 0; j < 77; j++) {
            for (int i = 0; i < 101; i++) {
                assertEquals(image.composantes[3 * (j * 101 + i)], image.composantes[3 * (j * 101 + 100 - i)], 0f);
            }
        }
    }

    /** Ni les répétitions ; le chemin lisible a les mêmes bits, et ses comptes à lui. */
    @ParameterizedTest
    @ValueSource(strings = {"p3-miroirs", "p4-foule"})
    void leNombreDeFilsNeChangeNiUnBitNiUnCompte(String nom, @TempDir Path dossier) throws IOException {
        Path pfm = dossier.resolve("image.pfm");
        byte[] attendue = null;
        for (String chemin : new String[] {"--seuil=" + Constantes.SEUIL, "--simple"}) {
            String attendus = null;
            for (String option : new String[] {"--fils=1", "--fils=3", "--fils=1024", "--repeter=3"}) {
                Essai e = Essai.executer(chemin, option, "--taille=100x75", "--reflets=5", "--statistiques", "--lineaire=" + pfm,
                        Ressources.chemin("reference/" + nom + ".ini"));
                assertEquals("", e.erreur);
                String comptes = e.sortie.substring(0, e.sortie.indexOf("lecture.ms"));
                attendus = attendus == null ? comptes : attendus;
                assertEquals(attendus, comptes, chemin + " " + option);
                assertEquals(100 * 75, e.statistique("rayons.primaires"));
                assertTrue(e.statistique("rayons.ombre") > 0 && e.statistique("rayons.reflechis") > 0, comptes);
                assertEquals(0, e.statistique("pixels.raffines"));
                byte[] image = Files.readAllBytes(pfm);
                attendue = attendue == null ? image : attendue;
                assertArrayEquals(attendue, image, chemin + " " + option);
            }
        }
    }

    @Test
    void leBrouillonPrendLeCentreDeChaqueCarreEtUneReflexionAuPlus() {
        Scene scene = new Scene(Ressources.chemin("reference/p1-quatre.ini"));
        int largeur = 30;
        int hauteur = 22;
        Camera camera = new Camera(largeur, hauteur);
        Ressources.Image brouillon = new Ressources.Image(largeur, hauteur);
        Lancer temoin = new Lancer(scene, camera);
        Ressources.Image image = new Ressources.Image(largeur, hauteur);
        boolean[] fini = new boolean[1];
        temoin.TracerImage(new Toile() {
            @Override
            public void drawPixel(Couleur coul, int xe, int ye) {
                (fini[0] ? image : brouillon).drawPixel(coul, xe, ye);
            }

            @Override
            public boolean montreUnBrouillon() {
                return true;
            }

            @Override
            public void finirBrouillon() {
                fini[0] = true;
            }
        }, 5, 2);
        Ressources.Image attendueEntiere = new Ressources.Image(largeur, hauteur);
        new Lancer(scene, camera).TracerImage(attendueEntiere, 5, 1);
        assertArrayEquals(attendueEntiere.composantes, image.composantes, "l'image vient après, avec toutes ses réflexions");
        for (int j = 0; j < hauteur; j++) {
            for (int i = 0; i < largeur; i++) {
                double xe = (i / 4 * 4 + Math.min(i / 4 * 4 + 4, largeur)) / 2.0;
                double ye = (j / 4 * 4 + Math.min(j / 4 * 4 + 4, hauteur)) / 2.0;
                Couleur attendue = temoin.getCouleurPixel(xe, ye, 1);
                assertEquals((float) attendue.r, brouillon.composantes[3 * (j * largeur + i)], "pixel " + i + ", " + j);
            }
        }
    }

    @Test
    void leBrouillonLanceUnRayonParCarreDeQuatrePixelsMemeCoupeParLeBord() {
        Scene ciel = new Scene(List.of(), List.of());
        for (int[] taille : new int[][] {{64, 32}, {32, 64}, {1, 1}, {33, 70}, {6, 3}}) {
            Lancer lancer = new Lancer(ciel, new Camera(taille[0], taille[1]));
            int[] peints = new int[1];
            lancer.TracerBrouillon((couleur, i, j) -> peints[0]++, 1, 1);
            assertEquals((taille[0] + 3) / 4 * ((taille[1] + 3) / 4), lancer.getAtelier().getCompteurs().primaires, taille[0] + " × "
                    + taille[1]);
            assertEquals(taille[0] * taille[1], peints[0]);
        }
    }

    @Test
    void unDessinArreteNeFinitPas() {
        Scene scene = new Scene(Ressources.chemin("reference/p1-quatre.ini"));
        Lancer lancer = new Lancer(scene, new Camera(64, 64));
        Thread appelant = Thread.currentThread();
        int[] pixels = new int[1];
        assertThrows(CancellationException.class, () -> lancer.TracerImage((coul, xe, ye) -> {
            pixels[0]++;
            appelant.interrupt();
            // ce fil est interrompu quand son équipe est arrêtée
            while (!Thread.currentThread().isInterrupted()) {
                LockSupport.parkNanos(1_000_000);
            }
        }, 5, 1));
        assertTrue(Thread.interrupted(), "l'interruption reste à voir");
        assertEquals(1, pixels[0], "l'arrêt agit au pixel suivant");
    }

    @Test
    void lesTaillesExtremesNOntQueDesNombresFinis() {
        for (int[] taille : new int[][] {{1, 1}, {1, 500}, {500, 1}, {33, 65}}) {
            assertTrue(image(new Scene(Ressources.chemin("reference/p1-quatre.ini")), taille[0], taille[1], 5, 2).estFinie());
        }
    }
}
