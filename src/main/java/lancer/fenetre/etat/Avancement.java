package lancer.fenetre.etat;

import java.util.Locale;
import lancer.dessin.Dessin;

/** Où en est un travail : ce que son fil en écrit, et que lit l'horloge de la fenêtre. Il ne décide rien. */
public final class Avancement {

    /** Temps de dessin avant de dire ce qui en reste. */
    private static final long RESTE_NS = 2_000_000_000;

    private final long debut = System.nanoTime();
    /** Ce qui se fait : lecture, préparation, brouillon, puis dessin. */
    private volatile String etape;
    private volatile long debutDeLEtape;
    /** La part lue du fichier, de 0 à 1 ; 0 ensuite. */
    private volatile double partLue;
    /** 0 avant la fin. */
    private volatile long fin;

    Avancement(String etape) {
        this.etape = etape;
    }

    public void lire(double part) {
        partLue = part;
    }

    public void passer(String suivante) {
        debutDeLEtape = System.nanoTime();
        partLue = 0;
        etape = suivante;
    }

    public void finir() {
        fin = System.nanoTime();
    }

    /** La part faite de la lecture, ou de l'image, de 0 à 1. @param dessin {@code null} avant son brouillon */
    double getPart(Dessin dessin) {
        return dessin == null ? partLue : dessin.lancer.getAtelier().getAvancement();
    }

    String direEtape(Dessin dessin) {
        return etape + " " + (int) (100 * getPart(dessin)) + " %";
    }

    /** Le temps de ce travail, lecture comprise, au contraire de celui que donne le résumé d'une image. */
    String direTemps() {
        return String.format(Locale.FRANCE, " — %.2f s", ((fin == 0 ? System.nanoTime() : fin) - debut) / 1e9);
    }

    /** Le temps qui reste, d'après la part faite du dessin ; vide tant qu'il ne peut être estimé. */
    String direReste(Dessin dessin) {
        long passe = System.nanoTime() - debutDeLEtape;
        double part = dessin == null ? 0 : dessin.getAvancement();
        if (passe < RESTE_NS || part == 0) {
            return "";
        }
        double s = passe * (1 - part) / part / 1e9;
        return ", reste " + (s < 60 ? Math.round(s) + " s" : Math.round(s / 60) + " min");
    }
}
