package lancer.mesures.vitesse;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import lancer.Lancer;
import lancer.Scene;
import lancer.antialias.Antialias;
import lancer.dessin.Dessin;
import lancer.mesures.Gabarit;
import lancer.mesures.ImageLineaire;

/**
 * Recherche du réglage le moins cher de la méthode {@code partage} qui tient une erreur : n, seuil, profondeur et seuil des reflets. Elle
 * essaie presque tous les réglages, ce que le programme ne peut pas faire avant de dessiner.
 */
final class Oracle {

    private static final int[] COTES = {2, 3, 4, 6, 8, 12, 16};
    private static final double[] SEUILS = {0.4, 0.3, 0.2, 0.15, 0.12, 0.1, 0.08, 0.06, 0.05, 0.04, 0.03, 0.02, 0.01};
    private static final int[] PROFONDEURS = {0, 1, 2, 3, 4, 5, 7, 10, 15, 20, 30, 40, 60, 80, Gabarit.PROFONDEUR};
    private static final double[] SEUILS_DES_REFLETS = {1.0 / 4096, 1.0 / 1024, 1.0 / 256, 1.0 / 128, 1.0 / 64, 1.0 / 32, 1.0 / 16, 1.0 / 8,
        1.0 / 4};

    /** Dépassement permis d'une prévision, pour dessiner quand même un candidat. */
    private static final double JEU = 1.1;

    private final Scene scene;
    private final Taille taille;
    private final ToDoubleFunction<ImageLineaire> erreur;
    private final List<Essai> echantillonnages = new ArrayList<>();
    private final List<Essai> limites = new ArrayList<>();
    private final Map<String, Essai> dessines = new HashMap<>();

    /** Un réglage, son erreur en niveaux, et son prix en rayons de toutes sortes par pixel. */
    static final class Essai {
        final int n;
        final double seuil;
        final int reflets;
        final double seuilDesReflets;
        double erreur;
        double prix;

        Essai(int n, double seuil, int reflets, double seuilDesReflets) {
            this.n = n;
            this.seuil = seuil;
            this.reflets = reflets;
            this.seuilDesReflets = seuilDesReflets;
        }

        @Override
        public String toString() {
            return "n=" + n + " seuil=" + seuil + " --reflets " + reflets + " --seuil " + seuilDesReflets;
        }
    }

    /**
     * @param moindre la plus petite erreur demandée
     * @param erreur celle d'une image de cette scène à cette taille
     */
    Oracle(Scene scene, Taille taille, double moindre, ToDoubleFunction<ImageLineaire> erreur) {
        this.scene = scene;
        this.taille = taille;
        this.erreur = erreur;
        echantillonnages.add(dessiner(new Essai(1, 0, Gabarit.PROFONDEUR, 0)));
        for (int n : COTES) {
            Essai essai = null;
            // au-dessous, l'erreur est plus petite que toute erreur demandée
            for (int k = 0; k < SEUILS.length && (essai == null || essai.erreur > moindre); k++) {
                essai = dessiner(new Essai(n, SEUILS[k], Gabarit.PROFONDEUR, 0));
                echantillonnages.add(essai);
            }
        }
        for (int reflets : PROFONDEURS) {
            limites.add(dessiner(new Essai(1, 0, reflets, 0)));
        }
        for (double seuil : SEUILS_DES_REFLETS) {
            limites.add(dessiner(new Essai(1, 0, Gabarit.PROFONDEUR, seuil)));
        }
    }

    /** Temps de processeur d'un dessin à ce réglage, en secondes. */
    double secondes(Essai essai) {
        double debut = MesureAuto.secondes();
        ImageLineaire.de(lancer(essai), essai.reflets, taille.fils);
        return MesureAuto.secondes() - debut;
    }

    private Lancer lancer(Essai essai) {
        return Dessin.lancer(scene.avec(scene.getModele().avec(Antialias.partage(essai.n, essai.seuil), essai.seuilDesReflets)),
                taille.largeur, taille.hauteur, false);
    }

    private Essai dessiner(Essai essai) {
        return dessines.computeIfAbsent(essai.toString(), nom -> {
            Lancer lancer = lancer(essai);
            essai.erreur = erreur.applyAsDouble(ImageLineaire.de(lancer, essai.reflets, taille.fils));
            essai.prix = (double) lancer.getCompteurs().rayons() / taille.pixels();
            return essai;
        });
    }

    /** Le réglage le moins cher qui tient cette erreur ; {@code null} s'il n'y en a pas. */
    Essai leMoinsCher(double voulue) {
        Essai unRayon = echantillonnages.get(0);
        List<Essai> candidats = new ArrayList<>();
        for (Essai e : echantillonnages) {
            for (Essai l : limites) {
                // les carrés de deux erreurs indépendantes s'ajoutent ; celui de la limite est mesuré avec un rayon par pixel
                double perdu = Math.max(0, l.erreur * l.erreur - unRayon.erreur * unRayon.erreur);
                if (Math.sqrt(e.erreur * e.erreur + perdu) <= JEU * voulue) {
                    Essai candidat = new Essai(e.n, e.seuil, l.reflets, l.seuilDesReflets);
                    candidat.prix = e.prix * l.prix / unRayon.prix;
                    candidats.add(candidat);
                }
            }
        }
        candidats.sort(Comparator.comparingDouble(c -> c.prix));
        Essai mieux = null;
        for (Essai candidat : candidats) {
            if (mieux != null && candidat.prix > JEU * mieux.prix) {
                break;
            }
            Essai dessine = dessiner(new Essai(candidat.n, candidat.seuil, candidat.reflets, candidat.seuilDesReflets));
            mieux = dessine.erreur <= voulue && (mieux == null || dessine.prix < mieux.prix) ? dessine : mieux;
        }
        return mieux;
    }
}
