package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.faire;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.Arrays;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import lancer.commande.Option;
import lancer.fenetre.vue.figures.GraphiqueVitesse;
import org.junit.jupiter.api.Test;

/** « Vitesse ou précision » : des points, dont chacun est un réglage dessiné, mesuré, et montré d'un clic. */
class FenetreVitesseTest extends EssaiFenetre {

    private JTextArea etat;
    private GraphiqueVitesse graphique;
    private int tremble;

    /** Une petite image est assez dessinée en un instant ; paire, aucune ligne n'y est à l'horizon. */
    private static final int LARGEUR = 100;
    private static final int HAUTEUR = 76;

    private void ouvrirLePanneau(String... options) throws Exception {
        String[] args = Arrays.copyOf(options, options.length + 2);
        args[options.length] = "--taille=" + LARGEUR + "x" + HAUTEUR;
        args[options.length + 1] = scene.toString();
        banc = new BancFenetre(args);
        banc.imageAchevee();
        banc.frapper(KeyEvent.VK_F3);
        graphique = composant("vitesse.graphique", GraphiqueVitesse.class);
        etat = composant("vitesse.etat", JTextArea.class);
    }

    private void attendreLaFin() throws Exception {
        attendre("tout est mesuré", () -> etat.getText().matches("(?s)(Les flèches ou la souris|La machine est occupée).*"));
    }

    /** Met la souris sur le point le plus à gauche, et rend son texte. */
    private String viserLePlusRapide() throws Exception {
        Point ou = surFilEvenements(() -> {
            for (int k = 0; k < graphique.getWidth() * graphique.getHeight(); k++) {
                Point la = new Point(k / graphique.getHeight() + 3, k % graphique.getHeight());
                if (graphique.sous(la) != null) {
                    return la;
                }
            }
            return null;
        });
        banc.viser(graphique, ou.x + 3, ou.y);
        // loin de son bord, et en tremblant : sur une machine chargée, une fenêtre n'est pas aussitôt là où Java la croit
        attendre("le point se dit", () -> {
            Point coin = graphique.getLocationOnScreen();
            banc.robot.mouseMove(coin.x + ou.x + 3 + tremble++ % 2, coin.y + ou.y);
            return BancFenetre.delier(etat.getText()).contains(" réflexion");
        });
        return surFilEvenements(() -> BancFenetre.delier(etat.getText()).replaceFirst("[^\n]*\n", ""));
    }

    @Test
    void chaquePointDitSonTempsEtSonErreurAvecLeursIntervallesEtUnClicDessineSonReglage() throws Exception {
        ouvrirLePanneau("--reflets=7");
        attendreLaFin();
        String dit = viserLePlusRapide();
        assertTrue(dit.matches("(?s)un rayon par pixel, \\d+ réflexions? : \\d,\\d{3} s \\(de \\d,\\d{3} à "
                + "\\d,\\d{3}\\), erreur de \\d+,\\d\\d ± \\d+,\\d\\d niveaux"), dit);
        int reflets = Integer.parseInt(dit.replaceFirst(".*, (\\d+) réflexion.*", "$1"));
        banc.robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        banc.robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        banc.attendreCodes("son image", BancFenetre.pixelsSansFenetre(dossier, scene, LARGEUR, HAUTEUR, "--reflets=" + reflets));
        banc.frapper(KeyEvent.VK_F2);
        assertEquals("" + reflets, surFilEvenements(composant("réflexions", JTextField.class)::getText));
    }

    @Test
    void lesPointsRestentPendantUnDessinEtSeRetrouventSansEtreMesuresDeNouveau() throws Exception {
        ouvrirLePanneau();
        attendreLaFin();
        String avant = viserLePlusRapide();
        banc.main.lent = true;
        banc.frapper(KeyEvent.VK_SUBTRACT);
        attendre("le texte le dit", () -> BancFenetre.delier(etat.getText()).startsWith("Les mesures reprendront après ce dessin."));
        assertEquals(avant, viserLePlusRapide(), "ils restent");
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("Échap l'arrête", () -> !banc.etat().enCours());
        assertEquals(avant, viserLePlusRapide(), "après Échap aussi");
        banc.main.lent = false;
        banc.frapper(KeyEvent.VK_ADD);
        banc.imageAchevee();
        attendreLaFin();
        assertEquals(avant, viserLePlusRapide(), "aucun n'est mesuré de nouveau");
        ecrire(BLEUE);
        banc.attendreCodes("elle est bleue", attendue(LARGEUR, HAUTEUR));
        attendreLaFin();
        assertFalse(viserLePlusRapide().equals(avant), "une autre scène est mesurée");
    }

    @Test
    void lesDessinsSeComptentEchapArreteEtF3Reprend() throws Exception {
        banc = new BancFenetre("--taille=640x480", scene.toString());
        banc.imageAchevee();
        banc.frapper(KeyEvent.VK_F3);
        graphique = composant("vitesse.graphique", GraphiqueVitesse.class);
        etat = composant("vitesse.etat", JTextArea.class);
        attendre("les dessins se comptent", () -> BancFenetre.delier(etat.getText()).matches("mesure en cours : [2-9] dessins sur \\d+"));
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("Échap arrête", () -> BancFenetre.delier(etat.getText()).matches("arrêtée : \\d+ réglages? mesurés? ; F3 reprend"));
        assertTrue(surFilEvenements(graphique::isShowing), "et le panneau reste");
        banc.frapper(KeyEvent.VK_RIGHT);
        attendre("une flèche désigne un point", () -> BancFenetre.delier(etat.getText()).contains(" réflexion"));
        banc.frapper(KeyEvent.VK_F3);
        attendre("F3 reprend", () -> BancFenetre.delier(etat.getText()).startsWith("mesure en cours : "));
        banc.frapper(KeyEvent.VK_ESCAPE);
        int reflets = surFilEvenements(() -> Integer.parseInt(etat.getText().replaceFirst("(?s).*, (\\d+) réflexion.*", "$1")));
        banc.frapper(KeyEvent.VK_ENTER);
        attendre("Entrée le prend", () -> banc.etat().demande.reglages.get(Option.REFLETS) == reflets);
    }

    @Test
    void laPlaceDuGraphiqueNeChangePasQuandUnTexteEstLongEtIlALaSienneDansUnePetiteFenetre() throws Exception {
        ouvrirLePanneau();
        int avant = surFilEvenements(graphique::getHeight);
        assertTrue(avant > 100, avant + " points de haut");
        faire(() -> {
            etat.setText("Une phrase de plusieurs lignes : chacun de ses mots compte, et il en faut encore, et encore, et encore.");
            graphique.getParent().validate();
        });
        assertEquals(avant, surFilEvenements(graphique::getHeight));
    }
}
