package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.chercher;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.faire;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.MouseInfo;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTextPane;
import lancer.Objet3D;
import lancer.Rayon;
import lancer.Scene;
import lancer.Vecteur;
import lancer.essai.Essai;
import lancer.image.ImageMemoire;
import lancer.scene.LecteurScene;
import org.junit.jupiter.api.Test;

/** L'inspecteur : la chaîne du pixel où l'on a cliqué, à côté de l'image et par-dessus elle. */
class FenetreInspecteurTest extends EssaiFenetre {

    private static Inspecteur inspecteur() throws Exception {
        return (Inspecteur) surFilEvenements(() -> Arrays.stream(java.awt.Window.getWindows())
                .filter(w -> w instanceof Inspecteur && w.isShowing()).findFirst().orElse(null));
    }

    private static void attendreTitre(int x, int y) throws Exception {
        attendre("le pixel " + x + ", " + y, () -> inspecteurSur("Rayons du pixel " + x + ", " + y));
    }

    private static boolean inspecteurSur(String titre) {
        return Arrays.stream(java.awt.Window.getWindows()).anyMatch(w -> w instanceof Inspecteur && w.isShowing()
                && ((Inspecteur) w).getTitle().equals(titre));
    }

    private static String attendreRecit(String fin) throws Exception {
        JTextPane recit = composant("recit", JTextPane.class);
        attendre("le récit finit par " + fin, () -> recit.getText().replaceFirst("   ←[^\n]*$", "").endsWith(fin));
        return surFilEvenements(recit::getText);
    }

    private static void attendreVerdict(String debut) throws Exception {
        JLabel verdict = composant("verdict", JLabel.class);
        attendre("le verdict « " + debut + " »", () -> verdict.getText().startsWith(debut));
    }

    private void presser(int... touches) throws Exception {
        banc.frapper(inspecteur(), touches);
    }

