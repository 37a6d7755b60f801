package lancer.essai;

import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Scene;
import lancer.Vecteur;

/** La question de l'ombre, posée comme le fait {@link Objet3D#getColor}. */
public final class Ombre {

    private Ombre() {
    }

    public static boolean cachee(Scene scene, Lampe lampe, Point contact, Objet3D objet) {
        Vecteur versLampe = new Vecteur(contact, lampe.getPosition());
        return scene.estCachee(lampe, contact, versLampe.normalized(), versLampe.norme(), objet);
    }
}
