package lancer.fenetre.etat;

import java.util.Locale;
import lancer.dessin.Demande;
import lancer.dessin.Dessin;

/** Lire la scène si elle ne l'est pas, puis dessiner : l'ordre, et ce qui en est fait. Immuable. */
public final class Travail {

    public final int numero;
    /** Le fichier dont la scène n'est pas encore montrée ; {@code null} si elle l'est. */
    public final String aLire;
    /** Ce qui se dessine ; {@code null} tant que la scène se lit. */
    final Demande demande;
    final Progres progres;
    final Avancement avancement;

    /** Le dernier dessin, {@code null} avant la préparation, ce qu'il a d'achevé, et l'échec qui l'a arrêté, ou non. */
    static final class Progres {

        /** L'étape atteinte : un travail arrêté ou échoué garde celle où il l'a été. */
        enum Etape { LECTURE, PREPARATION, BROUILLON, DESSIN }

        /** Ce qui le finit. */
        enum Fin { AUCUNE, ACHEVE, ARRETE, ECHEC }

        final Etape etape;
        final Dessin dessin;
        final Fin fin;
        final Throwable echec;

        Progres(Etape etape, Dessin dessin, Fin fin, Throwable echec) {
            this.etape = etape;
            this.dessin = dessin;
            this.fin = fin;
            this.echec = echec;
        }

        Progres fini(Fin comment, Throwable pourquoi) {
            return new Progres(etape, dessin, comment, pourquoi);
        }
    }

    private Travail(int numero, String aLire, Demande demande, Progres progres, Avancement avancement) {
        this.numero = numero;
        this.aLire = aLire;
        this.demande = demande;
        this.progres = progres;
        this.avancement = avancement;
    }

    /** Un travail qui commence : il a un fichier à lire, ou une demande à dessiner, l'autre étant {@code null}. */
    Travail(int numero, String aLire, Demande demande) {
        this(numero, aLire, demande, new Progres(aLire == null ? Progres.Etape.PREPARATION : Progres.Etape.LECTURE,
                null, Progres.Fin.AUCUNE, null), new Avancement());
    }

    /** La scène est lue. */
    Travail lue(Demande celle) {
        return new Travail(numero, aLire, celle, new Progres(Progres.Etape.PREPARATION, null, Progres.Fin.AUCUNE, null),
                avancement);
    }

    Travail avec(Progres autre) {
        return new Travail(numero, aLire, demande, autre, avancement);
    }

    /** La scène lue est celle qui se montre. */
    Travail montree() {
        return new Travail(numero, null, demande, progres, avancement);
    }

    /** Arrêté : ce qui est demandé ne se redessine pas de lui-même. */
    Travail arrete(Demande pour) {
        return new Travail(numero, aLire, pour, progres.fini(Progres.Fin.ARRETE, null), avancement);
    }

    boolean enCours() {
        return progres.fin == Progres.Fin.AUCUNE;
    }

    boolean aSonBrouillon() {
        return progres.etape == Progres.Etape.DESSIN;
    }

    /** La part faite de la lecture, ou de l'image, de 0 à 1. */
    public double getAvancement() {
        if (progres.etape == Progres.Etape.LECTURE) {
            return avancement.getPartLue();
        }
        return aSonBrouillon() ? progres.dessin.lancer.getAtelier().getAvancement() : 0;
    }

    /** Ce que ce travail fait ou a fait, en une ligne. */
    public String getTexte() {
        String temps = avancement.direTemps();
        String etape = progres.etape.toString().toLowerCase(Locale.ROOT).replace("preparation", "préparation")
                + " " + (int) (100 * getAvancement()) + " %";
        switch (progres.fin) {
            case ACHEVE:
                return "terminé" + temps;
            case ECHEC:
                return "échec" + temps;
            case ARRETE:
                return etape + ", arrêt" + temps;
            default:
                return etape + temps + (aSonBrouillon() ? avancement.direReste(progres.dessin) : "");
        }
    }
}
