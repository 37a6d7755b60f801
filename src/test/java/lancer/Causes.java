package lancer;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.InvocationInterceptor;
import org.junit.jupiter.api.extension.ReflectiveInvocationContext;
import org.junit.jupiter.api.extension.TestInstancePostProcessor;
import org.junit.jupiter.api.function.Executable;
import org.opentest4j.TestAbortedException;

/**
 * L'ordre des causes. Une vérification de {@link Tests} qu'explique un échec plus ancien n'est pas ratée : elle est « non
 * évaluable », et nomme cet échec. Une vérification a dix secondes, ou {@code -Dtests.patience} ; 0 : autant qu'elle en
 * veut. Ce fichier est donné : il n'y a rien à y changer.
 */
public final class Causes implements InvocationInterceptor, TestInstancePostProcessor {

    /**
     * Les méthodes du cours, les causes d'abord : leur classe, puis, si elle s'écrit en deux fois, une méthode. Une faute
     * explique celles de toutes les lignes qui suivent, si on les cherche après elle.
     */
    private static final List<List<String>> ORDRE = Arrays.asList(
            // les classes données
            Arrays.asList("Tuple"), Arrays.asList("Constantes"), Arrays.asList("PointContact"), Arrays.asList("Couleur"),
            Arrays.asList("Vecteur"), Arrays.asList("Point"), Arrays.asList("Rayon", "Rayon"),
            Arrays.asList("Sphere", "getIntersectionDistance"), Arrays.asList("Rayon", "calcContact"),
            Arrays.asList("Scene"), Arrays.asList("Sphere", "getNormale"), Arrays.asList("Objet3D"),
            Arrays.asList("Camera"), Arrays.asList("Lancer"));

    /** Les piles d'un fil qui ne répond pas, et les millisecondes de l'une à l'autre. */
    private static final int PILES = 10;
    private static final int ECART_MS = 20;

    /** Ce qu'une suite de vérifications a déjà montré. */
    private static final class Vu {

        /** Le premier échec de chaque rang. */
        private final Map<Integer, String> echecs = new TreeMap<>();
        /** Le rang d'une méthode qui ne finit pas, et son nom. */
        private int rangSansFin = ORDRE.size();
        private String sansFin;
        /** Si {@link Repetition} a été demandé, et ce qu'il a trouvé ; {@code null}, rien. */
        private boolean repete;
        private Error garde;
        /** Ce que dit {@link Tests#ombreDeSoi}, vide si elle ne dit rien ; {@code null} : pas encore demandé. */
        private String ombre;
    }

    private static Vu vu(ExtensionContext qui) {
        return qui.getRoot().getStore(ExtensionContext.Namespace.create(Causes.class))
                .getOrComputeIfAbsent(Vu.class, cle -> new Vu(), Vu.class);
    }

    /** Ce que demande une vérification : sa classe le dit, si elle-même ne le dit pas. */
    static Demande demande(Method verification) {
        Demande sienne = verification.getAnnotation(Demande.class);
        return sienne != null ? sienne : verification.getDeclaringClass().getAnnotation(Demande.class);
    }

    /** La place de ces méthodes d'une classe dans l'ordre des causes. */
    private static int rang(String classe, String... methodes) {
        for (int k = 0; k < ORDRE.size(); k++) {
            List<String> ligne = ORDRE.get(k);
            if (ligne.get(0).equals(classe) && (ligne.size() == 1 || methodes.length == 0
                    || Arrays.asList(methodes).contains(ligne.get(1)))) {
                return k;
            }
        }
        return 0;
    }

    private static int rang(ExtensionContext qui) {
        Demande demande = demande(qui.getRequiredTestMethod());
        return rang(demande.classe().getSimpleName(), demande.methodes());
    }

    @Override
    public void interceptBeforeEachMethod(Invocation<Void> etape, ReflectiveInvocationContext<Method> methode, ExtensionContext qui)
            throws Throwable {
        mener(etape, qui);
    }

