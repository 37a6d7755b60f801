package lancer.fenetre.moteur;

import java.awt.EventQueue;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import javax.swing.SwingWorker;
import lancer.fenetre.etat.Suite;
import lancer.fenetre.etat.Suite.Evenement;

/** Le travail d'un ordre, dans un fil à lui (cours, « Bilan intermédiaire »). Ses réponses sont des événements. */
abstract class Tache extends SwingWorker<Evenement, Void> {

    private final int numero;
    private final Consumer<Evenement> recevoir;

    Tache(int numero, Consumer<Evenement> recevoir) {
        this.numero = numero;
        this.recevoir = recevoir;
    }

    /** L'événement que fait cet échec. */
    abstract Evenement echouer(Throwable echec);

    private void repondre(Evenement reponse) {
        recevoir.accept(Suite.reponse(numero, reponse));
    }

    /** Dit ce qui s'est fait avant la fin, sans attendre comme {@link #publish}. */
    final void dire(Evenement reponse) {
        EventQueue.invokeLater(() -> repondre(reponse));
    }

    /** De même, sauf si la fin peut déjà se dire, et se dit seule. */
    final void direAvantLaFin(Evenement reponse) {
        EventQueue.invokeLater(() -> {
            if (!isDone()) {
                repondre(reponse);
            }
        });
    }

    /** Java dit les fins par paquets, parfois avant ce que {@link #dire} a dit : la fin se met derrière. */
    @Override
    protected void done() {
        EventQueue.invokeLater(this::finir);
    }

    private void finir() {
        try {
            repondre(get());
        } catch (ExecutionException e) {
            repondre(echouer(e.getCause()));
        } catch (InterruptedException | CancellationException e) {
            // arrêtée : un autre ordre l'a remplacée
        }
    }
}
