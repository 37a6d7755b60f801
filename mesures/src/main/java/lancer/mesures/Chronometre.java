package lancer.mesures;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lancer.Camera;
import lancer.Constantes;
import lancer.Lancer;
import lancer.Scene;
import lancer.commande.Pannes;
import lancer.contrat.Compteurs;
import lancer.contrat.Pave;
import lancer.sortie.ImageMemoire;

/**
 * Mesure une scène dans cette machine virtuelle, par le chemin du programme : lire, préparer, dessiner une première fois ; puis
 * échauffer, répéter, et n'en rendre les temps que si l'image est juste.
 */
final class Chronometre {

    /** Ce qui reste du temps accordé va aux dessins mesurés. */
    private static final double PART_ECHAUFFEMENT = 0.3;
    private static final double PART_VERIFICATION = 0.2;

    /** Dessins mesurés, quel que soit le temps accordé. */
    static final int REPETITIONS_MIN = 3;
    private static final int REPETITIONS_MAX = 1000;

    /** D'une scène lue à ce qui la dessine. */
    interface Preparation {
        Lancer preparer(Scene scene, int largeur, int hauteur);
    }

    /** Celle du programme. */
    static final Preparation DU_PROGRAMME = (scene, largeur, hauteur) ->
            lancer.temoins.LancerSurveille.preparer(scene, largeur, hauteur, false);

    private final Preparation preparation;
    private final Reglages reglages;

    Chronometre(Preparation preparation, Reglages reglages) {
        this.preparation = preparation;
        this.reglages = reglages;
    }

    Mesure mesurer(Path fichier) {
        try {
            return chronometrer(fichier);
        } catch (ImageFausse e) {
            return Mesure.fautive("image fausse : " + e.getMessage());
        } catch (RuntimeException | OutOfMemoryError e) {
            return Mesure.fautive(Pannes.message(e));
        }
    }

    private Mesure chronometrer(Path fichier) {
        int largeur = reglages.largeur;
        int hauteur = reglages.hauteur;
        long debut = System.nanoTime();
        Scene scene = Scenes.lire(fichier);
        long lue = System.nanoTime();
        Lancer lancer = preparation.preparer(scene, largeur, hauteur);
        long prete = System.nanoTime();

        Temoin temoin = new Temoin(largeur, hauteur);
        double partEnCours = Math.min(1, (double) reglages.fils / Pave.nombre(largeur, hauteur));
        String tropLong = Garde.surveiller(lancer, () -> lancer.TracerPixels(temoin, Constantes.MAX_REFLETS, reglages.fils),
                partEnCours, reglages.limiteNs);
        if (tropLong != null) {
            return Mesure.sautee(tropLong);
        }
        long premiere = lancer.getDureeNs();
        Compteurs rayons = lancer.getCompteurs();

        ImageMemoire image = new ImageMemoire(largeur, hauteur, false);
        repeter(lancer, image, temoin, 1, PART_ECHAUFFEMENT);
        long[] temps = repeter(lancer, image, temoin, REPETITIONS_MIN, 1 - PART_ECHAUFFEMENT - PART_VERIFICATION);
        // après les temps : le chemin lisible ferait compiler autrement le code qu'ils partagent
        int verifies = temoin.verifier(scene, new Camera(largeur, hauteur), (long) (PART_VERIFICATION * reglages.dureeNs));
        return Mesure.faite(new long[] {scene.getObjets().size(), rayons.primaires, rayons.ombre, rayons.reflechis, verifies,
            lue - debut, prete - lue, premiere}, temps);
    }

    /**
     * Dessine encore, autant de fois que le temps le permet.
     *
     * @param part du temps accordé à la scène
     * @return le temps de chaque dessin
     * @throws ImageFausse si l'un d'eux n'est pas l'image du témoin
     */
    private long[] repeter(Lancer lancer, ImageMemoire image, Temoin temoin, int auMoins, double part) {
        List<Long> temps = new ArrayList<>();
        long debut = System.nanoTime();
        while (temps.size() < auMoins
                || temps.size() < REPETITIONS_MAX && System.nanoTime() - debut < part * reglages.dureeNs) {
            Arrays.fill(image.getCodes(), 0);
            long depart = System.nanoTime();
            lancer.TracerPixels(image, Constantes.MAX_REFLETS, reglages.fils);
            temps.add(System.nanoTime() - depart);
            if (!Arrays.equals(image.getCodes(), temoin.getCodes())) {
                throw new ImageFausse("deux dessins de la même scène diffèrent");
            }
        }
        return temps.stream().mapToLong(Long::longValue).toArray();
    }
}
