package lancer;

import static org.junit.jupiter.api.Assertions.fail;

import java.lang.reflect.Field;
import java.util.Arrays;
import java.util.Collections;
import java.util.SplittableRandom;

/**
 * Les valeurs que demande {@link Tests}, celles de l'énoncé ou d'autres, tirées d'une graine ; les objets qu'elles
 * décrivent ; et de quoi les comparer, et les dire. Ce fichier est donné : il n'y a rien à y changer.
 */
abstract class Valeurs {

    /** Ce qui sépare deux réels que l'on tient pour égaux : le cours ne cherche ici que des erreurs très grossières. */
    static final double PRES = 1e-5;

    /** La même chose pour une composante d'une couleur : un quart de ce qui se voit à l'écran. */
    static final double PRES_COULEUR = 1e-3;

    static final Couleur NOIR = new Couleur(0, 0, 0);
    static final Couleur BLANC = new Couleur(1, 1, 1);

    /** D'où les valeurs sont tirées, toujours les mêmes pour une vérification et une graine ; {@code null} : elles ne le sont pas. */
    final SplittableRandom hasard = Long.getLong("tests.graine") == null ? null
            : new SplittableRandom(Long.getLong("tests.graine"));

    /** De quel angle la scène est tournée autour de la verticale, et où est son origine. */
    double tour = tirer(0, -3, 3);
    double[] origine = {tirer(0, -2, 2), tirer(0, -2, 2), tirer(0, -2, 2)};

    /** Le cosinus d'une direction de biais, et son sinus. */
    final double c = tirer(0.8, 0.5, 0.9);
    final double s = sinus(c);

    final Couleur gris = teinte(0.5, 0.5, 0.5);
    final Couleur couleurOrange = teinte(1, 0.5, 0.25);

    /** Cette valeur ou, si les valeurs sont tirées, une autre entre ces bornes, à deux décimales. */
    double tirer(double valeur, double min, double max) {
        return hasard == null ? valeur : Math.rint(100 * hasard.nextDouble(min, max)) / 100;
    }

    int entier(int valeur, int min, int max) {
        return hasard == null ? valeur : hasard.nextInt(min, max);
    }

    /** Cette valeur ou, tirée, la moitié d'un impair, qui n'est jamais entière et que même un {@code float} représente. */
    double demi(double valeur) {
        return hasard == null ? valeur : (hasard.nextBoolean() ? 0.5 : -0.5) * (2 * hasard.nextInt(1, 9) + 1);
    }

    double[] demis(double x, double y, double z) {
        return new double[] {demi(x), demi(y), demi(z)};
    }

    /** Cette couleur, chaque composante un peu assombrie si les valeurs sont tirées. */
    Couleur teinte(double rouge, double vert, double bleu) {
        return new Couleur(part(rouge), part(vert), part(bleu));
    }

    double part(double composante) {
        return hasard == null ? composante : Math.rint(100 * composante * hasard.nextDouble(0.6, 0.95)) / 100;
    }

    /** Le sinus d'un angle de ce cosinus, et l'inverse : 0,6 pour 0,8, sans les derniers chiffres. */
    static double sinus(double cosinus) {
        return arrondi(Math.sqrt(1 - cosinus * cosinus));
    }

    static double arrondi(double x) {
        return Math.abs(x) < 1e6 ? Math.rint(x * 1e9) / 1e9 : x;
    }

    /** La scène reste où elle est écrite : devant l'écran. */
    void devantLaCamera() {
        tour = 0;
        origine = new double[3];
    }

    /** Où va cette direction quand la scène est tournée, et ce point. */
    double[] direction(double x, double y, double z) {
        double cos = Math.cos(tour);
        double sin = Math.sin(tour);
        return new double[] {cos * x + sin * z, y, cos * z - sin * x};
    }

    double[] lieu(double x, double y, double z) {
        return somme(origine, 1, direction(x, y, z));
    }

