package lancer.rapide;

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
    /** La plus grande coordonnée, en valeur absolue, du point et du départ d'un rayon. */
    private final double portee;
    private final FaceDeCube[] faces = new FaceDeCube[6];
    /** Nombre de cases. La dernière est celle des directions hors des fenêtres. */
    final int nombre;

    /**
     * Ce point, et sur chaque face d'un cube une fenêtre autour des silhouettes, sauf celles des grandes enveloppes.
     *
     * @param depart un point d'où part un rayon : une lampe elle-même, ou un point de l'écran
     */
    PointDeVue(Point p, Point depart, Enveloppes enveloppes, int cases) {
        portee = Math.max(Enveloppes.plusGrande(p.x, p.y, p.z),
                Enveloppes.plusGrande(depart.x, depart.y, depart.z));
        x = p.x;
        y = p.y;
        z = p.z;
        double[] d = new double[3];
        double aire = 0;
        for (int f = 0; f < faces.length; f++) {
            faces[f] = new FaceDeCube(f);
            for (int k : enveloppes.bornes) {
                double sinus = viser(enveloppes.geometrie, k, d);
                if (sinus <= FaceDeCube.GRANDE) {
                    faces[f].elargir(d, sinus);
                }
            }
            aire += faces[f].aire();
        }
        int n = 0;
        for (FaceDeCube face : faces) {
            n = face.decouper(Math.sqrt(aire / cases), cases, n);
        }
        nombre = n + 1;
    }

    /**
     * Note dans d la direction de cette enveloppe.
     *
     * @return le sinus de son demi-angle, 1 ou plus si elle contient ce point ou en est trop loin
     */
    private double viser(double[] g, int k, double[] d) {
        int s = Enveloppes.PAS * k;
        double dx = g[s] - x;
        double dy = g[s + 1] - y;
        double dz = g[s + 2] - z;
        double loin = Math.sqrt(dx * dx + dy * dy + dz * dz);
        d[0] = dx / loin;
        d[1] = dy / loin;
        d[2] = dz / loin;
        double r = g[s + 3] + 2 * ECART * portee;
        return loin > LOIN_MIN && loin < Enveloppes.LONGUEUR_MAX ? r / loin : Double.POSITIVE_INFINITY;
    }

    /** Borne inférieure de la distance de ce point à l'enveloppe k. */
    float auMoins(double[] g, int k) {
        int s = Enveloppes.PAS * k;
        double dx = g[s] - x;
        double dy = g[s + 1] - y;
        double dz = g[s + 2] - z;
        double loin = Math.sqrt(dx * dx + dy * dy + dz * dz);
        double pres = loin - g[s + 3] - 2 * ECART * portee - Enveloppes.MARGE * loin;
        return loin < Enveloppes.LONGUEUR_MAX ? Math.max(0, Math.nextDown((float) pres)) : 0;
    }

    /** Ajoute les cases où se voit l'enveloppe k, ou l'objet libre k. */
    void chercher(double[] g, int k, Rangs cases) {
        double[] d = new double[3];
        double sinus = viser(g, k, d);
        for (FaceDeCube face : faces) {
            face.chercher(d, sinus, cases);
        }
        if (!(sinus <= FaceDeCube.GRANDE)) {
            cases.ajouter(nombre - 1);
        }
    }

    /** La case de ce rayon, de direction V ou −V vue du point ; −1 s'il n'y passe pas. */
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
        int f = FaceDeCube.numero(sens * V.x, sens * V.y, sens * V.z);
        int c = faces[f].caseDe(sens * V.x, sens * V.y, sens * V.z);
        return c < 0 ? nombre - 1 : c;
    }

    /** Ce qu'un rayon qui s'éloigne du point a parcouru avant P ; +∞ s'il s'en approche. */
    double avance(Point P, Vecteur V) {
        double a = (P.x - x) * V.x + (P.y - y) * V.y + (P.z - z) * V.z;
        return a >= 0 ? a * (1 + 1e-12) : Double.POSITIVE_INFINITY;
    }
}
