package lancer.correction.note;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
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
import lancer.correction.depot.Source;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVPrinter;
import org.apache.commons.csv.QuoteMode;

/**
 * La feuille de notes de Moodle, dont seules les cases de la note et du commentaire sont modifiées (moodle,
 * {@code mod/assign/feedback/offline/importgradeslib.php}). Moodle ignore une note vide, mais un commentaire vide efface l'ancien : une
 * case inchangée est donc recopiée. Une note vient de la correction si le commentaire de la correction la répète sur la même ligne. Sinon,
 * elle vient de l'enseignant, et n'est pas modifiée. Une feuille enregistrée par un tableur garde son séparateur et son codage.
 */
public final class FeuilleMoodle {

    private static final String DEPOSEE = "notes-a-deposer.csv";
    private static final Pattern NUMERO = Pattern.compile("\\D*(\\d+)\\s*");
    private static final String DEBUT = "Correction automatique : ";
    private static final String FIN = " ; le détail est dans le fichier de retour.";
    private static final Pattern NOTRE = Pattern.compile("\\s*" + DEBUT + "(\\d+\\.\\d\\d), étape atteinte, « [^\n»]* »"
            + Pattern.quote(FIN));
    /** Ni note, ni commentaire. */
    private static final String[] RIEN = {"", ""};
    private static final String BOM = "\uFEFF";

    private final Path fichier;
    private final Charset codage;
    private final String texte;
    private final CSVFormat format;
    private final List<List<String>> lignes;
    private final int identifiant;
    private final int note;
    private final int maximum;
    /** La note maximale, la même pour toute la classe. */
    public final double sur;
    private final int commentaire;
    private final int modifiable;

    /** @throws Panne si Moodle n'accepterait pas cette feuille de notes, ou si la note maximale ne s'y lit pas */
    public FeuilleMoodle(Path fichier) {
        this.fichier = fichier;
        try {
            byte[] octets = Files.readAllBytes(fichier);
            codage = Source.codage(octets);
            texte = new String(octets, codage);
            String titres = texte.split("[\r\n]", 2)[0];
            format = CSVFormat.DEFAULT.builder().setDelimiter(titres.contains(";") ? ';' : titres.contains("\t") ? '\t' : ',')
                    .setRecordSeparator(texte.contains("\r\n") ? "\r\n" : "\n").setQuoteMode(QuoteMode.MINIMAL).get();
            lignes = CSVParser.parse(texte.replaceFirst("^" + BOM, ""), format).stream()
                    .map(ligne -> new ArrayList<>(ligne.toList())).collect(Collectors.toList());
        } catch (IOException | RuntimeException e) {
            throw new Panne(2, "feuille de notes illisible : " + fichier + " (" + e.getMessage() + ")");
        }
        identifiant = colonne(true, "Identifier", "Identifiant");
        note = colonne(true, "Grade", "Note");
        colonne(true, "Last modified (grade)", "Dernière modification (note)");
        maximum = colonne(true, "Maximum grade", "Note maximale");
        commentaire = colonne(false, "Feedback comments", "Feedback par commentaires");
        modifiable = colonne(false, "Grade can be changed", "La note peut être modifiée");
        sur = maximum();
    }

    /** La place d'une colonne, d'après son titre anglais ou français, en majuscules ou non ; négative si elle manque. */
    private int colonne(boolean exigee, String anglais, String francais) {
        List<String> titres = lignes.isEmpty() ? List.of() : lignes.get(0);
        int k = titres.size() - 1;
        while (k >= 0 && !titres.get(k).trim().equalsIgnoreCase(anglais) && !titres.get(k).trim().equalsIgnoreCase(francais)) {
            k--;
        }
        if (k < 0 && exigee) {
            throw new Panne(2, fichier + " : la colonne « " + francais + " » (« " + anglais + " ») manque ; "
                    + "attendu : la feuille de notes de Moodle, telle qu'il la donne ou enregistrée par un tableur en CSV");
        }
        return k;
    }

    private double maximum() {
        double commune = 0;
        for (List<String> ligne : lignes.subList(1, lignes.size())) {
            double lue = reel(valeur(ligne, maximum));
            if (!numero(ligne).isEmpty() && (!(lue > 0) || commune > 0 && lue != commune)) {
                throw new Panne(2, fichier + " : « " + valeur(ligne, maximum) + " », note maximale de « " + valeur(ligne, identifiant)
                        + " » ; attendu : un nombre, le même pour tous");
            }
            commune = numero(ligne).isEmpty() ? commune : lue;
        }
        if (commune == 0) {
            throw new Panne(2, fichier + " : aucun étudiant ; attendu : un par ligne, après les titres");
        }
        return commune;
    }

    /** Une case, vide si la ligne ne l'a pas. */
    private static String valeur(List<String> ligne, int colonne) {
        return colonne >= 0 && colonne < ligne.size() ? ligne.get(colonne) : "";
    }

    /** Le numéro de l'étudiant, vide s'il n'y en a pas. */
    private String numero(List<String> ligne) {
        Matcher m = NUMERO.matcher(valeur(ligne, identifiant));
        return m.matches() ? m.group(1) : "";
    }

