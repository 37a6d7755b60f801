package lancer.mesures.trace;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.List;

/** Un texte coupé entre ses mots pour tenir dans une largeur. */
final class Paragraphe {

    private final List<String> lignes = new ArrayList<>();
    private final FontMetrics mesures;
    private final Font police;

    Paragraphe(Graphics2D g, String texte, Font police, double largeur) {
        this.police = police;
        mesures = g.getFontMetrics(police);
        StringBuilder ligne = new StringBuilder();
        for (String mot : insecable(texte).split(" ")) {
            if (ligne.length() > 0 && mesures.stringWidth(ligne + " " + mot) > largeur) {
                lignes.add(ligne.toString());
                ligne.setLength(0);
            }
            ligne.append(ligne.length() > 0 ? " " : "").append(mot);
        }
        if (ligne.length() > 0) {
            lignes.add(ligne.toString());
        }
    }

    /** Ni un guillemet ni une ponctuation haute ne se séparent de leur mot, ni un nombre de ce qui le suit. */
    private static String insecable(String texte) {
        return texte.replaceAll("« ", "«\u00A0").replaceAll(" ([»:;%?!×])", "\u00A0$1").replaceAll("; (?=[0-9])", ";\u00A0")
                .replaceAll("([0-9×]) (?=[0-9×a-z])", "$1\u00A0");
    }

    double hauteur() {
        return lignes.size() * mesures.getHeight();
    }

    /** Écrit, le haut en {@code y}. */
    void dessiner(Graphics2D g, double x, double y, Color couleur) {
        g.setFont(police);
        g.setColor(couleur);
        for (int k = 0; k < lignes.size(); k++) {
            g.drawString(lignes.get(k), (float) x, (float) (y + k * mesures.getHeight() + mesures.getAscent()));
        }
    }
}
