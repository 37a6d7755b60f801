package lancer.fenetre.etat;

import java.util.Locale;
import lancer.dessin.Dessin;

/** Où en est un travail : ce que son fil en écrit, et que lit l'horloge de la fenêtre. Il ne décide rien. */
public final class Avancement {

    /** Temps de dessin avant de dire ce qui en reste. */
    private static final long RESTE_NS = 2_000_000_000;

    private final long debut = System.nanoTime();
    private volatile double partLue;
    private volatile long debutDuDessin;
    /** 0 avant la fin. */
    private volatile long fin;

    public void lire(double part) {
        partLue = part;
    }

    public void dessiner() {
        debutDuDessin = System.nanoTime();
    }

    public void finir() {
        fin = System.nanoTime();
    }

    double getPartLue() {
        return partLue;
    }

    /** Le temps de ce travail, lecture comprise, au contraire de celui que donne le résumé d'une image. */
    String direTemps() {
        return String.format(Locale.FRANCE, " — %.2f s", ((fin == 0 ? System.nanoTime() : fin) - debut) / 1e9);
    }

    /** Le temps qui reste, d'après la part faite du dessin ; vide tant qu'il ne peut être estimé. */
    String direReste(Dessin dessin) {
        long passe = System.nanoTime() - debutDuDessin;
        double part = dessin.getAvancement();
        if (passe < RESTE_NS || part == 0) {
            return "";
        }
        double s = passe * (1 - part) / part / 1e9;
        return ", reste " + (s < 60 ? Math.round(s) + " s" : Math.round(s / 60) + " min");
    }
}