    /**
     * Écrit {@code notes-a-deposer.csv}. Une note que la correction n'a pas écrite est gardée, qu'elle soit dans la feuille ou que
     * l'enseignant l'ait tapée dans le fichier précédent ; il doit alors examiner ce rendu.
     *
     * @param travail dossier qui garde ce que la correction a écrit elle-même : le reste est de l'enseignant
     * @return les rendus jugés dont la note n'est pas dans la feuille : ils n'y sont pas, ou leur note est verrouillée
     */
    public Collection<Eleve> ecrire(Path dossier, Path travail, List<Eleve> eleves) throws IOException {
        Map<String, String[]> deposees = cases(dossier.resolve(DEPOSEE));
        Map<String, String[]> ecrites = cases(travail.resolve(DEPOSEE));
        Map<String, Eleve> parId = new LinkedHashMap<>();
        eleves.forEach(e -> parId.put(e.resultat.id, e));
        List<List<String>> sansRienDeTape = lignes.stream().map(ArrayList::new).collect(Collectors.toList());
        for (int k = 1; k < lignes.size(); k++) {
            List<String> ligne = lignes.get(k);
            if (ligne.size() > note && !valeur(ligne, modifiable).trim().matches("(?i)no|non")) {
                Eleve eleve = parId.remove(numero(ligne));
                String[] la = deposees.getOrDefault(numero(ligne), RIEN);
                String[] ecrite = ecrites.getOrDefault(numero(ligne), RIEN);
                boolean sienne = !la[0].equals(ecrite[0]) && reel(la[0]) != reel(ecrite[0]) && !estNotre(la[0], la[1]);
                String mots = reste(la[1]).equals(reste(ecrite[1])) ? "" : reste(la[1]);
                remplir(sansRienDeTape.get(k), eleve, "", "");
                List<String> regarder = remplir(ligne, eleve, sienne ? la[0] : "", mots);
                if (eleve != null) {
                    eleve.aRegarder.addAll(regarder);
                }
            }
        }
        enregistrer(travail, sansRienDeTape);
        enregistrer(dossier, lignes);
        parId.values().removeIf(Eleve::illisible);
        return parId.values();
    }

    /** La note et le commentaire de chaque étudiant d'une feuille, si elle existe. */
    private static Map<String, String[]> cases(Path fichier) {
        Map<String, String[]> cases = new HashMap<>();
        if (Files.exists(fichier)) {
            FeuilleMoodle feuille = new FeuilleMoodle(fichier);
            feuille.lignes.forEach(ligne -> cases.put(feuille.numero(ligne), new String[] {valeur(ligne, feuille.note).trim(),
                    valeur(ligne, feuille.commentaire)}));
        }
        return cases;
    }

    private void enregistrer(Path dossier, List<List<String>> tableau) throws IOException {
        StringWriter ecrit = new StringWriter();
        ecrit.append(texte.startsWith(BOM) ? BOM : "");
        try (CSVPrinter csv = new CSVPrinter(ecrit, format)) {
            csv.printRecords(tableau);
        }
        Files.write(dossier.resolve(DEPOSEE), ecrit.toString().getBytes(codage));
    }

    /** Dit si cette note est vide, ou si notre commentaire la répète. */
    private static boolean estNotre(String note, String commentaire) {
        return note.isBlank() || NOTRE.matcher(commentaire).results().anyMatch(r -> reel(note) == reel(r.group(1)));
    }

    /** Ce qu'un commentaire a de plus que le nôtre. */
    private static String reste(String commentaire) {
        return NOTRE.matcher(commentaire).replaceAll("").trim();
    }

    /**
     * Remplit les deux cases d'une ligne.
     *
     * @param eleve celui de cette ligne, {@code null} s'il n'a rien rendu
     * @param tapee note que l'enseignant a tapée dans le fichier précédent ; vide s'il n'y en a pas
     * @param mots commentaire qu'il y a tapé, de même
     * @return ce qu'il doit examiner
     */
    private List<String> remplir(List<String> ligne, Eleve eleve, String tapee, String mots) {
        List<String> regarder = new ArrayList<>();
        if (eleve == null && tapee.isEmpty() && mots.isEmpty()) {
            return regarder;
        }
        boolean juge = eleve != null && !eleve.illisible();
        String neuve = juge ? String.format(Locale.ROOT, "%.2f", eleve.note) : "";
        String ancienne = tapee.isEmpty() ? ligne.get(note) : tapee;
        String dit = valeur(ligne, commentaire);
        boolean aNous = tapee.isEmpty() && estNotre(ancienne, dit);
        if (aNous && juge) {
            // le signe décimal est celui de la note maximale
            ligne.set(note, valeur(ligne, maximum).contains(",") ? neuve.replace('.', ',') : neuve);
        } else if (!ancienne.isBlank()) {
            ligne.set(note, ancienne);
            regarder.add((!tapee.isEmpty() ? "note tapée dans " + DEPOSEE + ", gardée : "
                    : aNous ? "note d'un rendu d'avant, laissée dans la feuille : "
                    : "note de la feuille gardée, que nous n'avons pas écrite : ") + ancienne
                    + (reel(ancienne) <= sur ? "" : ", que Moodle ignorera")
                    + (juge ? " ; la nôtre serait " + neuve : ""));
        }
        if (commentaire >= 0 && commentaire < ligne.size() && (juge || !aNous || !mots.isEmpty())) {
            // le texte de l'enseignant est gardé ; celui de la correction est remplacé avec la note
            String reste = mots.isEmpty() ? reste(dit) : mots;
            ligne.set(commentaire, !juge || !aNous ? reste : (reste.isEmpty() ? "" : reste + " ") + DEBUT + neuve + ", étape atteinte, « "
                    + eleve.atteinte + " »" + FIN);
        }
        return regarder;
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
