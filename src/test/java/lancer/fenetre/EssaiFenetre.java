package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.faire;
import static lancer.fenetre.BancFenetre.pixelsSansFenetre;
import static lancer.fenetre.BancFenetre.surFilEvenements;

import java.awt.image.BufferedImage;
import java.io.File;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.CountDownLatch;
import javax.swing.JFileChooser;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.SwingUtilities;
import lancer.image.ImageMemoire;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Une fenêtre du programme sur un vrai écran, et une petite scène à lui donner. */
@Tag("fenetre")
@Timeout(900)
abstract class EssaiFenetre {

    static final int L = 320;
    static final int H = 240;
    static final String TAILLE = "--taille=" + L + "x" + H;
    static final String ROUGE = "[Sphere 1]\ncentre=0 0.2 6\nrayon=1\nKd=0.9 0.15 0.1\nKs=0.3 0.3 0.3\nns=40\n"
            + "[Sphere 2]\ncentre=-1.2 -0.6 5\nrayon=0.5\nKd=0.1 0.6 0.2\nKs=0.2 0.2 0.2\nns=10\n"
            + "[Lampe 1]\nposition=-4 6 -3\ncouleur=0.9 0.9 0.85\n";
    static final String BLEUE = ROUGE.replace("0.9 0.15 0.1", "0.1 0.2 0.9");
    static final String FAUTIVE = ROUGE.replace("rayon=1\n", "rayon=-1\n");

    @TempDir
    Path dossier;
    Path scene;
    BancFenetre banc;
    /** Ce que l'essai retient repart avec elle, et au plus tard à sa fin : aucun fil ne reste aux essais suivants. */
    final CountDownLatch suite = new CountDownLatch(1);

    @BeforeEach
    void ecrireLaScene() throws Exception {
        scene = dossier.resolve("boule.ini");
        ecrire(ROUGE);
    }

    @AfterEach
    void fermer() throws Exception {
        suite.countDown();
        if (banc != null) {
            banc.fermer();
        }
    }

    void ecrire(String texte) throws Exception {
        Files.write(scene, texte.getBytes(StandardCharsets.UTF_8));
    }

    /** Les arguments du programme, la scène la dernière. */
    String[] args(String... options) {
        String[] args = Arrays.copyOf(options, options.length + 2);
        args[options.length] = TAILLE;
        args[options.length + 1] = scene.toString();
        return args;
    }

    MainLent lente(String... options) {
        return new MainLent(args(options));
    }

    int[] attendue(int largeur, int hauteur) throws Exception {
        return pixelsSansFenetre(dossier, scene, largeur, hauteur);
    }

    /** L'image que ces options donnent de la scène. */
    int[] attendue(String... options) throws Exception {
        return pixelsSansFenetre(dossier, scene, L, H, options);
    }

    /** Ouvre la fenêtre sur la scène, et attend son image. */
    ImageMemoire ouvrir(String... options) throws Exception {
        banc = new BancFenetre(lente(options));
        return banc.imageAchevee();
    }

    /** Clique sur ce pixel de l'image. */
    void cliquer(int x, int y) throws Exception {
        banc.cliquer(banc.panneau, (banc.panneau.getWidth() - L) / 2 + x, (banc.panneau.getHeight() - H) / 2 + y);
    }

    /** Choisit ce fichier dans le dialogue qui s'ouvre ; rend le nom qui était proposé. */
    String choisir(Path fichier) throws Exception {
        JFileChooser choix = composant(null, JFileChooser.class);
        // comme quelqu'un : d'abord le clavier est au dialogue, et ce qui fut frappé avant ne va plus à la fenêtre
        attendre("le clavier est au dialogue", () -> SwingUtilities.getWindowAncestor(choix).isFocused());
        String propose = surFilEvenements(() -> {
            File selection = choix.getSelectedFile();
            choix.setSelectedFile(fichier.toFile());
            choix.approveSelection();
            return selection == null ? null : selection.getName();
        });
        attendre("le dialogue est fermé", () -> !choix.isShowing());
        return propose;
    }

    /** Ferme le message, qui couvre le bas de l'image. */
    void fermerLeMessage() throws Exception {
        // le haut : il y reste, même si une ligne de plus l'agrandit pendant ce temps
        banc.cliquer(banc.bandeau, 5, 5);
        banc.attendreMessage("");
    }

    /** Donne cette taille à la place de l'image. */
    void retailler(int largeur, int hauteur) throws Exception {
        faire(() -> {
            banc.cadre.setSize(banc.cadre.getWidth() + largeur - banc.panneau.getWidth(),
                    banc.cadre.getHeight() + hauteur - banc.panneau.getHeight());
            banc.cadre.validate();
        });
    }

    /** Ce que la fenêtre montre à la place de l'image. */
    BufferedImage peinte() throws Exception {
        return surFilEvenements(() -> {
            BufferedImage image = new BufferedImage(banc.panneau.getWidth(), banc.panneau.getHeight(), BufferedImage.TYPE_INT_RGB);
            banc.panneau.paint(image.createGraphics());
            return image;
        });
    }

    /** Cet article du menu Dessin. */
    JMenuItem article(String nom) {
        return article(2, nom);
    }

    /** Cet article de ce menu. */
    JMenuItem article(int menu, String nom) {
        JMenu dessin = banc.cadre.getJMenuBar().getMenu(menu);
        for (int k = 0; k < dessin.getItemCount(); k++) {
            if (dessin.getItem(k) != null && dessin.getItem(k).getText().equals(nom)) {
                return dessin.getItem(k);
            }
        }
        throw new AssertionError("pas d'article " + nom);
    }

    /** Attend la suite sans être interrompu, comme un disque lent ou une boucle sans fin. */
    void retenir() {
        attendreSansEtreInterrompu(suite);
    }

    static void attendreSansEtreInterrompu(CountDownLatch loquet) {
        while (true) {
            try {
                loquet.await();
                return;
            } catch (InterruptedException e) {
                // Échap n'arrête pas ce fil
            }
        }
    }
}
