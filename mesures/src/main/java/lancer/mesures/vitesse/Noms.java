package lancer.mesures.vitesse;

import lancer.mesures.Verite;

/** Comment écrire dans une phrase, ou près d'un point, ce que le CSV nomme sèchement. */
final class Noms {

    private Noms() {
    }

    /** Un nom de scène en tête de phrase. */
    static String scene(String scene) {
        return scene.equals("scene1") ? "Scène du cours" : Character.toUpperCase(scene.charAt(0)) + scene.substring(1);
    }

    /** Dans une phrase. */
    static String methode(Releve r) {
        switch (r.methode) {
            case Catalogue.GRILLE:
                return "la grille " + r.parametres;
            case Catalogue.UN_RAYON:
                return "un rayon par pixel";
            case Catalogue.BROUILLON:
                return "le brouillon";
            case Catalogue.PROFONDEUR:
                return "la profondeur " + valeur(r, "p");
            case Catalogue.SEUIL:
                return "le seuil " + valeur(r, "seuil");
            default:
                return "« " + r.methode + " » (" + etiquette(r) + ")";
        }
    }

    /** Près d'un point. */
    static String etiquette(Releve r) {
        switch (r.methode) {
            case Catalogue.UN_RAYON:
                return "1 rayon";
            case Catalogue.BROUILLON:
                return "brouillon";
            case Catalogue.COINS:
            case Catalogue.PARTAGE:
                return valeur(r, "n") + " ; " + valeur(r, "seuil").replace('.', ',');
            case Catalogue.PROFONDEUR:
                return valeur(r, "p");
            case Catalogue.SEUIL:
                return valeur(r, "seuil");
            default:
                return r.parametres;
        }
    }

    /** La valeur d'un paramètre « nom=valeur ». */
    static String valeur(Releve r, String nom) {
        for (String mot : r.parametres.split(" ")) {
            if (mot.startsWith(nom + "=")) {
                return mot.substring(nom.length() + 1);
            }
        }
        throw new IllegalArgumentException("pas de " + nom + " dans « " + r.parametres + " »");
    }

    /** Une série, pour la légende. */
    static String serie(String methode) {
        switch (methode) {
            case Catalogue.GRILLE:
                return "grille complète";
            case Catalogue.UN_RAYON:
                return "un rayon";
            case Catalogue.COINS:
                return "« coins » (n ; seuil)";
            case Catalogue.PARTAGE:
                return "« partage » (n ; seuil)";
            case Catalogue.PROFONDEUR:
                return "profondeur (seuil 1/1024)";
            case Catalogue.SEUIL:
                return "seuil (profondeur " + Verite.PROFONDEUR + ")";
            default:
                return methode;
        }
    }
}
