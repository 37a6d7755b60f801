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
import java.lang.reflect.Method;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/**
 * La machine virtuelle où tourne un rendu. Elle ne sait pas ce qu'on vérifie : on lui demande d'appeler une méthode,
 * elle dit ce que la méthode a rendu. Ni valeur attendue, ni verdict, ni secret n'y entre ; ce qu'un rendu peut y
 * falsifier n'est jamais que sa propre réponse.
 *
 * <p>Une demande par ligne : {@code A}, un appel, par son numéro dans {@code lancer.Appels} ; {@code S}, une méthode
 * d'une sonde ; {@code N}, oublier les objets déjà rendus, et dire combien de fils le rendu a laissés.
 */
public final class Execution {

    private final ClassLoader chargeur;
    private final List<Object> objets = new ArrayList<>();
    private final Map<Object, Integer> numeros = new IdentityHashMap<>();

    private Execution(ClassLoader chargeur) {
        this.chargeur = chargeur;
    }

    /** @param args le dossier des classes du rendu */
    public static void main(String[] args) throws IOException {
        PrintStream reponses = new PrintStream(new FileOutputStream(FileDescriptor.out), true, "UTF-8");
        BufferedReader demandes = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        System.setIn(InputStream.nullInputStream());
        // ce qu'un rendu affiche pour se mettre au point ne coûte rien
        PrintStream puits = new PrintStream(OutputStream.nullOutputStream());
        System.setOut(puits);
        System.setErr(puits);
        ClassLoader chargeur = new URLClassLoader(new URL[] {new File(args[0]).toURI().toURL()},
                Execution.class.getClassLoader());
        Thread.currentThread().setContextClassLoader(chargeur);
        Execution execution = new Execution(chargeur);
        for (String ligne = demandes.readLine(); ligne != null; ligne = demandes.readLine()) {
            String[] mots = ligne.split("\t");
            // une seule écriture : un texte du rendu ne peut couper une réponse
            reponses.print(Echange.REPONSE + execution.repondre(mots) + "\n");
            reponses.flush();
        }
        // les fils que le rendu a laissés ne retiennent personne
        Runtime.getRuntime().halt(0);
    }

    private String repondre(String[] mots) {
        if (mots[0].equals("N")) {
            objets.clear();
            numeros.clear();
            return "R\t" + (Thread.currentThread().getThreadGroup().activeCount() - 1);
        }
        try {
            return "R\t" + (mots[0].equals("A") ? appeler(mots)
                    : invoquer("lancer." + mots[1], mots[2], new Class<?>[] {String[].class},
                            (Object) Arrays.copyOfRange(mots, 3, mots.length)));
        } catch (StackOverflowError e) {
            return "D\t" + Echange.protege("appels sans fin (StackOverflowError)" + ou(e));
        } catch (Throwable e) {
            return cause(e);
        }
    }

    private String appeler(String[] mots) throws Throwable {
        Object[] arguments = new Object[mots.length - 2];
        for (int k = 0; k < arguments.length; k++) {
            arguments[k] = decoder(mots[k + 2]);
        }
        Object rendu = invoquer("lancer.Appels", "appeler", new Class<?>[] {int.class, Object[].class},
                Integer.parseInt(mots[1]), arguments);
        StringBuilder texte = new StringBuilder(coder(rendu));
        if (texte.charAt(0) == 'o') {
            for (Object champ : decrire(rendu)) {
                texte.append('\t').append(coder(champ));
            }
        }
        return texte.toString();
    }

    private Object invoquer(String classe, String methode, Class<?>[] types, Object... arguments) throws Throwable {
        try {
            Method appel = Class.forName(classe, true, chargeur).getMethod(methode, types);
            return appel.invoke(null, arguments);
        } catch (InvocationTargetException e) {
            throw e.getCause();
        }
    }

    private Object[] decrire(Object objet) throws Throwable {
        return (Object[]) invoquer("lancer.Appels", "champs", new Class<?>[] {Object.class}, objet);
    }

    private Object decoder(String mot) {
        String suite = mot.substring(1);
        switch (mot.charAt(0)) {
            case 'd':
                return Double.valueOf(suite);
            case 'i':
                return Integer.valueOf(suite);
            case 'o':
                return objets.get(Integer.parseInt(suite));
            case 'l':
                List<Object> liste = new ArrayList<>();
                for (String element : suite.isEmpty() ? new String[0] : suite.split(",")) {
                    liste.add(decoder(element));
                }
                return liste;
            default:
                return null;
        }
    }

    private String coder(Object valeur) throws Throwable {
        if (valeur == null) {
            return "n";
        } else if (valeur instanceof Boolean) {
            return "b" + valeur;
        } else if (valeur instanceof Number) {
            return "d" + ((Number) valeur).doubleValue();
        } else if (valeur instanceof CharSequence) {
            return "s" + Echange.protege(valeur.toString());
        }
        Integer numero = numeros.get(valeur);
        if (numero == null) {
            numero = objets.size();
            numeros.put(valeur, numero);
            objets.add(valeur);
        }
        return "o" + numero + ":" + invoquer("lancer.Appels", "nom", new Class<?>[] {Object.class}, valeur);
    }

    /** Une exception du rendu : son nom, la première ligne de son code ; une faute de compilation, ce qu'elle est. */
    private static String cause(Throwable e) {
        String message = String.valueOf(e.getMessage());
        String nom = e.getClass().getName();
        boolean compile = nom.equals("java.lang.Error") && message.startsWith("Unresolved compilation problem");
        if (compile || e instanceof LinkageError) {
            // une classe dont il n'est rien resté manque à tout ce qui la nomme
            return "C\t" + Echange.protege(ou(e)) + "\t"
                    + (compile ? Echange.protege(message.replaceFirst("^[^\n]*\n", "").trim().split("\n")[0]) : "");
        }
        return "E\t" + Echange.protege(nom.replaceFirst(".*\\.", "") + (e.getMessage() == null ? "" : " : " + message)
                + ou(e));
    }

    private static String ou(Throwable e) {
        for (StackTraceElement ou : e.getStackTrace()) {
            if (ou.getClassName().startsWith("lancer.") && !ou.getClassName().startsWith("lancer.correction.")) {
                return ou.getClassName().matches("lancer\\.(Appels|Sonde).*") ? ", appelé par la vérification"
                        : ", " + ou.getFileName() + ":" + ou.getLineNumber() + " (" + ou.getMethodName() + ")";
            }
        }
        return "";
    }
}
