package lancer.correction.depot;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Le nom que Moodle donne à un rendu : {@code <nom>_<numéro>_assignsubmission_file}, suivi ou non de « _ », puis en
 * mode plat du nom du fichier (moodle, {@code mod/assign/classes/downloader.php}).
 */
final class NomMoodle {

    private static final Pattern FORME = Pattern.compile("([^/]*?)_(\\d+)_assignsubmission_([a-z]+)(?:_(.*))?");

    final String nom;
    final String id;
    /** Faux pour un texte en ligne, ou ce qu'un autre greffon a remis. */
    final boolean fichier;
    /** En mode plat, le nom du fichier ; vide pour un dossier. */
    final String reste;

    private NomMoodle(Matcher m) {
        nom = m.group(1).trim();
        id = m.group(2);
        fichier = m.group(3).equals("file");
        reste = m.group(4) == null ? "" : m.group(4);
    }

    /** @return {@code null} si ce n'est pas un nom de Moodle */
    static NomMoodle lire(String segment) {
        Matcher m = FORME.matcher(segment);
        return m.matches() ? new NomMoodle(m) : null;
    }
}
