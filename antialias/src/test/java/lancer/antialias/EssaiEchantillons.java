package lancer.antialias;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import lancer.Couleur;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Vue;

/** De quoi essayer un échantillonnage sur une image qui n'a pas de scène : sa vue est une formule. */
abstract class EssaiEchantillons {

    /** Les rayons qu'a demandés la dernière vue comptée. */
    int rayons;

    Vue comptee(Vue vue) {
        rayons = 0;
        return (xe, ye) -> {
            rayons++;
            return vue.couleur(xe, ye);
        };
    }

    /** Ses pixels coupés en sous-pixels, sans image. */
    static int raffines(Echantillonnage echantillonnage, Pave pave, Vue vue) {
        return echantillonnage.tracer(pave, pave, vue, (couleur, i, j) -> { }).raffines;
    }

    /** Les pixels d'un pavé, ligne par ligne. */
    static Couleur[] pixels(Echantillonnage echantillonnage, Pave pave, Vue vue) {
        int largeur = pave.i1 - pave.i0;
        Couleur[] pixels = new Couleur[largeur * (pave.j1 - pave.j0)];
        echantillonnage.tracer(pave, pave, vue, (couleur, i, j) -> {
            int k = (j - pave.j0) * largeur + i - pave.i0;
            assertEquals(null, pixels[k], "chaque pixel une seule fois");
            pixels[k] = couleur;
        });
        return pixels;
    }

    /** Des disques de rayon rho (en pixels), jetés au hasard sur un fond presque noir : la part qu'aucun point ne voit est celle-ci. */
    static void verifierPartManquee(double attendue, Echantillonnage echantillonnage, double rho, int essais) {
        Random hasard = new Random(39);
        Pave voisinage = new Pave(0, 0, 6, 6);
        int manques = 0;
        for (int essai = 0; essai < essais; essai++) {
            double x = 2 + 2 * hasard.nextDouble();
            double y = 2 + 2 * hasard.nextDouble();
            boolean[] vu = new boolean[1];
            raffines(echantillonnage, voisinage, (xe, ye) -> {
                boolean dedans = (xe - x) * (xe - x) + (ye - y) * (ye - y) < rho * rho;
                vu[0] |= dedans;
                return new Couleur(dedans ? 1 : 1e-6 * xe);
            });
            manques += vu[0] ? 0 : 1;
        }
        assertEquals(attendue, (double) manques / essais, 4 * Math.sqrt(attendue * (1 - attendue) / essais));
    }
}
