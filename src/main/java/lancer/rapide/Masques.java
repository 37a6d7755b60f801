package lancer.rapide;

import java.util.List;
import lancer.Camera;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;

/**
 * Recherche d'une petite scène : un bit d'un {@code long} par objet qu'un rayon peut rencontrer. Il y a un masque par
 * tuile de l'écran, un par objet de départ et par cube de directions, un par lampe et par case de directions. Le rayon
 * est vérifié avant d'utiliser un masque. S'il ne convient pas, tous les objets sont proposés.
 */
final class Masques implements Recherche {

    /** Nombre de cubes de directions par côté du cube [−1, 1]³. */
    private static final int COTE = 8;
    private static final int CUBES = COTE * COTE * COTE;

    /** Côté d'une tuile de l'écran, en pixels. */
    private static final double TUILE = 8;

    /** Nombre de cases d'une lampe, et de pixels pour une case des lampes. */
    private static final int CASES_D_UNE_LAMPE = 4096;
    private static final int PIXELS_PAR_CASE = 8;

    private final Objet3D[] objets;
    private final double[] g;
    private final long tous;
    private final PointDeVue oeil;
    private final long[] parTuile;
    private final long[] parDirection;
    private final Lampe[] lampes;
    /** Pour chaque lampe, elle-même, et ce que peut rencontrer un rayon de chaque case ; {@code null} sans masques. */
    private final PointDeVue[] vues;
    private final long[][] parCase;
    private final Compteurs compteurs;

    /** Rang de l'objet de la dernière question, et de sa lampe : en général, ceux de la suivante. */
    private int rang;
    private int lampe;

    private long reste;
    /** Le bit proposé en dernier, 0 à la fin ; celui d'abord proposé ; celui qui a caché une lampe en dernier. */
    private long propose;
    private long dAbord;
    private long bloqueur;
    private boolean ombre;

    Masques(Enveloppes enveloppes, List<Lampe> siennes, Camera camera) {
        objets = enveloppes.objets;
        g = enveloppes.geometrie;
        compteurs = new Compteurs();
        int n = objets.length;
        tous = n == 0 ? 0 : -1L >>> Long.SIZE - n;
        double pixels = (double) camera.getLargeur() * camera.getHauteur();
        oeil = new PointDeVue(camera.getOeil(), camera.getEcran(0, 0), enveloppes,
                1 + (int) (pixels / (TUILE * TUILE)));
        parTuile = masques(oeil);
        parDirection = new long[CUBES * n];
        for (int b = 0; b < n; b++) {
            for (int a = 0; a < n; a++) {
                noterDirections(a, b);
            }
        }
        lampes = siennes.toArray(new Lampe[0]);
        vues = new PointDeVue[lampes.length];
        parCase = new long[lampes.length][];
        int cases = (int) Math.min(CASES_D_UNE_LAMPE, pixels / PIXELS_PAR_CASE / (1 + lampes.length));
        for (int l = 0; l < lampes.length; l++) {
            Recherche.obeir();
            Point place = lampes[l].getPosition();
            vues[l] = cases > n ? new PointDeVue(place, place, enveloppes, cases) : null;
            parCase[l] = vues[l] == null ? null : masques(vues[l]);
        }
    }

    /** Pour chaque case vue de ce point, les objets qui s'y voient. */
    private long[] masques(PointDeVue vue) {
        long[] masques = new long[vue.nombre];
        for (int k = 0; k < objets.length; k++) {
            Rangs cases = new Rangs();
            vue.chercher(g, k, cases);
            for (int c = 0; c < cases.nombre; c++) {
                masques[cases.rangs[c]] |= 1L << k;
            }
        }
        return masques;
    }

    private Masques(Masques autre, Compteurs compteurs) {
        objets = autre.objets;
        g = autre.g;
        tous = autre.tous;
        oeil = autre.oeil;
        parTuile = autre.parTuile;
        parDirection = autre.parDirection;
        lampes = autre.lampes;
        vues = autre.vues;
        parCase = autre.parCase;
        this.compteurs = compteurs;
    }

