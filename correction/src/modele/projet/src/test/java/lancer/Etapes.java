package lancer;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.platform.commons.support.HierarchyTraversalMode;
import org.junit.platform.commons.support.ReflectionSupport;
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.engine.TestExecutionResult.Status;
import org.junit.platform.engine.support.descriptor.MethodSource;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;
import org.junit.platform.launcher.TestPlan;

/**
 * Le bilan des vérifications de {@link Tests} : une ligne par étape, dans l'ordre de l'énoncé, puis ce qui manque à la
 * première qui n'est pas achevée. Ce fichier est donné : il n'y a rien à y changer.
 */
public class Etapes implements TestExecutionListener {

    private static final Path SOURCES = Paths.get(System.getProperty("etapes.sources", "src/main/java/lancer"));

    /** Les étapes qui complètent une méthode déjà écrite pour une autre, où aucun FIXME ne les annonce. */
    private static final List<String> DANS_LA_MEME_METHODE = Arrays.asList("phong", "ombres", "reflets");

    /** Un FIXME et ce qui tient lieu de réponse dans le squelette : qui l'a remplacé a commencé. */
    private static final Pattern A_ECRIRE = Pattern.compile(
            "// FIXME.*\\R\\s*(?:super\\(0, 0, 0\\)|(?:return|.* =) (?:[01]|null|new \\w+\\((?:[01], [01], 0)?\\)));");

    /** Un calcul dont rien ne garde le résultat : les opérations du cours ne changent pas ce à quoi on les demande. */
    private static final Pattern PERDU = Pattern.compile(
            "(?m)^\\s*((?:this\\.)?(\\w+)\\.(?:add|sub|mul|div|neg|normalized?)\\(.*\\);)");

    private final Map<TestIdentifier, TestExecutionResult> resultats = new HashMap<>();

    @Override
    public void executionFinished(TestIdentifier qui, TestExecutionResult resultat) {
        resultats.put(qui, resultat);
    }

    @Override
    public void testPlanExecutionFinished(TestPlan fini) {
        StringBuilder bilan = new StringBuilder("\n");
        String detail = "";
        Manque aReprendre = null;
        ImageAttendue image = null;
        String suivante = "Toutes les étapes sont faites : restent les extensions.";
        for (TestIdentifier etape : etapes(fini)) {
            List<TestIdentifier> verifications = enOrdre(fini, etape);
            List<Manque> manques = verifications.stream().filter(v -> !reussie(v)).map(v -> new Manque(v, etape))
                    .collect(Collectors.toList());
            ImageAttendue sienne = ImageAttendue.de(etape.getTags().iterator().next().getName());
            image = aReprendre == null && manques.isEmpty() && sienne != null ? sienne : image;
            bilan.append(etape.getDisplayName()).append(" : ").append(verifications.size() - manques.size()).append('/')
                    .append(verifications.size());
            if (!manques.isEmpty()) {
                Manque premier = manques.stream().filter(m -> !m.nonEvaluable).findFirst().orElse(manques.get(0));
                bilan.append(premier.nonEvaluable ? " ; le reste n'est pas évaluable"
                        : (premier.aCommencer ? " ; à commencer : " : " ; à reprendre d'abord : ") + premier.titre);
                // ce qu'une étape d'après explique n'est pas imputé à celle-ci
                if (aReprendre == null || premier.rang < aReprendre.rang) {
                    aReprendre = premier;
                    detail = Stream.concat(Stream.of(premier), manques.stream()).map(Manque::toString).distinct()
                            .collect(Collectors.joining());
                    suivante = "L'étape suivante : " + etape.getDisplayName() + " ; à " + premier.aFaire;
                    image = premier.rang == 0 && sienne != null ? sienne : image;
                }
            }
            bilan.append('\n');
        }
        if (bilan.length() == 1) {
            return;
        }
        bilan.append(detail).append('\n');
        if (!entier(fini)) {
            suivante = "Seule une partie des vérifications est lancée : toute la classe Tests dit où vous en êtes."
                    + (aReprendre == null ? "" : "\n" + suivante);
        } else if (image != null) {
            bilan.append(image.comparer()).append('\n');
            suivante = aReprendre == null && image.fausse ? "L'étape suivante : l'image, que les vérifications ne voient pas toute" : suivante;
        }
        if (aReprendre != null && ImageAttendue.extension() != null) {
            bilan.append("Cette copie est une extension : ce qu'elle change ne peut plus réussir, et c'est voulu.\n");
        }
        System.out.println(bilan.append(suivante));
    }

