package lancer.texte;

/** Lecture de la pile d'un échec. */
public final class Pile {

    /** Les noms des classes qui ne font pas partie de Java, pour {@link #cause}. */
    public static final String HORS_DE_JAVA = "(?!(java|javax|jdk|sun)\\.).*";

    private Pile() {
    }

    /**
     * Cause d'un échec, et la première ligne de sa pile dont la classe suit une de ces expressions, par préférence.
     */
    public static String cause(Throwable echec, String... classes) {
        Throwable cause = echec;
        while (cause.getCause() != null) {
            cause = cause.getCause();
        }
        return Texte.echappe(cause.toString()) + ligne(cause.getStackTrace(), classes);
    }

    private static String ligne(StackTraceElement[] pile, String... classes) {
        for (String noms : classes) {
            for (StackTraceElement pas : pile) {
                if (pas.getClassName().matches(noms)) {
                    return " (" + pas.getClassName() + "." + pas.getMethodName() + ", " + pas.getFileName() + ":"
                            + pas.getLineNumber() + ")";
                }
            }
        }
        return "";
    }
}
