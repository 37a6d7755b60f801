package lancer.antialias;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Random;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lancer;
import lancer.Scene;
import lancer.Sphere;
import lancer.contrat.Compteurs;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Vue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Ce que la méthode du cours prend de rayons, et ce qu'elle manque. */
class CoinsTest extends EssaiEchantillons {

    private static final Pave UN_PIXEL = new Pave(0, 0, 1, 1);

    /** L'unique pixel que donne cet échantillonnage. */
    private static Couleur pixel(Echantillonnage echantillonnage, Vue vue) {
        return pixels(echantillonnage, UN_PIXEL, vue)[0];
    }

    /** Une vue qui ne dépend que du sous-pixel de n × n où elle est prise, et qui refuse tout autre point que son centre. */
    private static Vue vue(int n, double... niveaux) {
        return (xe, ye) -> {
            int dx = (int) (xe * n);
            int dy = (int) (ye * n);
            assertEquals((dx + 0.5) / n, xe);
            assertEquals((dy + 0.5) / n, ye);
            return new Couleur(0, niveaux[dy * n + dx], 0);
        };
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 5, 64})
    void laMoyenneEstSommeeLigneParLigneEtNonLimitee(int n) {
        double[] niveaux = new Random(n).doubles(n * n).toArray();
        niveaux[n - 1] += 2;
        double somme = 0;
        for (double niveau : niveaux) {
            somme += niveau;
        }
        assertEquals(somme / (n * n), pixel(new Coins(n, 0), vue(n, niveaux)).v);
        assertEquals(somme / (n * n), pixel(new Coins(n, 1e-9), vue(n, niveaux)).v);
    }

    @Test
    void desCoinsEgauxSuffisentEtLeurContrasteDoitDepasserLeSeuil() {
        double[] milieu = {0.5, 9, 0.75, 9, 9, 9, 0.5, 9, 0.5};
        assertEquals(2.25 / 4, pixel(new Coins(3, 0.25), vue(3, milieu)).v, "contraste égal au seuil");
        milieu[2] = Math.nextUp(0.75);
        assertEquals((2.25 + 45) / 9, pixel(new Coins(3, 0.25), vue(3, milieu)).v, 1e-15, "contraste au-dessus");
        double[] eblouis = {2, 0, 3, 0, 0, 0, 5, 0, 6};
        assertEquals(4, pixel(new Coins(3, 0.25), vue(3, eblouis)).v, "comparés une fois limités à 1, moyennés sans limite");
        double[] sombres = {-2, 9, 0, 9, 9, 9, 0, 9, -2};
        assertEquals(-1, pixel(new Coins(3, 0.25), vue(3, sombres)).v, "et de même à 0");
    }

    private static Compteurs compteurs(List<Sphere> spheres, int n, double seuil) {
        Scene scene = new Scene(spheres, List.of());
        Lancer lancer = new Lancer(scene.avec(scene.getModele().avec(new Coins(n, seuil), Constantes.SEUIL)), new Camera(40, 30));
        lancer.TracerImage((couleur, i, j) -> { }, 5, 2);
        return lancer.getAtelier().getCompteurs();
    }

    @ParameterizedTest
    @CsvSource({"1, 0, 1, 0", "1, 0.05, 1, 0", "2, 0, 4, 0", "2, 0.05, 4, 0", "3, 0.05, 4, 0", "3, 0, 9, 1", "8, 0.05, 4, 0",
            "8, 0, 64, 1"})
    void unPixelHomogeneCouteExactementQuatreRayons(int n, double seuil, int rayons, int raffines) {
        Compteurs compteurs = compteurs(List.of(), n, seuil);
        assertEquals(rayons * 40 * 30, compteurs.primaires);
        assertEquals(raffines * 40 * 30, compteurs.pixelsRaffines);
    }

    @Test
    void leBrouillonNePrendPasUnRayonDePlus() {
        Scene scene = new Scene(List.of(), List.of());
        Lancer lancer = new Lancer(scene.avec(scene.getModele().avec(new Coins(8, 0), Constantes.SEUIL)), new Camera(41, 31));
        lancer.TracerBrouillon((couleur, i, j) -> { }, 5, 2);
        assertEquals(11 * 8, lancer.getAtelier().getCompteurs().primaires);
    }

    /** L'aire commune à deux disques de rayon rho dont les centres sont à la distance d. */
    private static double lentille(double rho, double d) {
        return d >= 2 * rho ? 0 : 2 * rho * rho * Math.acos(d / (2 * rho)) - d / 2 * Math.sqrt(4 * rho * rho - d * d);
    }

    /**
     * Les coins des pixels forment des bouquets de quatre points à 1/n l'un de l'autre : un disque est vu s'il en contient un,
     * soit une aire de 4πρ², moins ce que des disques voisins ont en commun dès que ρ dépasse 1/(2n) (et jusqu'à 1/(√2·n)).
     */
    @ParameterizedTest
    @CsvSource({"3, 0.05", "3, 0.1", "3, 0.16", "3, 0.2", "3, 0.235", "4, 0.1", "4, 0.15", "8, 0.05", "8, 0.0883"})
    void laProbabiliteDeManquerUnDisqueAUneFormeClose(int n, double rho) {
        verifierPartManquee(1 - 4 * Math.PI * rho * rho + 4 * lentille(rho, 1.0 / n), new Coins(n, 0.05), rho, 20_000);
    }
}
