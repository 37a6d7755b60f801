package lancer.fenetre;

import java.awt.AWTError;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.Toolkit;
import java.io.PrintStream;
import java.lang.reflect.InvocationTargetException;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.ExecutorService;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import lancer.commande.Echec;
import lancer.commande.Messages;
import lancer.commande.Options;
import lancer.dessin.Demande;
import lancer.dessin.Dessin;
import lancer.dessin.Lecture;
import lancer.scene.Services;

/** Ouverture de la fenêtre : lecture de la première scène, vérification de l'écran, début du dessin. */
public final class Ouverture {

    /** Temps laissé à la lecture de la première scène avant l'ouverture de la fenêtre. */
    private static final long PATIENCE_MS = 400;

    private Ouverture() {
    }

    /**
     * Ouvre la fenêtre sur la scène demandée, et revient après la lecture de cette scène.
     *
     * @param lecteur lit une scène, et dit la part lue du fichier, de 0 à 1
     * @param programme dessine une demande, et donne le dessin quand il commence, puis quand son brouillon est fini
     * @param erreur sortie des avertissements de la première scène
     * @param fin appelé à la fermeture de la fenêtre, dans un autre fil
     * @throws lancer.SceneFautive si la scène ne peut être utilisée ; aucune fenêtre n'est alors ouverte
     * @throws Echec s'il n'y a pas d'écran
     */
    public static Fenetre ouvrir(Options options, BiFunction<String, DoubleConsumer, Lecture> lecteur,
            BiConsumer<Demande, Consumer<Dessin>> programme, PrintStream erreur, Runnable fin) {
        Tracage.Moteur moteur = new Tracage.Moteur(options, lecteur, programme);
        // AWT lit la langue une seule fois, pour les menus et les dialogues
        Locale.setDefault(Locale.FRANCE);
        String manque = getManque();
        if (manque != null) {
            if (options.scene != null) {
                // une faute de la scène est plus utile à dire que l'absence d'écran
                new Demande(lecteur.apply(options.scene, part -> { }), options);
            }
            throw Echec.machine(manque + ", ou --image FICHIER.png");
        }
        // avec un seul fil, un dessin abandonné finit d'écrire avant le début du suivant
        ExecutorService dessins = Controleur.unFil("lancer-dessin");
        Tracage premier = options.scene == null ? null : new Tracage(moteur, options.scene, null, null, null,
                new Dimension(options.largeur, options.hauteur),
                PanneauImage.dans(Dialogues.ecran().getSize(), options.largeur, options.hauteur));
        if (premier != null) {
            // le dessin n'attend pas la fenêtre, plus longue à ouvrir que le brouillon à dessiner
            premier.entracte = premier::attendreDEtreVu;
            dessins.execute(premier);
            premier.attendreLecture(PATIENCE_MS);
        }
        Fenetre[] ouverte = new Fenetre[1];
        try {
            EventQueue.invokeAndWait(() -> {
                Apparence.preparer();
                List<String> variantes = Services.nomsDesVariantes();
                ouverte[0] = new Fenetre(moteur, variantes, dessins, fin);
                new Menus(ouverte[0], variantes);
                ouverte[0].commencer(premier);
            });
        } catch (InvocationTargetException e) {
            throw Echec.machine(Messages.message(e.getCause()));
        } catch (InterruptedException e) {
            throw Echec.machine("interrompu");
        }
        if (premier != null) {
            try {
                premier.attendreLecture(Long.MAX_VALUE);
            } catch (RuntimeException | Error e) {
                EventQueue.invokeLater(ouverte[0]::abandonner);
                throw e;
            }
            if (premier.getLu() != null) {
                Messages.avertir(premier.getLue().avertissements, erreur);
            }
        }
        return ouverte[0];
    }

    /** Ce qui manque pour ouvrir une fenêtre, ou {@code null}. */
    private static String getManque() {
        // sous X11, DISPLAY nomme un écran ; à demander avant AWT, qui peut changer cette propriété
        boolean nomme = !System.getenv().getOrDefault("DISPLAY", "").isEmpty()
                && System.getProperty("java.awt.headless") == null;
        try {
            if (!GraphicsEnvironment.isHeadless()
                    && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0) {
                // à appeler dans ce fil : le bureau reconnaît la fenêtre à la classe principale de ce fil
                Toolkit.getDefaultToolkit();
                return null;
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
}