    @Override
    public void interceptTestMethod(Invocation<Void> etape, ReflectiveInvocationContext<Method> methode, ExtensionContext qui)
            throws Throwable {
        mener(etape, qui);
    }

    private static void mener(Invocation<Void> etape, ExtensionContext qui) throws Throwable {
        Vu vu = vu(qui);
        int rang = rang(qui);
        if (rang >= vu.rangSansFin) {
            etape.skip();
            throw new Demande.NonEvaluable(vu.sansFin + " ne finit pas");
        }
        if (patience(qui) > 0) {
            // avant toutes les autres : ce qui est gardé l'est déjà après elles
            repeter(vu, new Ecoute(), patience(qui));
        }
        try {
            limiter(etape::proceed, patience(qui), vu);
        } catch (Throwable faute) {
            boolean abandonnee = faute instanceof TestAbortedException;
            String cause = qui.getTags().contains(Repetition.ETAPE) ? null
                    : abandonnee ? garde(vu.garde, rang) : cause(vu, rang, qui);
            if (cause != null) {
                throw new Demande.NonEvaluable(cause);
            }
            if (!abandonnee) {
                vu.echecs.putIfAbsent(rang, qui.getDisplayName());
            }
            throw faute;
        }
    }

    /** Répète les questions, une seule fois. */
    private static void repeter(Vu vu, Ecoute ecoute, long patience) {
        if (!vu.repete) {
            vu.repete = true;
            PrintStream sortie = System.out;
            try {
                limiter(() -> Repetition.chercher(ecoute), patience, new Vu());
                vu.garde = ecoute == null ? null : ecoute.affiche;
            } catch (Demande.Garde garde) {
                vu.garde = garde;
            } catch (Throwable inacheve) {
                // les vérifications le disent
            } finally {
                System.setOut(sortie);
            }
        }
    }

    /** Ce qui explique un échec, {@code null} si rien ne l'explique. */
    private static String cause(Vu vu, int rang, ExtensionContext qui) {
        for (Map.Entry<Integer, String> echec : vu.echecs.entrySet()) {
            if (echec.getKey() < rang) {
                return "« " + echec.getValue() + " » échoue d'abord";
            }
        }
        if (vu.rangSansFin < ORDRE.size()) {
            return null;
        }
        String garde = garde(garde(qui), rang);
        if (garde != null) {
            return garde;
        }
        if (demande(qui.getRequiredTestMethod()).classe() != Objet3D.class
                || qui.getRequiredTestMethod().getName().equals(Tests.OMBRE_DE_SOI)) {
            return null;
        }
        if (vu.ombre == null) {
            vu.ombre = "";
            String dit = ((Tests) qui.getRequiredTestInstances().getAllInstances().get(0)).ombreDeSoi();
            vu.ombre = dit == null ? "" : dit;
        }
        return vu.ombre.isEmpty() ? null : vu.ombre;
    }

    /** Ce que garde une méthode d'un appel à l'autre, si cela peut expliquer un échec de ce rang ; {@code null} sinon. */
    private static String garde(Error trouve, int rang) {
        Demande.Garde garde = trouve instanceof Demande.Garde ? (Demande.Garde) trouve : null;
        return garde != null && rang(garde.classe.getSimpleName(), garde.methodes) <= rang ? garde.getMessage() : null;
    }

    private static Error garde(ExtensionContext qui) {
        repeter(vu(qui), null, 0);
        return vu(qui).garde;
    }

    @Override
    public void postProcessTestInstance(Object instance, ExtensionContext qui) {
        if (instance instanceof Repetition) {
            ((Repetition) instance).faute = () -> garde(qui);
        }
    }

    /** Ce qui s'affiche n'y va pas : la ligne qui, la première, a affiché quelque chose est gardée. */
    private static final class Ecoute extends PrintStream {

