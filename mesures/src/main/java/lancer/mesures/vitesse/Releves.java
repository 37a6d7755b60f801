package lancer.mesures.vitesse;

import java.util.ArrayList;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.stream.Collectors;

/** Des mesures, et de quoi y retrouver celle qu'on cherche. */
final class Releves {

    private final List<Releve> tous;

    Releves(List<Releve> tous) {
        this.tous = new ArrayList<>(tous);
    }

    List<Releve> get() {
        return tous;
    }

    Releves de(String scene, Famille famille) {
        return new Releves(tous.stream().filter(r -> r.scene.equals(scene) && r.famille.equals(famille.nom()))
                .collect(Collectors.toList()));
    }

    Releves de(Famille famille) {
        return new Releves(tous.stream().filter(r -> r.famille.equals(famille.nom())).collect(Collectors.toList()));
    }

    Releves de(String methode) {
        return new Releves(tous.stream().filter(r -> r.methode.equals(methode)).collect(Collectors.toList()));
    }

    /** @throws NoSuchElementException si elle n'a pas été mesurée */
    Releve le(String methode, String parametres) {
        return tous.stream().filter(r -> r.methode.equals(methode) && r.parametres.equals(parametres)).findFirst()
                .orElseThrow(() -> new NoSuchElementException("pas de mesure de " + methode + " " + parametres));
    }

    /** Les scènes, dans l'ordre des mesures. */
    List<String> scenes() {
        return tous.stream().map(r -> r.scene).distinct().collect(Collectors.toList());
    }

    boolean estVide() {
        return tous.isEmpty();
    }
}
