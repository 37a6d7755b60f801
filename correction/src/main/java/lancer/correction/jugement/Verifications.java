package lancer.correction.jugement;

import static org.junit.platform.engine.discovery.DiscoverySelectors.selectClass;
import static org.junit.platform.engine.discovery.DiscoverySelectors.selectNestedMethod;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import lancer.correction.enfant.Echange;
import lancer.correction.enfant.Execution;
import lancer.correction.jugement.Verdict.Etat;
import org.junit.platform.engine.DiscoverySelector;
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.launcher.LauncherDiscoveryRequest;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;
import org.junit.platform.launcher.TestPlan;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.junit.platform.launcher.core.LauncherFactory;

/**
 * Les vérifications de {@code lancer.Tests}, listées et lancées ici : elles n'ont du rendu que des doublures,
 * et le rendu n'a rien d'elles.
 */
final class Verifications {

    private static final String TESTS = "lancer.Tests";
    /** Nombre de vérifications sans fin après lequel les suivantes ne sont pas lancées. */
    private static final int ARRETS_MAX = 3;

    private final ClassLoader chargeur;

    /** @param classes les vérifications et les doublures, compilées, par nom complet */
    Verifications(Map<String, byte[]> classes) {
        chargeur = new Execution.Classes(classes, Verifications.class.getClassLoader());
    }

    /** Lanceur sans les réglages de JUnit qui traîneraient là : les doublures parlent au nom du fil qui lance. */
    private static LauncherDiscoveryRequest demande(List<? extends DiscoverySelector> selecteurs) {
        return LauncherDiscoveryRequestBuilder.request().selectors(selecteurs)
                .enableImplicitConfigurationParameters(false).build();
    }

    List<Verification> lister() {
        TestPlan plan = LauncherFactory.create().discover(demande(List.of(selectClass(chargeur, TESTS))));
        return plan.getRoots().stream().flatMap(racine -> plan.getDescendants(racine).stream()).filter(TestIdentifier::isTest)
                .map(test -> new Verification(plan.getParent(test).get().getDisplayName(), test))
                .collect(Collectors.toList());
    }

    /** Résultats que des vérifications, lancées l'une après l'autre, donnent des classes que tient une machine. */
    static final class Bilan implements TestExecutionListener {

        /** Verdicts par {@link Verification#id()}. */
        final Map<String, Verdict> verdicts = new HashMap<>();
        /** Nombre de celles qui n'ont pas fini, et pourquoi la dernière. */
        int arrets;
        String pourquoi = "";
        private final Dialogue dialogue;

        private Bilan(List<Verification> verifications, Dialogue dialogue) {
            this.dialogue = dialogue;
            verifications.forEach(v -> verdicts.put(v.id(), new Verdict(Etat.RATE, "la vérification n'a pas pu commencer")));
        }

        /** Vrai si, faute de finir, les dernières n'ont pas été lancées. */
        boolean coupe() {
            return arrets >= ARRETS_MAX;
        }

        /** Note ce que donne cette vérification, et prépare la machine à la suivante. */
        @Override
        public void executionFinished(TestIdentifier test, TestExecutionResult fin) {
            if (!test.isTest()) {
                return;
            }
            // une fois coupé, chacune dit pourquoi elle n'est pas lancée
            String arret = coupe() ? null : dialogue.recommencer();
            if (arret != null) {
                arrets++;
                pourquoi = arret;
                if (coupe()) {
                    dialogue.refus = "non lancé, ce qui précède n'ayant pas fini : " + arret;
                }
            }
            verdicts.put(new Verification("", test).id(), arret != null ? new Verdict(Etat.RATE, arret)
                    : new Verdict(fin.getStatus() == TestExecutionResult.Status.SUCCESSFUL ? Etat.REUSSI
                    : fin.getStatus() == TestExecutionResult.Status.ABORTED ? Etat.NON_COMMENCE : Etat.RATE,
                    fin.getThrowable().map(Bilan::message).orElse("")));
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

    Bilan lancer(List<Verification> verifications, Machines.Rendue machine) {
        Dialogue dialogue = new Dialogue(machine);
        Bilan bilan = new Bilan(verifications, dialogue);
        dialogue.mener(() -> LauncherFactory.create().execute(demande(verifications.stream()
                .map(v -> selectNestedMethod(chargeur, List.of(TESTS), v.classeJava, v.methode))
                .collect(Collectors.toList())), bilan));
        return bilan;
    }
}
