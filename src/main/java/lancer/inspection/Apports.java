package lancer.inspection;

import lancer.Couleur;
import lancer.inspection.Chemin.Segment;
import lancer.inspection.Chemin.Terme;

/** Ce que les termes notés d'un segment expliquent de sa couleur. */
public final class Apports {

    private Apports() {
    }

    /** Couleur du contact, moins la somme des termes notés ; noire si les deux sont égales au bit près. */
    public static Couleur inconnue(Segment segment) {
        Couleur connue = segment.termes.stream().flatMap(terme -> terme.ajouts.stream()).reduce(new Couleur(),
                (c, ajout) -> new Couleur(c.r + ajout.r, c.v + ajout.v, c.b + ajout.b));
        return segment.N == null || segment.somme == null ? new Couleur() : segment.somme.sub(connue);
    }

    /** L'ajout de la lampe ou du rayon réfléchi ; {@code null} s'il n'éclaire pas le contact. */
    static Couleur apport(Terme terme) {
        int rang = terme.ajouts.indexOf(terme.produit);
        if (rang < 0 && terme.cache == null && terme.produit != null && !terme.produit.estNoire()) {
            return terme.ajouts.isEmpty() ? null : terme.ajouts.get(0);
        }
        return rang < 0 ? null : terme.ajouts.get(rang);
    }

    public static boolean eclaire(Terme terme) {
        return apport(terme) != null;
    }
}
