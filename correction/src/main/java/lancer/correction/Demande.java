package lancer.correction;

import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** La ligne de commande. */
final class Demande {

    private static final List<String> AVEC_VALEUR =
            List.of("--notes", "--sortie", "--bareme", "--corrige", "--variante", "--squelette");

    boolean aide;
    boolean sansConfinement;
    Path rendus;
    private final Map<String, String> valeurs = new HashMap<>();

    /** @throws Panne si un argument ne va pas */
    Demande(String[] arguments) {
        for (int k = 0; k < arguments.length && !aide; k++) {
            String nom = arguments[k];
            if (List.of("--aide", "--help", "-h").contains(nom)) {
                aide = true;
            } else if (nom.equals("--sans-confinement")) {
                sansConfinement = true;
            } else if (AVEC_VALEUR.contains(nom)) {
                if (++k >= arguments.length || arguments[k].isEmpty()) {
                    throw new Panne(2, "option sans sa valeur : " + nom);
                }
                valeurs.put(nom, arguments[k]);
            } else if (nom.startsWith("-")) {
                throw new Panne(2, "option inconnue : « " + nom + " » ; attendu : une de celles que montre --aide");
            } else if (rendus != null) {
                throw new Panne(2, "plusieurs rendus : « " + rendus + " » et « " + nom + " » ; attendu : un dossier, ou une archive");
            } else {
                rendus = Paths.get(nom);
            }
        }
        if (!aide && valeur("--squelette") == null && valeur("--corrige") == null && rendus == null) {
            throw new Panne(2, "aucun rendu à noter ; attendu : un dossier, ou l'archive de Moodle");
        }
    }

    /** Ce qui suit cette option, {@code null} si elle n'est pas là. */
    String valeur(String option) {
        return valeurs.get(option);
    }

    Path chemin(String option, Path defaut) {
        return valeurs.containsKey(option) ? Paths.get(valeurs.get(option)) : defaut;
    }
}
