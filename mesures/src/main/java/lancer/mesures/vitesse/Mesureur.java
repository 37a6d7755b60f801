package lancer.mesures.vitesse;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import lancer.Lancer;
import lancer.Scene;
import lancer.contrat.Compteurs;
import lancer.mesures.ImageFausse;
import lancer.mesures.ImageLineaire;
import lancer.mesures.Repartition;

/**
 * Mesure des méthodes sur une scène, dans cette machine virtuelle : dessine, vérifie, échauffe, puis chronomètre. Chaque image
 * chronométrée est comparée au bit près à celle qui a été vérifiée ; une image fausse n'a pas de temps.
 */
final class Mesureur {

    /** Dessins chronométrés, au moins. */
    static final int REPETITIONS_MIN = 7;
    private static final int REPETITIONS_MAX = 100;

    private final Taille taille;
    private final Controle controle;
    private final long echauffementNs;
    private final long dureeNs;

    Mesureur(Taille taille, boolean court) {
        this.taille = taille;
        controle = new Controle(taille, court ? 5e6 : 1e8);
        echauffementNs = TimeUnit.MILLISECONDS.toNanos(court ? 30 : 200);
        dureeNs = TimeUnit.MILLISECONDS.toNanos(court ? 30 : 300);
    }

    /** Une méthode mesurée. */
    static final class Mesure {
        final Methode methode;
        final ImageLineaire image;
        final Compteurs compteurs;
        final int verifies;
        private final Lancer lancer;
        private final List<Long> temps = new ArrayList<>();

        Mesure(Methode methode, Lancer lancer, ImageLineaire image, int verifies) {
            this.methode = methode;
            this.lancer = lancer;
            this.image = image;
            this.compteurs = lancer.getCompteurs();
            this.verifies = verifies;
        }

        Repartition temps() {
            return new Repartition(temps.stream().mapToLong(Long::longValue).toArray());
        }
    }

    /**
     * Mesure ces méthodes ensemble : à chaque tour, un dessin de chacune, pour qu'une machine qui ralentit ralentisse toutes.
     *
     * @throws ImageFausse si une image n'est pas celle des boucles du cours, ou change d'un dessin à l'autre
     */
    List<Mesure> mesurer(Scene scene, List<Methode> methodes) {
        List<Mesure> mesures = new ArrayList<>();
        for (Methode methode : methodes) {
            Lancer lancer = methode.preparer(scene, taille.largeur, taille.hauteur);
            ImageLineaire image = dessin(methode, lancer);
            mesures.add(new Mesure(methode, lancer, image, controle.verifier(methode, scene, image, lancer.getCompteurs())));
        }
        long debut = System.nanoTime();
        do {
            mesures.forEach(this::chronometrer);
        } while (System.nanoTime() - debut < echauffementNs * methodes.size());
        mesures.forEach(m -> m.temps.clear());
        debut = System.nanoTime();
        for (int tour = 0; tour < REPETITIONS_MIN
                || tour < REPETITIONS_MAX && System.nanoTime() - debut < dureeNs * methodes.size(); tour++) {
            mesures.forEach(this::chronometrer);
        }
        return mesures;
    }

    private ImageLineaire dessin(Methode methode, Lancer lancer) {
        ImageLineaire image = new ImageLineaire(taille.largeur, taille.hauteur);
        image.effacer();
        methode.dessiner(lancer, image, taille.fils);
        return image;
    }

    private void chronometrer(Mesure mesure) {
        ImageLineaire image = new ImageLineaire(taille.largeur, taille.hauteur);
        image.effacer();
        long debut = System.nanoTime();
        mesure.methode.dessiner(mesure.lancer, image, taille.fils);
        mesure.temps.add(System.nanoTime() - debut);
        if (!image.memesBits(mesure.image)) {
            throw new ImageFausse("deux dessins de la même scène diffèrent (" + mesure.methode.cle() + ")");
        }
    }
}
