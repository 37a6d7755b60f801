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

    List<Exactitude> de(String figure, Aspect methode) {
        return tous.stream().filter(r -> r.figure.equals(figure) && r.formule.equals(methode.cle())).collect(Collectors.toList());
    }

    /** Les défauts, du plus voyant au moins voyant. */
    List<Exactitude> defauts() {
        return tous.stream().filter(r -> r.figure.equals(Defauts.FIGURE) && !r.formule.equals(Defauts.PROGRAMME))
                .sorted(Comparator.comparingInt(r -> -r.faux)).collect(Collectors.toList());
    }

    static boolean estClasse(Exactitude r) {
        return r.part() <= TROP;
    }

    int faux(Aspect methode, String figure) {
        return de(figure, methode).stream().mapToInt(r -> r.faux).sum();
    }

    int essais(Aspect methode, String figure) {
        return de(figure, methode).stream().mapToInt(r -> r.essais).sum();
    }

    double part(Aspect methode, String figure) {
        return (double) faux(methode, figure) / essais(methode, figure);
    }

    /** Le plus grand nombre de rayons jugés en une abscisse. */
    int tires() {
        return de(Mesures.SOL, Aspect.PROGRAMME).stream().mapToInt(r -> r.essais).max().orElse(0);
    }

    private Exactitude auBout(Aspect methode, String figure) {
        return de(figure, methode).stream().max(Comparator.comparingDouble((Exactitude r) -> r.x)).get();
    }

    double partAuBout(Aspect methode, String figure) {
        return auBout(methode, figure).part();
    }

    int fauxAuBout(Aspect methode, String figure) {
        return auBout(methode, figure).faux;
    }

    /** La plus grande abscisse. */
    double leBout(String figure) {
        return auBout(Aspect.PROGRAMME, figure).x;
    }

    /** Rayons tirés pour une case de la carte, au plus. */
    int parCase() {
        return de(Mesures.CARTE, Aspect.PROGRAMME).stream().mapToInt(r -> r.essais).max().orElse(0);
    }

    /** Les rayons mal classés de plus loin que dix fois le rayon de la sphère : plus près, c'est une autre affaire. */
    int fauxDeLoin(Aspect methode) {
        return de(Mesures.LOIN, methode).stream().filter(r -> r.x >= 10).mapToInt(r -> r.faux).sum();
    }

    /** Au départ le plus près d'une surface. */
    int fauxAuRas(Aspect methode) {
        return de(Mesures.POSE, methode).stream().min(Comparator.comparingDouble((Exactitude r) -> r.x)).get().faux;
    }

    /** La pire erreur du programme, en unités de κ u t. */
    double unites(String figure) {
        return de(figure, Aspect.PROGRAMME).stream().filter(Bilan::estClasse).mapToDouble(r -> r.erreurEnUnites).max()
                .orElse(Double.NaN);
    }

    /** L'exposant de la distance dans l'erreur du manuel, de dix à un million de rayons. */
    double pente() {
        List<Exactitude> manuel = de(Mesures.LOIN, Aspect.MANUEL);
        return (Math.log10(en(manuel, 1e6).erreurEnUnites) - Math.log10(en(manuel, 10).erreurEnUnites)) / 5;
    }

    private static Exactitude en(List<Exactitude> exactitudes, double x) {
        return exactitudes.stream().filter(r -> Math.abs(r.x / x - 1) < 1e-6).findFirst().get();
    }

    /** D'où, au-delà de dix rayons, le manuel classe mal plus d'un rayon sur dix. */
    double perdu() {
        return de(Mesures.LOIN, Aspect.MANUEL).stream().filter(r -> r.x >= 10 && !estClasse(r)).mapToDouble(r -> r.x).min()
                .orElse(Double.NaN);
    }

    /** Combien de fois l'erreur du programme fait celle du manuel, en moyenne géométrique, là où les deux classent bien. */
    double rapportDesErreurs(String figure) {
        List<Exactitude> manuel = de(figure, Aspect.MANUEL).stream().filter(Bilan::estClasse).collect(Collectors.toList());
        List<Exactitude> programme = de(figure, Aspect.PROGRAMME);
        return Math.exp(manuel.stream().mapToDouble(m -> Math.log(m.erreurRelative / en(programme, m.x).erreurRelative)).average()
                .orElse(0));
    }

    /** Le nombre de chiffres justes de la distance, au-dessus du plus grand sol. */
    int chiffresJustes(Aspect methode) {
        return (int) -Math.log10(auBout(methode, Mesures.SOL).erreurRelative);
    }

    /** Le rapport des bornes d'une case. */
    double pasDeLaCarte() {
        double[] xs = de(Mesures.CARTE, Aspect.PROGRAMME).stream().mapToDouble(r -> r.x).distinct().sorted().toArray();
        return xs[1] / xs[0];
    }

    /** Les nombres que montrent les pages, par leurs noms. */
    Map<String, String> pages() {
        Map<String, String> valeurs = new TreeMap<>();
        valeurs.put("stabilite.unites", Style.arrondi(unites(Mesures.LOIN)));
        valeurs.put("stabilite.pente", Style.arrondi(pente()));
        valeurs.put("stabilite.perdu", Style.puissance(perdu()));
        valeurs.put("stabilite.loin.manuel", Style.arrondi(100 * partAuBout(Aspect.MANUEL, Mesures.LOIN)));
        valeurs.put("stabilite.loin.perpendiculaire", Figures.fois(fauxDeLoin(Aspect.PERPENDICULAIRE)));
        valeurs.put("stabilite.loin.programme", Figures.fois(fauxDeLoin(Aspect.PROGRAMME)));
        valeurs.put("stabilite.ras.rapport", Style.arrondi(rapportDesErreurs(Mesures.RAS)));
        valeurs.put("stabilite.rasloin.rapport", Style.arrondi(rapportDesErreurs(Mesures.RAS_LOIN)));
        valeurs.put("stabilite.ras.unites", Style.arrondi(Math.max(unites(Mesures.RAS), unites(Mesures.RAS_LOIN))));
        for (Aspect methode : Mesures.DES_COURBES) {
            valeurs.put("stabilite.sol." + methode.cle(), String.valueOf(chiffresJustes(methode)));
            valeurs.put("stabilite.pose." + methode.cle(), Figures.fois(fauxAuRas(methode)));
        }
        valeurs.put("stabilite.carte.manuel", Style.arrondi(100 * part(Aspect.MANUEL, Mesures.CARTE)));
        valeurs.put("stabilite.carte.programme", Figures.fois(faux(Aspect.PROGRAMME, Mesures.CARTE)));
        valeurs.put("stabilite.carte.rayons", Style.nombre(essais(Aspect.PROGRAMME, Mesures.CARTE)));
        List<Exactitude> naifs = defauts();
        valeurs.put("stabilite.defauts", String.valueOf(naifs.size()));
        valeurs.put("stabilite.defauts.programme", Style.nombre(faux(Aspect.PROGRAMME, Defauts.FIGURE)));
        naifs.forEach(r -> valeurs.put("stabilite.defaut." + r.formule, Style.nombre(r.faux)));
        return valeurs;
    }
}
