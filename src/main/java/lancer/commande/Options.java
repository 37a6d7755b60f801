package lancer.commande;

import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedList;
import java.util.Map;
import java.util.stream.Collectors;
import lancer.texte.Texte;

/** La ligne de commande lue : la valeur de chaque option de la table, et la scène. Immuable. */
public final class Options {

    /** La scène, {@code null} si aucune n'est nommée. */
    public final String scene;
    /** Les options données. */
    private final Map<Option<?>, Object> valeurs;

    private Options(String scene, Map<Option<?>, Object> valeurs) {
        this.scene = scene;
        this.valeurs = valeurs;
    }

    /** @throws Echec si un argument est refusé : la demande est fausse */
    public static Options lire(String... arguments) {
        Map<Option<?>, String> textes = new HashMap<>();
        String scene = separer(textes, arguments);
        // dans l'ordre de la table : de deux fautes, c'est toujours la même qui est dite
        Map<Option<?>, Object> valeurs = new LinkedHashMap<>();
        for (Option<?> option : Option.TABLE) {
            if (textes.containsKey(option)) {
                valeurs.put(option, option.lire(textes.get(option)));
            }
        }
        for (Option<?> option : valeurs.keySet()) {
            option.accorder(valeurs.keySet());
        }
        Options options = new Options(scene, valeurs);
        if (options.sansFenetre() && scene == null) {
            throw Echec.demande("aucune scène à dessiner ; attendu : un fichier, par exemple scenes/scene1.ini");
        }
        Option.Couple pixel = options.get(Option.PIXEL);
        Option.Couple taille = options.get(Option.TAILLE);
        if ((long) taille.x * taille.y > Option.PIXELS_MAX) {
            throw Option.TAILLE.impossible(textes.get(Option.TAILLE), Option.TAILLE.attendu);
        }
        if (pixel != null && (pixel.x >= taille.x || pixel.y >= taille.y)) {
            throw Option.PIXEL.impossible(textes.get(Option.PIXEL),
                    "un pixel de l'image, de 0,0 à " + (taille.x - 1) + "," + (taille.y - 1));
        }
        return options;
    }

    /** Range la valeur écrite de chaque option. @return la scène, {@code null} si aucune n'est nommée */
    private static String separer(Map<Option<?>, String> textes, String... arguments) {
        String scene = null;
        LinkedList<String> mots = new LinkedList<>(Arrays.asList(arguments));
        while (!mots.isEmpty()) {
            String mot = mots.pop();
            if (!mot.startsWith("-")) {
                if (scene != null) {
                    throw Echec.demande("plusieurs scènes : " + Texte.cite(scene) + " et " + Texte.cite(mot)
                            + " ; attendu : une seule");
                }
                scene = mot.isEmpty() ? null : mot;
                continue;
            }
            String[] moities = mot.split("=", 2);
            Option<?> option = Option.trouver(moities[0]);
            String valeur = moities.length > 1 ? moities[1] : "";
            // dans « --image --fils 2 », le nom du fichier a été oublié
            if (moities.length == 1 && option.prendUneValeur() && !mots.isEmpty() && !mots.peek().startsWith("--")) {
                valeur = mots.pop();
            }
            if (option == Option.AIDE || option == Option.VERSION) {
                // seule cette demande compte
                textes.clear();
                textes.put(option, valeur);
                return null;
            }
            if (textes.put(option, valeur) != null) {
                throw Echec.demande("option donnée deux fois : " + option.nom
                        + " ; attendu : une seule fois chaque option");
            }
            if (option.prendUneValeur() && valeur.isEmpty()) {
                throw Echec.demande("option sans sa valeur : " + option.nom + " ; attendu : " + option.attendu);
            }
        }
        return scene;
    }

    /** La valeur de cette option, donnée ou non. */
    @SuppressWarnings("unchecked")
    public <T> T get(Option<T> option) {
        return estDonnee(option) ? (T) valeurs.get(option) : option.absente;
    }

    public boolean estDonnee(Option<?> option) {
        return valeurs.containsKey(option);
    }

    /** Les mêmes options, sauf celle-ci. */
    public <T> Options avec(Option<T> option, T valeur) {
        Map<Option<?>, Object> autres = new HashMap<>(valeurs);
        autres.put(option, valeur);
        return new Options(scene, autres);
    }

    /** Les options qui donnent la même image, précédées d'un blanc ; vide s'il n'en faut pas. */
    public String getReglages() {
        return Option.TABLE.stream().filter(option -> option.reglage).map(this::ecrire).collect(Collectors.joining());
    }

    private <T> String ecrire(Option<T> option) {
        String valeur = option.ecrire(get(option));
        String ecrite = " " + option.nom + (option.prendUneValeur() ? " " + valeur : "");
        return valeur.equals(option.ecrire(option.absente)) ? "" : ecrite;
    }

    /** Dit si la demande (fichier, pixel, comparaison) se fait sans fenêtre. */
    public boolean sansFenetre() {
        return estDonnee(Option.IMAGE) || estDonnee(Option.LINEAIRE) || estDonnee(Option.PIXEL)
                || estDonnee(Option.COMPARER);
    }

    public static String getVersion() {
        String version = Options.class.getPackage().getImplementationVersion();
        return "lancer " + (version != null ? version : "(non empaqueté)");
    }

    public static String getAide() {
        return "Usage : java -jar target/lancer.jar [options] scenes/scene1.ini\n\n"
                + "Dessine une scène par lancer de rayons : dans une fenêtre, ou dans un fichier.\n\n"
                + Option.TABLE.stream().map(Option::getAide).collect(Collectors.joining())
                + "\nUne option s'écrit aussi --option=valeur, et l'ordre n'a pas d'importance.\n"
                + "Statut de sortie : 0 fait, 1 la machine n'a pas pu, 2 demande fausse.";
    }
}
