package lancer.mesures.stabilite;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import lancer.mesures.trace.Style;

/** Ce que disent les mesures, en nombres : pour les titres et pour les pages. */
final class Chiffres {

    /** Part des rayons mal classés au-dessus de laquelle une erreur ne veut plus rien dire. */
    private static final double TROP = 0.1;

    private final List<Resultat> tous;

    Chiffres(List<Resultat> tous) {
        this.tous = tous;
    }

    List<Resultat> de(String figure, Methode methode) {
        return tous.stream().filter(r -> r.figure.equals(figure) && r.methode.equals(methode.cle)).collect(Collectors.toList());
    }

    /** Les défauts, du plus voyant au moins voyant, ou ce que donne le programme sur les mêmes scènes, dans le même ordre. */
    List<Resultat> defauts(boolean programme) {
        List<Resultat> siens = tous.stream().filter(r -> r.figure.equals(Defauts.FIGURE)).collect(Collectors.toList());
        List<Resultat> naifs = siens.stream().filter(r -> !r.methode.equals(Defauts.PROGRAMME))
                .sorted(Comparator.comparingInt((Resultat r) -> -r.faux)).collect(Collectors.toList());
        return !programme ? naifs : naifs.stream().map(n -> siens.stream()
                .filter(r -> r.x == n.x && r.methode.equals(Defauts.PROGRAMME)).findFirst().get()).collect(Collectors.toList());
    }

    static boolean estClasse(Resultat r) {
        return r.part() <= TROP;
    }

    int faux(Methode methode, String figure) {
        return de(figure, methode).stream().mapToInt(r -> r.faux).sum();
    }

    int essais(Methode methode, String figure) {
        return de(figure, methode).stream().mapToInt(r -> r.essais).sum();
    }

    double part(Methode methode, String figure) {
        return (double) faux(methode, figure) / essais(methode, figure);
    }

    /** Le plus grand nombre de rayons jugés en une abscisse. */
    int tires() {
        return de(Mesures.SOL, Methode.PROGRAMME).stream().mapToInt(r -> r.essais).max().orElse(0);
    }

    private Resultat auBout(Methode methode, String figure) {
        return de(figure, methode).stream().max(Comparator.comparingDouble((Resultat r) -> r.x)).get();
    }

    double partAuBout(Methode methode, String figure) {
        return auBout(methode, figure).part();
    }

    int fauxAuBout(Methode methode, String figure) {
        return auBout(methode, figure).faux;
    }

    /** La plus grande abscisse. */
    double leBout(String figure) {
        return auBout(Methode.PROGRAMME, figure).x;
    }

    /** Rayons tirés pour une case de la carte, au plus. */
    int parCase() {
        return de(Mesures.CARTE, Methode.PROGRAMME).stream().mapToInt(r -> r.essais).max().orElse(0);
    }

    /** Les rayons mal classés de plus loin que dix fois le rayon de la sphère : plus près, c'est une autre affaire. */
    int fauxDeLoin(Methode methode) {
        return de(Mesures.LOIN, methode).stream().filter(r -> r.x >= 10).mapToInt(r -> r.faux).sum();
    }

    /** Au départ le plus près d'une surface. */
    int fauxAuRas(Methode methode) {
        return de(Mesures.POSE, methode).stream().min(Comparator.comparingDouble((Resultat r) -> r.x)).get().faux;
    }

    /** La pire erreur du programme, en unités de κ u t. */
    double unites(String figure) {
        return de(figure, Methode.PROGRAMME).stream().filter(Chiffres::estClasse).mapToDouble(r -> r.erreurEnUnites).max()
                .orElse(Double.NaN);
    }

    /** L'exposant de la distance dans l'erreur du manuel, de dix à un million de rayons. */
    double pente() {
        List<Resultat> manuel = de(Mesures.LOIN, Methode.MANUEL);
        return (Math.log10(en(manuel, 1e6).erreurEnUnites) - Math.log10(en(manuel, 10).erreurEnUnites)) / 5;
    }