    private static String couleur(int code) {
        return String.format(" = #%06X", code & 0xFFFFFF);
    }

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
        assertTrue(recit.contains(couleur(bleue[110 * L + 150]) + "   ← =" + couleur(rouge[110 * L + 150]).substring(2)), recit);
    }

    @Test
    void echapArreteDAbordUnDessinPuisFermeEtLaFigureSEnVa() throws Exception {
        ouvrir();
        int[] codes = attendue(L, H);
        banc.attendreImage("sans figure", codes);
        cliquer(150, 110);
        attendreRecit(couleur(codes[110 * L + 150]));
        attendre("la figure est sur l'image", () -> BancFenetre.trouver(codes, L) == null);
        assertArrayEquals(codes, banc.atelier.getImageComplete().codes, "et pas dans l'image");
        ImageMemoire avant = banc.atelier.getImageComplete();
        banc.main.lent();
        banc.frapper(KeyEvent.VK_F5);
        attendre("le dessin recommence", () -> banc.atelier.enCours() && banc.panneau.getImage() != avant);
        presser(KeyEvent.VK_ESCAPE);
        attendre("le dessin est arrêté", () -> !banc.atelier.enCours());
        assertNotNull(inspecteur(), "mais l'inspecteur reste");
        attendreVerdict("L'image n'est pas achevée");
        banc.main.lent = false;
        presser(KeyEvent.VK_ESCAPE);
        attendre("l'inspecteur se ferme", () -> inspecteurFerme());
        banc.frapper(KeyEvent.VK_F5);
        banc.attendreImage("sans figure de nouveau", codes);
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
    void aLaLoupeLePixelQueMenentLesFlechesResteEnVue() throws Exception {
        ouvrir();
        ouvrirAuMilieu();
        presser(KeyEvent.VK_SHIFT, KeyEvent.VK_UP);
        presser(KeyEvent.VK_SHIFT, KeyEvent.VK_UP);
        PanneauImage image = banc.panneau;
        for (int k = 0; k < 4; k++) {
            presser(KeyEvent.VK_CONTROL, KeyEvent.VK_UP);
        }
        attendre("la loupe est au plus fort", () -> image.getReduction(banc.atelier.getImageComplete()) == 16);
        attendreEnVue(L / 2, H / 2 - 20);
        for (int k = 1; k <= 3; k++) {
            presser(KeyEvent.VK_SHIFT, KeyEvent.VK_LEFT);
            attendreEnVue(L / 2 - 10 * k, H / 2 - 20);
        }
    }

    private void ouvrirAuMilieu() throws Exception {
        banc.robot.mouseMove(0, 0);
        banc.frapper(KeyEvent.VK_ENTER);
        attendreTitre(L / 2, H / 2);
    }

    private void attendreEnVue(int x, int y) throws Exception {
        PanneauImage image = banc.panneau;
        attendreTitre(x, y);
        // autour du milieu, la moitié de ce que la loupe laisse voir
        attendre("il est en vue", () -> Math.abs(image.getPixelVise().x - x) <= image.getWidth() / 32
                && Math.abs(image.getPixelVise().y - y) <= image.getHeight() / 32);
    }

    @Test
    void surUnEcranDenseLAnneauEntoureLePixelCliqueLoupeComprise() throws Exception {
        BancFenetre.exigerEcran();
        int[] attendue = attendue(L, H);
        Process programme = BancFenetre.processus(dossier.resolve("dit.txt"), "-Dsun.java2d.uiScale=2", "lancer.Main", TAILLE,
                scene.toString()).start();
        try {
            attendre("l'image est à l'écran", () -> BancFenetre.trouver(attendue, L) != null);
            Point coin = BancFenetre.trouver(attendue, L);
            Robot robot = new Robot();
            robot.mouseMove(coin.x + 150, coin.y + 110);
            attendre("l'anneau", () -> {
                robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
                robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
                return estEntoure(robot, coin.x + 150.5, coin.y + 110.5);
            });
            robot.mouseWheel(-1);
            robot.mouseWheel(-1);
            robot.mouseWheel(-1);
            // autour de la souris, qui est au bord du pixel
            attendre("l'anneau, à la loupe", () -> estEntoure(robot, coin.x + 150 + 4, coin.y + 110 + 4));
        } finally {
            programme.destroyForcibly();
        }
    }

    /** Vrai si l'on voit presque partout du blanc autour, au rayon d'un anneau pour des caractères deux fois plus grands. */
    private static boolean estEntoure(Robot robot, double x, double y) {
        int blancs = 0;
        for (int k = 0; k < 16; k++) {
            int plusClair = 0;
            for (double rayon = 16; rayon <= 20; rayon += 0.5) {
                Color vu = robot.getPixelColor((int) (x + rayon * Math.cos(k * Math.PI / 8)),
                        (int) (y + rayon * Math.sin(k * Math.PI / 8)));
                plusClair = Math.max(plusClair, Math.min(vu.getRed(), Math.min(vu.getGreen(), vu.getBlue())));
            }
            blancs += plusClair > 200 ? 1 : 0;
        }
        // les traits qui partent de là le recouvrent
        return blancs >= 12;
    }

    private static boolean inspecteurFerme() {
        return Arrays.stream(java.awt.Window.getWindows()).noneMatch(w -> w instanceof Inspecteur && w.isShowing());
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
        attendre("le brouillon est là", () -> banc.main.getTraceur() != null && banc.main.getTraceur().isBrouillonFait());
        attendre("et se voit", () -> banc.panneau.getImage() != null);
        cliquer(150, 100);
        attendreTitre(150, 100);
        attendreVerdict("L'image n'est pas achevée");
        JTextPane recit = composant("recit", JTextPane.class);
        attendre("la chaîne", () -> recit.getText().contains("\nsomme "));
        assertTrue(banc.atelier.enCours());
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

    /** Clique, de la vraie souris, sur la ligne du texte qui commence ainsi. */
    private void cliquerSur(JTextPane recit, String debut) throws Exception {
        Rectangle place = surFilEvenements(() -> recit.modelToView(recit.getDocument()
                .getText(0, recit.getDocument().getLength()).indexOf("\n" + debut) + 1));
        banc.cliquer(recit, place.x + 3, place.y + place.height / 2);
    }

    private static BufferedImage vueDeCote() throws Exception {
        JComponent cote = composant("cote", JComponent.class);
        return surFilEvenements(() -> peindre(cote));
    }

    private static BufferedImage peindre(JComponent composant) {
        BufferedImage vue = new BufferedImage(composant.getWidth(), composant.getHeight(), BufferedImage.TYPE_INT_RGB);
        composant.paint(vue.createGraphics());
        return vue;
    }

    @Test
    void unClicDeSourisSurLeNumeroDUnRebondLeMontreSeulEtUnAutreLesRendTous() throws Exception {
        ouvrir();
        cliquer(150, 110);
        attendreVerdict("Au bit près");
        JTextPane recit = composant("recit", JTextPane.class);
        JComponent cote = composant("cote", JComponent.class);
        int[] tous = BancFenetre.codes(vueDeCote());
        presser();
        cliquerSur(recit, "1  [Sphere 1]");
        attendre("la vue de côté ne montre que lui, de près", () -> !Arrays.equals(tous, BancFenetre.codes(peindre(cote))));
        attendreVerdict("Au bit près");
        cliquerSur(recit, "1  [Sphere 1]");
        attendre("elle les montre tous de nouveau", () -> Arrays.equals(tous, BancFenetre.codes(peindre(cote))));
    }

    @Test
    void pendantUnLongPixelLeTexteDAvantResteEnGrisEtCalculSeDit() throws Exception {
        AtomicReference<CountDownLatch> lenteur = new AtomicReference<>(new CountDownLatch(0));
        banc = new BancFenetre(new MainLent(args()) {
            private Scene avecMur;

            @Override
            public void lireScene(String fichier, LecteurScene lecteur) {
                super.lireScene(fichier, lecteur);
                List<Objet3D> objets = new ArrayList<>(super.getScene().getObjets());
                objets.add(new Lent(lenteur));
                avecMur = new Scene(objets, super.getScene().getLampes()).avec(super.getScene().getModele());
            }

            @Override
            public Scene getScene() {
                return avecMur;
            }
        });
        banc.imageAchevee();
        cliquer(150, 100);
        attendreVerdict("Au bit près");
        JTextPane recit = composant("recit", JTextPane.class);
        String avant = surFilEvenements(recit::getText);
        lenteur.set(new CountDownLatch(1));
        presser(KeyEvent.VK_RIGHT);
        attendreVerdict("calcul…");
        assertEquals(avant + Color.GRAY, surFilEvenements(() -> recit.getText() + recit.getForeground()));
        lenteur.get().countDown();
        attendreVerdict("Au bit près");
        assertFalse(surFilEvenements(recit::getText).equals(avant));
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

    @Test
    void laVueDeCoteMontreLOeilLEcranEtLesRayons() throws Exception {
        ouvrir();
        assertNull(chercher("cote", JComponent.class));
        cliquer(150, 100);
        attendreVerdict("Au bit près");
        long noirs = Arrays.stream(BancFenetre.codes(vueDeCote())).filter(c -> c == 0xFF000000).count();
        assertTrue(noirs > 30, noirs + " points noirs : l'œil et l'écran");
        Rectangle place = inspecteur().getBounds();
        assertTrue(new Rectangle(Toolkit.getDefaultToolkit().getScreenSize()).contains(place), place.toString());
    }
}
