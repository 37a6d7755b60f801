package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Point;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import lancer.dessin.ReglagesDessin;
import lancer.fenetre.figures.GraphiqueVitesse;
import lancer.image.ImageMemoire;
import org.junit.jupiter.api.Test;

/** « Vitesse ou précision » : des points, dont chacun se dessine d'un clic et se mesure. */
class FenetreVitesseTest extends EssaiFenetre {

    private JTextArea etat;
    private GraphiqueVitesse graphique;

    private void ouvrirLePanneau() throws Exception {
        ouvrir();
        banc.frapper(KeyEvent.VK_F3);
        graphique = composant("vitesse.graphique", GraphiqueVitesse.class);
        etat = composant("vitesse.etat", JTextArea.class);
    }

    private void attendreEtat(String debut) throws Exception {
        attendre(debut, () -> etat.getText().startsWith(debut));
    }

    private void frapper(int touche) throws Exception {
        banc.frapper(SwingUtilities.getWindowAncestor(graphique), touche);
    }

    /** L'image que la ligne de commande donne aux réglages présents. */
    private int[] presentsSansFenetre() throws Exception {
        ReglagesDessin presents = banc.controleur.etat.getReglages();
        return attendue("--reflets=" + presents.getReflets(), "--seuil=" + presents.getSeuil());
    }

    /** Le plus à gauche des disques pleins du graphique : le plus rapide des réglages. */
    private Point plusRapide() throws Exception {
        return surFilEvenements(() -> {
            BufferedImage vue = new BufferedImage(graphique.getWidth(), graphique.getHeight(), BufferedImage.TYPE_INT_RGB);
            graphique.paint(vue.createGraphics());
            int encre = UIManager.getColor("Component.accentColor").getRGB();
            for (int x = 0; x + 6 < vue.getWidth(); x++) {
                for (int y = 0; y + 6 < vue.getHeight(); y++) {
                    if (Arrays.stream(vue.getRGB(x, y, 6, 6, null, 0, 6)).allMatch(code -> code == encre)) {
                        return new Point(x + 3, y + 3);
                    }
                }
            }
            return null;
        });
    }

    private static boolean essaiEnCours() {
        return Thread.getAllStackTraces().entrySet().stream().filter(e -> e.getKey().getName().equals("lancer-vitesse"))
                .flatMap(e -> Arrays.stream(e.getValue())).anyMatch(appel -> appel.getClassName().startsWith("lancer.auto."));
    }

    @Test
    void unPointChoisiAuClavierSeDessineEtSeMesure() throws Exception {
        ouvrirLePanneau();
        attendreEtat("Un clic");
        frapper(KeyEvent.VK_RIGHT);
        frapper(KeyEvent.VK_ENTER);
        attendreEtat("Mesuré");
        assertArrayEquals(presentsSansFenetre(), banc.imageAchevee().codes);
        String dit = surFilEvenements(etat::getText);
        Matcher m = Pattern.compile("Mesuré : (\\d+),\\d+ ± .*").matcher(dit);
        assertTrue(m.matches(), dit);
        assertTrue(Integer.parseInt(m.group(1)) > 0, "sans anticrénelage, l'erreur se voit : " + dit);
    }

    @Test
    void unClicDeSourisSurUnPointDessineAvecSesReglages() throws Exception {
        ouvrirLePanneau();
        attendreEtat("Un clic");
        Point ou = plusRapide();
        banc.cliquer(graphique, ou.x, ou.y);
        attendreEtat("Mesuré");
        assertArrayEquals(presentsSansFenetre(), banc.imageAchevee().codes);
    }

    @Test
    void laOuLErreurPeutEtreNulleElleEstDiteAuPlus() throws Exception {
        // rien que du ciel : aucune erreur à attendre
        ecrire("[Sphere loin]\ncentre=0 50 6\nrayon=1\nKd=1 1 1\n[Lampe 1]\nposition=-4 6 -3\ncouleur=1 1 1\n");
        ouvrirLePanneau();
        attendreEtat("Un clic");
        JTextArea point = composant("vitesse.point", JTextArea.class);
        frapper(KeyEvent.VK_RIGHT);
        attendre("il se dit", () -> point.getText().contains(", erreur d'au plus "));
    }

    @Test
    void unReglageChangeAuClavierDevientLePresentDuGraphique() throws Exception {
        ouvrirLePanneau();
        attendreEtat("Un clic");
        for (int reflets : new int[] {2, 1, 0}) {
            frapper(KeyEvent.VK_SUBTRACT);
            attendre("moins de réflexions", () -> banc.controleur.etat.montre.getReglages().getReflets() == reflets);
            attendre("elles ont leur point", graphique::aUnPresent);
        }
    }

    @Test
    void uneMesureAuDelaDeToutCeQuiEtaitAttenduSeVoitDansLeCadre() throws Exception {
        ouvrirLePanneau();
        attendreEtat("Un clic");
        retailler(L, 500);
        BufferedImage vue = surFilEvenements(() -> {
            for (double temps = 0.01; temps < 2; temps *= 1.1) {
                graphique.ajouterMesure(temps, 200, 10);
            }
            BufferedImage peinte = new BufferedImage(graphique.getWidth(), graphique.getHeight(), BufferedImage.TYPE_INT_RGB);
            graphique.paint(peinte.createGraphics());
            return peinte;
        });
        int rouges = 0;
        for (int k = 0; k < vue.getWidth() * vue.getHeight(); k++) {
            int y = k / vue.getWidth();
            Color c = new Color(vue.getRGB(k % vue.getWidth(), y));
            if (c.getRed() > c.getBlue() + 60) {
                rouges++;
                assertTrue(y >= 26, "au-dessus du cadre : " + y);
            }
        }
        assertTrue(rouges > 5, rouges + " pixels");
    }

    @Test
    void fermerLePanneauArreteLesEssais() throws Exception {
        ouvrirLePanneau();
        attendre("les essais commencent, ou finissent", () -> !etat.getText().equals(" "));
        frapper(KeyEvent.VK_ESCAPE);
        attendre("le panneau se ferme", () -> !graphique.isShowing());
        attendre("plus aucun essai", () -> !essaiEnCours());
    }

    @Test
    void changerLaSceneRecommenceLesEssais() throws Exception {
        ouvrirLePanneau();
        attendreEtat("Un clic");
        List<Object> dits = new CopyOnWriteArrayList<>();
        etat.addCaretListener(e -> dits.add(etat.getText()));
        ecrire(BLEUE);
        attendre("d'autres essais commencent", () -> dits.contains("premiers essais…"));
        attendreEtat("Un clic");
    }

    @Test
    void relireUnFichierQuiNAPasChangeNeRecommencePasLesEssais() throws Exception {
        ouvrirLePanneau();
        attendreEtat("Un clic");
        List<Object> dits = new CopyOnWriteArrayList<>();
        etat.addCaretListener(e -> dits.add(etat.getText()));
        ImageMemoire avant = banc.imageAchevee();
        banc.frapper(KeyEvent.VK_F5);
        attendre("l'image est neuve", () -> banc.controleur.getImageComplete() != null
                && banc.controleur.getImageComplete() != avant);
        assertFalse(dits.contains("premiers essais…"), dits.toString());
    }
}
