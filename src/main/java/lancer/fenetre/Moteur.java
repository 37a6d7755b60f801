package lancer.fenetre;

import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import lancer.commande.Options;
import lancer.dessin.Demande;
import lancer.dessin.Dessin;
import lancer.dessin.Lecture;

/** Le programme, tel que la fenêtre s'en sert : ses options, comment il lit une scène, comment il la dessine. */
final class Moteur {

    final Options options;
    /** Lit le fichier de ce nom ; la part lue, de 0 à 1, va au second argument. */
    final BiFunction<String, DoubleConsumer, Lecture> lecteur;
    /** Dessine cette demande ; le dessin va au second argument quand il commence, puis quand son brouillon est fini. */
    final BiConsumer<Demande, Consumer<Dessin>> programme;

    Moteur(Options options, BiFunction<String, DoubleConsumer, Lecture> lecteur,
            BiConsumer<Demande, Consumer<Dessin>> programme) {
        this.options = options;
        this.lecteur = lecteur;
        this.programme = programme;
    }

    /** Lit cette scène. @throws lancer.SceneFautive si elle ne peut être utilisée */
    Demande lire(String fichier, DoubleConsumer suivi) {
        return new Demande(lecteur.apply(fichier, suivi), options);
    }
}
