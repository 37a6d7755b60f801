package lancer.rapide;

import java.util.Arrays;
import lancer.Camera;
import lancer.Constantes;
import lancer.Point;
import lancer.contrat.Recherche;
import lancer.precision.Intersection;

/**
 * Ce que l'on voit d'un point, case par case : les sphères dont la silhouette touche la case, de la plus proche à la
 * plus lointaine. Une case qu'une sphère couvre tout entière a une coupe : ce qui est au-delà est caché, et n'y est pas
 * noté. Une lampe est ponctuelle et le cours fait partir d'elle les rayons d'ombre, donc elle voit la scène comme une
 * seconde caméra (« light buffer », Haines et Greenberg, 1986) : une question coûte une ou deux sphères au lieu d'une
 * descente d'arbre, cinq à neuf fois moins.
 */
final class Carte implements Intersections, Occultations {

    /** Une sphère dont le point est aussi près de la surface est notée dans toutes les cases. */
    private static final double CONTRE_LA_SURFACE = 1e-9;

    /** Entre ces distances, les carrés se calculent sans détour. */
    private static final double LOIN_MIN = 1e-120;
    private static final double LOIN_MAX = 1e140;

    /** Cases examinées, par place permise, au-delà desquelles la carte coûte plus qu'elle ne rendra. */
    private static final long TRAVAIL = 16;

    /** Sphères dans la case d'une sphère, en moyenne, au-delà desquelles un arbre répond mieux qu'une carte. */
    private static final int ENCOMBREE = 20;

    /** Marge des distances de coupe : les distances calculées sous une coupe sont justes à 1e-10 près. */
    private static final double MARGE_COUPE = 1e-7;

    private final Spheres spheres;
    private final Point origine;
    private final boolean deLOeil;
    /** Pour un rayon qui n'est pas de ceux de la carte, ou que le compte ne permet pas. */
    private final Arbre secours;
    private final int parFace;
    private final Face[] faces;

    /**
     * Première entrée de chaque case, et pour chaque entrée une sphère et une distance qu'aucun de ses points ne
     * précède.
     */
    int[] debut;
    int[] entrees;
    float[] pres;

    /** Pour chaque case, la distance de coupe (+∞ sans coupe) et la sphère qui coupe. */
    final float[] coupe;
    final int[] coupeuse;

    /**
     * La carte d'une lampe, ou celle de l'œil : ses rayons partent de l'écran, où que ce soit dans un pixel, et tous
     * s'éloignent d'un même point.
     *
     * @param faces fenêtres par où la scène se voit de cette origine ; pour l'œil, celle de l'image
     * @param places au plus, dans les cases
     * @return {@code null} si elles débordent, ou en ont trop chacune : les sphères sont trop serrées, vues de ce point
     */
    static Carte de(Spheres spheres, Point origine, boolean deLOeil, Face[] faces, Arbre secours, long places) {
        Carte carte = new Carte(spheres, origine, deLOeil, faces, secours);
        return carte.remplir(origine.x, origine.y, origine.z, places) ? carte : null;
    }

    private Carte(Spheres spheres, Point origine, boolean deLOeil, Face[] faces, Arbre secours) {
        this.spheres = spheres;
        this.origine = origine;
        this.deLOeil = deLOeil;
        this.faces = faces;
        this.secours = secours;
        parFace = faces[0].colonnes * faces[0].lignes;
        coupe = new float[faces.length * parFace];
        coupeuse = new int[coupe.length];
        Arrays.fill(coupe, Float.POSITIVE_INFINITY);
    }

