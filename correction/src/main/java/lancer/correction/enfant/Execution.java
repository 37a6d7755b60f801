package lancer.correction.enfant;

import java.io.BufferedReader;
import java.io.File;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.PrintStream;
import java.lang.reflect.InvocationTargetException;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;

/**
 * La machine virtuelle où tourne un rendu. La première ligne de l'entrée est un mot de passe que le rendu ne connaît
 * pas ; chaque réponse le porte, de sorte qu'un texte qui imite les nôtres n'en est pas une. Chaque demande nomme un
 * dossier de classes : {@code L}, la liste des vérifications ; {@code T}, une vérification ; {@code S}, une méthode
 * d'une sonde.
 */
public final class Execution {

    private Execution() {
    }

    public static void main(String[] args) throws IOException {
        PrintStream reponses = new PrintStream(new FileOutputStream(FileDescriptor.out), true, "UTF-8");
        BufferedReader demandes = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        String motDePasse = demandes.readLine();
        System.setIn(InputStream.nullInputStream());
        PrintStream puits = new PrintStream(new Puits(), true);
        System.setOut(puits);
        System.setErr(puits);
        Map<String, ClassLoader> chargeurs = new HashMap<>();
        for (String ligne = demandes.readLine(); ligne != null; ligne = demandes.readLine()) {
            String[] mots = ligne.split("\t");
            ClassLoader chargeur = chargeurs.computeIfAbsent(mots[1], Execution::chargeur);
            Thread.currentThread().setContextClassLoader(chargeur);
            reponses.println(motDePasse + "\t" + repondre(mots, chargeur));
        }
        // les fils que le rendu a laissés ne retiennent personne
        Runtime.getRuntime().halt(0);
    }

    private static String repondre(String[] mots, ClassLoader chargeur) {
        try {
            switch (mots[0]) {
                case "L":
                    return Verifications.liste(chargeur);
                case "T":
                    return Verifications.lancer(chargeur, mots[2], mots[3]);
                default:
                    return "REPONSE\t" + sonde(chargeur, mots);
            }
        } catch (OutOfMemoryError e) {
            return "ECHEC\tmémoire épuisée";
        } catch (Throwable e) {
            return "ECHEC\t" + Verifications.cause(e);
        }
    }

    /** Appelle {@code lancer.<sonde>.<méthode>(String...)}. */
    private static String sonde(ClassLoader chargeur, String[] mots) throws Throwable {
        String[] arguments = new String[mots.length - 4];
        System.arraycopy(mots, 4, arguments, 0, arguments.length);
        try {
            Class<?> sonde = Class.forName("lancer." + mots[2], true, chargeur);
            return (String) sonde.getMethod(mots[3], String[].class).invoke(null, (Object) arguments);
        } catch (InvocationTargetException e) {
            throw e.getCause();
        }
    }

    private static ClassLoader chargeur(String dossier) {
        try {
            return new URLClassLoader(new URL[] {new File(dossier).toURI().toURL()}, Execution.class.getClassLoader());
        } catch (MalformedURLException e) {
            throw new IllegalArgumentException(e);
        }
    }

    /** Où va ce que le rendu imprime : nulle part, et pas sans fin. */
    private static final class Puits extends OutputStream {

        private long octets;

        @Override
        public void write(int b) {
            compter(1);
        }

        @Override
        public void write(byte[] tampon, int debut, int longueur) {
            compter(longueur);
        }

        private synchronized void compter(int n) {
            octets += n;
            if (octets > Echange.IMPRESSION_MAX) {
                Runtime.getRuntime().halt(Echange.TROP_IMPRIME);
            }
        }
    }
}
