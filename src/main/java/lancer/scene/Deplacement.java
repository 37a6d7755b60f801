package lancer.scene;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Sphere;
import lancer.texte.Nombre;

/** Déplacement d'une sphère ou d'une lampe dans une scène lue. */
public final class Deplacement {

    /** Écart permis entre la position voulue et la position écrite, en pixels. */
    private static final double ECART = 0.1;

    private Deplacement() {
    }

    /** Cette position, avec le moins de décimales possible. @param pixels nombre de pixels d'une unité de la scène */
    public static Point arrondir(Point p, double pixels) {
        return new Point(arrondir(p.x, pixels), arrondir(p.y, pixels), arrondir(p.z, pixels));
    }

    private static double arrondir(double x, double pixels) {
        BigDecimal exact = new BigDecimal(x);
        return IntStream.rangeClosed(-(int) Math.log10(1 + Math.abs(x)), 17)
                .mapToDouble(decimales -> exact.setScale(decimales, RoundingMode.HALF_EVEN).doubleValue())
                .filter(arrondi -> Math.abs(arrondi - x) * pixels <= ECART).findFirst().orElse(x);
    }

    public static Sphere en(Sphere sphere, Point centre) {
        Sphere autre = new Sphere(centre, sphere.getRayon());
        autre.setKd(sphere.getKd());
        autre.setKs(sphere.getKs());
        autre.setNs(sphere.getNs());
        return autre;
    }

    /** Les sections des objets et des lampes déplacés, avec leur nouvelle position, à copier dans le fichier. */
    public static String sections(SceneLue lue, SceneLue deplacee) {
        return IntStream.range(0, lue.objets.size()).filter(k -> lue.objets.get(k) != deplacee.objets.get(k))
                .mapToObj(k -> section(deplacee, deplacee.objets.get(k))).collect(Collectors.joining())
                + IntStream.range(0, lue.lampes.size()).filter(k -> lue.lampes.get(k) != deplacee.lampes.get(k))
                .mapToObj(k -> section(deplacee, deplacee.lampes.get(k))).collect(Collectors.joining());
    }

    private static String section(SceneLue scene, Object chose) {
        boolean objet = chose instanceof Objet3D;
        Point p = objet ? ((Sphere) chose).getCentre() : ((Lampe) chose).getPosition();
        return scene.origines.de(chose).replaceFirst(" ligne \\d+$", "") + (objet ? "\ncentre=" : "\nposition=")
                + Nombre.ecrire(p.x) + " " + Nombre.ecrire(p.y) + " " + Nombre.ecrire(p.z) + "\n\n";
    }
}