    /** Note chaque sphère dans les cases où elle peut se voir ; faux si c'est trop de places, ou trop de travail. */
    private boolean remplir(double ox, double oy, double oz, long places) {
        int n = spheres.nombre;
        int cases = coupe.length;
        Entrees liste = new Entrees(cases);
        long travail = TRAVAIL * (places + cases);
        double[] g = spheres.geometrie;
        long[] ordre = parDistance(spheres, ox, oy, oz);
        for (int o = 0; o < n; o++) {
            Recherche.obeir();
            if (liste.nombre > places || travail < 0) {
                return false;
            }
            int k = (int) ordre[o];
            float proche = Float.intBitsToFloat((int) (ordre[o] >>> 32));
            int s = Spheres.PAS * k;
            double x = g[s] - ox;
            double y = g[s + 1] - oy;
            double z = g[s + 2] - oz;
            double loin = Math.sqrt(x * x + y * y + z * z);
            double r = g[s + 3] / loin;
            if (!(loin > LOIN_MIN && loin < LOIN_MAX && r < 1 - CONTRE_LA_SURFACE)) {
                // le point y est, ou presque : à examiner partout, d'abord
                for (int c = 0; c < cases && liste.nombre <= places; c++) {
                    liste.noter(c, k, 0);
                }
                continue;
            }
            x /= loin;
            y /= loin;
            z /= loin;
            // nul rayon n'entre dans une sphère plus loin que ceux qui la frôlent
            float tangente = enHaut(loin * Math.sqrt(1 - r * r) * (1 + MARGE_COUPE));
            // ce qui coupe l'écran n'en couvre rien
            boolean peutCouper = !deLOeil || g[s + 2] - g[s + 3] > 1e-9 * (loin + g[s + 3]);
            for (int f = 0; f < faces.length; f++) {
                if (faces[f].silhouette(x, y, z, r)) {
                    travail -= noter(liste, f, k, proche, peutCouper ? tangente : Float.POSITIVE_INFINITY);
                }
            }
        }
        if (liste.nombre > places) {
            return false;
        }
        garder(liste);
        return !estEncombree(n);
    }

    /**
     * Note la sphère k dans les cases de la face f que touche sa silhouette, où aucune autre ne la cache.
     *
     * @param proche distance qu'aucun de ses points ne précède
     * @param tangente distance au-delà de laquelle ce qu'elle couvre est caché, +∞ si elle ne cache rien
     * @return le nombre de cases regardées
     */
    private long noter(Entrees liste, int f, int k, float proche, float tangente) {
        Face face = faces[f];
        long regardees = 0;
        for (int j = face.ligne0; j <= face.ligne1; j++) {
            int ligne = f * parFace + j * face.colonnes;
            int a = face.a[j];
            regardees += 1 + Math.max(0, a - face.de[j]);
            for (int i = face.de[j]; i <= a; i++) {
                int c = ligne + i;
                if (proche > coupe[c]) {
                    continue;
                }
                liste.noter(c, k, proche);
                if (tangente < coupe[c] && i >= face.couvertDe[j] && i <= face.couvertA[j]) {
                    coupe[c] = tangente;
                    coupeuse[c] = k;
                }
            }
        }
        return regardees;
    }

