package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.event.KeyEvent;
import java.util.Arrays;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.KeyStroke;
import lancer.fenetre.figures.GraphiqueVitesse;
import org.junit.jupiter.api.Test;

/** « Vitesse ou précision » : des points, dont chacun se dessine d'un clic et se mesure. */
class FenetreVitesseTest extends EssaiFenetre {

    private JLabel etat;
    private GraphiqueVitesse graphique;

    private void ouvrirLePanneau() throws Exception {
        banc = new BancFenetre(lente());
        banc.imageAchevee();
        banc.frapper(KeyEvent.VK_F3);
        graphique = composant("vitesse.graphique", GraphiqueVitesse.class);
        etat = composant("vitesse.etat", JLabel.class);
    }

    private void attendreEtat(String debut) throws Exception {
        attendre(debut, () -> etat.getText().startsWith(debut));
    }

    /** Ce que fait cette touche là où elle est liée : sans gestionnaire de fenêtres, le clavier reste à la première. */
    private static void frapper(JComponent composant, int touche) throws Exception {
        BancFenetre.surFilEvenements(() -> {
            composant.getActionForKeyStroke(KeyStroke.getKeyStroke(touche, 0)).actionPerformed(null);
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
        frapper(graphique, KeyEvent.VK_RIGHT);
        frapper(graphique, KeyEvent.VK_ENTER);
        attendreEtat("Mesuré");
        // le moins cher des réglages : un rayon par pixel, sans réflexion
        assertEquals(0, banc.fenetre.getReglages().getReflets());
        assertArrayEquals(BancFenetre.pixelsSansFenetre(dossier, scene, L, H, "--reflets=0"), banc.imageAchevee().getCodes());
        Matcher m = Pattern.compile("Mesuré : erreur de (\\d+),\\d+ ± .*").matcher(etat.getText());
        assertTrue(m.matches(), etat.getText());
        assertTrue(Integer.parseInt(m.group(1)) > 0, "sans réflexions ni anticrénelage, l'erreur se voit : " + etat.getText());
    }

    @Test
    void fermerLePanneauArreteLesEssais() throws Exception {
        ouvrirLePanneau();
        frapper(graphique.getRootPane(), KeyEvent.VK_ESCAPE);
        attendre("le panneau se ferme", () -> !graphique.isShowing());
        attendre("plus aucun essai", () -> !essaiEnCours());
    }

    @Test
    void changerLaSceneRecommenceLesEssais() throws Exception {
        ouvrirLePanneau();
        attendreEtat("Un clic");
        int avant = graphique.getVersion();
        ecrire(BLEUE);
        attendre("d'autres essais commencent", () -> graphique.getVersion() > avant);
        attendreEtat("Un clic");
    }
}
