package lancer.mesures.trace;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;

/** Des marques de même couleur et de même forme, et leur nom dans la légende. */
public final class Serie {

    final String nom;
    final Color couleur;
    final FormeDePoint forme;
    final boolean reliee;
    final List<Marque> marques;

    /** Texte écrit près de la dernière marque ; vide s'il n'y en a pas. */
    String bout = "";

    /** @param reliee vrai si un trait joint les marques, dans l'ordre donné */
    public Serie(String nom, Color couleur, FormeDePoint forme, boolean reliee, List<Marque> marques) {
        this.nom = nom;
        this.couleur = couleur;
        this.forme = forme;
        this.reliee = reliee;
        this.marques = new ArrayList<>(marques);
    }

    /** Écrit ce texte au bout du trait. */
    public Serie auBout(String texte) {
        bout = texte;
        return this;
    }
}
