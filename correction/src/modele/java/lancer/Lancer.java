package lancer;

/** L'algorithme : de la scène à l'image (cours, « Algorithme général »). */
public class Lancer {

    private static final int PAS_BROUILLON = 4;
    //<antialias
    //+
    //+ /** Sous-pixels sur un côté d'un pixel, 2 ou plus ; et l'écart des coins, de 0 à 1, qui les fait tous dessiner. */
    //+ private static final int N = 3;
    //+ private static final double SEUIL = 0.05;
    //>

    private final Scene scene;
    private final Camera camera;

    public Lancer(Scene scene, Camera camera) {
        this.scene = scene;
        this.camera = camera;
    }

    /**
     * La couleur vue à travers un point de l'écran.
     *
     * @param xe en pixels depuis la gauche
     * @param ye en pixels depuis le haut
     * @param profondeur le nombre de reflets permis
     */
    public Couleur getCouleurPixel(double xe, double ye, int profondeur) {
        //{ compléter : la couleur de l'objet le plus proche que rencontre le rayon de ce pixel, ou celle du ciel
        Rayon initial = camera.getRayon(xe, ye);
        PointContact contact = scene.getClosestIntersection(initial);
        if (contact == null) {
            //<brume
            return initial.getSkyColor();
            //+ return scene.getBrume().devant(initial.getSkyColor(), Constantes.INFINI);
            //>
        }
        //<brume
        return contact.objet.getColor(scene, initial, contact, profondeur);
        //+ Couleur vue = contact.objet.getColor(scene, initial, contact, profondeur);
        //+ return scene.getBrume().devant(vue, contact.distance);
        //>
        //= return new Couleur(0, 1, 0);
        //}
    }

    //<antialias
    /** Dessine un brouillon, un rayon pour 4 x 4 pixels, puis chaque pixel, au centre duquel passe un rayon. */
    //+ /** Dessine un brouillon, un rayon pour 4 x 4 pixels, puis chaque pixel, découpé en sous-pixels. */
    //>
    public void TracerImage(Toile toile, int largeur, int hauteur, int profondeur) {
        for (int ye = 0; ye < hauteur; ye += PAS_BROUILLON) {
            for (int xe = 0; xe < largeur; xe += PAS_BROUILLON) {
                double centre = PAS_BROUILLON / 2.0;
                Couleur couleur = getCouleurPixel(xe + centre, ye + centre, Math.min(1, profondeur));
                for (int y = ye; y < Math.min(hauteur, ye + PAS_BROUILLON); y++) {
                    for (int x = xe; x < Math.min(largeur, xe + PAS_BROUILLON); x++) {
                        toile.drawPixel(couleur, x, y);
                    }
                }
            }
        }
        for (int ye = 0; ye < hauteur; ye++) {
            for (int xe = 0; xe < largeur; xe++) {
                //<antialias
                toile.drawPixel(getCouleurPixel(xe + 0.5, ye + 0.5, profondeur), xe, ye);
                //+ toile.drawPixel(getCouleurMoyenne(xe, ye, profondeur), xe, ye);
                //>
            }
            toile.avancer((ye + 1.0) / hauteur);
        }
    }
    //<antialias
    //+
    //+ /** La moyenne des quatre sous-pixels des coins, ou celle de tous si ces quatre diffèrent trop. */
    //+ private Couleur getCouleurMoyenne(int xe, int ye, int profondeur) {
    //+     int pas = N - 1;
    //+     Couleur[] coins = sousPixels(xe, ye, profondeur, pas);
    //+     for (Couleur a : coins) {
    //+         for (Couleur b : coins) {
    //+             if (ecart(a.r, b.r) > SEUIL || ecart(a.v, b.v) > SEUIL || ecart(a.b, b.b) > SEUIL) {
    //+                 return moyenne(sousPixels(xe, ye, profondeur, 1));
    //+             }
    //+         }
    //+     }
    //+     return moyenne(coins);
    //+ }
    //+
    //+ /** Les sous-pixels de ce pas ; un rayon passe au centre de chacun. */
    //+ private Couleur[] sousPixels(int xe, int ye, int profondeur, int pas) {
    //+     Couleur[] couleurs = new Couleur[(1 + (N - 1) / pas) * (1 + (N - 1) / pas)];
    //+     int k = 0;
    //+     for (int dy = 0; dy < N; dy += pas) {
    //+         for (int dx = 0; dx < N; dx += pas) {
    //+             couleurs[k++] = getCouleurPixel(xe + (dx + 0.5) / N, ye + (dy + 0.5) / N, profondeur);
    //+         }
    //+     }
    //+     return couleurs;
    //+ }
    //+
    //+ private static Couleur moyenne(Couleur[] couleurs) {
    //+     Couleur somme = new Couleur();
    //+     for (Couleur couleur : couleurs) {
    //+         somme = somme.add(couleur);
    //+     }
    //+     return somme.div(couleurs.length);
    //+ }
    //+
    //+ /** L'écart de deux composantes telles qu'on les verra, de 0 à 1. */
    //+ private static double ecart(double a, double b) {
    //+     return Math.abs(Math.min(1, a) - Math.min(1, b));
    //+ }
    //>
}
