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

/** Mesures d'une méthode sur une scène : temps, rayons, erreur. Un nombre qui manque est vide dans le CSV, et NaN ici. */
final class Releve {

    static final List<String> COLONNES = Arrays.asList("machine", "coeurs", "jvm", "date", "commit", "famille", "scene", "spheres",
            "methode", "parametres", "largeur", "hauteur", "fils", "primaires", "ombre", "reflechis", "tests", "noeuds",
            "raffines", "pixels_verifies", "manches", "jetees", "reference_ms", "rapport", "rapport_min", "rapport_max",
            "processeur_ms", "memoire_mo");

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

    /** @param paires des noms de colonnes, chacun suivi de sa valeur */
    static Map<String, String> champs(Object... paires) {
        return IntStream.range(0, paires.length / 2).boxed()
                .collect(Collectors.toMap(k -> (String) paires[2 * k], k -> paires[2 * k + 1].toString()));
    }

    /** Nom lisible de la méthode et de ses paramètres. */
    String nom() {
        return (methode + " " + parametres).trim();
    }

    static String reel(double valeur) {
        return Double.isNaN(valeur) || Double.isInfinite(valeur) ? "" : valeur == 0 ? "0" : String.format(Locale.ROOT, "%.5g", valeur);
    }

    String texte(String colonne) {
        return champs.getOrDefault(colonne, "");
    }

    double nombre(String colonne) {
        String texte = texte(colonne);
        return texte.isEmpty() ? Double.NaN : Double.parseDouble(texte);
    }

    /** Rapport du temps à celui de la référence, qui est le réglage « un rayon » : 1 pour lui-même. */
    Intervalle rapport() {
        return methode.equals(Catalogue.UN_RAYON) && nombre("rapport") > 0 ? Intervalle.exact(1) : mesure();
    }

    /** Rapport mesuré, sans bornes s'il y a trop peu de manches. */
    Intervalle mesure() {
        double max = nombre("rapport_max");
        return new Intervalle(nombre("rapport"), Double.isNaN(max) ? 0 : nombre("rapport_min"),
                Double.isNaN(max) ? Double.POSITIVE_INFINITY : max);
    }

    Intervalle erreur() {
        return new Intervalle(nombre("erreur"), nombre("erreur_min"), nombre("erreur_max"));
    }

    /** Nombre de rayons de toutes sortes d'une image. */
    double rayons() {
        return texte("rayons").isEmpty() ? nombre("primaires") + nombre("ombre") + nombre("reflechis") : nombre("rayons");
    }

    /** La ligne de ces colonnes dans un CSV. */
    String ligne(List<String> colonnes) {
        return FichierCsv.ligne(colonnes.stream().map(this::texte).toArray());
    }

    /** Ces mesures, complétées ou remplacées par celles que l'autre a. */
    Releve avec(Releve autre) {
        Map<String, String> tous = new HashMap<>(champs);
        autre.champs.forEach((colonne, texte) -> tous.merge(colonne, texte, (sien, nouveau) -> nouveau.isEmpty() ? sien : nouveau));
        return new Releve(tous);
    }

    /** Dit si l'autre mesure a la même méthode, le même réglage et la même taille d'image. */
    boolean estLeMeme(Releve autre) {
        return Stream.of("famille", "scene", "methode", "parametres", "largeur", "hauteur").allMatch(c -> texte(c).equals(autre.texte(c)));
    }

    /** Dit si ce réglage est plus rapide et plus juste que l'autre, intervalles compris. */
    boolean bat(Releve autre) {
        return rapport().nettementSous(autre.rapport()) && erreur().nettementSous(autre.erreur());
    }
}
