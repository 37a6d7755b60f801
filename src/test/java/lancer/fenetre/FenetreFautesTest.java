package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.event.KeyEvent;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import javax.swing.JTextArea;
import javax.swing.JPanel;
import javax.swing.JTree;
import lancer.Couleur;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.essai.Plan;
import lancer.image.ImageMemoire;
import org.junit.jupiter.api.Test;

/** Ce qui manque au dessin : une scène devenue fautive, un pixel qu'une classe ne sait pas calculer. */
class FenetreFautesTest extends EssaiInspecteur {

    private static final int MAGENTA = 0xFFFF00FF;

    /** Un mur au fond, dont la classe échoue où l'on veut ; ailleurs, il est gris. */
    private static final class Mur extends Plan {

        Mur() {
            super(new lancer.Point(0, 0, 50), new Vecteur(0, 0, -1));
        }

        @Override
        public Couleur getColor(Scene scene, Rayon incident, PointContact contact, int profondeur) {
            if (contact.y < -8) {
                throw new IllegalStateException("boum");
            }
            return new Couleur(0.5);
        }
    }

    @Test
    void unPixelQuiEchoueEstMagentaLeResteSeDessineEtLaFauteSeRaconte() throws Exception {
        banc = new BancFenetre(lente().apresLecture(lue -> lue.objets.add(new Mur())));
        ImageMemoire image = banc.imageAchevee();
        int[] codes = image.codes;
        int fautifs = 0;
        int premier = -1;
        for (int k = 0; k < codes.length; k++) {
            if (codes[k] == MAGENTA) {
                fautifs++;
                premier = premier < 0 ? k : premier;
            }
        }
        assertTrue(fautifs > 100 && fautifs < codes.length / 2, fautifs + " pixels magenta");
        assertTrue(Arrays.stream(codes).anyMatch(c -> c == 0xFF808080), "le mur se voit ailleurs");
        int dits = fautifs;
        banc.attendreMessage(dits + " pixels n'ont pu être calculés ; le premier : pixel " + premier % L + ", " + premier / L + " de "
                + scene + " : java.lang.IllegalStateException: boum (");
        assertTrue(banc.message().contains("FenetreFautesTest.java:"), banc.message());
        banc.frapperCtrl('s');
        attendre("elle ne s'enregistre pas",
                () -> BancFenetre.delier(banc.bandeau.getText()).contains("\nImage non enregistrée : " + dits));
        assertTrue(banc.message().startsWith(dits + " pixels"), "la faute se lit toujours : " + banc.message());
        // le bandeau cache le bas de l'image
        fermerLeMessage();
        cliquer(premier % L, premier / L);
        JTree recit = composant("recit", JTree.class);
        attendre("la chaîne va jusqu'à la faute", () -> lu(recit).contains("  objet 3\n")
                && lu(recit).contains("\néchec : java.lang.IllegalStateException: boum ("));
        JTextArea verdict = composant("verdict", JTextArea.class);
        attendre("le verdict", () -> verdict.getText().equals("Ce pixel n'a pu être calculé."));
    }

    /** Les pixels qui sont là restent, et le dessin suivant se fait. */
    @Test
    void unObjetQuiNeRendJamaisLaMainSArreteParEchapEtLeDessinSuivantSeFait() throws Exception {
        MainLent main = lente("--fils=2");
        AtomicBoolean retenu = new AtomicBoolean(true);
        AtomicInteger retenus = new AtomicInteger();
        banc = new BancFenetre(main.apresLecture(lue -> lue.objets.add(new Sphere(new lancer.Point(0, 0.2, 9), 3) {
            @Override
            public Vecteur getNormale(lancer.Point contact) {
                if (retenu.get() && main.brouillonFait()) {
                    retenus.incrementAndGet();
                    retenir();
                }
                return super.getNormale(contact);
            }
        })));
        attendre("le brouillon est montré, et l'image retenue", () -> banc.etat().montre.dessin != null && retenus.get() > 1);
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("Échap l'arrête", () -> !banc.etat().enCours());
        assertTrue(Arrays.stream(banc.etat().montre.dessin.image.codes).anyMatch(code -> code != 0), "les pixels qui sont là restent");
        retenu.set(false);
        banc.frapper(KeyEvent.VK_F5);
        int[] codes = banc.imageAchevee().codes.clone();
        banc.attendreMessage("");
        suite.countDown();
        attendre("les fils retenus s'en vont", () -> !BancFenetre.vivent("lancer-1") && !BancFenetre.vivent("lancer-2"));
        assertArrayEquals(codes, surFilEvenements(() -> banc.etat().getImageEntiere()).codes);
    }

    @Test
    void apresUneFauteEnregistreeLInspecteurRepondPourLImageQuiResteEtF3Aussi() throws Exception {
        int[] codes = ouvrir().codes;
        cliquer(150, 100);
        JPanel inspecteur = composant("pixel", JPanel.class);
        JTree recit = composant("recit", JTree.class);
        JTextArea verdict = composant("verdict", JTextArea.class);
        attendre("le pixel", () -> lu(recit).endsWith(couleur(codes[100 * L + 150])));
        ecrire(FAUTIVE);
        banc.attendreMessage(scene.toString());
        presser(KeyEvent.VK_SHIFT, KeyEvent.VK_LEFT);
        attendre("une flèche mène au pixel voisin", () -> lu(recit).startsWith("pixel 140, 100\n")
                && lu(recit).endsWith(couleur(codes[100 * L + 140])) && verdict.getText().startsWith("Au bit près"));
        presser(KeyEvent.VK_ESCAPE);
        attendre("il se ferme", () -> !inspecteur.isShowing());
        cliquer(160, 120);
        attendre("il rouvre sur le pixel cliqué", () -> inspecteur.isShowing() && lu(recit).startsWith("pixel 160, 120\n")
                && lu(recit).endsWith(couleur(codes[120 * L + 160])) && verdict.getText().startsWith("Au bit près"));
        banc.frapper(KeyEvent.VK_F3);
        JTextArea etat = composant("vitesse.etat", JTextArea.class);
        attendre("F3 essaie l'image montrée", () -> BancFenetre.delier(etat.getText()).matches("(mesure en cours : [1-9]|La souris).*"));
        assertFalse(surFilEvenements(() -> banc.etat().enCours()));
        assertEquals(codes, surFilEvenements(() -> banc.etat().getImageEntiere()).codes);
    }
}
