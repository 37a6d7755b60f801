package lancer.lecture;

import java.io.IOException;
import java.io.InputStream;
import java.io.Reader;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
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
    private byte[] octets = new byte[TAMPON];
    private int debut;
    private int fin;
    private boolean epuisee;
    private char[] ligne = new char[256];
    private int longueur;
    private int donnes;
    private int numero;
    private String texte;
    private boolean utf16;

    Lignes(InputStream entree) {
        this.entree = entree;
    }

    /** Le numéro de la dernière ligne donnée, à partir de 1. */
    int getNumero() {
        return numero;
    }

    /** La dernière ligne donnée, telle que le fichier l'écrit ; ce qui n'y est pas de l'UTF-8 est remplacé. */
    String getTexte() {
        return texte != null ? texte : new String(ligne, 0, Math.max(0, longueur - 1));
    }

    /** Vrai si la dernière ligne donnée commence comme un fichier en UTF-16. */
    boolean estUtf16() {
        return utf16;
    }

    @Override
    public int read(char[] cible, int position, int nombre) throws IOException {
        if (donnes == longueur && !avancer()) {
            return -1;
        }
        int n = Math.min(nombre, longueur - donnes);
        System.arraycopy(ligne, donnes, cible, position, n);
        donnes += n;
        return n;
    }

    /** Passe à la ligne suivante, fin de ligne comprise (CR, LF ou CRLF, rendue par LF). */
    private boolean avancer() throws IOException {
        int i = debut;
        while (true) {
            if (i == fin) {
                int lus = i - debut;
                if (epuisee || !remplir()) {
                    i = debut + lus;
                    break;
                }
                i = debut + lus;
            }
            if (octets[i] == '\n' || octets[i] == '\r') {
                break;
            }
            i++;
        }
        if (i == debut && i == fin) {
            return false;
        }
        numero++;
        decoder(debut, i);
        debut = i;
        if (debut < fin) {
            boolean retour = octets[debut] == '\r';
            debut++;
            if (retour && (debut < fin || remplir()) && octets[debut] == '\n') {
                debut++;
            }
        }
        return true;
    }

    /** Fait de la place, et lit. Faux à la fin du fichier. */
    private boolean remplir() throws IOException {
        if (debut > 0) {
            System.arraycopy(octets, debut, octets, 0, fin - debut);
            fin -= debut;
            debut = 0;
        } else if (fin == LIGNE_MAX) {
            numero++;
            throw new LigneTropLongue();
        } else if (fin == octets.length) {
            octets = Arrays.copyOf(octets, 2 * octets.length);
        }
        int n = entree.read(octets, fin, octets.length - fin);
        epuisee = n <= 0;
        fin += Math.max(0, n);
        return !epuisee;
    }

    private void decoder(int de, int a) throws IOException {
        int i = de;
        if (numero == 1 && a - i >= 3 && octets[i] == (byte) 0xEF && octets[i + 1] == (byte) 0xBB
                && octets[i + 2] == (byte) 0xBF) {
            i += 3;
        }
        if (ligne.length <= a - i) {
            ligne = new char[2 * (a - i)];
        }
        longueur = 0;
        donnes = 0;
        int premier = i;
        while (i < a && (octets[i] >= ' ' || octets[i] == '\t')) {
            ligne[longueur++] = (char) octets[i++];
        }
        if (i < a) {
            decoderTout(premier, a);
        }
        int mot = 0;
        while (mot < longueur && ligne[mot] <= ' ') {
            mot++;
        }
        if (mot < longueur && (ligne[mot] == ';' || ligne[mot] == '#')) {
            longueur = 0;
        }
        ligne[longueur++] = '\n';
    }

    /** Une ligne qui n'est pas toute en ASCII visible. */
    private void decoderTout(int de, int a) throws IOException {
        CharBuffer decode;
        try {
            decode = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(octets, de, a - de));
        } catch (CharacterCodingException e) {
            int marque = a - de < 2 ? 0 : (octets[de] & 0xFF) << 8 | octets[de + 1] & 0xFF;
            utf16 = numero == 1 && (marque == 0xFEFF || marque == 0xFFFE);
            texte = new String(octets, de, a - de, StandardCharsets.UTF_8);
            throw e;
        }
        longueur = 0;
        while (decode.hasRemaining()) {
            char c = decode.get();
            if (longueur + 7 > LIGNE_MAX) {
                throw new LigneTropLongue();
            }
            if (longueur + 7 > ligne.length) {
                ligne = Arrays.copyOf(ligne, 2 * ligne.length);
            }
            if (c >= ' ' || c == '\t') {
                ligne[longueur++] = c;
            } else {
                String code = Texte.echappe(String.valueOf(c));
                code.getChars(0, code.length(), ligne, longueur);
                longueur += code.length();
            }
        }
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
