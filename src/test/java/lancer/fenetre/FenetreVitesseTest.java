package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
import lancer.dessin.Dessin;
import lancer.fenetre.figures.GraphiqueVitesse;
import lancer.image.ImageMemoire;
import org.junit.jupiter.api.Test;

/** « Vitesse ou précision » : des points, dont chacun est une image dessinée, mesurée, et montrée d'un clic. */
class FenetreVitesseTest extends EssaiFenetre {

    private JTextArea etat;
    private JTextArea point;
    private GraphiqueVitesse graphique;

    private void ouvrirLePanneau() throws Exception {
        ouvrirLePanneau(TAILLE);
    }

    private void ouvrirLePanneau(String taille) throws Exception {
        banc = new BancFenetre(taille, scene.toString());
        banc.imageAchevee();
        banc.frapper(KeyEvent.VK_F3);
        graphique = composant("vitesse.graphique", GraphiqueVitesse.class);
        etat = composant("vitesse.etat", JTextArea.class);
        point = composant("vitesse.point", JTextArea.class);
    }

    private void attendreEtat(String debut) throws Exception {
        attendre(debut, () -> etat.getText().startsWith(debut));
    }

    private void frapper(int touche) throws Exception {
        banc.frapper(SwingUtilities.getWindowAncestor(graphique), touche);
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

    private static boolean mesureEnCours() {
        return Thread.getAllStackTraces().entrySet().stream().filter(e -> e.getKey().getName().equals("lancer-vitesse"))
                .flatMap(e -> Arrays.stream(e.getValue())).anyMatch(appel -> appel.getClassName().startsWith("lancer."));
    }

    private String dit() throws Exception {
        return surFilEvenements(point::getText);
    }

    /** L'image que la ligne de commande donne à ce nombre de réflexions. */
    private int[] sansFenetre(int reflets) throws Exception {
        return attendue("--reflets=" + reflets);
    }

    /** Le texte du premier point est celui de l'image qu'un clic montre : même temps, et l'image même. */
    @Test
    void unPointChoisiAuClavierMontreSonImageEtSonTemps() throws Exception {
        ouvrirLePanneau();
        attendreEtat("Un clic");
        frapper(KeyEvent.VK_RIGHT);
        attendre("le point se dit", () -> point.getText().contains(" --reflets "));
        String dit = dit();
        Matcher m = Pattern.compile("un rayon par pixel, --reflets 0 --seuil 0\\.0009765625 : (\\d+,\\d+) s, erreur de (\\d+),.*")
                .matcher(dit);
        assertTrue(m.matches(), dit);
        assertTrue(Integer.parseInt(m.group(2)) > 0, "sans anticrénelage, l'erreur se voit : " + dit);
        frapper(KeyEvent.VK_ENTER);
        attendre("l'image sans réflexion", () -> banc.controleur.etat.montre.demande.reglages.getReflets() == 0
                && banc.controleur.etat.getImageEntiere() != null);
        assertArrayEquals(sansFenetre(0), banc.imageAchevee().codes);
        assertEquals(Double.parseDouble(m.group(1).replace(',', '.')), banc.controleur.etat.montre.lancer.getDureeNs() / 1e9, 0.0006);
        String resume = surFilEvenements(banc.resume::getText);
        assertTrue(resume.contains(", 0 réflexion"), resume);
    }

    @Test
    void unClicDeSourisSurUnPointMontreSonImageMemeSansLaRedessiner() throws Exception {
        ouvrirLePanneau();
        attendreEtat("Un clic");
        Point ou = plusRapide();
        Dessin dernier = banc.main.getDessin();
        banc.cliquer(graphique, ou.x, ou.y);
        attendre("le point se dit", () -> point.getText().contains(" --reflets "));
        int reflets = Integer.parseInt(dit().replaceFirst(".* --reflets (\\d+) .*", "$1"));
        attendre("son image", () -> banc.controleur.etat.montre.demande.reglages.getReflets() == reflets
                && !banc.controleur.etat.enCours && banc.controleur.etat.getImageEntiere() != null);
        assertArrayEquals(sansFenetre(reflets), banc.imageAchevee().codes);
        assertSame(dernier, banc.main.getDessin(), "l'image existait");
    }

    @Test
    void laPlaceDuGraphiqueNeChangePasQuandUnTexteEstLong() throws Exception {
        ouvrirLePanneau();
        attendreEtat("Un clic");
        int avant = surFilEvenements(graphique::getHeight);
        surFilEvenements(() -> {
            point.setText("Une phrase qui prend quatre lignes, ou plus encore si ce panneau est étroit : chacun de ses mots compte, "
                    + "et qu'il en faut encore, et encore, et encore, et encore, et encore, et encore.");
            graphique.getParent().validate();
            return null;
        });
        assertEquals(avant, surFilEvenements(graphique::getHeight));
    }

    @Test
    void laOuLErreurPeutEtreNulleElleEstDiteAuPlus() throws Exception {
        // rien que du ciel : aucune erreur à mesurer
        ecrire("[Sphere loin]\ncentre=0 50 6\nrayon=1\nKd=1 1 1\n[Lampe 1]\nposition=-4 6 -3\ncouleur=1 1 1\n");
        ouvrirLePanneau();
        attendreEtat("Un clic");
        frapper(KeyEvent.VK_RIGHT);
        attendre("il se dit", () -> point.getText().contains(", erreur d'au plus "));
    }

    @Test
    void cacherLePanneauSuspendLEchelleEtLeRouvrirLaContinue() throws Exception {
        ouvrirLePanneau();
        attendreEtat("Un clic");
        List<Object> dits = new CopyOnWriteArrayList<>();
        etat.addCaretListener(e -> dits.add(etat.getText()));
        frapper(KeyEvent.VK_ESCAPE);
        attendre("le panneau se ferme", () -> !graphique.isShowing());
        attendre("plus aucune mesure", () -> !mesureEnCours());
        banc.frapper(KeyEvent.VK_F3);
        attendre("le panneau revient", graphique::isShowing);
        attendreEtat("Un clic");
        assertFalse(dits.stream().anyMatch(dit -> dit.toString().startsWith("dessin de")), "ce qui est dessiné le reste : " + dits);
    }

    @Test
    void auDelaDeSoixanteQuatreMegaoctetsLesPremieresImagesSontDessineesDeNouveau() throws Exception {
        ouvrirLePanneau("--taille=1200x1000");
        attendreEtat("Un clic");
        Dessin dernier = banc.main.getDessin();
        for (int k = 0; k < 5; k++) {
            frapper(KeyEvent.VK_RIGHT);
        }
        frapper(KeyEvent.VK_ENTER);
        attendre("le dernier", () -> banc.controleur.etat.montre.demande.reglages.getReflets() == 1000 && !banc.controleur.etat.enCours);
        assertSame(dernier, banc.main.getDessin(), "son image est gardée");
        for (int k = 0; k < 5; k++) {
            frapper(KeyEvent.VK_LEFT);
        }
        frapper(KeyEvent.VK_ENTER);
        attendre("le premier", () -> banc.controleur.etat.montre.demande.reglages.getReflets() == 0 && !banc.controleur.etat.enCours);
        assertNotSame(dernier, banc.main.getDessin(), "la sienne ne l'est plus");
    }

    @Test
    void auDelaDeDeuxMillionsDePixelsLesImagesSontPlusPetitesEtCelaSeDit() throws Exception {
        ouvrirLePanneau("--taille=2000x1500");
        attendre("la taille des images", () -> etat.getText().contains(" Images de 1633 × 1225 pixels."));
    }

    @Test
    void changerLaSceneRecommenceLEchelle() throws Exception {
        ouvrirLePanneau();
        attendreEtat("Un clic");
        List<Object> dits = new CopyOnWriteArrayList<>();
        etat.addCaretListener(e -> dits.add(etat.getText()));
        ecrire(BLEUE);
        attendre("une autre échelle commence", () -> dits.contains("dessin de l'échelon 1 sur 5…"));
        attendreEtat("Un clic");
    }

    @Test
    void relireUnFichierQuiNAPasChangeNeRecommencePasLEchelle() throws Exception {
        ouvrirLePanneau();
        attendreEtat("Un clic");
        List<Object> dits = new CopyOnWriteArrayList<>();
        etat.addCaretListener(e -> dits.add(etat.getText()));
        ImageMemoire avant = banc.imageAchevee();
        banc.frapper(KeyEvent.VK_F5);
        attendre("l'image est neuve", () -> banc.controleur.etat.getImageEntiere() != null
                && banc.controleur.etat.getImageEntiere() != avant);
        attendreEtat("Un clic");
        assertFalse(dits.contains("dessin de l'échelon 1 sur 5…"), dits.toString());
    }
}
