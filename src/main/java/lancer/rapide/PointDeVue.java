package lancer.rapide;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntConsumer;
import java.util.stream.Collectors;
import lancer.Camera;
import lancer.Lampe;
import lancer.Point;
import lancer.Vecteur;

/** Un point par où passent des rayons, l'œil ou une lampe. Les directions qui en partent sont découpées en cases. */
final class PointDeVue {

    /** Écart permis du point à la droite du rayon, en part de la portée ; une enveloppe en a le double. */
    private static final double ECART = 5e-14;

    /** Arrondi d'un produit vectoriel de ce vecteur et d'une direction, en part du vecteur. */
    private static final double ARRONDI = 1e-15;

    /** Plus petite distance dont le carré garde ses chiffres. */
    private static final double LOIN_MIN = 1e-120;

    private final double x;
    private final double y;
    private final double z;
    /** La plus grande coordonnée du point, et de l'écran s'il est l'œil. */
    final double portee;
    /** Fenêtre de chaque face du cube, {@code null} s'il n'y a rien, et rang de sa première case. */
    private final Fenetre[] fenetres = new Fenetre[6];
    private final int[] premieres = new int[6];
    /** La case des directions hors des fenêtres ; −1 si elles ne sont pas connues. */
    private int ailleurs = -1;
    /** Nombre de cases. */
    final int nombre;

    /** @param bords de chaque face */
    private PointDeVue(Point p, double portee, double[][] bords, boolean connuAilleurs, int cases) {
        this.portee = portee;
        x = p.x;
        y = p.y;
        z = p.z;
        double aire = 0;
        double cote = 0;
        for (double[] b : bords) {
            if (b != null && b[0] < b[1]) {
                aire += (b[1] - b[0]) * (b[3] - b[2]);
                cote = Math.max(cote, Math.max(b[1] - b[0], b[3] - b[2]) / cases);
            }
        }
        cote = Math.max(cote, Math.sqrt(aire / cases));
        int n = 0;
        for (int f = 0; f < fenetres.length; f++) {
            double[] b = bords[f];
            if (b != null && b[0] < b[1]) {
                fenetres[f] = new Fenetre(f, b, 1 + (int) ((b[1] - b[0]) / cote), 1 + (int) ((b[3] - b[2]) / cote));
                premieres[f] = n;
                n += fenetres[f].colonnes * fenetres[f].lignes;
            }
        }
        if (connuAilleurs) {
            ailleurs = n++;
        }
        nombre = n;
    }

    /** L'œil, et sur chaque face d'un cube une fenêtre autour de l'écran ; {@code null} s'il est trop loin. */
    static PointDeVue deLOeil(Camera camera, int cases) {
        Point oeil = camera.getOeil();
        int largeur = camera.getLargeur();
        int hauteur = camera.getHauteur();
        List<Point> coins = Arrays.asList(camera.getEcran(0, 0), camera.getEcran(largeur, 0),
                camera.getEcran(largeur, hauteur), camera.getEcran(0, hauteur));
        double portee = Enveloppes.plusGrande(oeil.x, oeil.y, oeil.z);
        for (Point coin : coins) {
            portee = Math.max(portee, Enveloppes.plusGrande(coin.x, coin.y, coin.z));
        }
        if (!(portee < Enveloppes.LONGUEUR_MAX)) {
            return null;
        }
        List<Vecteur> ecran = coins.stream().map(coin -> new Vecteur(oeil, coin)).collect(Collectors.toList());
        double[][] bords = new double[6][];
        Arrays.setAll(bords, face -> Fenetre.entourer(face, ecran));
        return new PointDeVue(oeil, portee, bords, false, Math.max(1, cases));
    }

