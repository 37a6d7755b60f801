package lancer.contrat;

import java.util.Arrays;
import lancer.Couleur;
import lancer.Tuple;
import lancer.texte.Texte;

/** La première cause d'un échec, et la ligne du programme qui la situe. */
public final class Cause {

    /** Les types où un échec n'est pas situé, comme dans ce paquet : c'est leur appelant qui s'est trompé. */
    private static final Class<?>[] APPELES = {Tuple.class, Couleur.class, Toile.class, Section.class};

    private Cause() {
    }

    /** La première cause d'un échec, en une ligne. */
    public static String dire(Throwable echec) {
        Throwable cause = echec;
        while (cause.getCause() != null) {
            cause = cause.getCause();
        }
        return Texte.echappe(cause.toString()) + Arrays.stream(cause.getStackTrace()).filter(Cause::situe).findFirst()
                .map(pas -> " (" + pas.getClassName() + "." + pas.getMethodName() + ", " + pas.getFileName() + ":"
                + pas.getLineNumber() + ")").orElse("");
    }

    private static boolean situe(StackTraceElement pas) {
        try {
            Class<?> classe = Class.forName(pas.getClassName(), false, Cause.class.getClassLoader());
            return !classe.getName().matches("(java|javax|jdk|sun)\\..*")
                    && classe.getPackage() != Cause.class.getPackage()
                    && Arrays.stream(APPELES).noneMatch(appele -> appele.isAssignableFrom(classe));
        } catch (ClassNotFoundException e) {
            // une classe d'un autre chargeur
            return true;
        }
    }
}
