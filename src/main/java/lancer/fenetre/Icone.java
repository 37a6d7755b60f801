package lancer.fenetre;

import java.awt.Image;
import java.util.ArrayList;
import java.util.List;
import javax.swing.ImageIcon;

/** L'icône du programme : la scène du cours, que {@code make images} lui fait dessiner. */
final class Icone {

    private static final int[] COTES = {16, 32, 48, 128};

    private Icone() {
    }

    /** La même à plusieurs tailles, entre lesquelles le bureau choisit. */
    static List<Image> lire() {
        List<Image> icones = new ArrayList<>();
        for (int cote : COTES) {
            icones.add(new ImageIcon(Icone.class.getResource("icone-" + cote + ".png")).getImage());
        }
        return icones;
    }
}
