package lancer.fenetre;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.JTree;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lancer;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.commande.Option;
import lancer.essai.Plan;
import lancer.image.ImageMemoire;
import lancer.scene.SceneLue;
import org.junit.jupiter.api.Test;

/** La fenêtre entière, à l'écran : une image qui vient, une leçon du clic à l'écriture, et des fils qu'elle n'attend jamais. */
class FenetreTest extends EssaiFenetre {

    private static final int MAGENTA = 0xFFFF00FF;

    @Test
    void leBrouillonPuisLImageParaissentPuisCelleDuFichierEnregistreEtFermerNeLaisseAucunFil() throws Exception {
        ImageMemoire brouillon = new ImageMemoire(L, H, false);
        new Lancer(new Scene(scene.toString()), new Camera(L, H)).TracerBrouillon(brouillon, Constantes.REFLETS_BROUILLON, 1);
        MainLent lent = lente();
        lent.lent = true;
        ouvrir(lent);
        // le dernier pavé : l'image, ralentie, en est loin
        int[] bas = Arrays.copyOfRange(brouillon.codes, (H - 16) * L, H * L);
        attendre("le brouillon est à l'écran", () -> trouver(bas) != null);
        assertTrue(etat().enCours());
        assertNull(etat().getImageEntiere());
        main.lent = false;
        attendreImage("l'image le remplace", attendue());
        assertEquals("lancer — boule.ini", cadre.getTitle());
        assertEquals("", main.sortie.toString());
        assertEquals(4, cadre.getIconImages().size());
        // à la manière des éditeurs qui renomment, et à taille égale
        Path nouveau = dossier.resolve("boule.ini.tmp");
        Files.write(nouveau, BLEUE.getBytes("UTF-8"));
        Files.move(nouveau, scene, StandardCopyOption.REPLACE_EXISTING);
        attendreImage("la boule est bleue", attendue());
        main.lent = true;
        frapper(KeyEvent.VK_F5);
        attendre("le brouillon est fait", () -> main.brouillonFait);
        fermer();
        assertFalse(surFilEvenements(cadre::isDisplayable));
        attendre("plus aucun fil du programme", () -> !vivent("lancer-"));
    }

    @Test
    void cliquerTaperTirerDefaireEcrireEtQuitter() throws Exception {
        ouvrir();
        cliquer(panneau, place(160, 110).x, place(160, 110).y);
        attendreTexte("verdict", "Au bit près, la couleur du pixel dessiné : #");
        assertEquals("[Sphere 1] ligne 1", composant("section", JLabel.class).getText());
        JTextField rayon = composant("rayon", JTextField.class);
        faire(rayon::selectAll);
        frapper(rayon, KeyEvent.VK_1);
        frapper(rayon, KeyEvent.VK_UP);
        frapper(rayon, KeyEvent.VK_SHIFT, KeyEvent.VK_DOWN);
        attendreMessage(scene + ", ligne 3, [Sphere 1], rayon : hors limites : « -8 »");
        frapper(rayon, KeyEvent.VK_SHIFT, KeyEvent.VK_UP);
        attendre("deux, et l'image", () -> sphere().getRayon() == 2 && !etat().enCours());
        JTextField ns = composant("ns", JTextField.class);
        faire(ns::selectAll);
        frapper(ns, KeyEvent.VK_7);
        frapper(ns, KeyEvent.VK_TAB);
        attendre("quitté, un champ est pris", () -> etat().demande.lue.getSection("Sphere 1").mot("ns", null).equals("7"));
        Point de = place(160, 110);
        tirer(de, 30, -20);
        attendre("elle suit la souris", () -> sphere().getCentre().x > 0.1 && sphere().getCentre().y > 0.2);
        attendre("un point dans le titre", () -> cadre.getTitle().equals("lancer — boule.ini •"));
        frapperCtrl('z');
        attendre("elle revient", () -> sphere().getCentre().x == 0);
        tirer(de, 40, 0);
        lancer.Point voulu = sphere().getCentre();
        frapperCtrl('e');
        attendre("tout est écrit", () -> cadre.getTitle().equals("lancer — boule.ini"));
        attendreMessage("écrit dans boule.ini");
        assertEquals(ROUGE.replace("rayon=1", "rayon=2").replace("ns=40", "ns=7").replace("0 0.2 6", SceneLue.ecrire(voulu)), lu());
        attendreCodes("l'image est celle du fichier", attendue());
        String ecrit = lu();
        tirer(de, 20, 0);
        for (String reponse : new String[] {"Rester", "Oublier"}) {
            assertTrue(cadre.isDisplayable());
            frapperCtrl('q');
            JOptionPane question = composant(null, JOptionPane.class);
            assertEquals("Ce qui est changé dans « boule.ini » n'y est pas écrit.", question.getMessage());
            faire(() -> question.setValue(reponse));
            attendre("la question est fermée", () -> !question.isShowing());
        }
        attendre("fermée", () -> !cadre.isDisplayable());
        assertEquals(ecrit, lu());
    }

