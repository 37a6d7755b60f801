package lancer.mesures.trace;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import org.jfree.chart.labels.ItemLabelAnchor;
import org.jfree.chart.labels.ItemLabelPosition;
import org.jfree.chart.ui.TextAnchor;

/** Des marques de même couleur et de même forme, et leur nom dans la légende. */
public final class Serie {

    final String nom;
    final Color couleur;
    final FormeDePoint forme;
    final boolean reliee;
    final List<Marque> marques;

    /** Place du nom de chaque marque. */
    ItemLabelPosition place = new ItemLabelPosition(ItemLabelAnchor.OUTSIDE1, TextAnchor.BOTTOM_LEFT);

    /** @param reliee vrai si un trait joint les marques, dans l'ordre donné */
    public Serie(String nom, Color couleur, FormeDePoint forme, boolean reliee, List<Marque> marques) {
        this.nom = nom;
        this.couleur = couleur;
        this.forme = forme;
        this.reliee = reliee;
        this.marques = new ArrayList<>(marques);
    }

    /** Écrit le nom de chaque marque en bas à gauche, au lieu d'en haut à droite. */
    public Serie nommeeAGauche() {
        place = new ItemLabelPosition(ItemLabelAnchor.OUTSIDE7, TextAnchor.TOP_RIGHT);
        return this;
    }
}
