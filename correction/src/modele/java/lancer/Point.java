package lancer;

/** Un point de l'espace (cours, « Points et vecteurs »). */
public class Point extends Tuple {

    /** L'origine : le centre de l'écran. */
    public Point() {
        super();
    }

    public Point(double x, double y, double z) {
        super(x, y, z);
    }

    /** Le point translaté de {@code v}. */
    public Point add(Vecteur v) {
        return new Point(x + v.x, y + v.y, z + v.z);
    }

    /** Le point translaté de l'opposé de {@code v}. */
    public Point sub(Vecteur v) {
        //{ compléter : le point translaté de l'opposé de v
        return new Point(x - v.x, y - v.y, z - v.z);
        //= return new Point();
        //}
    }

    /** Le vecteur qui va de {@code q} à ce point. */
    public Vecteur sub(Point q) {
        //{ compléter : le vecteur qui va de q à ce point
        return new Vecteur(x - q.x, y - q.y, z - q.z);
        //= return new Vecteur();
        //}
    }

    public static Point add(Point p, Vecteur v) {
        return p.add(v);
    }

    public static Point sub(Point p, Vecteur v) {
        return p.sub(v);
    }

    /** Le vecteur qui va de {@code q} à {@code p}. */
    public static Vecteur sub(Point p, Point q) {
        return p.sub(q);
    }
}
