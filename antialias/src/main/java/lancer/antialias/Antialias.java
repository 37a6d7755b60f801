package lancer.antialias;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Modele;
import lancer.contrat.Parametre;
import lancer.contrat.Reglable;
import lancer.contrat.Section;
import lancer.texte.Texte;

/**
 * Anticrénelage (cours, « Anticrénelage ») : la couleur d'un pixel est la moyenne de celles de n × n sous-pixels, et
 * une méthode adaptative dit quels pixels peuvent se contenter de moins.
 */
public final class Antialias implements Reglable {

    private static final int N = 3;
    private static final int N_MAX = 64;
    private static final double SEUIL = 0.05;

    /** Du moins cher au plus cher : n, méthode, seuil. Ce que l'un de ceux-ci domine presque partout n'y est pas. */
    private static final String[] REGLAGES = {
        "1 coins 0", "3 partage 0.3", "4 partage 0.2", "8 partage 0.15", "8 partage 0.1", "8 partage 0.06",
        "16 partage 0.03", "16 partage 0.015", "16 partage 0.005"};

    /**
     * La méthode du cours : quatre coins d'abord, tous les sous-pixels s'ils diffèrent.
     *
     * @param n nombre de sous-pixels sur un côté, de 1 à 64
     * @param seuil 0 : tous les sous-pixels, toujours
     */
    public static Echantillonnage coins(int n, double seuil) {
        return new Coins(n, seuil);
    }

    /**
     * La méthode qui partage les sous-pixels entre voisins, et interpole là où tout se ressemble.
     *
     * @param n nombre de sous-pixels sur un côté, de 1 à 64
     * @param seuil 0 : tous les sous-pixels, toujours
     */
    public static Echantillonnage partage(int n, double seuil) {
        return new Partage(n, seuil);
    }

    @Override
    public String getSection() {
        return "Antialias";
    }

    @Override
    public void installer(Section valeurs, Modele modele) {
        int n = valeurs.entier("n", N, 1, N_MAX);
        double seuil = valeurs.reel("seuil", SEUIL, 0, Double.MAX_VALUE);
        modele.setEchantillonnage(methode(valeurs, n, seuil));
    }

    @Override
    public List<Parametre> getParametres() {
        return Arrays.asList(Parametre.nombre("n", (double) N, 1, 16, 1),
                Parametre.nombre("seuil", SEUIL, 0, 0.5, 0.005), Parametre.mot("methode", "coins", "partage"));
    }

    @Override
    public List<Section> getReglages() {
        List<Section> reglages = new ArrayList<>();
        for (String reglage : REGLAGES) {
            String[] mots = reglage.split(" ");
            reglages.add(Section.reglage(getSection(), "n", mots[0], "methode", mots[1], "seuil", mots[2]));
        }
        return reglages;
    }

    private static Echantillonnage methode(Section valeurs, int n, double seuil) {
        String nom = valeurs.mot("methode", "coins");
        switch (nom) {
            case "coins":
                return coins(n, seuil);
            case "partage":
                return partage(n, seuil);
            default:
                throw valeurs.fautive("methode", "méthode inconnue : " + Texte.cite(nom), "coins ou partage");
        }
    }
}
