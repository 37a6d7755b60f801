package lancer.correction.jugement;

import static org.junit.platform.engine.discovery.DiscoverySelectors.selectClass;
import static org.junit.platform.engine.discovery.DiscoverySelectors.selectNestedMethod;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import lancer.correction.enfant.Execution;
import lancer.correction.enfant.Texte;
import lancer.correction.jugement.Verdict.Etat;
import org.junit.platform.commons.support.HierarchyTraversalMode;
import org.junit.platform.commons.support.ReflectionSupport;
import org.junit.platform.engine.DiscoverySelector;
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.launcher.LauncherDiscoveryRequest;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;
import org.junit.platform.launcher.TestPlan;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.junit.platform.launcher.core.LauncherFactory;

/**
 * Les vérifications de {@code lancer.Tests}, listées et exécutées ici. Elles ne voient du rendu que des doublures, et le rendu ne les voit
 * pas.
 */
final class Verifications {

    private static final String TESTS = "lancer.Tests";
    /** Propriété de Java que lit {@code lancer.Tests}. */
    private static final String GRAINE = "tests.graine";
    /** Nombre de vérifications sans fin après lequel les suivantes ne sont pas exécutées. */
    private static final int ARRETS_MAX = 3;
    /** Pourquoi une vérification est abandonnée, d'après le nom de l'exception qui le dit : elle est d'un autre chargeur. */
    private static final Map<String, Etat> ABANDONS =
            Map.of("NonEvaluable", Etat.NON_EVALUABLE, "NonCommencee", Etat.NON_COMMENCE);

    private final ClassLoader chargeur;
    private final long graine;

    /** @param classes les vérifications et les doublures, compilées, par nom complet ; @param graine d'où tirer les valeurs */
    Verifications(Map<String, byte[]> classes, long graine) {
        this.graine = graine;
        chargeur = new Execution.Classes(classes, Verifications.class.getClassLoader());
    }

    /** Demande à JUnit, sans les réglages de l'environnement : les doublures dépendent du fil qui exécute. */
    private static LauncherDiscoveryRequest demande(List<? extends DiscoverySelector> selecteurs) {
        return LauncherDiscoveryRequestBuilder.request().selectors(selecteurs)
                .enableImplicitConfigurationParameters(false).configurationParameter("tests.patience", "0").build();
    }

    List<Verification> lister() {
        TestPlan plan = LauncherFactory.create().discover(demande(List.of(selectClass(chargeur, TESTS))));
        return plan.getRoots().stream().flatMap(racine -> plan.getDescendants(racine).stream()).filter(TestIdentifier::isTest)
                .map(test -> new Verification(plan.getParent(test).get().getDisplayName(), test))
                .collect(Collectors.toList());
    }

    /** Résultats de vérifications exécutées l'une après l'autre sur les classes d'une machine virtuelle. */
    static final class Bilan implements TestExecutionListener {

        /** Verdicts par {@link Verification#id()}. */
        final Map<String, Verdict> verdicts = new HashMap<>();
        /** Nombre de vérifications qui n'ont pas fini, et raison de la dernière. */
        int arrets;
        String pourquoi = "";
        private final Dialogue dialogue;

        private Bilan(List<Verification> verifications, Dialogue dialogue) {
            this.dialogue = dialogue;
            verifications.forEach(v -> verdicts.put(v.id(), new Verdict(Etat.FAUSSE, v.classe, "la vérification n'a pas pu commencer")));
        }

        /** Dit si les dernières vérifications n'ont pas été exécutées. */
        boolean coupe() {
            return arrets >= ARRETS_MAX;
        }

        /** Note le résultat de cette vérification, et prépare la machine virtuelle à la suivante. */
        @Override
        public void executionFinished(TestIdentifier test, TestExecutionResult fin) {
            if (!test.isTest()) {
                return;
            }
            // après trop d'arrêts, chaque vérification dit pourquoi elle n'est pas exécutée
            String arret = coupe() ? null : dialogue.recommencer();
            if (arret != null) {
                arrets++;
                pourquoi = arret;
                if (coupe()) {
                    dialogue.refus = "non lancé, ce qui précède n'ayant pas fini : " + arret;
                }
            }
            Verification v = new Verification("", test);
            verdicts.put(v.id(), arret != null ? new Verdict(Etat.FAUSSE, v.classe, arret) : verdict(v, fin));
        }

        private static Verdict verdict(Verification v, TestExecutionResult fin) {
            Throwable cause = fin.getThrowable().orElse(null);
            if (cause == null) {
                return new Verdict(Etat.REUSSI, v.classe, "");
            }
            Etat etat = ABANDONS.getOrDefault(cause.getClass().getSimpleName(), Etat.FAUSSE);
            if (etat == Etat.NON_COMMENCE) {
                return new Verdict(etat, ((Class<?>) champ(cause, "classe")).getSimpleName(), Texte.protege((String) champ(cause, "dit")),
                        null, (String) champ(cause, "methode"));
            } else if (etat == Etat.NON_EVALUABLE) {
                return new Verdict(etat, v.classe, Texte.protege((String) champ(cause, "dit")));
            }
            return new Verdict(etat, v.classe, message(cause), cause instanceof Dialogue.Echec ? ((Dialogue.Echec) cause).faute : null, "");
        }

        private static Object champ(Throwable abandon, String nom) {
            return ReflectionSupport.findFields(abandon.getClass(), c -> c.getName().equals(nom), HierarchyTraversalMode.TOP_DOWN).stream()
                    .map(c -> ReflectionSupport.tryToReadFieldValue(c, abandon).toOptional().get()).findFirst().get();
        }

        private static String message(Throwable e) {
            String message = String.valueOf(e.getMessage());
            if (e instanceof AssertionError || e instanceof Dialogue.Echec || e instanceof StackOverflowError) {
                return Texte.protege(message);
            } else if (e instanceof NullPointerException) {
                return "une méthode rend null, là où la vérification attend un objet";
            }
            return Texte.protege(e.getClass().getSimpleName() + " : " + message + ", dans la vérification");
        }
    }

    Bilan lancer(List<Verification> verifications, Machines.Rendue machine) {
        System.setProperty(GRAINE, String.valueOf(graine));
        Dialogue dialogue = new Dialogue(machine);
        Bilan bilan = new Bilan(verifications, dialogue);
        dialogue.mener(() -> LauncherFactory.create().execute(demande(verifications.stream()
                .map(v -> selectNestedMethod(chargeur, List.of(TESTS), v.classeJava, v.methode))
                .collect(Collectors.toList())), bilan));
        return bilan;
    }
}
