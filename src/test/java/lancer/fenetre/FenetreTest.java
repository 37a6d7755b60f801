package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.chercher;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static lancer.fenetre.BancFenetre.texte;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.swing.AbstractButton;
import javax.swing.JLabel;
import javax.swing.JProgressBar;
import lancer.Camera;
import lancer.Constantes;
import lancer.Lancer;
import lancer.Scene;
import lancer.fenetre.BancFenetre.MainLent;
import lancer.sortie.ImageMemoire;
import org.junit.jupiter.api.Test;

/** La fenêtre, sur un vrai écran : ce qu'on y voit, et ce qu'elle fait des touches, de la souris et de sa taille. */
class FenetreTest extends EssaiFenetre {

    @Test
    void leBrouillonParaitPuisLImageSAcheve() throws Exception {
        Lancer lancer = new Lancer(new Scene(scene.toString()), new Camera(L, H));
        ImageMemoire brouillon = new ImageMemoire(L, H, false);
        lancer.TracerBrouillon(brouillon, Constantes.MAX_REFLETS, 1);
        banc = new BancFenetre(lente().lent());
        // le dernier pavé : l'image, ralentie, en est loin
        int[] bas = Arrays.copyOfRange(brouillon.getCodes(), (H - 16) * L, H * L);
        attendre("le brouillon est à l'écran", () -> BancFenetre.trouver(bas, L) != null);
        assertTrue(banc.fenetre.enCours());
        assertNull(banc.fenetre.getImageComplete());
        banc.main.lent = false;
        banc.attendreImage("l'image remplace le brouillon", attendue(L, H));
    }

    @Test
    void lImageEstCelleQuEcriraitLeProgrammeSansFenetre() throws Exception {
        banc = new BancFenetre(lente());
        assertArrayEquals(attendue(L, H), banc.imageAchevee().getCodes());
        banc.attendreImage("l'écran montre les mêmes pixels", attendue(L, H));
        assertEquals("lancer — boule.ini", banc.cadre.getTitle());
        assertEquals("", texte(banc.sortie) + texte(banc.erreur));
    }

    @Test
    void changerDeTailleRedessineALaNouvelleTaille() throws Exception {
        banc = new BancFenetre(lente());
        banc.imageAchevee();
        for (int k = 0; k < 20; k++) {
            int agrandi = 10 * k;
            surFilEvenements(() -> {
                banc.cadre.setSize(banc.cadre.getWidth() + agrandi % 70 - 30, banc.cadre.getHeight() + 3);
                return null;
            });
        }
        attendre("l'image a la taille du panneau", () -> banc.fenetre.getImageComplete() != null
                && banc.fenetre.getImageComplete().getLargeur() == banc.panneau.getWidth()
                && banc.fenetre.getImageComplete().getHauteur() == banc.panneau.getHeight());
        Dimension taille = surFilEvenements(banc.panneau::getSize);
        assertFalse(taille.equals(new Dimension(L, H)));
        banc.attendreImage("sans trace des tailles abandonnées", attendue(taille.width, taille.height));
    }

    @Test
    void lAncienneImageRemplitLaFenetreJusquAuBrouillonSuivant() throws Exception {
        banc = new BancFenetre(lente());
        banc.imageAchevee();
        int gris = banc.panneau.getBackground().getRGB();
        // dans un seul événement : aucun dessin n'a pu être montré entre-temps
        BufferedImage vue = surFilEvenements(() -> {
            banc.cadre.setSize(banc.cadre.getWidth() + 150, banc.cadre.getHeight() + 100);
            banc.cadre.validate();
            BufferedImage image = new BufferedImage(banc.panneau.getWidth(), banc.panneau.getHeight(), BufferedImage.TYPE_INT_RGB);
            banc.panneau.paint(image.createGraphics());
            return image;
        });
        assertEquals(L + 150, vue.getWidth());
        for (int code : BancFenetre.codes(vue)) {
            assertFalse(code == gris || code == 0xFF000000, "ni gris ni noir entre deux images");
        }
    }

