package lancer.mesures.stabilite;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import lancer.mesures.trace.Style;

/** Ce que disent les mesures, en nombres : pour les titres et pour les pages. */
final class Bilan {

    /** Part des rayons mal classés au-dessus de laquelle une erreur ne veut plus rien dire. */
    private static final double TROP = 0.1;

    private final List<Exactitude> tous;

    Bilan(List<Exactitude> tous) {
        this.tous = tous;
    }

    List<Exactitude> de(String figure, Formule formule) {
        return tous.stream().filter(r -> r.figure.equals(figure) && r.formule.equals(formule.cle)).collect(Collectors.toList());
    }

    /** Les défauts, du plus voyant au moins voyant, ou ce que donne le programme sur les mêmes scènes, dans le même ordre. */
    List<Exactitude> defauts(boolean programme) {
        List<Exactitude> siens = tous.stream().filter(r -> r.figure.equals(Defauts.FIGURE)).collect(Collectors.toList());
        List<Exactitude> naifs = siens.stream().filter(r -> !r.formule.equals(Defauts.PROGRAMME))
                .sorted(Comparator.comparingInt((Exactitude r) -> -r.faux)).collect(Collectors.toList());
        return !programme ? naifs : naifs.stream().map(n -> siens.stream()
                .filter(r -> r.x == n.x && r.formule.equals(Defauts.PROGRAMME)).findFirst().get()).collect(Collectors.toList());
    }

    static boolean estClasse(Exactitude r) {
        return r.part() <= TROP;
    }

    int faux(Formule formule, String figure) {
        return de(figure, formule).stream().mapToInt(r -> r.faux).sum();
    }

    int essais(Formule formule, String figure) {
        return de(figure, formule).stream().mapToInt(r -> r.essais).sum();
    }

    double part(Formule formule, String figure) {
        return (double) faux(formule, figure) / essais(formule, figure);
    }

    /** Le plus grand nombre de rayons jugés en une abscisse. */
    int tires() {
        return de(Mesures.SOL, Formule.PROGRAMME).stream().mapToInt(r -> r.essais).max().orElse(0);
    }

    private Exactitude auBout(Formule formule, String figure) {
        return de(figure, formule).stream().max(Comparator.comparingDouble((Exactitude r) -> r.x)).get();
    }

    double partAuBout(Formule formule, String figure) {
        return auBout(formule, figure).part();
    }

    int fauxAuBout(Formule formule, String figure) {
        return auBout(formule, figure).faux;
    }

    /** La plus grande abscisse. */
    double leBout(String figure) {
        return auBout(Formule.PROGRAMME, figure).x;
    }

    /** Rayons tirés pour une case de la carte, au plus. */
    int parCase() {
        return de(Mesures.CARTE, Formule.PROGRAMME).stream().mapToInt(r -> r.essais).max().orElse(0);
    }

    /** Les rayons mal classés de plus loin que dix fois le rayon de la sphère : plus près, c'est une autre affaire. */
    int fauxDeLoin(Formule formule) {
        return de(Mesures.LOIN, formule).stream().filter(r -> r.x >= 10).mapToInt(r -> r.faux).sum();
    }

    /** Au départ le plus près d'une surface. */
    int fauxAuRas(Formule formule) {
        return de(Mesures.POSE, formule).stream().min(Comparator.comparingDouble((Exactitude r) -> r.x)).get().faux;
    }

    /** La pire erreur du programme, en unités de κ u t. */
    double unites(String figure) {
        return de(figure, Formule.PROGRAMME).stream().filter(Bilan::estClasse).mapToDouble(r -> r.erreurEnUnites).max()
                .orElse(Double.NaN);
    }

    /** L'exposant de la distance dans l'erreur du manuel, de dix à un million de rayons. */
    double pente() {
        List<Exactitude> manuel = de(Mesures.LOIN, Formule.MANUEL);
        return (Math.log10(en(manuel, 1e6).erreurEnUnites) - Math.log10(en(manuel, 10).erreurEnUnites)) / 5;
    }

