package lancer.commande;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.systeme.Echec;
import lancer.texte.Texte;

/** La ligne de commande : ce qu'elle demande, et les textes de {@code --aide} et de {@code --version}. */
public final class Options {

    private Options() {
    }

    /** Ce que demandent ces arguments. @throws Echec si l'un d'eux est refusé : la demande est fausse */
    public static Reglages lire(String... arguments) {
        Map<Option<?>, String> textes = new HashMap<>();
        String scene = separer(textes, arguments);
        // dans l'ordre de la table : de deux fautes, c'est toujours la même qui est dite
        List<Option<?>> donnees = new ArrayList<>(Option.TABLE);
        donnees.retainAll(textes.keySet());
        for (Option<?> option : donnees) {
            option.lire(textes.get(option));
        }
        for (Option<?> option : donnees) {
            option.accorder(donnees);
        }
        Reglages reglages = new Reglages(scene, textes);
        if (reglages.sansFenetre() && scene == null) {
            throw Echec.demande("aucune scène à dessiner ; attendu : un fichier, par exemple scenes/scene1.ini");
        }
        Couple pixel = reglages.get(Option.PIXEL);
        Couple taille = reglages.get(Option.TAILLE);
        if (pixel != null && (pixel.x >= taille.x || pixel.y >= taille.y)) {
            throw Option.PIXEL.impossible(textes.get(Option.PIXEL),
                    "un pixel de l'image, de 0,0 à " + (taille.x - 1) + "," + (taille.y - 1));
        }
        return reglages;
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
                            + " ; attendu : une seule" + conseil(textes.keySet()));
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

    /** PowerShell fait plusieurs mots d'une valeur qui a une virgule ; vide si aucune de ces options n'en a. */
    private static String conseil(Set<Option<?>> donnees) {
        return Stream.of(Option.PIXEL, Option.SANS).filter(donnees::contains).findFirst()
                .map(option -> ", et entre guillemets, pour PowerShell, la valeur de " + option.nom).orElse("");
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
