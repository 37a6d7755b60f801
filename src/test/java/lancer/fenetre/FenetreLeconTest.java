package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.faire;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.geom.Point2D;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.JMenu;
import lancer.Sphere;
import lancer.commande.Options;
import lancer.image.ImageMemoire;
import org.junit.jupiter.api.Test;

/** Ce que la fenêtre montre en classe : une boule qui se prend, des vues en fausses couleurs. */
class FenetreLeconTest extends EssaiFenetre {

    private Point centre() throws Exception {
        return surFilEvenements(this::centreIci);
    }

    private Point centreIci() {
        return place(sphere(0).getCentre());
    }

    private Point place(lancer.Point p) {
        lancer.Point vue = banc.controleur.etat.montre.lancer.getCamera().projeter(p);
        Point2D ou = banc.panneau.placeDe(vue.x, vue.y);
        return new Point((int) ou.getX(), (int) ou.getY());
    }

    private Sphere sphere(int rang) {
        return (Sphere) banc.controleur.etat.choix.scene.objets.get(rang);
    }

    /** Tire, Maj tenue, d'autant de pixels. */
    private void tirer(Point de, int dx, int dy) throws Exception {
        saisir(de);
        glisser(de, dx, dy);
    }

    private void saisir(Point ou) throws Exception {
        banc.viser(banc.panneau, ou.x, ou.y);
        banc.robot.keyPress(KeyEvent.VK_SHIFT);
        banc.robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
    }

    private void glisser(Point de, int dx, int dy) throws Exception {
        Point coin = surFilEvenements(banc.panneau::getLocationOnScreen);
        for (int k = 1; k <= 10; k++) {
            banc.robot.mouseMove(coin.x + de.x + dx * k / 10, coin.y + de.y + dy * k / 10);
            banc.robot.waitForIdle();
        }
        banc.robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        banc.robot.keyRelease(KeyEvent.VK_SHIFT);
        banc.robot.waitForIdle();
    }

    /** L'image que donne le fichier, une fois écrit ce que la copie dit. */
    private int[] imageDeLaCopie() throws Exception {
        banc.frapper(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_C);
        String[] copie = {""};
        attendre("la copie", () -> {
            copie[0] = BancFenetre.copie();
            return copie[0].contains("centre=") || copie[0].contains("position=");
        });
        String texte = ROUGE;
        for (String section : copie[0].split("\n\n")) {
            if (section.startsWith("[")) {
                String[] lignes = section.split("\n");
                String cle = lignes[1].substring(0, lignes[1].indexOf('='));
                texte = texte.replaceFirst("(?s)(\\Q" + lignes[0] + "\\E.*?)" + cle + "=[^\n]*", "$1" + lignes[1]);
            }
        }
        Path deplacee = dossier.resolve("deplacee.ini");
        Files.write(deplacee, texte.getBytes(StandardCharsets.UTF_8));
        return BancFenetre.pixelsSansFenetre(dossier, deplacee, L, H);
    }

    @Test
    void uneBoulePriseParMajEtLaSourisSeDeplaceEnMemoireSeuleEtSeCopieTelleQuElleSeVoit() throws Exception {
        int[] avant = ouvrir().codes;
        Point de = centre();
        tirer(de, 40, -20);
        Point a = centre();
        assertEquals(40, a.x - de.x, 1);
        assertEquals(-20, a.y - de.y, 1);
        assertEquals(6, sphere(0).getCentre().z, "dans le plan parallèle à l'écran");
        banc.imageAchevee();
        banc.attendreCodes("le fichier où l'on colle la copie donne cette image", imageDeLaCopie());
        assertEquals(ROUGE, new String(Files.readAllBytes(scene), StandardCharsets.UTF_8), "rien ne s'est écrit");
        banc.frapperCtrl('z');
        banc.attendreCodes("Ctrl+Z la remet", avant);
        assertFalse(surFilEvenements(() -> banc.controleur.etat.estDeplace()));
    }

