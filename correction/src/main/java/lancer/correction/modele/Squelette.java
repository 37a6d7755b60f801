package lancer.correction.modele;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import java.util.stream.Stream;
import lancer.correction.Panne;

/**
 * Écrit le projet que les étudiants reçoivent : les classes à compléter, les scènes, {@code Tests}, de quoi construire.
 */
public final class Squelette {

    private Squelette() {
    }

    /** @throws Panne si le dossier n'est pas vide, ou ne peut être écrit */
    public static void ecrire(String dossier, PrintStream sortie) {
        Path racine = Paths.get(dossier);
        try {
            if (Files.exists(racine)) {
                try (Stream<Path> contenu = Files.list(racine)) {
                    if (contenu.findAny().isPresent()) {
                        throw new Panne(2, "le dossier n'est pas vide : " + dossier
                                + " ; attendu : un dossier vide, ou qui n'existe pas");
                    }
                }
            }
            Path sources = Files.createDirectories(racine.resolve("src/main/java/lancer"));
            for (String classe : Modele.classes()) {
                Files.writeString(sources.resolve(classe + ".java"), Modele.squelette(classe));
            }
            Files.writeString(Files.createDirectories(racine.resolve("src/test/java/lancer")).resolve("Tests.java"),
                    Modele.tests());
            Path scenes = Files.createDirectories(racine.resolve("scenes"));
            for (String scene : Modele.SCENES) {
                Files.writeString(scenes.resolve(scene + ".ini"), Modele.scene(scene));
            }
            for (String fichier : List.of("pom.xml", "Makefile", "LISEZMOI.md")) {
                Files.writeString(racine.resolve(fichier), Modele.projet(fichier));
            }
        } catch (IOException e) {
            throw new Panne(1, "écriture impossible : " + e);
        }
        sortie.println("Le projet à compléter est dans " + racine);
    }
}
