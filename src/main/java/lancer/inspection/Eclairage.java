package lancer.inspection;

import java.util.Comparator;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Vecteur;

/** Le terme d'une lampe dans la couleur d'un contact, par les équations du cours. */
public final class Eclairage {

    public final Lampe lampe;

    /** N·(lampe − contact) ; s'il est négatif ou nul, la lampe est dans le dos et ce qui suit est nul. */
    final double devant;

    /** Direction de la lampe, de longueur 1 ; N·L ; les deux parts de l'apport, et leur somme. */
    final Vecteur L;
    final double cosinus;
    final Couleur diffus;
    final Couleur reflet;
    final Couleur apport;

    /** Dit si un objet cache la lampe, cherchée seulement si elle apporte quelque chose. */
    final boolean cachee;

    /** Contact le plus proche d'elle de l'objet qui la cache ; {@code null} s'il n'y en a pas. */
    public final PointContact obstacle;

    Eclairage(Lampe lampe, Segment segment, Scene scene) {
        this.lampe = lampe;
        Objet3D objet = segment.contact.objet;
        Vecteur versLampe = new Vecteur(segment.contact, lampe.getPosition());
        devant = segment.N.dot(versLampe);
        L = devant > 0 ? versLampe.normalized() : new Vecteur();
        cosinus = Math.min(1, segment.N.dot(L));
        diffus = segment.Kd.mul(lampe.getCouleur()).mul(cosinus);
        double eclat = !(devant > 0) || objet.getKs().estNoire() ? 0 : scene.getModele().getSpecularite()
                .eclat(segment.rayon.getV(), segment.N, L, segment.R, objet.getNs());
        reflet = objet.getKs().mul(lampe.getCouleur()).mul(eclat);
        apport = Segment.ajouter(diffus, reflet);
        cachee = !apport.estNoire() && scene.estCachee(lampe, segment.contact, L, versLampe.norme(), objet);
        obstacle = cachee ? chercherLObstacle(segment.contact, versLampe.norme(), scene) : null;
    }

    /** Dit si la lampe éclaire le contact. */
    public boolean eclaire() {
        return !cachee && !apport.estNoire();
    }

    /** Demandé de la lampe ; si elle est lointaine et rien n'est devant le milieu, demandé ensuite du contact. */
    private PointContact chercherLObstacle(PointContact contact, double distance, Scene scene) {
        boolean lointaine = Scene.estLointaine(lampe, contact);
        double portee = lointaine ? distance / 2 : distance;
        Rayon deLaLampe = Rayon.unitaire(lampe.getPosition(), L.neg());
        PointContact premier = scene.getClosestIntersection(deLaLampe, contact.objet);
        if (deLaLampe.getDistance() < portee || !lointaine) {
            return deLaLampe.getDistance() < portee ? premier : null;
        }
        Rayon versLampe = Rayon.unitaire(contact, L);
        return scene.getObjets().stream().filter(objet -> objet != contact.objet)
                .map(objet -> Segment.toucher(objet, versLampe)).filter(vu -> vu != null && vu.distance < portee)
                .max(Comparator.comparingDouble(vu -> vu.distance)).orElse(null);
    }
}