    @Test
    void avecMajLesFlechesPoussentCeQuiEstPrisDUnPixelEtLaMoletteLEloigne() throws Exception {
        ouvrir();
        Point de = centre();
        tirer(de, 20, 0);
        Point avant = centre();
        for (int k = 0; k < 10; k++) {
            banc.frapper(KeyEvent.VK_SHIFT, KeyEvent.VK_DOWN);
        }
        attendre("dix pixels plus bas", () -> Math.abs(centreIci().y - avant.y - 10) <= 1);
        lancer.Point pres = surFilEvenements(() -> sphere(0).getCentre());
        banc.robot.keyPress(KeyEvent.VK_SHIFT);
        banc.robot.mouseWheel(-2);
        banc.robot.keyRelease(KeyEvent.VK_SHIFT);
        attendre("plus loin", () -> sphere(0).getCentre().z > pres.z + 0.3);
        assertEquals(avant.x, centre().x, 1, "et toujours à la même place de l'image");
        banc.imageAchevee();
        banc.attendreCodes("et cela se copie", imageDeLaCopie());
        banc.frapper(KeyEvent.VK_ESCAPE);
        banc.frapper(KeyEvent.VK_SHIFT, KeyEvent.VK_DOWN);
        banc.robot.waitForIdle();
        int bas = centre().y;
        assertEquals(avant.y + 10, bas, 1, "Échap l'a lâchée");
    }

    @Test
    void uneLampeQuiSeVoitSePrendParSonEtoile() throws Exception {
        ecrire(ROUGE.replace("-4 6 -3", "0 1.5 5"));
        ouvrir();
        tirer(surFilEvenements(() -> place(banc.controleur.etat.choix.scene.lampes.get(0).getPosition())), -30, 10);
        attendre("elle est plus à gauche", () -> banc.controleur.etat.choix.scene.lampes.get(0).getPosition().x < -0.2);
    }

    @Test
    void ceQuiEstDeplaceResteAPresF5EtUnEnregistrementSaufSiSaPlaceAChangeDansLeFichier() throws Exception {
        ouvrir();
        String titre = banc.cadre.getTitle();
        tirer(centre(), 30, 0);
        int[] deplacee = banc.imageAchevee().codes;
        double x = sphere(0).getCentre().x;
        attendre("un point dans le titre", () -> banc.cadre.getTitle().equals(titre + " •"));
        banc.frapper(KeyEvent.VK_F5);
        attendre("relue", () -> !banc.controleur.etat.enCours);
        banc.attendreCodes("F5 garde le déplacement", deplacee);
        ecrire(BLEUE);
        attendre("une autre couleur, à la place d'avant", () -> sphere(0).getKd().b == 0.9 && sphere(0).getCentre().x == x);
        ecrire(BLEUE.replace("centre=0 0.2 6", "centre=0.3 0.2 6"));
        banc.attendreMessage("scène relue : son fichier a changé la place");
        fermerLeMessage();
        banc.attendreImage("celle du fichier", attendue(L, H));
        attendre("plus de point", () -> banc.cadre.getTitle().equals(titre));
        banc.frapperCtrl('z');
        attendre("Ctrl+Z la déplace de nouveau", () -> sphere(0).getCentre().x == x && sphere(0).getKd().b == 0.9);
        attendre("le point revient", () -> banc.cadre.getTitle().equals(titre + " •"));
        ecrire(BLEUE.replace("centre=0 0.2 6", "centre=" + x + " " + sphere(0).getCentre().y + " 6"));
        attendre("mise dans le fichier, elle n'est plus déplacée", () -> !banc.controleur.etat.estDeplace());
        assertEquals("", banc.message());
    }

    @Test
    void deplacementsReglagesEtVuesSeDefontEtSeRefontMemeApresF5() throws Exception {
        int[] depart = ouvrir().codes;
        tirer(centre(), 30, 0);
        int[] deplacee = banc.imageAchevee().codes;
        banc.frapper(KeyEvent.VK_SUBTRACT);
        attendre("deux réflexions", () -> banc.resume.getText().contains("2 réflexions"));
        int[] reglee = banc.imageAchevee().codes;
        faire(((JMenu) article(1, "Vue")).getItem(1)::doClick);
        attendre("la vue", () -> banc.resume.getText().contains("vue normales"));
        int[] vue = banc.imageAchevee().codes;
        banc.frapper(KeyEvent.VK_F5);
        attendre("relue", () -> banc.controleur.etat.enCours);
        banc.attendreCodes("F5 ne change rien", vue);
        for (int[] avant : new int[][] {reglee, deplacee, depart}) {
            banc.frapperCtrl('z');
            banc.attendreCodes("défait", avant);
        }
        attendre("rien de plus à défaire", () -> !article("Défaire").isEnabled());
        for (int[] apres : new int[][] {deplacee, reglee, vue}) {
            banc.frapper(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_Z);
            banc.attendreCodes("refait", apres);
        }
        attendre("rien de plus à refaire", () -> !article("Refaire").isEnabled() && article("Défaire").isEnabled());
    }

