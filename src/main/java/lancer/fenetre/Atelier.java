package lancer.fenetre;

import java.awt.EventQueue;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Consumer;
import javax.swing.JFrame;
import lancer.Lancer;
import lancer.commande.Pannes;
import lancer.dessin.ReglagesDessin;
import lancer.sortie.ImageMemoire;

/** Ce que la fenêtre offre à ce qui s'ouvre à côté d'elle ; tout s'appelle, et répond, dans le fil des événements. */
interface Atelier {

    /** Le cadre, à côté de qui s'ouvrir. */
    JFrame getCadre();

    /** Les réglages de la scène montrée, que son dessin soit achevé ou non ; {@code null} avant la première. */
    ReglagesDessin getReglages();

    /**
     * Dessine la scène montrée avec ces réglages ; ce qui se dessinait est abandonné.
     *
     * @param suite vrai si ce n'est que la suite d'un même geste : l'image « d'avant » reste alors celle d'avant lui
     */
    void dessiner(ReglagesDessin reglages, boolean suite);

    /** La commande qui dessine la scène montrée avec ces réglages, sections changées mises dans son fichier. */
    String getCommande();

    /** Vrai tant qu'un dessin est en cours, lecture et préparation comprises. */
    boolean enCours();

    /** L'image montrée si elle est achevée ; {@code null} tant qu'un dessin est en cours, ou s'il a été arrêté. */
    ImageMemoire getImageComplete();

    /** Ce qui a dessiné l'image achevée ou la dessine, scène préparée comprise ; {@code null} s'il n'y en a pas. */
    Lancer getLancer();

    /** Nombre de fils d'un dessin. */
    int getFils();

    /** Un fil à part, où les tâches attendent leur tour ; il ne retient pas le programme. */
    static ExecutorService unFil(String nom) {
        return Executors.newSingleThreadExecutor(tache -> {
            Thread fil = new Thread(tache, nom);
            fil.setDaemon(true);
            return fil;
        });
    }

    /**
     * Donne une tâche à ce fil.
     *
     * @param siPanne reçoit, dans le fil des événements, ce qui l'a empêchée ; rien si c'est qu'elle a été arrêtée
     */
    static Future<?> confier(ExecutorService fil, Runnable tache, Consumer<String> siPanne) {
        return fil.submit(() -> {
            try {
                tache.run();
            } catch (CancellationException e) {
                // ce qu'elle calculait n'est plus demandé
            } catch (RuntimeException | Error e) {
                EventQueue.invokeLater(() -> siPanne.accept(Pannes.message(e)));
            }
        });
    }

    /** Appelle {@code siChange} chaque fois qu'un dessin commence, s'achève ou s'arrête, et qu'une scène est lue. */
    void prevenir(Runnable siChange);
}
