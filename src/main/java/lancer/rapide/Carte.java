package lancer.rapide;

import java.util.Arrays;
import lancer.Constantes;
import lancer.Point;
import lancer.contrat.Recherche;
import lancer.precision.Intersection;

/**
 * Les sphères vues d'un point, notées par case de direction (« light buffer », Haines et Greenberg, 1986). Chaque case
 * donne, de la plus proche à la plus lointaine, les sphères dont la silhouette la touche. Si une sphère couvre toute
 * une case, cette case a une coupe : les sphères plus lointaines n'y sont pas notées. L'œil a une carte. Chaque lampe
 * en a une aussi, car les rayons d'ombre du cours partent de la lampe. Une réponse examine une ou deux sphères.
 */
final class Carte implements Intersections, Occultations {

    /** Nombre de cases examinées, par place permise, au-delà duquel la construction est abandonnée. */
    private static final long TRAVAIL = 16;

    /** Nombre moyen de sphères dans la case d'une sphère au-delà duquel l'arbre est plus rapide. */
    private static final int ENCOMBREE = 20;

    /** Marge des distances de coupe : les distances calculées sont justes à 1e-10 près. */
    private static final double MARGE_COUPE = 1e-7;

    private final Spheres spheres;
    private final Point origine;
    private final boolean deLOeil;
    /** Arbre qui répond si la carte n'accepte pas le rayon ou si le crédit est épuisé. */
    private final Arbre secours;
    private final int parFace;
    private final Face[] faces;

    /** Première entrée de chaque case ; pour chaque entrée, une sphère et une borne inférieure de sa distance. */
    private final int[] debut;
    int[] entrees;
    private float[] pres;
    /** Nombre de places encore permises pendant la construction. */
    private long libres;

    /** Distance de coupe de chaque case (+∞ sans coupe), et sphère de cette coupe. */
    final float[] coupe;
    final int[] coupeuse;

    /**
     * La carte d'une lampe, ou celle de l'œil, dont les rayons partent de l'écran.
     *
     * @param faces fenêtres qui contiennent la scène vue de cette origine ; pour l'œil, celle de l'image
     * @param places nombre maximal d'entrées
     * @return {@code null} s'il faut trop d'entrées, en tout ou par case
     */
    static Carte de(Spheres spheres, Point origine, boolean deLOeil, Face[] faces, Arbre secours, long places) {
        Carte carte = new Carte(spheres, origine, deLOeil, faces, secours, places);
        return carte.remplir() ? carte : null;
    }

    private Carte(Spheres spheres, Point origine, boolean deLOeil, Face[] faces, Arbre secours, long places) {
        this.spheres = spheres;
        this.origine = origine;
        this.deLOeil = deLOeil;
        this.faces = faces;
        this.secours = secours;
        libres = places;
        parFace = faces[0].colonnes * faces[0].lignes;
        coupe = new float[faces.length * parFace];
        coupeuse = new int[coupe.length];
        debut = new int[coupe.length + 1];
        Arrays.fill(coupe, Float.POSITIVE_INFINITY);
    }

    /** Note chaque sphère dans les cases de sa silhouette. @return faux s'il faut trop de places ou d'examens */
    private boolean remplir() {
        long[] ordre = parDistance();
        long travail = TRAVAIL * (libres + coupe.length);
        for (int o = 0; o < ordre.length && libres >= 0 && travail >= 0; o++) {
            travail -= noter(ordre[o]);
        }
        if (libres < 0 || travail < 0) {
            return false;
        }
        int total = Tri.cumuler(debut);
        entrees = new int[total];
        pres = new float[total];
        // de la plus lointaine à la plus proche, car chaque case se remplit par la fin
        for (int o = ordre.length - 1; o >= 0; o--) {
            noter(ordre[o]);
        }
        return !estEncombree();
    }

    /**
     * Compte une sphère dans chaque case que touche sa silhouette, sauf au-delà d'une coupe. La place dans les cases si
     * {@link #entrees} existe. Les sphères sont comptées par distance croissante : aucune coupe n'en retire ensuite.
     *
     * @param cle voir {@link #parDistance}
     * @return le nombre de cases examinées
     */
    private long noter(long cle) {
        Recherche.obeir();
        int k = (int) cle;
        float proche = Float.intBitsToFloat((int) (cle >>> 32));
        double[] g = spheres.geometrie;
        int s = Spheres.PAS * k;
        double x = g[s] - origine.x;
        double y = g[s + 1] - origine.y;
        double z = g[s + 2] - origine.z;
        double loin = Math.sqrt(x * x + y * y + z * z);
        double r = g[s + 3] / loin;
        // un rayon atteint une sphère au plus à la distance des tangentes, sauf si elle coupe l'écran
        float tangente = deLOeil && g[s + 2] - g[s + 3] <= 1e-9 * (loin + g[s + 3]) ? Float.POSITIVE_INFINITY
                : Math.nextUp((float) (loin * Math.sqrt(1 - r * r) * (1 + MARGE_COUPE)));
        long regardees = 0;
        for (int f = 0; f < faces.length; f++) {
            Face face = faces[f];
            if (!face.silhouette(x, y, z, g[s + 3])) {
                continue;
            }
            for (int j = face.ligne0; j <= face.ligne1; j++) {
                int ligne = f * parFace + j * face.colonnes;
                regardees += 1 + Math.max(0, face.a[j] - face.de[j]);
                for (int i = face.de[j]; i <= face.a[j]; i++) {
                    int c = ligne + i;
                    if (proche > coupe[c]) {
                        continue;
                    }
                    if (entrees == null) {
                        debut[c]++;
                        libres--;
                    } else {
                        entrees[--debut[c]] = k;
                        pres[debut[c]] = proche;
                    }
                    if (tangente < coupe[c] && i >= face.couvertDe[j] && i <= face.couvertA[j]) {
                        coupe[c] = tangente;
                        coupeuse[c] = k;
                    }
                }
            }
        }
        return regardees;
    }

