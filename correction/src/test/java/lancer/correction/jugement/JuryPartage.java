package lancer.correction.jugement;

import java.util.HashMap;
import java.util.Map;
import lancer.correction.isolement.Confinement;

/** Le jury de tous les essais de cette machine virtuelle, avec ou sans confinement : juger le corrigé dure autant que quelques rendus. */
public final class JuryPartage extends Jury {

    /** D'où viennent les valeurs de ces essais. */
    public static final long GRAINE = 20;

    private static final Map<Boolean, JuryPartage> JURYS = new HashMap<>();

    private JuryPartage(Confinement confinement) {
        super(confinement, GRAINE);
        Runtime.getRuntime().addShutdownHook(new Thread(super::close));
    }

    public static JuryPartage de(Confinement confinement) {
        return JURYS.computeIfAbsent(confinement.confine, oui -> new JuryPartage(confinement));
    }

    /** D'autres essais s'en servent ensuite. */
    @Override
    public void close() {
        // à la fin de la machine virtuelle
    }
}
