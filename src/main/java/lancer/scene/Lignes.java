package lancer.scene;

import java.io.BufferedReader;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CancellationException;
import java.util.function.DoubleConsumer;
import lancer.texte.Texte;

/**
 * Lecture d'un fichier UTF-8 pour ini4j, une ligne à la fois : le numéro et le texte de la ligne en cours sont connus.
 * Un commentaire devient une ligne vide, car ini4j garderait en mémoire les commentaires qui se suivent. Un caractère
 * de contrôle est remplacé par son code ({@link Texte}), car ini4j l'effacerait au bout d'une clé ou d'une valeur.
 */
final class Lignes extends Reader {

    /** Longueur maximale d'une ligne, en octets : {@code /dev/zero} n'a pas de fin de ligne. */
    static final int LIGNE_MAX = 1 << 23;

    /** Le fichier, où chaque octet est un caractère. */
    private final BufferedReader octets;
    private String ligne = "";
    /** Le nombre de caractères de la ligne qui sont rendus, LF compris. */
    private int rendus = 1;
    private int numero;

    /**
     * @param aLire longueur annoncée du fichier, en octets
     * @param suivi reçoit la part lue, de 0 à 1
     */
    Lignes(InputStream entree, long aLire, DoubleConsumer suivi) {
        octets = new BufferedReader(new InputStreamReader(new Suivi(entree, aLire, suivi),
                StandardCharsets.ISO_8859_1));
    }

    int getNumero() {
        return numero;
    }

    /** La ligne en cours. Un octet qui n'est pas de l'UTF-8 y est remplacé. */
    String getTexte() {
        return ligne;
    }

    @Override
    public int read(char[] cible, int position, int nombre) throws IOException {
        if (rendus > ligne.length() && !avancer()) {
            return -1;
        }
        int n = Math.min(nombre, ligne.length() - rendus);
        ligne.getChars(rendus, rendus + n, cible, position);
        if (n < nombre) {
            cible[position + n++] = '\n';
        }
        rendus += n;
        return n;
    }

    /** Passe à la ligne suivante, qui finit par CR, LF ou CRLF. */
    private boolean avancer() throws IOException {
        numero++;
        String brute = octets.readLine();
        if (brute == null) {
            return false;
        }
        ligne = brute;
        if (!estOrdinaire(brute)) {
            decoder(brute.getBytes(StandardCharsets.ISO_8859_1));
        }
        String mots = ligne.trim();
        rendus = mots.startsWith(";") || mots.startsWith("#") ? ligne.length() : 0;
        return true;
    }

    /** Dit si cette ligne n'a que des lettres sans accent, des blancs et des signes. */
    private static boolean estOrdinaire(String brute) {
        for (int k = 0; k < brute.length(); k++) {
            char c = brute.charAt(k);
            if (c >= 0x7F || c < ' ' && c != '\t') {
                return false;
            }
        }
        return true;
    }

    /** @throws java.nio.charset.CharacterCodingException si ces octets ne sont pas de l'UTF-8 */
    private void decoder(byte[] codes) throws IOException {
        ligne = new String(codes, StandardCharsets.UTF_8);
        StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(codes));
        StringBuilder s = new StringBuilder();
        for (char c : ligne.toCharArray()) {
            s.append(c >= ' ' || c == '\t' ? String.valueOf(c) : Texte.echappe(String.valueOf(c)));
        }
        ligne = s.substring(numero == 1 && ligne.startsWith("\uFEFF") ? 1 : 0);
    }

    @Override
    public void close() throws IOException {
        octets.close();
    }

    static final class LigneTropLongue extends IOException {
        private static final long serialVersionUID = 1;
    }

    /** Les octets du fichier, dont la lecture se dit, s'interrompt, et refuse une ligne sans fin. */
    private static final class Suivi extends FilterInputStream {

        private final long aLire;
        private final DoubleConsumer suivi;
        private long lus;
        /** Le nombre d'octets lus depuis la dernière fin de ligne. */
        private int sansFin;

        Suivi(InputStream entree, long aLire, DoubleConsumer suivi) {
            super(entree);
            this.aLire = aLire;
            this.suivi = suivi;
        }

        @Override
        public int read(byte[] cible, int position, int nombre) throws IOException {
            if (Thread.currentThread().isInterrupted()) {
                throw new CancellationException("lecture interrompue");
            }
            int n = super.read(cible, position, nombre);
            int depuis = 0;
            while (depuis < n && cible[position + n - 1 - depuis] != '\n' && cible[position + n - 1 - depuis] != '\r') {
                depuis++;
            }
            sansFin = depuis < n ? depuis : sansFin + depuis;
            if (sansFin > LIGNE_MAX) {
                throw new LigneTropLongue();
            }
            lus += Math.max(0, n);
            suivi.accept(Math.min(1, (double) lus / Math.max(1, aLire)));
            return n;
        }
    }
}
