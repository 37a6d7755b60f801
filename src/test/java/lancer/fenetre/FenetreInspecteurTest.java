package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.faire;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.MouseInfo;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.IntStream;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import javax.swing.JTextArea;
import javax.swing.JTree;
import javax.swing.SwingUtilities;
import lancer.Couleur;
import lancer.Objet3D;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.commande.Option;
import lancer.essai.Essai;
import lancer.fenetre.etat.Onglet;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** L'inspecteur : la chaîne du pixel où l'on a cliqué, à côté de l'image. */
class FenetreInspecteurTest extends EssaiInspecteur {

    @Test
    void unClicOuvreLaChaineDuPixelQuiEstCelleDeLaLigneDeCommandeArrondie() throws Exception {
        int[] codes = ouvrir().codes;
        cliquer(150, 100);
        attendreTitre(150, 100);
        attendreRecit(couleur(codes[100 * L + 150]));
        attendreVerdict("Au bit près, la couleur du pixel dessiné : #");
        String[] complet = Essai.executer(TAILLE, "--pixel=150,100", scene.toString()).sortie.split(System.lineSeparator());
        JTree arbre = composant("recit", JTree.class);
        int replies = surFilEvenements(arbre::getRowCount);
        presser(KeyEvent.VK_D);
        attendre("le détail est déplié", () -> arbre.getRowCount() > replies);
        String recit = surFilEvenements(() -> lu(arbre));
        String[] arrondi = recit.split("\n");
        assertEquals(complet.length, arrondi.length, recit);
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
        presser(KeyEvent.VK_D);
        attendre("et se replie", () -> arbre.getRowCount() == replies);
        presser(KeyEvent.VK_CONTROL, KeyEvent.VK_T);
        attendre("le texte de --pixel est copié", () -> BancFenetre.copie().equals(String.join("\n", complet)));
        banc.attendreMessage("récit du pixel copié, " + complet.length + " lignes");
        cliquerSur(arbre, "[Lampe 1]");
        attendre("un clic déplie les facteurs d'une lampe",
                () -> lu(arbre).contains("\ndiffus = Kd (0.9 0.15 0.1) ⊗ lampe (0.9 0.9 0.85) × N·L "));
        assertTrue(surFilEvenements(banc.panneau::isFocusOwner), "et laisse le clavier à l'image");
        banc.frapper(KeyEvent.VK_RIGHT);
        attendreTitre(151, 100);
    }

    @Test
    void uneLigneTropLongueSeContinueAuDessousQuelleQueSoitLaLargeur() throws Exception {
        ouvrir();
        cliquer(150, 100);
        attendreVerdict("Au bit près");
        JTree recit = composant("recit", JTree.class);
        presser(KeyEvent.VK_D);
        for (int largeur : new int[] {0, 120, -200}) {
            faire(() -> {
                JSplitPane partage = (JSplitPane) SwingUtilities.getAncestorOfClass(javax.swing.JTabbedPane.class, recit).getParent();
                partage.setDividerLocation(partage.getDividerLocation() - largeur);
                partage.validate();
            });
            attendre("aucune ligne n'est coupée, de " + largeur, () -> IntStream.range(0, recit.getRowCount()).allMatch(k -> {
                Rectangle place = recit.getRowBounds(k);
                JTextArea ligne = (JTextArea) recit.getCellRenderer().getTreeCellRendererComponent(recit,
                        recit.getPathForRow(k).getLastPathComponent(), false, true, false, k, false);
                ligne.setSize(place.width, Short.MAX_VALUE);
                return place.x + place.width <= recit.getVisibleRect().width && ligne.getPreferredSize().height <= place.height;
            }));
        }
    }

    @Test
    void unClicLentDUneMainQuiTrembleEnEstUn() throws Exception {
        ouvrir();
        banc.viser(banc.panneau, (banc.panneau.getWidth() - L) / 2 + 150, (banc.panneau.getHeight() - H) / 2 + 100);
        Point ou = surFilEvenements(() -> MouseInfo.getPointerInfo().getLocation());
        banc.robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        // au-delà du temps d'un double clic, AWT ne voit plus de clic dans un geste qui a bougé
        banc.robot.delay(700);
        banc.robot.mouseMove(ou.x + 1, ou.y);
        banc.robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        attendreTitre(151, 100);
    }

    @Test
    void lesFlechesLeMenentDUnPixelOuDeDixSansSortirDeLImage() throws Exception {
        ouvrir();
        cliquer(150, 100);
        attendreTitre(150, 100);
        presser(KeyEvent.VK_RIGHT);
        presser(KeyEvent.VK_UP);
        attendreTitre(151, 99);
        presser(KeyEvent.VK_SHIFT, KeyEvent.VK_DOWN);
        presser(KeyEvent.VK_SHIFT, KeyEvent.VK_LEFT);
        attendreTitre(141, 109);
        banc.frapper(KeyEvent.VK_LEFT);
        attendreTitre(140, 109);
        cliquer(3, H - 1);
        presser(KeyEvent.VK_SHIFT, KeyEvent.VK_LEFT);
        presser(KeyEvent.VK_DOWN);
        attendreTitre(0, H - 1);
    }

