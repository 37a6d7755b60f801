package lancer.mesures.trace;

import java.awt.font.TextAttribute;
import java.text.AttributedString;
import org.jfree.chart.axis.LogAxis;
import org.jfree.chart.axis.NumberTickUnit;

/** Un axe logarithmique, gradué par puissances de dix ou, s'il est court, de deux. Les nombres sont écrits à la française. */
final class Axe extends LogAxis {

    private static final long serialVersionUID = 1;

    /** Rapport des bornes au-delà duquel l'axe est long ; nombre de graduations à ne pas dépasser. */
    private static final double LONG = 1000;
    private static final int ASSEZ = 10;

    /** @param min plus grand que 0 */
    Axe(String nom, double min, double max) {
        super(nom);
        setSmallestValue(Math.min(1e-300, min));
        setRange(min, max);
        setBase(max / min > LONG ? 10 : 2);
        setTickUnit(new NumberTickUnit(Math.ceil((calculateLog(max) - calculateLog(min)) / ASSEZ)), false, true);
    }

    @Override
    protected AttributedString createTickLabel(double valeur) {
        AttributedString texte = new AttributedString(valeur >= 1e4 || valeur < 1e-2 ? Style.puissance(valeur) : Style.nombre(valeur));
        texte.addAttribute(TextAttribute.FONT, getTickLabelFont());
        return texte;
    }
}
