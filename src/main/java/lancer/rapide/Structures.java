package lancer.rapide;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import lancer.Camera;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;

/** Ce qui est construit pour une scène et une image : cellules de l'espace, de l'œil et de chaque lampe, et arbre. */
final class Structures {

    /** Nombre d'objets par pixel au-delà duquel il n'y a que l'arbre. */
    private static final int OBJETS_PAR_PIXEL = 8;

    /** Nombre de cubes voulu par objet, nombre au moins, nombre pour toutes les lampes ensemble, et rangs par cube. */
    private static final int CUBES_PAR_OBJET = 2;
    private static final int CUBES_AU_MOINS = 1 << 10;
    private static final int CUBES_TOUJOURS = 1 << 18;
    private static final int PLACES_PAR_CUBE = 8;

    final Enveloppes enveloppes;
    private Arbre arbre;
    /** {@code null} là où l'arbre les remplace, comme pour l'œil et chaque lampe. */
    final Cellules espace;
    /** La plus grande coordonnée d'un rayon dans l'espace. */
    final double portee;
    final PointDeVue oeil;
    /** Ceux des lampes, par position. */
    final Map<Point, PointDeVue> vues = new IdentityHashMap<>();

    Structures(List<Objet3D> objets, List<Lampe> lampes, Camera camera) {
        enveloppes = new Enveloppes(objets);
        int n = enveloppes.petits.length;
        double loin = 0;
        for (int k : enveloppes.petits) {
            int s = Enveloppes.PAS * k;
            double[] g = enveloppes.geometrie;
            loin = Math.max(loin, Enveloppes.plusGrande(g[s], g[s + 1], g[s + 2]) + g[s + 3]);
        }
        portee = 1024 * loin;
        boolean avecCellules = n > 0 && n <= OBJETS_PAR_PIXEL * (long) camera.getLargeur() * camera.getHauteur();
        int cubes = Math.max(CUBES_AU_MOINS, CUBES_PAR_OBJET * n);
        espace = avecCellules ? Cellules.de(enveloppes.geometrie, enveloppes.petits, Enveloppes.MARGE * loin, false,
                cubes, PLACES_PAR_CUBE * cubes) : null;
        int permisParVue = Math.max(CUBES_TOUJOURS, cubes) / (1 + lampes.size());
        int cubesParVue = Math.min(permisParVue, cubes);
        int placesParVue = PLACES_PAR_CUBE * permisParVue;
        // il y faut une place au moins par enveloppe
        boolean avecVues = avecCellules && placesParVue >= n;
        oeil = avecVues ? vue(camera.getOeil(), camera.getEcran(0, 0), cubesParVue, placesParVue) : null;
        for (Lampe lampe : avecVues ? lampes : Collections.<Lampe>emptyList()) {
            Point p = lampe.getPosition();
            vues.put(p, vue(p, p, cubesParVue, placesParVue));
        }
    }

    /** L'arbre, construit au premier rayon qui en a besoin. */
    synchronized Arbre getArbre() {
        arbre = arbre == null ? new Arbre(enveloppes) : arbre;
        return arbre;
    }

    private PointDeVue vue(Point p, Point depart, int cubes, int placesMax) {
        PointDeVue vue = new PointDeVue(p, depart, enveloppes, cubes, placesMax);
        return vue.cellules == null ? null : vue;
    }
}
