package lancer.mesures.vitesse;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/** Le front de Pareto : ce que rien ne bat à la fois en coût et en erreur. */
final class Front {

    private final List<Releve> tous;
    private final Cout cout;
    private final List<Releve> front = new ArrayList<>();

    Front(List<Releve> tous, Cout cout) {
        this.tous = new ArrayList<>(tous);
        this.cout = cout;
        List<Releve> parCout = new ArrayList<>(tous);
        parCout.sort(Comparator.comparingDouble(cout::de).thenComparingDouble(Releve::erreurEnPas));
        double erreur = Double.POSITIVE_INFINITY;
        for (Releve r : parCout) {
            if (r.erreurEnPas() < erreur) {
                front.add(r);
                erreur = r.erreurEnPas();
            }
        }
    }

    /** Du moins cher au plus juste. */
    List<Releve> get() {
        return front;
    }

    /** Vrai s'il est sur le front, ou confondu avec qui y est. */
    boolean contient(Releve r) {
        return front.stream().anyMatch(f -> cout.de(f) == cout.de(r) && f.erreurEnPas() == r.erreurEnPas());
    }

    /** Le moins cher de ce qui ne se trompe pas plus ; vide s'il n'y a pas moins cher que lui. */
    Optional<Releve> mieuxQue(Releve r) {
        return tous.stream().filter(a -> a.erreurEnPas() <= r.erreurEnPas() && cout.de(a) < cout.de(r))
                .min(Comparator.comparingDouble(cout::de));
    }

    /** Combien de fois moins cher que {@code r} est ce qui fait au moins aussi bien : 1 s'il est sur le front. */
    double gain(Releve r) {
        return mieuxQue(r).map(a -> cout.de(r) / cout.de(a)).orElse(1.0);
    }
}
