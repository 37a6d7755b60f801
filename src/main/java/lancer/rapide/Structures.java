package lancer.rapide;

import java.util.List;
import lancer.Camera;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;

/** Ce qui est construit pour une scène et une image : cellules de l'espace, de l'œil et de chaque lampe, et arbre. */
final class Structures {

    /** Nombre d'objets par pixel au-delà duquel il n'y a que l'arbre. */
    private static final int OBJETS_PAR_PIXEL = 8;

    /** Nombre de cubes voulu par objet, nombre au moins, et nombre pour toutes les lampes ensemble. */
    private static final int CUBES_PAR_OBJET = 2;
    private static final int CUBES_AU_MOINS = 1 << 10;
    private static final int CUBES_TOUJOURS = 1 << 18;

    final Enveloppes enveloppes;
    final Arbre arbre;
    /** {@code null} là où l'arbre les remplace, comme pour l'œil et chaque lampe. */
    final Cellules espace;
    /** La plus grande coordonnée d'un rayon dans l'espace. */
    final double portee;
    final PointDeVue oeil;
    final Point[] lampes;
    final PointDeVue[] vues;

    Structures(List<Objet3D> objets, List<Lampe> siennes, Camera camera) {
        enveloppes = new Enveloppes(objets);
        arbre = new Arbre(enveloppes);
        lampes = siennes.stream().map(Lampe::getPosition).toArray(Point[]::new);
        vues = new PointDeVue[lampes.length];
        int n = enveloppes.petits.length;
        double loin = 0;
        for (int k : enveloppes.petits) {
            int s = Enveloppes.PAS * k;
            double[] g = enveloppes.geometrie;
            loin = Math.max(loin, Enveloppes.plusGrande(g[s], g[s + 1], g[s + 2]) + g[s + 3]);
        }
        portee = 1024 * loin;
        boolean avecCellules = n > 0 && n <= OBJETS_PAR_PIXEL * (long) camera.getLargeur() * camera.getHauteur();
        int voulus = Math.max(CUBES_AU_MOINS, CUBES_PAR_OBJET * n);
        espace = avecCellules
                ? Cellules.de(enveloppes.geometrie, enveloppes.petits, Enveloppes.MARGE * loin, false, voulus) : null;
        int permis = Math.max(CUBES_TOUJOURS, voulus) / (1 + lampes.length);
        int cubes = Math.min(permis, voulus);
        boolean avecVues = avecCellules && cubes > n / 16;
        oeil = avecVues ? vue(camera.getOeil(), camera.getEcran(0, 0), cubes) : null;
        for (int l = 0; l < lampes.length && avecVues; l++) {
            vues[l] = vue(lampes[l], lampes[l], cubes);
        }
    }

    private PointDeVue vue(Point p, Point depart, int cubes) {
        PointDeVue vue = new PointDeVue(p, depart, enveloppes, cubes);
        return vue.cellules == null ? null : vue;
    }
}
