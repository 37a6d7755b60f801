package lancer.mesures.juge;

import java.awt.image.Raster;
import java.io.IOException;

/** Qui sait dessiner une scène écrite dans la langue de POV-Ray. */
public interface Peintre {

    /** Son nom et sa version. */
    String nom();

    /**
     * @param texte la scène, telle que l'écrit TraductionPov
     * @param nom celui des fichiers à écrire, sans extension
     * @param options d'anticrénelage, dans la langue de sa commande ; aucune pour un rayon par pixel
     * @return l'image linéaire : trois composantes de 16 bits, la ligne du haut d'abord
     * @throws IOException s'il n'y arrive pas ; le message dit pourquoi
     */
    Raster dessiner(String texte, String nom, int largeur, int hauteur, String... options) throws IOException;
}
