package lancer;

import lancer.precision.Norme;

/**
 * Un vecteur de l'espace (cours, « Points et vecteurs »). Immuable. Chaque opération existe sous deux formes de même
 * résultat : {@code u.add(v)} et {@code Vecteur.add(u, v)}.
 */
public class Vecteur extends Tuple {

    /** Le vecteur nul. */
    public Vecteur() {
        super();
    }

    public Vecteur(double x, double y, double z) {
        super(x, y, z);
    }

    /** Le vecteur qui va de {@code a} à {@code b} : b − a. */
    public Vecteur(Point a, Point b) {
        super(b.x - a.x, b.y - a.y, b.z - a.z);
    }

    public Vecteur add(Vecteur v) {
        return new Vecteur(x + v.x, y + v.y, z + v.z);
    }

    /** Somme u + k·v. */
    public Vecteur add(double k, Vecteur v) {
        return new Vecteur(x + k * v.x, y + k * v.y, z + k * v.z);
    }

    public Vecteur sub(Vecteur v) {
        return new Vecteur(x - v.x, y - v.y, z - v.z);
    }

    public Vecteur mul(double k) {
        return new Vecteur(x * k, y * k, z * k);
    }

    public Vecteur div(double k) {
        return new Vecteur(x / k, y / k, z / k);
    }

    public Vecteur neg() {
        return new Vecteur(-x, -y, -z);
    }

    /** Produit scalaire : ‖u‖·‖v‖·cos(u, v). */
    public double dot(Vecteur v) {
        return x * v.x + y * v.y + z * v.z;
    }

    /** Carré de la norme : {@code v.dot(v)}. */
    public double norme2() {
        return dot(this);
    }

    /** Longueur du vecteur, juste même si son carré n'est pas représentable (composantes de 1e-200 ou 1e200). */
    public double norme() {
        double carre = x * x + y * y + z * z;
        return carre >= Norme.CARRE_MIN && carre <= Norme.CARRE_MAX ? Math.sqrt(carre)
                : Math.hypot(Math.hypot(x, y), z);
    }

    /**
     * Le vecteur de même direction et de longueur 1, à 4 unités du dernier chiffre près.
     *
     * @throws ArithmeticException si le vecteur est nul ou si une composante n'est pas finie
     */
    public Vecteur normalized() {
        double carre = x * x + y * y + z * z;
        if (!(carre >= Norme.CARRE_MIN && carre <= Norme.CARRE_MAX)) {
            return extremeNormalise();
        }
        double k = Math.abs(carre - 1) <= Norme.PRESQUE_UN ? 1.5 - 0.5 * carre : 1 / Math.sqrt(carre);
        return new Vecteur(x * k, y * k, z * k);
    }

    private Vecteur extremeNormalise() {
        double plusGrande = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        if (!(plusGrande > 0 && plusGrande <= Double.MAX_VALUE)) {
            throw new ArithmeticException("vecteur sans direction, impossible à normaliser : " + this);
        }
        // une puissance de deux : la multiplication est exacte, sauf pour une composante négligeable
        int k = -Math.getExponent(plusGrande);
        return new Vecteur(Math.scalb(x, k), Math.scalb(y, k), Math.scalb(z, k)).normalized();
    }

    public static Vecteur add(Vecteur u, Vecteur v) {
        return u.add(v);
    }

    public static Vecteur sub(Vecteur u, Vecteur v) {
        return u.sub(v);
    }

    public static Vecteur mul(Vecteur v, double k) {
        return v.mul(k);
    }

    public static Vecteur div(Vecteur v, double k) {
        return v.div(k);
    }

    public static Vecteur neg(Vecteur v) {
        return v.neg();
    }

    public static double dot(Vecteur u, Vecteur v) {
        return u.dot(v);
    }

    public static Vecteur normalize(Vecteur v) {
        return v.normalized();
    }
}
