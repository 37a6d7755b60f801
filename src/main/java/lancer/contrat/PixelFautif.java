package lancer.contrat;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import lancer.Couleur;

/** Échec du calcul d'un pixel : une exception, ou une couleur qui n'est pas finie. */
public final class PixelFautif extends RuntimeException {

    private static final long serialVersionUID = 1L;

    /** Pile de la première cause de chaque classe (voir docs/etendre.md). */
    private static final Map<Class<?>, StackTraceElement[]> PILES = new ConcurrentHashMap<>();

    /** Colonne et ligne du pixel, puis point de l'écran, en pixels depuis la gauche et depuis le haut. */
    public final int x;
    public final int y;
    public final double xe;
    public final double ye;

    public PixelFautif(double xe, double ye, Throwable cause) {
        super("pixel " + (int) xe + ", " + (int) ye, cause);
        PILES.computeIfAbsent(cause.getClass(), classe -> cause.getStackTrace());
        this.xe = xe;
        this.ye = ye;
        x = (int) xe;
        y = (int) ye;
    }

    /** La pile de la cause ou, si elle est vide, celle de la première cause de même classe. */
    @Override
    public StackTraceElement[] getStackTrace() {
        StackTraceElement[] pile = getCause().getStackTrace();
        return pile.length > 0 ? pile : PILES.get(getCause().getClass());
    }

    /** Rend cette couleur. @throws PixelFautif si elle est {@code null} ou si une composante n'est pas finie */
    public static Couleur verifier(Couleur couleur, double xe, double ye) {
        if (couleur == null || !couleur.estFinie()) {
            throw new PixelFautif(xe, ye,
                    new ArithmeticException("ce n'est pas une couleur aux composantes finies : " + couleur));
        }
        return couleur;
    }
}
