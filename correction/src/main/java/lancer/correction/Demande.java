package lancer.correction;

import java.nio.file.Path;
import java.nio.file.Paths;

/** La ligne de commande. */
final class Demande {

    static final String AIDE = "Usage : java -jar correction/target/correction.jar [options] RENDUS\n"
            + "        java -jar correction/target/correction.jar --squelette DOSSIER\n"
            + "        java -jar correction/target/correction.jar --corrige DOSSIER [--variante brume]\n"
            + "\n"
            + "Note les rendus d'une classe : un dossier, l'archive « Télécharger tous les travaux remis » de "
            + "Moodle, ou un seul rendu.\n"
            + "\n"
            + "  --notes FEUILLE.csv     la feuille de notes de Moodle : écrit notes-a-deposer.csv et retours.zip\n"
            + "  --sortie DOSSIER        où écrire les pages et les fichiers (par défaut correction/classe)\n"
            + "  --bareme FICHIER.ini    les points de chaque étape (par défaut bareme.ini, dans ce dossier ; écrit "
            + "s'il n'existe pas)\n"
            + "  --sans-confinement      exécute le code des étudiants même si bwrap manque : il peut alors lire et "
            + "écrire vos fichiers\n"
            + "  --squelette DOSSIER     écrit le projet à compléter\n"
            + "  --corrige DOSSIER       écrit le projet achevé, ou la copie d'une extension : --variante brume, "
            + "antialias ou blinn\n"
            + "  --aide                  ce texte\n"
            + "\n"
            + "Statut de sortie : 0 fait, 1 la machine n'a pas pu, 2 demande fausse.";

    boolean aide;
    String squelette;
    String corrige;
    String variante = "";
    Path rendus;
    Path notes;
    Path sortie = Paths.get("correction", "classe");
    Path bareme;
    boolean sansConfinement;

    /** @throws Panne si un argument ne va pas */
    static Demande lire(String[] arguments) {
        Demande demande = new Demande();
        for (int k = 0; k < arguments.length; k++) {
            String nom = arguments[k];
            switch (nom) {
                case "--aide":
                case "--help":
                case "-h":
                    demande.aide = true;
                    return demande;
                case "--sans-confinement":
                    demande.sansConfinement = true;
                    break;
                case "--notes":
                    demande.notes = Paths.get(valeur(arguments, ++k));
                    break;
                case "--sortie":
                    demande.sortie = Paths.get(valeur(arguments, ++k));
                    break;
                case "--bareme":
                    demande.bareme = Paths.get(valeur(arguments, ++k));
                    break;
                case "--corrige":
                    demande.corrige = valeur(arguments, ++k);
                    break;
                case "--variante":
                    demande.variante = valeur(arguments, ++k);
                    break;
                case "--squelette":
                    demande.squelette = valeur(arguments, ++k);
                    break;
                default:
                    if (nom.startsWith("-")) {
                        throw new Panne(2, "option inconnue : « " + nom
                                + " » ; attendu : une de celles que montre --aide");
                    }
                    if (demande.rendus != null) {
                        throw new Panne(2, "plusieurs rendus : « " + demande.rendus + " » et « " + nom
                                + " » ; attendu : un dossier, ou une archive");
                    }
                    demande.rendus = Paths.get(nom);
            }
        }
        if (demande.squelette == null && demande.corrige == null && demande.rendus == null) {
            throw new Panne(2, "aucun rendu à noter ; attendu : un dossier, ou l'archive de Moodle");
        }
        return demande;
    }

    private static String valeur(String[] arguments, int k) {
        if (k >= arguments.length || arguments[k].isEmpty()) {
            throw new Panne(2, "option sans sa valeur : " + arguments[k - 1]);
        }
        return arguments[k];
    }
}
