package lancer.scene;

import java.io.BufferedReader;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
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

    /** Un octet, un caractère : un octet qui n'est pas de l'UTF-8 ne cache pas sa ligne. */
    private final BufferedReader octets;
    private int octetsDepuisLaLigne;
    private int numero;
    /** La ligne en cours, et le nombre de ses caractères qui sont rendus, LF compris. */
    private String ligne = "";
    private int rendus = 1;

    /**
     * @param aLire longueur annoncée du fichier, en octets
     * @param suivi reçoit la part lue, de 0 à 1
     */
    Lignes(InputStream entree, long aLire, DoubleConsumer suivi) {
        octets = new BufferedReader(new InputStreamReader(new FilterInputStream(entree) {
            private double total;

            @Override
            public int read(byte[] tampon, int debut, int nombre) throws IOException {
                Recherche.obeir();
                int lus = super.read(tampon, debut, nombre);
                total += Math.max(0, lus);
                octetsDepuisLaLigne += lus;
                if (octetsDepuisLaLigne > LIGNE_MAX) {
                    throw new IOException("ligne de plus de " + (LIGNE_MAX >> 20) + " Mo");
                }
                suivi.accept(Math.min(1, total / Math.max(1, aLire)));
                return lus;
            }
        }, StandardCharsets.ISO_8859_1));
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
        octetsDepuisLaLigne = 0;
        String lue = octets.readLine();
        if (lue == null) {
            return false;
        }
        ligne = lue;
        boolean ordinaire = true;
        for (int k = 0; k < lue.length(); k++) {
            ordinaire &= lue.charAt(k) < '\u0080' && !estUnControle(lue.charAt(k));
        }
        if (!ordinaire) {
            coder(lue.getBytes(StandardCharsets.ISO_8859_1));
        }
        String mots = ligne.trim();
        rendus = mots.startsWith(";") || mots.startsWith("#") ? ligne.length() : 0;
        return true;
    }

    private static boolean estUnControle(char c) {
        return c < ' ' && c != '\t';
    }

    /** Décode la ligne, ôte la marque UTF-8 du fichier, et remplace les caractères de contrôle. */
    private void coder(byte[] codes) throws IOException {
        ligne = new String(codes, StandardCharsets.UTF_8);
        StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(codes));
        StringBuilder s = new StringBuilder();
        for (char c : ligne.toCharArray()) {
            s.append(estUnControle(c) ? Texte.echappe(String.valueOf(c)) : String.valueOf(c));
        }
        ligne = s.substring(numero == 1 && ligne.startsWith("\uFEFF") ? 1 : 0);
    }

    @Override
    public void close() throws IOException {
        octets.close();
    }
}
