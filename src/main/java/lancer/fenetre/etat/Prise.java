package lancer.fenetre.etat;

import lancer.Camera;
import lancer.Constantes;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Point;
import lancer.PointContact;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.dessin.Dessin;
import lancer.scene.SceneLue;

/** Ce que prennent et déplacent Maj et la souris, parallèlement à l'écran : une sphère, une étoile de lampe. */
public final class Prise {

    private Prise() {
    }

    /** Le point de l'image où l'œil voit p : x et y, en pixels ; z est le nombre de pixels d'une unité en p. */
    public static Point projeter(Camera camera, Point p) {
        Vecteur vu = camera.depuisLOeil(p);
        Vecteur coin = camera.depuisLOeil(camera.getEcran(0, 0));
        double pixels = coin.z / vu.z * camera.getLargeur() / Constantes.ECHELLE;
        double unite = camera.getLargeur() / Constantes.ECHELLE;
        return new Point(vu.x * pixels - coin.x * unite, coin.y * unite - vu.y * pixels, pixels);
    }

    /** Le point de l'image où se voit cette lampe ; {@code null} si elle est derrière l'œil. */
    public static Point etoile(Camera camera, Lampe lampe) {
        Point vu = projeter(camera, lampe.getPosition());
        return vu.z > 0 && vu.z < Double.POSITIVE_INFINITY ? vu : null;
    }

    /** La section de la lampe ou de la sphère qui est là ; {@code null} si rien n'y peut être pris. */
    static String viser(Dessin montre, SceneLue scene, double xe, double ye, double portee) {
        Lancer lancer = montre.lancer;
        for (Lampe lampe : scene.lampes) {
            Point ou = etoile(lancer.getCamera(), lampe);
            if (ou != null && Math.hypot(ou.x - xe, ou.y - ye) < portee) {
                return scene.getNomDeSection(lampe);
            }
        }
        PointContact contact = lancer.getScene().pourUnFil()
                .getClosestIntersection(lancer.getCamera().getRayon(xe, ye));
        // l'image montrée peut être celle d'avant le dernier changement, où cet objet avait une autre place
        String section = contact == null ? null : montre.demande.lue.getNomDeSection(contact.objet);
        Object chose = section == null ? null : scene.getChose(section);
        if (chose == null || chose.getClass() != Sphere.class) {
            return null;
        }
        double pixels = projeter(lancer.getCamera(), ((Sphere) chose).getCentre()).z;
        // plus large que l'image, ou autour de l'œil, c'est un sol ou une voûte
        boolean petite = pixels > 0 && 2 * pixels * ((Sphere) chose).getRayon() <= lancer.getCamera().getLargeur();
        return petite ? section : null;
    }

    /** La place, tirée d'un point de l'image à un autre, de ce qui est à cette origine. */
    static Point deplacer(Camera camera, Point origine, double deXe, double deYe, double xe, double ye) {
        double pixels = projeter(camera, origine).z;
        // ce que la souris parcourt à l'écran, agrandi comme l'est le plan de ce qui est pris
        Vecteur de = new Vecteur(camera.getEcran(deXe, deYe), camera.getEcran(xe, ye))
                .mul(camera.getLargeur() / Constantes.ECHELLE / pixels);
        // à un dixième de pixel : la valeur à écrire est courte
        double fois = Math.pow(10, Math.ceil(Math.log10(5 * pixels)));
        return new Point(bouger(origine.x, de.x, fois), bouger(origine.y, de.y, fois), bouger(origine.z, de.z, fois));
    }

    private static double bouger(double x, double de, double fois) {
        // la coordonnée que rien ne bouge reste celle du fichier
        return Math.abs(de * fois) < 0.5 ? x : Math.rint((x + de) * fois) / fois;
    }
}
