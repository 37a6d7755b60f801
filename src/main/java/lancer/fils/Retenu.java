package lancer.fils;

/** Un fil que le même calcul retient depuis dix secondes. La pile de cette exception est celle du fil. */
public final class Retenu extends RuntimeException {

    private static final long serialVersionUID = 1L;

    Retenu(Thread fil) {
        super("ce calcul dure depuis dix secondes");
        setStackTrace(fil.getStackTrace());
    }

    /** Le message seul, sans nom de classe. */
    @Override
    public String toString() {
        return getMessage();
    }
}
