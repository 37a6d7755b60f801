package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.chercher;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.faire;
import static lancer.fenetre.BancFenetre.pngSansFenetre;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Image;
import java.awt.Toolkit;
import java.awt.datatransfer.DataFlavor;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import org.junit.jupiter.api.Test;

/** L'image enregistrée, telle que l'écrit le programme sans fenêtre, et l'image copiée. */
class FenetreEnregistrementTest extends EssaiFenetre {

    @Test
    void ctrlSEcritLeMemePngEtDemandeAvantDeRemplacer() throws Exception {
        ouvrir();
        byte[] attendu = Files.readAllBytes(pngSansFenetre(dossier, scene, L, H));
        Path png = dossier.resolve("image.png");
        assertEquals("boule.png", enregistrerSous(png));
        attendre("l'image est écrite", () -> Files.exists(png));
        assertArrayEquals(attendu, Files.readAllBytes(png));

        Files.write(png, new byte[] {42});
        enregistrerSous(png);
        repondre("Annuler");
        assertArrayEquals(new byte[] {42}, Files.readAllBytes(png));
        enregistrerSous(png);
        repondre("Remplacer");
        attendre("l'image est remplacée", () -> Arrays.equals(attendu, Files.readAllBytes(png)));
    }

    @Test
    void laSceneElleMemeNEstJamaisEcrasee() throws Exception {
        // un nom de scène finit comme on veut, celui d'une image par .png
        scene = dossier.resolve("scene.png");
        ecrire(ROUGE);
        ouvrir();
        enregistrerSous(scene);
        repondre("Remplacer");
        banc.attendreMessage("la sortie est la scène elle-même");
        assertArrayEquals(ROUGE.getBytes(StandardCharsets.UTF_8), Files.readAllBytes(scene));
    }

    @Test
    void unDessinQuiSAcheveNEffacePasUnEnregistrementQuiAEchoue() throws Exception {
        ouvrir();
        Path perdue = dossier.resolve("absent").resolve("image.png");
        enregistrerSous(perdue);
        banc.attendreMessage(perdue + " : écriture impossible");
        ecrire(BLEUE);
        banc.attendreCodes("l'image suit sa scène", attendue(L, H));
        assertTrue(banc.message().startsWith(perdue.toString()), banc.message());
    }

    @Test
    void uneImageInacheveeNeSEnregistrePas() throws Exception {
        banc = new BancFenetre(lente().lent());
        banc.frapperCtrl('S');
        banc.attendreMessage("L'image se dessine encore");
        assertNull(chercher(null, JFileChooser.class));
    }

    @Test
    void leNomDUneImageFinitToujoursParPng() throws Exception {
        ouvrir();
        byte[] attendu = Files.readAllBytes(pngSansFenetre(dossier, scene, L, H));
        for (String[] noms : new String[][] {{"tp1.exo2", "tp1.exo2.png"}, {"photo.jpg", "photo.jpg.png"}, {"vue.PNG", "vue.PNG"}}) {
            enregistrerSous(dossier.resolve(noms[0]));
            banc.attendreMessage("enregistrée : " + noms[1]);
            assertArrayEquals(attendu, Files.readAllBytes(dossier.resolve(noms[1])));
        }
    }

    @Test
    void ctrlCCopieLImage() throws Exception {
        ouvrir();
        banc.frapperCtrl('c');
        banc.attendreMessage("image copiée, 320 × 240 pixels");
        Image copie = (Image) Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.imageFlavor);
        BufferedImage lue = new BufferedImage(L, H, BufferedImage.TYPE_INT_RGB);
        lue.createGraphics().drawImage(copie, 0, 0, null);
        assertArrayEquals(attendue(L, H), BancFenetre.codes(lue));
        int[] codes = surFilEvenements(() -> banc.etat().getImageEntiere()).codes;
        banc.frapper(KeyEvent.VK_F5);
        attendre("un autre dessin ne se fait pas dans l'image copiée", () -> banc.etat().getImageEntiere() != null
                && banc.etat().getImageEntiere().codes != codes);
    }

    /** Frappe Ctrl+S et choisit ce fichier ; rend le nom qui était proposé. */
    private String enregistrerSous(Path fichier) throws Exception {
        banc.frapperCtrl('S');
        return choisir(fichier);
    }

    private void repondre(String texte) throws Exception {
        JOptionPane question = composant(null, JOptionPane.class);
        faire(() -> question.setValue(texte));
        attendre("la question est fermée", () -> !question.isShowing());
    }
}
