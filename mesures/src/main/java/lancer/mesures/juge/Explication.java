package lancer.mesures.juge;

import lancer.Couleur;
import lancer.Lancer;

/**
 * La cause d'un écart, et sa preuve : un de nos rayons, à moins d'un millionième de pixel de celui du pixel, voit la couleur du juge.
 * Le pixel est alors sur un bord, ou sa couleur varie si vite d'un rayon à l'autre qu'elle dépend des arrondis.
 */
final class Explication {

    /** Le plus loin où chercher un rayon voisin, en pixels. */
    static final double RAYON_MAX = 1e-6;

    private static final double RAYON_MIN = 1e-12;
    private static final double PAS_DU_RAYON = Math.sqrt(10);
    private static final int DIRECTIONS = 16;

    /** De combien le dernier pas est plus petit que le premier. */
    private static final double FINESSE = 512;

    /** Le rayon voisin doit réduire l'écart d'autant au moins : une couleur un peu moins loin ne prouve rien. */
    private static final double REDUCTION = 16;

    /** Ce qu'une composante du juge doit à l'arrondi de son image (un demi-pas) et à ses couleurs de 24 bits. */
    private static final double ARRONDI_DU_JUGE = 0.75 * Accord.PAS_16;

    final Cause cause;

    /** À combien de pixels du nôtre passe le rayon qui voit la couleur du juge ; 0 s'il n'y en a pas. */
    final double distance;

    private final Lancer lancer;
    private final int reflets;
    private final Accord accord;
    private final int k;
    private final double x;
    private final double y;
    private double meilleurX;
    private double meilleurY;
    private double meilleurEcart;

    /**
     * @param lancer de quoi tracer un rayon de la scène
     * @param reflets nombre de réflexions permises
     * @param accord les deux images
     * @param k rang du pixel
     */
    Explication(Lancer lancer, int reflets, Accord accord, int k) {
        int largeur = lancer.getCamera().getLargeur();
        this.lancer = lancer;
        this.reflets = reflets;
        this.accord = accord;
        this.k = k;
        x = k % largeur + 0.5;
        y = k / largeur + 0.5;
        meilleurEcart = Double.POSITIVE_INFINITY;
        essayer(x, y);
        double permis = Math.max(ARRONDI_DU_JUGE, meilleurEcart / REDUCTION);
        boolean trouve = false;
        for (double r = RAYON_MIN; !trouve && r <= RAYON_MAX / 2; r *= PAS_DU_RAYON) {
            trouve = chercher(r, permis);
        }
        cause = trouve ? chemin(x, y).separation(chemin(meilleurX, meilleurY)) : Cause.INEXPLIQUE;
        distance = trouve ? Math.hypot(meilleurX - x, meilleurY - y) : 0;
    }

    /**
     * Cherche, à moins de deux fois {@code r}, un rayon dont la couleur est celle du juge : le meilleur d'un cercle, puis, de proche en
     * proche, un meilleur encore, par pas qui diminuent.
     *
     * @param permis l'écart qui suffit
     */
    private boolean chercher(double r, double permis) {
        meilleurX = x;
        meilleurY = y;
        meilleurEcart = Double.POSITIVE_INFINITY;
        cercle(x, y, r, DIRECTIONS);
        for (double pas = r / 2; meilleurEcart > permis && pas > r / FINESSE; pas /= 2) {
            cercle(meilleurX, meilleurY, pas, DIRECTIONS / 2);
        }
        return meilleurEcart <= permis;
    }

    private void cercle(double cx, double cy, double r, int directions) {
        for (int d = 0; d < directions; d++) {
            double angle = 2 * Math.PI * d / directions;
            essayer(cx + r * Math.cos(angle), cy + r * Math.sin(angle));
        }
    }

    private void essayer(double xv, double yv) {
        Couleur couleur = lancer.getCouleurPixel(xv, yv, reflets);
        double ecart = 0;
        for (Composante c : Composante.values()) {
            ecart = Math.max(ecart, Math.abs(Accord.limite(c.de(couleur)) - accord.juge(k, c)));
        }
        if (ecart < meilleurEcart) {
            meilleurX = xv;
            meilleurY = yv;
            meilleurEcart = ecart;
        }
    }

    private Trajet chemin(double xv, double yv) {
        return new Trajet(lancer.getScene(), lancer.getCamera().getRayon(xv, yv), reflets);
    }
}