        private Error affiche;

        Ecoute() {
            super(new ByteArrayOutputStream());
        }

        @Override
        public void write(byte[] octets, int debut, int combien) {
            if (affiche == null) {
                affiche = new Error("dessiner un pixel affiche du texte dans la console : une image en a 480 000");
                affiche.setStackTrace(Arrays.stream(affiche.getStackTrace()).filter(Causes::deLEtudiant).toArray(StackTraceElement[]::new));
            }
        }
    }

    /** Millisecondes ; 0 si rien n'est mesuré : un débogueur arrête le programme autant qu'il veut. */
    private static long patience(ExtensionContext qui) {
        boolean debogueur = ManagementFactory.getRuntimeMXBean().getInputArguments().stream().anyMatch(a -> a.startsWith("-agentlib:jdwp"));
        return debogueur ? 0 : 1000L * qui.getConfigurationParameter("tests.patience", Integer::valueOf).orElse(10);
    }

    /** Mène cette vérification dans un fil que l'on abandonne s'il ne finit pas à temps. */
    private static void limiter(Executable etape, long patience, Vu vu) throws Throwable {
        if (patience == 0) {
            etape.execute();
            return;
        }
        Throwable[] faute = new Throwable[1];
        Thread fil = new Thread(() -> {
            try {
                etape.execute();
            } catch (Throwable e) {
                faute[0] = e;
            }
        });
        fil.setDaemon(true);
        fil.start();
        fil.join(patience);
        if (fil.isAlive()) {
            faute[0] = sansFin(fil, patience, vu);
        }
        if (faute[0] != null) {
            throw faute[0];
        }
    }

    /** La dernière méthode de l'étudiant où ce fil est toujours, de pile en pile. */
    private static Error sansFin(Thread fil, long patience, Vu vu) throws InterruptedException {
        List<StackTraceElement> commune = pile(fil);
        for (int k = 1; k < PILES; k++) {
            Thread.sleep(ECART_MS);
            List<StackTraceElement> autre = pile(fil);
            int pareilles = 0;
            while (pareilles < Math.min(commune.size(), autre.size())
                    && memeMethode(commune.get(pareilles), autre.get(pareilles))) {
                pareilles++;
            }
            commune = autre.subList(0, pareilles);
        }
        commune = new ArrayList<>(commune);
        Collections.reverse(commune);
        while (!commune.isEmpty() && !deLEtudiant(commune.get(0))) {
            commune.remove(0);
        }
        String ou = "";
        if (!commune.isEmpty()) {
            String classe = commune.get(0).getClassName().replaceFirst("^lancer\\.", "");
            vu.sansFin = classe + "." + commune.get(0).getMethodName();
            vu.rangSansFin = Math.max(rang("Rayon", "Rayon"), rang(classe, commune.get(0).getMethodName().replace("<init>", classe)));
            ou = " dans " + vu.sansFin;
        }
        Error erreur = new Error("sans réponse après " + patience / 1000 + " secondes : une boucle sans fin" + ou + " ?");
        erreur.setStackTrace(commune.toArray(new StackTraceElement[0]));
        return erreur;
    }

    /** Ses appels, du premier au dernier. */
    private static List<StackTraceElement> pile(Thread fil) {
        List<StackTraceElement> pile = Arrays.asList(fil.getStackTrace());
        Collections.reverse(pile);
        return pile;
    }

    private static boolean memeMethode(StackTraceElement a, StackTraceElement b) {
        return a.getClassName().equals(b.getClassName()) && a.getMethodName().equals(b.getMethodName());
    }

    /** Vrai dans une classe du projet qui n'est pas une de celles qui le vérifient. */
    static boolean deLEtudiant(StackTraceElement appel) {
        return appel.getClassName().matches("lancer\\.(?!Tests|Demande|Causes|Repetition|Valeurs|ImageAttendue).*");
    }
}
