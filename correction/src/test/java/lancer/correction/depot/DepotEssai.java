package lancer.correction.depot;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import lancer.correction.isolement.Arret;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/** De quoi écrire des rendus, et les lire. */
abstract class DepotEssai {

    static final String CLASSE = "package lancer;\npublic class Vecteur extends Tuple {\n}\n";

    private static Cours cours;

    @TempDir
    Path dossier;
    Path rendus;
    /** Celui d'un étudiant, tel que Moodle le nomme. */
    Path rendu;

    @BeforeEach
    void preparer() throws IOException {
        rendus = Files.createDirectories(dossier.resolve("rendus"));
        rendu = rendus.resolve("Étudiant 1_11_assignsubmission_file");
    }

    Projet projet() {
        return projet(lire(rendus).get("11"));
    }

    /** Le projet de ce rendu, où sont aussi ces classes. */
    Projet rendre(String dossier, String... classesEtTextes) throws IOException {
        ecrire(dossier, classesEtTextes);
        return projet();
    }

    /** Écrit dans ce dossier du rendu des classes : un nom et un texte, et ainsi de suite. */
    void ecrire(String dossier, String... classesEtTextes) throws IOException {
        for (int k = 0; k < classesEtTextes.length; k += 2) {
            ecrire(rendu.resolve(dossier).resolve(classesEtTextes[k] + ".java"), classesEtTextes[k + 1]);
        }
    }

    static byte[] octets(String texte) {
        return texte.getBytes(StandardCharsets.UTF_8);
    }

    static byte[] zip(Map<String, byte[]> entrees) throws IOException {
        ByteArrayOutputStream octets = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(octets)) {
            for (Map.Entry<String, byte[]> entree : entrees.entrySet()) {
                zip.putNextEntry(new ZipEntry(entree.getKey()));
                zip.write(entree.getValue());
            }
        }
        return octets.toByteArray();
    }

    static void ecrire(Path fichier, String texte) throws IOException {
        Files.createDirectories(fichier.getParent());
        Files.writeString(fichier, texte);
    }

    static List<Rendu> classe(Path lieu) {
        return Depot.lire(lieu, false);
    }

    /** Tout ce lieu est un seul rendu. */
    static Rendu un(Path lieu) {
        return Depot.lire(lieu, true).get(0);
    }

    Map<String, Rendu> lire(Path lieu) {
        return classe(lieu).stream().collect(Collectors.toMap(r -> r.id, r -> r));
    }

    /** Lu dans cette machine virtuelle-ci : rien de ces essais n'est hostile au JDK. */
    static Projet projet(Rendu rendu) {
        try {
            cours = cours == null ? new Cours(Lecteur::lire) : cours;
            return Projet.lire(rendu, Lecteur::lire, cours);
        } catch (Arret e) {
            throw new AssertionError(e);
        }
    }

    static void verifier(Rendu rendu, String nom) {
        assertEquals(nom, rendu.nom);
        assertEquals(List.of(), rendu.refus);
        assertEquals("lancer/Vecteur", String.join(" ", projet(rendu).base.keySet()));
    }
}
