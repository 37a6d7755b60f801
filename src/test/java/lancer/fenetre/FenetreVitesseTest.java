package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.faire;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.event.KeyEvent;
import javax.swing.JSpinner;
import javax.swing.JTextArea;
import lancer.commande.Reglages;
import lancer.fenetre.figures.GraphiqueVitesse;
import org.junit.jupiter.api.Test;

/** « Vitesse ou précision » : des points, dont chacun est un réglage dessiné, mesuré, et montré d'un clic. */
class FenetreVitesseTest extends EssaiFenetre {

    private JTextArea etat;
    private GraphiqueVitesse graphique;

    private void ouvrirLePanneau(String... options) throws Exception {
        ouvrir(options);
        banc.frapper(KeyEvent.VK_F3);
        graphique = composant("vitesse.graphique", GraphiqueVitesse.class);
        etat = composant("vitesse.etat", JTextArea.class);
    }

    private void attendreLaFin() throws Exception {
        attendre("tout est mesuré", () -> etat.getText().contains("Un clic sur un point montre son image"));
    }

    /** Désigne le réglage le plus rapide, et rend son texte. */
    private String plusRapide() throws Exception {
        banc.frapper(KeyEvent.VK_RIGHT);
        attendre("un point se dit", () -> graphique.getVise() != null);
        for (int k = 0; k < 6; k++) {
            banc.frapper(KeyEvent.VK_LEFT);
        }
        banc.robot.waitForIdle();
        return surFilEvenements(etat::getText);
    }

    @Test
    void chaquePointDitSonTempsEtSonErreurAvecLeursIntervallesEtEntreeDessineSonReglage() throws Exception {
        ouvrirLePanneau("--reflets=7");
        attendreLaFin();
        attendre("F3 mène à la figure", graphique::isFocusOwner);
        String dit = plusRapide();
        assertTrue(dit.matches("(?s)un rayon par pixel, --reflets \\d+ --seuil 0\\.0009765625 : \\d,\\d{3} s \\(de \\d,\\d{3} à "
                + "\\d,\\d{3}\\), erreur de \\d+,\\d\\d ± \\d+,\\d\\d niveaux\n.*"), dit);
        Reglages vise = surFilEvenements(() -> graphique.getVise().reglages);
        banc.frapper(KeyEvent.VK_ENTER);
        banc.attendreCodes("son image", attendue("--reflets=" + vise.getReflets()));
        assertEquals(vise, surFilEvenements(() -> banc.controleur.demande.reglages));
        banc.frapper(KeyEvent.VK_F2);
        assertEquals(vise.getReflets(), surFilEvenements(composant("réflexions", JSpinner.class)::getValue));
    }

    @Test
    void lesPointsRestentPendantUnDessinEtSeRetrouventSansEtreMesuresDeNouveau() throws Exception {
        ouvrirLePanneau();
        attendreLaFin();
        String avant = plusRapide();
        banc.main.lent = true;
        banc.frapper(KeyEvent.VK_SUBTRACT);
        attendre("le texte le dit", () -> etat.getText().endsWith("Les mesures reprendront après ce dessin."));
        String pendant = surFilEvenements(etat::getText);
        assertEquals(avant.split("\n")[0], pendant.split("\n")[0]);
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("Échap l'arrête", () -> !banc.controleur.enCours);
        assertEquals(avant.split("\n")[0], surFilEvenements(etat::getText).split("\n")[0], "ils restent");
        banc.main.lent = false;
        banc.frapper(KeyEvent.VK_F9);
        banc.frapper(KeyEvent.VK_ADD);
        banc.imageAchevee();
        attendreLaFin();
        assertEquals(avant.split("\n")[0], surFilEvenements(etat::getText).split("\n")[0], "aucun n'est mesuré de nouveau");
    }

    @Test
    void uneAutreSceneSeMesureDeNouveauEtUneLampeDeplaceeAussi() throws Exception {
        ouvrirLePanneau();
        attendreLaFin();
        String avant = plusRapide();
        ecrire(BLEUE);
        banc.attendreCodes("elle est bleue", attendue(L, H));
        attendreLaFin();
        attendre("les temps sont d'autres", () -> !etat.getText().split("\n")[0].equals(avant.split("\n")[0]));
    }

    @Test
    void laOuRienNeSeVoitAucunIntervalleNEstDit() throws Exception {
        // rien que du ciel : aucune erreur à mesurer
        ecrire("[Sphere loin]\ncentre=0 50 6\nrayon=1\nKd=1 1 1\n[Lampe 1]\nposition=-4 6 -3\ncouleur=1 1 1\n");
        ouvrirLePanneau();
        attendreLaFin();
        String dit = plusRapide();
        assertTrue(dit.contains("), aucun écart vu\n"), dit);
    }

    @Test
    void laPlaceDuGraphiqueNeChangePasQuandUnTexteEstLongEtIlALaSienneDansUnePetiteFenetre() throws Exception {
        banc = new BancFenetre("--taille=200x150", scene.toString());
        banc.imageAchevee();
        banc.frapper(KeyEvent.VK_F3);
        graphique = composant("vitesse.graphique", GraphiqueVitesse.class);
        etat = composant("vitesse.etat", JTextArea.class);
        int avant = surFilEvenements(graphique::getHeight);
        assertTrue(avant > 100, avant + " points de haut");
        faire(() -> {
            etat.setText("Une phrase de plusieurs lignes : chacun de ses mots compte, et il en faut encore, et encore, et encore.");
            graphique.getParent().validate();
        });
        assertEquals(avant, surFilEvenements(graphique::getHeight));
    }
}
