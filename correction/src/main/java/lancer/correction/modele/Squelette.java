package lancer.correction.modele;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import lancer.correction.Panne;

/**
 * Écrit un projet que les étudiants reçoivent, à compléter ou achevé : les classes, les scènes, {@code Tests}, de quoi
 * construire.
 */
public final class Squelette {

    /** Ce qui accompagne les classes, et les mêmes fichiers dans le projet. */
    private static final List<String> PROJET = List.of("pom.xml", "Makefile", "src/test/java/lancer/Etapes.java",
            "src/test/resources/META-INF/services/org.junit.platform.launcher.TestExecutionListener");

    private Squelette() {
    }

    /** @throws Panne si le dossier n'est pas vide, ou ne peut être écrit */
    public static void ecrire(String dossier, PrintStream sortie) {
        Path racine = ecrire(dossier, Modele.classes(), Modele::squelette,
                Map.of("LISEZMOI.md", Modele.ressource("projet/LISEZMOI.md")));
        sortie.println("Le projet à compléter est dans " + racine);
    }

    /**
     * Écrit le projet achevé.
     *
     * @param variante l'extension dont c'est la copie, vide pour le projet de base
     * @throws Panne si le dossier n'est pas vide, ou ne peut être écrit, ou si le cours n'a pas cette extension
     */
    public static void ecrireCorrige(String dossier, String variante, PrintStream sortie) {
        List<String> classes = new ArrayList<>(Modele.classes());
        if (!variante.isEmpty()) {
            if (!Modele.VARIANTES.containsKey(variante)) {
                throw new Panne(2, "extension inconnue : « " + variante + " » ; attendu : "
                        + String.join(", ", new TreeSet<>(Modele.VARIANTES.keySet())));
            }
            classes.addAll(Modele.VARIANTES.get(variante));
        }
        Map<String, String> fichiers = new TreeMap<>();
        fichiers.put("LISEZMOI.md", Modele.ressource("projet/CORRIGE.md"));
        if (variante.equals("blinn")) {
            // hors du miroir, les reflets de Blinn ne sont pas ceux de Phong, que Tests demande
            fichiers.put(".mvn/maven.config", "-DexcludedGroups=phong\n");
        }
        Path racine = ecrire(dossier, classes, classe -> Modele.corrige(classe, variante), fichiers);
        sortie.println("Le corrigé" + (variante.isEmpty() ? "" : ", extension " + variante + ",") + " est dans " + racine);
    }

    private static Path ecrire(String dossier, List<String> classes, UnaryOperator<String> texte, Map<String, String> fichiers) {
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
            for (String classe : classes) {
                ecrire(racine.resolve("src/main/java/lancer/" + classe + ".java"), texte.apply(classe));
            }
            ecrire(racine.resolve("src/test/java/lancer/Tests.java"), Modele.tests());
            for (String scene : Modele.SCENES) {
                ecrire(racine.resolve("scenes/" + scene + ".ini"), Modele.scene(scene));
            }
            for (String fichier : PROJET) {
                ecrire(racine.resolve(fichier), Modele.ressource("projet/" + fichier));
            }
            for (Map.Entry<String, String> fichier : fichiers.entrySet()) {
                ecrire(racine.resolve(fichier.getKey()), fichier.getValue());
            }
        } catch (IOException e) {
            throw new Panne(1, "écriture impossible : " + e);
        }
        return racine;
    }

    private static void ecrire(Path fichier, String texte) throws IOException {
        Files.createDirectories(fichier.getParent());
        Files.writeString(fichier, texte);
    }
}
