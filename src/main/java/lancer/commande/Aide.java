package lancer.commande;

import java.util.Scanner;

/** Les textes de {@code --aide} et de {@code --version}. */
public final class Aide {

    private Aide() {
    }

    public static String texte() {
        try (Scanner aide = new Scanner(Aide.class.getResourceAsStream("aide.txt"), "UTF-8")) {
            return aide.useDelimiter("\\n\\z").next();
        }
    }

    public static String version() {
        String version = Aide.class.getPackage().getImplementationVersion();
        return "lancer " + (version != null ? version : "(non empaqueté)");
    }
}
