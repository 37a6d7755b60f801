package lancer.rapide;

import java.util.Arrays;
import lancer.Constantes;
import lancer.Sphere;

/**
 * Ce que l'on voit d'un point, case par case : les sphères dont la silhouette touche la case, de la plus proche à la plus
 * lointaine. Une case qu'une sphère couvre tout entière a une coupe : ce qui est au-delà est caché, et n'y est pas noté.
 */
final class Carte {

    /** Une sphère dont le point est aussi près de la surface est notée dans toutes les cases. */
    private static final double CONTRE_LA_SURFACE = 1e-9;

    /** Entre ces distances, les carrés se calculent sans détour. */
    private static final double LOIN_MIN = 1e-120;
    private static final double LOIN_MAX = 1e140;

    /** Marge des distances de coupe : les distances calculées sous une coupe sont justes à 1e-10 près. */
    private static final double MARGE_COUPE = 1e-7;

    /** Entrées par case au-delà desquelles la carte n'en est plus une. */
    private static final int ENTREES_PAR_CASE = 8;

    private static final int SANS_COUPE = 0;
    private static final int COUPE = 1;
    private static final int COUPE_DEVANT_L_ECRAN = 2;

    /** Réponse de {@link #plusProche} pour une direction qui n'est d'aucune case. */
    static final int HORS = -2;

    private final Spheres spheres;
    private final int parFace;
    private final Face[] faces;

    /** Première entrée de chaque case, et pour chaque entrée une sphère et une distance qu'aucun de ses points ne précède. */
    final int[] debut;
    final int[] entrees;
    final float[] pres;

    /** Pour chaque case, la distance de coupe (+∞ sans coupe) et la sphère qui coupe. */
    final float[] coupe;
    final int[] coupeuse;

    /** Faux si les cases débordent : les sphères sont trop serrées, vues de ce point. */
    final boolean bonne;

    /** La carte d'un point. @param deLOeil vrai si les rayons partent de l'écran : ce qui le coupe n'en couvre rien */
    static Carte duPoint(Spheres spheres, double ox, double oy, double oz, Face[] faces, boolean deLOeil) {
        return new Carte(spheres, ox, oy, oz, 0, -1, faces, deLOeil ? COUPE_DEVANT_L_ECRAN : COUPE);
    }

    /** La carte de tout ce que voit la surface de la sphère {@code depart}, elle-même exceptée ; sans coupe. */
    static Carte deLaSurface(Spheres spheres, int depart, double marge, Face[] faces) {
        double[] g = spheres.geometrie;
        int s = Spheres.PAS * depart;
        return new Carte(spheres, g[s], g[s + 1], g[s + 2], g[s + 3] + marge, depart, faces, SANS_COUPE);
    }

