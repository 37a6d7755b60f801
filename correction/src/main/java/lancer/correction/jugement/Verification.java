package lancer.correction.jugement;

import java.lang.annotation.Annotation;
import java.lang.reflect.Method;
import java.util.List;
import java.util.stream.Stream;
import org.junit.platform.commons.support.ReflectionSupport;
import org.junit.platform.engine.support.descriptor.MethodSource;
import org.junit.platform.launcher.TestIdentifier;

/** Un critère d'une étape : une vérification de {@code lancer.Tests}, l'image d'une scène, une extension ou une consigne. */
public final class Verification {

    /** L'étape qui ne vaut aucun point : ce qu'une classe garde d'un appel à l'autre est dit, et coûte là où cela rend faux. */
    static final String REPETITION = "repetition";

    final String etape;
    /** Le titre de son étape. */
    final String titreEtape;
    final String methode;
    public final String titre;
    /** La classe du cours visée, vide s'il n'y en a pas. */
    public final String classe;
    /** Celles des méthodes à compléter de cette classe qu'elle demande ; aucune, si toutes peuvent être en cause. */
    transient List<String> methodes = List.of();
    /** Faux si le projet à compléter réussit déjà ce critère, qui ne rapporte alors rien. */
    public boolean compte = true;
    /** La classe de {@code lancer.Tests} qui contient la vérification, {@code null} pour un autre critère. */
    transient String classeJava;

    Verification(String etape, String titreEtape, String methode, String classe, String titre) {
        this.etape = etape;
        this.titreEtape = titreEtape;
        this.methode = methode;
        this.classe = classe;
        this.titre = titre;
    }

    Verification(String titreEtape, TestIdentifier test) {
        this(test.getTags().iterator().next().getName(), titreEtape.replaceFirst("^\\d+\\. ", ""), source(test).getMethodName(),
                demandee(test), test.getDisplayName());
        methodes = List.of((String[]) demande(test, "methodes"));
        classeJava = source(test).getClassName();
    }

    private static MethodSource source(TestIdentifier test) {
        return (MethodSource) test.getSource().get();
    }

    /** La classe du cours que demande une vérification. */
    public static String demandee(TestIdentifier test) {
        return ((Class<?>) demande(test, "classe")).getSimpleName();
    }

    /** Ce que dit l'annotation d'une vérification, ou à défaut celle de son étape ; sa classe est d'un autre chargeur. */
    private static Object demande(TestIdentifier test, String quoi) {
        Method methode = source(test).getJavaMethod();
        Annotation demande = Stream.of(methode, methode.getDeclaringClass()).flatMap(e -> Stream.of(e.getAnnotations()))
                .filter(a -> a.annotationType().getName().equals("lancer.Demande")).findFirst().get();
        return ReflectionSupport.invokeMethod(ReflectionSupport.findMethod(demande.annotationType(), quoi).get(), demande);
    }

    public String id() {
        return etape + "." + methode;
    }
}
