package lancer.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** La veille sur le fichier d'une scène, devant un disque qui ne répond pas. */
@Timeout(60)
class SurveillanceTest {

    @Test
    void suivreUneAutreSceneNAttendPasUnDisqueQuiNeRepondPas() throws Exception {
        CountDownLatch demande = new CountDownLatch(2);
        CountDownLatch reponse = new CountDownLatch(1);
        AtomicInteger ici = new AtomicInteger();
        LinkedBlockingQueue<String> dits = new LinkedBlockingQueue<>();
        Surveillance veille = new Surveillance(fichier -> {
            if (fichier.equals("loin")) {
                demande.countDown();
                // la première question est répondue, la deuxième se fait attendre
                if (demande.getCount() == 0) {
                    attendre(reponse);
                }
                return "changée";
            }
            ici.incrementAndGet();
            return "autre";
        }, () -> dits.add("change"), () -> dits.add("efface"));
        veille.suivre("loin", "lue");
        assertTrue(demande.await(40, TimeUnit.SECONDS), "le disque est interrogé");
        Thread fenetre = new Thread(() -> veille.suivre("ici", "lue"));
        fenetre.start();
        fenetre.join(TimeUnit.SECONDS.toMillis(20));
        boolean attend = fenetre.isAlive();
        reponse.countDown();
        assertFalse(attend, "la fenêtre attend le disque");
        assertEquals("change", dits.poll(40, TimeUnit.SECONDS));
        veille.terminer();
        assertTrue(ici.get() >= 2, "c'est de la scène d'ici que cela se dit");
    }

    private static void attendre(CountDownLatch loquet) {
        try {
            loquet.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
