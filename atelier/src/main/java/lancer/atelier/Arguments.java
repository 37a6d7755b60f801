package lancer.atelier;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Une ligne de commande : des options, avec ou sans valeur, et le reste. */
public final class Arguments {

    /** Ce qui n'est pas une option. */
    public final List<String> restes = new ArrayList<>();

    private final Map<String, String> valeurs = new HashMap<>();

    /**
     * @param usage ce que dit le programme de ses options ; celles suivies d'un mot en capitales ont une valeur
     * @param restesPermis vrai si des noms peuvent suivre
     * @throws IllegalArgumentException si un argument ne va pas, avec un message d'une ligne
     */
    public Arguments(String usage, boolean restesPermis, String... args) {
        List<String> mots = Arrays.asList(usage.replaceAll("[\\[\\]|]", " ").trim().split("\\s+"));
        for (int k = 0; k < args.length; k++) {
            String option = args[k];
            int rang = mots.indexOf(option);
            if (!option.startsWith("--") && restesPermis) {
                restes.add(option);
                continue;
            }
            if (!option.startsWith("--") || rang < 0) {
                throw new IllegalArgumentException("option inconnue : « " + option + " » ; usage : " + usage);
            }
            boolean aValeur = rang + 1 < mots.size() && !mots.get(rang + 1).startsWith("--");
            if (aValeur && (++k == args.length || args[k].isEmpty())) {
                throw new IllegalArgumentException("option sans sa valeur : " + option + " ; usage : " + usage);
            }
            if (valeurs.put(option, aValeur ? args[k] : "") != null) {
                throw new IllegalArgumentException("option donnée deux fois : " + option);
            }
        }
    }

    public boolean a(String option) {
        return valeurs.containsKey(option);
    }

    public String valeur(String option, String defaut) {
        return valeurs.getOrDefault(option, defaut);
    }
}
