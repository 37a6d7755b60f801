package lancer.correction.enfant;

import static org.junit.platform.engine.discovery.DiscoverySelectors.selectClass;
import static org.junit.platform.engine.discovery.DiscoverySelectors.selectNestedMethod;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.platform.engine.DiscoverySelector;
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.engine.support.descriptor.MethodSource;
import org.junit.platform.launcher.Launcher;
import org.junit.platform.launcher.LauncherDiscoveryRequest;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;
import org.junit.platform.launcher.TestPlan;
import org.junit.platform.engine.TestTag;
import org.junit.platform.launcher.core.LauncherConfig;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.junit.platform.launcher.core.LauncherFactory;

/** Les vérifications de {@code lancer.Tests}, listées et lancées une à une. */
final class Verifications {

    private static final String TESTS = "lancer.Tests";

    private Verifications() {
    }

    private static Launcher lanceur() {
        return LauncherFactory.create(LauncherConfig.builder().enableTestEngineAutoRegistration(true)
                .enableTestExecutionListenerAutoRegistration(false).enableLauncherSessionListenerAutoRegistration(false)
                .build());
    }

    private static LauncherDiscoveryRequest demande(DiscoverySelector selecteur) {
        return LauncherDiscoveryRequestBuilder.request().selectors(selecteur).build();
    }

    /** {@code LISTE}, puis pour chacune : classe, méthode, titre, étiquettes, séparés par des barres verticales. */
    static String liste(ClassLoader chargeur) throws ClassNotFoundException {
        TestPlan plan = lanceur().discover(demande(selectClass(Class.forName(TESTS, false, chargeur))));
        StringBuilder texte = new StringBuilder("LISTE");
        ajouter(plan, plan.getRoots(), texte);
        return texte.toString();
    }

    private static void ajouter(TestPlan plan, Set<TestIdentifier> niveau, StringBuilder texte) {
        for (TestIdentifier test : niveau) {
            test.getSource().filter(s -> test.isTest() && s instanceof MethodSource).map(s -> (MethodSource) s)
                    .ifPresent(s -> {
                List<String> etiquettes = test.getTags().stream().map(TestTag::getName).sorted()
                        .collect(Collectors.toList());
                String titre = plan.getParent(test).map(TestIdentifier::getDisplayName).orElse("");
                texte.append('\t').append(String.join("|", s.getClassName(), s.getMethodName(), titre,
                        test.getDisplayName(),
                        String.join(",", etiquettes)));
            });
            ajouter(plan, plan.getChildren(test), texte);
        }
    }

    /** {@code REUSSI}, {@code ABANDONNE} ou {@code ECHEC}, et pourquoi. */
    static String lancer(ClassLoader chargeur, String classe, String methode) throws ClassNotFoundException {
        Class<?> englobante = Class.forName(TESTS, false, chargeur);
        Ecoute ecoute = new Ecoute();
        lanceur().execute(demande(selectNestedMethod(List.of(englobante), Class.forName(classe, false, chargeur),
                methode)), ecoute);
        return ecoute.resultat;
    }

    /** Une vérification qui n'a pas même commencé est un échec : seule la dernière fin compte, et il en faut une. */
    private static final class Ecoute implements TestExecutionListener {

        private String resultat = "ECHEC\tla vérification n'a pas pu commencer";

        @Override
        public void executionFinished(TestIdentifier test, TestExecutionResult fin) {
            String pourquoi = fin.getThrowable().map(Verifications::cause).orElse("");
            if (test.isTest()) {
                switch (fin.getStatus()) {
                    case SUCCESSFUL:
                        resultat = "REUSSI\t";
                        break;
                    case ABORTED:
                        resultat = "ABANDONNE\t" + pourquoi;
                        break;
                    default:
                        resultat = "ECHEC\t" + pourquoi;
                }
            } else if (fin.getStatus() == TestExecutionResult.Status.FAILED) {
                resultat = "ECHEC\t" + pourquoi;
            }
        }
    }

    /** Le message d'une vérification ; pour une exception de l'étudiant, son nom et la première ligne de son code. */
    static String cause(Throwable e) {
        String message = String.valueOf(e.getMessage());
        String nom = e.getClass().getName();
        if (nom.startsWith("org.opentest4j.")) {
            return Echange.protege(message.replaceFirst("^Assumption failed: ", ""));
        }
        StringBuilder texte = new StringBuilder();
        if (e instanceof StackOverflowError) {
            texte.append("appels sans fin (StackOverflowError)");
        } else if (nom.equals("java.lang.Error") && message.startsWith("Unresolved compilation problem")
                || e instanceof LinkageError || nom.endsWith(".DiscoveryIssueException")) {
            // une classe dont il n'est rien resté manque à tout ce qui la nomme
            texte.append("ne se compile pas");
        } else {
            texte.append(nom.replaceFirst(".*\\.", "")).append(e.getMessage() == null ? "" : " : " + message);
        }
        for (StackTraceElement ou : e.getStackTrace()) {
            if (ou.getClassName().startsWith("lancer.") && !ou.getClassName().startsWith("lancer.correction.")) {
                texte.append(ou.getClassName().matches("lancer\\.(Tests|Sonde).*") ? ", appelé par la vérification"
                        : ", " + ou.getFileName() + ":" + ou.getLineNumber() + " (" + ou.getMethodName() + ")");
                break;
            }
        }
        return Echange.protege(texte.toString());
    }
}
