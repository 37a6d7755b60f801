package lancer.correction.modele;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lancer.correction.Panne;

/**
 * Les classes du cours à compléter, et les mêmes classes complétées d'après le seul énoncé. Un même texte contient les deux. De
 * {@code //&#123;} à {@code //=}, il contient la réponse ; de là à {@code //&#125;}, le texte du squelette. De {@code //&lt;brume} à
 * {@code //&gt;}, la copie de l'extension remplace les lignes ordinaires par celles qui commencent par {@code //+}.
 */
public final class SourcesDuCours {

    /** Les classes à compléter, dans l'ordre de l'énoncé. */
    public static final List<String> A_COMPLETER =
            List.of("Vecteur", "Point", "Rayon", "Camera", "Sphere", "Scene", "Lancer", "Objet3D");

    /** Les classes données achevées. */
    public static final List<String> DONNEES =
            List.of("Tuple", "Couleur", "Lampe", "PointContact", "Constantes", "LecteurScene", "Toile", "Main");

    /** Les extensions, dans l'ordre du cours. */
    public static final List<String> VARIANTES = List.of("brume", "antialias", "blinn");

    /** Ce qui vérifie un projet : les vérifications, ce qu'elles demandent, leurs valeurs, les causes, les réponses qui changent. */
    public static final List<String> VERIFICATIONS =
            List.of("lancer/Tests", "lancer/Demande", "lancer/Valeurs", "lancer/Causes", "lancer/Repetition");

    private static final List<String> SCENES = List.of("scene1", "diffus", "ombres", "miroirs", "bowling", "brume",
            "tournesol");

    /** Rayon d'une sphère trop grande pour être déplacée : un sol, un miroir presque plat. */
    private static final double IMMENSE = 100;

    private static final Pattern RAYON = Pattern.compile("(?m)^rayon=(\\S+)");
    private static final Pattern TRIPLET = Pattern.compile("(?m)^(centre|position|Kd|Ks|couleur)=(\\S+) (\\S+) (\\S+)$");

    /** Fichiers du projet qui ne sont pas des classes du cours. */
    private static final List<String> PROJET = List.of("pom.xml", "Makefile", "src/test/java/lancer/Etapes.java",
            "src/test/java/lancer/ImageAttendue.java",
            "src/test/resources/META-INF/services/org.junit.platform.launcher.TestExecutionListener");

    /** Les étapes qui ont une image, et les scènes que ces images montrent. */
    public static final List<String> ETAPES_DESSINEES = List.of("scene", "lambert", "phong", "ombres", "reflets");
    private static final List<String> SCENES_DESSINEES = List.of("diffus", "scene1");
    public static final String ATTENDUES = "src/test/resources/attendues/";

    private SourcesDuCours() {
    }

    /** Toutes les classes du projet, sans ses tests. */
    public static List<String> classes() {
        return Stream.concat(A_COMPLETER.stream(), DONNEES.stream()).collect(Collectors.toList());
    }

    /** La classe à compléter, avec des {@code FIXME} à la place des réponses. */
    public static String squelette(String classe) {
        return source(classe, "", false);
    }

    public static String corrige(String classe) {
        return corrige(classe, "");
    }

    /** La classe complétée, dans le projet d'une extension : {@code brume}, {@code antialias}, {@code blinn}. */
    public static String corrige(String classe, String variante) {
        return source(classe, variante, true);
    }

    /** Le texte d'une classe, pour la base ou pour cette extension. */
    private static String source(String classe, String variante, boolean reponses) {
        StringBuilder resultat = new StringBuilder();
        // null pour toutes les copies ; sinon, l'extension dont les lignes sont lues
        String pour = null;
        boolean dansReponse = false;
        for (String ligne : ressource("modele/lancer/" + classe + ".java").split("\n")) {
            String nue = ligne.trim();
            String marge = ligne.substring(0, ligne.indexOf(nue));
            if (nue.startsWith("//<") || nue.equals("//>")) {
                pour = nue.equals("//>") ? null : nue.substring(3);
            } else if (pour != null && pour.equals(variante) != nue.startsWith("//+")) {
                continue;
            } else if (nue.startsWith("//{")) {
                dansReponse = true;
                resultat.append(reponses || nue.length() == 3 ? "" : marge + "// FIXME" + nue.substring(3) + "\n");
            } else if (nue.startsWith("//=") || nue.equals("//}")) {
                dansReponse = false;
                resultat.append(reponses || nue.equals("//}") ? "" : marge + nue.substring(4) + "\n");
            } else if (!dansReponse || reponses) {
                resultat.append((pour == null ? ligne : ligne.replaceFirst("//\\+ ?", "")).stripTrailing()).append('\n');
            }
        }
        return resultat.toString();
    }

