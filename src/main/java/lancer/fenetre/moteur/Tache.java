package lancer.fenetre.moteur;

import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import javax.swing.SwingWorker;
import lancer.fenetre.etat.Suite;
import lancer.fenetre.etat.Suite.Evenement;

/** Le travail d'un ordre, dans un fil à lui (cours, « Bilan intermédiaire »). Ses réponses sont des événements. */
abstract class Tache extends SwingWorker<Evenement, Evenement> {

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

    /** Ce qui s'est fait avant la fin ; d'un travail déjà fini, la fin seule se dit. */
    @Override
    protected void process(List<Evenement> reponses) {
        reponses.stream().filter(reponse -> !isDone() || seDitToujours(reponse)).forEach(this::repondre);
    }

    /** Dit si cette réponse compte même quand la tâche est finie. */
    boolean seDitToujours(Evenement reponse) {
        return true;
    }

    @Override
    protected void done() {
        try {
            repondre(get());
        } catch (ExecutionException e) {
            repondre(echouer(e.getCause()));
        } catch (InterruptedException | CancellationException e) {
            // arrêtée : un autre ordre l'a remplacée
        }
    }
}
