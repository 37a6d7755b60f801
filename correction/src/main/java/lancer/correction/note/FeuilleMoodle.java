package lancer.correction.note;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.charset.Charset;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.LocalDateTime;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import lancer.correction.Panne;
import lancer.correction.depot.Source;
import lancer.correction.enfant.Texte;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
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
    private static final Pattern NOTRE = Pattern.compile("\\s*" + DEBUT + "(\\d+[.,]\\d\\d), étape atteinte, « [^\n»]* »"
            + Pattern.quote(FIN));
    /** Le statut de qui a remis son travail, que tous ont. */
    private static final String REMIS = "^(Remis pour évaluation|Submitted for grading)[ -]*";
    /** Les espaces, insécables comprises. */
    private static final Pattern BLANCS = Pattern.compile("[\\s\u00A0\u202F]");
    private static final String BOM = "\uFEFF";

    /** Les codages des tableurs, quand ce n'est pas l'UTF-8 : ceux de Windows, de macOS et de MS-DOS. */
    private static final List<String> CODAGES = List.of("windows-1252", "x-MacRoman", "IBM850");
    /** Des titres qui disent le codage : ils ont des accents. */
    private static final Pattern ACCENTUES = Pattern.compile("Dernière modification|La note peut être modifiée");
    /** Ce que deviennent, lues par le codage de Windows, les lettres accentuées d'un autre. */
    private static final Pattern ETRANGERS = Pattern.compile("[‚ƒ„†‡ˆ‰Š‹Ž•˜™š›žŸ\uFFFD]");

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
    private final int statut;
    private final int nom;

    /** @throws Panne si Moodle n'accepterait pas cette feuille de notes, ou si la note maximale ne s'y lit pas */
    public FeuilleMoodle(Path fichier) {
        this.fichier = fichier;
        try {
            byte[] octets = Files.readAllBytes(fichier);
            codage = codage(octets);
            texte = new String(octets, codage);
            String titres = texte.split("[\r\n]", 2)[0];
            char separateur = Stream.of(';', '\t').filter(c -> titres.indexOf(c) >= 0).findFirst().orElse(',');
            format = CSVFormat.DEFAULT.builder().setDelimiter(separateur)
                    .setRecordSeparator(Stream.of("\r\n", "\n", "\r").filter(texte::contains).findFirst().orElse("\n"))
                    .setQuoteMode(QuoteMode.MINIMAL).get();
            lignes = CSVParser.parse(texte.replaceFirst("^" + BOM, ""), format).stream()
                    .map(ligne -> new ArrayList<>(ligne.toList())).collect(Collectors.toList());
        } catch (Panne e) {
            throw e;
        } catch (IOException | RuntimeException e) {
            throw new Panne(2, "feuille de notes illisible : " + fichier + " (" + e.getMessage() + ")");
        }
        identifiant = colonne(true, "Identifier", "Identifiant");
        note = colonne(true, "Grade", "Note");
        colonne(true, "Last modified (grade)", "Dernière modification (note)");
        maximum = colonne(true, "Maximum grade", "Note maximale");
        commentaire = colonne(false, "Feedback comments", "Feedback par commentaires");
        modifiable = colonne(false, "Grade can be changed", "La note peut être modifiée");
        statut = colonne(false, "Status", "Statut");
        nom = colonne(false, "Full name", "Nom complet");
        sur = maximum();
    }

    /** Le codage d'une feuille : des titres accentués le disent. @throws Panne s'il ne se sait pas */
    private Charset codage(byte[] octets) {
        Charset lu = Source.codage(octets);
        if (!CODAGES.contains(lu.name())) {
            return lu;
        }
        Charset dit = CODAGES.stream().filter(Charset::isSupported).map(Charset::forName)
                .filter(c -> ACCENTUES.matcher(new String(octets, c)).find()).findFirst().orElse(lu);
        String texte = new String(octets, dit);
        if (dit == lu && ETRANGERS.matcher(texte).find() || !Arrays.equals(octets, texte.getBytes(dit))) {
            throw new Panne(2, fichier + " : le codage de cette feuille ne se sait pas ; attendu : enregistrée en « CSV UTF-8 »");
        }
        return dit;
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
     * Écrit {@code notes-a-deposer.csv}. Une note que la correction n'a pas écrite est gardée ; l'enseignant doit alors examiner ce rendu.
     * Un fichier que quelqu'un a changé depuis est mis de côté, sous un autre nom.
     *
     * @param avis reçoit ce nom
     * @return les rendus jugés dont la note n'est pas dans la feuille : ils n'y sont pas, ou leur note est verrouillée
     */
    public Collection<Eleve> ecrire(Path dossier, List<Eleve> eleves, List<String> avis, Sorties sorties)
            throws IOException {
        Map<String, Eleve> parId = new LinkedHashMap<>();
        eleves.forEach(e -> parId.put(e.resultat.id, e));
        Set<String> vus = new HashSet<>();
        Set<Eleve> notes = new HashSet<>();
        List<String> sansRendu = new ArrayList<>();
        for (List<String> ligne : lignes.subList(1, lignes.size())) {
            Eleve eleve = parId.get(numero(ligne));
            if (eleve != null) {
                eleve.statut = Texte.protege(valeur(ligne, statut).replaceFirst(REMIS, "").replaceFirst("[ -]+$", ""));
            } else if (!numero(ligne).isEmpty()) {
                sansRendu.add(Texte.protege(valeur(ligne, nom).isBlank() ? numero(ligne) : valeur(ligne, nom)));
            }
            if (eleve != null && !vus.add(eleve.resultat.id)) {
                avis.add("deux fois dans la feuille, dont la seconde est laissée : " + eleve.resultat.qui());
            } else if (eleve != null && ligne.size() > note && !valeur(ligne, modifiable).trim().matches("(?i)no|non")) {
                remplir(ligne, eleve);
                notes.add(eleve);
            } else if (eleve != null && reel(valeur(ligne, note)) <= sur) {
                eleve.note = reel(valeur(ligne, note));
            }
        }
        if (!sansRendu.isEmpty()) {
            avis.add("dans la feuille, et sans rendu ici (" + sansRendu.size() + ") : " + String.join(", ", sansRendu));
        }
        StringWriter ecrit = new StringWriter();
        ecrit.append(texte.startsWith(BOM) ? BOM : "");
        format.print(ecrit).printRecords(lignes);
        deposer(dossier, ecrit.toString().getBytes(codage), avis, sorties);
        return eleves.stream().filter(e -> !notes.contains(e) && !e.illisible()).collect(Collectors.toList());
    }

    /** Écrit le fichier à déposer, et ce qui dira s'il a été changé. */
    private static void deposer(Path dossier, byte[] octets, List<String> avis, Sorties sorties) throws IOException {
        Path deposee = dossier.resolve(DEPOSEE);
        Path copie = dossier.resolve("." + DEPOSEE);
        if (Files.exists(deposee) && !(Files.exists(copie) && Arrays.equals(Files.readAllBytes(deposee), Files.readAllBytes(copie)))) {
            Path cote = dossier.resolve(DEPOSEE.replace(".csv", " changée avant le " + LocalDateTime.now()
                    .format(DateTimeFormatter.ofPattern("yyyy-MM-dd HH'h'mm'm'ss")) + ".csv"));
            try {
                Files.move(deposee, cote, StandardCopyOption.REPLACE_EXISTING);
            } catch (FileSystemException e) {
                sorties.ecrireACote(deposee, octets);
                return;
            }
            avis.add(DEPOSEE + " a été changé : il est gardé sous le nom « " + cote.getFileName() + " » ; une note se tape dans la feuille "
                    + "de Moodle, ou dans ajustements.csv");
        }
        Files.write(copie, octets);
        sorties.ecrire(deposee, octets);
    }

    /** Dit si cette note est vide, ou si notre commentaire la répète. */
    private static boolean estNotre(String note, String commentaire) {
        return note.isBlank() || NOTRE.matcher(commentaire).results().anyMatch(r -> reel(note) == reel(r.group(1)));
    }

    /** Remplit les deux cases de la ligne de cet élève, et lui dit ce qu'il faut examiner. */
    private void remplir(List<String> ligne, Eleve eleve) {
        boolean juge = !eleve.illisible();
        String neuve = juge ? String.format(Locale.FRANCE, "%.2f", eleve.calculee) : "";
        String ancienne = ligne.get(note);
        String dit = valeur(ligne, commentaire);
        boolean aNous = estNotre(ancienne, dit);
        if (aNous && juge) {
            // le signe décimal est celui de la note maximale
            ligne.set(note, valeur(ligne, maximum).contains(",") ? neuve : neuve.replace(',', '.'));
        } else if (!ancienne.isBlank()) {
            String aQui = aNous ? "note d'un rendu d'avant, laissée dans la feuille : "
                    : "note de la feuille gardée, que nous n'avons pas écrite : ";
            boolean possible = reel(ancienne) <= sur;
            String gardee = aQui + ancienne.replace('.', ',') + (possible ? "" : ", que Moodle ignorera");
            eleve.aRegarder.add(juge ? gardee + " ; la nôtre serait " + neuve : gardee);
            eleve.note = juge && possible ? reel(ancienne) : eleve.note;
        }
        if (commentaire >= 0 && commentaire < ligne.size() && (juge || !aNous)) {
            // le texte de l'enseignant est gardé ; celui de la correction est remplacé avec la note
            String reste = NOTRE.matcher(dit).replaceAll("").trim();
            String notre = juge && aNous ? DEBUT + neuve + ", étape atteinte, « " + eleve.atteinte + " »" + FIN : "";
            ligne.set(commentaire, (reste + " " + notre).trim());
        }
    }

    /** @return NaN si le texte n'est pas un nombre */
    private static double reel(String texte) {
        String propre = BLANCS.matcher(texte).replaceAll("").replace(',', '.');
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