    private static Resultat en(List<Resultat> resultats, double x) {
        return resultats.stream().filter(r -> Math.abs(r.x / x - 1) < 1e-6).findFirst().get();
    }

    /** D'où, au-delà de dix rayons, le manuel classe mal plus d'un rayon sur dix. */
    double perdu() {
        return de(Mesures.LOIN, Methode.MANUEL).stream().filter(r -> r.x >= 10 && !estClasse(r)).mapToDouble(r -> r.x).min()
                .orElse(Double.NaN);
    }

    /** Combien de fois l'erreur du programme fait celle du manuel, en moyenne géométrique, là où les deux classent bien. */
    double rapportDesErreurs(String figure) {
        List<Resultat> manuel = de(figure, Methode.MANUEL).stream().filter(Chiffres::estClasse).collect(Collectors.toList());
        List<Resultat> programme = de(figure, Methode.PROGRAMME);
        return Math.exp(manuel.stream().mapToDouble(m -> Math.log(m.erreurRelative / en(programme, m.x).erreurRelative)).average()
                .orElse(0));
    }

    /** Le nombre de chiffres justes de la distance, au-dessus du plus grand sol. */
    int chiffresJustes(Methode methode) {
        return (int) -Math.log10(auBout(methode, Mesures.SOL).erreurRelative);
    }

    /** Le rapport des bornes d'une case. */
    double pasDeLaCarte() {
        double[] xs = de(Mesures.CARTE, Methode.PROGRAMME).stream().mapToDouble(r -> r.x).distinct().sorted().toArray();
        return xs[1] / xs[0];
    }

    /** Les nombres que montrent les pages, par leurs noms. */
    Map<String, String> pages() {
        Map<String, String> valeurs = new TreeMap<>();
        valeurs.put("stabilite.unites", Style.arrondi(unites(Mesures.LOIN)));
        valeurs.put("stabilite.pente", Style.arrondi(pente()));
        valeurs.put("stabilite.perdu", Style.puissance(perdu()));
        valeurs.put("stabilite.loin.manuel", Style.arrondi(100 * partAuBout(Methode.MANUEL, Mesures.LOIN)));
        valeurs.put("stabilite.loin.perpendiculaire", Figures.fois(fauxDeLoin(Methode.PERPENDICULAIRE)));
        valeurs.put("stabilite.loin.programme", Figures.fois(fauxDeLoin(Methode.PROGRAMME)));
        valeurs.put("stabilite.ras.rapport", Style.arrondi(rapportDesErreurs(Mesures.RAS)));
        valeurs.put("stabilite.rasloin.rapport", Style.arrondi(rapportDesErreurs(Mesures.RAS_LOIN)));
        valeurs.put("stabilite.ras.unites", Style.arrondi(Math.max(unites(Mesures.RAS), unites(Mesures.RAS_LOIN))));
        for (Methode methode : Methode.values()) {
            valeurs.put("stabilite.sol." + methode.cle, String.valueOf(chiffresJustes(methode)));
            valeurs.put("stabilite.pose." + methode.cle, Figures.fois(fauxAuRas(methode)));
        }
        valeurs.put("stabilite.carte.manuel", Style.arrondi(100 * part(Methode.MANUEL, Mesures.CARTE)));
        valeurs.put("stabilite.carte.programme", Figures.fois(faux(Methode.PROGRAMME, Mesures.CARTE)));
        valeurs.put("stabilite.carte.rayons", Style.nombre(essais(Methode.PROGRAMME, Mesures.CARTE)));
        List<Resultat> naifs = defauts(false);
        valeurs.put("stabilite.defauts", String.valueOf(naifs.size()));
        valeurs.put("stabilite.defauts.programme", Style.nombre(faux(Methode.PROGRAMME, Defauts.FIGURE)));
        naifs.forEach(r -> valeurs.put("stabilite.defaut." + r.methode, Style.nombre(r.faux)));
        return valeurs;
    }
}
