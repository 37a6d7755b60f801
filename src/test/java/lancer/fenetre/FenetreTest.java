package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.chercher;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static lancer.fenetre.BancFenetre.texte;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.Color;
import java.awt.Component;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JOptionPane;
import javax.swing.JProgressBar;
import javax.swing.JTextArea;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
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
        assertTrue(banc.atelier.enCours());
        assertNull(banc.atelier.getImageComplete());
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
    void changerDeTailleGardeLImageDemandeeEtSesProportions() throws Exception {
        banc = new BancFenetre(lente());
        ImageMemoire image = banc.imageAchevee();
        retailler(151, 83);
        attendre("elle est à sa taille, au milieu", () -> BancFenetre.trouver(image.getCodes(), L) != null);
        BufferedImage vue = peinte();
        assertEquals(banc.panneau.getBackground().getRGB(), vue.getRGB(60, 20));
        retailler(L / 2 - banc.panneau.getWidth(), -83);
        // une colonne de gris, puis la moitié des pixels : une boule rouge au milieu, comme avant
        vue = peinte();
        assertEquals(L / 2, vue.getWidth());
        assertEquals(banc.panneau.getBackground().getRGB(), vue.getRGB(L / 4, H / 8));
        Color milieu = new Color(image.getCodes()[H / 2 * L + L / 2]);
        assertEquals(milieu.getRed(), new Color(vue.getRGB(L / 4, vue.getHeight() / 2)).getRed(), 25);
        JTextArea resume = chercher("resume", JTextArea.class);
        attendre("la réduction se dit", () -> resume.getText().startsWith("320 × 240 pixels montrés à 50 %, "));
        assertSame(image, banc.atelier.getImageComplete(), "rien n'est redessiné");
    }

    @Test
    void uneTaillePlusGrandeQueLEcranEstDessineeEnEntierEtMontreeReduite() throws Exception {
        banc = new BancFenetre(new MainLent("--taille=2000x1500", scene.toString()));
        ImageMemoire image = banc.imageAchevee();
        assertEquals("2000 x 1500", image.getLargeur() + " x " + image.getHauteur());
        double reduction = Math.min(banc.panneau.getWidth() / 2000.0, banc.panneau.getHeight() / 1500.0);
        assertTrue(reduction < 1, "l'écran du test est trop grand");
        JTextArea resume = chercher("resume", JTextArea.class);
        String debut = "2000 × 1500 pixels montrés à " + Math.round(100 * reduction) + " %, ";
        attendre("la réduction se dit", () -> resume.getText().startsWith(debut));
        JLabel pixel = chercher("pixel", JLabel.class);
        Point coin = surFilEvenements(banc.panneau::getLocationOnScreen);
        attendre("le pixel dit est celui de l'image dessinée", () -> {
            banc.robot.mouseMove(coin.x + banc.panneau.getWidth() / 2 + 1, coin.y + banc.panneau.getHeight() / 2);
            banc.robot.mouseMove(coin.x + banc.panneau.getWidth() / 2, coin.y + banc.panneau.getHeight() / 2);
            return pixel.getText().matches("pixel (99\\d|100\\d), (74\\d|75\\d) : .*");
        });
    }

    @Test
    void leResumeSeLitEnEntierDansUneFenetreEtroite() throws Exception {
        banc = new BancFenetre(lente());
        banc.imageAchevee();
        JTextArea resume = chercher("resume", JTextArea.class);
        int uneLigne = surFilEvenements(resume::getHeight);
        retailler(200 - banc.panneau.getWidth(), 0);
        attendre("tout est à l'écran, sur plusieurs lignes", () -> {
            Rectangle fin = resume.modelToView(resume.getText().length());
            return resume.getText().endsWith(" réflexions") && resume.getHeight() > uneLigne
                    && resume.getVisibleRect().contains(fin.x, fin.y + fin.height - 1);
        });
    }

    @Test
    void lePixelNeSeDitPlusQuandLaFenetreBougeSousLaSouris() throws Exception {
        banc = new BancFenetre(lente());
        banc.attendreImage("à l'écran", banc.imageAchevee().getCodes());
        Point coin = BancFenetre.trouver(banc.imageAchevee().getCodes(), L);
        JLabel pixel = chercher("pixel", JLabel.class);
        attendre("la souris est là", () -> {
            banc.robot.mouseMove(coin.x + 101, coin.y + 60);
            banc.robot.mouseMove(coin.x + 100, coin.y + 60);
            return pixel.getText().startsWith("pixel 100, 60 : ");
        });
        surFilEvenements(() -> {
            banc.cadre.setLocation(banc.cadre.getX() + 40, banc.cadre.getY() + 10);
            return null;
        });
        attendre("ce n'est plus le même pixel", () -> pixel.getText().equals(" "));
    }

    private void retailler(int deX, int deY) throws Exception {
        surFilEvenements(() -> {
            banc.cadre.setSize(banc.cadre.getWidth() + deX, banc.cadre.getHeight() + deY);
            banc.cadre.validate();
            return null;
        });
    }

    private BufferedImage peinte() throws Exception {
        return surFilEvenements(() -> {
            BufferedImage image = new BufferedImage(banc.panneau.getWidth(), banc.panneau.getHeight(), BufferedImage.TYPE_INT_RGB);
            banc.panneau.paint(image.createGraphics());
            return image;
        });
    }

    @Test
    void lAncienneImageResteJusquAuBrouillonDeLaSuivante() throws Exception {
        CountDownLatch dessin = new CountDownLatch(1);
        String[] args = {TAILLE, scene.toString()};
        banc = new BancFenetre(new MainLent(args) {
            private boolean premiere = true;

            @Override
            public void drawPixel(Couleur coul, int xe, int ye) {
                if (!premiere) {
                    attendreSansEtreInterrompu(dessin);
                }
                super.drawPixel(coul, xe, ye);
            }

            @Override
            public List<String> lireScene(String fichier) {
                premiere = getImage() == null;
                return super.lireScene(fichier);
            }
        });
        banc.imageAchevee();
        int[] avant = attendue(L, H);
        JTextArea resume = chercher("resume", JTextArea.class);
        attendre("le coût se dit", () -> resume.getText().contains("rayons"));
        banc.frapper(KeyEvent.VK_F5);
        attendre("le dessin suivant a commencé", () -> banc.atelier.enCours() && banc.main.getLancer() != null);
        assertArrayEquals(avant, BancFenetre.codes(peinte().getSubimage((banc.panneau.getWidth() - L) / 2, 0, L, H)));
        assertEquals(" ", surFilEvenements(resume::getText), "le coût n'est plus celui de l'image qui vient");
        dessin.countDown();
        banc.attendreImage("elle la remplace", avant);
    }

    @Test
    void echapArreteEtF5Recommence() throws Exception {
        banc = new BancFenetre(lente().lent());
        attendre("le brouillon est fait", () -> banc.main.getLancer() != null && banc.main.getLancer().isBrouillonFait());
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("le dessin est arrêté", () -> !banc.atelier.enCours());
        JProgressBar avancement = chercher("avancement", JProgressBar.class);
        assertTrue(surFilEvenements(avancement::getString).startsWith("arrêté à "));
        assertEquals(" ", surFilEvenements(chercher("resume", JTextArea.class)::getText), "pas de coût d'une image inachevée");
        attendre("plus aucun fil ne dessine", () -> !BancFenetre.vivent("lancer-1") && !BancFenetre.vivent("lancer-2"));
        assertNull(banc.atelier.getImageComplete());
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
        attendre("il propose de redessiner", () -> bouton.getText().equals("Redessiner") && !banc.atelier.enCours());
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
            public List<String> lireScene(String fichier) {
                if (!premiere) {
                    attendreSansEtreInterrompu(lecture);
                }
                premiere = false;
                return super.lireScene(fichier);
            }
        }.lent());
        attendre("le dessin a commencé", () -> banc.main.getLancer() != null);
        repondA(50);
        assertTrue(banc.atelier.enCours(), "le dessin n'a pas eu à finir pour cela");
        banc.frapper(KeyEvent.VK_F5);
        JProgressBar avancement = chercher("avancement", JProgressBar.class);
        attendre("la lecture se dit", () -> avancement.getString().startsWith("lecture "));
        banc.frapper(KeyEvent.VK_F5);
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("arrêté", () -> !banc.atelier.enCours());
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

    static void attendreSansEtreInterrompu(CountDownLatch loquet) {
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
        JTextArea resume = chercher("resume", JTextArea.class);
        String cout = "320 × 240 pixels, \\d+(\u00A0\\d{3})* rayons, \\d+,\\d\\d s, 5 réflexions";
        attendre("le coût se dit", () -> resume.getText().matches(cout));
        banc.frapper(KeyEvent.VK_F5);
        attendre("la seconde image se compte aussi", () -> texte(banc.sortie).split("\n").length == 26);
        String dit = texte(banc.sortie);
        assertTrue(dit.matches("(?:(?:[a-z]+\\.)+[a-z]+: [0-9.]+\n){26}"), dit);
        assertTrue(dit.startsWith("rayons.primaires: 76800\n"), dit);
    }

    @Test
    void seuleLaCouleurDUnPixelDessineSeDitEtCelleDUnBrouillonEstDiteTelle() throws Exception {
        CountDownLatch bas = new CountDownLatch(1);
        String[] args = {TAILLE, scene.toString()};
        banc = new BancFenetre(new MainLent(args) {
            @Override
            public void drawPixel(Couleur coul, int xe, int ye) {
                // le brouillon attend avant le bas de l'image
                if (ye >= H / 2 && !getLancer().isBrouillonFait()) {
                    attendreSansEtreInterrompu(bas);
                }
                super.drawPixel(coul, xe, ye);
            }
        }.lent());
        JLabel pixel = chercher("pixel", JLabel.class);
        attendre("le haut du brouillon se dit", () -> {
            survoler(10, 10);
            return pixel.getText().matches("pixel 10, 10 \\(brouillon\\) : #.*");
        });
        attendre("le bas n'a pas encore de couleur", () -> {
            survoler(10, H - 10);
            return pixel.getText().equals(" ");
        });
        bas.countDown();
        attendre("le bas du brouillon se dit", () -> pixel.getText().matches("pixel 10, " + (H - 10) + " \\(brouillon\\) : #.*"));
        banc.main.lent = false;
        attendre("puis sa dernière couleur", () -> pixel.getText().startsWith("pixel 10, " + (H - 10) + " : #"));
    }

    /** La souris est sur ce pixel de l'image, sans que l'écran ait à le dire. */
    private void survoler(int x, int y) {
        banc.panneau.dispatchEvent(new MouseEvent(banc.panneau, MouseEvent.MOUSE_MOVED, 0, 0, (banc.panneau.getWidth() - L) / 2 + x,
                (banc.panneau.getHeight() - H) / 2 + y, 0, false));
    }

    @Test
    void unEcranDenseMontreUnPixelDImageParPixel() throws Exception {
        BancFenetre.exigerEcran();
        int[] attendue = attendue(L, H);
        Robot robot = new Robot();
        Process programme = BancFenetre.processus(dossier.resolve("dit.txt"), "-Dsun.java2d.uiScale=2", "lancer.Main", TAILLE,
                scene.toString()).start();
        try {
            attendre("l'image est à l'écran, à la taille demandée", () -> BancFenetre.trouver(attendue, L) != null);
            Point ou = BancFenetre.trouver(attendue, L);
            robot.mouseMove(ou.x + L / 2, ou.y + H / 2);
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
    void lesReglagesEtLaSectionLaisseeDeCoteSeLisentApresLeurAvis() throws Exception {
        ecrire(ROUGE + "[Brume dense]\n");
        banc = new BancFenetre(lente("--reflets=1"));
        JTextArea resume = chercher("resume", JTextArea.class);
        attendre("le résumé les dit", () -> resume.getText().matches("320 × 240 pixels, .* s, 1 réflexion, \\[Brume dense] ignorée"));
        assertTrue(texte(banc.erreur).startsWith("lancer : " + scene + ", ligne 16, [Brume dense] : "), texte(banc.erreur));
    }

    @Test
    void unArticleDeMenuQuiNePeutRienEstGrise() throws Exception {
        banc = new BancFenetre(lente().lent());
        JMenu dessin = banc.cadre.getJMenuBar().getMenu(2);
        attendre("on peut arrêter", () -> dessin.getItem(1).isEnabled());
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("il n'y a plus rien à arrêter", () -> !dessin.getItem(1).isEnabled());
        assertTrue(dessin.getItem(0).isEnabled(), "on peut redessiner");
    }

    @Test
    void chaqueMenuEtChaqueArticleSeChoisitParUneLettreQueSesVoisinsNOntPas() throws Exception {
        banc = new BancFenetre(lente());
        banc.imageAchevee();
        JMenuBar menus = banc.cadre.getJMenuBar();
        verifierLesLettres(Arrays.stream(menus.getComponents()));
        for (int k = 0; k < menus.getMenuCount(); k++) {
            // ceux des scènes sont sans nombre
            if (!menus.getMenu(k).getText().equals("Scènes")) {
                verifierLesLettres(Arrays.stream(menus.getMenu(k).getMenuComponents()));
            }
        }
    }

    private static void verifierLesLettres(Stream<Component> articles) {
        List<Integer> lettres = articles.filter(article -> article instanceof JMenuItem)
                .map(article -> ((JMenuItem) article).getMnemonic()).collect(Collectors.toList());
        assertEquals(lettres.size(), new HashSet<>(lettres).size(), lettres.toString());
        assertFalse(lettres.contains(KeyEvent.VK_UNDEFINED), lettres.toString());
    }

    @Test
    void f1MontreLesTouches() throws Exception {
        banc = new BancFenetre(lente());
        banc.frapper(KeyEvent.VK_F1);
        assertTrue(composant(null, JOptionPane.class).getMessage().toString().contains("Échap   arrêter le dessin"));
    }

    @Test
    void lIconeEstLaSceneDuCoursAPlusieursTailles() throws Exception {
        banc = new BancFenetre(lente());
        attendre("elle est là", () -> banc.cadre.getIconImages().size() == 4);
        Lancer lancer = new Lancer(new Scene("scenes/scene1.ini"), new Camera(128, 128));
        ImageMemoire dessinee = new ImageMemoire(128, 128, false);
        lancer.TracerPixels(dessinee, Constantes.MAX_REFLETS, 1);
        BufferedImage icone = new BufferedImage(128, 128, BufferedImage.TYPE_INT_RGB);
        icone.createGraphics().drawImage(banc.cadre.getIconImages().get(3), 0, 0, null);
        int proches = 0;
        for (int k = 0; k < 128 * 128; k++) {
            Color a = new Color(icone.getRGB(k % 128, k / 128));
            Color b = new Color(dessinee.getCodes()[k]);
            proches += Math.abs(a.getRed() - b.getRed()) + Math.abs(a.getBlue() - b.getBlue()) < 8 ? 1 : 0;
        }
        assertTrue(proches > 128 * 128 * 3 / 4, "aux bords près, qu'elle a plus doux : " + proches);
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
