package lancer.rapide;

import java.util.Arrays;
import java.util.List;
import lancer.Camera;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Scene;
import lancer.contrat.Compteurs;

/**
 * Le garde-fou : quelques pixels de l'image, semés sur une grille, disent ce que coûte chaque structure. Là où elle
 * coûte plus qu'un bon arbre, on construit l'arbre, on lui pose les mêmes questions, et le moins cher reste. Aucune
 * scène ne tombe ainsi dans un trou (sol immense, amas dispersés), et l'arbre n'est pas construit là où il ne servirait
 * pas.
 */
final class Choix {

    /** Pixels semés par côté de l'image, et réflexions suivies. */
    private static final int SEMIS = 24;
    private static final int REFLETS = 2;

    /** Sphères et cases examinées par question, au-dessous desquelles l'arbre ne ferait pas mieux. */
    private static final double BON_MARCHE = 32;

    /** Rangs des sortes de questions : les premiers rayons, les suivants, puis l'ombre de chaque lampe. */
    private static final int PREMIERS = 0;
    private static final int SUIVANTS = 1;
    private static final int OMBRES = 2;

    private final Preparation preparation;
    private final List<Lampe> lampes;

    Choix(Preparation preparation, List<Lampe> lampes) {
        this.preparation = preparation;
        this.lampes = lampes;
    }

    /**
     * Remplace par {@code arbre}, dans {@code voisins} (premiers, suivants) et {@code obstacles}, ce qui coûte plus que
     * lui.
     */
    void faire(Scene scene, Camera camera, Voisins[] voisins, Obstacles[] obstacles, Secours arbre) {
        RechercheRapide choisie = new RechercheRapide(preparation, voisins[PREMIERS], voisins[SUIVANTS], obstacles,
                new Compteurs());
        Ecoute ecoute = new Ecoute(choisie);
        semer(scene, camera, ecoute);
        long[] couts = couts(ecoute.questions);
        int[] nombres = new int[couts.length];
        for (Question q : ecoute.questions) {
            nombres[sorte(q)]++;
        }
        boolean[] cheres = new boolean[couts.length];
        boolean uneChere = false;
        for (int s = 0; s < couts.length; s++) {
            cheres[s] = couts[s] > BON_MARCHE * nombres[s];
            uneChere |= cheres[s];
        }
        if (!uneChere) {
            return;
        }
        Obstacles[] partout = new Obstacles[obstacles.length];
        Arrays.fill(partout, arbre);
        Ecoute autre = new Ecoute(new RechercheRapide(preparation, arbre, arbre, partout, new Compteurs()));
        for (Question q : ecoute.questions) {
            q.memeReponse(autre);
        }
        long[] coutsDeLArbre = couts(autre.questions);
        for (int s = 0; s < couts.length; s++) {
            if (cheres[s] && coutsDeLArbre[s] < couts[s]) {
                if (s < OMBRES) {
                    voisins[s] = arbre;
                } else {
                    obstacles[s - OMBRES] = arbre;
                }
            }
        }
    }

    private static void semer(Scene scene, Camera camera, Ecoute ecoute) {
        Scene vue = scene.pourUnFil();
        vue.setRecherche(ecoute);
        Lancer lancer = new Lancer(vue, camera);
        for (int j = 0; j < SEMIS; j++) {
            for (int i = 0; i < SEMIS; i++) {
                try {
                    lancer.getCouleurPixel((i + 0.5) * camera.getLargeur() / SEMIS,
                            (j + 0.5) * camera.getHauteur() / SEMIS, REFLETS);
                } catch (RuntimeException | StackOverflowError | LinkageError e) {
                    // ce qui échoue ici échouera au dessin, qui dira où
                }
            }
        }
    }

    private long[] couts(List<Question> questions) {
        long[] couts = new long[OMBRES + lampes.size()];
        for (Question q : questions) {
            couts[sorte(q)] += q.cout;
        }
        return couts;
    }

    private int sorte(Question q) {
        return q.lampe != null ? OMBRES + lampes.indexOf(q.lampe) : q.saufLui == null ? PREMIERS : SUIVANTS;
    }
}
