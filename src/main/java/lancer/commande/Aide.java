package lancer.commande;

/** Les textes de {@code --aide} et de {@code --version}. */
public final class Aide {

    private Aide() {
    }

    public static String texte() {
        return "Usage : java -jar target/lancer.jar [options] scenes/scene1.ini\n"
                + "\n"
                + "Dessine une scène par lancer de rayons : dans une fenêtre, ou dans un fichier.\n"
                + "\n"
                + "  --image FICHIER.png      écrit l'image, sans fenêtre ni écran\n"
                + "  --lineaire FICHIER.pfm   écrit les couleurs non limitées (PFM) ; peut aller avec --image\n"
                + "  --taille 800x600         taille de l'image, 1 à 16384 pixels de côté\n"
                + "  --reflets 5              nombre de réflexions d'un rayon, 0 à 1000\n"
                + "  --seuil 0.0009765625     reflets abandonnés sous ce produit des Ks ; 0 : jamais\n"
                + "  --sans Brume,Blinn       sans ces variantes, même si elles sont dans le chemin des classes\n"
                + "  --fils N                 nombre de fils d'exécution, 1 à 1024 ; sans elle, tous les cœurs\n"
                + "  --repeter N              dessine N fois avant d'écrire, pour mesurer\n"
                + "  --statistiques           après l'image, rayons et temps, une ligne « nom: valeur » chacun\n"
                + "  --simple                 les boucles du cours au lieu de la recherche rapide : la même image\n"
                + "  --pixel 421,426          pourquoi ce pixel a sa couleur : contacts, lampes, reflets, terme par\n"
                + "                           terme, jusqu'à « somme R V B = #RRGGBB » ; sans fenêtre ni écran\n"
                + "  --auto erreur=1          choisit reflets, seuil et, s'il est là, anticrénelage : au meilleur\n"
                + "                           prix pour une erreur quadratique moyenne d'un niveau sur 255 au plus,\n"
                + "                           et dit ce qu'il en est, à ± près (vrai 19 fois sur 20) ;\n"
                + "                           --auto temps=0.5s : au plus juste pour ce temps, essais compris.\n"
                + "                           Avec --image ou --lineaire\n"
                + "  --comparer REF.png       compare la scène, ou une autre image, à un PNG ou un PFM : statut 0\n"
                + "                           pareilles, 1 différentes ; --tolerance 1 : l'écart permis, en\n"
                + "                           niveaux sur 255 ; --image : l'image des différences\n"
                + "  --aide, --help, -h       ce texte\n"
                + "  --version                la version\n"
                + "\n"
                + "Une option s'écrit aussi --option=valeur, et l'ordre n'a pas d'importance.\n"
                + "Statut de sortie : 0 fait, 1 la machine n'a pas pu, 2 demande fausse.";
    }

    public static String version() {
        String version = Aide.class.getPackage().getImplementationVersion();
        return "lancer " + (version != null ? version : "(non empaqueté)");
    }
}
