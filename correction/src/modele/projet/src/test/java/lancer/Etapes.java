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
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.engine.TestExecutionResult.Status;
import org.junit.platform.engine.TestTag;
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

    /** Ce qui suit un lieu où le squelette demande encore d'écrire. */
    private static final String FIXME = " (FIXME)";

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
        String suivante = "Toutes les étapes sont faites : restent les images à regarder, et les extensions.";
        for (TestIdentifier etape : etapes(fini)) {
            List<TestIdentifier> verifications = enOrdre(fini, etape);
            List<Manque> manques = verifications.stream().filter(v -> !reussie(v)).map(v -> new Manque(v, etape))
                    .collect(Collectors.toList());
            bilan.append(etape.getDisplayName()).append(" : ").append(verifications.size() - manques.size()).append('/')
                    .append(verifications.size());
            if (!manques.isEmpty()) {
                Manque premier = manques.stream().filter(m -> !m.nonEvaluable).findFirst().orElse(manques.get(0));
                bilan.append(premier.nonEvaluable ? " ; le reste n'est pas évaluable"
                        : premier.aCommencer ? " ; à commencer : " + premier.dit
                        : " ; à reprendre d'abord : " + premier.intitule);
                // ce qu'une étape d'après explique n'est pas imputé à celle-ci
                if (aReprendre == null || premier.rang < aReprendre.rang) {
                    aReprendre = premier;
                    detail = manques.stream().map(Manque::toString).distinct().collect(Collectors.joining());
                    suivante = "L'étape suivante : " + etape.getDisplayName() + " ; à " + premier.aFaire;
                }
            }
            bilan.append('\n');
        }
        if (bilan.length() > 1) {
            System.out.println(bilan.append(detail).append('\n').append(suivante));
        }
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

        private final String intitule;
        private final String dit;
        private final String question;
        private final String aFaire;
        private final boolean nonEvaluable;
        private final boolean aCommencer;
        /** Ce qui se reprend d'abord : ce qui échoue, puis ce qui n'est pas commencé, puis ce que le reste empêche d'évaluer. */
        private final int rang;

        Manque(TestIdentifier qui, TestIdentifier etape) {
            intitule = qui.getDisplayName();
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
            String classe = qui.getTags().stream().map(TestTag::getName).filter(t -> Files.exists(fichier(t)))
                    .findFirst().orElse("");
            String lieu;
            if (abandonnee || cause instanceof AssertionError) {
                dit = String.valueOf(cause.getMessage()).replaceFirst("^Assumption failed: (étape non commencée : )?", "");
                lieu = lieu(classe, intitule + " : " + dit);
            } else if (cause instanceof StackOverflowError && premiere(cause, p -> p.getMethodName().equals("getColor")).isPresent()) {
                // en haut de la pile, la dernière méthode appelée, qui n'y est pour rien
                dit = "des appels sans fin : la profondeur ne diminue pas, ou rien ne la regarde, dans Objet3D.getColor";
                lieu = lieu("Objet3D", "getColor");
            } else {
                // une exception : elle est née dans une des classes de l'étudiant
                dit = cause instanceof StackOverflowError ? "des appels sans fin : une méthode s'appelle elle-même, ou par une autre"
                        : cause.toString().replaceFirst("^java\\.lang\\.(Error: )?", "");
                lieu = premiere(cause, Causes::deLEtudiant)
                        .map(p -> p.getFileName() + ":" + p.getLineNumber()).orElse(lieu(classe, intitule));
            }
            nonEvaluable = abandonnee && dit.startsWith("étape non évaluable");
            aCommencer = abandonnee && (lieu.endsWith(FIXME) || cause.getMessage().contains("étape non commencée")
                    && etape.getTags().stream().anyMatch(t -> DANS_LA_MEME_METHODE.contains(t.getName())));
            rang = nonEvaluable ? 2 : aCommencer ? 1 : 0;
            aFaire = (aCommencer || lieu.endsWith(FIXME) ? "compléter : " : "reprendre : ") + lieu;
        }

        private Optional<StackTraceElement> premiere(Throwable faute, Predicate<StackTraceElement> voulue) {
            return Arrays.stream(faute.getStackTrace()).filter(voulue).findFirst();
        }

        @Override
        public String toString() {
            return aCommencer ? "\n- " + dit + "\n  à " + aFaire + "\n"
                    : "\n- " + intitule + "\n  " + dit + "\n  " + question + " ; à " + aFaire + "\n";
        }
    }

    private static Path fichier(String classe) {
        return SOURCES.resolve(classe + ".java");
    }

    /** Où est, dans cette classe, la première méthode que nomme un texte ; à défaut celle à compléter, ou le premier FIXME. */
    private static String lieu(String classe, String dit) {
        String texte;
        try {
            texte = new String(Files.readAllBytes(fichier(classe)), StandardCharsets.UTF_8);
        } catch (IOException e) {
            return classe;
        }
        // un nom suivi d'un point est celui d'une classe ; si aucun n'est dit, celui de la méthode à compléter
        Matcher nom = Pattern.compile("\\b(\\w+)\\b(?!\\.)(?:\\(([^)]*)\\))?").matcher(dit + " getIntersectionDistance getColor getRayon");
        int ou = -1;
        while (ou < 0 && nom.find()) {
            ou = methode(texte, nom.group(1), nom.group(2) == null ? "" : nom.group(2));
        }
        ou = ou >= 0 ? ou : texte.indexOf("// FIXME");
        return classe + ".java" + (ou < 0 ? "" : ":" + texte.substring(0, ou).split("\n", -1).length
                + (texte.startsWith("// FIXME", ou) ? FIXME : ""));
    }

    /** La place d'une méthode dans un texte, de son FIXME s'il y est encore ; -1 si elle n'y est pas. */
    private static int methode(String texte, String nom, String parametres) {
        int ou = -1;
        int meilleur = Integer.MIN_VALUE;
        Matcher m = Pattern.compile("(?m)^    (?:[\\w<>]+ )+" + nom + "\\(([^)]*)\\)[^;{]*\\{(?s:.*?)\n    }")
                .matcher(texte);
        while (m.find()) {
            // de deux méthodes de ce nom, celle qui a ces paramètres, et aucun autre ; puis celle qui a le plus à dire
            int accord = m.group().length() - (parametres.isEmpty() ? 0 : 5_000 * m.group(1).split(",").length);
            for (String parametre : parametres.split("\\W+")) {
                accord += m.group(1).matches(".* " + parametre + "\\b.*") ? 10_000 : 0;
            }
            if (accord > meilleur) {
                meilleur = accord;
                ou = m.start() + Math.max(0, m.group().indexOf("// FIXME"));
            }
        }
        return ou;
    }
}
