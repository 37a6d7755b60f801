package lancer.correction.jugement;

import static org.junit.platform.engine.discovery.DiscoverySelectors.selectClass;
import static org.junit.platform.engine.discovery.DiscoverySelectors.selectNestedMethod;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import lancer.correction.enfant.Echange;
import lancer.correction.isolement.Arret;
import lancer.correction.jugement.Verdict.Etat;
import org.junit.platform.engine.DiscoverySelector;
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.engine.TestTag;
import org.junit.platform.engine.support.descriptor.MethodSource;
import org.junit.platform.launcher.Launcher;
import org.junit.platform.launcher.LauncherDiscoveryRequest;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;
import org.junit.platform.launcher.TestPlan;
import org.junit.platform.launcher.core.LauncherConfig;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.junit.platform.launcher.core.LauncherFactory;

/**
 * Les vérifications de {@code lancer.Tests}, listées et lancées une à une, ici : elles n'ont du rendu que des doublures,
 * et le rendu n'a rien d'elles.
 */
final class Verifications {

    private static final String TESTS = "lancer.Tests";

    private final ClassLoader chargeur;

    /** @param classes les vérifications et les doublures, compilées, par nom complet */
    Verifications(Map<String, byte[]> classes) {
        chargeur = new ClassLoader(Verifications.class.getClassLoader()) {
            @Override
            protected Class<?> loadClass(String nom, boolean resoudre) throws ClassNotFoundException {
                byte[] octets = classes.get(nom);
                if (octets == null) {
                    return super.loadClass(nom, resoudre);
                }
                synchronized (getClassLoadingLock(nom)) {
                    Class<?> connue = findLoadedClass(nom);
                    return connue != null ? connue : defineClass(nom, octets, 0, octets.length);
                }
            }
        };
    }

    private Class<?> classe(String nom) {
        try {
            return Class.forName(nom, false, chargeur);
        } catch (ClassNotFoundException e) {
            throw new IllegalStateException(e);
        }
    }

    private static Launcher lanceur() {
        return LauncherFactory.create(LauncherConfig.builder().enableTestEngineAutoRegistration(true)
                .enableTestExecutionListenerAutoRegistration(false).enableLauncherSessionListenerAutoRegistration(false)
                .build());
    }

    /** Sans les réglages de JUnit qui traîneraient là : les doublures parlent au nom du fil qui lance. */
    private static LauncherDiscoveryRequest demande(DiscoverySelector selecteur) {
        return LauncherDiscoveryRequestBuilder.request().selectors(selecteur)
                .enableImplicitConfigurationParameters(false).build();
    }

    List<Verification> lister() {
        TestPlan plan = lanceur().discover(demande(selectClass(classe(TESTS))));
        List<Verification> liste = new ArrayList<>();
        ajouter(plan, plan.getRoots(), liste);
        return liste;
    }

    private static void ajouter(TestPlan plan, Set<TestIdentifier> niveau, List<Verification> liste) {
        for (TestIdentifier test : niveau) {
            test.getSource().filter(s -> test.isTest() && s instanceof MethodSource).map(s -> (MethodSource) s)
                    .ifPresent(s -> liste.add(new Verification(s.getClassName(), s.getMethodName(),
                            plan.getParent(test).map(TestIdentifier::getDisplayName).orElse(""), test.getDisplayName(),
                            test.getTags().stream().map(TestTag::getName).sorted().collect(Collectors.toList()))));
            ajouter(plan, plan.getChildren(test), liste);
        }
    }

    /** Ce qu'une vérification donne des classes que tient cette machine. */
    Verdict lancer(Verification v, Machines.Rendue machine) throws Arret {
        return Dialogue.avec(machine, () -> {
            Ecoute ecoute = new Ecoute();
            lanceur().execute(demande(selectNestedMethod(List.of(classe(TESTS)), classe(v.classeJava), v.methode)),
                    ecoute);
            return ecoute.verdict;
        });
    }

    /** Une vérification qui n'a pas même commencé est un échec : seule la dernière fin compte, et il en faut une. */
    private static final class Ecoute implements TestExecutionListener {

        private Verdict verdict = new Verdict(Etat.RATE, "la vérification n'a pas pu commencer");

        @Override
        public void executionFinished(TestIdentifier test, TestExecutionResult fin) {
            if (test.isTest() || fin.getStatus() == TestExecutionResult.Status.FAILED) {
                verdict = new Verdict(fin.getStatus() == TestExecutionResult.Status.SUCCESSFUL ? Etat.REUSSI
                        : fin.getStatus() == TestExecutionResult.Status.ABORTED ? Etat.NON_COMMENCE : Etat.RATE,
                        fin.getThrowable().map(Ecoute::message).orElse(""));
            }
        }

        private static String message(Throwable e) {
            String message = String.valueOf(e.getMessage());
            boolean parle = e instanceof AssertionError || e instanceof Dialogue.Echec
                    || e instanceof StackOverflowError || e.getClass().getName().startsWith("org.opentest4j.");
            return Echange.protege(parle ? message.replaceFirst("^Assumption failed: ", "")
                    : e instanceof NullPointerException ? "une méthode rend null, là où la vérification attend un objet"
                    : e.getClass().getSimpleName() + " : " + message + ", dans la vérification");
        }
    }
}
