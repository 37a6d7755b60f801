package lancer.antialias;

import lancer.Scene;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Variante;
import lancer.lecture.Section;
import lancer.lecture.Texte;

/**
 * Anticrénelage (cours, « Anticrénelage ») : la couleur d'un pixel est la moyenne de celles de n × n sous-pixels, et une
 * méthode adaptative dit quels pixels peuvent se contenter de moins.
 */
public final class Antialias implements Variante {

    private static final int N = 3;
    private static final int N_MAX = 64;
    private static final double SEUIL = 0.05;

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
    public void installer(Section valeurs, Scene scene) {
        int n = valeurs.entier("n", N, 1, N_MAX);
        double seuil = valeurs.reel("seuil", SEUIL, 0, Double.MAX_VALUE);
        scene.setEchantillonnage(methode(valeurs, n, seuil));
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
