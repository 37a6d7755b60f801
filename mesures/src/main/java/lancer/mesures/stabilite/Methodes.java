package lancer.mesures.stabilite;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import lancer.atelier.Circonstances;
import lancer.atelier.FichierCsv;
import lancer.mesures.Intervalle;
import lancer.mesures.trace.Marque;
import lancer.mesures.trace.Planche;
import lancer.mesures.trace.Serie;
import lancer.mesures.trace.Style;
import lancer.mesures.trace.Volet;

/** Ce que coûte chaque façon de calculer une distance, et de combien elle se trompe, dans chaque {@link Regime}. */
public final class Methodes {

    public static final String CSV = "methodes.csv";

    private final List<Exactitude> toutes;
    private final String note;

    /** Les mesures de ce dossier. */
    Methodes(Path dossier) throws IOException {
        toutes = Exactitude.lire(dossier.resolve(CSV), Exactitude.METHODES);
        List<String> lignes = Files.readAllLines(dossier.resolve(CSV));
        note = lignes.get(lignes.size() - 1).substring(FichierCsv.NOTE.length());
    }

    /** Où ranger le temps d'une méthode dans un régime. @param formule son nom dans {@link lancer.essai.Formule} */
    public static String cle(String regime, String formule) {
        return (regime + " " + formule).toLowerCase(Locale.ROOT);
    }

    /**
     * Juge chaque méthode, sans arrondi, et l'écrit dans {@link #CSV} auprès de son temps.
     *
     * @param temps par {@link #cle}, en nanosecondes, et ce qu'il y a de part et d'autre dans son intervalle
     */
    public static void noter(Path dossier, Map<String, double[]> temps) throws IOException {
        List<Exactitude> toutes = new ArrayList<>();
        for (Regime regime : Regime.values()) {
            for (Exactitude r : regime.juger()) {
                double[] ns = temps.get(cle(r.figure, r.formule));
                toutes.add(new Exactitude(r.figure, r.formule, ns[0], ns[1], r.essais, r.faux, r.erreurRelative, r.erreurEnUnites));
            }
        }
        Circonstances c = new Circonstances();
        Exactitude.ecrire(dossier.resolve(CSV), Exactitude.METHODES, toutes, c.machine + ", " + c.jvm + ", commit " + c.commit + ", "
                + c.date.replace('T', ' '));
    }

    private Exactitude une(Regime regime, Aspect methode) {
        return toutes.stream().filter(r -> cle(r.figure, r.formule).equals(cle(regime.name(), methode.cle()))).findFirst().get();
    }

    /** Le temps d'une méthode, celui du manuel valant 1 : un rapport seulement si les intervalles disent lequel est le plus long. */
    private String cout(Regime regime, Aspect methode) {
        Intervalle a = une(regime, methode).temps();
        Intervalle b = une(regime, Aspect.MANUEL).temps();
        return a.nettementSous(b) || b.nettementSous(a) ? "× " + Style.arrondi(a.valeur / b.valeur) : "autant, à l'intervalle près";
    }

    Planche planche() {
        Planche planche = new Planche("Le temps, comparé au manuel : perpendiculaire " + cout(Regime.ORDINAIRE, Aspect.PERPENDICULAIRE)
                + " ; programme " + cout(Regime.ORDINAIRE, Aspect.PROGRAMME) + ", au-dessus d'un sol "
                + cout(Regime.SOL, Aspect.PROGRAMME) + ", dans une recherche " + cout(Regime.SOL, Aspect.RECHERCHE),
                "Temps d'une intersection, par JMH, dans une recherche de la plus petite de huit ; barres : trois machines virtuelles "
                + "sur dix ; erreur : la pire de " + Style.nombre(Regime.RAYONS) + " rayons, jugés sans arrondi ; 1 est l'effet d'un "
                + "arrondi de la direction, κ u t = u (1 + r/h) t. En creux : plus d'un rayon sur dix est mal classé, et l'erreur ne dit "
                + "que celle des autres. " + note + ". make noyaux")
                .colonnes(2).taille(Style.LARGEUR, 1500);
        for (Regime regime : Regime.values()) {
            Exactitude programme = une(regime, Aspect.PROGRAMME);
            Volet volet = new Volet(regime.nom, "Le programme : " + Style.nombre(programme.x) + " ns, "
                    + Style.arrondi(programme.erreurEnUnites) + (programme.erreurEnUnites < 2 ? " unité" : " unités"),
                    "temps d'une intersection, en ns", "pire erreur de t, en unités de κ u t").repere(Cas.K, "8, la borne promise");
            for (Aspect methode : Aspect.values()) {
                Exactitude r = une(regime, methode);
                Marque m = new Marque(new Intervalle(r.x, Math.max(r.x / 2, r.x - r.y), r.x + r.y),
                        Intervalle.exact(Math.max(0.05, r.erreurEnUnites)));
                m = r.faux > 0 ? m.nommee("faux : " + Style.arrondi(100 * r.part()) + " %") : m;
                volet.serie(new Serie(methode.nom, methode.couleur, methode.forme, false,
                        Collections.singletonList(Bilan.estClasse(r) ? m : m.creuse())));
            }
            planche.volet(volet);
        }
        return planche;
    }

    /** Les nombres que montre la page : le tableau, et ceux que cite le texte. */
    Map<String, String> pages() {
        Map<String, String> valeurs = new TreeMap<>();
        StringBuilder tableau = new StringBuilder("\n\n| |");
        for (Regime regime : Regime.values()) {
            tableau.append(' ').append(regime.cle()).append(" |");
            for (Aspect methode : Aspect.values()) {
                valeurs.put("methodes." + methode.cle() + "." + regime.cle(), cout(regime, methode));
            }
        }
        tableau.append("\n|---|---|---|---|---|\n");
        for (Aspect methode : Aspect.values()) {
            tableau.append("| ").append(methode.nom.replace("|", "\\|")).append(" |");
            for (Regime regime : Regime.values()) {
                Exactitude r = une(regime, methode);
                String erreur = r.erreurEnUnites < 1e4 ? Style.arrondi(r.erreurEnUnites) : Style.puissance(r.erreurEnUnites);
                tableau.append(' ').append(Style.nombre(r.x)).append(" ± ").append(Style.arrondi(r.y)).append(" ns ; ").append(erreur)
                        .append(r.faux == 0 ? "" : " ; " + Style.nombre(r.faux) + " faux").append(" |");
            }
            tableau.append('\n');
        }
        valeurs.put("methodes.tableau", tableau.append('\n').toString());
        valeurs.put("methodes.rayons", Style.nombre(une(Regime.ORDINAIRE, Aspect.PROGRAMME).essais));
        return valeurs;
    }
}
