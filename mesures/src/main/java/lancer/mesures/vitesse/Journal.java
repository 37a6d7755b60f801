package lancer.mesures.vitesse;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Le CSV des mesures : chaque ligne y est écrite dès que sa mesure est finie, et d'un coup. Ce que Ctrl+C ou une panne a coupé
 * est oublié ; tout ce qui précède reste.
 */
final class Journal {

    private final Path fichier;

    Journal(Path fichier) {
        this.fichier = fichier;
    }

    Path getFichier() {
        return fichier;
    }

    /** Note une mesure de plus ; l'en-tête d'abord, s'il le faut. */
    void ajouter(String ligne) throws IOException {
        Files.createDirectories(fichier.toAbsolutePath().getParent());
        oublierLaFinCoupee();
        boolean vide = !Files.exists(fichier) || Files.size(fichier) == 0;
        String texte = (vide ? String.join(",", Releve.COLONNES) + "\n" : "") + ligne + "\n";
        Files.write(fichier, texte.getBytes(StandardCharsets.UTF_8), StandardOpenOption.CREATE, StandardOpenOption.APPEND);
    }

    /** Ôte ce qui suit la dernière fin de ligne. */
    private void oublierLaFinCoupee() throws IOException {
        if (!Files.exists(fichier)) {
            return;
        }
        try (RandomAccessFile acces = new RandomAccessFile(fichier.toFile(), "rw")) {
            long fin = acces.length();
            while (fin > 0) {
                acces.seek(fin - 1);
                if (acces.read() == '\n') {
                    break;
                }
                fin--;
            }
            acces.setLength(fin);
        }
    }

    /** Les mesures finies, dans l'ordre ; aucune si le fichier n'existe pas. */
    List<Releve> lire() throws IOException {
        List<Releve> releves = new ArrayList<>();
        if (!Files.exists(fichier)) {
            return releves;
        }
        String texte = new String(Files.readAllBytes(fichier), StandardCharsets.UTF_8);
        int fin = texte.lastIndexOf('\n');
        String[] lignes = fin < 0 ? new String[0] : texte.substring(0, fin).split("\n");
        List<String> colonnes = lignes.length == 0 ? new ArrayList<>() : champs(lignes[0]);
        for (int k = 1; k < lignes.length; k++) {
            List<String> valeurs = champs(lignes[k]);
            if (valeurs.size() != colonnes.size()) {
                throw new IOException(fichier + ", ligne " + (k + 1) + " : " + valeurs.size() + " champs au lieu de " + colonnes.size());
            }
            Map<String, String> parNom = new HashMap<>();
            for (int c = 0; c < valeurs.size(); c++) {
                parNom.put(colonnes.get(c), valeurs.get(c));
            }
            releves.add(new Releve(parNom));
        }
        return releves;
    }

    /** Ce qu'il n'y a plus à mesurer. */
    Set<String> clesFaites() throws IOException {
        Set<String> cles = new HashSet<>();
        for (Releve releve : lire()) {
            cles.add(releve.cle());
        }
        return cles;
    }

    /** Les champs d'une ligne (RFC 4180, sans fin de ligne dans un champ). */
    static List<String> champs(String ligne) {
        List<String> champs = new ArrayList<>();
        StringBuilder champ = new StringBuilder();
        boolean cite = false;
        for (int k = 0; k < ligne.length(); k++) {
            char c = ligne.charAt(k);
            if (cite && c == '"' && k + 1 < ligne.length() && ligne.charAt(k + 1) == '"') {
                champ.append('"');
                k++;
            } else if (c == '"') {
                cite = !cite;
            } else if (c == ',' && !cite) {
                champs.add(champ.toString());
                champ.setLength(0);
            } else {
                champ.append(c);
            }
        }
        champs.add(champ.toString());
        return champs;
    }
}
