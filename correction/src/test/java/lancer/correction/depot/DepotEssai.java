package lancer.correction.depot;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
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

    @BeforeEach
    void preparer() throws IOException {
        rendus = Files.createDirectories(dossier.resolve("rendus"));
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
