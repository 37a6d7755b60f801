package lancer.texte;

import java.util.Arrays;

/** Lecture de la pile d'un échec. */
public final class Pile {

    /** Les classes où un échec n'est pas situé : c'est leur appelant qui s'est trompé. */
    private static final String APPELEES = "(java|javax|jdk|sun)\\..*"
            + "|lancer\\.(Tuple|Vecteur|Point|Couleur|contrat\\..*|image\\.ImageMemoire|scene\\.SectionLue)";

    private Pile() {
    }

    /** La première cause d'un échec, et la première ligne de sa pile qui le situe. */
    public static String cause(Throwable echec) {
        Throwable cause = echec;
        while (cause.getCause() != null) {
            cause = cause.getCause();
        }
        return Texte.echappe(cause.toString()) + Arrays.stream(cause.getStackTrace())
                .filter(pas -> !pas.getClassName().matches(APPELEES)).findFirst().map(pas -> " (" + pas.getClassName()
                + "." + pas.getMethodName() + ", " + pas.getFileName() + ":" + pas.getLineNumber() + ")").orElse("");
    }
}
