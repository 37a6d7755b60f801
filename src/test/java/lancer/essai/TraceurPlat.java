package lancer.essai;

import static lancer.essai.Triplets.ajouter;
import static lancer.essai.Triplets.dot;
import static lancer.essai.Triplets.fois;
import static lancer.essai.Triplets.gris;
import static lancer.essai.Triplets.moins;
import static lancer.essai.Triplets.plus;
import static lancer.essai.Triplets.t;
import static lancer.essai.Triplets.unite;

import java.util.List;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Sphere;
import lancer.contrat.Vue;

/**
 * Le lancer de rayons de l'énoncé sur des triplets de nombres : des classes du cours, il ne prend que les données d'une scène. Une fille
 * en change une équation.
 */
public class TraceurPlat implements Vue {

    static final double[] OEIL = {0, 0, -1 / Math.tan(Math.toRadians(15))};

    private final List<? extends Objet3D> boules;
    private final List<Lampe> lampes;
    private final int largeur;
    private final int hauteur;
    private final int reflets;

    public TraceurPlat(List<? extends Objet3D> boules, List<Lampe> lampes, int largeur, int hauteur, int reflets) {
        this.boules = boules;
        this.lampes = lampes;
        this.largeur = largeur;
        this.hauteur = hauteur;
        this.reflets = reflets;
    }

    @Override
    public final Couleur couleur(double xe, double ye) {
        double[] P = ecran(largeur, hauteur, xe, ye);
        return couleur(vue(P, unite(moins(P, OEIL)), null, reflets));
    }

    static Couleur couleur(double[] c) {
        return new Couleur(c[0], c[1], c[2]);
    }

    static double[] ecran(int largeur, int hauteur, double xe, double ye) {
        return new double[] {(xe - largeur / 2.0) * 2 / largeur, (hauteur / 2.0 - ye) * 2 / largeur, 0};
    }

    private double[] vue(double[] P, double[] V, Sphere sauf, int profondeur) {
        Sphere boule = premiere(P, V, sauf);
        if (boule == null) {
            return ciel(V);
        }
        double[] X = plus(P, distance(P, V, boule), V);
        double[] N = unite(moins(X, t(boule.getCentre())));
        double[] R = unite(plus(V, -2 * dot(V, N), N));
        double[] somme = new double[3];
        for (Lampe lampe : lampes) {
            double[] versLampe = moins(t(lampe.getPosition()), X);
            if (dot(N, versLampe) > 0 && cache(lampe, X, boule) == null) {
                double[] L = unite(versLampe);
                ajouter(somme, diffus(boule, lampe, N, L));
                ajouter(somme, reflet(boule, lampe, eclat(V, N, L, R, boule.getNs())));
            }
        }
        if (profondeur > 0) {
            ajouter(somme, fois(t(boule.getKs()), vue(X, R, boule, profondeur - 1)));
        }
        return somme;
    }

    protected final double[] diffus(Sphere boule, Lampe lampe, double[] N, double[] L) {
        return fois(fois(t(boule.getKd()), t(lampe.getCouleur())), gris(dot(N, L)));
    }

    protected final double[] reflet(Sphere boule, Lampe lampe, double eclat) {
        return fois(fois(t(boule.getKs()), t(lampe.getCouleur())), gris(eclat));
    }

    protected double eclat(double[] V, double[] N, double[] L, double[] R, double ns) {
        return Math.pow(Math.max(0, dot(R, L)), ns);
    }

    protected static double[] ciel(double[] V) {
        double y = V[1];
        return y > 0 ? new double[] {0.7 * (1 - y), 0.7 * (1 - y), 1} : new double[] {0.5, 0.4 + 0.2 * y, 0.1};
    }

    /** La première que rencontre ce rayon, {@code null} s'il n'en rencontre pas. @param sauf celle d'où il part */
    protected Sphere premiere(double[] P, double[] V, Sphere sauf) {
        Sphere premiere = null;
        double plusProche = Double.POSITIVE_INFINITY;
        for (Objet3D boule : boules) {
            double d = boule == sauf ? Double.POSITIVE_INFINITY : distance(P, V, (Sphere) boule);
            if (d < plusProche) {
                premiere = (Sphere) boule;
                plusProche = d;
            }
        }
        return premiere;
    }

    /** La première, depuis la lampe, qui la cache à ce contact ; {@code null} si rien ne la cache. */
    protected Sphere cache(Lampe lampe, double[] X, Sphere boule) {
        double[] S = t(lampe.getPosition());
        double[] versX = moins(X, S);
        double[] V = unite(versX);
        Sphere premiere = premiere(S, V, boule);
        return premiere != null && distance(S, V, premiere) < Math.sqrt(dot(versX, versX)) ? premiere : null;
    }

    protected double distance(double[] P, double[] V, Sphere boule) {
        return Formule.PERPENDICULAIRE.distance(moins(t(boule.getCentre()), P), V, boule.getRayon());
    }
}
