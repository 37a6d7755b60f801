package lancer.lecture;

import java.io.IOException;
import java.io.InputStream;
import java.io.Reader;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.concurrent.CancellationException;
import lancer.contrat.Suivi;
import lancer.texte.Texte;

/**
 * Un fichier UTF-8 donné ligne par ligne : ini4j lit une ligne à la fois, et le numéro de la dernière donnée est donc
 * celui de la ligne qu'il traite. Le fichier n'est jamais tout entier en mémoire. Une ligne de commentaire est donnée
 * vide, sans quoi ini4j garderait tous ceux qui se suivent. Un caractère de contrôle est donné par son code, comme
 * {@link Texte} le montre : ini4j le ferait disparaître au bout d'une clé ou d'une valeur.
 */
final class Lignes extends Reader {

    /** Taille des lectures, en octets. */
    private static final int TAMPON = 1 << 16;

    /** Plus longue ligne, en octets et en caractères : de quoi s'arrêter devant {@code /dev/zero}, qui n'en a pas. */
    static final int LIGNE_MAX = 1 << 23;

    private final InputStream entree;
    private final byte[] tampon = new byte[TAMPON];
    private final long aLire;
    private final Suivi suivi;
    private long total;
    private int suivant;
    private int lus;
    /** La ligne en cours : ses octets sans sa fin, ce qui en est donné, et combien l'est déjà. */
    private byte[] octets = new byte[256];
    private int taille;
    private String ligne = "";
    private int donnes;
    private int numero;

    /** @param aLire la longueur du fichier, en octets ; ce n'est qu'une promesse */
    Lignes(InputStream entree, long aLire, Suivi suivi) {
        this.entree = entree;
        this.aLire = aLire;
        this.suivi = suivi;
    }

    /** Le numéro de la dernière ligne donnée, à partir de 1. */
    int getNumero() {
        return numero;
    }

    /** La dernière ligne donnée, telle que le fichier l'écrit ; ce qui n'y est pas de l'UTF-8 est remplacé. */
    String getTexte() {
        return ligne.replace("\n", "");
    }

    /** Vrai si la dernière ligne donnée commence comme un fichier en UTF-16. */
    boolean estUtf16() {
        int marque = taille < 2 ? 0 : (octets[0] & 0xFF) << 8 | octets[1] & 0xFF;
        return numero == 1 && (marque == 0xFEFF || marque == 0xFFFE);
    }

    @Override
    public int read(char[] cible, int position, int nombre) throws IOException {
        if (donnes == ligne.length() && !avancer()) {
            return -1;
        }
        int n = Math.min(nombre, ligne.length() - donnes);
        ligne.getChars(donnes, donnes + n, cible, position);
        donnes += n;
        return n;
    }

    /** Passe à la ligne suivante, fin de ligne comprise (CR, LF ou CRLF, rendue par LF). */
    private boolean avancer() throws IOException {
        int c = octet();
        if (c < 0) {
            return false;
        }
        numero++;
        taille = 0;
        boolean simple = true;
        while (c >= 0 && c != '\n' && c != '\r') {
            simple &= c >= ' ' && c < 0x80 || c == '\t';
            ajouter(c);
            c = octet();
        }
        if (c == '\r') {
            int apres = octet();
            suivant -= apres >= 0 && apres != '\n' ? 1 : 0;
        }
        ajouter('\n');
        taille--;
        donnes = 0;
        ligne = simple ? new String(octets, 0, taille + 1, StandardCharsets.US_ASCII) : decoder();
        int mot = 0;
        while (ligne.charAt(mot) == ' ' || ligne.charAt(mot) == '\t') {
            mot++;
        }
        if (ligne.charAt(mot) == ';' || ligne.charAt(mot) == '#') {
            ligne = "\n";
        }
        return true;
    }

    private int octet() throws IOException {
        if (suivant == lus) {
            if (Thread.currentThread().isInterrupted()) {
                throw new CancellationException("lecture interrompue");
            }
            suivant = 0;
            lus = Math.max(0, entree.read(tampon, 0, TAMPON));
            total += lus;
            suivi.fait(Math.min(1, (double) total / Math.max(1, aLire)));
        }
        return suivant == lus ? -1 : tampon[suivant++] & 0xFF;
    }

    private void ajouter(int octet) throws IOException {
        if (taille > LIGNE_MAX) {
            throw new LigneTropLongue();
        }
        if (taille == octets.length) {
            octets = Arrays.copyOf(octets, 2 * taille);
        }
        octets[taille++] = (byte) octet;
    }

    /** Une ligne qui n'est pas toute en ASCII visible. */
    private String decoder() throws IOException {
        boolean marque = numero == 1 && taille >= 3 && octets[0] == (byte) 0xEF && octets[1] == (byte) 0xBB
                && octets[2] == (byte) 0xBF;
        int debut = marque ? 3 : 0;
        CharBuffer decode;
        try {
            decode = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(octets, debut, taille - debut));
        } catch (CharacterCodingException e) {
            ligne = new String(octets, debut, taille - debut, StandardCharsets.UTF_8);
            throw e;
        }
        StringBuilder s = new StringBuilder();
        while (decode.hasRemaining() && s.length() <= LIGNE_MAX) {
            char c = decode.get();
            if (c >= ' ' || c == '\t') {
                s.append(c);
            } else {
                s.append(Texte.echappe(String.valueOf(c)));
            }
        }
        if (decode.hasRemaining()) {
            throw new LigneTropLongue();
        }
        return s.append('\n').toString();
    }

    /** Une ligne que personne n'a pu vouloir. */
    static final class LigneTropLongue extends IOException {
        private static final long serialVersionUID = 1;
    }

    @Override
    public void close() throws IOException {
        entree.close();
    }
}
