package lancer;

import java.nio.ByteBuffer;
import java.util.Base64;

/** Dessine une scène par les classes d'un étudiant, en interrogeant leurs méthodes publiques. */
public final class SondeImage {

    private SondeImage() {
    }

    /** Les couleurs non limitées, en flottants, en base 64. */
    private static String coder(Couleur[] couleurs) {
        ByteBuffer octets = ByteBuffer.allocate(couleurs.length * 12);
        for (Couleur c : couleurs) {
            octets.putFloat((float) c.r).putFloat((float) c.v).putFloat((float) c.b);
        }
        return Base64.getEncoder().encodeToString(octets.array());
    }

    /** @param a scène, largeur, hauteur, profondeur, décalage en x et en y */
    public static String dessiner(String... a) {
        Scene scene = new Scene(a[0]);
        int largeur = Integer.parseInt(a[1]);
        int hauteur = Integer.parseInt(a[2]);
        int profondeur = Integer.parseInt(a[3]);
        double decalage = Double.parseDouble(a[4]);
        Camera camera = new Camera(largeur, hauteur);
        // par getCouleurPixel ; s'il n'existe pas sous cette forme, par les méthodes qu'il appelle
        boolean parLancer = true;
        try {
            parLancer(scene, camera, 0, 0, profondeur, decalage);
        } catch (Error e) {
            parLancer = false;
        }
        Couleur[] pixels = new Couleur[largeur * hauteur];
        for (int p = 0; p < pixels.length; p++) {
            int xe = p % largeur;
            int ye = p / largeur;
            pixels[p] = parLancer ? parLancer(scene, camera, xe, ye, profondeur, decalage)
                    : parRayon(scene, camera.getRayon(xe + decalage, ye + decalage), profondeur);
        }
        return coder(pixels);
    }

    private static Couleur parLancer(Scene scene, Camera camera, int xe, int ye, int profondeur, double decalage) {
        return decalage == 0 ? parEntiers(scene, camera, xe, ye, profondeur)
                : new Lancer(scene, camera).getCouleurPixel(xe + decalage, ye + decalage, profondeur);
    }

    /** Des entiers : {@code getCouleurPixel} peut les vouloir. */
    private static Couleur parEntiers(Scene scene, Camera camera, int xe, int ye, int profondeur) {
        return new Lancer(scene, camera).getCouleurPixel(xe, ye, profondeur);
    }

    static Couleur parRayon(Scene scene, Rayon rayon, int profondeur) {
        PointContact contact = scene.getClosestIntersection(rayon, null);
        return contact == null ? rayon.getSkyColor() : contact.objet.getColor(scene, rayon, contact, profondeur);
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
     * @param a scène d'une boule et d'une lampe, largeur, hauteur, décalage, facteur ; là où la lampe éclaire, le seul
     * Ks K_L (N.H)^(facteur ns)
     */
    public static String blinn(String... a) {
        int largeur = Integer.parseInt(a[1]);
        double decalage = Double.parseDouble(a[3]);
        Scene scene = new Scene(a[0]);
        Camera camera = new Camera(largeur, Integer.parseInt(a[2]));
        Lampe lampe = scene.getLampes().get(0);
        Couleur[] pixels = new Couleur[largeur * Integer.parseInt(a[2])];
        for (int p = 0; p < pixels.length; p++) {
            Rayon rayon = camera.getRayon(p % largeur + decalage, p / largeur + decalage);
            PointContact contact = scene.getClosestIntersection(rayon);
            pixels[p] = new Couleur();
            if (contact != null) {
                Vecteur N = contact.objet.getNormale(contact);
                Vecteur L = new Vecteur(contact, lampe.getPosition()).normalized();
                Vecteur H = L.sub(rayon.getV()).normalized();
                double eclat = N.dot(L) > 0 ? Math.pow(Math.max(0, N.dot(H)), Double.parseDouble(a[4]) * contact.objet.getNs())
                        : 0;
                pixels[p] = contact.objet.getKs().mul(lampe.getCouleur()).mul(eclat);
            }
        }
        return coder(pixels);
    }
}
