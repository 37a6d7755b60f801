package lancer.mesures.vitesse;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lancer.mesures.FichierCsv;
import lancer.mesures.Intervalle;

/** Mesures d'une méthode sur une scène : ses temps, ses rayons et son erreur. Un nombre qui manque est vide dans un CSV, et ici NaN. */
final class Releve {

    static final List<String> COLONNES = Arrays.asList("machine", "coeurs", "jvm", "date", "commit", "famille", "scene", "spheres",
            "methode", "parametres", "largeur", "hauteur", "fils", "primaires", "ombre", "reflechis", "tests", "noeuds",
            "raffines", "pixels_verifies", "lancements", "manches", "jetees", "reference_ms", "rapport", "rapport_min", "rapport_max",
            "processeur_ms", "processeur_rapport", "processeur_min", "processeur_max", "memoire_mo", "memoire_rapport", "memoire_min",
            "memoire_max");

    final String famille;
    final String scene;
    final String methode;
    final String parametres;
    private final Map<String, String> champs;

    /** @param champs par nom de colonne */
    Releve(Map<String, String> champs) {
        this.champs = champs;
        famille = texte("famille");
        scene = texte("scene");
        methode = texte("methode");
        parametres = texte("parametres");
    }

    /** @param paires des noms de colonnes, chacun suivi de ce qu'il vaut */
    static Map<String, String> champs(Object... paires) {
        return IntStream.range(0, paires.length / 2).boxed()
                .collect(Collectors.toMap(k -> (String) paires[2 * k], k -> paires[2 * k + 1].toString()));
    }

    /** Nom qui la distingue des autres d'une même scène, en clair. */
    String nom() {
        return (methode + " " + parametres).trim();
    }

    static String reel(double valeur) {
        return Double.isNaN(valeur) || Double.isInfinite(valeur) ? "" : valeur == 0 ? "0" : String.format(Locale.ROOT, "%.5g", valeur);
    }

    String texte(String colonne) {
        return champs.getOrDefault(colonne, "");
    }

    /** Circonstances de la mesure. */
    String circonstances() {
        return texte("machine") + ", " + texte("coeurs") + " cœurs, " + texte("jvm") + ", commit " + texte("commit") + ", "
                + texte("date").replace('T', ' ');
    }

    /** NaN si le champ est vide. */
    double nombre(String colonne) {
        String texte = texte(colonne);
        return texte.isEmpty() ? Double.NaN : Double.parseDouble(texte);
    }

    /** Rapport du temps à celui de la référence ; sans bornes si l'on n'a qu'une manche. */
    Intervalle rapport() {
        double max = nombre("rapport_max");
        return new Intervalle(nombre("rapport"), Double.isNaN(max) ? 0 : nombre("rapport_min"),
                Double.isNaN(max) ? Double.POSITIVE_INFINITY : max);
    }

    /** Erreur en niveaux. */
    Intervalle erreur() {
        return new Intervalle(nombre("erreur"), nombre("erreur_min"), nombre("erreur_max"));
    }

    /** Rayons de toutes sortes, d'une image. */
    double rayons() {
        return texte("rayons").isEmpty() ? nombre("primaires") + nombre("ombre") + nombre("reflechis") : nombre("rayons");
    }

    /** Ces champs-là, dans un CSV. */
    String ligne(List<String> colonnes) {
        return FichierCsv.ligne(colonnes.stream().map(this::texte).toArray());
    }

    /** Les mêmes mesures que celui-ci, et celles d'un autre ; là où ils diffèrent, les siennes. */
    Releve avec(Releve autre) {
        Map<String, String> tous = new HashMap<>(champs);
        tous.putAll(autre.champs);
        return new Releve(tous);
    }

    /** Vrai si l'autre est de la même méthode, au même réglage, en une image de même taille. */
    boolean estLeMeme(Releve autre) {
        return Stream.of("famille", "scene", "methode", "parametres", "largeur", "hauteur").allMatch(c -> texte(c).equals(autre.texte(c)));
    }

    /** Vrai si celui-ci prend moins de temps, et se trompe moins, à coup sûr. */
    boolean bat(Releve autre) {
        return rapport().nettementSous(autre.rapport()) && erreur().nettementSous(autre.erreur());
    }
}