    @Test
    void echapArreteEtF5Recommence() throws Exception {
        banc = new BancFenetre(lente().lent());
        attendre("le brouillon est fait", () -> banc.main.getLancer() != null && banc.main.getLancer().isBrouillonFait());
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("le dessin est arrêté", () -> !banc.fenetre.enCours());
        JProgressBar avancement = chercher("avancement", JProgressBar.class);
        assertTrue(surFilEvenements(avancement::getString).startsWith("arrêté à "));
        attendre("plus aucun fil ne dessine", () -> !BancFenetre.vivent("lancer-1") && !BancFenetre.vivent("lancer-2"));
        assertNull(banc.fenetre.getImageComplete());
        banc.main.lent = false;
        banc.frapper(KeyEvent.VK_F5);
        banc.attendreImage("F5 recommence", attendue(L, H));
        assertTrue(surFilEvenements(avancement::getString).startsWith("terminé"));
    }

    @Test
    void leBoutonArreteEtRecommenceAussi() throws Exception {
        banc = new BancFenetre(lente().lent());
        AbstractButton bouton = chercher("bouton", AbstractButton.class);
        attendre("il propose d'arrêter", () -> bouton.getText().equals("Arrêter"));
        surFilEvenements(() -> {
            bouton.doClick();
            return null;
        });
        attendre("il propose de redessiner", () -> bouton.getText().equals("Redessiner") && !banc.fenetre.enCours());
        banc.main.lent = false;
        surFilEvenements(() -> {
            bouton.doClick();
            return null;
        });
        banc.attendreImage("il redessine", attendue(L, H));
    }

    @Test
    void unePanneDuDessinSeLitDansLaFenetreQuiResteUtilisable() throws Exception {
        String[] args = {TAILLE, scene.toString()};
        CountDownLatch repare = new CountDownLatch(1);
        banc = new BancFenetre(new MainLent(args) {
            @Override
            public void doTracerImage(int largeur, int hauteur) {
                if (repare.getCount() > 0) {
                    throw new IllegalStateException("objet\nmal fait");
                }
                super.doTracerImage(largeur, hauteur);
            }
        });
        banc.attendreMessage("échec du programme : java.lang.IllegalStateException: objet\\nmal fait");
        repare.countDown();
        banc.frapper(KeyEvent.VK_F5);
        banc.attendreMessage("");
        banc.attendreImage("l'image est là", attendue(L, H));
        assertEquals("", texte(banc.erreur));
    }

    @Test
    void fermerNeLaisseAucunFil() throws Exception {
        banc = new BancFenetre(lente().lent());
        attendre("le brouillon est fait", () -> banc.main.getLancer() != null && banc.main.getLancer().isBrouillonFait());
        banc.fermer();
        assertFalse(surFilEvenements(banc.cadre::isDisplayable));
        attendre("plus aucun fil du programme", () -> !BancFenetre.vivent("lancer-"));
    }

    @Test
    void leFilDesEvenementsNAttendNiLaLectureNiLeDessin() throws Exception {
        CountDownLatch lecture = new CountDownLatch(1);
        String[] args = {TAILLE, scene.toString()};
        banc = new BancFenetre(new MainLent(args) {
            private boolean premiere = true;

            @Override
            public Scene lireScene(String fichier) {
                if (!premiere) {
                    attendreSansEtreInterrompu(lecture);
                }
                premiere = false;
                return super.lireScene(fichier);
            }
        }.lent());
        attendre("le dessin a commencé", () -> banc.main.getLancer() != null);
        repondA(50);
        assertTrue(banc.fenetre.enCours(), "le dessin n'a pas eu à finir pour cela");
        banc.frapper(KeyEvent.VK_F5);
        JProgressBar avancement = chercher("avancement", JProgressBar.class);
        attendre("la lecture se dit", () -> avancement.getString().startsWith("lecture…"));
        banc.frapper(KeyEvent.VK_F5);
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("arrêté", () -> !banc.fenetre.enCours());
        repondA(50);
        assertEquals(1, lecture.getCount(), "la lecture n'a pas eu à finir pour cela");
        lecture.countDown();
        banc.main.lent = false;
        banc.frapper(KeyEvent.VK_F5);
        banc.attendreImage("et tout se remet en marche", attendue(L, H));
    }

