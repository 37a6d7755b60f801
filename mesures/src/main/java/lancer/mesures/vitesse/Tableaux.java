package lancer.mesures.vitesse;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import lancer.mesures.Nombres;
import lancer.mesures.scenes.Scenes;

/** Les tableaux des pages, par leurs noms. */
final class Tableaux {

    /** Écart relatif de deux temps au-dessous duquel aucun n'est dit plus long : celui d'une commande mesurée deux fois. */
    private static final double AUTANT = 0.1;
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
        pages.put("choisir", choisir() + source(choix.plusAncienne(m -> m.compte), choix.plusAncienne(m -> m.chronometre)));
        pages.put("resultat", resultat());
        pages.put("couts", table(Arrays.asList("ce qui change", "temps, divisé par celui du programme sans option", "processeurs",
                "mémoire"), couts.toutes.stream().map(m -> Arrays.asList(m.nom(), m.estDe(Reglage.UN_RAYON) ? "l'unité"
                : rapport(m.rapport()), quantite(m.processeurs, " s"), quantite(m.memoire, " Mo"))).collect(Collectors.toList()))
                + source(couts.plusAncienne(m -> m.chronometre)));
        pages.put("pentes", pentes());
        pages.put("machine", tous.toutes.stream().filter(m -> !m.machine.isEmpty()).findFirst()
                .map(m -> m.machine).orElse(PAS_ENCORE));
        return pages;
    }

    // ---- la première table

    /** Un souhait, et pour chaque sorte de scène le réglage qui y répond et ce qu'il coûte ; dessous, ce qu'il faut écrire. */
    private String choisir() {
        Resultats livrees = choix.tels(m -> !Scenes.DIFFICILES.contains(m.scene));
        Map<String, String> lignes = new LinkedHashMap<>();
        List<Mesure> choisies = new ArrayList<>();
        Map<String, Function<Resultats, Optional<Mesure>>> souhaits = new LinkedHashMap<>();
        souhaits.put("aller au plus vite", r -> r.scene(Catalogue.COURS).de(Reglage.UN_RAYON));
        souhaits.put("le mieux, en deux fois ce temps", r -> r.lePlusJuste(Catalogue.COURS, 2 * (1 + AUTANT)));
        souhaits.put("un niveau au plus", r -> r.leMoinsCher(Catalogue.COURS, 1));
        souhaits.put("moins que l'arrondi de l'écran", r -> r.leMoinsCher(Catalogue.COURS, Planches.ARRONDI));
        souhaits.forEach((souhait, reponse) -> {
            String cases = "";
            for (Resultats scenes : Arrays.asList(livrees, choix)) {
                Optional<Mesure> choisie = reponse.apply(scenes);
                choisie.ifPresent(choisies::add);
                cases += "<td>" + choisie.map(m -> dire(m, scenes)).orElse("rien de ce qui est mesuré") + "</td>";
            }
            // deux souhaits qui ont la même réponse sont une ligne
            lignes.merge(cases, souhait, (a, b) -> a + " ; " + b);
        });
        StringBuilder table = new StringBuilder("\n<table>\n<tr><th>je veux</th><th>ma scène n'a pas de détail plus petit qu'un pixel</th>"
                + "<th>elle en a, ou je ne sais pas</th></tr>\n");
        lignes.forEach((cases, souhait) -> table.append("<tr><td>" + souhait + "</td>" + cases + "</tr>\n"));
        table.append("</table>\n\n");
        choisies.stream().map(m -> Catalogue.reglage(m)).collect(Collectors.toMap(Reglage::nom, r -> r, (r, s) -> r, LinkedHashMap::new))
                .forEach((nom, r) -> table.append("**" + nom + "** : " + (r.section.isEmpty() ? "" : "dans la scène,\n\n"
                        + bloc(r.section) + "et ") + "dans un terminal,\n\n" + bloc(r.commande())));
        return table.toString();
    }

    /** Une case : le réglage, son erreur sur la pire de ces scènes, et son prix sur celle du cours et sur la plus chère. */
    private String dire(Mesure m, Resultats scenes) {
        Mesure pire = scenes.pire(m).orElse(m);
        Mesure chere = scenes.tels(a -> a.nom().equals(m.nom())).toutes.stream().max(Comparator.comparingDouble(this::prix)).orElse(m);
        String plus = prix(chere) > prix(m) ? " (jusqu'à × " + Nombres.arrondi(prix(chere)) + ", " + chere.scene + ")" : "";
        return "<b>" + m.nom() + "</b><br>au pire " + Nombres.niveaux(pire.erreur.valeur) + " (de " + Nombres.arrondi(pire.erreur.min)
                + " à " + Nombres.arrondi(pire.erreur.max) + ", " + pire.scene + ")<br>" + Nombres.arrondi(100 * pire.visibles)
                + " % des pixels visiblement faux<br>rayons × " + Nombres.arrondi(prix(m)) + plus
                + (m.rapport() > 0 ? ", temps × " + Nombres.arrondi(m.rapport()) : "");
    }

    /** Les rayons, divisés par ceux d'un rayon par pixel de la même scène. */
    private double prix(Mesure m) {
        return m.rayons / choix.scene(m.scene).de(Reglage.UN_RAYON).map(u -> u.rayons).orElse(Double.NaN);
    }

    private static String bloc(String texte) {
        return texte.trim().replaceAll("(?m)^", "    ") + "\n\n";
    }

    /** Deux réglages dont l'erreur est voisine, leurs rayons et leurs temps. */
    private String resultat() {
        Resultats cours = choix.scene(Catalogue.COURS);
        Optional<Mesure> partage = cours.de(Catalogue.UN_NIVEAU);
        Optional<Mesure> grille = cours.de(Reglage.grille(5));
        if (!partage.isPresent() || !grille.isPresent()) {
            return PAS_ENCORE;
        }
        double temps = grille.get().processeurs / partage.get().processeurs;
        return Nombres.niveaux(partage.get().erreur.valeur) + ". La grille de 5 × 5 rayons par pixel lance "
                + Nombres.arrondi(grille.get().rayons / partage.get().rayons) + " fois plus de rayons" + (Double.isNaN(temps) ? ""
                : ", en " + Nombres.arrondi(temps) + " fois plus de temps de processeur") + ", pour une erreur de "
                + Nombres.niveaux(grille.get().erreur.valeur);
    }

    /** L'ordre de convergence de deux méthodes sur la scène du cours : la pente de la droite des moindres carrés, en logarithmes. */
    private String pentes() {
        Resultats cours = choix.scene(Catalogue.COURS);
        return "rayons<sup>" + pente(cours.methode(Reglage.GRILLE)) + "</sup> par la grille, et comme rayons<sup>"
                + pente(cours.methode(Reglage.PARTAGE)) + "</sup> par `partage`";
    }

    private static String pente(Resultats methode) {
        return Nombres.arrondi(Planches.pente(methode.toutes, m -> Math.log(m.rayons), m -> Math.log(m.erreur.valeur)));
    }

    // ---- les autres

    /** Le nombre et son unité ; vide s'il n'est pas mesuré. */
    private static String quantite(double nombre, String unite) {
        return Double.isNaN(nombre) ? "" : Nombres.nombre(nombre) + unite;
    }

    /** La ligne sous un tableau. @param quand commit et jour, séparés par une espace, de la plus ancienne de chaque sorte de mesures */
    static String source(String... quand) {
        String dates = Arrays.stream(quand).filter(s -> !s.isEmpty()).distinct().map(s -> s.replace(" ", ", le "))
                .collect(Collectors.joining(" ; "));
        return dates.isEmpty() ? "" : "\nLa plus ancienne de ces mesures : commit " + dates + ".\n";
    }

    /** Un tableau Markdown. */
    static String table(List<String> titres, List<List<String>> lignes) {
        List<List<String>> toutes = new ArrayList<>(Arrays.asList(titres, titres.stream().map(t -> "---").collect(Collectors.toList())));
        toutes.addAll(lignes);
        return toutes.stream().map(l -> "| " + l.stream().map(c -> c.replace("|", "\\|")).collect(Collectors.joining(" | ")) + " |")
                .collect(Collectors.joining("\n", "\n", "\n"));
    }

    /** Facteur, ou phrase qui dit qu'aucune différence n'est sûre. */
    static String rapport(double rapport) {
        if (Double.isNaN(rapport)) {
            return "";
        }
        return Math.abs(rapport - 1) < AUTANT ? "autant, à un dixième près" : "× " + Nombres.nombre(rapport);
    }
}
