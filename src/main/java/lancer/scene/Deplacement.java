package lancer.scene;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import lancer.Point;
import lancer.SceneFautive;
import lancer.texte.Nombre;

/** La place d'un objet ou d'une lampe, telle que sa section l'écrit. */
public final class Deplacement {

    /** Les clés qui donnent une place, par préférence. */
    public static final List<String> CLES = Arrays.asList("centre", "position");

    /** Écart permis entre la position voulue et la position écrite, en pixels. */
    private static final double ECART = 0.1;

    private Deplacement() {
    }

    /** La place que donne cette section, sous l'une des {@link #CLES} ; {@code null} si elle n'en donne pas. */
    public static Point place(SectionLue section) {
        try {
            String cle = cle(section);
            return cle == null ? null : section.point(cle);
        } catch (SceneFautive e) {
            // une forme a pu donner un autre sens à cette clé
            return null;
        }
    }

    /** Celle des {@link #CLES} que donne cette section, ou {@code null}. */
    public static String cle(SectionLue section) {
        return CLES.stream().filter(cle -> section.valeur(cle) != null).findFirst().orElse(null);
    }

    /** Cette position, comme dans un fichier, à un dixième de pixel. @param pixels nombre de pixels d'une unité */
    public static String ecrire(Point p, double pixels) {
        return ecrire(p.x, pixels) + " " + ecrire(p.y, pixels) + " " + ecrire(p.z, pixels);
    }

    private static String ecrire(double x, double pixels) {
        BigDecimal exact = new BigDecimal(x);
        double arrondi = IntStream.rangeClosed(-(int) Math.log10(1 + Math.abs(x)), 17)
                .mapToDouble(decimales -> exact.setScale(decimales, RoundingMode.HALF_EVEN).doubleValue())
                .filter(proche -> Math.abs(proche - x) * pixels <= ECART).findFirst().orElse(x);
        return Nombre.ecrire(arrondi);
    }
}