    private Carte(Spheres spheres, double ox, double oy, double oz, double grossi, int sauf, Face[] faces, int coupes) {
        this.spheres = spheres;
        this.faces = faces;
        int n = spheres.nombre;
        parFace = faces[0].colonnes * faces[0].lignes;
        int cases = faces.length * parFace;
        coupe = new float[cases];
        coupeuse = new int[cases];
        Arrays.fill(coupe, Float.POSITIVE_INFINITY);
        Entrees liste = new Entrees(cases);
        long maximum = coupes == SANS_COUPE ? Long.MAX_VALUE : (long) ENTREES_PAR_CASE * cases + n;
        double[] g = spheres.geometrie;
        long[] ordre = parDistance(spheres, ox, oy, oz, grossi);
        for (int o = 0; o < n && liste.nombre <= maximum; o++) {
            int k = (int) ordre[o];
            float proche = Float.intBitsToFloat((int) (ordre[o] >>> 32));
            int s = Spheres.PAS * k;
            double x = g[s] - ox;
            double y = g[s + 1] - oy;
            double z = g[s + 2] - oz;
            double loin = Math.sqrt(x * x + y * y + z * z);
            double r = (g[s + 3] + grossi) / loin;
            if (k == sauf) {
                continue;
            }
            if (!(loin > LOIN_MIN && loin < LOIN_MAX && r < 1 - CONTRE_LA_SURFACE)) {
                // le point y est, ou presque : à examiner partout, d'abord
                for (int c = 0; c < cases && liste.nombre <= maximum; c++) {
                    liste.noter(c, k, 0);
                }
                continue;
            }
            x /= loin;
            y /= loin;
            z /= loin;
            boolean peutCouper = coupes == COUPE || coupes == COUPE_DEVANT_L_ECRAN && g[s + 2] - g[s + 3] > 1e-9 * (loin + g[s + 3]);
            for (int f = 0; f < faces.length; f++) {
                Face face = faces[f];
                if (!face.silhouette(x, y, z, r)) {
                    continue;
                }
                for (int j = face.ligne0; j <= face.ligne1; j++) {
                    int ligne = f * parFace + j * face.colonnes;
                    int a = face.a[j];
                    for (int i = face.de[j]; i <= a; i++) {
                        int c = ligne + i;
                        if (proche > coupe[c]) {
                            continue;
                        }
                        liste.noter(c, k, proche);
                        if (peutCouper && i >= face.couvertDe[j] && i <= face.couvertA[j]) {
                            float d = Etendue.enHaut(face.entree(i, j, x, y, z, r) * loin * (1 + MARGE_COUPE));
                            if (d < coupe[c]) {
                                coupe[c] = d;
                                coupeuse[c] = k;
                            }
                        }
                    }
                }
            }
        }
        bonne = liste.nombre <= maximum;
        entrees = new int[liste.nombre];
        pres = new float[liste.nombre];
        debut = new int[cases + 1];
        int e = 0;
        for (int c = 0; c < cases; c++) {
            debut[c] = e;
            // ce qu'une sphère venue plus tard a fini par couvrir ne sert plus
            for (int q = liste.tete[c]; q >= 0 && liste.proche[q] <= coupe[c]; q = liste.apres(q, c)) {
                entrees[e] = liste.sphere[q];
                pres[e++] = liste.proche[q];
            }
        }
        debut[cases] = e;
    }

    /** Les numéros des sphères dans la moitié basse, par distance croissante ; celle-ci, arrondie vers 0, dans la haute. */
    private static long[] parDistance(Spheres spheres, double ox, double oy, double oz, double grossi) {
        double[] g = spheres.geometrie;
        long[] ordre = new long[spheres.nombre];
        for (int k = 0; k < ordre.length; k++) {
            int s = Spheres.PAS * k;
            double x = g[s] - ox;
            double y = g[s + 1] - oy;
            double z = g[s + 2] - oz;
            double d = Math.sqrt(x * x + y * y + z * z);
            double r = g[s + 3] + grossi;
            double proche = d - r - 1e-9 * (d + r);
            ordre[k] = (long) Float.floatToRawIntBits(proche > 0 && d < LOIN_MAX ? Etendue.enBas(proche) : 0) << 32 | k;
        }
        Arrays.sort(ordre);
        return ordre;
    }

