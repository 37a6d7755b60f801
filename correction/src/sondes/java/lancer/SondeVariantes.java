package lancer;

import java.nio.ByteBuffer;
import java.util.Base64;

/** Interroge une variante d'un étudiant, ou sa base, à qui on la compare. */
public final class SondeVariantes {

    private SondeVariantes() {
    }

    private static String coder(Couleur[] couleurs) {
        ByteBuffer octets = ByteBuffer.allocate(couleurs.length * 12);
        for (Couleur c : couleurs) {
            octets.putFloat((float) c.r).putFloat((float) c.v).putFloat((float) c.b);
        }
        return Base64.getEncoder().encodeToString(octets.array());
    }

    /** @param a scène, largeur, hauteur, profondeur ; ce que dessine TracerImage, où l'étudiant met l'anticrénelage */
    public static String tracer(String... a) {
        int largeur = Integer.parseInt(a[1]);
        int hauteur = Integer.parseInt(a[2]);
        Couleur[] pixels = new Couleur[largeur * hauteur];
        Toile toile = new Toile() {
            @Override
            public void drawPixel(Couleur coul, int xe, int ye) {
                pixels[ye * largeur + xe] = coul;
            }

            @Override
            public void avancer(double part) {
                // personne ne regarde
            }
        };
        new Lancer(new Scene(a[0]), new Camera(largeur, hauteur))
                .TracerImage(toile, largeur, hauteur, Integer.parseInt(a[3]));
        return coder(pixels);
    }

    /**
     * @param a scène, largeur, hauteur, profondeur, n, début ; de chaque pixel, la moyenne de n x n rayons, le premier
     * à début du coin
     */
    public static String moyenne(String... a) {
        int largeur = Integer.parseInt(a[1]);
        int hauteur = Integer.parseInt(a[2]);
        int profondeur = Integer.parseInt(a[3]);
        int n = Integer.parseInt(a[4]);
        double debut = Double.parseDouble(a[5]);
        Scene scene = new Scene(a[0]);
        Camera camera = new Camera(largeur, hauteur);
        Couleur[] pixels = new Couleur[largeur * hauteur];
        for (int p = 0; p < pixels.length; p++) {
            Couleur somme = new Couleur(0, 0, 0);
            for (int k = 0; k < n * n; k++) {
                Rayon rayon = camera.getRayon(p % largeur + debut + (double) (k % n) / n, p / largeur + debut
                        + (double) (k / n) / n);
                somme = somme.add(SondeImage.parRayon(scene, rayon, profondeur));
            }
            pixels[p] = somme.mul(1.0 / (n * n));
        }
        return coder(pixels);
    }

    /**
     * @param a scène d'une boule et d'une lampe, largeur, hauteur, décalage, facteur ; Ks K_L (N.H)^(facteur ns), sans
     * rien d'autre
     */
    public static String blinn(String... a) {
        int largeur = Integer.parseInt(a[1]);
        int hauteur = Integer.parseInt(a[2]);
        double decalage = Double.parseDouble(a[3]);
        double facteur = Double.parseDouble(a[4]);
        Scene scene = new Scene(a[0]);
        Camera camera = new Camera(largeur, hauteur);
        Couleur[] pixels = new Couleur[largeur * hauteur];
        for (int p = 0; p < pixels.length; p++) {
            Rayon rayon = camera.getRayon(p % largeur + decalage, p / largeur + decalage);
            PointContact contact = scene.getClosestIntersection(rayon);
            pixels[p] = contact == null ? rayon.getSkyColor()
                    : eclat(scene.getLampes().get(0), rayon, contact, facteur);
        }
        return coder(pixels);
    }

    private static Couleur eclat(Lampe lampe, Rayon rayon, PointContact contact, double facteur) {
        Vecteur N = contact.objet.getNormale(contact);
        Vecteur L = new Vecteur(contact, lampe.getPosition()).normalized();
        Vecteur H = L.sub(rayon.getV()).normalized();
        double eclat = N.dot(L) > 0 ? Math.pow(Math.max(0, N.dot(H)), facteur * contact.objet.getNs()) : 0;
        return contact.objet.getKs().mul(lampe.getCouleur()).mul(eclat);
    }
}