    /** Toutes les classes du projet, par nom complet ({@code lancer/Vecteur}), avec leur texte. */
    public static Map<String, String> tout(UnaryOperator<String> texte) {
        return classes().stream().collect(Collectors.toMap(c -> "lancer/" + c, texte));
    }

    /** Toutes les classes complétées de cette extension, ou de la base si ce nom est vide. */
    public static Map<String, String> acheve(String variante) {
        Map<String, String> classes = tout(c -> corrige(c, variante));
        if (variante.equals("brume")) {
            classes.put("lancer/Brume", corrige("Brume"));
        }
        return classes;
    }

    public static String scene(String nom) {
        return ressource("scenes/" + nom + ".ini");
    }

    /** Cette scène, dont les positions et les couleurs varient un peu selon la graine. */
    public static String scene(String nom, long graine) {
        SplittableRandom hasard = new SplittableRandom(graine);
        StringBuilder texte = new StringBuilder();
        for (String section : scene(nom).split("(?m)^(?=\\[)")) {
            Matcher rayon = RAYON.matcher(section);
            double r = rayon.find() ? Double.parseDouble(rayon.group(1)) : IMMENSE;
            texte.append(TRIPLET.matcher(section).replaceAll(triplet -> tirer(hasard, triplet, r < IMMENSE ? r / 8 : 0)));
        }
        return texte.toString();
    }

    /** @param ecart le plus grand déplacement d'un centre ; celui d'une lampe est un vingtième de sa distance */
    private static String tirer(SplittableRandom hasard, MatchResult triplet, double ecart) {
        double[] t = IntStream.rangeClosed(2, 4).mapToDouble(k -> Double.parseDouble(triplet.group(k))).toArray();
        String cle = triplet.group(1);
        double pas = cle.equals("position") ? Math.sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]) / 20 : ecart;
        return cle + "=" + Arrays.stream(t).map(x -> cle.matches("centre|position") ? x + pas * hasard.nextDouble(-1, 1)
                : x * hasard.nextDouble(0.75, 1)).mapToObj(x -> String.format(Locale.ROOT, "%.4f", x)).collect(Collectors.joining(" "));
    }

    /** Un texte de l'archive du programme. */
    public static String ressource(String nom) {
        try (InputStream flux = SourcesDuCours.class.getResourceAsStream("/" + nom)) {
            return new String(flux.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Écrit un projet d'étudiant : les classes, les scènes, {@code Tests}, les fichiers de construction.
     *
     * @param variante {@code null} pour le projet à compléter ; vide pour le projet complété, ou nom d'une extension
     * @throws Panne si le dossier n'est pas vide ou ne peut être écrit, ou si l'extension n'existe pas
     */
    public static void ecrire(String dossier, String variante, PrintStream sortie) {
        if (variante != null && !variante.isEmpty() && !VARIANTES.contains(variante)) {
            throw new Panne(2, "extension inconnue : « " + variante + " » ; attendu : "
                    + String.join(", ", new TreeSet<>(VARIANTES)));
        }
        Map<String, String> fichiers = new TreeMap<>();
        (variante == null ? tout(SourcesDuCours::squelette) : acheve(variante))
                .forEach((nom, texte) -> fichiers.put("src/main/java/" + nom + ".java", texte));
        fichiers.put("LISEZMOI.md", ressource("projet/" + (variante == null ? "LISEZMOI.md" : "CORRIGE.md")));
        if ("blinn".equals(variante)) {
            // Tests demande les reflets de Phong, et ceux de Blinn ne leur sont égaux que dans la direction réfléchie
            fichiers.put(".mvn/maven.config", "-DexcludedGroups=phong\n");
        }
        VERIFICATIONS.forEach(nom -> fichiers.put("src/test/java/" + nom + ".java", ressource("modele/" + nom + ".java")));
        SCENES.forEach(scene -> fichiers.put("scenes/" + scene + ".ini", scene(scene)));
        PROJET.forEach(fichier -> fichiers.put(fichier, ressource("projet/" + fichier)));
        boolean extension = VARIANTES.contains(String.valueOf(variante));
        SCENES_DESSINEES.stream().filter(s -> !extension).forEach(s -> fichiers.put(ATTENDUES + s + ".ini", scene(s)));
        Path racine = Path.of(dossier);
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
            for (String etape : extension ? List.<String>of() : ETAPES_DESSINEES) {
                String image = ATTENDUES + etape + ".png";
                try (InputStream png = SourcesDuCours.class.getResourceAsStream("/projet/" + image)) {
                    Files.copy(png, racine.resolve(image));
                }
            }
        } catch (IOException e) {
            throw new Panne(1, "écriture impossible : " + e);
        }
        String corrige = "".equals(variante) ? "Le corrigé" : "Le corrigé, extension " + variante + ",";
        sortie.println((variante == null ? "Le projet à compléter" : corrige) + " est dans " + racine);
    }
}
