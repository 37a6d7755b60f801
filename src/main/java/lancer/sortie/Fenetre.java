package lancer.sortie;

import java.io.PrintStream;
import lancer.Main;

public final class Fenetre {
    public static void ouvrir(Main main, PrintStream sortie, PrintStream erreur) {
        throw new lancer.commande.Echec(1, "pas d'écran");
    }
}
