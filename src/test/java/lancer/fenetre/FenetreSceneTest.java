package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import lancer.Camera;
import lancer.Lampe;
import lancer.Sphere;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** L'onglet Scène : chaque objet et chaque lampe s'y prend et s'y change, visible ou non. */
class FenetreSceneTest extends EssaiFenetre {

    private static final String SOL = "[Sphere sol]\ncentre=0 -19892.188 2099.569\nrayon=20000\nKd=0.5 0.5 0.5\n" + ROUGE;

    private JTable table;
    private JTextArea refus;

    private void ouvrirLaTable() throws Exception {
        banc.frapper(KeyEvent.VK_F4);
        table = composant("table", JTable.class);
        refus = composant("refus", JTextArea.class);
    }

    private void cliquerLaCase(int ligne, int colonne, int fois) throws Exception {
        Rectangle place = surFilEvenements(() -> table.getCellRect(ligne, colonne, true));
        banc.viser(table, place.x + 5, place.y + place.height / 2);
        for (int k = 0; k < fois; k++) {
            banc.robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
            banc.robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        }
        banc.robot.waitForIdle();
    }

    /** Remplace la valeur de cette case par ce texte, puis Entrée. */
    private void ecrireDans(int ligne, int colonne, String valeur) throws Exception {
        cliquerLaCase(ligne, colonne, 2);
        JTextField champ = composant("valeur", JTextField.class);
        attendre("le clavier est à la case", champ::isFocusOwner);
        surFilEvenements(() -> {
            champ.setText(valeur.replaceAll("^-", ""));
            champ.setCaretPosition(0);
            return null;
        });
        if (valeur.startsWith("-")) {
            // une vraie frappe : ce signe est aussi une touche de la fenêtre
            banc.frapper(KeyEvent.VK_MINUS);
        }
        banc.frapper(KeyEvent.VK_ENTER);
        banc.robot.waitForIdle();
    }

    private Point2D place(lancer.Point p, double dx, double dy) throws Exception {
        return surFilEvenements(() -> {
            Camera camera = banc.controleur.etat.montre.lancer.getCamera();
            lancer.Point vue = camera.projeter(p);
            return banc.panneau.placeDe(vue.x + dx * vue.z, vue.y + dy * vue.z);
        });
    }

    private Sphere sphere(int rang) {
        return (Sphere) banc.controleur.etat.choix.scene.objets.get(rang);
    }

    private void viserAvecMaj(Point2D ou) throws Exception {
        banc.viser(banc.panneau, (int) ou.getX() + 1, (int) ou.getY());
        banc.robot.keyPress(KeyEvent.VK_SHIFT);
        Point coin = surFilEvenements(banc.panneau::getLocationOnScreen);
        banc.robot.mouseMove(coin.x + (int) ou.getX(), coin.y + (int) ou.getY());
        banc.robot.waitForIdle();
    }

    @Test
    void lesSectionsSontDansLOrdreDuFichierAvecLeursValeurs() throws Exception {
        ecrire("[Lampe]\nposition=-4 6 -3\ncouleur=0.9 0.9 0.85\n" + ROUGE.replace("Ks=0.2 0.2 0.2", "Kr=0.2 0.2 0.2"));
        ouvrir();
        ouvrirLaTable();
        String[] lignes = surFilEvenements(() -> IntStream.range(0, table.getRowCount()).mapToObj(r ->
                IntStream.range(0, table.getColumnCount()).mapToObj(c -> String.valueOf(table.getValueAt(r, c)))
                .collect(Collectors.joining("|"))).toArray(String[]::new));
        assertArrayEquals(new String[] {"[Lampe] ligne 1|-4 6 -3|—|0.9 0.9 0.85|—|—", "[Sphere 1]|0 0.2 6|1|0.9 0.15 0.1|0.3 0.3 0.3|40",
            "[Sphere 2]|-1.2 -0.6 5|0.5|0.1 0.6 0.2|0.2 0.2 0.2|10", "[Lampe 1]|-4 6 -3|—|0.9 0.9 0.85|—|—"}, lignes);
    }

