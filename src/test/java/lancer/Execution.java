package lancer;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.io.UnsupportedEncodingException;

/** Le programme entier, lancé dans la machine virtuelle des tests : ce qu'il écrit, et son statut. */
final class Execution {

    final int statut;
    final String sortie;
    final String erreur;

    private Execution(int statut, String sortie, String erreur) {
        this.statut = statut;
        this.sortie = sortie;
        this.erreur = erreur;
    }

    static Execution de(String... arguments) {
        ByteArrayOutputStream sortie = new ByteArrayOutputStream();
        ByteArrayOutputStream erreur = new ByteArrayOutputStream();
        try {
            int statut = Main.executer(arguments, new PrintStream(sortie, true, "UTF-8"), new PrintStream(erreur, true, "UTF-8"));
            return new Execution(statut, sortie.toString("UTF-8"), erreur.toString("UTF-8"));
        } catch (UnsupportedEncodingException e) {
            throw new IllegalStateException(e);
        }
    }

    /** De quoi comprendre un test qui échoue. */
    @Override
    public String toString() {
        return "statut " + statut + ", sortie « " + sortie + " », erreur « " + erreur + " »";
    }
}
