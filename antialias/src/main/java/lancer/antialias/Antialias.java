package lancer.antialias;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Modele;
import lancer.contrat.Parametre;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.texte.Texte;

/** L'anticrénelage du cours : la moyenne de n × n sous-pixels, ou de moins si une méthode adaptative s'en passe. */
public final class Antialias implements Variante {

    private static final int N = 3;
    private static final int N_MAX = 64;
    private static final double SEUIL = 0.05;

    /** Sections proposées, du moins cher au plus juste : n, méthode, seuil, seuil des reflets. */
    private static final String[] PROPOSEES = {
        "1 coins 0 0.015625", "2 partage 0.15 0.0078125", "3 partage 0.12 0.0078125", "4 partage 0.07 0.0078125",
        "6 partage 0.06 0.00390625", "12 partage 0.045 0.00390625", "16 partage 0.03 0.001953125",
        "16 partage 0.02 0.001953125", "16 partage 0.01 0.0009765625", "16 partage 0.006 0"};

    /** La méthode du cours. @param n de 1 à 64 @param seuil contraste, de 0 (tous les sous-pixels) à 1 */
    public static Echantillonnage coins(int n, double seuil) {
        return new Coins(n, seuil);
    }

    /** La méthode qui partage les sous-pixels entre pixels voisins, et interpole si les couleurs se ressemblent. */
    public static Echantillonnage partage(int n, double seuil) {
        // avec un seul sous-pixel, ou tous, aucune interpolation n'est possible
        return n == 1 || seuil == 0 ? new Coins(n, 0) : new Partage(n, seuil);
    }

    @Override
    public String getSection() {
        return "Antialias";
    }

    @Override
    public void installer(Section valeurs, Modele.Construction modele) {
        int n = valeurs.entier("n", N, 1, N_MAX);
        double seuil = valeurs.reel("seuil", SEUIL, 0, Double.MAX_VALUE);
        String methode = valeurs.mot("methode", "coins");
        if (!methode.matches("coins|partage")) {
            throw valeurs.fautive("methode", "méthode inconnue : " + Texte.cite(methode), "coins ou partage");
        }
        modele.setEchantillonnage(methode.equals("coins") ? coins(n, seuil) : partage(n, seuil));
    }

    @Override
    public List<Parametre> getParametres() {
        return Arrays.asList(Parametre.nombre("n", (double) N, 1, 16, 1),
                Parametre.nombre("seuil", SEUIL, 0, 0.5, 0.005), Parametre.mot("methode", "coins", "partage"));
    }

    @Override
    public Map<Section, Double> getSectionsProposees(Section sienne) {
        Map<Section, Double> proposees = new LinkedHashMap<>();
        for (String proposee : PROPOSEES) {
            String[] mots = proposee.split(" ");
            proposees.put(sienne.sansFichier("n", mots[0], "methode", mots[1], "seuil", mots[2]),
                    Double.parseDouble(mots[3]));
        }
        return proposees;
    }

    @Override
    public String getNomCourt(Section proposee) {
        String n = proposee.mot("n", "" + N);
        return n.equals("1") ? "un rayon"
                : (proposee.mot("methode", "coins") + " ").replace("partage ", "") + n + "/"
                        + proposee.mot("seuil", "" + SEUIL);
    }
}
