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
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.DoubleConsumer;
import javax.swing.JTextPane;
import lancer.Couleur;
import lancer.Objet3D;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.essai.Essai;
import lancer.scene.SceneLue;
import org.junit.jupiter.api.Test;

/** L'inspecteur : la chaîne du pixel où l'on a cliqué, à côté de l'image. */
class FenetreInspecteurTest extends EssaiInspecteur {

    @Test
    void unClicOuvreLaChaineDuPixelQuiEstCelleDeLaLigneDeCommandeArrondie() throws Exception {
        int[] codes = ouvrir().codes;
        cliquer(150, 100);
        attendreTitre(150, 100);
        String recit = attendreRecit(couleur(codes[100 * L + 150]));
        attendreVerdict("Au bit près, la couleur du pixel dessiné : #");
        String[] complet = Essai.executer(TAILLE, "--pixel=150,100", scene.toString()).sortie.split(System.lineSeparator());
        JTextPane texte = composant("recit", JTextPane.class);
        presser(KeyEvent.VK_D);
        attendre("le détail est déplié", () -> texte.getText().contains(" ▾"));
        recit = surFilEvenements(texte::getText);
        String[] arrondi = Arrays.stream(recit.split("\n")).filter(ligne -> !ligne.endsWith(" ▾")).toArray(String[]::new);
        assertTrue(arrondi[1].contains("arrondis"), recit);
        assertEquals(complet.length + 1, arrondi.length, recit);
        for (int k = 1; k < complet.length; k++) {
            String[] mots = complet[k].trim().split("[ ,()^]+");
            String[] dits = arrondi[k + 1].trim().split("[ ,()^]+");
            assertEquals(mots.length, dits.length, arrondi[k + 1]);
            for (int m = 0; m < mots.length; m++) {
                if (mots[m].matches("-?\\d+\\.\\d+(E-?\\d+)?")) {
                    double exact = Double.parseDouble(mots[m]);
                    assertEquals(exact, Double.parseDouble(dits[m]), 5.1e-4 * Math.min(1, Math.abs(exact)), arrondi[k + 1]);
                } else {
                    assertEquals(mots[m], dits[m]);
                }
            }
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
    void aCoteDUneImageSansHauteurLaChaineSeLitAussi() throws Exception {
        banc = new BancFenetre("--taille=320x8", scene.toString());
        banc.imageAchevee();
        banc.robot.mouseMove(0, 0);
        banc.frapper(KeyEvent.VK_ENTER);
        attendreVerdict("Au bit près");
        JTextPane recit = composant("recit", JTextPane.class);
        assertTrue(lignesEnVue(recit) >= 15, lignesEnVue(recit) + " lignes en vue");
        // toute la hauteur d'un écran de 768 pixels, deux par point
        Inspecteur inspecteur = inspecteur();
        faire(() -> {
            inspecteur.setSize(inspecteur.getWidth(), 384);
            inspecteur.validate();
        });
        assertTrue(lignesEnVue(recit) >= 14, lignesEnVue(recit) + " lignes en vue sur un écran dense");
    }

    @Test
    void aucunNombreNEstCoupeAuBoutDUneLigne() throws Exception {
        ouvrir();
        cliquer(160, 120);
        attendreVerdict("Au bit près");
        JTextPane recit = composant("recit", JTextPane.class);
        String texte = surFilEvenements(recit::getText);
        assertTrue(texte.contains("e-15 "), texte);
        int[] lignes = surFilEvenements(() -> {
            int[] hauteurs = new int[texte.length()];
            for (int k = 0; k < hauteurs.length; k++) {
                hauteurs[k] = recit.modelToView(k).y;
            }
            return hauteurs;
        });
        for (int k = 1; k < lignes.length; k++) {
            boolean dansUnMot = texte.charAt(k) > ' ' && texte.charAt(k - 1) > ' ';
            assertFalse(dansUnMot && lignes[k] != lignes[k - 1], texte.substring(Math.max(0, k - 30), k + 1));
        }
    }

    private static int lignesEnVue(JTextPane recit) throws Exception {
        return surFilEvenements(() -> recit.getVisibleRect().height / recit.getFontMetrics(recit.getFont()).getHeight());
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
    void ilSuitLeMemePixelQuandLaSceneChangeEtMarqueCeQuiAChange() throws Exception {
        int[] rouge = ouvrir().codes.clone();
        cliquer(150, 110);
        attendreRecit(couleur(rouge[110 * L + 150]));
        ecrire(BLEUE);
        int[] bleue = attendue(L, H);
        attendre("la nouvelle image", () -> banc.atelier.getImageComplete() != null
                && Arrays.equals(banc.atelier.getImageComplete().codes, bleue));
        String recit = attendreRecit(couleur(bleue[110 * L + 150]));
        attendreVerdict("Au bit près");
        long marques = Arrays.stream(recit.split("\n")).filter(ligne -> ligne.contains("   ← = ")).count();
        assertTrue(marques > 0 && marques < recit.split("\n").length / 2, marques + " lignes marquées dans " + recit);
        assertTrue(recit.matches("(?s).*" + couleur(bleue[110 * L + 150]) + "   ← somme [^\n]*" + couleur(rouge[110 * L + 150])), recit);
    }

    @Test
    void ilRaconteLImageQuiSeVoitDesSonBrouillonQueLaSceneOuUnReglageAitChange() throws Exception {
        banc = new BancFenetre(lente());
        banc.imageAchevee();
        cliquer(150, 110);
        attendreVerdict("Au bit près");
        JTextPane recit = composant("recit", JTextPane.class);
        banc.main.lent = true;
        ecrire(BLEUE);
        attendre("la scène relue", () -> recit.getText().contains("diffus = Kd (0.10000 0.20000 0.90000)"));
        attendreVerdict("L'image n'est pas achevée");
        presser(KeyEvent.VK_SUBTRACT);
        attendre("deux réflexions", () -> banc.atelier.enCours && banc.atelier.montre.getReglages().getReflets() == 2);
        attendreVerdict("L'image n'est pas achevée");
        assertTrue(surFilEvenements(() -> banc.atelier.enCours));
    }

    @Test
    void leMemeEndroitResteInspecteQuandLImageChangeDeTaille() throws Exception {
        ouvrir();
        cliquer(160, 60);
        attendreTitre(160, 60);
        banc.frapper(KeyEvent.VK_CONTROL, KeyEvent.VK_0);
        faire(() -> banc.cadre.setSize(banc.cadre.getWidth() + 320, banc.cadre.getHeight() + 240));
        attendre("une image plus haute", () -> banc.atelier.montre.getImage().hauteur > H + 100);
        attendre("au même endroit", () -> {
            double fois = banc.atelier.montre.getImage().largeur / (double) L;
            return composant("recit", JTextPane.class).getText().startsWith(
                    "pixel " + (int) (160.5 * fois) + ", " + (int) (60.5 * fois));
        });
    }

    @Test
    void uneToucheQueCtrlAltOuUnMenuAPriseNEstPasUnChiffre() throws Exception {
        ouvrir();
        cliquer(150, 110);
        attendreVerdict("Au bit près");
        JTextPane recit = composant("recit", JTextPane.class);
        String replie = surFilEvenements(recit::getText);
        BancFenetre.mettreDevant(banc.cadre);
        banc.frapper(KeyEvent.VK_CONTROL, KeyEvent.VK_1);
        banc.frapper(KeyEvent.VK_ALT, KeyEvent.VK_D);
        presserLeMenu(KeyEvent.VK_X);
        presserLeMenu(KeyEvent.VK_2);
        attendre("deux réflexions", () -> banc.atelier.reglages.getReflets() == 2);
        attendreVerdict("Au bit près");
        Inspecteur ouvert = inspecteur();
        assertEquals(0, surFilEvenements(() -> ouvert.rebond));
        assertFalse(surFilEvenements(recit::getText).contains(" ▾"), replie);
        banc.frapper(KeyEvent.VK_D);
        attendre("mais d seul déplie", () -> recit.getText().contains(" ▾"));
        banc.frapper(KeyEvent.VK_1);
        attendre("et 1 seul isole", () -> ouvert.rebond == 1);
    }

    private void presserLeMenu(int touche) throws Exception {
        banc.robot.waitForIdle();
        banc.robot.keyPress(touche);
        banc.robot.keyRelease(touche);
        banc.robot.waitForIdle();
    }

    @Test
    void auClavierSeulEntreeLOuvreAuMilieuEtLesTouchesDuCadreYRepondent() throws Exception {
        ouvrir();
        ouvrirAuMilieu();
        presser(KeyEvent.VK_SUBTRACT);
        int[] deux = BancFenetre.pixelsSansFenetre(dossier, scene, L, H, "--reflets=2");
        attendre("moins de réflexions", () -> banc.atelier.getImageComplete() != null
                && Arrays.equals(deux, banc.atelier.getImageComplete().codes));
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

    @Test
    void pendantUnDessinLentLaChaineSeLitDeja() throws Exception {
        banc = new BancFenetre(lente().lent());
        attendre("le brouillon est là", () -> banc.main.brouillonFait());
        attendre("et se voit", () -> banc.panneau.montree != null);
        cliquer(150, 100);
        attendreTitre(150, 100);
        attendreVerdict("L'image n'est pas achevée");
        JTextPane recit = composant("recit", JTextPane.class);
        attendre("la chaîne", () -> recit.getText().contains("\nsomme "));
        assertTrue(banc.atelier.enCours);
    }

    @Test
    void sansRienChoisirCtrlCCopieToutLeTexteEtNonLImage() throws Exception {
        int[] codes = ouvrir().codes;
        cliquer(150, 100);
        String recit = attendreRecit(couleur(codes[100 * L + 150]));
        presser(KeyEvent.VK_CONTROL, KeyEvent.VK_C);
        attendre("le texte, copié", () -> BancFenetre.copie().equals(recit));
        assertFalse(composant("recit", JTextPane.class).isEditable());
    }

    @Test
    void pendantUnLongPixelLeTexteDAvantResteEnGrisEtCalculSeDit() throws Exception {
        AtomicReference<CountDownLatch> lenteur = new AtomicReference<>(new CountDownLatch(0));
        banc = new BancFenetre(new MainLent(args()) {
            @Override
            public SceneLue lireScene(String fichier, DoubleConsumer suivi) {
                SceneLue lue = super.lireScene(fichier, suivi);
                lue.objets.add(new Lent(lenteur));
                return lue;
            }
        });
        banc.imageAchevee();
        lenteur.set(new CountDownLatch(1));
        cliquer(150, 100);
        attendreVerdict("calcul…");
        JTextPane recit = composant("recit", JTextPane.class);
        AtomicReference<Throwable> panne = new AtomicReference<>();
        Thread.setDefaultUncaughtExceptionHandler((fil, e) -> panne.set(e));
        banc.cliquer(recit, 5, 5);
        banc.robot.waitForIdle();
        Thread.setDefaultUncaughtExceptionHandler(null);
        assertNull(panne.get(), "d'un texte encore blanc, un clic ne fait rien");
        lenteur.get().countDown();
        attendreVerdict("Au bit près");
        String avant = surFilEvenements(recit::getText);
        lenteur.set(new CountDownLatch(1));
        presser(KeyEvent.VK_RIGHT);
        attendreVerdict("calcul…");
        assertEquals(avant, surFilEvenements(recit::getText));
        assertTrue(plusNoir(recit) > 100, "il est en gris");
        lenteur.get().countDown();
        attendreVerdict("Au bit près");
        assertFalse(surFilEvenements(recit::getText).equals(avant));
        assertEquals(0, plusNoir(recit), "le nouveau est en noir");
    }

    /** Le plus sombre des rouges d'un texte tel qu'il se peint, de 0 à 255. */
    private static int plusNoir(JTextPane texte) throws Exception {
        return surFilEvenements(() -> {
            BufferedImage vue = new BufferedImage(texte.getWidth(), texte.getHeight(), BufferedImage.TYPE_INT_RGB);
            texte.paint(vue.createGraphics());
            return Arrays.stream(BancFenetre.codes(vue)).map(code -> code >> 16 & 255).min().getAsInt();
        });
    }

    @Test
    void leVerdictDitQuUneCouleurAUnTermeQueLeRecitNeConnaitPas() throws Exception {
        Sphere braise = new Sphere(new lancer.Point(0, 0.2, 6), 1) {
            @Override
            public Couleur getColor(Scene scene, Rayon incident, PointContact contact, int profondeur) {
                return super.getColor(scene, incident, contact, profondeur).add(new Couleur(0.25, 0.5, 0));
            }
        };
        banc = new BancFenetre(new MainLent(args()) {
            @Override
            public SceneLue lireScene(String fichier, DoubleConsumer suivi) {
                SceneLue lue = super.lireScene(fichier, suivi);
                lue.lampes.clear();
                lue.objets.clear();
                lue.objets.add(braise);
                return lue;
            }
        });
        banc.imageAchevee();
        cliquer(L / 2, 100);
        attendreVerdict("Au bit près, la couleur du pixel dessiné : #408000\nLe récit ne connaît pas tous les termes de cette couleur.");
        String recit = attendreRecit(" = #408000");
        assertTrue(recit.contains("\n     autre = 0.25000 0.50000 0.0000 (que le récit ne connaît pas)\n   somme 1 = 0.25000 "), recit);
    }

    /** Un objet que rien ne touche, et dont l'intersection attend ce qu'on veut. */
    private static final class Lent extends Objet3D {

        private final AtomicReference<CountDownLatch> lenteur;

        Lent(AtomicReference<CountDownLatch> lenteur) {
            this.lenteur = lenteur;
        }

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
