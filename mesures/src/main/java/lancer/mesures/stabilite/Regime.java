package lancer.mesures.stabilite;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.function.Function;

/** Familles de rayons sur lesquelles les méthodes sont comparées, en temps et en erreur. */
public enum Regime {

    ORDINAIRE("D'ordinaire : une boule à portée de 3 à 30 rayons", h -> Cas.deLoin(h, puissance(h, 0.5, 1.5))),
    LOIN("De loin : de 10⁵ à 10⁹ rayons, une lampe lointaine", h -> Cas.deLoin(h, puissance(h, 5, 9))),
    RASANT("Au ras : à 10⁻³ … 10⁻¹³ rayon de la tangente", h -> Cas.rasant(h, puissance(h, 0.5, 1.5),
            (h.nextBoolean() ? 1 : -1) * puissance(h, -13, -3))),
    SOL("Au-dessus d'un sol de rayon 20 000, à hauteur 1", h -> Cas.auSol(h, 20_000));

    /** Nombre de rayons à juger ; les premiers servent à mesurer le temps. */
    public static final int RAYONS = 4_000;

    public final String nom;
    private final Function<Random, Cas> tirage;

    Regime(String nom, Function<Random, Cas> tirage) {
        this.nom = nom;
        this.tirage = tirage;
    }

    private static double puissance(Random h, double de, double a) {
        return Math.pow(10, de + (a - de) * h.nextDouble());
    }

    public String cle() {
        return name().toLowerCase(Locale.ROOT);
    }

    private long graine() {
        return 7_000L + ordinal();
    }

    /** Des rayons toujours les mêmes, sauf ceux qui ne peuvent être jugés ({@link Cas#seJuge}). */
    List<Cas> tirer(int tires) {
        return Mesures.tirer(tires, graine(), tirage);
    }

    List<Exactitude> juger() {
        return Mesures.juger("regime-" + cle(), 0, RAYONS, graine(), tirage, Arrays.asList(Formule.values()));
    }
}
