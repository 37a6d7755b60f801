package lancer.contrat;

import lancer.Objet3D;

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

    /** Compte un rayon qui cherche ce qu'il voit. @param depart l'objet qui l'a réfléchi, {@code null} sans lui */
    public void compter(Objet3D depart) {
        if (depart == null) {
            primaires++;
        } else {
            reflechis++;
        }
    }

    public void ajouter(Compteurs compteurs) {
        primaires += compteurs.primaires;
        ombre += compteurs.ombre;
        reflechis += compteurs.reflechis;
        testsSpheres += compteurs.testsSpheres;
        noeudsVisites += compteurs.noeudsVisites;
        pixelsRaffines += compteurs.pixelsRaffines;
    }

    /** Le nombre de rayons de toutes sortes. */
    public long rayons() {
        return primaires + ombre + reflechis;
    }
}
