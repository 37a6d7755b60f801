package lancer;

import java.nio.ByteBuffer;
import java.util.Base64;

/** Dessine une scène par les classes d'un étudiant, en interrogeant leurs méthodes publiques. */
public final class SondeImage {

    private SondeImage() {
    }

    /**
     * @param a scène, largeur, hauteur, profondeur, décalage en x et en y ; rend les couleurs non limitées, en
     * flottants, en base 64
     */
    public static String dessiner(String... a) {
        Scene scene = new Scene(a[0]);
        int largeur = Integer.parseInt(a[1]);
        int hauteur = Integer.parseInt(a[2]);
        int profondeur = Integer.parseInt(a[3]);
        double decalage = Double.parseDouble(a[4]);
        Camera camera = new Camera(largeur, hauteur);
        Vue vue = vue(scene, camera, profondeur, decalage);
        ByteBuffer octets = ByteBuffer.allocate(largeur * hauteur * 12);
        for (int ye = 0; ye < hauteur; ye++) {
            for (int xe = 0; xe < largeur; xe++) {
                Couleur c = vue.couleur(xe, ye);
                octets.putFloat((float) c.r).putFloat((float) c.v).putFloat((float) c.b);
            }
        }
        return Base64.getEncoder().encodeToString(octets.array());
    }

    interface Vue {
        Couleur couleur(int xe, int ye);
    }

    /** Par {@code getCouleurPixel} ; s'il n'existe pas sous cette forme, par les méthodes qu'il appelle. */
    private static Vue vue(Scene scene, Camera camera, int profondeur, double decalage) {
        try {
            Vue vue = decalage == 0 ? parLancer(scene, camera, profondeur)
                    : parLancer(scene, camera, profondeur, decalage);
            vue.couleur(0, 0);
            return vue;
        } catch (Error e) {
            return (xe, ye) -> parRayon(scene, camera.getRayon(xe + decalage, ye + decalage), profondeur);
        }
    }

    /** Des entiers : {@code getCouleurPixel} peut les vouloir. */
    private static Vue parLancer(Scene scene, Camera camera, int profondeur) {
        Lancer lancer = new Lancer(scene, camera);
        return (xe, ye) -> lancer.getCouleurPixel(xe, ye, profondeur);
    }

    private static Vue parLancer(Scene scene, Camera camera, int profondeur, double decalage) {
        Lancer lancer = new Lancer(scene, camera);
        return (xe, ye) -> lancer.getCouleurPixel(xe + decalage, ye + decalage, profondeur);
    }

    static Couleur parRayon(Scene scene, Rayon rayon, int profondeur) {
        PointContact contact = scene.getClosestIntersection(rayon, null);
        return contact == null ? rayon.getSkyColor() : contact.objet.getColor(scene, rayon, contact, profondeur);
    }
}