    /** Dit si toutes les vérifications de {@link Tests} sont lancées, sauf celles qu'un réglage du projet laisse de côté. */
    private static boolean entier(TestPlan plan) {
        List<String> exclues = Arrays.asList(System.getProperty("excludedGroups", "").split("\\W+"));
        long toutes = Arrays.stream(Tests.class.getDeclaredClasses())
                .filter(etape -> etape.isAnnotationPresent(Tag.class) && !exclues.contains(etape.getAnnotation(Tag.class).value()))
                .mapToLong(etape -> ReflectionSupport.findMethods(etape, m -> m.isAnnotationPresent(Test.class),
                        HierarchyTraversalMode.TOP_DOWN).size()).sum();
        return etapes(plan).stream().mapToLong(etape -> enOrdre(plan, etape).size()).sum() >= toutes;
    }

    private static List<TestIdentifier> etapes(TestPlan plan) {
        return plan.getRoots().stream().flatMap(moteur -> enOrdre(plan, moteur).stream())
                .flatMap(classe -> enOrdre(plan, classe).stream()).filter(TestIdentifier::isContainer)
                .collect(Collectors.toList());
    }

    private static List<TestIdentifier> enOrdre(TestPlan plan, TestIdentifier parent) {
        return new ArrayList<>(plan.getChildren(parent));
    }

    private boolean reussie(TestIdentifier qui) {
        return resultats.containsKey(qui) && resultats.get(qui).getStatus() == Status.SUCCESSFUL;
    }

    /** Une vérification qui n'a pas réussi : ce qu'elle dit, la ligne qui le demande, et celle où le reprendre. */
    private final class Manque {

        private final String titre;
        private final String dit;
        private final String question;
        private final String aFaire;
        private final boolean nonEvaluable;
        private final boolean aCommencer;
        /** Ce qui se reprend d'abord : ce qui échoue, puis ce qui n'est pas commencé, puis ce que le reste empêche d'évaluer. */
        private final int rang;

        Manque(TestIdentifier qui, TestIdentifier etape) {
            String intitule = qui.getDisplayName();
            TestExecutionResult resultat = resultats.getOrDefault(qui, resultats.get(etape));
            Throwable faute = resultat.getThrowable().get();
            String methode = ((MethodSource) qui.getSource().get()).getMethodName();
            question = premiere(faute, p -> p.getMethodName().equals(methode))
                    .map(p -> p.getFileName() + ":" + p.getLineNumber()).orElse("Tests.java");
            boolean abandonnee = resultat.getStatus() == Status.ABORTED;
            Throwable cause = faute;
            while (cause.getCause() != null) {
                cause = cause.getCause();
            }
            String classe = (cause instanceof Demande.Garde ? ((Demande.Garde) cause).classe
                    : Causes.demande(((MethodSource) qui.getSource().get()).getJavaMethod()).classe()).getSimpleName();
            Lieu lieu;
            String message;
            if (abandonnee || cause instanceof AssertionError) {
                message = String.valueOf(cause.getMessage()).replaceFirst("^étape non commencée : ", "");
                lieu = Lieu.nomme(classe, intitule + " : " + message);
            } else if (cause instanceof StackOverflowError && premiere(cause, p -> p.getMethodName().equals("getColor")).isPresent()) {
                // en haut de la pile, la dernière méthode appelée, qui n'y est pour rien
                message = "des appels sans fin : la profondeur ne diminue pas, ou rien ne la regarde, dans Objet3D.getColor";
                lieu = Lieu.nomme("Objet3D", "getColor");
            } else {
                boolean sansFin = cause instanceof StackOverflowError;
                message = sansFin ? "des appels sans fin : une méthode s'appelle elle-même, ou par une autre"
                        : cause.toString().replaceFirst("^java\\.lang\\.(Error: )?", "");
                // une exception est née dans une des classes de l'étudiant ; de méthodes qui s'appellent en rond, celle que
                // demande la vérification
                boolean enRond = sansFin
                        && premiere(cause, p -> intitule.matches(".*\\b" + p.getMethodName() + "\\b.*")).isPresent();
                lieu = premiere(cause, Causes::deLEtudiant).filter(p -> !enRond).map(Lieu::new)
                        .orElse(Lieu.nomme(classe, intitule));
            }
            boolean expliquee = cause instanceof Demande.NonEvaluable;
            nonEvaluable = expliquee && !lieu.aEcrire;
            Lieu perdu = nonEvaluable ? null : lieu.perdu();
            boolean memeMethode = etape.getTags().stream().anyMatch(t -> DANS_LA_MEME_METHODE.contains(t.getName()));
            aCommencer = perdu == null && !nonEvaluable
                    && (lieu.aEcrire || memeMethode && cause instanceof Demande.NonCommencee);
            rang = nonEvaluable ? 2 : aCommencer ? 1 : 0;
            titre = aCommencer && abandonnee && !expliquee ? message : intitule;
            dit = perdu == null ? message : "rien ne garde le résultat de « " + perdu.texte.trim() + " » ; " + message;
            aFaire = (aCommencer ? "compléter : " : "reprendre : ") + (perdu == null ? lieu : perdu);
        }

        private Optional<StackTraceElement> premiere(Throwable faute, Predicate<StackTraceElement> voulue) {
            return Arrays.stream(faute.getStackTrace()).filter(voulue).findFirst();
        }

