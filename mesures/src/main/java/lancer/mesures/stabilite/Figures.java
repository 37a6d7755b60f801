package lancer.mesures.stabilite;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import lancer.mesures.Nombres;
import lancer.mesures.trace.Planche;
import lancer.mesures.trace.Volet;

/** Les figures de la stabilité. Une courbe s'arrête là où plus d'un rayon sur dix est mal classé. */
public final class Figures {

    private static final String UNITES = "erreur de t, en unités de κ u t";
    private static final String BORNE = "8, la borne promise";
    private static final int HAUTEUR = 800;

    /** Ordonnées d'une erreur nulle, et d'une part nulle, en %, sur un axe logarithmique. */
    private static final double EXACT = 0.1;
    private static final double AUCUN = 0.05;

    private final Bilan bilan;

    private Figures(Bilan bilan) {
        this.bilan = bilan;
    }

    /** Les figures des mesures de ce dossier, par leurs noms de fichier. */
    public static Map<String, Planche> planches(Path dossier) throws IOException {
        Figures figures = new Figures(new Bilan(dossier));
        Map<String, Planche> planches = new TreeMap<>();
        planches.put("stabilite-loin.png", figures.loin());
        planches.put("stabilite-ras.png", figures.ras());
        planches.put("stabilite-sol.png", figures.sol());
        planches.put("stabilite-reflets.png", figures.reflets());
        return planches;
    }

    private Planche loin() {
        Volet classes = new Volet("Rayons mal classés", "|P − C| / r", "rayons mal classés, en %").repere(AUCUN, "aucun");
        courbes(classes, Mesures.LOIN, r -> Math.max(AUCUN, 100 * r.part()), false);
        return new Planche(2, HAUTEUR).volet(unites("Erreur de la distance", "|P − C| / r", Mesures.LOIN)).volet(classes);
    }

    private Planche ras() {
        return new Planche(2, HAUTEUR).volet(rasant(Mesures.RAS, Mesures.PRES)).volet(rasant(Mesures.RAS_LOIN, Mesures.LOINTAIN));
    }

    private Volet rasant(String figure, double distance) {
        Volet volet = new Volet("À " + Nombres.nombre(distance) + " r du centre", "1 − l/r, vers la tangente",
                "erreur relative de t, la pire").versZero();
        courbes(volet, figure, r -> r.erreurRelative, true);
        guide(volet, "8 u (1 + r/h), la borne promise", figure, Bilan.PROMESSE);
        return guide(volet, "u (1 + r/h), l'effet d'un arrondi", figure, 1);
    }

    private Volet guide(Volet volet, String nom, String figure, double facteur) {
        // h² = r² − l²
        return volet.serie(nom, true, bilan.de(figure, Formule.PROGRAMME).stream()
                .map(r -> new Volet.Point(r.x, facteur * Cas.U * (1 + 1 / Math.sqrt(r.x * (2 - r.x))))).collect(Collectors.toList()));
    }

    private Planche sol() {
        return new Planche(2, HAUTEUR).volet(unites("Un œil à hauteur 1", "rayon du sol", Mesures.SOL))
                .volet(unites("Un départ posé sur une surface", "hauteur du départ / rayon", Mesures.POSE).versZero());
    }

    private Volet unites(String titre, String axe, String figure) {
        Volet volet = new Volet(titre, axe, UNITES).repere(Bilan.PROMESSE, BORNE);
        courbes(volet, figure, r -> Math.max(EXACT, r.erreurEnUnites), true);
        return volet;
    }

    private Planche reflets() {
        Volet volet = new Volet("De reflet en reflet, entre petites boules", "reflets, de boule en boule",
                "erreur du contact, en rayons ; à 1, la boule est perdue").xOrdinaire();
        String[][] series = {{"float", "float"}, {"double", "double"}, {"compensee", "chaque reflet sans erreur, puis rangé en double"},
            {"deux_doubles", "deux doubles par nombre"}};
        for (String[] s : series) {
            volet.serie(s[1], true, bilan.de(Reflets.FIGURE, s[0]).stream().map(r -> new Volet.Point(r.x, r.erreurRelative))
                    .collect(Collectors.toList()));
        }
        return new Planche(1, HAUTEUR).volet(volet);
    }

    /** Ajoute la courbe de chaque méthode. @param juste vrai pour ne garder que les abscisses bien classées */
    private void courbes(Volet volet, String figure, ToDoubleFunction<Exactitude> y, boolean juste) {
        for (Formule methode : Formule.values()) {
            volet.serie(methode.nom, true, bilan.de(figure, methode).stream().filter(r -> !juste || Bilan.estClasse(r))
                    .map(r -> new Volet.Point(r.x, y.applyAsDouble(r))).filter(Volet.Point::seMontre).collect(Collectors.toList()));
        }
    }
}
