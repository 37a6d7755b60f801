package lancer.fenetre;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Dimension;
import java.awt.Image;
import java.awt.Toolkit;
import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.DataFlavor;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import javax.swing.JLabel;
import javax.swing.JMenuItem;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.MenuSelectionManager;
import javax.swing.SwingUtilities;
import lancer.essai.Essai;
import org.junit.jupiter.api.Test;

/** Ce qui s'ouvre devant la fenêtre : les dialogues et les menus ; et ce qui va au presse-papiers. */
class FenetreDialoguesTest extends EssaiFenetre {

    @Test
    void ctrlOSansSceneOuTenuNOuvreQuUnDialogueEtLeNomSeComplete() throws Exception {
        ouvrir(new MainLent(TAILLE));
        choisir(null);
        attendreMessage("Ctrl+O pour ouvrir une scène");
        cliquer(composant("message", JTextArea.class), 5, 5);
        mettreDevant(cadre);
        robot.keyPress(KeyEvent.VK_CONTROL);
        for (int k = 0; k < 3; k++) {
            robot.keyPress(KeyEvent.VK_O);
            robot.keyRelease(KeyEvent.VK_O);
        }
        robot.keyRelease(KeyEvent.VK_CONTROL);
        choisir(dossier.resolve("boule"));
        attendreImage("rien ne la recouvre", attendue());
        assertEquals("lancer — boule.ini", cadre.getTitle());
        // c'est elle, maintenant, qui est surveillée
        ecrire(BLEUE);
        attendreCodes("modifiée", attendue());
    }

    @Test
    void uneSceneFautiveAuDepartNOuvrePasDeFenetre() throws Exception {
        ecrire(ROUGE.replace("rayon=1", "rayon=-1"));
        Essai essai = Essai.executer(scene.toString());
        assertEquals(2, essai.code);
        assertTrue(essai.erreur.matches("lancer : .*boule.ini.*rayon.*\\R"), essai.erreur);
    }

    @Test
    void ctrlSEcritLeMemePngEtDemandeAvantDeRemplacerMaisJamaisLaScene() throws Exception {
        // un nom de scène finit comme on veut, celui d'une image par .png
        scene = dossier.resolve("scene.png");
        ecrire(ROUGE);
        ouvrir();
        byte[] attendu = Files.readAllBytes(pngSansFenetre());
        Path png = dossier.resolve("tp1.exo2.png");
        assertEquals("scene.png", enregistrerSous(dossier.resolve("tp1.exo2")));
        attendreMessage("enregistrée : tp1.exo2.png");
        assertArrayEquals(attendu, Files.readAllBytes(png));
        Files.write(png, new byte[] {42});
        enregistrerSous(png);
        repondre("Annuler");
        // le disque écrit dans l'ordre : après cette image, l'autre le serait
        enregistrerSous(dossier.resolve("vue"));
        attendreMessage("enregistrée : vue.png");
        assertArrayEquals(new byte[] {42}, Files.readAllBytes(png));
        enregistrerSous(png);
        repondre("Remplacer");
        attendre("l'image est remplacée", () -> Arrays.equals(attendu, Files.readAllBytes(png)));
        enregistrerSous(scene);
        repondre("Remplacer");
        attendreMessage("la sortie est la scène elle-même");
        assertEquals(ROUGE, lu());
        Path perdue = dossier.resolve("absent").resolve("vue.PNG");
        enregistrerSous(perdue);
        attendreMessage(perdue + " : écriture impossible");
    }

    /** Frappe Ctrl+S et choisit ce fichier ; rend le nom qui était proposé. */
    private String enregistrerSous(Path fichier) throws Exception {
        frapperCtrl('S');
        return choisir(fichier);
    }

    private static void repondre(String texte) throws Exception {
        JOptionPane question = composant(null, JOptionPane.class);
        faire(() -> question.setValue(texte));
        attendre("la question est fermée", () -> !question.isShowing());
    }

    @Test
    void ctrlCCopieLImageEtAvecMajLaCommande() throws Exception {
        ouvrir();
        Clipboard presse = Toolkit.getDefaultToolkit().getSystemClipboard();
        frapperCtrl('c');
        attendreMessage("image copiée, 320 × 240 pixels");
        BufferedImage lue = new BufferedImage(L, H, BufferedImage.TYPE_INT_RGB);
        lue.createGraphics().drawImage((Image) presse.getData(DataFlavor.imageFlavor), 0, 0, null);
        assertArrayEquals(attendue(), codes(lue));
        frapper(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_C);
        attendreMessage("réglages copiés : la commande");
        assertTrue(((String) presse.getData(DataFlavor.stringFlavor)).endsWith(" --taille 320x240 " + scene + "\n"));
    }

    @Test
    void unArticleDeMenuSeChoisitParLesFlechesEtEntreeSansRienOuvrirDerriere() throws Exception {
        ouvrir();
        for (int menu = 0; menu < 5; menu++) {
            JMenuItem article = cadre.getJMenuBar().getMenu(menu).getItem(0);
            int rang = menu;
            boolean[] fait = new boolean[1];
            if (article != null) {
                faire(() -> {
                    // ce qu'il ferait n'importe pas ici : ouvrir un dialogue, ou un onglet
                    article.setAction(null);
                    article.addActionListener(e -> fait[0] = true);
                });
                frapper(KeyEvent.VK_F10);
                for (int k = 0; k < menu; k++) {
                    frapper(KeyEvent.VK_RIGHT);
                }
                frapper(KeyEvent.VK_DOWN);
                attendre("le menu " + rang, () -> cadre.getJMenuBar().getMenu(rang).isSelected() && article.isArmed());
                frapper(KeyEvent.VK_ENTER);
                attendre("l'article du menu " + rang, () -> fait[0]);
                attendre("le menu se ferme", () -> MenuSelectionManager.defaultManager().getSelectedPath().length == 0);
            }
        }
        assertNull(chercher("pixel", JPanel.class), "l'inspecteur ne s'est pas ouvert derrière");
    }

    @Test
    void f1DitLesTouchesQueDitLaPageDansUnPetitDialogue() throws Exception {
        ouvrir();
        frapper(KeyEvent.VK_F1);
        JLabel table = composant("table", JLabel.class);
        Dimension place = surFilEvenements(() -> SwingUtilities.getWindowAncestor(table).getSize());
        assertTrue(place.width * place.height < 1280 * 800 * 2 / 5, place.toString());
        String page = new String(Files.readAllBytes(Paths.get("docs/fenetre.md")), StandardCharsets.UTF_8);
        for (String ligne : table.getText().replaceFirst(".*?<tr>", "").split("<tr>")) {
            String[] dit = ligne.substring("<td>".length()).split("<td>");
            // le nom d'une touche suit la langue de la machine des tests
            assertTrue(page.contains(" | " + dit[1] + " |"), dit[1]);
        }
        mettreDevant(SwingUtilities.getWindowAncestor(table));
        robot.keyPress(KeyEvent.VK_ESCAPE);
        robot.keyRelease(KeyEvent.VK_ESCAPE);
        attendre("Échap le ferme", () -> !table.isShowing());
    }
}