    /** a + k b */
    static double[] somme(double[] a, double k, double[] b) {
        return new double[] {a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]};
    }

    static double produit(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    static double[] unitaire(double[] v) {
        return somme(new double[3], 1 / Math.sqrt(produit(v, v)), v);
    }

    static boolean pres(double a, double b) {
        // l'égalité d'abord : elle seule compare deux infinis
        return a == b || Math.abs(a - b) <= PRES;
    }

    static boolean pres(Couleur c, Couleur d) {
        return composantes(c.r, d.r) && composantes(c.v, d.v) && composantes(c.b, d.b);
    }

    /** NaN n'est près que de NaN. */
    private static boolean composantes(double a, double b) {
        return Math.abs(a - b) <= PRES_COULEUR || Double.compare(a, b) == 0;
    }

    /** Abandonne la vérification si cette méthode n'est pas commencée. */
    static void siCommencee(boolean commencee, Class<?> classe, String methode, String sinon) {
        if (!commencee) {
            throw new Demande.NonCommencee(classe, methode, sinon);
        }
    }

    /** Abandonne la vérification si elle ne peut juger de rien. */
    static void siEvaluable(boolean evaluable, String sinon) {
        if (!evaluable) {
            throw new Demande.NonEvaluable(sinon);
        }
    }

    static void verifier(String demande, double attendu, double obtenu) {
        dire(pres(attendu, obtenu), demande, arrondi(attendu), arrondi(obtenu));
    }

    static void verifier(String demande, double[] a, Tuple t) {
        dire(t != null && pres(a[0], t.x) && pres(a[1], t.y) && pres(a[2], t.z), demande, lisible(a[0], a[1], a[2]),
                t == null ? t : lisible(t.x, t.y, t.z));
    }

    static void verifier(String demande, Couleur attendue, Couleur c) {
        dire(c != null && pres(attendue, c), demande, lisible(attendue.r, attendue.v, attendue.b), c == null ? c
                : lisible(c.r, c.v, c.b));
    }

    static void dire(boolean juste, String demande, Object attendu, Object obtenu) {
        if (!juste) {
            fail(demande + " ; attendu : " + attendu + ", obtenu : " + obtenu);
        }
    }

    /** Sans les derniers chiffres, qui ne sont que des arrondis : 0,8 et non 0,7999999999999999. */
    static String lisible(double x, double y, double z) {
        return "(" + arrondi(x) + ", " + arrondi(y) + ", " + arrondi(z) + ")";
    }

    static String plus(double x) {
        return (x < 0 ? " - " : " + ") + nb(Math.abs(x));
    }

    /** Un nombre d'une question, à trois décimales. */
    static String nb(double x) {
        double proche = Math.rint(x * 1e3) / 1e3;
        return proche == Math.rint(proche) ? String.valueOf((long) proche) : String.valueOf(proche);
    }

    static String texte(double... t) {
        return "(" + nb(t[0]) + "," + nb(t[1]) + "," + nb(t[2]) + ")";
    }

    static String texte(Couleur c) {
        return c.r == c.v && c.v == c.b ? nb(c.r) : texte(c.r, c.v, c.b);
    }

    /** Ce point et cette direction, tels qu'ils sont une fois la scène tournée. */
    String point(double x, double y, double z) {
        return texte(lieu(x, y, z));
    }

    String vers(double x, double y, double z) {
        return x == 0 && y == 0 && hasard == null ? z > 0 ? "+z" : "-z" : texte(direction(x, y, z));
    }

    Sphere boule(double x, double y, double z, double rayon) {
        double[] centre = lieu(x, y, z);
        return new Sphere(new Point(centre[0], centre[1], centre[2]), rayon);
    }

    Sphere boule(double x, double y, double z, double rayon, Couleur Kd, Couleur Ks, double ns) {
        Sphere boule = boule(x, y, z, rayon);
        boule.setKd(Kd);
        boule.setKs(Ks);
        boule.setNs(ns);
        return boule;
    }

    /** Une boule de rayon 1, pour que seule l'étape 5 voie que N n'est pas normalisé, et touchée en (0,0,4) vers +z. */
    Sphere boule(Couleur Kd, Couleur Ks, double ns) {
        return boule(0, 0, 5, 1, Kd, Ks, ns);
    }

    Lampe lampe(double x, double y, double z, Couleur couleur) {
        double[] position = lieu(x, y, z);
        return new Lampe(new Point(position[0], position[1], position[2]), couleur);
    }

    Lampe lampe(double x, double y, double z) {
        return lampe(x, y, z, BLANC);
    }

    /** Une lampe dont chaque composante est autre : qui en oublie la couleur se voit. */
    Lampe orange(double x, double y, double z) {
        return lampe(x, y, z, couleurOrange);
    }

    static Scene scene(Lampe lampe, Sphere... boules) {
        return new Scene(Arrays.asList(boules), lampe == null ? Collections.<Lampe>emptyList() : Collections.singletonList(lampe));
    }

    Rayon rayon(double px, double py, double pz, double vx, double vy, double vz) {
        double[] p = lieu(px, py, pz);
        double[] v = direction(vx, vy, vz);
        return new Rayon(new Point(p[0], p[1], p[2]), new Vecteur(v[0], v[1], v[2]));
    }

    /** L'objet d'un contact, que ce champ soit public ou non. */
    static Objet3D objet(PointContact contact) {
        return (Objet3D) champ(PointContact.class, "objet", contact);
    }

    static double distance(PointContact contact) {
        return (Double) champ(PointContact.class, "distance", contact);
    }

    static Object champ(Class<?> classe, String nom, Object objet) {
        try {
            Field champ = classe.getDeclaredField(nom);
            champ.setAccessible(true);
            return champ.get(objet);
        } catch (ReflectiveOperationException e) {
            return fail(classe.getSimpleName() + " n'a plus de champ " + nom);
        }
    }

    /** Le rayon de (0,0,0) vers +z. */
    Rayon devant() {
        return rayon(0, 0, 0, 0, 0, 1);
    }

    /** La couleur du ciel, dans une direction de longueur 1 qui monte d'autant. */
    static Couleur ciel(double y) {
        return y > 0 ? new Couleur(0.7 * (1 - y), 0.7 * (1 - y), 1) : new Couleur(0.5, 0.4 + 0.2 * y, 0.1);
    }
}
