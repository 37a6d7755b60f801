package lancer.systeme;

import java.io.File;
import java.io.PrintStream;
import java.io.UnsupportedEncodingException;
import java.nio.charset.Charset;
import java.nio.charset.CharsetEncoder;

/** Ce que la console de ce système sait montrer, et ce que son interpréteur de commandes accepte. */
public final class Console {

    public static final boolean WINDOWS = File.separatorChar == '\\';

    private Console() {
    }

    /**
     * Ce flux, ou le même en UTF-8 si le codage de la langue du système n'a pas d'accents (C, POSIX).
     *
     * @param propriete celle où Java 18 et suivants nomment son codage, {@code stdout.encoding} ou
     *                  {@code stderr.encoding} ; avant, c'est celui de la langue
     */
    public static PrintStream avecAccents(PrintStream flux, String propriete) {
        Charset codage = Charset.forName(System.getProperty(propriete, Charset.defaultCharset().name()));
        return codage.newEncoder().canEncode('é') ? flux : enUtf8(flux);
    }

    private static PrintStream enUtf8(PrintStream flux) {
        try {
            return new PrintStream(flux, true, "UTF-8");
        } catch (UnsupportedEncodingException e) {
            throw new IllegalStateException(e);
        }
    }

    /**
     * Ce qui écrit un récit sur la sortie standard : en UTF-8 quelle que soit la langue, mais sous Windows dans le
     * codage de la console.
     */
    public static PrintStream pourUnRecit(PrintStream sortie) {
        return WINDOWS ? sortie : enUtf8(sortie);
    }

    /** Ce texte, pour {@link #pourUnRecit}. */
    public static String recit(String texte) {
        return WINDOWS ? avecSignesVoisins(texte, codageDeLaSortie()) : texte;
    }

    /** Le codage de la sortie standard : Java 18 et suivants le nomment, comme Java 8 à 17 celui d'une console. */
    private static Charset codageDeLaSortie() {
        String nom = System.getProperty("stdout.encoding", System.getProperty("sun.stdout.encoding"));
        return nom == null ? Charset.defaultCharset() : Charset.forName(nom);
    }

    /** Ce texte, où un signe que ce codage n'a pas est remplacé par un signe voisin, × ou -. */
    static String avecSignesVoisins(String texte, Charset codage) {
        CharsetEncoder codeur = codage.newEncoder();
        return remplacer(remplacer(texte, '⊗', '×', codeur), '−', '-', codeur);
    }

    private static String remplacer(String texte, char signe, char voisin, CharsetEncoder codeur) {
        return codeur.canEncode(signe) ? texte : texte.replace(signe, voisin);
    }

    /** Ce mot d'une commande, entre guillemets s'il le faut : sh, ou cmd et PowerShell, l'acceptent tel quel. */
    public static String mot(String mot) {
        return WINDOWS ? motWindows(mot) : motUnix(mot);
    }

    static String motUnix(String mot) {
        return mot.matches("[\\w./:,+-]+") ? mot : "'" + mot.replace("'", "'\\''") + "'";
    }

    /** PowerShell coupe un mot à sa virgule ou à son point-virgule. Un nom n'y a pas de guillemet. */
    static String motWindows(String mot) {
        return mot.matches("[\\w./\\\\:+-]+") ? mot : '"' + mot + '"';
    }
}
