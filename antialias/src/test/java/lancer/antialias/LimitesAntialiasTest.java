package lancer.antialias;

import static lancer.essai.Ressources.boule;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Vue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Où d'autres façons de moyenner un pixel échouent ; ce que la nôtre manque est dans {@link CoinsTest}. */
class LimitesAntialiasTest extends EssaiEchantillons {

    /** La moyenne de n × n points d'un pixel, pris à {@code decalage} du coin de leur sous-pixel, limités ou non avant d'être sommés. */
    private static Couleur moyenne(Vue vue, int i, int j, int n, double decalage, boolean limiter) {
        Couleur somme = new Couleur();
        for (int dy = 0; dy < n; dy++) {
            for (int dx = 0; dx < n; dx++) {
                Couleur c = vue.couleur(i + (dx + decalage) / n, j + (dy + decalage) / n);
                somme = somme.add(limiter ? new Couleur(Math.min(1, c.r), Math.min(1, c.v), Math.min(1, c.b)) : c);
            }
        }
        return somme.div(n * n);
    }

    private static Couleur laNotre(Vue vue, int n) {
        return pixels(new Coins(n, 0), new Pave(0, 0, 1, 1), vue)[0];
    }

    /**
     * Des sous-pixels pris en leur coin plutôt qu'en leur centre décalent toute l'image de 1/(2n) pixel : la part couverte d'un
     * pixel de bord est fausse d'autant, toujours dans le même sens. Centrés, l'erreur est d'au plus 1/(2n), et nulle en moyenne.
     */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 8})
    void desSousPixelsNonCentresOntUnBiaisDUnDemiSousPixel(int n) {
        Random hasard = new Random(40);
        int tirages = 20_000;
        double biaisNaif = 0;
        double biaisNotre = 0;
        for (int k = 0; k < tirages; k++) {
            double bord = hasard.nextDouble();
            Vue blancAGauche = (xe, ye) -> new Couleur(xe < bord ? 1 : 0);
            double naive = moyenne(blancAGauche, 0, 0, n, 0, false).r - bord;
            double notre = laNotre(blancAGauche, n).r - bord;
            assertTrue(naive >= -1e-12 && Math.abs(notre) <= 0.5 / n + 1e-12, "graine 40, tirage " + k);
            biaisNaif += naive / tirages;
            biaisNotre += notre / tirages;
        }
        assertEquals(0.5 / n, biaisNaif, 0.01 / n);
        assertEquals(0, biaisNotre, 0.01 / n);
    }

    /** Limiter avant de moyenner : un bord éblouissant recule d'un pixel, et l'image linéaire perd ce qu'elle avait de plus que 1. */
    @Test
    void limiterAvantDeMoyennerEteintLesBordsEblouissants() {
        // un pixel que deux points sur neuf voient à 10 et les autres à 0 est plus clair que le blanc
        Vue eclat = (xe, ye) -> new Couleur(xe < 0.67 && ye < 0.33 ? 10 : 0);
        assertEquals(2.0 / 9, moyenne(eclat, 0, 0, 3, 0.5, true).r, 1e-15);
        assertEquals(20.0 / 9, laNotre(eclat, 3).r, 1e-15);
    }

    /** La somme de la tache d'une lampe, plus petite qu'un pixel, par une méthode, en fois celle d'un échantillonnage fin : écart type. */
    private static double tacheManquee(Echantillonnage methode) {
        Random hasard = new Random(41);
        double carres = 0;
        int tirages = 40;
        for (int k = 0; k < tirages; k++) {
            Sphere boule = boule(0.4 * hasard.nextDouble(), 0.4 * hasard.nextDouble(), 6, 1, 0, 1, 200);
            Scene scene = new Scene(List.of(boule), List.of(new Lampe(new Point(-3, 4, -5), new Couleur(1))));
            carres += Math.pow(tache(scene, methode) / tache(scene, new Coins(16, 0)) - 1, 2) / tirages;
        }
        return Math.sqrt(carres);
    }

    /** Ce que la lampe ajoute à l'image, sans aucun reflet du ciel. */
    private static double tache(Scene scene, Echantillonnage methode) {
        double[] somme = new double[1];
        for (Scene s : new Scene[] {scene, new Scene(scene.getObjets(), List.of())}) {
            somme[0] = -somme[0];
            new Lancer(s.avec(s.getModele().avec(methode, 0)), new Camera(12, 12))
                    .TracerImage((couleur, i, j) -> somme[0] += couleur.v, 0, 1);
        }
        return -somme[0];
    }

    /** Une tache plus petite qu'un pixel : un rayon la voit trop grande, ou pas du tout ; les coins n'y ont rien vu non plus. */
    @Test
    void uneTachePlusPetiteQuUnPixelEstManqueeParToutCeQuiNEstPasLaGrille() {
        double unRayon = tacheManquee(new Coins(1, 0));
        double coins = tacheManquee(new Coins(8, 0.05));
        double partage = tacheManquee(new Partage(8, 0.06));
        double grille = tacheManquee(new Coins(8, 0));
        assertTrue(unRayon > 0.7 && coins > 0.3 && partage > 0.3, unRayon + ", coins " + coins + ", partage " + partage);
        assertTrue(grille < 0.1, "la grille : " + grille);
    }
}
