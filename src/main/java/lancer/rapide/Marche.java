package lancer.rapide;

import lancer.Constantes;
import lancer.Point;
import lancer.Vecteur;

/**
 * Les cubes que traverse un rayon, l'un après l'autre (Amanatides et Woo, <i>A Fast Voxel Traversal Algorithm for Ray
 * Tracing</i>, 1987).
 */
final class Marche implements Source {

    /** Nombre d'enveloppes d'un cube trop plein. */
    private static final int PLEIN = 30;

    private final Cellules c;

    /** Le cube suivant, et la distance où le rayon y entre : +∞ s'il est sorti de la grille. */
    private int cube;
    private double entree;

    /** Par axe : distance du bord suivant et entre deux bords, écart entre les rangs de deux cubes, cubes de reste. */
    private double tx;
    private double ty;
    private double tz;
    private double dx;
    private double dy;
    private double dz;
    private int pasX;
    private int pasY;
    private int pasZ;
    private int resteX;
    private int resteY;
    private int resteZ;

    Marche(Cellules cellules) {
        c = cellules;
    }

    /** Place ce rayon au premier cube qu'il traverse. */
    void entrer(Point p, Vecteur v) {
        double wx = Descente.inverse(v.x);
        double wy = Descente.inverse(v.y);
        double wz = Descente.inverse(v.z);
        double ax = (c.x0 - p.x) * wx;
        double ay = (c.y0 - p.y) * wy;
        double az = (c.z0 - p.z) * wz;
        dx = c.cote * wx;
        dy = c.cote * wy;
        dz = c.cote * wz;
        double bx = ax + c.nx * dx;
        double by = ay + c.ny * dy;
        double bz = az + c.nz * dz;
        double sortie = Math.min(Math.max(ax, bx), Math.min(Math.max(ay, by), Math.max(az, bz)));
        entree = Math.max(0, Math.max(Math.min(ax, bx), Math.max(Math.min(ay, by), Math.min(az, bz))));
        if (entree > sortie) {
            entree = Constantes.INFINI;
        }
        int i = Math.max(0, Math.min((int) ((p.x + entree * v.x - c.x0) * c.parCote), c.nx - 1));
        int j = Math.max(0, Math.min((int) ((p.y + entree * v.y - c.y0) * c.parCote), c.ny - 1));
        int l = Math.max(0, Math.min((int) ((p.z + entree * v.z - c.z0) * c.parCote), c.nz - 1));
        tx = ax + (wx > 0 ? i + 1 : i) * dx;
        ty = ay + (wy > 0 ? j + 1 : j) * dy;
        tz = az + (wz > 0 ? l + 1 : l) * dz;
        resteX = wx > 0 ? c.nx - 1 - i : i;
        resteY = wy > 0 ? c.ny - 1 - j : j;
        resteZ = wz > 0 ? c.nz - 1 - l : l;
        pasX = wx > 0 ? c.ny * c.nz : -c.ny * c.nz;
        pasY = wy > 0 ? c.nz : -c.nz;
        pasZ = wz > 0 ? 1 : -1;
        dx = Math.abs(dx);
        dy = Math.abs(dy);
        dz = Math.abs(dz);
        cube = (i * c.ny + j) * c.nz + l;
    }

    @Override
    public Suite suivante(Liste liste, double limite) {
        while (entree <= limite && entree < Constantes.INFINI) {
            int debut = c.debut[cube];
            int fin = c.debut[cube + 1];
            liste.examens++;
            if (fin - debut > PLEIN || liste.examens > EXAMENS_MAX) {
                return Suite.TROP;
            }
            avancer();
            if (debut < fin) {
                liste.donner(c.objets, debut, fin);
                return Suite.LISTE;
            }
        }
        return Suite.FIN;
    }

    /** Va au cube suivant. */
    private void avancer() {
        if (tx <= ty && tx <= tz) {
            entree = resteX-- == 0 ? Constantes.INFINI : tx;
            cube += pasX;
            tx += dx;
        } else if (ty <= tz) {
            entree = resteY-- == 0 ? Constantes.INFINI : ty;
            cube += pasY;
            ty += dy;
        } else {
            entree = resteZ-- == 0 ? Constantes.INFINI : tz;
            cube += pasZ;
            tz += dz;
        }
    }
}
