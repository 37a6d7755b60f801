package lancer;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.opentest4j.TestAbortedException;

/**
 * Ce que demande une vérification de {@link Tests} : une classe du cours, et ses méthodes qui sont à compléter. Une étape
 * le dit pour toutes les siennes qui ne le disent pas. Ce fichier est donné : il n'y a rien à y changer.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target({ElementType.METHOD, ElementType.TYPE})
public @interface Demande {

    /** {@code Object} si la vérification ne la connaît pas : son échec est alors {@link Garde}. */
    Class<?> classe();

    /** Leurs noms, celui de la classe pour un constructeur ; aucun, si toutes peuvent être en cause. */
    String[] methodes() default {};

    /** Abandonne une vérification : cette méthode du cours est encore telle qu'elle est donnée. */
    final class NonCommencee extends TestAbortedException {

        private static final long serialVersionUID = 1;

        public final Class<?> classe;
        public final String methode;
        /** Ce qui le montre. */
        public final String dit;

        public NonCommencee(Class<?> classe, String methode, String dit) {
            super("étape non commencée : " + dit);
            this.classe = classe;
            this.methode = methode;
            this.dit = dit;
        }
    }

    /** Abandonne une vérification : un échec plus ancien l'explique, ou empêche d'en juger. */
    final class NonEvaluable extends TestAbortedException {

        private static final long serialVersionUID = 1;

        /** Cet échec. */
        public final String dit;

        public NonEvaluable(String dit) {
            super("étape non évaluable : " + dit);
            this.dit = dit;
        }
    }

    /** Échec de qui garde quelque chose d'un appel à l'autre : il dit lui-même la classe et la méthode en cause. */
    final class Garde extends AssertionError {

        private static final long serialVersionUID = 1;

        public final Class<?> classe;
        /** Aucune, si un champ est en cause. */
        public final String[] methodes;

        public Garde(String dit, Class<?> classe, String... methodes) {
            super(classe.getSimpleName() + (methodes.length == 0 ? "" : "." + methodes[0]) + " : " + dit);
            this.classe = classe;
            this.methodes = methodes;
        }
    }
}