    /** Dit si les cases d'une sphère contiennent, en moyenne, trop de sphères. */
    private boolean estEncombree() {
        int n = spheres.nombre;
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

    /** Les sphères par distance croissante. La moitié basse est un numéro, la haute une distance arrondie vers 0. */
    private long[] parDistance() {
        double[] g = spheres.geometrie;
        long[] ordre = new long[spheres.nombre];
        for (int k = 0; k < ordre.length; k++) {
            int s = Spheres.PAS * k;
            double x = g[s] - origine.x;
            double y = g[s + 1] - origine.y;
            double z = g[s + 2] - origine.z;
            double d = Math.sqrt(x * x + y * y + z * z);
            double r = g[s + 3];
            float proche = Math.max(0, Math.nextDown((float) (d - r - 1e-9 * (d + r))));
            ordre[k] = (long) Float.floatToRawIntBits(proche) << 32 | k;
        }
        return Tri.parMoitieHaute(ordre);
    }

    /** Premier contact dans la case. L'arbre répond si le rayon ne vient pas de l'œil, ou sans crédit. */
    @Override
    public int plusProche(EtatDeRecherche etat, double px, double py, double pz, double vx, double vy, double vz,
            int sauf) {
        int c = faces[0].caseDeLOeil(px, py, pz, vx, vy, vz);
        if (c < 0) {
            return secours.plusProche(etat, px, py, pz, vx, vy, vz, sauf);
        }
        // distance de l'œil à P, car V.z = focale / ‖P − Œil‖ : les distances de la carte partent de l'œil
        double avance = faces[0].focale / vz * (1 + 1e-12);
        etat.distance = Constantes.INFINI;
        etat.compteurs.noeudsVisites++;
        int premiere = debut[c];
        int derniere = debut[c + 1];
        if (premiere == derniere) {
            return -1;
        }
        double[] g = spheres.geometrie;
        double distance = Constantes.INFINI;
        int trouvee = -1;
        long credit = etat.credit + EtatDeRecherche.PAR_RAYON;
        int fin = derniere - premiere <= credit ? derniere : premiere + (int) credit;
        int e = premiere;
        for (; e < fin && pres[e] - avance <= distance; e++) {
            int k = entrees[e];
            int s = Spheres.PAS * k;
            double d = Intersection.distanceOuDoute(px, py, pz, vx, vy, vz, g[s], g[s + 1], g[s + 2], g[s + 3]);
            if (d < 0) {
                d = etat.trancher(spheres, k, d, distance, px, py, pz, vx, vy, vz);
            }
            if (d <= distance && Spheres.avant(d, k, distance, trouvee)) {
                distance = d;
                trouvee = k;
            }
        }
        etat.compteurs.testsSpheres += e - premiere;
        etat.credit = credit - (e - premiere);
        if (e >= fin && e < derniere && pres[e] - avance <= distance) {
            return secours.plusProche(etat, px, py, pz, vx, vy, vz, sauf);
        }
        etat.distance = distance;
        return trouvee;
    }

    /** {@inheritDoc} Pour la carte d'une lampe. */
    @Override
    public boolean cachee(EtatDeRecherche etat, double px, double py, double pz, double vx, double vy, double vz,
            double distance, int sauf) {
        if (px != origine.x || py != origine.y || pz != origine.z) {
            return secours.reprendre(etat, px, py, pz, vx, vy, vz, distance, sauf);
        }
        int c = caseDe(vx, vy, vz);
        if (c < 0) {
            return false;
        }
        etat.compteurs.noeudsVisites++;
        if (distance > coupe[c]) {
            // sur la sphère de la coupe elle-même, un arrondi peut mettre le contact au-delà de la coupe
            return coupeuse[c] != sauf || secours.reprendre(etat, px, py, pz, vx, vy, vz, distance, sauf);
        }
        int premiere = debut[c];
        int derniere = debut[c + 1];
        etat.credit += EtatDeRecherche.PAR_RAYON;
        int fin = derniere - premiere <= etat.credit ? derniere : premiere + (int) etat.credit;
        int e = premiere;
        boolean cachee = false;
        for (; e < fin && !cachee && pres[e] < distance; e++) {
            int k = entrees[e];
            if (k != sauf) {
                cachee = etat.touche(spheres, k, px, py, pz, vx, vy, vz, distance);
            }
        }
        etat.credit -= e - premiere;
        return cachee || e >= fin && e < derniere && pres[e] < distance
                && secours.reprendre(etat, px, py, pz, vx, vy, vz, distance, sauf);
    }

    /** La case de cette direction, -1 si elle est hors de la fenêtre. */
    int caseDe(double x, double y, double z) {
        if (faces.length == 1) {
            return faces[0].caseDe(x, y, z);
        }
        int f = Faces.duCube(x, y, z);
        return f * parFace + faces[f].caseDe(x, y, z);
    }
}
