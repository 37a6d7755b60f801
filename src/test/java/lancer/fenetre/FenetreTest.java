package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.faire;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.File;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.concurrent.TimeUnit;
import javax.swing.JComponent;
import javax.swing.JTabbedPane;
import lancer.Camera;
import lancer.Constantes;
import lancer.Lancer;
import lancer.Scene;
import lancer.image.ImageMemoire;
import org.junit.jupiter.api.Test;

/** La fenêtre elle-même : ses menus, ses touches, son icône, et l'écran qui manque. */
class FenetreTest extends EssaiFenetre {

    private static final Class<JTabbedPane> ONGLETS = JTabbedPane.class;

    private void attendreOnglet(String nom) throws Exception {
        JTabbedPane panneau = composant("panneau", ONGLETS);
        attendre("l'onglet " + nom, () -> panneau.getTitleAt(panneau.getSelectedIndex()).equals(nom));
    }

    @Test
    void lePanneauSOuvreADroiteSansDeplacerLImageEtEchapRendSaTailleAuCadre() throws Exception {
        ouvrir();
        Dimension avant = surFilEvenements(banc.cadre::getSize);
        Rectangle image = surFilEvenements(banc.panneau::getBounds);
        banc.frapper(KeyEvent.VK_F2);
        attendreOnglet("Réglages");
        attendre("le cadre s'est élargi", () -> banc.cadre.getWidth() > avant.width);
        assertEquals(image, surFilEvenements(banc.panneau::getBounds), "l'image n'a pas bougé");
        banc.frapper(KeyEvent.VK_F3);
        attendreOnglet("Vitesse");
        faire(banc.panneau::requestFocusInWindow);
        attendre("le clavier est à l'image", banc.panneau::isFocusOwner);
        banc.frapper(KeyEvent.VK_ENTER);
        attendreOnglet("Pixel");
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("le cadre reprend sa taille", () -> banc.cadre.getSize().equals(avant));
        assertEquals(image, surFilEvenements(banc.panneau::getBounds), "l'image n'a toujours pas bougé");
    }

    @Test
    void ceQuiSeMontreAUnNomPourUnLecteurDEcran() throws Exception {
        ouvrir();
        banc.frapper(KeyEvent.VK_ENTER);
        composant("recit", JComponent.class);
        nommes("image", "avancement", "cote", "recit");
        banc.frapper(KeyEvent.VK_F3);
        nommes("vitesse.graphique");
    }

    private void nommes(String... noms) throws Exception {
        for (String nom : noms) {
            String dit = composant(nom, JComponent.class).getAccessibleContext().getAccessibleName();
            assertTrue(dit != null && !dit.trim().isEmpty(), nom);
        }
        attendre("l'image dit ce qu'elle est", () -> ("" + banc.panneau.getAccessibleContext().getAccessibleDescription())
                .startsWith("320 × 240 pixels"));
    }

    @Test
    void lIconeEstLaSceneDuCoursAPlusieursTailles() throws Exception {
        banc = new BancFenetre(lente());
        attendre("elle est là", () -> banc.cadre.getIconImages().size() == 4);
        Lancer lancer = new Lancer(new Scene("scenes/scene1.ini"), new Camera(128, 128));
        ImageMemoire dessinee = new ImageMemoire(128, 128, false);
        lancer.TracerImage(dessinee, Constantes.MAX_REFLETS, 1);
        BufferedImage icone = new BufferedImage(128, 128, BufferedImage.TYPE_INT_RGB);
        icone.createGraphics().drawImage(banc.cadre.getIconImages().get(3), 0, 0, null);
        int proches = 0;
        for (int k = 0; k < 128 * 128; k++) {
            Color a = new Color(icone.getRGB(k % 128, k / 128));
            Color b = new Color(dessinee.codes[k]);
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

    /** Le même Java, sans la bibliothèque qui ouvre des fenêtres sous X11, que certains paquets n'ont pas. */
    @Test
    void unJavaSansFenetresDevantUnEcranLeDitAuLieuDeNierLEcran() throws Exception {
        BancFenetre.exigerEcran();
        Path vrai = Paths.get(System.getProperty("java.home")).toRealPath();
        assumeTrue(Files.exists(vrai.resolve("lib/libawt_xawt.so")), "pas un Java de Linux");
        Path java = Files.createDirectory(dossier.resolve("java"));
        Files.createDirectories(java.resolve("lib/server"));
        Files.createDirectories(java.resolve("bin"));
        Files.copy(vrai.resolve("bin/java"), java.resolve("bin/java"));
        Path classes = Files.createSymbolicLink(java.resolve("lib/modules"), vrai.resolve("lib/modules"));
        for (String ou : new String[] {"lib", "lib/server"}) {
            for (File f : vrai.resolve(ou).toFile().listFiles()) {
                // Java cherche ses bibliothèques à côté d'elles-mêmes, et non de leurs liens
                if (f.getName().matches("(?!libawt_xawt).*\\.(so|cfg|dat)")) {
                    Files.copy(f.toPath(), java.resolve(ou).resolve(f.getName()));
                }
            }
        }
        Path dit = dossier.resolve("dit.txt");
        ProcessBuilder programme = BancFenetre.processus(dit, "lancer.Main", scene.toString());
        programme.command().set(0, java.resolve("bin/java").toString());
        Process lance = programme.start();
        assertTrue(lance.waitFor(40, TimeUnit.SECONDS), "une fenêtre s'est ouverte");
        Files.delete(classes);
        assertEquals(1, lance.exitValue());
        String ligne = new String(Files.readAllBytes(dit), StandardCharsets.UTF_8);
        assertTrue(ligne.matches("lancer : impossible d'ouvrir une fenêtre : .*default-jdk.*--image.*\\R"), ligne);
    }
}
