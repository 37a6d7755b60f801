package lancer.fenetre;

import java.awt.AWTError;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.Toolkit;
import java.io.PrintStream;
import java.lang.reflect.InvocationTargetException;
import java.util.Locale;
import java.util.concurrent.ExecutorService;
import java.util.function.Consumer;
import lancer.commande.Echec;
import lancer.commande.Options;
import lancer.commande.Pannes;
import lancer.dessin.Dessin;
import lancer.scene.Services;

/** Chemin de la commande à la fenêtre : lire la première scène, s'assurer d'un écran, et commencer à dessiner. */
public final class Ouverture {

    /** Temps laissé à une scène pour se lire, ou se refuser, avant qu'une fenêtre ne s'ouvre pour le dire. */
    private static final long PATIENCE_MS = 400;

    private Ouverture() {
    }

    /**
     * Ouvre la fenêtre sur la scène demandée, et revient une fois celle-ci lue.
     *
     * @param dessin le premier, qui est à lire, s'il a un fichier
     * @param erreur où dire ce que cette première scène a de laissé de côté
     * @param fin ce que fait sa fermeture, dans un autre fil
     * @throws lancer.SceneFautive si la scène ne peut être utilisée ; rien n'est ouvert
     * @throws Echec s'il n'y a pas d'écran
     */
    public static Fenetre ouvrir(Options options, Dessin dessin, Consumer<Dessin> programme, PrintStream erreur,
            Runnable fin) {
        // avant qu'AWT ne se charge : ce que Java écrit lui-même, des touches des menus aux dialogues
        Locale.setDefault(Locale.FRANCE);
        if (!ecranPresent()) {
            if (dessin.fichier != null) {
                // ce que la scène a de fautif d'abord
                dessin.lire();
            }
            throw Echec.panne("pas d'écran pour ouvrir une fenêtre ; attendu : un écran, ou --image FICHIER.png");
        }
        // un seul fil, donc une image à la fois : la suivante attend là que celle qu'on abandonne ait fini d'écrire
        ExecutorService dessins = Controleur.unFil("lancer-dessin");
        Tracage premier = dessin.fichier == null ? null : new Tracage(programme, dessin, null,
                PanneauImage.dans(Dialogues.ecran().getSize(), dessin.largeur, dessin.hauteur), options.fils);
        if (premier != null) {
            // sans attendre la fenêtre, plus longue à ouvrir que le brouillon à dessiner
            dessin.setEntracte(premier::attendreDEtreVu);
            dessins.execute(premier);
            premier.attendreLecture(PATIENCE_MS);
        }
        Fenetre[] ouverte = new Fenetre[1];
        try {
            EventQueue.invokeAndWait(() -> {
                Apparence.preparer();
                ouverte[0] = new Fenetre(options, dessin, programme, Services.nomsDesVariantes(), dessins, fin);
                ouverte[0].commencer(premier);
            });
        } catch (InvocationTargetException e) {
            throw Echec.panne(Pannes.message(e.getCause()));
        } catch (InterruptedException e) {
            throw Echec.panne("interrompu");
        }
        if (premier != null) {
            try {
                premier.attendreLecture(Long.MAX_VALUE);
            } catch (RuntimeException | Error e) {
                EventQueue.invokeLater(ouverte[0]::abandonner);
                throw e;
            }
            if (dessin.getLue() != null) {
                Pannes.avertir(dessin.getLue().avertissements, erreur);
            }
        }
        return ouverte[0];
    }

    private static boolean ecranPresent() {
        try {
            boolean present = !GraphicsEnvironment.isHeadless()
                    && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
            // dès ce fil : le bureau reconnaît la fenêtre à la classe d'où part celui qui ouvre l'écran
            Toolkit.getDefaultToolkit();
            return present;
        } catch (HeadlessException | AWTError | LinkageError e) {
            // un DISPLAY sans serveur derrière, ou un Java sans ses bibliothèques d'écran
            return false;
        }
    }
}
