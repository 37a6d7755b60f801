package lancer.fenetre;

import java.awt.AWTError;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.Toolkit;
import java.io.File;
import java.io.PrintStream;
import java.lang.reflect.InvocationTargetException;
import java.util.Locale;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import lancer.commande.Echec;
import lancer.commande.Messages;
import lancer.commande.Reglages;
import lancer.dessin.Demande;
import lancer.dessin.Programme;
import lancer.scene.LecteurSections;
import lancer.scene.Surveillance;
import lancer.texte.ErreurSysteme;
import lancer.texte.Texte;

/** Ouverture de la fenêtre : lecture de la première scène, vérification de l'écran, début du dessin. */
public final class Ouverture {

    /** La profondeur d'écran que Java ne connaît pas, en bits. */
    private static final int BITS_DE_TROP = 30;

    private Ouverture() {
    }

    /**
     * Ouvre la fenêtre sur la scène demandée, et revient après la lecture de cette scène.
     *
     * @param erreur sortie des avertissements de la première scène
     * @param fin appelé à la fermeture de la fenêtre, dans un autre fil
     * @throws lancer.SceneFautive si la scène ne peut être utilisée ; aucune fenêtre n'est alors ouverte
     * @throws Echec s'il n'y a pas d'écran
     */
    public static Fenetre ouvrir(Reglages options, Programme programme, PrintStream erreur, Runnable fin) {
        // AWT lit la langue une seule fois, pour les menus et les dialogues
        Locale.setDefault(Locale.FRANCE);
        String manque = getManque();
        if (manque != null) {
            if (options.scene != null) {
                // une faute de la scène est plus utile à dire que l'absence d'écran
                new Demande(programme.lire(options.scene, part -> { }), options);
            }
            throw Echec.machine(manque + ", ou --image FICHIER.png");
        }
        // pendant que la scène se lit ici
        FutureTask<Void> apparence = new FutureTask<>(Apparence::preparer, null);
        EventQueue.invokeLater(apparence);
        String version = options.scene == null ? null : Surveillance.version(options.scene);
        Demande demande = options.scene == null ? null
                : new Demande(programme.lire(options.scene, part -> { }), options);
        Fenetre[] ouverte = new Fenetre[1];
        try {
            apparence.get();
            EventQueue.invokeAndWait(() -> {
                Travail premier = demande == null ? null : new Travail(programme, demande);
                if (premier != null) {
                    // le dessin n'attend pas la fenêtre, plus longue à ouvrir que le brouillon à dessiner
                    premier.version = version;
                    premier.execute();
                }
                ouverte[0] = new Fenetre(programme, options, LecteurSections.nomsDesVariantes(), fin);
                new Commandes(ouverte[0]);
                ouverte[0].montrer(premier);
            });
        } catch (ExecutionException e) {
            throw Echec.machine("pas de polices pour ouvrir une fenêtre : " + ErreurSysteme.cause(e)
                    + " ; attendu : les paquets fontconfig et fonts-dejavu-core, ou --image FICHIER.png");
        } catch (InvocationTargetException e) {
            throw Echec.machine(Messages.message(e.getCause()));
        } catch (InterruptedException e) {
            throw Echec.machine("interrompu");
        }
        if (demande != null) {
            demande.lue.avertissements.forEach(ligne -> Messages.avertir(ligne, erreur));
        }
        return ouverte[0];
    }

    /** Ce qui manque pour ouvrir une fenêtre, ou {@code null}. */
    private static String getManque() {
        if (!new File(System.getProperty("user.home")).isDirectory()) {
            // « ? » pour un utilisateur sans nom : Java y écrirait ses polices, dans un dossier de ce nom
            System.setProperty("user.home", System.getProperty("java.io.tmpdir"));
        }
        // sous X11, DISPLAY nomme un écran ; à demander avant AWT, qui peut changer cette propriété
        boolean nomme = !System.getenv().getOrDefault("DISPLAY", "").isEmpty()
                && System.getProperty("java.awt.headless") == null;
        try {
            if (!GraphicsEnvironment.isHeadless()
                    && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0) {
                return getManqueDeJava();
            }
        } catch (HeadlessException | AWTError e) {
            // DISPLAY sans serveur
            nomme = false;
        } catch (LinkageError e) {
            // Java sans bibliothèques graphiques
        }
        return nomme ? "ce Java ne sait pas ouvrir de fenêtre : " + System.getProperty("java.home")
                + " ; attendu : un JDK complet, par exemple le paquet default-jdk"
                : "pas d'écran pour ouvrir une fenêtre ; attendu : un écran";
    }

    /** Ce qui manque à Java, sur un écran qui répond. */
    private static String getManqueDeJava() {
        try {
            // à appeler dans ce fil : le bureau reconnaît la fenêtre à la classe principale de ce fil
            int bits = Toolkit.getDefaultToolkit().getColorModel().getPixelSize();
            return bits == BITS_DE_TROP
                    ? "écran de 30 bits, où Java ne sait pas dessiner ; attendu : un écran de 24 bits"
                    : null;
        } catch (AWTError e) {
            // une classe d'accessibilité que nomme accessibility.properties, et qui manque
            return "ce Java ne sait pas ouvrir de fenêtre : " + Texte.echappe(e.getMessage())
                    + " ; attendu : -Djavax.accessibility.assistive_technologies= devant -jar";
        }
    }
}
