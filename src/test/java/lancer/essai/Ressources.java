package lancer.essai;

import java.io.File;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.Modele;
import lancer.contrat.Toile;

/** Les fichiers des tests, de quoi composer une scène, et une image dessinée en couleurs non limitées. */
public final class Ressources {

    private Ressources() {
    }

    /** Le chemin d'un fichier de {@code src/test/resources}. */
    public static String chemin(String nom) {
        try {
            return Path.of(Ressources.class.getResource("/" + nom).toURI()).toString();
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Les fichiers de ce dossier, et de ceux où l'on entre ; les autres peuvent changer pendant qu'on les cherche. */
    public static List<Path> fichiers(Path dossier, Predicate<Path> entrer) {
        List<Path> fichiers = new ArrayList<>();
        for (File fichier : dossier.toFile().listFiles()) {
            if (fichier.isFile()) {
                fichiers.add(fichier.toPath());
            } else if (fichier.isDirectory() && entrer.test(fichier.toPath())) {
                fichiers.addAll(fichiers(fichier.toPath(), entrer));
            }
        }
        return fichiers;
    }

    /** Les scènes de ce dossier, toujours dans le même ordre. */
    public static List<Path> scenes(Path dossier) {
        return fichiers(dossier, aucun -> false).stream().filter(f -> f.toString().endsWith(".ini")).sorted().collect(Collectors.toList());
    }

    /** Une image en couleurs non limitées : trois flottants par pixel, ligne par ligne depuis le haut. */
    public static final class Image implements Toile {

        public final int largeur;
        public final int hauteur;
        public final float[] composantes;

        public Image(int largeur, int hauteur) {
            this.largeur = largeur;
            this.hauteur = hauteur;
            this.composantes = new float[3 * largeur * hauteur];
        }

        @Override
        public void drawPixel(Couleur coul, int xe, int ye) {
            int k = 3 * (ye * largeur + xe);
            composantes[k] = (float) coul.r;
            composantes[k + 1] = (float) coul.v;
            composantes[k + 2] = (float) coul.b;
        }

        public boolean estFinie() {
            return ecart(composantes, composantes) == 0;
        }
    }

    /** La plus grande différence, composante par composante ; +∞ si les tailles diffèrent ou si un nombre n'est pas fini. */
    static double ecart(float[] a, float[] b) {
        double pire = a.length == b.length ? 0 : Double.POSITIVE_INFINITY;
        for (int k = 0; k < Math.min(a.length, b.length); k++) {
            double d = Math.abs((double) a[k] - b[k]);
            pire = d <= pire ? pire : Double.isNaN(d) ? Double.POSITIVE_INFINITY : d;
        }
        return pire;
    }

    public static Sphere boule(double x, double y, double z, double rayon, double kd, double ks, double ns) {
        Sphere boule = new Sphere(new Point(x, y, z), rayon);
        boule.setKd(new Couleur(kd));
        boule.setKs(new Couleur(ks));
        boule.setNs(ns);
        return boule;
    }

    /** Ce point, d'un monde autant de fois plus grand. */
    public static Point fois(Point p, double f) {
        return new Point(p.x * f, p.y * f, p.z * f);
    }

    /** Les objets et les lampes de cette scène, chacun mis à la place que dit cette fonction, d'un monde autant de fois plus grand. */
    public static Scene deplacee(Scene scene, UnaryOperator<Point> place, double fois) {
        List<Sphere> boules = new ArrayList<>();
        for (Objet3D objet : scene.getObjets()) {
            Sphere boule = new Sphere(place.apply(((Sphere) objet).getCentre()), ((Sphere) objet).getRayon() * fois);
            boule.setMatiere(objet);
            boules.add(boule);
        }
        return new Scene(boules, scene.getLampes().stream().map(lampe -> new Lampe(place.apply(lampe.getPosition()), lampe.getCouleur()))
                .collect(Collectors.toList()));
    }

    /** La question de l'ombre, posée comme le fait {@link Objet3D#getColor}. */
    public static boolean cachee(Scene scene, Lampe lampe, Point contact, Objet3D objet) {
        Vecteur versLampe = new Vecteur(contact, lampe.getPosition());
        return scene.estCachee(lampe, contact, versLampe.normalized(), versLampe.norme(), objet);
    }

    public static Scene scene(List<? extends Objet3D> objets, Lampe... lampes) {
        return new Scene(objets, List.of(lampes)).avec(new Modele().avecSeuil(0));
    }

    public static Image image(Scene scene, int largeur, int hauteur, int reflets, int fils) {
        Image image = new Image(largeur, hauteur);
        new Lancer(scene, new Camera(largeur, hauteur)).TracerImage(image, reflets, fils);
        return image;
    }

    public static boolean memesBits(Image a, Image b) {
        return Arrays.equals(a.composantes, b.composantes);
    }
}
