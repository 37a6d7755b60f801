package lancer.auto;

import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;

/** Entre des réglages essayés : le moins cher qui tienne une erreur, le plus juste qui tienne un prix. */
final class Choix {

    /** Deux erreurs si proches ne valent pas de payer plus : 2 %, ou un centième de niveau. */
    private static final double PROCHE = 1.02;
    private static final double NEGLIGEABLE = 0.01;

    private Choix() {
    }

    /** @return {@code null} si aucun ne tient cette erreur, en niveaux */
    static Reglage moinsCher(List<Reglage> reglages, double erreur) {
        return reglages.stream().filter(r -> r.getErreurRetenue() <= erreur)
                .min(Comparator.comparingDouble(Reglage::getPrix).thenComparingDouble(Reglage::getErreur)).orElse(null);
    }

    /** @return {@code null} si aucun n'est à ce prix */
    static Reglage plusJuste(List<Reglage> reglages, double prix) {
        List<Reglage> abordables = reglages.stream().filter(r -> r.getPrix() <= prix).collect(Collectors.toList());
        double moindre = abordables.stream().mapToDouble(Reglage::getErreurRetenue).min().orElse(0);
        return moinsCher(abordables, PROCHE * moindre + NEGLIGEABLE);
    }
}
