package lancer;

/** Le point où un rayon touche un objet (cours, « Scène de sphères »). Immuable. */
public class PointContact extends Point {

    public final Objet3D objet;

    /** La distance du départ du rayon à ce point, en unités de la scène. */
    public final double distance;

    public PointContact(Point position, Objet3D objet, double distance) {
        super(position.x, position.y, position.z);
        this.objet = objet;
        this.distance = distance;
    }
}
