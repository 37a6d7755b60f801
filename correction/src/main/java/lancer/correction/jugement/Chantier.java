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
    private final String appels;

    /** @param appels la source de {@code lancer.Appels} */
    Chantier(Path dossier, Machines.Compilation compilation, String appels) {
        this.dossier = dossier;
        this.compilation = compilation;
        this.appels = appels;
    }

    /** Un assemblage compilé. */
    static final class Assemblage {

        final Path classes;
        final List<Faute> fautes;

        Assemblage(Path classes, List<Faute> fautes) {
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

    /** Compile les classes d'un rendu, avec ce qui les appelle et les sonde. */
    Assemblage assembler(String nom, Map<String, String> classes) throws Arret {
        Map<String, String> sources = new TreeMap<>(classes);
        sources.put("lancer/" + Modele.APPELS, appels);
        Modele.SONDES.forEach(s -> sources.put("lancer/" + s, Modele.sonde(s)));
        try {
            Files.createDirectories(scenes());
            for (String scene : List.of("scene1", "ombres")) {
                ecrire(scenes().resolve(scene + ".ini"), Modele.scene(scene));
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return compiler(nom, sources);
    }

    /** Compile ces sources, et rien d'autre. */
    Assemblage compiler(String nom, Map<String, String> sources) throws Arret {
        Path ici = dossier.resolve(nom);
        Path classes = ici.resolve("classes");
        try {
            for (Map.Entry<String, String> source : sources.entrySet()) {
                Path fichier = ici.resolve("src").resolve(source.getKey() + ".java");
                Files.createDirectories(fichier.getParent());
                ecrire(fichier, source.getValue());
            }
            Files.createDirectories(classes);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return new Assemblage(classes, compilation.compiler(ici.resolve("src"), classes));
    }

    /** Les scènes que l'on fait dessiner au rendu. */
    Path scenes() {
        return dossier.resolve("scenes");
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
