package lancer.commande;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
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
        boolean unTexte = textes.containsKey(Option.AIDE) || textes.containsKey(Option.VERSION);
        for (Option<?> option : Option.TABLE) {
            if (textes.containsKey(option) && (!unTexte || !option.prendUneValeur())) {
                valeurs.put(option, option.lire(textes.get(option)));
            }
        }
        Options options = new Options(scene, valeurs);
        if (!unTexte) {
            options.accorder(textes);
        }
        return options;
    }

    /** Range la valeur écrite de chaque option, jusqu'à une demande d'aide ou de version. @return la scène */
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
            String valeur = egal < 0 ? "" : argument.substring(egal + 1);
            if (!option.prendUneValeur() && egal >= 0) {
                throw Echec.demande("option qui ne prend pas de valeur : " + option.nom + " ; reçu : "
                        + Texte.cite(valeur));
            }
            // dans « --image --fils 2 », le nom du fichier a été oublié
            if (option.prendUneValeur() && egal < 0 && k + 1 < arguments.length && !arguments[k + 1].startsWith("--")) {
                valeur = arguments[++k];
            }
            if (textes.put(option, valeur) != null) {
                throw Echec.demande("option donnée deux fois : " + option.nom
                        + " ; attendu : une seule fois chaque option");
            }
            if (option.prendUneValeur() && valeur.isEmpty()) {
                throw Echec.demande("option sans sa valeur : " + option.nom + " ; attendu : " + option.attendu);
            }
            if (option == Option.AIDE || option == Option.VERSION) {
                return scene;
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
            throw Echec.demande("nom de scène vide ; attendu : un fichier, par exemple scenes/scene1.ini");
        }
        return nom;
    }

    private void accorder(Map<Option<?>, String> textes) {
        for (Option<?> option : valeurs.keySet()) {
            option.exclure(valeurs.keySet());
        }
        for (Option<?> option : valeurs.keySet()) {
            option.servir(valeurs.keySet());
        }
        if (sansFenetre() && scene == null) {
            throw Echec.demande("aucune scène à dessiner ; attendu : un fichier, par exemple scenes/scene1.ini");
        }
        Option.Couple pixel = get(Option.PIXEL);
        Option.Couple taille = get(Option.TAILLE);
        if ((long) taille.x * taille.y > Option.PIXELS_MAX) {
            throw Option.TAILLE.impossible(textes.get(Option.TAILLE), Option.TAILLE.attendu);
        }
        if (pixel != null && (pixel.x >= taille.x || pixel.y >= taille.y)) {
            throw Option.PIXEL.impossible(textes.get(Option.PIXEL),
                    "un pixel de l'image, de 0,0 à " + (taille.x - 1) + "," + (taille.y - 1));
        }
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
        StringBuilder ecrites = new StringBuilder();
        for (Option<?> option : Option.TABLE) {
            ecrites.append(option.estUnReglage() ? ecrire(option) : "");
        }
        return ecrites.toString();
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
        StringBuilder aide = new StringBuilder("Usage : java -jar target/lancer.jar [options] scenes/scene1.ini\n\n"
                + "Dessine une scène par lancer de rayons : dans une fenêtre, ou dans un fichier.\n\n");
        for (Option<?> option : Option.TABLE) {
            aide.append(option.getAide());
        }
        return aide + "\nUne option s'écrit aussi --option=valeur, et l'ordre n'a pas d'importance.\n"
                + "Statut de sortie : 0 fait, 1 la machine n'a pas pu, 2 demande fausse.";
    }
}