    private static Exactitude en(List<Exactitude> exactitudes, double x) {
        return exactitudes.stream().filter(r -> Math.abs(r.x / x - 1) < 1e-6).findFirst().get();
    }

    /** D'où, au-delà de dix rayons, le manuel classe mal plus d'un rayon sur dix. */
    double perdu() {
        return de(Mesures.LOIN, Formule.MANUEL).stream().filter(r -> r.x >= 10 && !estClasse(r)).mapToDouble(r -> r.x).min()
                .orElse(Double.NaN);
    }

    /** Combien de fois l'erreur du programme fait celle du manuel, en moyenne géométrique, là où les deux classent bien. */
    double rapportDesErreurs(String figure) {
        List<Exactitude> manuel = de(figure, Formule.MANUEL).stream().filter(Bilan::estClasse).collect(Collectors.toList());
        List<Exactitude> programme = de(figure, Formule.PROGRAMME);
        return Math.exp(manuel.stream().mapToDouble(m -> Math.log(m.erreurRelative / en(programme, m.x).erreurRelative)).average()
                .orElse(0));
    }

    /** Le nombre de chiffres justes de la distance, au-dessus du plus grand sol. */
    int chiffresJustes(Formule formule) {
        return (int) -Math.log10(auBout(formule, Mesures.SOL).erreurRelative);
    }

    /** Le rapport des bornes d'une case. */
    double pasDeLaCarte() {
        double[] xs = de(Mesures.CARTE, Formule.PROGRAMME).stream().mapToDouble(r -> r.x).distinct().sorted().toArray();
        return xs[1] / xs[0];
    }

    /** Les nombres que montrent les pages, par leurs noms. */
    Map<String, String> pages() {
        Map<String, String> valeurs = new TreeMap<>();
        valeurs.put("stabilite.unites", Style.arrondi(unites(Mesures.LOIN)));
        valeurs.put("stabilite.pente", Style.arrondi(pente()));
        valeurs.put("stabilite.perdu", Style.puissance(perdu()));
        valeurs.put("stabilite.loin.manuel", Style.arrondi(100 * partAuBout(Formule.MANUEL, Mesures.LOIN)));
        valeurs.put("stabilite.loin.perpendiculaire", Figures.fois(fauxDeLoin(Formule.PERPENDICULAIRE)));
        valeurs.put("stabilite.loin.programme", Figures.fois(fauxDeLoin(Formule.PROGRAMME)));
        valeurs.put("stabilite.ras.rapport", Style.arrondi(rapportDesErreurs(Mesures.RAS)));
        valeurs.put("stabilite.rasloin.rapport", Style.arrondi(rapportDesErreurs(Mesures.RAS_LOIN)));
        valeurs.put("stabilite.ras.unites", Style.arrondi(Math.max(unites(Mesures.RAS), unites(Mesures.RAS_LOIN))));
        for (Formule formule : Formule.values()) {
            valeurs.put("stabilite.sol." + formule.cle, String.valueOf(chiffresJustes(formule)));
            valeurs.put("stabilite.pose." + formule.cle, Figures.fois(fauxAuRas(formule)));
        }
        valeurs.put("stabilite.carte.manuel", Style.arrondi(100 * part(Formule.MANUEL, Mesures.CARTE)));
        valeurs.put("stabilite.carte.programme", Figures.fois(faux(Formule.PROGRAMME, Mesures.CARTE)));
        valeurs.put("stabilite.carte.rayons", Style.nombre(essais(Formule.PROGRAMME, Mesures.CARTE)));
        List<Exactitude> naifs = defauts(false);
        valeurs.put("stabilite.defauts", String.valueOf(naifs.size()));
        valeurs.put("stabilite.defauts.programme", Style.nombre(faux(Formule.PROGRAMME, Defauts.FIGURE)));
        naifs.forEach(r -> valeurs.put("stabilite.defaut." + r.formule, Style.nombre(r.faux)));
        return valeurs;
    }
}
