package lancer.mesures.vitesse;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import lancer.atelier.FichierCsv;

/** Des mesures, et de quoi y retrouver celle qu'on cherche. */
final class Releves {

    /** Deux machines virtuelles ne sont jamais supposées plus semblables que cela. */
    private static final double MARGE_MIN = 1.05;

    private final List<Releve> tous;

    Releves(List<Releve> tous) {
        this.tous = tous;
    }

    /** Lit un CSV ; les rapports pris dans une seule machine virtuelle y ont la marge que montrent ceux qui devraient valoir 1. */
    static Releves lire(Path csv) throws IOException {
        Releves releves = new Releves(FichierCsv.lire(csv).stream().map(Releve::new).collect(Collectors.toList()));
        double marge = releves.marge();
        releves.tous.stream().filter(Releve::estDUneMachine).forEach(r -> r.elargir(marge));
        return releves;
    }

    /**
     * Le plus grand écart à 1 que portent les rapports de la référence à elle-même, d'une machine virtuelle à l'autre : ce qui, dans leurs
     * intervalles, comprend 1 est déjà dans ceux des autres.
     */
    double marge() {
        return tous.stream().filter(Releve::estTemoin)
                .mapToDouble(r -> Math.max(r.nombre("rapport_min"), 1 / r.nombre("rapport_max"))).reduce(MARGE_MIN, Math::max);
    }

    List<Releve> get() {
        return tous;
    }

    Releves de(String famille) {
        return tels(r -> r.famille.equals(famille));
    }

    Releves scene(String scene) {
        return tels(r -> r.scene.equals(scene));
    }

    Releves methode(String... noms) {
        return tels(r -> Arrays.asList(noms).contains(r.methode));
    }

    Releves tels(Predicate<Releve> condition) {
        return new Releves(tous.stream().filter(condition).collect(Collectors.toList()));
    }

    /** @throws NoSuchElementException si elle n'a pas été mesurée */
    Releve le(String methode, String parametres) {
        return methode(methode).tels(r -> r.parametres.equals(parametres)).get().stream().findFirst()
                .orElseThrow(() -> new NoSuchElementException("pas de mesure de " + methode + " " + parametres));
    }

    /** Les scènes, dans l'ordre des mesures. */
    List<String> scenes() {
        return tous.stream().map(r -> r.scene).distinct().collect(Collectors.toList());
    }

    /** De la meilleure manche de toutes, en millisecondes : ce qui donne un temps à chaque rapport. */
    double referenceMs() {
        return tous.stream().mapToDouble(r -> r.nombre("reference_ms")).filter(t -> !Double.isNaN(t)).min().orElse(Double.NaN);
    }

    /** Du moins cher au plus juste, ce que rien ne bat en rapport et en erreur, d'après leurs seules valeurs. */
    List<Releve> front() {
        List<Releve> parCout = new ArrayList<>(tous);
        parCout.sort(Comparator.comparingDouble((Releve r) -> r.rapport().valeur).thenComparingDouble(r -> r.erreur().valeur));
        List<Releve> front = new ArrayList<>();
        for (Releve r : parCout) {
            if (front.isEmpty() || r.erreur().valeur < front.get(front.size() - 1).erreur().valeur) {
                front.add(r);
            }
        }
        return front;
    }

    /** Ce qui bat celui-ci à coup sûr, le plus rapide. */
    Optional<Releve> vainqueur(Releve r) {
        return tous.stream().filter(a -> a.bat(r)).min(Comparator.comparingDouble(a -> a.rapport().valeur));
    }
}
