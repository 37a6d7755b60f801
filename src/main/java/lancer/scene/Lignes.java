package lancer.scene;

import java.io.IOException;
import java.io.InputStream;
import java.io.Reader;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.function.DoubleConsumer;
import lancer.contrat.Recherche;
import lancer.texte.Texte;

/**
 * Lecture d'un fichier UTF-8 pour ini4j, une ligne à la fois : le numéro et le texte de la ligne en cours sont connus.
 * Un commentaire devient une ligne vide, car ini4j garderait en mémoire les commentaires qui se suivent. Un caractère
 * de contrôle est remplacé par son code ({@link Texte}), car ini4j l'effacerait au bout d'une clé ou d'une valeur.
 */
final class Lignes extends Reader {

    /** Longueur maximale d'une ligne, en octets : {@code /dev/zero} n'a pas de fin de ligne. */
    private static final int LIGNE_MAX = 1 << 23;

    /** Ce que rend {@link #suivant} à la fin du fichier. */
    private static final int FIN = Integer.MAX_VALUE;

    private final InputStream entree;
    private final long aLire;
    private final DoubleConsumer suivi;
    /** Tampon ; nombre d'octets qu'il contient, et de ceux qui ont servi. */
    private final byte[] tampon = new byte[1 << 14];
    private int lus;
    private int servis;
    private long total;
    /** Les octets de la ligne en cours, son texte, et le nombre de ses caractères qui sont rendus, LF compris. */
    private byte[] octets = new byte[1 << 8];
    private String ligne = "";
    private int rendus = 1;
    private int numero;

    /**
     * @param aLire longueur annoncée du fichier, en octets
     * @param suivi reçoit la part lue, de 0 à 1
     */
    Lignes(InputStream entree, long aLire, DoubleConsumer suivi) {
        this.entree = entree;
        this.aLire = aLire;
        this.suivi = suivi;
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
        int n = 0;
        boolean ordinaire = true;
        int c = suivant();
        if (c == FIN) {
            return false;
        }
        for (; c != FIN && c != '\n' && c != '\r'; c = suivant()) {
            if (n == octets.length) {
                if (n == LIGNE_MAX) {
                    throw new IOException("ligne de plus de " + (LIGNE_MAX >> 20) + " Mo");
                }
                octets = Arrays.copyOf(octets, 2 * n);
            }
            // un octet négatif est celui d'un caractère qui n'est pas de l'ASCII
            ordinaire &= c >= ' ' || c == '\t';
            octets[n++] = (byte) c;
        }
        int apres = c == '\r' ? suivant() : FIN;
        if (apres != FIN && apres != '\n') {
            servis--;
        }
        ligne = new String(octets, 0, n, StandardCharsets.UTF_8);
        if (!ordinaire) {
            StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(octets, 0, n));
            coder();
        }
        String mots = ligne.trim();
        rendus = mots.startsWith(";") || mots.startsWith("#") ? ligne.length() : 0;
        return true;
    }

    /** Ôte la marque UTF-8 du fichier, et remplace les caractères de contrôle. */
    private void coder() {
        StringBuilder s = new StringBuilder();
        for (char c : ligne.toCharArray()) {
            s.append(c >= ' ' || c == '\t' ? String.valueOf(c) : Texte.echappe(String.valueOf(c)));
        }
        ligne = s.substring(numero == 1 && ligne.startsWith("\uFEFF") ? 1 : 0);
    }

    /** L'octet suivant du fichier. */
    private int suivant() throws IOException {
        if (servis == lus) {
            Recherche.obeir();
            lus = Math.max(0, entree.read(tampon));
            servis = 0;
            total += lus;
            suivi.accept(Math.min(1, (double) total / Math.max(1, aLire)));
        }
        return servis < lus ? tampon[servis++] : FIN;
    }

    @Override
    public void close() throws IOException {
        entree.close();
    }
}
