package lancer.correction.note;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import lancer.correction.Panne;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVPrinter;
import org.apache.commons.csv.QuoteMode;

/**
 * La feuille de notes de Moodle, dont seules les cases de la note et du commentaire sont modifiées (moodle,
 * {@code mod/assign/feedback/offline/importgradeslib.php}). Moodle ignore une note vide, mais un commentaire vide efface l'ancien : une
 * case inchangée est donc recopiée. Une note vient de la correction si le commentaire de la correction la répète sur la même ligne. Sinon,
 * elle vient de l'enseignant, et n'est pas modifiée.
 */
public final class FeuilleMoodle {

    private static final Pattern NUMERO = Pattern.compile("\\D*(\\d+)\\s*");
    private static final String DEBUT = "Correction automatique : ";
    private static final String FIN = " ; le détail est dans le fichier de retour.";
    private static final Pattern NOTRE = Pattern.compile("\\s*" + DEBUT + "(\\d+\\.\\d\\d), étape atteinte, « [^\n»]* »"
            + Pattern.quote(FIN));
    private static final String BOM = "\uFEFF";

    private final Path fichier;
    private final String texte;
    private final List<List<String>> lignes;
    private final int identifiant;
    private final int note;
    private final int maximum;
    private final int commentaire;
    private final int modifiable;

    /** @throws Panne si Moodle n'accepterait pas cette feuille de notes */
    public FeuilleMoodle(Path fichier) {
        this.fichier = fichier;
        try {
            texte = Files.readString(fichier);
            lignes = CSVParser.parse(texte.replaceFirst("^" + BOM, ""), CSVFormat.DEFAULT).stream()
                    .map(ligne -> new ArrayList<>(ligne.toList())).collect(Collectors.toList());
        } catch (CharacterCodingException e) {
            throw new Panne(2, fichier + " : n'est pas en UTF-8 ; attendu : la feuille de notes telle que Moodle la donne");
        } catch (IOException | RuntimeException e) {
            throw new Panne(2, "feuille de notes illisible : " + fichier + " (" + e.getMessage() + ")");
        }
        identifiant = colonne(true, "Identifier", "Identifiant");
        note = colonne(true, "Grade", "Note");
        colonne(true, "Last modified (grade)", "Dernière modification (note)");
        maximum = colonne(false, "Maximum Grade", "Note maximale");
        commentaire = colonne(false, "Feedback comments", "Feedback par commentaires");
        modifiable = colonne(false, "Grade can be changed", "La note peut être modifiée");
    }

    private int colonne(boolean exigee, String anglais, String francais) {
        List<String> titres = lignes.isEmpty() ? List.of() : lignes.get(0);
        int k = Math.max(titres.indexOf(anglais), titres.indexOf(francais));
        if (k < 0 && exigee) {
            throw new Panne(2, fichier + " : la colonne « " + francais + " » (« " + anglais + " ») manque ; "
                    + "attendu : la feuille de notes telle que Moodle la donne, séparée par des virgules");
        }
        return k;
    }

    /** Une case, vide si la ligne ne l'a pas. */
    private static String valeur(List<String> ligne, int colonne) {
        return colonne >= 0 && colonne < ligne.size() ? ligne.get(colonne) : "";
    }

    /**
     * Écrit {@code notes-a-deposer.csv}. Une note que la correction n'a pas écrite est gardée : l'enseignant doit examiner ce rendu.
     *
     * @return les rendus jugés dont la note n'est pas dans la feuille : ils n'y sont pas, ou leur note est verrouillée
     */
    public Collection<Eleve> ecrire(Path dossier, List<Eleve> eleves, Bareme bareme) throws IOException {
        Map<String, Eleve> parId = new LinkedHashMap<>();
        eleves.forEach(e -> parId.put(e.resultat.id, e));
        lignes.stream().skip(1).forEach(ligne -> noter(ligne, parId, bareme));
        try (CSVPrinter csv = new CSVPrinter(Files.newBufferedWriter(dossier.resolve("notes-a-deposer.csv")), CSVFormat.DEFAULT.builder()
                .setRecordSeparator(texte.contains("\r\n") ? "\r\n" : "\n").setQuoteMode(QuoteMode.MINIMAL).get())) {
            csv.getOut().append(texte.startsWith(BOM) ? BOM : "");
            csv.printRecords(lignes);
        }
        parId.values().removeIf(Eleve::illisible);
        return parId.values();
    }

    /** Note cette ligne si elle est celle d'un de ces élèves et qu'elle peut changer. L'élève est alors retiré de {@code parId}. */
    private void noter(List<String> ligne, Map<String, Eleve> parId, Bareme bareme) {
        Matcher m = NUMERO.matcher(valeur(ligne, identifiant));
        Eleve eleve = m.matches() ? parId.get(m.group(1)) : null;
        if (eleve == null || ligne.size() <= note || valeur(ligne, modifiable).trim().matches("(?i)no|non")) {
            return;
        }
        parId.remove(m.group(1));
        double sur = reel(valeur(ligne, maximum)) > 0 ? reel(valeur(ligne, maximum)) : bareme.total;
        String neuve = eleve.illisible() ? "" : String.format(Locale.ROOT, "%.2f", Math.min(sur, eleve.total() / eleve.sur * sur));
        String ancienne = ligne.get(note);
        String dit = valeur(ligne, commentaire);
        boolean aNous = ancienne.isBlank() || NOTRE.matcher(dit).results().anyMatch(r -> reel(ancienne) == reel(r.group(1)));
        if (aNous && !eleve.illisible()) {
            ligne.set(note, neuve);
        } else if (!ancienne.isBlank()) {
            eleve.aRegarder.add((aNous ? "note d'un rendu d'avant, laissée dans la feuille : " + ancienne
                    : "note de la feuille gardée, que nous n'avons pas écrite : " + ancienne)
                    + (eleve.illisible() ? "" : " ; la nôtre serait " + neuve));
        }
        if (commentaire >= 0 && commentaire < ligne.size() && !(aNous && eleve.illisible())) {
            // le texte de l'enseignant est gardé ; celui de la correction est remplacé avec la note
            String reste = NOTRE.matcher(dit).replaceAll("").trim();
            ligne.set(commentaire, !aNous ? reste : (reste.isEmpty() ? "" : reste + " ") + DEBUT + neuve + ", étape atteinte, « "
                    + eleve.atteinte + " »" + FIN);
        }
    }

    /** @return NaN si le texte n'est pas un nombre */
    private static double reel(String texte) {
        String propre = texte.trim().replace(',', '.');
        return propre.matches("\\d{1,9}(\\.\\d+)?") ? Double.parseDouble(propre) : Double.NaN;
    }

    /** Écrit {@code retours.zip} : chaque page est dans le dossier que Moodle lit ({@code mod/assign/feedback/file/importziplib.php}). */
    public static void ecrireRetours(Path dossier, List<Eleve> eleves) throws IOException {
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(dossier.resolve("retours.zip")))) {
            for (Eleve eleve : eleves) {
                if (eleve.resultat.id.matches("\\d+")) {
                    String nom = eleve.resultat.nom.replaceAll("[_/\\\\\\p{Cntrl}]", " ").replaceFirst("^[.~]+", "");
                    zip.putNextEntry(new ZipEntry(nom + "_" + eleve.resultat.id + "_assignsubmission_file/correction.html"));
                    zip.write(Files.readAllBytes(dossier.resolve("etudiants").resolve(eleve.page)));
                    zip.closeEntry();
                }
            }
        }
    }
}
