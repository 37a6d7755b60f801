package lancer.contrat;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import lancer.Couleur;

/** Un pixel n'a pu être calculé : une classe de la scène, ou une variante, échoue ou ne répond pas un nombre. */
public final class PixelFautif extends RuntimeException {

    private static final long serialVersionUID = 1L;

    /** Pile de la première cause de chaque classe : une fois le code compilé, Java n'en donne plus aux suivantes. */
    private static final Map<Class<?>, StackTraceElement[]> PILES = new ConcurrentHashMap<>();

    /** Colonne et ligne, depuis le haut à gauche, et le point de l'écran qui n'a pu être vu, en pixels. */
    public final int x;
    public final int y;
    public final double xe;
    public final double ye;

    /** @param xe en pixels depuis la gauche */
    public PixelFautif(double xe, double ye, Throwable cause) {
        super("pixel " + (int) xe + ", " + (int) ye, cause);
        PILES.computeIfAbsent(cause.getClass(), classe -> cause.getStackTrace());
        this.xe = xe;
        this.ye = ye;
        x = (int) xe;
        y = (int) ye;
    }

    /** La pile de sa cause ; à défaut, celle de la première de même classe. */
    @Override
    public StackTraceElement[] getStackTrace() {
        StackTraceElement[] pile = getCause().getStackTrace();
        return pile.length > 0 ? pile : PILES.get(getCause().getClass());
    }

    /** @throws PixelFautif si cette couleur, qui est rendue, est nulle ou a une composante qui n'est pas finie */
    public static Couleur verifier(Couleur couleur, double xe, double ye) {
        if (couleur == null || !couleur.estFinie()) {
            throw new PixelFautif(xe, ye,
                    new ArithmeticException("ce n'est pas une couleur aux composantes finies : " + couleur));
        }
        return couleur;
    }
}
