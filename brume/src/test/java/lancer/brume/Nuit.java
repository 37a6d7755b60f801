package lancer.brume;

import lancer.Couleur;
import lancer.Scene;
import lancer.contrat.Atmosphere;
import lancer.contrat.Variante;
import lancer.lecture.Section;

/**
 * Une quatrième variante, comme un étudiant l'écrirait : tout s'assombrit de moitié à chaque {@code portee}. Elle n'est dans
 * le chemin des classes que des essais qui la demandent, par {@code quatrieme/META-INF/services}.
 */
public final class Nuit implements Variante {

    @Override
    public String getSection() {
        return "Nuit";
    }

    @Override
    public void installer(Section valeurs, Scene scene) {
        scene.setAtmosphere(new Obscurite(valeurs.reelPositif("portee", 10, 1e6)));
    }

    private static final class Obscurite implements Atmosphere {

        private final double portee;

        Obscurite(double portee) {
            this.portee = portee;
        }

        @Override
        public Couleur traverser(Couleur vue, double distance) {
            return vue.mul(Math.pow(0.5, distance / portee));
        }
    }
}
