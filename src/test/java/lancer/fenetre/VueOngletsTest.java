package lancer.fenetre;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.text.ParseException;
import java.util.Arrays;
import java.util.stream.IntStream;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JFormattedTextField;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import javax.swing.JTextArea;
import javax.swing.JTree;
import javax.swing.SwingUtilities;
import lancer.commande.Etape;
import lancer.commande.Option;
import lancer.essai.Essai;
import lancer.fenetre.vue.figures.GraphiqueVitesse;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Les trois onglets : le récit d'un pixel et les nombres de ce qui s'y voit, les réglages, la vitesse. */
class VueOngletsTest extends EssaiVue {

    @Test
    void leRecitEstCeluiDeLaLigneDeCommandeArrondi() {
        ouvrir();
        faire("clic 80 55, achève");
        String[] complet = Essai.executer("--taille=160x120", "--pixel=80,55", boule.toString()).sortie.split(System.lineSeparator());
        int replies = recit().split("\n").length;
        frapper(panneau, "D");
        String[] arrondi = recit().split("\n");
        assertEquals(complet.length, arrondi.length, recit());
        for (int k = 1; k < complet.length; k++) {
            String[] mots = complet[k].trim().split("[ ,()^]+");
            String[] dits = arrondi[k].trim().split("[ ,()^]+");
            assertEquals(mots.length, dits.length, arrondi[k]);
            for (int m = 0; m < mots.length; m++) {
                if (mots[m].matches("-?\\d+\\.\\d+(E-?\\d+)?")) {
                    assertEquals(Double.parseDouble(mots[m]), Double.parseDouble(dits[m]), 5.1e-4, arrondi[k]);
                    assertTrue(dits[m].length() <= 10, arrondi[k]);
                } else {
                    assertEquals(mots[m], dits[m]);
                }
            }
        }
        frapper(panneau, "D");
        assertEquals(replies, recit().split("\n").length);
        choisir("Copier le récit du pixel");
        assertEquals(String.join("\n", complet), copie);
        assertEquals("récit du pixel copié, " + complet.length + " lignes", message());
    }

    @Test
    void uneLigneTropLongueSeContinueAuDessousQuelleQueSoitLaLargeur() {
        ouvrir();
        faire("clic 80 55, achève");
        frapper(panneau, "D");
        JTree recit = composant("recit", JTree.class);
        JSplitPane partage = (JSplitPane) SwingUtilities.getAncestorOfClass(JTabbedPane.class, recit).getParent();
        for (int plus : new int[] {0, 120, -200}) {
            partage.setDividerLocation(partage.getDividerLocation() - plus);
            cadre.validate();
            Arrays.stream(recit.getParent().getComponentListeners()).forEach(suiveur -> suiveur.componentResized(null));
            assertTrue(IntStream.range(0, recit.getRowCount()).allMatch(k -> {
                Rectangle place = recit.getRowBounds(k);
                JTextArea ligne = (JTextArea) recit.getCellRenderer().getTreeCellRendererComponent(recit,
                        recit.getPathForRow(k).getLastPathComponent(), false, true, false, k, false);
                ligne.setSize(place.width, Short.MAX_VALUE);
                return place.x + place.width <= recit.getVisibleRect().width && ligne.getPreferredSize().height <= place.height;
            }), "aucune ligne n'est coupée, de " + plus);
        }
    }

    @Test
    void pendantUnLongPixelLeTexteDAvantResteEnGrisEtUnClicYEstSansEffet() {
        ouvrir();
        faire("clic 80 55");
        JTree recit = composant("recit", JTree.class);
        souris(recit, MouseEvent.MOUSE_PRESSED, InputEvent.BUTTON1_DOWN_MASK, 5, 5);
        assertEquals("calcul…", dit("verdict"));
        faire("achève");
        String avant = recit();
        frapper(panneau, "RIGHT");
        assertEquals("calcul…", dit("verdict"));
        assertEquals(avant, recit());
        assertFalse(seLit(recit), "il est en gris");
        faire("achève");
        assertNotEquals(avant, recit());
        assertTrue(recit().startsWith("pixel 81, 55\n"), recit());
        assertTrue(seLit(recit), "le nouveau est en noir");
        frapper(panneau, "shift DOWN");
        faire("achève");
        assertTrue(recit().startsWith("pixel 81, 65\n"), recit());
    }

