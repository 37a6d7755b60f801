package lancer.correction.jugement;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.correction.isolement.Arret;
import lancer.correction.modele.Modele;

/**
 * Le dossier d'un rendu, et les assemblages de classes qu'on y compile : tout ensemble, ou une classe seule dans le
 * corrigé.
 */
final class Chantier {

    private final Path dossier;
    private final Machines.Compilation compilation;

    Chantier(Path dossier, Machines.Compilation compilation) {
        this.dossier = dossier;
        this.compilation = compilation;
    }

    Path getDossier() {
        return dossier;
    }

    /** Un assemblage compilé. */
    static final class Assemblage {

        final String classes;
        final List<Faute> fautes;

        Assemblage(String classes, List<Faute> fautes) {
            this.classes = classes;
            this.fautes = fautes;
        }

        List<Faute> fautesDe(String classe) {
            return fautes.stream().filter(f -> f.classe().equals(classe)).collect(Collectors.toList());
        }
    }

    /** Toutes les classes du corrigé : {@code lancer/Vecteur} et son texte. */
    static Map<String, String> corrige() {
        Map<String, String> sources = new TreeMap<>();
        Modele.classes().forEach(c -> sources.put("lancer/" + c, Modele.corrige(c)));
        return sources;
    }

    static Map<String, String> squelette() {
        Map<String, String> sources = new TreeMap<>();
        Modele.classes().forEach(c -> sources.put("lancer/" + c, Modele.squelette(c)));
        return sources;
    }

    /** Compile ces sources, avec nos vérifications et nos sondes. */
    Assemblage assembler(String nom, Map<String, String> sources) throws Arret {
        Path ici = dossier.resolve(nom);
        try {
            Path lancer = Files.createDirectories(ici.resolve("src/lancer"));
            for (Map.Entry<String, String> source : sources.entrySet()) {
                Path fichier = ici.resolve("src").resolve(source.getKey() + ".java");
                Files.createDirectories(fichier.getParent());
                ecrire(fichier, source.getValue());
            }
            ecrire(lancer.resolve("Tests.java"), Modele.tests());
            for (String sonde : Modele.SONDES) {
                ecrire(lancer.resolve(sonde + ".java"), Modele.sonde(sonde));
            }
            Path scenes = Files.createDirectories(dossier.resolve("scenes"));
            for (String scene : List.of("scene1", "ombres")) {
                ecrire(scenes.resolve(scene + ".ini"), Modele.scene(scene));
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        Path classes = ici.resolve("classes");
        return new Assemblage(classes.toString(), compilation.compiler(ici.resolve("src"), classes));
    }

    private static void ecrire(Path fichier, String texte) throws IOException {
        Files.write(fichier, texte.getBytes(StandardCharsets.UTF_8));
    }

    static void effacer(Path dossier) throws IOException {
        if (Files.exists(dossier)) {
            List<Path> contenu;
            try (Stream<Path> flux = Files.walk(dossier)) {
                contenu = flux.sorted(Comparator.reverseOrder()).collect(Collectors.toList());
            }
            for (Path fichier : contenu) {
                Files.delete(fichier);
            }
        }
    }
}
