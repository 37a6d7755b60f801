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
import lancer.mesures.Intervalle;

/** Des mesures, et les moyens d'en extraire. */
final class Releves {

    static final Comparator<Releve> PAR_TEMPS = Comparator.comparingDouble(r -> r.rapport().valeur);

    private final List<Releve> tous;

    Releves(List<Releve> tous) {
        this.tous = tous;
    }

    /** Lit les temps et les erreurs d'un dossier. Les temps d'un réglage qui n'a pas d'erreur mesurée sont ignorés. */
    static Releves lire(Path dossier) throws IOException {
        List<Releve> temps = lignes(dossier.resolve(Vitesse.CSV));
        List<Releve> tous = new ArrayList<>();
        for (Releve r : lignes(dossier.resolve(Comptes.CSV))) {
            tous.add(temps.stream().filter(r::estLeMeme).findFirst().map(r::avec).orElse(r));
        }
        temps.stream().filter(t -> !t.famille.equals(Catalogue.METHODES)).forEach(tous::add);
        return new Releves(tous);
    }

    /** Les mesures d'un fichier ; liste vide si le fichier n'existe pas. */
    static List<Releve> lignes(Path csv) throws IOException {
        return Files.exists(csv) ? FichierCsv.lire(csv).stream().map(Releve::new).collect(Collectors.toList()) : new ArrayList<>();
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

    /** @throws NoSuchElementException si cette mesure n'existe pas */
    Releve le(String methode, String parametres) {
        return methode(methode).tels(r -> r.parametres.equals(parametres)).get().stream().findFirst()
                .orElseThrow(() -> new NoSuchElementException("pas de mesure de " + methode + " " + parametres));
    }

    /** Les scènes, dans l'ordre des mesures. */
    List<String> scenes() {
        return tous.stream().map(r -> r.scene).distinct().collect(Collectors.toList());
    }

    /** Le temps de référence, celui d'un rayon par pixel, en secondes : la médiane, NaN si rien n'a été chronométré. */
    double secondes() {
        double[] ms = tous.stream().mapToDouble(r -> r.nombre("reference_ms")).filter(t -> !Double.isNaN(t)).toArray();
        return Intervalle.mediane(ms) / 1000;
    }

    /** Les réglages que l'on peut conseiller : sans POV-Ray, les boucles du cours, ni {@code --auto}. */
    Releves aNous() {
        return tels(r -> !Arrays.asList(Catalogue.POVRAY, Catalogue.BOUCLES, Catalogue.AUTO).contains(r.methode));
    }

    /** La mesure de ce réglage sur la scène où son erreur est la plus grande ; vide s'il n'est pas mesuré sur chaque scène. */
    Optional<Releve> pire(Releve r) {
        List<Releve> siens = methode(r.methode).tels(a -> a.parametres.equals(r.parametres)).tous;
        return siens.size() < scenes().size() ? Optional.empty()
                : siens.stream().max(Comparator.comparingDouble(a -> a.erreur().valeur));
    }

    /** Sur cette scène, le réglage le plus rapide dont l'erreur, intervalle compris, ne dépasse ce nombre de niveaux sur aucune scène. */
    Optional<Releve> lePlusRapide(String scene, double erreur) {
        return scene(scene).aNous().tous.stream().filter(r -> r.nombre("rapport") > 0
                && pire(r).filter(p -> p.erreur().max <= erreur).isPresent()).min(PAR_TEMPS);
    }

    /** Le plus rapide des réglages qui battent {@code r}. */
    Optional<Releve> vainqueur(Releve r) {
        return aNous().tous.stream().filter(a -> a.bat(r)).min(PAR_TEMPS);
    }
}