    private static boolean seLit(JTree recit) {
        return recit.getCellRenderer().getTreeCellRendererComponent(recit, recit.getModel().getRoot(), false, true, false, 0, false)
                .isEnabled();
    }

    private static void taper(JFormattedTextField champ, String texte) throws ParseException {
        champ.setText(texte);
        champ.commitEdit();
    }

    @ParameterizedTest
    @CsvSource({"réflexions, 40, 2000, 'valeur impossible, « 2000 » ; attendu : un entier de 0 à 1000', 7",
        "réflexions, 40, '', aucune valeur ; attendu : un entier de 0 à 1000, 7",
        "seuil des reflets, 0.01, -1, 'valeur impossible, « -1 » ; attendu : un nombre positif ou nul, par exemple 0.001', 0.5"})
    void unReglageSeTapeEtUneValeurImpossibleSeDit(String nom, String present, String faux, String dit, String bon) throws Exception {
        ouvrir(ROUGE, "--taille=160x120", "--reflets=40", "--seuil=0.01");
        faire("F2");
        JFormattedTextField champ = composant(nom, JFormattedTextField.class);
        assertEquals(present, champ.getText());
        assertThrows(ParseException.class, () -> taper(champ, faux));
        assertEquals(nom + " : " + dit, message());
        assertEquals(faux, champ.getText(), "il reste à corriger");
        taper(champ, bon);
        assertEquals("", message());
        faire("achève");
        assertTrue(dit("resume").contains(bon), dit("resume"));
        arrive(suite -> suite.regler(etat.demande.reglages.avec(Option.REFLETS, 40).avec(Option.SEUIL, 0.01)));
        assertEquals(present, champ.getText(), "un réglage venu d'ailleurs se voit");
        JComboBox<?> etapes = composant("étape du cours", JComboBox.class);
        etapes.setSelectedIndex(0);
        assertEquals(Etape.LAMBERT, etat.demande.reglages.get(Option.ETAPE));
        faire("étape OMBRES");
        assertEquals(2, etapes.getSelectedIndex());
    }

    @Test
    void unPointSeDesigneParLaSourisEtSePrendDUnClic() {
        ouvrir();
        faire("F3, achève");
        GraphiqueVitesse graphique = composant("vitesse.graphique", GraphiqueVitesse.class);
        graphique.setSize(400, 400);
        Point premier = IntStream.range(0, 400 * 400).mapToObj(k -> new Point(k / 400, k % 400))
                .filter(ou -> graphique.sous(ou) != null).findFirst().get();
        souris(graphique, MouseEvent.MOUSE_MOVED, 0, premier.x, premier.y);
        String dit = dit("vitesse.etat").replaceFirst("[^\n]*\n", "");
        assertTrue(dit.matches("(?s)un rayon par pixel, \\d+ réflexions? : \\d+,\\d{3} s \\(de \\d+,\\d{3} à "
                + "\\d+,\\d{3}\\), erreur de \\d+,\\d\\d ± \\d+,\\d\\d niveaux"), dit);
        souris(graphique, MouseEvent.MOUSE_PRESSED, InputEvent.BUTTON1_DOWN_MASK, premier.x, premier.y);
        assertEquals(graphique.sous(premier).reglages, etat.demande.reglages);
        graphique.getParent().doLayout();
        int haut = graphique.getHeight();
        composant("vitesse.etat", JTextArea.class).setText("Une phrase de plusieurs lignes : il en faut encore, et encore, et encore.");
        graphique.getParent().doLayout();
        assertEquals(haut, graphique.getHeight(), "un long texte ne déplace pas la figure");
        assertTrue(haut > 100, haut + " points de haut");
    }

    @Test
    void lesTextesOntUneAutreTailleDansToutLeCadreOngletCacheCompris() {
        ouvrir();
        int ordinaire = panneau.getFont().getSize();
        faire("F2, achève, Échap, textes 9, F2");
        for (int plus : new int[] {9, 0}) {
            for (String nom : new String[] {"resume", "réflexions", "image"}) {
                assertEquals(ordinaire + plus, composant(nom, JComponent.class).getFont().getSize(), nom);
            }
            choisir("Textes à leur taille");
        }
    }
}