    private static void repondA(int questions) throws Exception {
        for (int k = 0; k < questions; k++) {
            surFilEvenements(() -> null);
        }
    }

    private static void attendreSansEtreInterrompu(CountDownLatch loquet) {
        while (true) {
            try {
                loquet.await();
                return;
            } catch (InterruptedException e) {
                // un disque lent ne s'interrompt pas
            }
        }
    }

    @Test
    void laBarreDitLePixelSousLaSourisEtLeCoutDeLImage() throws Exception {
        banc = new BancFenetre(lente("--statistiques"));
        ImageMemoire image = banc.imageAchevee();
        banc.attendreImage("l'image est à l'écran", image.getCodes());
        Point coin = BancFenetre.trouver(image.getCodes(), L);
        int k = 100 * L + 160;
        String debut = String.format("pixel 160, 100 : #%06X = ", image.getCodes()[k] & 0xFFFFFF);
        JLabel pixel = chercher("pixel", JLabel.class);
        banc.robot.mouseMove(coin.x + 10, coin.y + 10);
        attendre("le pixel se dit", () -> {
            banc.robot.mouseMove(coin.x + 160, coin.y + 100);
            return pixel.getText().startsWith(debut);
        });
        JLabel resume = chercher("resume", JLabel.class);
        attendre("le coût se dit", () -> resume.getText().matches("320 × 240 pixels, \\d+(\u00A0\\d{3})* rayons, \\d+,\\d\\d s"));
        banc.frapper(KeyEvent.VK_F5);
        attendre("la seconde image se compte aussi", () -> texte(banc.sortie).split("\n").length == 24);
        String dit = texte(banc.sortie);
        assertTrue(dit.matches("(?:(?:[a-z]+\\.)+[a-z]+: [0-9.]+\n){24}"), dit);
        assertTrue(dit.startsWith("rayons.primaires: 76800\n"), dit);
    }

    @Test
    void unEcranDenseMontreUnPixelDImageParPixel() throws Exception {
        BancFenetre.exigerEcran();
        int[] attendue = attendue(2 * L, 2 * H);
        Robot robot = new Robot();
        Process programme = BancFenetre.processus(dossier.resolve("dit.txt"), "-Dsun.java2d.uiScale=2", "lancer.Main", TAILLE,
                scene.toString()).start();
        try {
            attendre("l'image est à l'écran, deux fois plus grande et aussi nette",
                    () -> BancFenetre.trouver(attendue, 2 * L) != null);
            Point ou = BancFenetre.trouver(attendue, 2 * L);
            robot.mouseMove(ou.x + L, ou.y + H);
            attendre("Ctrl+Q termine le programme", () -> {
                robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
                robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
                robot.keyPress(KeyEvent.VK_CONTROL);
                robot.keyPress(KeyEvent.VK_Q);
                robot.keyRelease(KeyEvent.VK_Q);
                robot.keyRelease(KeyEvent.VK_CONTROL);
                return programme.waitFor(500, TimeUnit.MILLISECONDS);
            });
            assertEquals(0, programme.exitValue());
            assertEquals(0, Files.size(dossier.resolve("dit.txt")));
        } finally {
            programme.destroyForcibly();
        }
    }

    @Test
    void sansEcranUneLigneProposeDeSePasserDeFenetre() throws Exception {
        // ailleurs qu'avec X11, l'écran ne se cache pas par une variable, et une fenêtre s'ouvrirait
        assumeTrue(System.getProperty("os.name").equals("Linux"), "pas un Linux");
        for (String affichage : new String[] {null, ":98765"}) {
            Path dit = dossier.resolve("dit.txt");
            ProcessBuilder programme = BancFenetre.processus(dit, "lancer.Main", scene.toString());
            programme.environment().remove("DISPLAY");
            if (affichage != null) {
                programme.environment().put("DISPLAY", affichage);
            }
            assertEquals(1, programme.start().waitFor());
            String ligne = new String(Files.readAllBytes(dit), StandardCharsets.UTF_8);
            assertTrue(ligne.matches("lancer : .*--image.*\\R"), ligne);
        }
    }
}
