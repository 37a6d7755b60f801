package lancer.auto;

import java.util.ArrayList;
import java.util.List;

/** Entre des réglages essayés : le moins cher qui tienne une erreur, le plus juste qui tienne un prix. */
final class Choix {

    /** Deux erreurs si proches ne valent pas de payer plus : 2 %, ou un centième de niveau. */
    private static final double PROCHE = 1.02;
    private static final double NEGLIGEABLE = 0.01;

    private Choix() {
    }

    static Reglage moinsCher(List<Reglage> reglages) {
        return moinsCher(reglages, Double.POSITIVE_INFINITY);
    }

    /** @return {@code null} si aucun ne tient cette erreur, en niveaux */
    static Reglage moinsCher(List<Reglage> reglages, double erreur) {
        Reglage choisi = null;
        for (Reglage r : reglages) {
            if (r.getErreurRetenue() <= erreur && (choisi == null || r.getPrix() < choisi.getPrix()
                    || r.getPrix() == choisi.getPrix() && r.getErreur() < choisi.getErreur())) {
                choisi = r;
            }
        }
        return choisi;
    }

    /** @return {@code null} si aucun n'est à ce prix */
    static Reglage plusJuste(List<Reglage> reglages, double prix) {
        List<Reglage> abordables = new ArrayList<>();
        double moindre = Double.POSITIVE_INFINITY;
        for (Reglage r : reglages) {
            if (r.getPrix() <= prix) {
                abordables.add(r);
                moindre = Math.min(moindre, r.getErreurRetenue());
            }
        }
        return moinsCher(abordables, PROCHE * moindre + NEGLIGEABLE);
    }
}
