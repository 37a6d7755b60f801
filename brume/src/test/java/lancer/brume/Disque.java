package lancer.brume;

import lancer.Constantes;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Vecteur;
import lancer.contrat.Forme;
import lancer.contrat.Section;

/** Une forme d'un module de variante, inscrite à côté de celle de {@code Nuit} : un disque plat. */
public final class Disque extends Objet3D implements Forme {

    private Point centre;
    private Vecteur normale;
    private double rayon;

    @Override
    public String getSection() {
        return "Disque";
    }

    @Override
    public String[] getCles() {
        return new String[] {"centre", "normale", "rayon"};
    }

    @Override
    public Objet3D lire(Section valeurs) {
        Disque disque = new Disque();
        disque.centre = valeurs.point("centre");
        disque.normale = valeurs.direction("normale");
        disque.rayon = valeurs.longueur("rayon");
        return disque;
    }

    @Override
    public double getIntersectionDistance(Rayon incident) {
        Point P = incident.getP();
        Vecteur V = incident.getV();
        double d = centre.sub(P).dot(normale) / V.dot(normale);
        if (!(d > 0 && P.add(V.mul(d)).sub(centre).norme() <= rayon)) {
            d = Constantes.INFINI;
        }
        incident.setContact(this, d);
        return d;
    }

    @Override
    public Vecteur getNormale(Point contact) {
        return normale;
    }
}