    @Test
    void ilRaconteLImageQuiSeVoitDesSonBrouillonQueLaSceneOuUnReglageAitChange() throws Exception {
        banc = new BancFenetre(lente());
        banc.imageAchevee();
        cliquer(150, 110);
        attendreVerdict("Au bit près");
        JTree recit = composant("recit", JTree.class);
        presser(KeyEvent.VK_D);
        banc.main.lent = true;
        ecrire(BLEUE);
        attendre("la scène relue", () -> lu(recit).contains("diffus = Kd (0.1 0.2 0.9)"));
        attendreVerdict("L'image n'est pas achevée");
        presser(KeyEvent.VK_SUBTRACT);
        attendre("deux réflexions", () -> banc.etat().enCours()
                && banc.etat().montre.dessin.demande.reglages.get(Option.REFLETS) == 2);
        attendreVerdict("L'image n'est pas achevée");
        assertTrue(surFilEvenements(() -> banc.etat().enCours()));
        banc.main.lent = false;
        int[] bleue = attendue("--reflets=2");
        banc.attendreCodes("la nouvelle image", bleue);
        attendreRecit(couleur(bleue[110 * L + 150]));
        attendreVerdict("Au bit près");
    }

    @Test
    void unPixelDessineQuiNEstPasCeluiDesEquationsSeDit() throws Exception {
        ouvrir().codes[120 * L + 160] ^= 1;
        cliquer(160, 120);
        attendreVerdict("Différent du pixel dessiné, qui est #");
        presser(KeyEvent.VK_RIGHT);
        attendreVerdict("Au bit près");
    }

    private final AtomicReference<CountDownLatch> lenteur = new AtomicReference<>(new CountDownLatch(0));

    @AfterEach
    void lacher() {
        lenteur.get().countDown();
    }

    @Test
    void pendantUnLongPixelLeTexteDAvantResteEnGrisEtCalculSeDit() throws Exception {
        banc = new BancFenetre(lente().apresLecture(lue -> lue.objets.add(new Lent())));
        banc.imageAchevee();
        lenteur.set(new CountDownLatch(1));
        cliquer(150, 100);
        attendreVerdict("calcul…");
        JTree recit = composant("recit", JTree.class);
        AtomicReference<Throwable> panne = new AtomicReference<>();
        Thread.setDefaultUncaughtExceptionHandler((fil, e) -> panne.set(e));
        banc.cliquer(recit, 5, 5);
        banc.robot.waitForIdle();
        Thread.setDefaultUncaughtExceptionHandler(null);
        assertNull(panne.get(), "d'un texte encore blanc, un clic ne fait rien");
        lenteur.get().countDown();
        attendreVerdict("Au bit près");
        String avant = surFilEvenements(() -> lu(recit));
        lenteur.set(new CountDownLatch(1));
        presser(KeyEvent.VK_RIGHT);
        attendreVerdict("calcul…");
        assertEquals(avant, surFilEvenements(() -> lu(recit)));
        assertFalse(surFilEvenements(() -> seLit(recit)), "il est en gris");
        lenteur.get().countDown();
        attendreVerdict("Au bit près");
        assertFalse(surFilEvenements(() -> lu(recit)).equals(avant));
        assertTrue(surFilEvenements(() -> seLit(recit)), "le nouveau est en noir");
    }

    private static boolean seLit(JTree recit) {
        return recit.getCellRenderer().getTreeCellRendererComponent(recit, recit.getModel().getRoot(), false, true, false, 0, false)
                .isEnabled();
    }

    @Test
    void leRecitDitLeTermeQuIlNeConnaitPas() throws Exception {
        Sphere braise = new Sphere(new lancer.Point(0, 0.2, 6), 1) {
            @Override
            public Couleur getColor(Scene scene, Rayon incident, PointContact contact, int profondeur) {
                return super.getColor(scene, incident, contact, profondeur).add(new Couleur(0.25, 0.5, 0));
            }
        };
        banc = new BancFenetre(lente().apresLecture(lue -> {
            lue.lampes.clear();
            lue.objets.clear();
            lue.objets.add(braise);
        }));
        banc.imageAchevee();
        cliquer(L / 2, 100);
        attendreVerdict("Au bit près, la couleur du pixel dessiné : #408000");
        String recit = attendreRecit(" = #408000");
        assertTrue(recit.contains("\n1  objet 1  0.250 0.500 0 = autre\naucune lampe dans la scène : rien ne l'éclaire\n"
                + "autre = 0.250 0.500 0 (que le récit ne connaît pas)\n"), recit);
    }

    @Test
    void cacheIlNeCalculePlusEtLaFigureSEnVaPuisRevient() throws Exception {
        int[] codes = ouvrir().codes;
        cliquer(150, 110);
        attendreVerdict("Au bit près");
        JTabbedPane onglets = composant("panneau", JTabbedPane.class);
        faire(() -> onglets.setSelectedIndex(Onglet.REGLAGES.ordinal()));
        banc.attendreImage("sans figure", codes);
        banc.frapper(KeyEvent.VK_RIGHT);
        banc.robot.waitForIdle();
        faire(() -> onglets.setSelectedIndex(Onglet.PIXEL.ordinal()));
        attendreTitre(150, 110);
        attendre("la figure revient", () -> Ecran.trouver(codes, L) == null);
    }

    /** Un objet que rien ne touche, et dont l'intersection attend ce qu'on veut. */
    private final class Lent extends Objet3D {

        @Override
        public double getIntersectionDistance(Rayon incident) {
            attendreSansEtreInterrompu(lenteur.get());
            incident.setContact(this, Double.POSITIVE_INFINITY);
            return Double.POSITIVE_INFINITY;
        }

        @Override
        public Vecteur getNormale(lancer.Point contact) {
            return new Vecteur(0, 0, -1);
        }
    }
}
