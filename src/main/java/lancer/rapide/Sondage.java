package lancer.rapide;

import java.util.Arrays;
import java.util.Random;
import java.util.concurrent.CancellationException;
import java.util.function.IntConsumer;
import lancer.Camera;
import lancer.Constantes;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;
import lancer.fils.Equipe;

/**
 * Le garde-fou : quelques pixels disent ce que coûte chaque structure. Là où elle coûte plus que presque rien, on
 * construit l'arbre, on lui pose les mêmes questions, et le moins cher reste. Une moitié des pixels est semée au hasard
 * sur un quadrillage de l'image, l'autre là où se voient des sphères tirées au sort : un amas de quelques pixels, si
 * beaucoup de sphères y sont, ne passe pas entre les mailles.
 */
final class Sondage {

    /** Pixels semés par côté de l'image, autant en tout sur des sphères, et réflexions suivies. */
    private static final int SEMIS = 17;
    private static final int REFLETS = 2;

    /** Sphères et cases examinées par question, au-dessous desquelles l'arbre ne ferait pas mieux. */
    private static final double BON_MARCHE = 10;

    /** Sphères et cases examinées au-delà desquelles un sondage en sait assez. */
    private static final long EXAMENS = 2_000_000;

    private static final long GRAINE = 24;

    /** Rangs des sortes de questions : les premiers rayons, les suivants, puis l'ombre de chaque lampe. */
    private static final int PREMIERS = 0;
    private static final int SUIVANTS = 1;
    private static final int OMBRES = 2;

    private final Scene scene;
    private final Camera camera;
    private final Equipe equipe;

    Sondage(Scene scene, Camera camera, Equipe equipe) {
        this.scene = scene;
        this.camera = camera;
        this.equipe = equipe;
    }

    /** Remplace par l'arbre, dans ces structures, celles qui coûtent plus que lui. */
    Structures choisir(Structures structures) {
        double[][] pixels = semer(structures.spheres);
        Releve leur = new Releve(structures, pixels, Long.MAX_VALUE);
        structures.essais = leur.examines();
        boolean uneChere = false;
        for (int s = 0; s < leur.couts.length; s++) {
            uneChere |= leur.chere(s);
        }
        if (!uneChere) {
            return structures;
        }
        Structures arbre = new Structures(structures.spheres, structures.arbre, Arrays.asList(structures.lampes));
        equipe.faire(1, Arrays.<IntConsumer>asList(k -> structures.arbre.noeuds()));
        Releve sien = new Releve(arbre, pixels, leur.questions);
        structures.essais += sien.examines();
        for (int s = 0; s < leur.couts.length; s++) {
            if (leur.chere(s) && sien.couts[s] < leur.couts[s]) {
                if (s == PREMIERS) {
                    structures.premiers = structures.arbre;
                } else if (s == SUIVANTS) {
                    structures.suivants = structures.arbre;
                } else {
                    structures.ombres[s - OMBRES] = structures.arbre;
                }
            }
        }
        return structures;
    }

    /** Les points de l'image à sonder, en pixels. */
    private double[][] semer(Spheres spheres) {
        Random hasard = new Random(GRAINE);
        double[][] pixels = new double[2 * SEMIS * SEMIS][2];
        for (int p = 0; p < pixels.length; p++) {
            double x = (p % SEMIS + hasard.nextDouble()) / SEMIS * camera.getLargeur();
            double y = (p / SEMIS % SEMIS + hasard.nextDouble()) / SEMIS * camera.getHauteur();
            if (p >= SEMIS * SEMIS) {
                int s = Spheres.PAS * hasard.nextInt(spheres.nombre);
                double[] g = spheres.geometrie;
                double parUnite = camera.getLargeur() / Constantes.ECHELLE * Camera.FOCALE
                        / (g[s + 2] + Camera.FOCALE);
                double xs = camera.getLargeur() / 2.0 + g[s] * parUnite;
                double ys = camera.getHauteur() / 2.0 - g[s + 1] * parUnite;
                if (parUnite > 0 && xs > 0 && xs < camera.getLargeur() && ys > 0 && ys < camera.getHauteur()) {
                    x = xs;
                    y = ys;
                }
            }
            pixels[p][0] = x;
            pixels[p][1] = y;
        }
        return pixels;
    }

    /** Ce que coûtent à des structures les questions de ces pixels, sorte par sorte. */
    private final class Releve implements Recherche {

        final long[] couts;
        final long[] nombres;
        long questions;
        private final Lampe[] lampes;
        private final Compteurs compteurs = new Compteurs();
        private final Recherche recherche;

        /** @param questionsMax nombre de questions où s'arrêter */
        Releve(Structures structures, double[][] pixels, long questionsMax) {
            lampes = structures.lampes;
            couts = new long[OMBRES + lampes.length];
            nombres = new long[couts.length];
            recherche = new RechercheRapide(structures, compteurs);
            Scene vue = scene.avec(scene.getModele());
            vue.getModele().setRecherche(this);
            Lancer lancer = new Lancer(vue, camera);
            for (int p = 0; p < pixels.length && examines() < EXAMENS && questions < questionsMax; p++) {
                if (Thread.currentThread().isInterrupted()) {
                    throw new CancellationException("préparation interrompue");
                }
                try {
                    lancer.getCouleurPixel(pixels[p][0], pixels[p][1], REFLETS);
                } catch (RuntimeException | StackOverflowError | LinkageError e) {
                    // ce qui échoue ici échouera au dessin, qui dira où
                }
            }
        }

        boolean chere(int sorte) {
            return couts[sorte] > BON_MARCHE * nombres[sorte];
        }

        long examines() {
            return compteurs.testsSpheres + compteurs.noeudsVisites;
        }

        private void noter(int sorte, long avant) {
            couts[sorte] += examines() - avant;
            nombres[sorte]++;
            questions++;
        }

        @Override
        public void plusProche(Rayon incident, Objet3D saufLui) {
            long avant = examines();
            recherche.plusProche(incident, saufLui);
            noter(saufLui == null ? PREMIERS : SUIVANTS, avant);
        }

        @Override
        public boolean estCachee(Lampe lampe, Point P, Vecteur V, double distance, Objet3D objet) {
            long avant = examines();
            boolean cachee = recherche.estCachee(lampe, P, V, distance, objet);
            for (int l = 0; l < lampes.length; l++) {
                if (lampes[l] == lampe) {
                    noter(OMBRES + l, avant);
                }
            }
            return cachee;
        }

        @Override
        public Recherche pourUnFil(Compteurs autres) {
            return recherche.pourUnFil(autres);
        }
    }
}
