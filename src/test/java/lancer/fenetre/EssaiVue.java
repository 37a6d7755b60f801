package lancer.fenetre;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.image.BufferedImage;
import java.lang.reflect.Method;
import java.util.Arrays;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JMenuItem;
import javax.swing.JTextArea;
import javax.swing.JTree;
import javax.swing.KeyStroke;
import lancer.commande.Option;
import lancer.commande.Options;
import lancer.fenetre.etat.EssaiSuite;
import lancer.fenetre.etat.Etat;
import lancer.fenetre.vue.Apparence;
import lancer.fenetre.vue.Cadre;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.InvocationInterceptor;
import org.junit.jupiter.api.extension.ReflectiveInvocationContext;

/** Le vrai cadre, jamais montré, dans le fil des événements, et un moteur que l'essai mène : rien n'y est à attendre. */
@Tag("fenetre")
@ExtendWith(EssaiVue.FilDesEvenements.class)
public abstract class EssaiVue extends EssaiSuite {

    protected static final int L = 160;
    protected static final int H = 120;

    /** La taille ordinaire des textes, que rien de ce que garde l'utilisateur ne change. */
    private static final int POLICE = GraphicsEnvironment.isHeadless() ? 0 : Apparence.preparer();

    protected Cadre cadre;
    protected JComponent panneau;

    /** Fait chaque essai dans le fil des événements. */
    static final class FilDesEvenements implements InvocationInterceptor {

        @Override
        public void interceptTestMethod(Invocation<Void> essai, ReflectiveInvocationContext<Method> ou, ExtensionContext c)
                throws Throwable {
            EssaiFenetre.exigerEcran();
            Throwable[] echec = new Throwable[1];
            EventQueue.invokeAndWait(() -> {
                try {
                    essai.proceed();
                } catch (Throwable e) {
                    echec[0] = e;
                }
            });
            if (echec[0] != null) {
                throw echec[0];
            }
        }

        @Override
        public void interceptTestTemplateMethod(Invocation<Void> essai, ReflectiveInvocationContext<Method> ou, ExtensionContext c)
                throws Throwable {
            interceptTestMethod(essai, ou, c);
        }
    }

    @AfterEach
    void defaireLeCadre() throws Exception {
        if (cadre != null) {
            EventQueue.invokeAndWait(cadre::dispose);
        }
    }

    /** Fait le cadre de cette scène, et achève son image. */
    protected void ouvrir(String scene, String... autres) {
        fichier("boule.ini", scene);
        String[] args = Arrays.copyOf(autres, autres.length + 2);
        args[autres.length] = "--fils=1";
        args[autres.length + 1] = boule.toString();
        options = Options.lire(args);
        etat = Etat.vide(options.get(Option.TAILLE).x, options.get(Option.TAILLE).y, POLICE);
        montrerLaBoule();
        faireLeCadre();
    }

    protected void ouvrir() {
        ouvrir(ROUGE, "--taille=" + L + "x" + H);
    }

    protected void faireLeCadre() {
        cadre = new Cadre("lancer", etat, this::arrive);
        montrer();
        cadre.pack();
        panneau = composant("image", JComponent.class);
        placer(panneau.getWidth(), panneau.getHeight());
    }

    @Override
    protected void montrer() {
        if (cadre != null) {
            cadre.montrer(etat);
        }
    }

    /** Donne cette taille à la place de l'image. */
    protected void placer(int largeur, int hauteur) {
        panneau.setSize(largeur, hauteur);
        faire("place " + largeur + " " + hauteur);
    }

    protected <T extends Component> T composant(String nom, Class<T> classe) {
        return EssaiFenetre.contenus(cadre).stream().filter(c -> classe.isInstance(c) && nom.equals(c.getName())).map(classe::cast)
                .findFirst().orElseThrow(() -> new AssertionError("pas de " + nom));
    }

    /** Le texte d'un composant, où une espace insécable est une espace. */
    protected String dit(String nom) {
        return EssaiFenetre.delier(composant(nom, JTextArea.class).getText());
    }

    protected String pixelDit() {
        return composant("pixel", JLabel.class).getText();
    }

    protected String recit() {
        return EssaiFenetre.lu(composant("recit", JTree.class));
    }

    protected String message() {
        return composant("message", JTextArea.class).isVisible() ? dit("message") : "";
    }

    /** Choisit cet article, dans un menu ou un autre. */
    protected void choisir(String article) {
        Arrays.stream(cadre.getJMenuBar().getComponents()).flatMap(menu -> Arrays.stream(((javax.swing.JMenu) menu).getMenuComponents()))
                .filter(a -> a instanceof JMenuItem && article.equals(((JMenuItem) a).getText())).map(JMenuItem.class::cast)
                .findFirst().get().doClick();
    }

    /** Ce composant reçoit cette touche. */
    protected static void frapper(JComponent ou, String touche) {
        ou.getActionForKeyStroke(KeyStroke.getKeyStroke(touche)).actionPerformed(new java.awt.event.ActionEvent(ou, 0, touche));
    }

    /** La souris fait ceci sur ce composant. @param geste une constante de {@link MouseEvent} */
    protected static void souris(Component ou, int geste, int modificateurs, int x, int y) {
        int bouton = (modificateurs & InputEvent.BUTTON3_DOWN_MASK) != 0 ? MouseEvent.BUTTON3 : MouseEvent.BUTTON1;
        ou.dispatchEvent(new MouseEvent(ou, geste, 0, modificateurs, x, y, 1, false,
                geste == MouseEvent.MOUSE_MOVED ? MouseEvent.NOBUTTON : bouton));
    }

    /** La molette, sur l'image. */
    protected void molette(int crans, int x, int y) {
        panneau.dispatchEvent(new MouseWheelEvent(panneau, MouseEvent.MOUSE_WHEEL, 0, 0, x, y, 0, false,
                MouseWheelEvent.WHEEL_UNIT_SCROLL, 1, crans));
    }

    /** Clique sur ce pixel de l'image. */
    protected void cliquer(int x, int y) {
        Point ou = place(x, y);
        souris(panneau, MouseEvent.MOUSE_PRESSED, InputEvent.BUTTON1_DOWN_MASK, ou.x, ou.y);
        souris(panneau, MouseEvent.MOUSE_RELEASED, InputEvent.BUTTON1_DOWN_MASK, ou.x, ou.y);
    }

    /** L'endroit du panneau où se voit ce point de l'image. */
    protected Point place(double xe, double ye) {
        // la place a pu changer, et ne se dit qu'un instant plus tard
        faire("place " + panneau.getWidth() + " " + panneau.getHeight());
        lancer.Point ou = etat.ecran.loupe.placeDe(etat.getVisible().image, xe, ye);
        return new Point((int) Math.floor(ou.x), (int) Math.floor(ou.y));
    }

    /** Ce que montre ce composant. */
    protected static BufferedImage peint(JComponent composant) {
        BufferedImage image = new BufferedImage(composant.getWidth(), composant.getHeight(), BufferedImage.TYPE_INT_RGB);
        composant.paint(image.createGraphics());
        return image;
    }
}
