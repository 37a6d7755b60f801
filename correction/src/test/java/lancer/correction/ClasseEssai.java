package lancer.correction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.Reader;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import lancer.correction.jugement.JuryPartage;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVRecord;

/** De quoi noter des rendus d'essai, et relire ce que le programme en écrit. */
public abstract class ClasseEssai {

    public static final Path RENDUS = Path.of("src", "test", "resources");

    /** Ce que le programme a dit. */
    static final class Essai {

        int code;
        String sortie;
        String erreur;

        /** Il a refusé, en une seule ligne où sont ces mots. */
        void exigerRefus(String... mots) {
            assertEquals(2, code, erreur);
            assertEquals(1, erreur.trim().split("\n").length, erreur);
            contient(erreur, mots);
        }
    }

    static Essai executer(Object... arguments) {
        Essai essai = new Essai();
        ByteArrayOutputStream sortie = new ByteArrayOutputStream();
        ByteArrayOutputStream erreur = new ByteArrayOutputStream();
        essai.code = Correction.executer(Stream.of(arguments).map(String::valueOf).toArray(String[]::new),
                new PrintStream(sortie, true, StandardCharsets.UTF_8), new PrintStream(erreur, true, StandardCharsets.UTF_8),
                (confinement, graine) -> JuryPartage.de(confinement));
        essai.sortie = sortie.toString(StandardCharsets.UTF_8);
        essai.erreur = erreur.toString(StandardCharsets.UTF_8);
        return essai;
    }

    /** Note de nouveau, avec ces options, ce qui a été jugé dans ce dossier. */
    static Essai renoter(Path dossier, Object... options) {
        return executer(Stream.concat(Stream.of("--noter", "--sortie", dossier), Stream.of(options)).toArray());
    }

    static String index(Path dossier) throws IOException {
        return Files.readString(dossier.resolve("index.html"));
    }

    /** Les lignes de classe.csv, par identifiant. */
    static Map<String, Map<String, String>> noter(Path rendus, Path dossier, Object... options) throws IOException {
        List<Object> arguments = new ArrayList<>(List.of("--sortie", dossier, "--sans-confinement"));
        arguments.addAll(List.of(options));
        arguments.add(rendus);
        Essai essai = executer(arguments.toArray());
        assertEquals(0, essai.code, essai.erreur);
        return classe(dossier);
    }

    static Map<String, Map<String, String>> classe(Path dossier) throws IOException {
        Map<String, Map<String, String>> lignes = new LinkedHashMap<>();
        try (Reader texte = Files.newBufferedReader(dossier.resolve("classe.csv"), StandardCharsets.UTF_8);
                CSVParser csv = CSVParser.parse(texte, CSVFormat.DEFAULT.builder().setHeader().setSkipHeaderRecord(true).get())) {
            for (CSVRecord ligne : csv) {
                lignes.put(ligne.get("identifiant"), ligne.toMap());
            }
        }
        return lignes;
    }

    static String page(Path dossier, String id) throws IOException {
        try (Stream<Path> pages = Files.list(dossier.resolve("etudiants"))) {
            Path page = pages.filter(p -> p.endsWith(id + ".html")).findFirst().get();
            return Files.readString(page);
        }
    }

    public static void copier(Path source, Path destination) throws IOException {
        try (Stream<Path> flux = Files.walk(source)) {
            for (Path fichier : flux.collect(Collectors.toList())) {
                Path copie = destination.resolve(source.relativize(fichier).toString());
                if (Files.isDirectory(fichier)) {
                    Files.createDirectories(copie);
                } else {
                    Files.createDirectories(copie.getParent());
                    Files.copy(fichier, copie, StandardCopyOption.REPLACE_EXISTING);
                }
            }
        }
    }

    /** Dans cette classe du dossier, le premier texte devient le second. */
    public static void changer(Path sources, String classe, String avant, String apres) throws IOException {
        changer(sources.resolve(classe + ".java"), avant, apres);
    }

    public static void changer(Path fichier, String avant, String apres) throws IOException {
        String texte = Files.readString(fichier);
        assertTrue(texte.contains(avant), fichier + " : " + avant);
        Files.writeString(fichier, texte.replace(avant, apres));
    }

    /** Les blocs d'un fichier de fautes, qu'une ligne vide sépare : le titre de chacun, puis ses autres lignes. */
    public static List<String[]> blocs(String fichier) throws IOException {
        String texte = Files.readString(RENDUS.resolve(fichier)).replaceAll("(?m)^#.*\n", "").trim();
        return Stream.of(texte.split("\n\n")).map(bloc -> (bloc + "\n").split("\n", 2)).collect(Collectors.toList());
    }

    /** L'archive d'un dossier, ses fichiers sous ce préfixe. */
    public static void archiver(Path source, Path archive, String prefixe) throws IOException {
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(archive)); Stream<Path> flux = Files.walk(source)) {
            for (Path fichier : flux.filter(Files::isRegularFile).sorted(Comparator.naturalOrder()).collect(Collectors.toList())) {
                zip.putNextEntry(new ZipEntry(prefixe + source.relativize(fichier).toString().replace('\\', '/')));
                zip.write(Files.readAllBytes(fichier));
                zip.closeEntry();
            }
        }
    }

    static void contient(String texte, String... mots) {
        for (String mot : mots) {
            assertTrue(texte.contains(mot), () -> "« " + mot + " » n'est pas dans : "
                    + texte.replaceAll("data:image[^\"]*|<style>.*?</style>", "…"));
        }
    }

    /** Une archive d'un seul lien : ce que fait « zip --symlinks ». Il suffit d'en changer les droits, dans le répertoire central. */
    public static void ecrireLien(Path archive, String nom, String cible) throws IOException {
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(archive))) {
            zip.putNextEntry(new ZipEntry(nom));
            zip.write(cible.getBytes(StandardCharsets.UTF_8));
        }
        ByteBuffer octets = ByteBuffer.wrap(Files.readAllBytes(archive)).order(ByteOrder.LITTLE_ENDIAN);
        int fiche = 0;
        while (octets.getInt(fiche) != 0x02014b50) {
            fiche++;
        }
        octets.put(fiche + 5, (byte) 3);
        octets.putInt(fiche + 38, 0xA1FF << 16);
        Files.write(archive, octets.array());
    }
}
