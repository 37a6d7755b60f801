package lancer.mesures.stabilite;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import lancer.mesures.trace.Style;

/** Nombres que donnent les mesures : pour les titres et pour les pages. */
public final class Bilan {

    /** Part des rayons mal classés au-dessus de laquelle une erreur ne veut plus rien dire. */
    private static final double TROP = 0.1;

    /** Distance en rayons de la sphère : plus près, c'est une autre affaire. */
    static final double DE_LOIN = 10;

    /** Promesse du programme, en unités de l'erreur inévitable, κ u t. */
    public static final double PROMESSE = 8;

    private final List<Exactitude> tous;

    /** Des mesures de ce dossier. */
    public Bilan(Path dossier) throws IOException {
        tous = Exactitude.lire(dossier.resolve(Mesures.CSV));
    }

    List<Exactitude> de(String figure, Formule methode) {
        return de(figure, methode.cle());
    }

    List<Exactitude> de(String figure, String methode) {
        return tous.stream().filter(r -> r.figure.equals(figure) && r.formule.equals(methode)).collect(Collectors.toList());
    }

    public static boolean estClasse(Exactitude r) {
        return r.part() <= TROP;
    }

    /** Justesse d'une méthode dans un régime. */
    public Exactitude en(Regime regime, Formule methode) {
        return de("regime-" + regime.cle(), methode).get(0);
    }

    /** Les rayons mal classés à partir de cette abscisse. */
    int faux(String figure, Formule methode, double aPartirDe) {
        return de(figure, methode).stream().filter(r -> r.x >= aPartirDe).mapToInt(r -> r.faux).sum();
    }

    /** La plus grande de ces valeurs, celles du programme. */
    double max(String figure, ToDoubleFunction<Exactitude> valeur) {
        return de(figure, Formule.PROGRAMME).stream().mapToDouble(valeur).max().orElse(0);
    }

    /** Borne de la pire erreur du programme, en dixièmes d'unité de κ u t. */
    double unites(String figure) {
        return Math.ceil(10 * max(figure, r -> estClasse(r) ? r.erreurEnUnites : 0)) / 10;
    }

    /** Justesse d'une méthode à la plus grande abscisse, ou à la plus petite. */
    private Exactitude auBout(String figure, Formule methode, boolean grande) {
        return de(figure, methode).stream().max(Comparator.comparingDouble((Exactitude r) -> grande ? r.x : -r.x)).get();
    }

    /** L'exposant de la distance dans l'erreur du manuel, de dix à un million de rayons. */
    double pente() {
        List<Exactitude> manuel = de(Mesures.LOIN, Formule.MANUEL);
        return (Math.log10(en(manuel, 1e6).erreurEnUnites) - Math.log10(en(manuel, 10).erreurEnUnites)) / 5;
    }

    private static Exactitude en(List<Exactitude> exactitudes, double x) {
        return exactitudes.stream().filter(r -> Math.abs(r.x / x - 1) < 1e-6).findFirst().get();
    }

    /** Nombre de fois que l'erreur du programme fait celle du manuel, en moyenne géométrique, là où les deux classent bien. */
    private double rapportDesErreurs(String figure) {
        List<Exactitude> programme = de(figure, Formule.PROGRAMME);
        return Math.exp(de(figure, Formule.MANUEL).stream().filter(Bilan::estClasse)
                .mapToDouble(m -> Math.log(m.erreurRelative / en(programme, m.x).erreurRelative)).average().orElse(0));
    }

    /** « jamais », « 3 fois ». */
    private static String fois(int faux) {
        return faux == 0 ? "jamais" : Style.nombre(faux) + " fois";
    }

