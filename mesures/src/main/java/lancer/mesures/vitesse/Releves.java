package lancer.mesures.vitesse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import lancer.mesures.FichierCsv;

/** Des mesures, et de quoi y retrouver celle qu'on cherche. */
final class Releves {

    /** Deux machines virtuelles ne sont jamais supposées plus semblables que cela. */
    private static final double MARGE_MIN = 1.05;

    private final List<Releve> tous;

    Releves(List<Releve> tous) {
        this.tous = tous;
    }

    /**
     * Lit les temps d'un dossier, et les erreurs de leurs réglages ; ceux des réglages sans erreur n'ont plus cours. Les rapports pris
     * dans une seule machine virtuelle ont la marge que montrent ceux qui devraient valoir 1.
     */
    static Releves lire(Path dossier) throws IOException {
        Releves temps = new Releves(lignes(dossier.resolve(Vitesse.CSV)));
        double marge = temps.marge();
        temps.tous.stream().filter(Releve::estDUneMachine).forEach(r -> r.marge = marge);
        List<Releve> tous = new ArrayList<>();
        for (Releve r : lignes(dossier.resolve(Comptes.CSV))) {
            tous.add(temps.tous.stream().filter(r::estLeMeme).findFirst().map(t -> t.avec(r)).orElse(r));
        }
        temps.tous.stream().filter(t -> !t.famille.equals(Catalogue.METHODES)).forEach(tous::add);
        return new Releves(tous);
    }

    /** Mesures d'un fichier, telles quelles ; aucune s'il n'est pas là. */
    static List<Releve> lignes(Path csv) throws IOException {
        return Files.exists(csv) ? FichierCsv.lire(csv).stream().map(Releve::new).collect(Collectors.toList()) : new ArrayList<>();
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

    /** Temps de la meilleure manche de toutes, en millisecondes ; NaN si aucune n'a été prise. */
    double referenceMs() {
        return tous.stream().mapToDouble(r -> r.nombre("reference_ms")).filter(t -> !Double.isNaN(t)).min().orElse(Double.NaN);
    }

    /** Les réglages du catalogue : POV-Ray, et ce que choisit {@code --auto}, ne sont là que pour comparer. */
    Releves aNous() {
        return tels(r -> !r.methode.equals(Catalogue.POVRAY) && !r.methode.equals(Catalogue.AUTO));
    }

    /** Front, du moins cher au plus juste : ce qui se trompe moins, à coup sûr, que tout ce qui est moins cher que lui. */
    List<Releve> front() {
        List<Releve> front = new ArrayList<>();
        aNous().tous.stream().sorted(Comparator.comparingDouble(Releve::rayons).thenComparingDouble(r -> r.erreur().valeur)).forEach(r -> {
            if (front.isEmpty() || r.erreur().nettementSous(front.get(front.size() - 1).erreur())) {
                front.add(r);
            }
        });
        return front;
    }

    /** Le moins cher dont l'erreur, intervalle compris, ne dépasse pas ce nombre de niveaux. */
    Optional<Releve> leMoinsCher(double erreur) {
        return aNous().tous.stream().filter(r -> r.erreur().max <= erreur).min(Comparator.comparingDouble(Releve::rayons));
    }

    /** Relevé le moins cher de ceux qui battent celui-ci à coup sûr. */
    Optional<Releve> vainqueur(Releve r) {
        return aNous().tous.stream().filter(a -> a.bat(r)).min(Comparator.comparingDouble(Releve::rayons));
    }
}