    @Test
    void uneLigneChoisieEstEntoureeDansLImageEtUneBoulePriseEstChoisieDansLaTable() throws Exception {
        ouvrir();
        ouvrirLaTable();
        Point2D bord = place(sphere(0).getCentre(), 0, -1.01);
        cliquerLaCase(0, 0, 1);
        attendre("son cercle est blanc", () -> IntStream.rangeClosed(-3, 3)
                .anyMatch(k -> (peinteIci((int) bord.getX(), (int) bord.getY() + k) & 0xC0C0C0) == 0xC0C0C0));
        viserAvecMaj(place(sphere(1).getCentre(), 0, 0));
        banc.robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        attendre("la deuxième ligne est choisie", () -> table.getSelectedRow() == 1);
        banc.robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        banc.robot.keyRelease(KeyEvent.VK_SHIFT);
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("lâchée, elle n'est plus choisie", () -> table.getSelectedRow() == -1);
    }

    @AfterEach
    void lacherMaj() {
        if (banc != null) {
            banc.robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
            banc.robot.keyRelease(KeyEvent.VK_SHIFT);
        }
    }

    private int peinteIci(int x, int y) {
        BufferedImage image = new BufferedImage(banc.panneau.getWidth(), banc.panneau.getHeight(), BufferedImage.TYPE_INT_RGB);
        banc.panneau.paint(image.createGraphics());
        return image.getRGB(x, y);
    }

    @Test
    void uneValeurChangeeRedessineLImageQueDonneraitLeFichierEtCtrlZLaRemet() throws Exception {
        int[] avant = ouvrir().codes;
        ouvrirLaTable();
        ecrireDans(0, 2, "1.5");
        ecrireDans(2, 1, "3 5 -2");
        ecrire(ROUGE.replace("rayon=1\n", "rayon=1.5\n").replace("-4 6 -3", "3 5 -2"));
        banc.attendreCodes("l'image du fichier ainsi changé", attendue(L, H));
        ecrire(ROUGE);
        banc.frapperCtrl('z');
        banc.frapperCtrl('z');
        banc.attendreCodes("Ctrl+Z les remet", avant);
    }

    @Test
    void uneValeurRefuseeResteDansSaCaseAvecLaPhraseDeLaLecture() throws Exception {
        ouvrir();
        ouvrirLaTable();
        Object scene = surFilEvenements(() -> banc.controleur.etat.choix);
        for (String[] essai : new String[][] {{"-1", "hors limites : « -1 »"}, {"0,5", "une virgule dans un nombre : « 0,5 »"},
            {"1e999", "nombre trop grand : « 1e999 »"}}) {
            ecrireDans(0, 2, essai[0]);
            attendre(essai[0], () -> refus.getText()
                    .startsWith("valeur refusée, [Sphere 1], rayon : " + essai[1] + " ; attendu : un nombre"));
            assertTrue(surFilEvenements(table::isEditing), "la valeur reste à corriger");
            banc.frapper(KeyEvent.VK_ESCAPE);
            attendre("Échap la rend", () -> !table.isEditing() && table.getValueAt(0, 2).equals("1"));
        }
        assertSame(scene, surFilEvenements(() -> banc.controleur.etat.choix), "rien n'a changé, réglages compris");
    }

    @Test
    void uneLampeHorsDeLImageSePrendDansLaTableEtSePousseDepuisLImage() throws Exception {
        ouvrir();
        ouvrirLaTable();
        cliquerLaCase(2, 0, 1);
        attendre("le clavier est à l'image", banc.panneau::isFocusOwner);
        Lampe avant = surFilEvenements(() -> banc.controleur.etat.choix.scene.lampes.get(0));
        banc.frapper(KeyEvent.VK_SHIFT, KeyEvent.VK_RIGHT);
        attendre("elle a bougé", () -> !banc.controleur.etat.choix.scene.lampes.get(0).getPosition().equals(avant.getPosition()));
        attendre("la table donne sa nouvelle place", () -> !table.getValueAt(2, 1).equals("-4 6 -3"));
    }

