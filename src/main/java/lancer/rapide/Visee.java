package lancer.rapide;

import lancer.Point;
import lancer.Vecteur;

/**
 * Les enveloppes qui se voient d'un point de vue dans la direction d'un rayon, de la plus proche à la plus lointaine,
 * données quelques-unes à la fois : un contact peut rendre les autres inutiles.
 */
final class Visee implements Source {

    /** Nombre d'enveloppes d'une liste. */
    private static final int QUELQUES = 4;

    private PointDeVue vue;
    private Point p;
    private Vecteur v;
    /** Voir {@link PointDeVue#erreur}. */
    private double erreur;
    /** La première enveloppe qui n'est pas encore donnée, et la fin de celles de cette direction. */
    private int place;
    private int fin;

    /** Recommence, pour un rayon de ce point de vue. */
    void viser(PointDeVue pointDeVue, Point depart, Vecteur direction) {
        vue = pointDeVue;
        p = depart;
        v = direction;
        erreur = vue.erreur(p);
        int cube = vue.cellules.cubeDe(v.x, v.y, v.z);
        place = cube < 0 ? 0 : vue.cellules.debut[cube];
        fin = cube < 0 ? 0 : vue.cellules.debut[cube + 1];
    }

    @Override
    public Suite suivante(Liste liste, double limite) {
        int[] rangs = vue.cellules.objets;
        liste.examens++;
        if (place == fin || vue.metAuDela(limite + erreur, rangs[place], p, v)) {
            return Suite.FIN;
        }
        if (liste.examens > EXAMENS_MAX) {
            return Suite.TROP;
        }
        liste.donner(rangs, place, Math.min(place + QUELQUES, fin));
        place = liste.fin;
        return Suite.LISTE;
    }
}
