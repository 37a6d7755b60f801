package lancer.mesures;

import java.util.concurrent.CancellationException;
import java.util.concurrent.TimeUnit;
import lancer.Lancer;

/** Arrête un dessin dès qu'il promet d'être trop long : au quart de la limite, ce qui est fait dit ce que coûtera le tout. */
final class Garde implements Runnable {

    private static final long PAS_MS = 20;

    private final Lancer lancer;
    private final long limiteNs;

    /** La part de l'image confiée à chaque instant aux fils : tant qu'aucun pavé n'est fini, pas plus que cela n'est fait. */
    private final double partEnCours;

    private final long debut = System.nanoTime();
    private volatile boolean fini;
    private String raison;

    private Garde(Lancer lancer, double partEnCours, long limiteNs) {
        this.lancer = lancer;
        this.partEnCours = partEnCours;
        this.limiteNs = limiteNs;
    }

    /**
     * Dessine sous surveillance.
     *
     * @param dessin le dessin de {@code lancer}
     * @param partEnCours la part de l'image que les fils ont ensemble entre les mains, dans ]0, 1]
     * @return {@code null} si le dessin est fini, sinon pourquoi il a été arrêté
     */
    static String surveiller(Lancer lancer, Runnable dessin, double partEnCours, long limiteNs) {
        Garde garde = new Garde(lancer, partEnCours, limiteNs);
        Thread veille = new Thread(garde, "garde");
        veille.setDaemon(true);
        veille.start();
        try {
            dessin.run();
        } catch (CancellationException e) {
            // la garde a dit pourquoi
        }
        return garde.relever();
    }

    /** Plus rien ne sera arrêté ; ce qui l'a été, au dernier moment peut-être, est dit. */
    private synchronized String relever() {
        fini = true;
        return raison;
    }

    private synchronized void arreter(String pourquoi) {
        if (!fini) {
            raison = pourquoi;
            lancer.arreter();
        }
    }

    @Override
    public void run() {
        while (!fini) {
            long ecoule = System.nanoTime() - debut;
            double part = lancer.getAvancement();
            double promis = ecoule / Math.max(part, partEnCours);
            if (ecoule > limiteNs / 4 && promis > limiteNs) {
                arreter("une image prendrait " + (part > 0 ? "environ " : "plus de ") + duree(promis) + ", la limite est "
                        + duree(limiteNs));
                return;
            }
            try {
                TimeUnit.MILLISECONDS.sleep(PAS_MS);
            } catch (InterruptedException e) {
                return;
            }
        }
    }

    /** Un temps en secondes, minutes ou heures, sans plus de précision qu'une estimation n'en a. */
    static String duree(double ns) {
        double secondes = ns / 1e9;
        return secondes < 1 ? Math.round(1000 * secondes) + " ms" : secondes < 120 ? Math.round(secondes) + " s"
                : secondes < 7200 ? Math.round(secondes / 60) + " min" : Math.round(secondes / 3600) + " h";
    }
}