    /** Une lampe, et sur chaque face d'un cube une fenêtre autour des silhouettes, sauf des grandes enveloppes. */
    static PointDeVue deLaLampe(Lampe celle, Enveloppes enveloppes, int cases) {
        Point lampe = celle.getPosition();
        double portee = Enveloppes.plusGrande(lampe.x, lampe.y, lampe.z);
        if (!(portee < Enveloppes.LONGUEUR_MAX)) {
            return null;
        }
        double[][] bords = new double[6][];
        Arrays.setAll(bords, face -> Fenetre.vide());
        double[] d = new double[3];
        for (int k : enveloppes.bornes) {
            double sinus = viser(lampe.x, lampe.y, lampe.z, portee, enveloppes.geometrie, k, d);
            for (int f = 0; f < bords.length && sinus <= Fenetre.GRANDE; f++) {
                Fenetre.elargir(f, d, sinus, bords[f]);
            }
        }
        return new PointDeVue(lampe, portee, bords, true, cases);
    }

    /**
     * Note dans d la direction de cette enveloppe vue de (x, y, z), de cette portée.
     *
     * @return le sinus de son demi-angle, 1 ou plus si elle contient ce point
     */
    private static double viser(double x, double y, double z, double portee, double[] g, int k, double[] d) {
        int s = Enveloppes.PAS * k;
        double dx = g[s] - x;
        double dy = g[s + 1] - y;
        double dz = g[s + 2] - z;
        double loin = Math.sqrt(dx * dx + dy * dy + dz * dz);
        d[0] = dx / loin;
        d[1] = dy / loin;
        d[2] = dz / loin;
        double r = g[s + 3] + 2 * ECART * portee;
        return loin > LOIN_MIN ? r / loin : Double.POSITIVE_INFINITY;
    }

    /** Borne inférieure de la distance de ce point à l'enveloppe k. */
    float auMoins(double[] g, int k) {
        int s = Enveloppes.PAS * k;
        double dx = g[s] - x;
        double dy = g[s + 1] - y;
        double dz = g[s + 2] - z;
        double loin = Math.sqrt(dx * dx + dy * dy + dz * dz);
        double pres = loin - g[s + 3] - 2 * ECART * portee - Enveloppes.MARGE * loin;
        return Math.max(0, Math.nextDown((float) pres));
    }

    /** Donne les cases où se voit l'enveloppe k, ou l'objet libre k. */
    void cases(double[] g, int k, IntConsumer vue) {
        double[] d = new double[3];
        double sinus = viser(x, y, z, portee, g, k, d);
        for (int f = 0; f < fenetres.length; f++) {
            int premiere = premieres[f];
            if (fenetres[f] != null) {
                fenetres[f].chercher(d, sinus, c -> vue.accept(premiere + c));
            }
        }
        if (ailleurs >= 0 && !(sinus <= Fenetre.GRANDE)) {
            vue.accept(ailleurs);
        }
    }

    /** La case de ce rayon, de direction V ou −V vue du point ; −1 s'il n'y passe pas, ou si elle n'est pas connue. */
    int caseDe(Point P, Vecteur V) {
        double ax = P.x - x;
        double ay = P.y - y;
        double az = P.z - z;
        double cx = ay * V.z - az * V.y;
        double cy = az * V.x - ax * V.z;
        double cz = ax * V.y - ay * V.x;
        double ecart = ECART * portee;
        boolean passe = cx * cx + cy * cy + cz * cz <= ecart * ecart;
        // plus loin, l'arrondi de ce produit vectoriel passerait l'écart
        boolean sur = ARRONDI * Enveloppes.plusGrande(ax, ay, az) <= ecart;
        if (!(passe && sur && Enveloppes.estUnitaire(V.x, V.y, V.z))) {
            return -1;
        }
        double sens = ax * V.x + ay * V.y + az * V.z >= 0 ? 1 : -1;
        int f = Fenetre.face(sens * V.x, sens * V.y, sens * V.z);
        int c = fenetres[f] == null ? -1 : fenetres[f].caseDe(sens * V.x, sens * V.y, sens * V.z);
        return c < 0 ? ailleurs : premieres[f] + c;
    }

    /** Ce qu'un rayon qui s'éloigne du point a parcouru avant P ; +∞ s'il s'en approche. */
    double avance(Point P, Vecteur V) {
        double a = (P.x - x) * V.x + (P.y - y) * V.y + (P.z - z) * V.z;
        return a >= 0 ? a * (1 + 1e-12) : Double.POSITIVE_INFINITY;
    }
}
