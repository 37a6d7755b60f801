package lancer.mesures.vitesse;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import lancer.mesures.Intervalle;
import lancer.mesures.Nombres;

/** Les tableaux des pages, par leurs noms. */
final class Tableaux {

    private static final Intervalle UN = Intervalle.exact(1);
    private static final String PAS_ENCORE = "pas encore mesuré";

    private final Resultats tous;
    private final Resultats choix;

    Tableaux(Resultats tous) {
        this.tous = tous;
        choix = tous.volet(Catalogue.CHOIX);
    }

    /** Tous les tableaux ; les temps manquent s'ils n'ont pas été mesurés. */
    Map<String, String> pages() {
        Map<String, String> pages = new TreeMap<>();
        Resultats couts = tous.volet(Catalogue.COUTS);
        pages.put("choisir", choisir() + source(choix.toutes, m -> m.chronometre));
        pages.put("resultat", resultat());
        pages.put("couts", table(Arrays.asList("ce qui change", "temps, divisé par celui du programme sans option", "processeurs",
                "mémoire"), couts.toutes.stream().map(m -> Arrays.asList(m.nom(), m.estDe(Reglage.UN_RAYON) ? "l'unité"
                : rapport(m.rapport), processeurs(m), memoire(m))).collect(Collectors.toList()))
                + source(couts.toutes, m -> m.chronometre));
        pages.put("machine", tous.toutes.stream().filter(m -> !m.machine.isEmpty()).findFirst()
                .map(m -> m.machine + ", commit " + m.chronometre.replace(" ", ", le ")).orElse(PAS_ENCORE));
        return pages;
    }

    // ---- la première table

    /** Une question, le réglage qui y répond, ce qu'il coûte en rayons et en temps ; dessous, ce qu'il faut écrire. */
    private String choisir() {
        Map<String, Optional<Mesure>> lignes = new LinkedHashMap<>();
        lignes.put("aller au plus vite", choix.scene(Catalogue.COURS).de(Reglage.UN_RAYON));
        lignes.put("le mieux, en deux fois ce temps", choix.lePlusJuste(Catalogue.COURS, 2));
        lignes.put("un niveau au plus", choix.lePlusRapide(Catalogue.COURS, 1));
        lignes.put("moins que l'arrondi de l'écran", choix.lePlusRapide(Catalogue.COURS, Planches.ARRONDI));
        StringBuilder table = new StringBuilder("\n<table>\n<tr><th>je veux</th><th>réglage</th><th>erreur</th><th>pire scène</th>"
                + "<th>rayons</th><th>temps</th></tr>\n");
        List<String> ecrits = new ArrayList<>();
        lignes.forEach((besoin, choisi) -> table.append("<tr><td>" + besoin + "</td>" + choisi.map(m -> "<td>" + m.nom() + "</td><td>"
                + Nombres.niveaux(m.erreur.valeur) + "</td><td>" + choix.pire(m).map(p -> Nombres.niveaux(p.erreur.valeur) + " ("
                + p.scene + ")").orElse("") + "</td><td>" + rayons(m) + "</td><td>" + temps(m) + "</td></tr>\n" + aEcrire(m, ecrits))
                .orElse("<td colspan=\"5\">rien de ce qui est mesuré</td></tr>\n")));
        return table.append("</table>\n").toString();
    }

    /** Ce qu'il faut écrire pour ce réglage, une seule fois par réglage. */
    private static String aEcrire(Mesure m, List<String> ecrits) {
        if (ecrits.contains(m.nom())) {
            return "";
        }
        ecrits.add(m.nom());
        Reglage reglage = Catalogue.reglage(m);
        return "<tr><td colspan=\"6\">\n" + bloc("dans la scène", reglage.section) + bloc("dans un terminal", reglage.commande())
                + "</td></tr>\n";
    }

