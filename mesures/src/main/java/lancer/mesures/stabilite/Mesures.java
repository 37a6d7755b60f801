package lancer.mesures.stabilite;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Juge chaque méthode sur des rayons au hasard. Rien n'est chronométré : les nombres sont les mêmes sur toute machine. */
public final class Mesures {

    public static final String CSV = "stabilite.csv";

    /** Rayons de loin : x = |P − C|/r. */
    static final String LOIN = "loin";

    /** Rayons rasants : x = 1 − l/r, vus de près puis de loin. */
    static final String RAS = "ras";
    static final String RAS_LOIN = "ras-loin";

    /** Rayons au-dessus d'un sol : x = rayon du sol. */
    static final String SOL = "sol";

    /** Départ posé sur une surface : x = hauteur/rayon. */
    static final String POSE = "pose";

    /** Distance du départ au centre, en rayons, pour {@link #RAS} et {@link #RAS_LOIN}. */
    static final double PRES = 3;
    static final double LOINTAIN = 1000;

    /** Part minimale de rayons jugés pour tracer une abscisse. */
    private static final double PART_JUGEE = 0.5;

    private final int rayons;
    private final int pas;

    /** @param rapide vrai pour le dixième des rayons, à une abscisse sur deux */
    public Mesures(boolean rapide) {
        rayons = rapide ? 100 : 1000;
        pas = rapide ? 2 : 1;
    }

    public void ecrire(Path dossier) throws IOException {
        Exactitude.ecrire(dossier.resolve(CSV), toutes());
    }

    private List<Exactitude> toutes() {
        List<Exactitude> tous = new ArrayList<>();
        tous.addAll(courbe(LOIN, 1, 0, 12, 2, d -> h -> Cas.deLoin(h, d)));
        tous.addAll(courbe(RAS, 2, -14, -1, 1, m -> h -> Cas.rasant(h, PRES, m)));
        tous.addAll(courbe(RAS_LOIN, 3, -12, -1, 1, m -> h -> Cas.rasant(h, LOINTAIN, m)));
        tous.addAll(sol());
        tous.addAll(courbe(POSE, 5, -16, -1, 1, e -> h -> Cas.pose(h, e)));
        tous.addAll(Reflets.mesurer(pas > 1 ? 15 : 41));
        return tous;
    }

    List<Exactitude> sol() {
        return courbe(SOL, 4, 2, 9, 2, r -> h -> Cas.auSol(h, r));
    }

    /** Mesure {@code parDecade} abscisses par puissance de dix. */
    private List<Exactitude> courbe(String figure, int graine, int de, int a, int parDecade,
            Function<Double, Function<Random, Cas>> tirage) {
        return IntStream.rangeClosed(0, (a - de) * parDecade / pas).parallel().boxed().flatMap(k -> {
            double x = Math.pow(10, de + (double) k * pas / parDecade);
            return juger(figure, x, 1000L * graine + k, tirage.apply(x)).stream();
        }).collect(Collectors.toList());
    }

    /** Juge chaque méthode sur les mêmes rayons ; liste vide si la plupart ne peuvent être jugés. */
    private List<Exactitude> juger(String figure, double x, long graine, Function<Random, Cas> tirage) {
        Random hasard = new Random(graine);
        List<Cas> cas = IntStream.range(0, rayons).mapToObj(k -> tirage.apply(hasard)).filter(Cas::seJuge).collect(Collectors.toList());
        List<Exactitude> exactitudes = new ArrayList<>();
        if (cas.size() < PART_JUGEE * rayons) {
            return exactitudes;
        }
        for (Formule methode : Formule.values()) {
            int faux = 0;
            double relative = 0;
            double unites = 0;
            for (Cas c : cas) {
                if (c.malClasse(methode)) {
                    faux++;
                } else if (!Double.isInfinite(c.distance)) {
                    relative = Math.max(relative, c.erreurRelative(methode));
                    unites = Math.max(unites, c.erreurEnUnites(methode));
                }
            }
            exactitudes.add(new Exactitude(figure, methode.cle(), x, cas.size(), faux, relative, unites));
        }
        return exactitudes;
    }
}