    private Sphere sphere() {
        return (Sphere) etat().demande.lue.objets.get(0);
    }

    /** Tire, Maj tenue. */
    private void tirer(Point de, int dx, int dy) throws Exception {
        Point ou = viser(panneau, de.x, de.y);
        robot.keyPress(KeyEvent.VK_SHIFT);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        for (int k = 1; k <= 4; k++) {
            robot.mouseMove(ou.x + dx * k / 4, ou.y + dy * k / 4);
            robot.waitForIdle();
        }
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        robot.keyRelease(KeyEvent.VK_SHIFT);
        robot.waitForIdle();
    }

    @Test
    void leFilDesEvenementsNAttendNiLaLectureNiLaPreparationNiLeDessin() throws Exception {
        ouvrir();
        main.lent = true;
        for (String etape : new String[] {"dessin ", "préparation ", "lecture "}) {
            main.avantDessin = etape.startsWith("p") ? this::retenir : () -> { };
            main.avantLecture = etape.startsWith("l") ? this::retenir : () -> { };
            frapper(KeyEvent.VK_F5);
            attendreTexte("resume", etape);
            for (int k = 0; k < 50; k++) {
                surFilEvenements(() -> null);
            }
            assertTrue(etat().enCours(), "rien n'a eu à finir pour cela");
            frapper(KeyEvent.VK_ESCAPE);
            attendre("arrêté", () -> !etat().enCours());
            attendre("aucun fil ne dessine", () -> !vivent("lancer-1"));
        }
        assertEquals(1, suite.getCount());
        suite.countDown();
        main.lent = false;
        frapper(KeyEvent.VK_F5);
        attendreImage("et tout se remet en marche", attendue());
    }

    @Test
    void unePanneSeLitPuisUnPixelQuiEchoueEstMagentaEtSaFauteSeRaconte() throws Exception {
        MainLent fautif = lente();
        fautif.avantDessin = () -> {
            throw new IllegalStateException("objet\nmal fait");
        };
        fautif.apresLecture = lue -> lue.objets.add(new Plan(new lancer.Point(0, 0, 50), new Vecteur(0, 0, -1)) {
            @Override
            public Couleur getColor(Scene celle, Rayon incident, PointContact contact, int profondeur) {
                if (contact.y < -8) {
                    throw new IllegalStateException("boum");
                }
                return new Couleur(0.5);
            }
        });
        ouvrir(fautif);
        attendreMessage("échec du programme : java.lang.IllegalStateException: objet\\nmal fait");
        main.avantDessin = () -> { };
        frapper(KeyEvent.VK_F5);
        int[] codes = imageAchevee().codes;
        int premier = IntStream.range(0, codes.length).filter(k -> codes[k] == MAGENTA).findFirst().getAsInt();
        long fautifs = Arrays.stream(codes).filter(code -> code == MAGENTA).count();
        assertTrue(fautifs > 100 && Arrays.stream(codes).anyMatch(code -> code == 0xFF808080), "le mur se voit ailleurs");
        attendreMessage(fautifs + " pixels n'ont pu être calculés ; le premier : pixel " + premier % L + ", " + premier / L + " de "
                + scene + " : java.lang.IllegalStateException: boum (");
        frapperCtrl('s');
        JTextArea message = composant("message", JTextArea.class);
        attendre("elle ne s'enregistre pas", () -> delier(message.getText()).contains("\nImage non enregistrée : " + fautifs));
        cliquer(message, 5, 5);
        cliquer(panneau, place(premier % L, premier / L).x, place(premier % L, premier / L).y);
        JTree recit = composant("recit", JTree.class);
        attendre("la chaîne va jusqu'à la faute", () -> lu(recit).contains("\néchec : java.lang.IllegalStateException: boum ("));
        attendreTexte("verdict", "Ce pixel n'a pu être calculé.");
        cliquer(recit, 40, 10);
        attendre("un clic dans le récit laisse le clavier à l'image", panneau::isFocusOwner);
        frapper(KeyEvent.VK_RIGHT);
        attendre("les flèches y vont", () -> lu(recit).startsWith("pixel " + (premier % L + 1) + ", "));
    }