    /** Un bloc à copier, sous son titre ; vide s'il n'y a rien à écrire. */
    private static String bloc(String titre, String texte) {
        return texte.isEmpty() ? "" : titre + " :\n\n" + texte.trim().replaceAll("(?m)^", "    ") + "\n\n";
    }

    private String rayons(Mesure m) {
        return "× " + Nombres.arrondi(m.rayons / choix.scene(m.scene).de(Reglage.UN_RAYON).map(u -> u.rayons).orElse(Double.NaN));
    }

    private String temps(Mesure m) {
        return Nombres.arrondi(choix.scene(m.scene).unite() * m.rapport.valeur) + " s, "
                + (m.estDe(Reglage.UN_RAYON) ? "l'unité" : fois(m.rapport));
    }

    /** Deux réglages dont l'erreur est voisine, leurs rayons et leurs temps. */
    private String resultat() {
        Resultats cours = choix.scene(Catalogue.COURS);
        Optional<Mesure> partage = cours.de(Reglage.partage(8, 0.1));
        Optional<Mesure> grille = cours.de(Reglage.grille(4));
        if (!partage.isPresent() || !grille.isPresent()) {
            return PAS_ENCORE;
        }
        double temps = grille.get().rapport.valeur / partage.get().rapport.valeur;
        return Nombres.niveaux(partage.get().erreur.valeur) + ". La grille de 4 × 4 rayons par pixel lance "
                + Nombres.arrondi(grille.get().rayons / partage.get().rayons) + " fois plus de rayons" + (Double.isNaN(temps) ? ""
                : ", en " + Nombres.arrondi(temps) + " fois plus de temps") + ", pour une erreur de "
                + Nombres.niveaux(grille.get().erreur.valeur);
    }

    // ---- les autres

    private static String processeurs(Mesure m) {
        return quantite(m.processeurs, " s");
    }

    private static String memoire(Mesure m) {
        return quantite(m.memoire, " Mo");
    }

    /** Le nombre et son unité ; vide s'il n'est pas mesuré. */
    private static String quantite(double nombre, String unite) {
        return Double.isNaN(nombre) ? "" : Nombres.nombre(nombre) + unite;
    }

    /** La ligne sous un tableau : le commit et le jour de ses mesures ; vide s'ils ne sont pas connus. */
    private static String source(List<Mesure> mesures, Function<Mesure, String> quand) {
        return source(mesures.stream().map(quand).filter(s -> !s.isEmpty()).distinct().collect(Collectors.toList()));
    }

    /** @param quand un commit et un jour, séparés par une espace */
    static String source(List<String> quand) {
        return quand.isEmpty() ? "" : "\nMesures du commit " + quand.stream().map(s -> s.replace(" ", ", le "))
                .collect(Collectors.joining(" ; ")) + ".\n";
    }

    /** Un tableau Markdown. */
    static String table(List<String> titres, List<List<String>> lignes) {
        List<List<String>> toutes = new ArrayList<>(Arrays.asList(titres, titres.stream().map(t -> "---").collect(Collectors.toList())));
        toutes.addAll(lignes);
        return toutes.stream().map(l -> "| " + l.stream().map(c -> c.replace("|", "\\|")).collect(Collectors.joining(" | ")) + " |")
                .collect(Collectors.joining("\n", "\n", "\n"));
    }

    /** « × 2,6 (de 2,4 à 2,9) » ; vide si le rapport n'est pas mesuré. */
    private static String fois(Intervalle i) {
        return i.valeur > 0 ? "× " + Nombres.nombre(i.valeur) + " (de " + Nombres.nombre(i.min) + " à " + Nombres.nombre(i.max) + ")" : "";
    }

    /** Facteur, ou phrase qui dit qu'aucune différence n'est sûre. */
    static String rapport(Intervalle i) {
        return UN.nettementSous(i) || i.nettementSous(UN) ? fois(i)
                : "autant, à l'intervalle près (de " + Nombres.nombre(i.min) + " à " + Nombres.nombre(i.max) + ")";
    }
}
