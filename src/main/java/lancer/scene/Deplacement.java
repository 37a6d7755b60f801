package lancer.scene;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import lancer.Lampe;
import lancer.Point;
import lancer.Sphere;

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

    /** La position de cette sphère ou de cette lampe ; {@code null} pour une autre forme. */
    public static Point position(Object chose) {
        return chose instanceof Lampe ? ((Lampe) chose).getPosition()
                : chose instanceof Sphere ? ((Sphere) chose).getCentre() : null;
    }

    /** La même sphère, ou la même lampe, à cette position. */
    public static Object en(Object chose, Point ou) {
        if (chose instanceof Lampe) {
            return new Lampe(ou, ((Lampe) chose).getCouleur());
        }
        Sphere sphere = (Sphere) chose;
        Sphere autre = new Sphere(ou, sphere.getRayon());
        autre.setKd(sphere.getKd());
        autre.setKs(sphere.getKs());
        autre.setNs(sphere.getNs());
        return autre;
    }

    /**
     * Les déplacements faits depuis {@code lue}, faits dans la scène relue. Si le fichier a changé une position, la
     * sienne l'emporte, sauf si {@code malgreLui} est vrai.
     */
    public static SceneLue reporter(SceneLue lue, SceneLue deplacee, SceneLue relue, boolean malgreLui) {
        SceneLue faite = relue;
        for (int k : deplaces(lue, deplacee)) {
            Object ancien = choses(lue).get(k);
            Point voulue = position(choses(deplacee).get(k));
            String debut = nom(lue, ancien) + " ligne ";
            Object ici = choses(relue).stream().filter(chose -> (relue.origines.de(chose) + "").startsWith(debut))
                    .findFirst().orElse(null);
            Point sienne = position(ici);
            if (sienne != null && !sienne.equals(voulue) && (malgreLui || sienne.equals(position(ancien)))) {
                faite = new SceneLue(faite, ici, en(ici, voulue));
            }
        }
        return faite;
    }

    /** Les sections des objets et des lampes déplacés, avec leur nouvelle position, à copier dans le fichier. */
    public static String sections(SceneLue lue, SceneLue deplacee) {
        return Arrays.stream(deplaces(lue, deplacee)).mapToObj(k -> choses(deplacee).get(k))
                .map(chose -> nom(deplacee, chose) + (chose instanceof Lampe ? "\nposition=" : "\ncentre=")
                        + ecrire(position(chose)) + "\n\n").collect(Collectors.joining());
    }

    private static int[] deplaces(SceneLue lue, SceneLue deplacee) {
        List<Object> avant = choses(lue);
        List<Object> apres = choses(deplacee);
        return IntStream.range(0, avant.size()).filter(k -> avant.get(k) != apres.get(k)).toArray();
    }

    private static List<Object> choses(SceneLue scene) {
        List<Object> choses = new ArrayList<>(scene.objets);
        choses.addAll(scene.lampes);
        return choses;
    }

    private static String nom(SceneLue scene, Object chose) {
        return scene.origines.de(chose).replaceFirst(" ligne \\d+$", "");
    }

    private static String ecrire(Point p) {
        return DoubleStream.of(p.x, p.y, p.z).mapToObj(x -> x == 0 ? "0"
                : new BigDecimal(Double.toString(x)).stripTrailingZeros().toPlainString())
                .collect(Collectors.joining(" "));
    }
}
