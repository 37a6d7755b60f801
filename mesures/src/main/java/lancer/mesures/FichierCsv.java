package lancer.mesures;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** Le journal des mesures : une ligne de plus pour chaque scène mesurée, jamais une de moins. */
public final class FichierCsv {

    static final List<String> COLONNES = Arrays.asList("date", "commit", "machine", "coeurs", "jvm", "scene", "spheres", "largeur",
            "hauteur", "fils", "primaires", "ombre", "reflechis", "pixels_verifies", "repetitions", "lecture_ms", "preparation_ms",
            "premiere_ms", "mediane_ms", "q1_ms", "q3_ms", "min_ms", "max_ms");

    private static final double NS_PAR_MS = 1e6;

    private final Path fichier;
    private final Circonstances circonstances;
    private final Reglages reglages;

    FichierCsv(Path fichier, Circonstances circonstances, Reglages reglages) {
        this.fichier = fichier;
        this.circonstances = circonstances;
        this.reglages = reglages;
    }

    void ajouter(String scene, Mesure m) throws IOException {
        List<String> lignes = new ArrayList<>();
        Path dossier = fichier.toAbsolutePath().getParent();
        Files.createDirectories(dossier);
        if (!Files.exists(fichier) || Files.size(fichier) == 0) {
            lignes.add(String.join(",", COLONNES));
        }
        lignes.add(ligne(circonstances.date, circonstances.commit, circonstances.machine, circonstances.coeurs, circonstances.jvm,
                scene, m.spheres, reglages.largeur, reglages.hauteur, reglages.fils, m.primaires, m.ombre, m.reflechis,
                m.pixelsVerifies, m.temps.nombre(), ms(m.lectureNs), ms(m.preparationNs), ms(m.premiereNs), ms(m.temps.mediane()),
                ms(m.temps.premierQuartile()), ms(m.temps.troisiemeQuartile()), ms(m.temps.min()), ms(m.temps.max())));
        Files.write(fichier, lignes, StandardCharsets.UTF_8, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
    }

    private static String ms(double ns) {
        return String.format(Locale.ROOT, "%.3f", ns / NS_PAR_MS);
    }

    /** Une ligne, sans sa fin : les champs s'y séparent par des virgules (RFC 4180). */
    public static String ligne(Object... valeurs) {
        return Arrays.stream(valeurs).map(v -> champ(v.toString())).collect(Collectors.joining(","));
    }

    /** Entre guillemets si une virgule ou un guillemet l'exige (RFC 4180). */
    private static String champ(String texte) {
        return texte.matches("[^\",\\r\\n]*") ? texte : '"' + texte.replace("\"", "\"\"") + '"';
    }
}