        @Override
        public String toString() {
            return "\n- " + titre + "\n  " + (aCommencer ? "" : dit + "\n  " + question + " ; ") + "à " + aFaire + "\n";
        }
    }

    /** Une ligne d'une classe de l'étudiant. */
    private static final class Lieu {

        private final String classe;
        private final int ligne;
        /** Ce qui y est écrit, et ce qui suit ; vide s'il n'est pas lu. */
        private final String texte;
        private final boolean aEcrire;

        private Lieu(String classe, String source, int debut, int fin) {
            this.classe = classe;
            ligne = source.substring(0, debut).split("\n", -1).length;
            texte = source.substring(debut, fin);
            aEcrire = A_ECRIRE.matcher(texte).lookingAt();
        }

        Lieu(StackTraceElement appel) {
            classe = appel.getFileName().replace(".java", "");
            ligne = appel.getLineNumber();
            texte = "";
            aEcrire = false;
        }

        private static Path fichier(String classe) {
            return SOURCES.resolve(classe + ".java");
        }

        /**
         * Où est, dans cette classe, le champ statique ou la première méthode que nomme un texte ; à défaut celle à
         * compléter, ou le premier FIXME.
         */
        static Lieu nomme(String classe, String dit) {
            String source = source(classe);
            Matcher champ = Pattern.compile("gardé dans un champ : (\\w+)").matcher(dit);
            if (champ.find() && champ(classe, source, champ.group(1)) != null) {
                return champ(classe, source, champ.group(1));
            }
            // un nom suivi d'un point est celui d'une classe ; si aucun n'est dit, celui de la méthode à compléter
            Matcher nom = Pattern.compile("\\b(\\w+)\\b(?!\\.)(?:\\(([^)]*)\\))?")
                    .matcher(dit + " getIntersectionDistance getColor getRayon");
            Lieu ou = null;
            while (ou == null && nom.find()) {
                ou = methode(classe, source, nom.group(1), nom.group(2) == null ? "" : nom.group(2));
                ou = ou == null ? champ(classe, source, nom.group(1)) : ou;
            }
            return ou != null ? ou : new Lieu(classe, source, Math.max(0, source.indexOf("// FIXME")), source.length());
        }

        private static String source(String classe) {
            try {
                return new String(Files.readAllBytes(fichier(classe)), StandardCharsets.UTF_8);
            } catch (IOException e) {
                return "";
            }
        }

        /** Un champ statique dans un texte ; {@code null} s'il n'y est pas. */
        private static Lieu champ(String classe, String source, String nom) {
            Matcher ecrit = Pattern.compile("(?m)^.*\\bstatic\\b[^(\\n]* " + nom + " *[=;]").matcher(source);
            return ecrit.find() ? new Lieu(classe, source, ecrit.start(), ecrit.end()) : null;
        }

        /** Une méthode dans un texte, ou son FIXME s'il y est encore ; {@code null} si elle n'y est pas. */
        private static Lieu methode(String classe, String source, String nom, String parametres) {
            Lieu ou = null;
            int meilleur = Integer.MIN_VALUE;
            Matcher m = Pattern.compile("(?m)^(\\h+)(?:[\\w<>]+ )+" + nom + "\\(([^)]*)\\)[^;{]*\\{(?s:.*?)\\n\\1}")
                    .matcher(source);
            while (m.find()) {
                // de deux méthodes de ce nom, celle qui a ces paramètres, et aucun autre ; puis celle qui a le plus à dire
                int accord = m.group().length() - (parametres.isEmpty() ? 0 : 5_000 * m.group(2).split(",").length);
                for (String parametre : parametres.split("\\W+")) {
                    accord += m.group(2).matches(".* " + parametre + "\\b.*") ? 10_000 : 0;
                }
                if (accord > meilleur) {
                    meilleur = accord;
                    Matcher fixme = A_ECRIRE.matcher(m.group());
                    ou = new Lieu(classe, source, m.start() + (fixme.find() ? fixme.start() : 0), m.end());
                }
            }
            return ou;
        }

        /** Le premier calcul de cette méthode dont rien ne garde le résultat ; {@code null} s'il n'y en a pas. */
        Lieu perdu() {
            Matcher m = PERDU.matcher(texte);
            while (m.find()) {
                // une liste, elle, change
                if (m.group(2).equals("Vecteur")
                        || source(classe).matches("(?s).*\\b(Couleur|Vecteur|Point) " + m.group(2) + "\\b.*")) {
                    int ici = source(classe).indexOf(texte) + m.start(1);
                    return new Lieu(classe, source(classe), ici, ici + m.group(1).length());
                }
            }
            return null;
        }

        @Override
        public String toString() {
            return classe + ".java" + (ligne == 1 ? "" : ":" + ligne) + (aEcrire ? " (FIXME)" : "");
        }
    }
}
