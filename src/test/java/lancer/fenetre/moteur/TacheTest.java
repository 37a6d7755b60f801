package lancer.fenetre.moteur;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.EventQueue;
import java.awt.Toolkit;
import java.awt.event.InvocationEvent;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.function.BooleanSupplier;
import lancer.fenetre.etat.Suite.Evenement;
import org.junit.jupiter.api.Test;

/** Les réponses d'une tâche arrivent dans l'ordre où elle les donne. */
class TacheTest {

    private final List<String> recus = new CopyOnWriteArrayList<>();

    private Tache tache(boolean parle) {
        return new Tache(1, evenement -> recus.add(parle ? "dit" : "autre")) {
            @Override
            protected Evenement doInBackground() {
                if (parle) {
                    dire(suite -> { });
                    EventQueue.invokeLater(() -> recus.add("puis"));
                }
                return suite -> { };
            }

            @Override
            Evenement echouer(Throwable echec) {
                return suite -> { };
            }
        };
    }

    private static void attendre(BooleanSupplier vrai) throws InterruptedException {
        while (!vrai.getAsBoolean()) {
            Thread.sleep(1);
        }
    }

    /** Java dit les fins par paquets : celle d'une autre tâche, qui attend, peut emporter la sienne. */
    @Test
    void laFinSeDitApresCeQuiSEstDitAvant() throws Exception {
        CountDownLatch suite = new CountDownLatch(1);
        CountDownLatch retenu = new CountDownLatch(1);
        EventQueue.invokeLater(() -> {
            retenu.countDown();
            try {
                suite.await();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        });
        retenu.await();
        tache(false).execute();
        EventQueue file = Toolkit.getDefaultToolkit().getSystemEventQueue();
        attendre(() -> file.peekEvent(InvocationEvent.INVOCATION_DEFAULT) != null);
        Tache celle = tache(true);
        celle.execute();
        attendre(celle::isDone);
        // le fil de la tâche ajoute encore sa fin au paquet
        Thread.sleep(50);
        suite.countDown();
        attendre(() -> recus.size() == 4);
        assertEquals(Arrays.asList("dit", "puis", "autre", "dit"), recus);
    }
}
