package lancer.blinn;

import java.util.Locale;
import lancer.Vecteur;
import lancer.contrat.Specularite;

/**
 * Quel facteur rend le reflet de Blinn, max(0, N·H)^(facteur·ns), le plus proche de celui de Phong, max(0, R·L)^ns ? L'œil et
 * la lampe sont loin, la surface est une sphère ; le reflet est centré là où N est la bissectrice, l'incidence i y est l'angle
 * de N et L. Un point du reflet est repéré par son écart δ à ce centre et par l'azimut de cet écart (0° : dans le plan
 * d'incidence ; 90° : en travers). Le facteur retenu est celui des moindres carrés, sur la part visible et éclairée.
 */
public final class MesureFacteur {

    static final double[] POLIS = {5, 20, 100, 1000};
    static final double[] INCIDENCES = {0, 15, 30, 45, 60, 75};

    private static final int PAS_ECART = 100;
    private static final int PAS_AZIMUT = 40;
    private static final double FACTEUR_MAX = 6;
    private static final double PAS_FACTEUR = 0.5;
    private static final double NOMBRE_D_OR = (Math.sqrt(5) - 1) / 2;

    private final double ns;
    private final double incidence;
    /** Bornes des azimuts, en radians, et leur nombre. */
    private final double azimutMin;
    private final double azimutMax;
    private final int azimuts;

    private MesureFacteur(double ns, double incidence, double azimutMin, double azimutMax, int azimuts) {
        this.ns = ns;
        this.incidence = Math.toRadians(incidence);
        this.azimutMin = Math.toRadians(azimutMin);
        this.azimutMax = Math.toRadians(azimutMax);
        this.azimuts = azimuts;
    }

    /** Tout le reflet, à cette incidence en degrés. Un quart suffit : les quatre sont symétriques. */
    static MesureFacteur entier(double ns, double incidence) {
        return new MesureFacteur(ns, incidence, 0, 90, PAS_AZIMUT);
    }

    /** La seule ligne de cet azimut, en degrés. */
    static MesureFacteur ligne(double ns, double incidence, double azimut) {
        return new MesureFacteur(ns, incidence, azimut, azimut, 1);
    }

    /** Le facteur de moindre écart : le meilleur d'une grille, puis la section dorée autour de lui. */
    double meilleur() {
        double depart = PAS_FACTEUR;
        for (double f = PAS_FACTEUR; f < FACTEUR_MAX; f += PAS_FACTEUR) {
            depart = ecart(f) < ecart(depart) ? f : depart;
        }
        double a = depart - PAS_FACTEUR;
        double b = depart + PAS_FACTEUR;
        while (b - a > 1e-4) {
            double c = b - NOMBRE_D_OR * (b - a);
            double d = a + NOMBRE_D_OR * (b - a);
            if (ecart(c) < ecart(d)) {
                b = d;
            } else {
                a = c;
            }
        }
        return (a + b) / 2;
    }

    /** L'écart quadratique des deux reflets, rapporté au reflet de Phong : 0 s'ils sont égaux. */
    double ecart(double facteur) {
        Specularite blinn = new Blinn(facteur);
        Vecteur L = new Vecteur(Math.sin(incidence), 0, Math.cos(incidence));
        Vecteur V = new Vecteur(Math.sin(incidence), 0, -Math.cos(incidence));
        // au-delà de six écarts types, plus rien ne brille
        double ecartMax = Math.min(Math.PI / 2, 6 / (2 * Math.cos(incidence) * Math.sqrt(ns)));
        double difference = 0;
        double total = 0;
        for (int a = 0; a < azimuts; a++) {
            double azimut = azimutMin + (azimutMax - azimutMin) * (a + 0.5) / azimuts;
            for (int e = 0; e < PAS_ECART; e++) {
                double ecart = ecartMax * (e + 0.5) / PAS_ECART;
                double sinus = Math.sin(ecart);
                Vecteur N = new Vecteur(sinus * Math.cos(azimut), sinus * Math.sin(azimut), Math.cos(ecart));
                if (N.dot(L) > 0 && N.dot(V) < 0) {
                    Vecteur R = V.sub(N.mul(2 * V.dot(N))).normalized();
                    double phong = Specularite.PHONG.eclat(V, N, L, R, ns);
                    double d = phong - blinn.eclat(V, N, L, R, ns);
                    difference += d * d * sinus;
                    total += phong * phong * sinus;
                }
            }
        }
        return Math.sqrt(difference / total);
    }

    /** Le tableau du README : une ligne par ns, puis le détail par azimut. */
    static String tableau() {
        StringBuilder s = new StringBuilder("| facteur | ");
        for (double i : INCIDENCES) {
            s.append(String.format(Locale.ROOT, "i = %.0f° | ", i));
        }
        s.append("\n|---|").append(new String(new char[INCIDENCES.length]).replace("\0", "---|"));
        for (double ns : POLIS) {
            s.append(String.format(Locale.ROOT, "\n| ns = %.0f, tout le reflet | ", ns));
            for (double i : INCIDENCES) {
                double facteur = entier(ns, i).meilleur();
                s.append(String.format(Locale.ROOT, "%.2f (%.0f %%) | ", facteur, 100 * entier(ns, i).ecart(facteur)));
            }
        }
        for (double azimut : new double[] {0, 45, 90}) {
            s.append(String.format(Locale.ROOT, "\n| ns = 100, azimut %.0f° | ", azimut));
            for (double i : INCIDENCES) {
                s.append(String.format(Locale.ROOT, "%.2f | ", ligne(100, i, azimut).meilleur()));
            }
        }
        return s.toString().replaceAll(" +(\n|$)", "$1");
    }

    public static void main(String[] args) {
        System.out.println(tableau());
    }
}
