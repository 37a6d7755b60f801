package lancer.fenetre.etat;

import lancer.dessin.Demande;
import lancer.dessin.Dessin;

/** Lire la scène si elle ne l'est pas, puis dessiner : l'ordre, et ce qui en est fait. Immuable. */
public final class Travail {

    /** Ce qui finit un travail. */
    enum Fin { AUCUNE, ACHEVE, ARRETE, ECHEC }

    public final int numero;
    /** Le fichier dont la scène n'est pas encore montrée ; {@code null} si elle l'est. */
    public final String aLire;
    /** Ce qui se dessine ; {@code null} tant que la scène se lit. */
    final Demande demande;
    /** Le dessin dont chaque pixel a une couleur ; {@code null} avant son brouillon. */
    final Dessin dessin;
    final Fin fin;
    /** Ce qui a empêché de dessiner, en une phrase ; {@code null} si rien. */
    final String faute;
    final Avancement avancement;

    private Travail(int numero, String aLire, Demande demande, Dessin dessin, Fin fin, String faute,
            Avancement avancement) {
        this.numero = numero;
        this.aLire = aLire;
        this.demande = demande;
        this.dessin = dessin;
        this.fin = fin;
        this.faute = faute;
        this.avancement = avancement;
    }

    /** Un travail qui commence : il a un fichier à lire, ou une demande à dessiner, l'autre étant {@code null}. */
    Travail(int numero, String aLire, Demande demande) {
        this(numero, aLire, demande, null, Fin.AUCUNE, null,
                new Avancement(aLire == null ? "préparation" : "lecture"));
    }

    /** La scène est lue. */
    Travail lue(Demande celle) {
        return new Travail(numero, aLire, celle, dessin, fin, faute, avancement);
    }

    /** La scène lue est celle qui se montre. */
    Travail montree() {
        return new Travail(numero, null, demande, dessin, fin, faute, avancement);
    }

    /** Chaque pixel de ce dessin a une couleur. @param comment ACHEVE si elle est la bonne */
    Travail avec(Dessin celui, Fin comment) {
        return new Travail(numero, aLire, demande, celui, comment, faute, avancement);
    }

    /** @param pourquoi {@code null} si c'est la lecture qui a échoué : {@link Etat#source} dit pourquoi */
    Travail echoue(String pourquoi) {
        return new Travail(numero, aLire, demande, dessin, Fin.ECHEC, pourquoi, avancement);
    }

    /** Arrêté : ce qui est demandé ne se redessine pas de lui-même. */
    Travail arrete(Demande pour) {
        return new Travail(numero, aLire, pour, dessin, Fin.ARRETE, faute, avancement);
    }

    boolean enCours() {
        return fin == Fin.AUCUNE;
    }

    /** La part faite de la lecture, ou de l'image, de 0 à 1. */
    public double getAvancement() {
        return avancement.getPart(dessin);
    }

    /** Ce que ce travail fait ou a fait, en une ligne. */
    public String getTexte() {
        String temps = avancement.direTemps();
        switch (fin) {
            case ACHEVE:
                return "terminé" + temps;
            case ECHEC:
                return "échec" + temps;
            case ARRETE:
                return avancement.direEtape(dessin) + ", arrêt" + temps;
            default:
                return avancement.direEtape(dessin) + temps + avancement.direReste(dessin);
        }
    }
}
