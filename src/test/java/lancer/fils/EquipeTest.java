package lancer.fils;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Des fils s'arrêtent au premier échec et à l'interruption ; celui qui ne s'arrête pas est abandonné. */
@Timeout(60)
class EquipeTest {

    @Test
    void unFilQuiNeSArretePasEstAbandonneEtLaCauseDeLArretEstDite() {
        CountDownLatch fin = new CountDownLatch(1);
        try {
            Equipe equipe = new Equipe();
            assertThrows(IllegalStateException.class, () -> equipe.faire(List.of(() -> attendreSourd(fin), () -> {
                throw new IllegalStateException("la cause");
            })));
            assertThrows(CancellationException.class, () -> equipe.faire(() -> { }));
        } finally {
            fin.countDown();
        }
    }

    @Test
    void unFilAbandonneNePrendPlusDeTache() throws InterruptedException {
        CountDownLatch fin = new CountDownLatch(1);
        AtomicReference<Thread> abandonne = new AtomicReference<>();
        AtomicInteger prises = new AtomicInteger();
        Thread appelant = Thread.currentThread();
        Equipe equipe = new Equipe();
        assertThrows(CancellationException.class, () -> equipe.faire(() -> {
            equipe.prendre();
            prises.incrementAndGet();
            abandonne.set(Thread.currentThread());
            appelant.interrupt();
            attendreSourd(fin);
            equipe.prendre();
            prises.incrementAndGet();
        }));
        assertTrue(Thread.interrupted(), "l'interruption reste à voir");
        fin.countDown();
        abandonne.get().join();
        assertEquals(1, prises.get());
        assertThrows(CancellationException.class, equipe::obeir, "le fil abandonné s'arrête à sa prochaine lecture");
    }

    @Test
    void chaqueTacheEstPriseUneFois() {
        AtomicInteger somme = new AtomicInteger();
        Equipe equipe = new Equipe();
        equipe.faire(Collections.nCopies(3, () -> {
            for (int tache = equipe.prendre(); tache < 1000; tache = equipe.prendre()) {
                somme.addAndGet(tache);
            }
        }));
        assertEquals(999 * 1000 / 2, somme.get());
    }

    private static void attendreSourd(CountDownLatch fin) {
        while (fin.getCount() > 0) {
            LockSupport.parkNanos(10_000_000);
        }
    }
}
