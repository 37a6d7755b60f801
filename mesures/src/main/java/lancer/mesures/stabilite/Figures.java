package lancer.mesures.stabilite;

import java.awt.Color;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import lancer.mesures.trace.FormeDePoint;
import lancer.mesures.trace.Marque;
import lancer.mesures.trace.Planche;
import lancer.mesures.trace.Serie;
import lancer.mesures.trace.Style;
import lancer.mesures.trace.Volet;

/** Les figures de la stabilité. */
public final class Figures {

    private static final String ERREUR = "erreur relative de t, la pire";
    private static final String UNITES = "erreur de t, en unités de κ u t";
    private static final String BORNE = "8, la borne promise";

    /** Ordonnée d'une part nulle, en %, sur un axe logarithmique. */
    private static final double AUCUN = 0.05;

    private final Bilan bilan;
    private final String note;

    Figures(Bilan bilan) {
        this.bilan = bilan;
        note = "Pire de " + Style.nombre(bilan.max(Mesures.SOL, r -> r.essais)) + " rayons tirés au sort par abscisse, jugés sans arrondi "
                + "(140 chiffres) ; ceux qu'un arrondi de leur direction fait changer d'avis sont laissés. Un trait s'arrête là où plus "
                + "d'un rayon sur dix est mal classé. u = 2⁻⁵³, κ u t = u (1 + r/h) t : l'effet d'un arrondi de la direction. make mesures";
    }

    /** Dessine les figures des mesures de ce dossier. */
    public static void ecrire(Path dossier) throws IOException {
        Figures figures = new Figures(new Bilan(dossier));
        figures.loin().ecrire(dossier.resolve("stabilite-loin.png"));
        figures.ras().ecrire(dossier.resolve("stabilite-ras.png"));
        figures.sol().ecrire(dossier.resolve("stabilite-sol.png"));
        figures.reflets().ecrire(dossier.resolve("stabilite-reflets.png"));
    }

    /** A : de loin. */
    private Planche loin() {
        Volet erreur = new Volet("Erreur de la distance", "|P − C| / r", UNITES).repere(Bilan.PROMESSE, BORNE);
        courbes(erreur, Mesures.LOIN, r -> Math.max(0.1, r.erreurEnUnites), true);
        Volet genre = new Volet("Rayons mal classés", "|P − C| / r", "rayons mal classés, en %").repere(AUCUN, "aucun");
        courbes(genre, Mesures.LOIN, r -> Math.max(AUCUN, 100 * r.part()), false);
        return new Planche("De loin", note).volet(erreur).volet(genre);
    }

    /** B : rayons rasants. */
    private Planche ras() {
        return new Planche("Au ras", note)
                .volet(rasant(Mesures.RAS, Mesures.PRES)).volet(rasant(Mesures.RAS_LOIN, Mesures.LOINTAIN));
    }

    private Volet rasant(String figure, double distance) {
        Volet volet = new Volet("À " + Style.nombre(distance) + " r du centre", "1 − l/r, vers la tangente", ERREUR).versZero();
        courbes(volet, figure, r -> r.erreurRelative, true);
        return volet.serie(guide("8 u (1 + r/h), la borne promise", Style.GRIS, figure, Bilan.PROMESSE))
                .serie(guide("u (1 + r/h), l'effet d'un arrondi", Style.FRONT, figure, 1));
    }

    private Serie guide(String nom, Color couleur, String figure, double facteur) {
        // h² = r² − l²
        List<Marque> marques = bilan.de(figure, Formule.PROGRAMME).stream()
                .map(r -> Marque.en(r.x, facteur * Cas.U * (1 + 1 / Math.sqrt(r.x * (2 - r.x))))).collect(Collectors.toList());
        return new Serie(nom, couleur, FormeDePoint.AUCUNE, true, marques);
    }

    /** C : le sol, et un départ posé sur une surface. */
    private Planche sol() {
        Volet sol = new Volet("Un œil à hauteur 1", "rayon du sol", UNITES).repere(Bilan.PROMESSE, BORNE);
        courbes(sol, Mesures.SOL, r -> Math.max(0.1, r.erreurEnUnites), true);
        Volet pose = new Volet("Un départ posé sur une surface", "hauteur du départ / rayon", UNITES).versZero()
                .repere(Bilan.PROMESSE, BORNE);
        courbes(pose, Mesures.POSE, r -> Math.max(0.1, r.erreurEnUnites), true);
        return new Planche("Près d'une surface", note).volet(sol).volet(pose);
    }

    /** D : de reflet en reflet. */
    private Planche reflets() {
        Volet volet = new Volet("", "reflets, de boule en boule", "erreur du contact, en rayons ; à 1, la boule est perdue")
                .lineaire().repere(1, "");
        Object[][] series = {{"float", "float", Style.ORANGE, FormeDePoint.TRIANGLE},
            {"double", "double", Style.VERMILLON, FormeDePoint.ROND},
            {"compensee", "chaque reflet sans erreur, puis rangé en double", Style.POURPRE, FormeDePoint.CROIX},
            {"deux_doubles", "deux doubles par nombre", Style.BLEU, FormeDePoint.CARRE}};
        for (Object[] s : series) {
            volet.serie(new Serie((String) s[1], (Color) s[2], (FormeDePoint) s[3], true, bilan.de(Reflets.FIGURE, (String) s[0]).stream()
                    .map(r -> Marque.en(r.x, r.erreurRelative)).collect(Collectors.toList())));
        }
        return new Planche("De reflet en reflet, entre petites boules", "La pente des droites est l'exposant de Lyapunov, "
                + Style.arrondi(bilan.exposantDeLyapunov()) + " : chaque reflet multiplie l'erreur par "
                + Style.arrondi(Math.exp(bilan.exposantDeLyapunov())) + ". Erreur médiane de "
                + Style.nombre(bilan.de(Reflets.FIGURE, "double").get(0).essais) + " chaînes de boules de rayon 1, à des distances de 5 "
                + "à 40, jugées à 140 chiffres. Aucune formule n'y peut rien : le contact, une fois rangé dans un double, n'y est qu'à "
                + "un arrondi près, et le reflet suivant multiplie cet arrondi. make mesures").volet(volet);
    }

    /** Ajoute la courbe de chaque méthode. @param juste vrai pour ne garder que les abscisses bien classées */
    private void courbes(Volet volet, String figure, ToDoubleFunction<Exactitude> y, boolean juste) {
        for (Formule methode : Mesures.DES_COURBES) {
            volet.serie(new Serie(methode.nom, methode.couleur, methode.forme, true, bilan.de(figure, methode).stream()
                    .filter(r -> !juste || Bilan.estClasse(r))
                    .map(r -> Marque.en(r.x, Math.max(Double.MIN_NORMAL, y.applyAsDouble(r)))).collect(Collectors.toList())));
        }
    }
}