    /**
     * La sphère que rencontre d'abord un rayon, parmi celles que note la case d'une direction. Une seule
     * boucle pour l'œil et pour les départs : la compiler une fois au lieu de cinq prend 30 ms de moins à la première image de la
     * scène du cours, sur 240.
     *
     * @param x la direction vue du point de la carte ; d'une carte d'une seule face, (x, y) est le point de sa fenêtre
     * @param avance de combien l'origine du rayon est en avant du point de la carte, au plus
     * @return son numéro, -1 si le rayon n'en rencontre pas, {@link #HORS} si la direction n'est pas dans la carte
     */
    int plusProche(Sonde sonde, double x, double y, double z, double avance, double px, double py, double pz, double vx,
            double vy, double vz) {
        int c;
        if (faces.length == 1) {
            c = faces[0].casePlane(x, y);
        } else {
            int f = Faces.duCube(x, y, z);
            c = f * parFace + faces[f].caseDe(x, y, z);
        }
        sonde.distance = Constantes.INFINI;
        sonde.compteurs.noeudsVisites++;
        if (c < 0) {
            return HORS;
        }
        int premiere = debut[c];
        int fin = debut[c + 1];
        if (premiere == fin) {
            return -1;
        }
        double[] g = spheres.geometrie;
        double distance = Constantes.INFINI;
        int trouvee = -1;
        int douteuse = -1;
        double doute = 0;
        int e = premiere;
        for (; e < fin && pres[e] - avance <= distance; e++) {
            int k = entrees[e];
            int s = Spheres.PAS * k;
            double d = Sphere.distanceOuDoute(px, py, pz, vx, vy, vz, g[s], g[s + 1], g[s + 2], g[s + 3]);
            if (d <= distance && spheres.avant(d, k, distance, trouvee)) {
                if (d >= 0) {
                    distance = d;
                    trouvee = k;
                } else if (douteuse < 0) {
                    douteuse = k;
                    doute = d;
                } else {
                    break;
                }
            }
        }
        sonde.compteurs.testsSpheres += e - premiere;
        sonde.distance = distance;
        sonde.trouvee = trouvee;
        return douteuse < 0 ? trouvee : trancher(sonde, douteuse, doute, e, fin, avance, px, py, pz, vx, vy, vz);
    }

    /** La fin de {@link #plusProche} quand une sphère est en doute : elle d'abord, puis ce qui vient à partir de l'entrée e. */
    private int trancher(Sonde sonde, int douteuse, double doute, int e, int fin, double avance, double px, double py, double pz,
            double vx, double vy, double vz) {
        sonde.retenir(spheres, douteuse, doute, px, py, pz, vx, vy, vz);
        double[] g = spheres.geometrie;
        for (; e < fin && pres[e] - avance <= sonde.distance; e++) {
            int s = Spheres.PAS * entrees[e];
            sonde.compteurs.testsSpheres++;
            double d = Sphere.distanceOuDoute(px, py, pz, vx, vy, vz, g[s], g[s + 1], g[s + 2], g[s + 3]);
            sonde.retenir(spheres, entrees[e], d, px, py, pz, vx, vy, vz);
        }
        return sonde.trouvee;
    }

    /** La case de cette direction, -1 si aucune sphère ne peut y être. */
    int caseDe(double x, double y, double z) {
        if (faces.length == 1) {
            return faces[0].caseDe(x, y, z);
        }
        int f = Faces.duCube(x, y, z);
        return f * parFace + faces[f].caseDe(x, y, z);
    }

    /** Les entrées de chaque case, chaînées dans l'ordre où elles viennent : leur nombre n'est pas connu d'avance. */
    private static final class Entrees {

        int nombre;
        final int[] tete;
        private final int[] queue;
        int[] sphere;
        float[] proche;
        private int[] suivante;

        Entrees(int cases) {
            tete = new int[cases];
            queue = new int[cases];
            Arrays.fill(tete, -1);
            sphere = new int[cases + 64];
            proche = new float[cases + 64];
            suivante = new int[cases + 64];
        }

        void noter(int c, int k, float p) {
            if (nombre == sphere.length) {
                int places = nombre + (nombre >> 1);
                sphere = Arrays.copyOf(sphere, places);
                proche = Arrays.copyOf(proche, places);
                suivante = Arrays.copyOf(suivante, places);
            }
            sphere[nombre] = k;
            proche[nombre] = p;
            if (tete[c] < 0) {
                tete[c] = nombre;
            } else {
                suivante[queue[c]] = nombre;
            }
            queue[c] = nombre++;
        }

        int apres(int q, int c) {
            return q == queue[c] ? -1 : suivante[q];
        }
    }
}
