package lancer.rapide;

import lancer.Constantes;
import lancer.Point;
import lancer.PointContact;
import lancer.contrat.Compteurs;

/** Ce qu'un fil retient d'une question à l'autre, et ce que la boucle répond à la question en cours. */
final class Memoire {

    final Structures structures;
    final Compteurs compteurs;

    /** Rang du dernier contact ; en général, un rayon d'ombre ou réfléchi vient ensuite de lui. */
    int contact = -1;

    /** Nombre de questions posées, et numéro de celle en cours. */
    long questions;
    long enCours;

    /** Distance au-delà de laquelle un contact ne compte plus, selon la boucle. */
    double limite;

    /** De la question en cours, le premier proposé des plus proches, et le premier d'entre eux dans la scène. */
    int proche;
    int premier;

    /** Rang de la dernière lampe demandée ; en général, la suivante vient juste après. */
    private int lampe;

    Memoire(Structures structures, Compteurs compteurs) {
        this.structures = structures;
        this.compteurs = compteurs;
    }

    /** Attend la réponse de la boucle à cette question. */
    void attendre(long numero, int rangProche, int rangPremier) {
        enCours = numero;
        limite = Constantes.INFINI;
        proche = rangProche;
        premier = rangPremier;
    }

    /** D'où part ce rayon d'ombre : le point de vue de la lampe ; {@code null} s'il n'y en a pas. */
    PointDeVue trouverLaLampe(Point p) {
        Point[] lampes = structures.lampes;
        // un rayon d'ombre qui part du contact ne part pas d'une lampe
        for (int k = p instanceof PointContact ? lampes.length : 0; k < lampes.length; k++) {
            if (lampes[lampe] == p) {
                return structures.vues[lampe];
            }
            lampe = lampe + 1 < lampes.length ? lampe + 1 : 0;
        }
        return null;
    }
}
