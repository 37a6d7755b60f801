package lancer.contrat;

/** Comptes d'un fil qui dessine. Chaque fil a les siens, additionnés à la fin. */
public final class Compteurs {

    /** Rayons partis de l'écran, rayons d'ombre (une lampe est-elle cachée d'un contact ?), rayons réfléchis. */
    public long primaires;
    public long ombre;
    public long reflechis;

    /** Intersections calculées, et celles que leur forme directe laissait en doute, sauf dans les boucles du cours. */
    public long testsSpheres;
    public long testsPrecis;

    /** Nœuds ou cases de structures de recherche visités, et pixels que l'échantillonnage a raffinés. */
    public long noeudsVisites;
    public long pixelsRaffines;

    public void ajouter(Compteurs autres) {
        primaires += autres.primaires;
        ombre += autres.ombre;
        reflechis += autres.reflechis;
        testsSpheres += autres.testsSpheres;
        testsPrecis += autres.testsPrecis;
        noeudsVisites += autres.noeudsVisites;
        pixelsRaffines += autres.pixelsRaffines;
    }

    /** Le nombre de sphères et de cases examinées. */
    public long examens() {
        return testsSpheres + noeudsVisites;
    }

    /** Le nombre de rayons de toutes sortes. */
    public long rayons() {
        return primaires + ombre + reflechis;
    }
}