    /** Range à plat les entrées qu'aucune coupe ne cache. */
    private void garder(Entrees liste) {
        int cases = coupe.length;
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

    /** Vrai si une sphère prise au hasard a trop de voisines dans ses cases. */
    private boolean estEncombree(int n) {
        long[] voisines = new long[n];
        int[] places = new int[n];
        for (int c = 0; c < coupe.length; c++) {
            for (int e = debut[c]; e < debut[c + 1]; e++) {
                voisines[entrees[e]] += debut[c + 1] - debut[c];
                places[entrees[e]]++;
            }
        }
        double somme = 0;
        int vues = 0;
        for (int k = 0; k < n; k++) {
            if (places[k] > 0) {
                somme += (double) voisines[k] / places[k];
                vues++;
            }
        }
        return somme > ENCOMBREE * (double) vues;
    }

    /**
     * Les numéros des sphères dans la moitié basse, par distance croissante ; celle-ci, arrondie vers 0, dans la haute.
     */
    private static long[] parDistance(Spheres spheres, double ox, double oy, double oz) {
        double[] g = spheres.geometrie;
        long[] ordre = new long[spheres.nombre];
        for (int k = 0; k < ordre.length; k++) {
            int s = Spheres.PAS * k;
            double x = g[s] - ox;
            double y = g[s + 1] - oy;
            double z = g[s + 2] - oz;
            double d = Math.sqrt(x * x + y * y + z * z);
            double r = g[s + 3];
            double proche = d - r - 1e-9 * (d + r);
            ordre[k] = (long) Float.floatToRawIntBits(proche > 0 && d < LOIN_MAX ? enBas(proche) : 0) << 32 | k;
        }
        return Tri.parMoitieHaute(ordre);
    }

    /**
     * Pour la carte de l'œil : la sphère que rencontre d'abord un rayon, parmi celles que note sa case. Un rayon qui ne
     * vient pas de l'œil, ou que le compte ne permet pas, est pour le secours.
     */
    @Override
    public int plusProche(Parcours parcours, double px, double py, double pz, double vx, double vy, double vz,
            int sauf) {
        int c = faces[0].caseDeLOeil(px, py, pz, vx, vy, vz);
        if (c < 0) {
            return secours.plusProche(parcours, px, py, pz, vx, vy, vz, sauf);
        }
        // les distances de la carte partent de l'œil, et V.z = FOCALE / ‖P − Œil‖
        double avance = Camera.FOCALE / vz * (1 + 1e-12);
        parcours.distance = Constantes.INFINI;
        parcours.compteurs.noeudsVisites++;
        int premiere = debut[c];
        int derniere = debut[c + 1];
        if (premiere == derniere) {
            return -1;
        }
        double[] g = spheres.geometrie;
        double distance = Constantes.INFINI;
        int trouvee = -1;
        long credit = parcours.credit + Parcours.PAR_RAYON;
        int fin = derniere - premiere <= credit ? derniere : premiere + (int) credit;
        int e = premiere;
        for (; e < fin && pres[e] - avance <= distance; e++) {
            int k = entrees[e];
            int s = Spheres.PAS * k;
            double d = Intersection.distanceOuDoute(px, py, pz, vx, vy, vz, g[s], g[s + 1], g[s + 2], g[s + 3]);
            if (d < 0) {
                d = Intersection.auMoins(d) > distance ? Constantes.INFINI
                        : parcours.trancher(spheres, k, px, py, pz, vx, vy, vz);
            }
            if (d <= distance && Spheres.avant(d, k, distance, trouvee)) {
                distance = d;
                trouvee = k;
            }
        }
        parcours.compteurs.testsSpheres += e - premiere;
        parcours.credit = credit - (e - premiere);
        if (e >= fin && e < derniere && pres[e] - avance <= distance) {
            return secours.plusProche(parcours, px, py, pz, vx, vy, vz, sauf);
        }
        parcours.distance = distance;
        return trouvee;
    }

    /** {@inheritDoc} Pour la carte d'une lampe. */
    @Override
    public boolean cachee(Parcours parcours, double px, double py, double pz, double vx, double vy, double vz,
            double distance, int sauf) {
        if (px != origine.x || py != origine.y || pz != origine.z) {
            return secours.cachee(parcours, px, py, pz, vx, vy, vz, distance, sauf);
        }
        int c = caseDe(vx, vy, vz);
        if (c < 0) {
            return false;
        }
        parcours.compteurs.noeudsVisites++;
        if (distance > coupe[c]) {
            // ou bien le contact est sur la sphère qui coupe, un rien plus loin qu'elle par un arrondi
            return coupeuse[c] != sauf || secours.cachee(parcours, px, py, pz, vx, vy, vz, distance, sauf);
        }
        double[] g = spheres.geometrie;
        int premiere = debut[c];
        int derniere = debut[c + 1];
        long credit = parcours.credit + Parcours.PAR_RAYON;
        int fin = derniere - premiere <= credit ? derniere : premiere + (int) credit;
        int tests = 0;
        int e = premiere;
        boolean cachee = false;
        for (; e < fin && !cachee && pres[e] < distance; e++) {
            int k = entrees[e];
            if (k != sauf) {
                tests++;
                int s = Spheres.PAS * k;
                double d = Intersection.distanceOuDoute(px, py, pz, vx, vy, vz, g[s], g[s + 1], g[s + 2], g[s + 3]);
                cachee = d < distance && (d >= 0 || Intersection.auMoins(d) < distance
                        && parcours.trancher(spheres, k, px, py, pz, vx, vy, vz) < distance);
            }
        }
        parcours.compteurs.testsSpheres += tests;
        parcours.credit = credit - (e - premiere);
        return cachee || e >= fin && e < derniere && pres[e] < distance
                && secours.cachee(parcours, px, py, pz, vx, vy, vz, distance, sauf);
    }

    /** Le flottant juste au-dessous, ou égal. */
    private static float enBas(double x) {
        float f = (float) x;
        return f <= x ? f : Math.nextDown(f);
    }

    /** Le flottant juste au-dessus, ou égal. */
    private static float enHaut(double x) {
        float f = (float) x;
        return f >= x ? f : Math.nextUp(f);
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
