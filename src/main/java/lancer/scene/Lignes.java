package lancer.scene;

import java.io.BufferedReader;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.concurrent.CancellationException;
import java.util.function.DoubleConsumer;
import lancer.texte.Texte;

/**
 * Un fichier UTF-8 donné ligne par ligne : ini4j lit une ligne à la fois, et le numéro de la dernière donnée est donc
 * celui de la ligne qu'il traite. Le fichier n'est jamais tout entier en mémoire. Une ligne de commentaire est donnée
 * vide, sans quoi ini4j garderait tous ceux qui se suivent. Un caractère de contrôle est donné par son code, comme
 * {@link Texte} le montre : ini4j le ferait disparaître au bout d'une clé ou d'une valeur.
 */
final class Lignes extends Reader {

    /** Plus longue ligne, en octets et en caractères : de quoi s'arrêter devant {@code /dev/zero}, qui n'en a pas. */
    static final int LIGNE_MAX = 1 << 23;

    /** Un caractère par octet : les lignes se coupent avant de se décoder, et chacune est jugée à son tour. */
    private final BufferedReader octets;
    private String brute = "";
    private String ligne = "";
    private int donnes;
    private int numero;
    /** Octets que la ligne en cours a fait lire. */
    private int lusPourElle;

    /** @param aLire la longueur du fichier, en octets ; ce n'est qu'une promesse */
    Lignes(InputStream entree, long aLire, DoubleConsumer suivi) {
        InputStream suivie = new FilterInputStream(entree) {
            private long total;

            @Override
            public int read(byte[] cible, int position, int nombre) throws IOException {
                if (Thread.currentThread().isInterrupted()) {
                    throw new CancellationException("lecture interrompue");
                }
                if (lusPourElle > LIGNE_MAX) {
                    throw new LigneTropLongue();
                }
                int lus = super.read(cible, position, nombre);
                lusPourElle += Math.max(0, lus);
                total += Math.max(0, lus);
                suivi.accept(Math.min(1, (double) total / Math.max(1, aLire)));
                return lus;
            }
        };
        octets = new BufferedReader(new InputStreamReader(suivie, StandardCharsets.ISO_8859_1));
    }

    /** Le numéro de la dernière ligne donnée, à partir de 1. */
    int getNumero() {
        return numero;
    }

    /** La dernière ligne donnée, telle que le fichier l'écrit ; ce qui n'y est pas de l'UTF-8 est remplacé. */
    String getTexte() {
        return ligne.replace("\n", "");
    }

    /**
     * L'autre codage que trahit la dernière ligne donnée, {@code null} si elle peut être de l'UTF-8 : sa marque, au
     * début du fichier, ou les octets nuls de ses lettres, un sur deux en UTF-16, trois sur quatre en UTF-32.
     */
    String autreCodage() {
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
        numero++;
        lusPourElle = 0;
        String lue = octets.readLine();
        if (lue == null) {
            numero--;
            return false;
        }
        brute = lue;
        String texte = estSimple(lue) ? lue : decoder(lue.getBytes(StandardCharsets.ISO_8859_1));
        if (texte.length() > LIGNE_MAX) {
            throw new LigneTropLongue();
        }
        int mot = 0;
        while (mot < texte.length() && (texte.charAt(mot) == ' ' || texte.charAt(mot) == '\t')) {
            mot++;
        }
        boolean commentaire = texte.startsWith(";", mot) || texte.startsWith("#", mot);
        ligne = commentaire ? "\n" : texte + '\n';
        donnes = 0;
        return true;
    }

    /** Dit si cette ligne est toute en ASCII visible. */
    private static boolean estSimple(String lue) {
        for (int i = 0; i < lue.length(); i++) {
            char c = lue.charAt(i);
            if (c < ' ' && c != '\t' || c >= 0x80) {
                return false;
            }
        }
        return true;
    }

    private String decoder(byte[] lue) throws IOException {
        String texte = new String(lue, StandardCharsets.UTF_8);
        ligne = numero == 1 && texte.startsWith("\uFEFF") ? texte.substring(1) : texte;
        donnes = ligne.length();
        if (!Arrays.equals(texte.getBytes(StandardCharsets.UTF_8), lue) || autreCodage() != null) {
            throw new CharacterCodingException();
        }
        StringBuilder s = new StringBuilder();
        for (char c : ligne.toCharArray()) {
            s.append(c >= ' ' || c == '\t' ? String.valueOf(c) : Texte.echappe(String.valueOf(c)));
        }
        return s.toString();
    }

    /** Une ligne que personne n'a pu vouloir. */
    static final class LigneTropLongue extends IOException {
        private static final long serialVersionUID = 1;
    }

    @Override
    public void close() throws IOException {
        octets.close();
    }
}
