package lancer.correction.modele;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import lancer.correction.Panne;

/**
 * Écrit un projet que les étudiants reçoivent, à compléter ou achevé : les classes, les scènes, {@code Tests}, de quoi
 * construire.
 */
public final class Squelette {

    /** Fichiers qui accompagnent les classes, et les mêmes fichiers dans le projet. */
    private static final List<String> PROJET = List.of("pom.xml", "Makefile", "src/test/java/lancer/Etapes.java",
            "src/test/resources/META-INF/services/org.junit.platform.launcher.TestExecutionListener");

    private Squelette() {
    }

    /**
     * Écrit le projet.
     *
     * @param variante {@code null} pour le projet à compléter ; vide pour le projet achevé, ou l'extension dont c'est la copie
     * @throws Panne si le dossier n'est pas vide, ou ne peut être écrit, ou si le cours n'a pas cette extension
     */
    public static void ecrire(String dossier, String variante, PrintStream sortie) {
        if (variante != null && !variante.isEmpty() && !Modele.VARIANTES.contains(variante)) {
            throw new Panne(2, "extension inconnue : « " + variante + " » ; attendu : "
                    + String.join(", ", new TreeSet<>(Modele.VARIANTES)));
        }
        Map<String, String> fichiers = new TreeMap<>();
        (variante == null ? Modele.tout(Modele::squelette) : Modele.acheve(variante))
                .forEach((nom, texte) -> fichiers.put("src/main/java/" + nom + ".java", texte));
        fichiers.put("LISEZMOI.md", Modele.ressource("projet/" + (variante == null ? "LISEZMOI.md" : "CORRIGE.md")));
        if ("blinn".equals(variante)) {
            // hors du miroir, les reflets de Blinn ne sont pas ceux de Phong, que Tests demande
            fichiers.put(".mvn/maven.config", "-DexcludedGroups=phong\n");
        }
        fichiers.put("src/test/java/lancer/Tests.java", Modele.ressource("modele/lancer/Tests.java"));
        Modele.SCENES.forEach(scene -> fichiers.put("scenes/" + scene + ".ini", Modele.scene(scene)));
        PROJET.forEach(fichier -> fichiers.put(fichier, Modele.ressource("projet/" + fichier)));
        Path racine = Paths.get(dossier);
        try {
            String[] contenu = racine.toFile().list();
            if (contenu != null && contenu.length > 0) {
                throw new Panne(2, "le dossier n'est pas vide : " + dossier + " ; attendu : un dossier vide, ou qui n'existe pas");
            }
            for (Map.Entry<String, String> fichier : fichiers.entrySet()) {
                Path chemin = racine.resolve(fichier.getKey());
                Files.createDirectories(chemin.getParent());
                Files.writeString(chemin, fichier.getValue());
            }
        } catch (IOException e) {
            throw new Panne(1, "écriture impossible : " + e);
        }
        sortie.println((variante == null ? "Le projet à compléter" : variante.isEmpty() ? "Le corrigé"
                : "Le corrigé, extension " + variante + ",") + " est dans " + racine);
    }
}
