package lancer.texte;

import java.io.PrintStream;
import java.io.UnsupportedEncodingException;
import java.nio.charset.Charset;

/** Un flux du programme, dont les messages gardent leurs accents. */
public final class Flux {

    private Flux() {
    }

    /**
     * Ce flux, ou le même en UTF-8 si le codage de la langue du système n'a pas d'accents (C, POSIX).
     *
     * @param propriete celle où Java 18 et suivants nomment son codage, {@code stdout.encoding} ou
     *                  {@code stderr.encoding} ; avant, c'est celui de la langue
     */
    public static PrintStream avecAccents(PrintStream flux, String propriete) {
        Charset codage = Charset.forName(System.getProperty(propriete, Charset.defaultCharset().name()));
        try {
            return codage.newEncoder().canEncode('é') ? flux : new PrintStream(flux, true, "UTF-8");
        } catch (UnsupportedEncodingException e) {
            throw new IllegalStateException(e);
        }
    }
}
