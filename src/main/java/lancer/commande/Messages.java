package lancer.commande;

import java.io.File;
import java.io.PrintStream;
import lancer.SceneFautive;
import lancer.contrat.Cause;
import lancer.systeme.Console;
import lancer.systeme.Echec;
import lancer.texte.Texte;

/** Messages et statuts de sortie. Chaque message tient en une ligne, quel que soit son contenu. */
public final class Messages {

    private Messages() {
    }

    /** Écrit cet échec en une ligne. @return le statut de sortie */
    public static int dire(Throwable echec, PrintStream erreur) {
        avertir(message(echec), erreur);
        if (echec instanceof Echec) {
            return ((Echec) echec).code;
        }
        return echec instanceof SceneFautive ? Echec.DEMANDE : Echec.MACHINE;
    }

    public static String message(Throwable echec) {
        if (echec instanceof Echec || echec instanceof SceneFautive) {
            return echec.getMessage();
        }
        if (echec instanceof OutOfMemoryError) {
            // Java lève la même erreur pour deux manques
            return String.valueOf(echec.getMessage()).contains("native thread")
                    ? "trop de fils d'exécution pour cette machine ; en demander moins, par exemple --fils 2"
                    : "mémoire épuisée ; donner plus à Java, par exemple java -Xmx2g -jar …";
        }
        return "échec du programme : " + Cause.dire(echec);
    }

    public static void avertir(String ligne, PrintStream erreur) {
        erreur.println("lancer : " + Texte.echappe(ligne));
    }

    /** Écrit une réponse sur la sortie standard. @throws Echec si elle n'a pu être écrite */
    public static void repondre(String texte, PrintStream sortie) {
        sortie.println(texte);
        // un PrintStream ne lève pas d'exception
        if (sortie.checkError()) {
            throw Echec.machine("sortie standard : écriture impossible");
        }
    }

    /** La commande qui dessine cette scène. @param options chacune après un blanc */
    public static String commande(String options, String scene) {
        String chemin = System.getProperty("java.class.path");
        String programme = chemin.endsWith(".jar") && !chemin.contains(File.pathSeparator)
                ? "java -jar " + Console.mot(chemin) : "java -cp " + Console.mot(chemin) + " lancer.Main";
        return programme + options + ' ' + Console.mot(scene);
    }
}
