package lancer.mesures;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** Un fichier CSV (RFC 4180), sans fin de ligne dans un champ. La première ligne nomme les colonnes. */
public final class FichierCsv {

    private static final Pattern CHAMP = Pattern.compile(",(?:\"((?:[^\"]|\"\")*)\"|([^,]*))");

    private FichierCsv() {
    }

    /** Une ligne, sans sa fin. */
    public static String ligne(Object... valeurs) {
        return Arrays.stream(valeurs).map(v -> champ(v.toString())).collect(Collectors.joining(","));
    }

    /** Met le champ entre guillemets s'il contient une virgule ou un guillemet. */
    private static String champ(String texte) {
        return texte.matches("[^\",\\r\\n]*") ? texte : '"' + texte.replace("\"", "\"\"") + '"';
    }

    /**
     * Les lignes d'un fichier, par noms de colonnes.
     *
     * @throws IOException si une ligne n'a pas autant de champs que la première
     */
    public static List<Map<String, String>> lire(Path fichier) throws IOException {
        List<String> lignes = Files.readAllLines(fichier);
        List<Map<String, String>> lues = new ArrayList<>();
        List<String> colonnes = lignes.isEmpty() ? new ArrayList<>() : champs(lignes.get(0));
        for (int k = 1; k < lignes.size(); k++) {
            List<String> valeurs = champs(lignes.get(k));
            if (valeurs.size() != colonnes.size()) {
                throw new IOException(fichier + ", ligne " + (k + 1) + " : " + valeurs.size() + " champs au lieu de "
                        + colonnes.size());
            }
            lues.add(new LinkedHashMap<>());
            for (int c = 0; c < valeurs.size(); c++) {
                lues.get(k - 1).put(colonnes.get(c), valeurs.get(c));
            }
        }
        return lues;
    }

    static List<String> champs(String ligne) {
        List<String> champs = new ArrayList<>();
        Matcher m = CHAMP.matcher("," + ligne);
        while (m.find()) {
            champs.add(m.group(1) == null ? m.group(2) : m.group(1).replace("\"\"", "\""));
        }
        return champs;
    }
}
