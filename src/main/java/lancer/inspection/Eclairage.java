package lancer.inspection;

import lancer.Couleur;
import lancer.Lampe;
import lancer.PointContact;
import lancer.Vecteur;

/** Une lampe, vue d'un contact ; ce qui n'a pas été calculé est {@code null}. */
public final class Eclairage {

    public final Lampe lampe;

    /** Produit N·(lampe − contact) : la lampe est devant la surface s'il est positif. */
    public final double devant;

    double cosinus;
    double eclat;
    Couleur diffus;
    Couleur reflet;

    /** Direction de la lampe si un rayon d'ombre a été demandé. */
    Vecteur L;
    double distance;
    Couleur apport;
    PointContact cache;

    Eclairage(Lampe lampe, double devant) {
        this.lampe = lampe;
        this.devant = devant;
    }

    /** Ce qu'il advient d'elle et de ses pareilles. */
    String sort() {
        return eclaire() ? "éclairées" : diffus == null ? "dans le dos"
                : L == null ? "sans effet sur cette matière" : "cachées";
    }

    /** Dit si elle compte dans la somme. */
    public boolean eclaire() {
        return apport != null;
    }

    /** Contact de l'objet le plus proche d'elle qui la cache, {@code null} si elle n'est pas cachée. */
    public PointContact getCache() {
        return cache;
    }
}
