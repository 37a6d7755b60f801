package lancer.mesures.vitesse;

import java.util.ArrayList;
import java.util.List;

/** Des réglages comparés ensemble, lancés à tour de rôle, à la même unité de temps. */
final class Groupe {

    /** Courbe ou tableau auquel ces mesures appartiennent, et scène dessinée. */
    final String volet;
    final String scene;

    /** Scène que dessine l'unité de temps, le programme sans option. */
    final String sceneUnite;
    final List<Essai> essais = new ArrayList<>();

    /** Un réglage, et son abscisse. */
    static final class Essai {

        final Reglage reglage;
        final double x;

        Essai(Reglage reglage, double x) {
            this.reglage = reglage;
            this.x = x;
        }
    }

    Groupe(String volet, String scene, String sceneUnite) {
        this.volet = volet;
        this.scene = scene;
        this.sceneUnite = sceneUnite;
    }

    /** @param x abscisse de la courbe ; 0 si le volet n'en est pas une */
    Groupe avec(Reglage reglage, double x) {
        essais.add(new Essai(reglage, x));
        return this;
    }
}