    @Test
    void avecMajLaLigneDuBasNommeCeQuiSeraitPrisPuisCeQuiEstTire() throws Exception {
        ouvrir();
        Point2D boule = place(sphere(0).getCentre(), 0, 0);
        viserAvecMaj(boule);
        attendre("ce qui serait pris", () -> banc.pixel.getText().equals("[Sphere 1] centre=0 0.2 6"));
        banc.robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        Point coin = surFilEvenements(banc.panneau::getLocationOnScreen);
        banc.robot.mouseMove(coin.x + (int) boule.getX() + 30, coin.y + (int) boule.getY());
        attendre("ce qui est tiré, et sa place", () -> banc.pixel.getText().matches("\\[Sphere 1] centre=0\\.\\d+ 0\\.2 6"));
        banc.robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        banc.robot.keyRelease(KeyEvent.VK_SHIFT);
        banc.viser(banc.panneau, (int) boule.getX(), (int) boule.getY() + 5);
        attendre("puis le pixel", () -> banc.pixel.getText().startsWith("pixel "));
    }

    @Test
    void deuxTiragesDeLaMemeBouleSeDefontUnParUn() throws Exception {
        ouvrir();
        Object[] etapes = new Object[3];
        etapes[0] = surFilEvenements(() -> sphere(0).getCentre());
        for (int k = 1; k < 3; k++) {
            Point2D boule = place(sphere(0).getCentre(), 0, 0);
            viserAvecMaj(boule);
            banc.robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
            Point coin = surFilEvenements(banc.panneau::getLocationOnScreen);
            banc.robot.mouseMove(coin.x + (int) boule.getX() + 10, coin.y + (int) boule.getY());
            Object avant = etapes[k - 1];
            attendre("elle est tirée", () -> !sphere(0).getCentre().equals(avant));
            banc.robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
            banc.robot.keyRelease(KeyEvent.VK_SHIFT);
            etapes[k] = surFilEvenements(() -> sphere(0).getCentre());
        }
        banc.frapperCtrl('z');
        attendre("le premier tirage", () -> sphere(0).getCentre().equals(etapes[1]));
        banc.frapperCtrl('z');
        attendre("la place du fichier", () -> sphere(0).getCentre().equals(etapes[0]));
    }

    @Test
    void leSolNeSePrendQueDansLaTable() throws Exception {
        ecrire(SOL);
        ouvrir();
        viserAvecMaj(new Point2D.Double((banc.panneau.getWidth() - L) / 2.0 + 300, (banc.panneau.getHeight() - H) / 2.0 + 235));
        attendre("il se nomme", () -> banc.pixel.getText()
                .equals("[Sphere sol] couvre plus de la moitié de l'image : on la prend dans l'onglet Scène"));
        banc.robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        banc.attendreMessage("[Sphere sol] couvre");
        banc.robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        banc.robot.keyRelease(KeyEvent.VK_SHIFT);
        ouvrirLaTable();
        assertEquals(-1, surFilEvenements(table::getSelectedRow));
        cliquerLaCase(0, 0, 1);
        banc.frapper(KeyEvent.VK_SHIFT, KeyEvent.VK_UP);
        attendre("la table le prend", () -> sphere(0).getCentre().y > -19892.188);
    }

    @Test
    void centMilleLignesDefilentJusquALaDerniere() throws Exception {
        StringBuilder foule = new StringBuilder(ROUGE);
        for (int k = 0; k < 100_000; k++) {
            foule.append("[Sphere b").append(k).append("]\ncentre=").append(k % 100 - 50).append(" ").append(k / 100 % 100 - 50)
                    .append(" ").append(60 + k / 10_000).append("\nrayon=0.3\nKd=0.5 0.5 0.5\n");
        }
        ecrire(foule.toString());
        ouvrir();
        ouvrirLaTable();
        cliquerLaCase(0, 2, 1);
        attendre("le clavier est à la table", table::isFocusOwner);
        // de FlatLaf ; l'apparence de Java veut Ctrl+Fin
        banc.frapper(KeyEvent.VK_END);
        attendre("la dernière ligne", () -> table.getSelectedRow() == 100_002
                && table.getVisibleRect().contains(table.getCellRect(100_002, 2, true)));
        assertEquals("[Sphere b99999]", surFilEvenements(() -> table.getValueAt(100_002, 0)));
        ecrireDans(100_002, 2, "0.5");
        attendre("elle est changée", () -> sphere(100_001).getRayon() == 0.5);
    }
}
