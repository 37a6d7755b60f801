package lancer.fenetre.etat;

import lancer.Point;
import lancer.commande.Couple;
import lancer.image.ImageMemoire;

/**
 * Où se voit une image, en pixels de l'écran : au milieu de sa place, réduite si elle y tient mal, ou à la loupe. Les
 * points sont des {@link Point} d'abscisse x, d'ordonnée y vers le bas, et de z nul. Immuable.
 */
public final class Loupe {

    private static final int LOUPE_MAX = 16;

    /** La place de l'image, en pixels de l'écran. */
    public final int largeur;
    public final int hauteur;
    /** Le grossissement, 0 sans loupe ; avec elle, le point de l'image qui est au milieu de la place. */
    final int fois;
    private final Point milieu;

    private Loupe(int largeur, int hauteur, int fois, Point milieu) {
        this.largeur = largeur;
        this.hauteur = hauteur;
        this.fois = fois;
        this.milieu = milieu;
    }

    Loupe(int largeur, int hauteur) {
        this(largeur, hauteur, 0, new Point());
    }

    /** Celle-ci, dans une autre place. */
    public Loupe dans(int autreLargeur, int autreHauteur) {
        return autreLargeur == largeur && autreHauteur == hauteur ? this
                : new Loupe(autreLargeur, autreHauteur, fois, milieu);
    }

    /** Le plus grand rapport auquel une image de cette taille tient dans la place. */
    private double getRapport(int l, int h) {
        return Math.min((double) largeur / l, (double) hauteur / h);
    }

    /** La plus grande taille d'une image de ces proportions qui tient dans la place. */
    Couple remplir(Couple taille) {
        double rapport = getRapport(taille.x, taille.y);
        return new Couple((int) Math.max(1, Math.round(rapport * taille.x)),
                (int) Math.max(1, Math.round(rapport * taille.y)));
    }

    /** Le rapport de la taille montrée de l'image à sa taille. */
    public double getReduction(ImageMemoire image) {
        return fois > 0 ? fois : Math.min(1, getRapport(image.largeur, image.hauteur));
    }

    /** Le côté d'un pixel de l'image, à l'écran : d'une image très réduite, il reste une ligne. */
    public double getLargeurDUnPixel(ImageMemoire image) {
        return Math.max(getReduction(image), 1.0 / image.largeur);
    }

    public double getHauteurDUnPixel(ImageMemoire image) {
        return Math.max(getReduction(image), 1.0 / image.hauteur);
    }

    /** La place du coin de l'image, celle d'un pixel de l'écran. */
    public Point getCoin(ImageMemoire image) {
        Point exact = getCoinExact(image);
        return new Point(Math.rint(exact.x), Math.rint(exact.y), 0);
    }

    private Point getCoinExact(ImageMemoire image) {
        double x = fois > 0 ? Math.min(image.largeur, milieu.x) : image.largeur / 2.0;
        double y = fois > 0 ? Math.min(image.hauteur, milieu.y) : image.hauteur / 2.0;
        return new Point(largeur / 2.0 - getLargeurDUnPixel(image) * x,
                hauteur / 2.0 - getHauteurDUnPixel(image) * y, 0);
    }

    /** La place de ce point de l'image. */
    public Point placeDe(ImageMemoire image, double xe, double ye) {
        Point coin = getCoin(image);
        return new Point(coin.x + getLargeurDUnPixel(image) * xe, coin.y + getHauteurDUnPixel(image) * ye, 0);
    }

    /** Le point de l'image qui est là. */
    public Point pointDe(ImageMemoire image, double x, double y) {
        return pointDe(image, getCoin(image), x, y);
    }

    private Point pointDe(ImageMemoire image, Point coin, double x, double y) {
        return new Point((x - coin.x) / getLargeurDUnPixel(image), (y - coin.y) / getHauteurDUnPixel(image), 0);
    }

    /** Le pixel de l'image qui est là, ou le plus proche. */
    public Pixel pixelDe(ImageMemoire image, double x, double y) {
        Point point = pointDe(image, x, y);
        return new Pixel((int) Math.floor(point.x), (int) Math.floor(point.y)).dans(image.largeur, image.hauteur);
    }

    /** Dit si l'image est là. */
    public boolean contient(ImageMemoire image, double x, double y) {
        Point point = pointDe(image, x, y);
        return point.x >= 0 && point.x < image.largeur && point.y >= 0 && point.y < image.hauteur;
    }

    /** Agrandit ou réduit deux fois ; ce qui est là y reste, d'après le milieu exact : des arrondis s'ajouteraient. */
    Loupe grossir(ImageMemoire image, boolean plus, double x, double y) {
        Point vise = pointDe(image, getCoinExact(image), x, y);
        // une image réduite passe d'abord à sa taille, un pixel pour un pixel
        int premiere = getRapport(image.largeur, image.hauteur) < 1 ? 1 : 2;
        int moins = fois <= premiere ? 0 : fois / 2;
        return new Loupe(largeur, hauteur, plus ? Math.max(premiere, Math.min(LOUPE_MAX, 2 * fois)) : moins, milieu)
                .amener(vise, x, y);
    }

    /** À la loupe, met là ce point de l'image. */
    Loupe amener(Point point, double x, double y) {
        double pixels = Math.max(1, fois);
        return new Loupe(largeur, hauteur, fois, new Point(Math.max(0, point.x + (largeur / 2.0 - x) / pixels),
                Math.max(0, point.y + (hauteur / 2.0 - y) / pixels), 0));
    }

    /** Garde ce pixel en vue. */
    Loupe suivre(ImageMemoire image, Pixel pixel) {
        Point coin = placeDe(image, pixel.x, pixel.y);
        boolean enVue = coin.x >= 0 && coin.y >= 0 && coin.x + fois <= largeur && coin.y + fois <= hauteur;
        return fois == 0 || enVue ? this : amener(new Point(pixel.x, pixel.y, 0), largeur / 2.0, hauteur / 2.0);
    }
}
