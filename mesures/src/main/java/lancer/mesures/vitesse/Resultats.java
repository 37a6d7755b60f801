package lancer.mesures.vitesse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import lancer.mesures.FichierCsv;

/** Les mesures d'un dossier, et les moyens d'en extraire. */
final class Resultats {

    static final String CSV = "mesures.csv";

    final List<Mesure> toutes;

    Resultats(List<Mesure> toutes) {
        this.toutes = toutes;
    }

    /** @return aucune mesure si le dossier n'en a pas */
    static Resultats lire(Path dossier) throws IOException {
        return new Resultats(FichierCsv.lire(dossier.resolve(CSV)).stream().map(Mesure::lire)
                .collect(Collectors.toCollection(ArrayList::new)));
    }

    void ecrire(Path dossier) throws IOException {
        List<String> lignes = toutes.stream().map(Mesure::ligne).collect(Collectors.toCollection(ArrayList::new));
        lignes.add(0, Mesure.COLONNES);
        Files.write(dossier.resolve(CSV), lignes);
    }

    /** La mesure de ce réglage, ajoutée si elle n'existe pas encore. */
    Mesure noter(Groupe groupe, Groupe.Essai essai) {
        Mesure neuve = new Mesure(groupe.volet, groupe.scene, essai.reglage.methode, essai.reglage.parametres, essai.x);
        Optional<Mesure> ancienne = volet(groupe.volet).scene(groupe.scene).toutes.stream().filter(m -> m.estDe(essai.reglage))
                .findFirst();
        if (!ancienne.isPresent()) {
            toutes.add(neuve);
        }
        return ancienne.orElse(neuve);
    }

    Resultats volet(String volet) {
        return tels(m -> m.volet.equals(volet));
    }

    Resultats scene(String scene) {
        return tels(m -> m.scene.equals(scene));
    }

    Resultats methode(String methode) {
        return tels(m -> m.methode.equals(methode));
    }

    Resultats tels(Predicate<Mesure> condition) {
        return new Resultats(toutes.stream().filter(condition).collect(Collectors.toList()));
    }

    Optional<Mesure> de(Reglage reglage) {
        return toutes.stream().filter(m -> m.estDe(reglage)).findFirst();
    }

    /** Les scènes, dans l'ordre des mesures. */
    List<String> scenes() {
        return toutes.stream().map(m -> m.scene).distinct().collect(Collectors.toList());
    }

    /** Les secondes de processeur de l'unité de ces mesures ; NaN si rien n'a été chronométré. */
    double unite() {
        return toutes.stream().mapToDouble(m -> m.unite).filter(t -> !Double.isNaN(t)).min().orElse(Double.NaN);
    }

    /** La mesure de ce réglage sur celle de ces scènes où son erreur est la plus grande ; vide s'il n'est pas mesuré sur chacune. */
    Optional<Mesure> pire(Mesure m) {
        List<Mesure> siennes = tels(a -> a.nom().equals(m.nom())).toutes;
        return siennes.size() < scenes().size() ? Optional.empty()
                : siennes.stream().max(Comparator.comparingDouble(a -> a.erreur.valeur));
    }

    /** Le moins cher en rayons, sur cette scène, des réglages dont l'erreur, intervalle compris, ne dépasse ce nombre sur aucune. */
    Optional<Mesure> leMoinsCher(String scene, double erreur) {
        return scene(scene).toutes.stream().filter(m -> pire(m).filter(p -> p.erreur.max <= erreur).isPresent())
                .min(Comparator.comparingDouble(m -> m.rayons));
    }

    /** Le réglage dont la pire erreur est la plus petite, de ceux qui ne prennent pas plus de tant de fois l'unité sur cette scène. */
    Optional<Mesure> lePlusJuste(String scene, double temps) {
        return scene(scene).toutes.stream().filter(m -> m.rapport() <= temps && pire(m).isPresent())
                .min(Comparator.comparingDouble(m -> pire(m).get().erreur.valeur));
    }

    /** La plus ancienne des mesures, d'après ce que chacune dit : son commit et son jour ; vide si aucune n'en dit rien. */
    String plusAncienne(Function<Mesure, String> quand) {
        return toutes.stream().map(quand).filter(q -> !q.isEmpty()).min(Comparator.comparing(q -> q.replaceFirst(".* ", ""))).orElse("");
    }
}
