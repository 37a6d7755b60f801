package lancer.fils;

/** Un fil que le même calcul retient depuis dix secondes. Sa pile est celle de ce fil. */
public final class Retenu extends RuntimeException {

    private static final long serialVersionUID = 1L;

    Retenu(Thread fil) {
        super("ce calcul dure depuis dix secondes");
        setStackTrace(fil.getStackTrace());
    }

    /** Message seul : ce n'est pas une exception de Java. */
    @Override
    public String toString() {
        return getMessage();
    }
}