    /** Les nombres que montrent les titres et les pages, par leurs noms. */
    public Map<String, String> nombres() {
        Map<String, String> valeurs = new TreeMap<>();
        valeurs.put("stabilite.unites", Style.arrondi(unites(Mesures.LOIN)));
        valeurs.put("stabilite.pente", Style.arrondi(pente()));
        // d'où, de loin, le manuel classe mal plus d'un rayon sur dix
        valeurs.put("stabilite.perdu", Style.puissance(de(Mesures.LOIN, Formule.MANUEL).stream()
                .filter(r -> r.x >= DE_LOIN && !estClasse(r)).mapToDouble(r -> r.x).min().orElse(Double.NaN)));
        valeurs.put("stabilite.bout", Style.puissance(max(Mesures.LOIN, r -> r.x)));
        valeurs.put("stabilite.bout.manuel", Style.arrondi(100 * auBout(Mesures.LOIN, Formule.MANUEL, true).part()));
        valeurs.put("stabilite.loin.programme", fois(faux(Mesures.LOIN, Formule.PROGRAMME, DE_LOIN)));
        valeurs.put("stabilite.ras.rapport", Style.arrondi(rapportDesErreurs(Mesures.RAS)));
        valeurs.put("stabilite.ras-loin.rapport", Style.arrondi(rapportDesErreurs(Mesures.RAS_LOIN)));
        valeurs.put("stabilite.ras.unites", Style.arrondi(Math.max(unites(Mesures.RAS), unites(Mesures.RAS_LOIN))));
        valeurs.put("stabilite.sol", Style.puissance(max(Mesures.SOL, r -> r.x)));
        for (Formule methode : Mesures.DES_COURBES) {
            valeurs.put("stabilite.sol." + methode.cle(),
                    String.valueOf((int) -Math.log10(auBout(Mesures.SOL, methode, true).erreurRelative)));
            valeurs.put("stabilite.pose." + methode.cle(), fois(auBout(Mesures.POSE, methode, false).faux));
        }
        petites(valeurs);
        reflets(valeurs);
        return valeurs;
    }

    /** Phrases sur les cas où la méthode recommandée échouait le plus : son erreur, celles des autres, et ce qu'elle coûte. */
    private void petites(Map<String, String> valeurs) {
        Exactitude pire = de(PetitesBoules.FIGURE, PetitesBoules.SANS).stream()
                .max(Comparator.comparingDouble(r -> r.y / en(de(PetitesBoules.FIGURE, "partage"), r.x).y)).get();
        for (String methode : new String[] {"un_rayon", "coins", PetitesBoules.SANS, "partage", "grille"}) {
            valeurs.put("stabilite.petites." + methode, Style.arrondi(en(de(PetitesBoules.FIGURE, methode), pire.x).y));
        }
        valeurs.put("stabilite.petites.x", Style.nombre(pire.x));
        valeurs.put("stabilite.petites.prix", Style.arrondi(en(de(PetitesBoules.FIGURE, "grille"), pire.x).erreurEnUnites
                / en(de(PetitesBoules.FIGURE, "partage"), pire.x).erreurEnUnites));
    }

    /** Nombre de chiffres qu'un reflet prend à un double, tant qu'il en a, et auquel il n'en reste pas. */
    private void reflets(Map<String, String> valeurs) {
        for (String facon : new String[] {"float", "double", "compensee", "deux_doubles"}) {
            valeurs.put("stabilite.reflets." + facon, de(Reflets.FIGURE, facon).stream().filter(r -> r.erreurRelative >= 0.1).findFirst()
                    .map(r -> Style.nombre(r.x)).orElse("plus de " + Reflets.MAX));
        }
        List<Exactitude> justes = de(Reflets.FIGURE, "double").stream().filter(r -> r.erreurRelative < 0.01).collect(Collectors.toList());
        Exactitude dernier = justes.get(justes.size() - 1);
        valeurs.put("stabilite.reflets.perte", Style.arrondi(
                Math.log10(dernier.erreurRelative / justes.get(0).erreurRelative) / (dernier.x - justes.get(0).x)));
    }
}