    /** Les pixels qui sont là restent, et le dessin suivant se fait. */
    @Test
    void unObjetQuiNeRendJamaisLaMainSArreteParEchapEtLeDessinSuivantSeFait() throws Exception {
        MainLent boucle = new MainLent("--fils=2", TAILLE, scene.toString());
        AtomicBoolean retenu = new AtomicBoolean(true);
        AtomicInteger retenus = new AtomicInteger();
        boucle.apresLecture = lue -> lue.objets.add(new Sphere(new lancer.Point(0, 0.2, 9), 3) {
            @Override
            public Vecteur getNormale(lancer.Point contact) {
                if (retenu.get() && boucle.brouillonFait) {
                    retenus.incrementAndGet();
                    retenir();
                }
                return super.getNormale(contact);
            }
        });
        ouvrir(boucle);
        attendre("le brouillon est montré, et l'image retenue", () -> etat().montre.dessin != null && retenus.get() > 1);
        frapper(KeyEvent.VK_ESCAPE);
        attendre("Échap l'arrête", () -> !etat().enCours());
        assertTrue(Arrays.stream(etat().montre.dessin.image.codes).anyMatch(code -> code != 0), "les pixels qui sont là restent");
        retenu.set(false);
        frapper(KeyEvent.VK_F5);
        int[] codes = imageAchevee().codes.clone();
        suite.countDown();
        attendre("les fils retenus s'en vont", () -> !vivent("lancer-1") && !vivent("lancer-2"));
        assertArrayEquals(codes, surFilEvenements(() -> etat().getImageEntiere()).codes);
    }

    @Test
    void f3MesureEchapArreteEtUnPointSePrendAuClavier() throws Exception {
        // une petite image est assez dessinée en un instant ; paire, aucune ligne n'y est à l'horizon
        ouvrir(new MainLent("--taille=100x76", "--reflets=7", scene.toString()));
        imageAchevee();
        frapper(KeyEvent.VK_F3);
        attendreTexte("vitesse.etat", "mesure en cours : ");
        frapper(KeyEvent.VK_ESCAPE);
        attendreTexte("vitesse.etat", "arrêtée : ");
        frapper(KeyEvent.VK_F3);
        attendre("tout est mesuré", () -> !etat().mesures.essais.isEmpty()
                && etat().direLesMesures().matches("(Les flèches|La machine est occupée).*"));
        assertTrue(etat().mesures.essais.containsKey(etat().demande.reglages), "le réglage de l'image aussi");
        frapper(KeyEvent.VK_RIGHT);
        JTextArea dit = composant("vitesse.etat", JTextArea.class);
        attendre("une flèche désigne un point", () -> delier(dit.getText()).contains(" réflexion"));
        int reflets = Integer.parseInt(surFilEvenements(dit::getText).replaceFirst("(?s).*, (\\d+) réflexion.*", "$1"));
        frapper(KeyEvent.VK_ENTER);
        attendre("Entrée le prend", () -> etat().demande.reglages.get(Option.REFLETS) == reflets);
        assertTrue(etat().mesures.essais.values().stream().allMatch(essai -> essai.suffit() && essai.durees.getMediane() > 0));
    }
}
