package lancer.fenetre;

import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.Toolkit;
import java.io.File;
import java.io.PrintStream;
import java.lang.reflect.InvocationTargetException;
import java.util.Locale;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import lancer.commande.Messages;
import lancer.commande.Reglages;
import lancer.contrat.Cause;
import lancer.dessin.Demande;
import lancer.dessin.Programme;
import lancer.fenetre.etat.Suite;
import lancer.fenetre.moteur.Moteur;
import lancer.fenetre.vue.Apparence;
import lancer.scene.LecteurSections;
import lancer.systeme.Echec;

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
        // sur un Mac, Commande+Q ferme les fenêtres, qui demandent que faire de ce qui n'est pas écrit
        System.setProperty("apple.eawt.quitStrategy", "CLOSE_ALL_WINDOWS");
        // AWT lit la langue une seule fois, pour les menus et les dialogues
        Locale.setDefault(Locale.FRANCE);
        String manque = getManque();
        FutureTask<Integer> apparence = new FutureTask<>(Apparence::preparer);
        if (manque == null) {
            // pendant que la scène se lit ici
            EventQueue.invokeLater(apparence);
        }
        Demande demande = options.scene == null ? null
                : new Demande(programme.lire(options.scene, part -> { }), options);
        if (manque != null) {
            // après une faute de la scène, plus utile à dire
            throw Echec.machine(manque + ", ou --image FICHIER.png");
        }
        Fenetre[] ouverte = new Fenetre[1];
        int gardee = Moteur.getPolice();
        try {
            int ordinaire = apparence.get();
            int police = gardee == 0 ? ordinaire : Suite.borner(gardee);
            EventQueue.invokeAndWait(() -> {
                if (police != ordinaire) {
                    Apparence.donnerAuxTextes(police);
                }
                ouverte[0] = new Fenetre(programme, options, demande, LecteurSections.nomsDesVariantes(), police, fin);
                ouverte[0].montrer();
            });
        } catch (ExecutionException e) {
            throw Echec.machine("pas de polices pour ouvrir une fenêtre : " + Cause.dire(e)
                    + " ; attendu : les paquets fontconfig et fonts-dejavu-core, ou --image FICHIER.png");
        } catch (InvocationTargetException | InterruptedException e) {
            throw Echec.machine(Messages.message(e));
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
        String pourquoi;
        try {
            if (!GraphicsEnvironment.isHeadless()) {
                // à appeler dans ce fil : le bureau reconnaît la fenêtre à la classe principale de ce fil
                int bits = Toolkit.getDefaultToolkit().getColorModel().getPixelSize();
                return bits == BITS_DE_TROP
                        ? "écran de 30 bits, où Java ne sait pas dessiner ; attendu : un écran de 24 bits" : null;
            }
            pourquoi = System.getenv().getOrDefault("DISPLAY", "").isEmpty() ? "pas d'écran"
                    : "ce Java n'en ouvre pas, " + System.getProperty("java.home");
        } catch (Error e) {
            // DISPLAY sans serveur, Java sans bibliothèques graphiques, classe d'accessibilité qui manque
            pourquoi = Cause.dire(e);
        }
        return "impossible d'ouvrir une fenêtre : " + pourquoi
                + " ; attendu : un écran, et un JDK complet, par exemple le paquet default-jdk";
    }
}
