package lancer.scene;

import java.io.IOException;
import java.io.InputStream;
import java.io.Reader;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.concurrent.CancellationException;
import java.util.function.DoubleConsumer;
import lancer.texte.Texte;

/**
 * Lecture d'un fichier UTF-8 pour ini4j, une ligne à la fois en mémoire. Un commentaire devient une ligne vide, car
 * ini4j garderait en mémoire les commentaires qui se suivent. Un caractère de contrôle est remplacé par son code
 * ({@link Texte}), car ini4j l'effacerait au bout d'une clé ou d'une valeur.
 */
final class Lignes extends Reader {

    /** Longueur maximale d'une ligne, en octets et en caractères : {@code /dev/zero} n'a pas de fin de ligne. */
    static final int LIGNE_MAX = 1 << 23;

    private final InputStream entree;
    private final long aLire;
    private final DoubleConsumer suivi;
    /** Tampon ; nombre d'octets lus ; début de la ligne en cours ; sa longueur, sans puis avec sa fin. */
    private byte[] octets = new byte[1 << 14];
    private int lus;
    private int debut;
    private int longueur;
    private int occupes;
    private boolean controles;
    /** La ligne en cours ; le nombre de ses caractères qui sont rendus, LF compris. */
    private String ligne = "";
    private int rendus = 1;
    private int numero;
    private long total;

    /** @param aLire longueur annoncée du fichier, en octets */
    Lignes(InputStream entree, long aLire, DoubleConsumer suivi) {
        this.entree = entree;
        this.aLire = aLire;
        this.suivi = suivi;
    }

    int getNumero() {
        return numero;
    }

    /** La ligne en cours, comme dans le fichier. Un octet qui n'est pas de l'UTF-8 est remplacé. */
    String getTexte() {
        return ligne;
    }

    /** Autre codage probable : une marque, ou un octet nul sur deux (UTF-16) ou trois sur quatre (UTF-32). */
    String autreCodage() {
        String brute = new String(octets, debut, longueur, StandardCharsets.ISO_8859_1);
        boolean marque16 = brute.startsWith("\u00FE\u00FF") || brute.startsWith("\u00FF\u00FE");
        boolean marque32 = brute.startsWith("\u00FF\u00FE\0\0") || brute.startsWith("\0\0\u00FE\u00FF");
        int nuls = brute.length() - brute.replace("\0", "").length();
        double part = (double) nuls / brute.length();
        boolean parlants = brute.length() >= 4 && part > 0.35 && part < 0.9;
        return numero == 1 && marque32 || parlants && part > 0.6 ? "UTF-32"
                : numero == 1 && marque16 || parlants ? "UTF-16" : null;
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

    /** Passe à la ligne suivante, et la décode. */
    private boolean avancer() throws IOException {
        numero++;
        if (!couper()) {
            return false;
        }
        ligne = new String(octets, debut, longueur, StandardCharsets.UTF_8);
        // un octet qui n'est pas de l'UTF-8 devient U+FFFD, que le fichier peut aussi contenir
        boolean fausse = ligne.indexOf('\uFFFD') >= 0 && !Arrays.equals(ligne.getBytes(StandardCharsets.UTF_8),
                Arrays.copyOfRange(octets, debut, debut + longueur));
        ligne = numero == 1 && ligne.startsWith("\uFEFF") ? ligne.substring(1) : ligne;
        if (fausse || controles && autreCodage() != null) {
            throw new CharacterCodingException();
        }
        if (controles) {
            StringBuilder s = new StringBuilder();
            for (char c : ligne.toCharArray()) {
                s.append(c >= ' ' || c == '\t' ? String.valueOf(c) : Texte.echappe(String.valueOf(c)));
            }
            ligne = s.toString();
        }
        if (ligne.length() > LIGNE_MAX) {
            throw new LigneTropLongue();
        }
        String mots = ligne.trim();
        rendus = mots.startsWith(";") || mots.startsWith("#") ? ligne.length() : 0;
        return true;
    }

    /** Cherche la fin de la ligne suivante : CR, LF ou CRLF. */
    private boolean couper() throws IOException {
        debut += occupes;
        controles = false;
        int n = 0;
        for (; (debut + n < lus || remplir()) && octets[debut + n] != '\n' && octets[debut + n] != '\r'; n++) {
            controles |= octets[debut + n] >= 0 && octets[debut + n] < ' ' && octets[debut + n] != '\t';
        }
        longueur = n;
        if (debut + n < lus && octets[debut + n++] == '\r' && (debut + n < lus || remplir())
                && octets[debut + n] == '\n') {
            n++;
        }
        occupes = n;
        return n > 0;
    }

    /** Lit la suite du fichier dans le tampon, après la ligne en cours. */
    private boolean remplir() throws IOException {
        if (Thread.currentThread().isInterrupted()) {
            throw new CancellationException("lecture interrompue");
        }
        lus -= debut;
        if (lus > LIGNE_MAX) {
            throw new LigneTropLongue();
        }
        byte[] place = lus < octets.length ? octets : new byte[2 * lus];
        System.arraycopy(octets, debut, place, 0, lus);
        octets = place;
        debut = 0;
        int n = Math.max(0, entree.read(octets, lus, octets.length - lus));
        lus += n;
        total += n;
        suivi.accept(Math.min(1, (double) total / Math.max(1, aLire)));
        return n > 0;
    }

    static final class LigneTropLongue extends IOException {
        private static final long serialVersionUID = 1;
    }

    @Override
    public void close() throws IOException {
        entree.close();
    }
}
