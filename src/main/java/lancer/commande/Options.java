package lancer.commande;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.texte.Texte;

/** La ligne de commande lue : la valeur de chaque option de la table, et la scène. Immuable. */
public final class Options {

    private static final String UNE_SCENE = "un fichier, par exemple scenes/scene1.ini";

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
        valeurs.keySet().forEach(option -> option.exclure(valeurs.keySet()));
        valeurs.keySet().forEach(option -> option.servir(valeurs.keySet()));
        Options options = new Options(scene, valeurs);
        if (options.sansFenetre() && scene == null) {
            throw Echec.demande("aucune scène à dessiner ; attendu : " + UNE_SCENE);
        }
        Option.Couple pixel = options.get(Option.PIXEL);
        Option.Couple taille = options.get(Option.TAILLE);
        if (pixel != null && (pixel.x >= taille.x || pixel.y >= taille.y)) {
            throw Option.PIXEL.impossible(textes.get(Option.PIXEL),
                    "un pixel de l'image, de 0,0 à " + (taille.x - 1) + "," + (taille.y - 1));
        }
        return options;
    }

    /** Range la valeur écrite de chaque option. @return la scène */
    private static String separer(Map<Option<?>, String> textes, String... arguments) {
        String scene = null;
        for (int k = 0; k < arguments.length; k++) {
            String argument = arguments[k];
            if (!argument.startsWith("-")) {
                scene = nommerLaScene(scene, argument);
                continue;
            }
            int egal = argument.startsWith("--") ? argument.indexOf('=') : -1;
            Option<?> option = Option.trouver(egal < 0 ? argument : argument.substring(0, egal));
            String valeur = argument.substring(egal + 1);
            if (egal < 0) {
                // dans « --image --fils 2 », le nom du fichier a été oublié
                boolean suit = option.prendUneValeur() && k + 1 < arguments.length
                        && !arguments[k + 1].startsWith("--");
                valeur = suit ? arguments[++k] : "";
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

    private static String nommerLaScene(String deja, String nom) {
        if (deja != null) {
            throw Echec.demande("plusieurs scènes : " + Texte.cite(deja) + " et " + Texte.cite(nom)
                    + " ; attendu : une seule");
        }
        if (nom.isEmpty()) {
            throw Echec.demande("nom de scène vide ; attendu : " + UNE_SCENE);
        }
        return nom;
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
        return Option.TABLE.stream().filter(Option::estUnReglage).map(this::ecrire).collect(Collectors.joining());
    }

    private <T> String ecrire(Option<T> option) {
        String valeur = option.ecrire(get(option));
        String ecrite = " " + option.nom + (option.prendUneValeur() ? " " + valeur : "");
        return valeur.equals(option.ecrire(option.absente)) ? "" : ecrite;
    }

    /** Dit si la demande (fichier, pixel, comparaison) se fait sans fenêtre. */
    public boolean sansFenetre() {
        return Stream.of(Option.IMAGE, Option.LINEAIRE, Option.PIXEL, Option.COMPARER).anyMatch(this::estDonnee);
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