    /**
     * Note l'objet b, s'il peut être rencontré par un rayon parti de l'objet a. L'angle de sa direction et de AB est au
     * plus asin((rA + rB) / AB). Dans un cube de centre c et de demi-côté h, le cosinus d'une direction avec w est au
     * plus c·w + h(|wx| + |wy| + |wz|).
     */
    private void noterDirections(int a, int b) {
        int sa = Enveloppes.PAS * a;
        int sb = Enveloppes.PAS * b;
        double x = g[sb] - g[sa];
        double y = g[sb + 1] - g[sa + 1];
        double z = g[sb + 2] - g[sa + 2];
        double d = Math.sqrt(x * x + y * y + z * z);
        // NaN si l'un des deux est sans borne : la négation le note alors partout
        double sinus = (g[sa + 3] + g[sb + 3]) / d;
        double cosinus = Math.sqrt(1 - sinus * sinus) - Enveloppes.MARGE;
        x /= d;
        y /= d;
        z /= d;
        double demi = 1.0 / COTE;
        double plus = demi * (Math.abs(x) + Math.abs(y) + Math.abs(z));
        int c = CUBES * a;
        for (int k = 0; k < COTE; k++) {
            double cz = ((2 * k + 1) * demi - 1) * z + plus;
            for (int j = 0; j < COTE; j++) {
                double cy = ((2 * j + 1) * demi - 1) * y + cz;
                for (int i = 0; i < COTE; i++, c++) {
                    if (!(((2 * i + 1) * demi - 1) * x + cy < cosinus)) {
                        parDirection[c] |= 1L << b;
                    }
                }
            }
        }
    }

    @Override
    public void commencer(Point P, Vecteur V, Objet3D depart) {
        ombre = false;
        dAbord = 0;
        if (depart == null) {
            bloqueur = 0;
            int c = oeil.caseDe(P, V);
            poser(c < 0 ? tous : parTuile[c]);
        } else {
            rang = Enveloppes.trouver(depart, objets, rang);
            boolean connu = objets.length > 0 && objets[rang] == depart && estDansLEnveloppe(P)
                    && Enveloppes.estUnitaire(V.x, V.y, V.z);
            poser(connu ? parDirection[CUBES * rang + (cube(V.z) * COTE + cube(V.y)) * COTE + cube(V.x)] : tous);
        }
    }

    private static int cube(double v) {
        return Math.min(COTE - 1, (int) ((v + 1) * (COTE / 2)));
    }

    @Override
    public void commencerOmbre(Lampe demandee, Point P, Vecteur V, double distance, Objet3D eclaire) {
        // la boucle qui s'est arrêtée avant la fin a trouvé ce qui cache la lampe
        if (ombre && propose != 0) {
            bloqueur = propose;
        }
        ombre = true;
        dAbord = bloqueur;
        lampe = Enveloppes.trouver(demandee, lampes, lampe);
        PointDeVue vue = lampes.length > 0 && lampes[lampe] == demandee ? vues[lampe] : null;
        int c = vue == null ? -1 : vue.caseDe(P, V);
        poser(c < 0 ? tous : parCase[lampe][c]);
    }

    private void poser(long masque) {
        compteurs.noeudsVisites++;
        reste = masque;
        propose = 0;
    }

    /** Dit si ce point est dans l'enveloppe de l'objet trouvé. */
    private boolean estDansLEnveloppe(Point p) {
        int s = Enveloppes.PAS * rang;
        double dx = p.x - g[s];
        double dy = p.y - g[s + 1];
        double dz = p.z - g[s + 2];
        return dx * dx + dy * dy + dz * dz <= g[s + 3] * g[s + 3];
    }

    @Override
    public int suivant(double auPlus) {
        long bits = reste;
        if (bits == 0) {
            propose = 0;
            return -1;
        }
        long bit = (bits & dAbord) != 0 ? dAbord : Long.lowestOneBit(bits);
        propose = bit;
        reste = bits ^ bit;
        return Long.numberOfTrailingZeros(bit);
    }

    @Override
    public Recherche pourUnFil(Compteurs siens) {
        return new Masques(this, siens);
    }
}
