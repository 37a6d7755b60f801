package lancer.contrat;

import lancer.Constantes;
import lancer.Objet3D;
import lancer.PointContact;
import lancer.Rayon;

/** Compteurs d'un fil. Ceux de tous les fils sont additionnés à la fin du dessin. */
public final class Compteurs {

    /** Rayons partis de l'écran, rayons d'ombre, rayons réfléchis. */
    public long primaires;
    public long ombre;
    public long reflechis;

    /** Distances demandées à un objet. */
    public long testsSpheres;

    /** Enveloppes, cubes et nœuds que la recherche a examinés, et pixels que l'échantillonnage a raffinés. */
    public long noeudsVisites;
    public long pixelsRaffines;

    /** Compte ce rayon. D'une lampe lointaine, le second rayon d'ombre, qui part du contact, n'est pas compté. */
    public void compter(Rayon rayon, Objet3D depart, double portee) {
        if (portee < Constantes.INFINI) {
            ombre += rayon.getP() instanceof PointContact ? 0 : 1;
        } else if (depart == null) {
            primaires++;
        } else {
            reflechis++;
        }
    }

    public void ajouter(Compteurs autres) {
        primaires += autres.primaires;
        ombre += autres.ombre;
        reflechis += autres.reflechis;
        testsSpheres += autres.testsSpheres;
        noeudsVisites += autres.noeudsVisites;
        pixelsRaffines += autres.pixelsRaffines;
    }

    /** Le nombre de rayons de toutes sortes. */
    public long rayons() {
        return primaires + ombre + reflechis;
    }
}
