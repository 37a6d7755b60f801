package lancer.mesures;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/** Un fichier de nombres et de noms sans virgule. La première ligne nomme les colonnes. */
public final class FichierCsv {

    private FichierCsv() {
    }

    /**
     * Une ligne, sans sa fin.
     *
     * @throws IllegalArgumentException si un champ contient une virgule ou une fin de ligne
     */
    public static String ligne(Object... valeurs) {
        return Arrays.stream(valeurs).map(String::valueOf).peek(v -> {
            if (v.matches("(?s).*[,\n].*")) {
                throw new IllegalArgumentException("un champ ne contient ni virgule, ni fin de ligne : " + v);
            }
        }).collect(Collectors.joining(","));
    }

    /**
     * Les champs de chaque ligne, sauf la première ; aucune ligne si le fichier n'existe pas.
     *
     * @throws IOException si une ligne n'a pas autant de champs que la première
     */
    public static List<String[]> lire(Path fichier) throws IOException {
        List<String[]> lignes = new ArrayList<>();
        for (String ligne : Files.exists(fichier) ? Files.readAllLines(fichier) : new ArrayList<String>()) {
            String[] champs = ligne.split(",", -1);
            if (!lignes.isEmpty() && champs.length != lignes.get(0).length) {
                throw new IOException(fichier + " : " + champs.length + " champs au lieu de " + lignes.get(0).length + " : " + ligne);
            }
            lignes.add(champs);
        }
        return lignes.isEmpty() ? lignes : lignes.subList(1, lignes.size());
    }
}
