package lancer.mesures.stabilite;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;

/** Résultats des mesures de stabilité. */
public final class Bilan {

    /** Part des rayons mal classés au-dessus de laquelle une erreur n'a plus de sens. */
    private static final double TROP = 0.1;

    /** Borne promise par le programme, en unités de l'erreur inévitable κ u t. */
    public static final double PROMESSE = 8;

    private final List<Exactitude> tous;

    /** Lit les mesures de ce dossier. */
    public Bilan(Path dossier) throws IOException {
        tous = Exactitude.lire(dossier.resolve(Mesures.CSV));
    }

    List<Exactitude> de(String figure, Formule methode) {
        return de(figure, methode.cle());
    }

    List<Exactitude> de(String figure, String methode) {
        return tous.stream().filter(r -> r.figure.equals(figure) && r.formule.equals(methode)).collect(Collectors.toList());
    }

    public static boolean estClasse(Exactitude r) {
        return r.part() <= TROP;
    }

    /** La plus grande de ces valeurs pour le programme. */
    double max(String figure, ToDoubleFunction<Exactitude> valeur) {
        return de(figure, Formule.PROGRAMME).stream().mapToDouble(valeur).max().orElse(0);
    }

    /**
     * Exposant de Lyapunov d'une chaîne de reflets : la croissance moyenne, par reflet, du logarithme naturel de l'erreur, tant que le
     * contact est connu au centième. L'arithmétique la plus précise en donne la plus longue suite.
     */
    public double exposantDeLyapunov() {
        List<Exactitude> justes = de(Reflets.FIGURE, "deux_doubles").stream().filter(r -> r.erreurRelative < 0.01)
                .collect(Collectors.toList());
        return Math.log(justes.get(justes.size() - 1).erreurRelative / justes.get(0).erreurRelative) / (justes.size() - 1);
    }
}
