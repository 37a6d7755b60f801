package lancer.mesures.juge;

import java.io.IOException;

/** Cette scène ne se dit pas dans la langue de POV-Ray : elle n'est pas jugée, et le message dit pourquoi. */
public final class Intraduisible extends IOException {

    private static final long serialVersionUID = 1;

    Intraduisible(String raison) {
        super(raison);
    }
}
