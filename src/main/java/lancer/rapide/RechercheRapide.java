package lancer.rapide;

import lancer.Camera;
import lancer.Constantes;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;
import lancer.contrat.Vue;

/**
 * La recherche qui s'aide des structures de {@link Preparation} : pour chaque sorte de rayon, celle qui lui va. Les structures
 * sont partagées ; chaque fil a sa {@link Sonde}.
 */
final class RechercheRapide implements Recherche {

    private final Preparation preparation;
    private final Spheres spheres;
    private final Sonde sonde;

    RechercheRapide(Preparation preparation, Compteurs compteurs) {
        this.preparation = preparation;
        this.spheres = preparation.getSpheres();
        this.sonde = new Sonde(compteurs);
    }

    Spheres getSpheres() {
        return spheres;
    }

    Voisins premiers(Camera camera) {
        return preparation.premiers(camera);
    }

    Voisins suivants() {
        return preparation.suivants();
    }

    Obstacles[] obstacles() {
        return preparation.obstacles();
    }

    @Override
    public void plusProche(Rayon incident, Objet3D saufLui) {
        Point P = incident.getP();
        Vecteur V = incident.getV();
        int k = preparation.deNImporteOu().plusProche(sonde, P.x, P.y, P.z, V.x, V.y, V.z, spheres.numero(saufLui));
        double distance = sonde.distance;
        if (spheres.autres.length == 0 || autrePlusProche(incident, distance, k, saufLui) == null) {
            incident.setContact(k < 0 ? null : spheres.objet(k), distance);
        }
    }

    @Override
    public boolean estCachee(Lampe lampe, Point contact, Objet3D objet) {
        Point P = lampe.getPosition();
        Vecteur V = new Vecteur(P, contact);
        double distance = V.norme();
        V = V.normalized();
        return preparation.obstaclesDe(lampe).cachee(sonde, P.x, P.y, P.z, V.x, V.y, V.z, distance, spheres.numero(objet))
                || spheres.autres.length > 0 && autreCache(P, contact, distance, objet);
    }

    /**
     * L'objet, parmi ceux qui ne sont pas des sphères, que ce rayon rencontre avant la sphère k ; il le retient alors.
     *
     * @param distance celle de la sphère k, +∞ si k est -1
     * @return {@code null} si c'est la sphère, ou rien
     */
    Objet3D autrePlusProche(Rayon rayon, double distance, int k, Objet3D saufLui) {
        Objet3D plusProche = null;
        int rang = k < 0 ? Integer.MAX_VALUE : spheres.rang[k];
        for (int a = 0; a < spheres.autres.length; a++) {
            Objet3D autre = spheres.autres[a];
            if (autre != saufLui) {
                sonde.compteurs.testsSpheres++;
                double d = autre.getIntersectionDistance(rayon);
                if (d < distance || d == distance && d != Constantes.INFINI && spheres.rangAutres[a] < rang) {
                    plusProche = autre;
                    distance = d;
                    rang = spheres.rangAutres[a];
                }
            }
        }
        if (plusProche != null) {
            rayon.setContact(plusProche, distance);
        }
        return plusProche;
    }

    /** Vrai si un objet qui n'est pas une sphère se trouve entre la lampe et le contact. */
    boolean autreCache(Point lampe, Point contact, double distance, Objet3D objet) {
        Rayon ombre = new Rayon(lampe, contact);
        for (Objet3D autre : spheres.autres) {
            if (autre != objet) {
                sonde.compteurs.testsSpheres++;
                if (autre.getIntersectionDistance(ombre) < distance) {
                    return true;
                }
            }
        }
        return false;
    }

    @Override
    public Recherche pourUnFil(Compteurs compteurs) {
        return new RechercheRapide(preparation, compteurs);
    }

    @Override
    public Vue vue(Lancer lancer, int profondeur) {
        return new Traceur(this, sonde, lancer, profondeur);
    }

    /** Ce que {@link Preparation} a choisi pour cette scène. */
    @Override
    public String toString() {
        return preparation.toString();
    }
}