    @Test
    void depuisLImageUneFlecheMeneAuPixelVoisinEtCtrlHautGrossit() throws Exception {
        ouvrir();
        cliquer(160, 120);
        EssaiInspecteur.attendreTitre(160, 120);
        assertTrue(surFilEvenements(banc.panneau::isFocusOwner), "le clavier est à l'image");
        banc.frapper(KeyEvent.VK_RIGHT);
        EssaiInspecteur.attendreTitre(161, 120);
        banc.frapper(KeyEvent.VK_CONTROL, KeyEvent.VK_UP);
        attendre("grossie", () -> banc.panneau.getReduction(banc.panneau.montree) == 2);
    }

    @Test
    void leCielNeSePrendPasEtLaFenetreLeDit() throws Exception {
        ouvrir();
        saisir(new Point(30, 20));
        // cet avis s'efface au bout de quelques secondes
        banc.attendreMessage("rien à prendre ici");
        glisser(new Point(30, 20), 30, 30);
        assertFalse(surFilEvenements(() -> banc.controleur.etat.estDeplace()));
    }

    @Test
    void chaqueVueEstCelleDeLaLigneDeCommandeEtDitSaValeurSousLaSouris() throws Exception {
        ouvrir();
        JMenu vues = (JMenu) article(1, "Vue");
        String[] dits = {"N = .*", "d = \\d+\\.\\d+", "lampes : \\d", "rayons : \\d+", "écart : \\d+\\.\\d\\d niveaux"};
        for (int k = 0; k < dits.length; k++) {
            String nom = Options.VUES.get(k);
            int rang = k;
            faire(vues.getItem(k + 1)::doClick);
            banc.attendreImage(nom, attendue("--vue=" + nom));
            attendre("elle se dit", () -> banc.resume.getText().startsWith("vue " + nom + " : "));
            banc.viser(banc.panneau, banc.panneau.getWidth() / 2 + k % 2, banc.panneau.getHeight() / 2);
            attendre("sa valeur sous la souris", () -> banc.pixel.getText().matches("pixel .* " + dits[rang]));
        }
        faire(vues.getItem(1)::doClick);
        attendre("une autre vue", () -> banc.resume.getText().startsWith("vue normales"));
        banc.viser(banc.panneau, (banc.panneau.getWidth() - L) / 2 + 5, (banc.panneau.getHeight() - H) / 2 + 5);
        attendre("le ciel se dit", () -> banc.pixel.getText().endsWith(" ciel"));
        faire(vues.getItem(0)::doClick);
        banc.attendreImage("et l'on revient à l'image", attendue(L, H));
    }

    @Test
    void laDifferenceSeFaitAvecLImageDAvantSIlYEnAUne() throws Exception {
        ImageMemoire avant = ouvrir();
        banc.frapper(KeyEvent.VK_SUBTRACT);
        attendre("deux réflexions", () -> banc.resume.getText().contains("2 réflexions"));
        ImageMemoire apres = banc.imageAchevee();
        faire(((JMenu) article(1, "Vue")).getItem(Options.VUES.indexOf("difference") + 1)::doClick);
        attendre("la vue", () -> banc.resume.getText().contains("vue difference"));
        ImageMemoire vue = banc.imageAchevee();
        for (int k = 0; k < vue.codes.length; k++) {
            double pire = 0;
            for (int c = 3 * k; c < 3 * k + 3; c++) {
                pire = Math.max(pire, Math.abs(Math.min(1, avant.lineaire[c]) - Math.min(1, apres.lineaire[c])));
            }
            assertEquals(255 * pire, vue.lineaire[3 * k], 1e-3, "pixel " + k);
        }
    }

    @Test
    void leBrouillonDUneTresGrandeImageEstPrecedeDUnApercuALaTailleDeLEcran() throws Exception {
        banc = new BancFenetre(new MainLent("--taille=6400x4800", scene.toString()));
        attendre("un aperçu", () -> banc.panneau.apercu != null || banc.panneau.montree != null);
        ImageMemoire apercu = surFilEvenements(() -> banc.panneau.apercu);
        assertTrue(apercu == null || apercu.largeur < 1300, "à la taille de l'écran");
        attendre("le brouillon le remplace", () -> banc.panneau.montree != null && banc.panneau.apercu == null);
    }
}
