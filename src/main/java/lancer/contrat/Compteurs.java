package lancer.contrat;

/** Compteurs d'un fil. Ceux de tous les fils sont additionnés à la fin du dessin. */
public final class Compteurs {

    /** Rayons partis de l'écran, rayons d'ombre, rayons réfléchis. */
    public long primaires;
    public long ombre;
    public long reflechis;

    /** Intersections calculées ; parmi celles de la recherche rapide, celles dont la forme directe est en doute. */
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

    /** Le nombre d'examens de sphères, de nœuds et de cases. */
    public long examens() {
        return testsSpheres + noeudsVisites;
    }

    /** Le nombre de rayons de toutes sortes. */
    public long rayons() {
        return primaires + ombre + reflechis;
    }
}
