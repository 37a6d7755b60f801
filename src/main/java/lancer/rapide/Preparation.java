package lancer.rapide;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.function.IntConsumer;
import lancer.Camera;
import lancer.Constantes;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Point;
import lancer.Scene;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;
import lancer.contrat.RechercheSimple;
import lancer.fils.Equipe;

/**
 * Le choix des structures : ce que la scène demande, et rien de plus. Une préparation vaut pour un dessin : la place
 * des objets, leurs matières et les lampes sont celles du moment où elle est faite.
 */
public final class Preparation {

    /** Jusqu'à ce nombre de sphères, les masques, et la boucle là où ils ne savent pas répondre ; au-delà, l'arbre. */
    static final int PEU = 24;

    /**
     * Une sphère de tant de fois le rayon médian couvrirait presque toute la grille ; il y en a au plus tant, à part.
     */
    static final double GROSSE = 50;
    static final int GROSSES_MAX = 8;

    /**
     * Cases d'une carte de lampe : tant par sphère, entre ces bornes. De 1 à 16 par sphère le dessin dure autant (7381
     * à 100 000 sphères), et la construction deux fois moins ; au-delà de 2^19, les cases ne tiennent plus dans les
     * caches.
     */
    private static final int CASES_PAR_SPHERE = 2;
    private static final int CASES_MIN = 1 << 10;
    private static final int CASES_MAX = 1 << 19;

    /**
     * Côté d'une case de la carte de l'œil, en pixels : au plus celui-ci, et à peu près autant de cases que de sphères.
     * 8 ne dessine pas plus vite (10 à 1000 sphères).
     */
    private static final int PIXELS_PAR_CASE = 16;

    /** Au-dessous de ce nombre de sphères, un fil coûte plus à lancer qu'il ne fait gagner. */
    private static final int SPHERES_PAR_FIL = 200;

    private final Spheres spheres;
    private final List<Lampe> lampes;
    private final Voisins general;
    private final Obstacles obstacleGeneral;
    private Voisins premiers;
    private Voisins suivants;
    private final Obstacles[] obstacles;

    private Preparation(Scene scene, Camera camera, Reglage reglage) {
        spheres = new Spheres(scene.getObjets());
        lampes = scene.getLampes();
        obstacles = new Obstacles[lampes.size()];
        int n = spheres.nombre;
        int[] lesquelles = Grosses.lesAutres(spheres, n <= PEU ? 0 : GROSSES_MAX);
        Etendue boite = Etendue.de(spheres, lesquelles);
        double portee = Math.max(boite.portee(), -Camera.OEIL.z);
        boolean peu = reglage.peu == null ? n <= PEU : reglage.peu;
        // rien à chercher, ou des longueurs que des flottants courts ne tiennent pas
        if (lesquelles.length == 0
                || !(boite.portee() < Etendue.LONGUEUR_MAX && boite.portee() > Etendue.LONGUEUR_MIN)) {
            Boucle boucle = new Boucle(spheres);
            general = boucle;
            obstacleGeneral = boucle;
            premiers = boucle;
            suivants = boucle;
            Arrays.fill(obstacles, boucle);
            return;
        }
        if (peu) {
            Boucle boucle = new Boucle(spheres);
            general = boucle;
            obstacleGeneral = boucle;
            Masques masques = reglage.arbreSeul || n > Masques.MAX ? null
                    : new Masques(spheres, boucle, portee, camera);
            premiers = masques == null ? boucle : masques;
            suivants = premiers;
            for (int l = 0; l < obstacles.length; l++) {
                obstacles[l] = masques == null ? boucle : masques.obstacles(lampes.get(l).getPosition());
            }
            return;
        }
        spheres.ranger(Morton.ordre(spheres, boite));
        lesquelles = Grosses.lesAutres(spheres, GROSSES_MAX);
        double lointaine = portee;
        for (Lampe lampe : lampes) {
            Point p = lampe.getPosition();
            double d = Math.max(Math.abs(p.x), Math.max(Math.abs(p.y), Math.abs(p.z))) / Etendue.DEPART_MAX;
            lointaine = Math.max(lointaine, d < 1e6 * portee ? d : 0);
        }
        Secours secours = new Secours(spheres, lesquelles, Grosses.complement(lesquelles, n), lointaine);
        general = secours;
        obstacleGeneral = secours;
        premiers = general;
        suivants = general;
        Arrays.fill(obstacles, obstacleGeneral);
        if (reglage.arbreSeul) {
            return;
        }
        int[] dansLaGrille = lesquelles;
        construire(new IntConsumer() {
            @Override
            public void accept(int k) {
                if (k == 0) {
                    suivants = new Grille(spheres, dansLaGrille, Grosses.complement(dansLaGrille, n), boite, general);
                } else if (k <= obstacles.length) {
                    obstacles[k - 1] = deLaLampe(lampes.get(k - 1).getPosition());
                } else {
                    premiers = deLOeil(camera);
                }
            }
        });
        if (!reglage.sansChoix) {
            Voisins[] voisins = {premiers, suivants};
            new Choix(this, lampes).faire(scene, camera, voisins, obstacles, (Secours) general);
            premiers = voisins[0];
            suivants = voisins[1];
        }
    }

    /** Les structures, sans rapport entre elles, par autant de fils que de cœurs si cela en vaut la peine. */
    private void construire(IntConsumer structure) {
        int nombre = 2 + obstacles.length;
        if (spheres.nombre < SPHERES_PAR_FIL) {
            for (int k = 0; k < nombre; k++) {
                structure.accept(k);
            }
            return;
        }
        int fils = Math.min(nombre, Runtime.getRuntime().availableProcessors());
        new Equipe("preparation").faire(nombre, Collections.nCopies(fils, structure));
    }

    private Obstacles deLaLampe(Point p) {
        int cases = (int) Math.max(CASES_MIN, Math.min(CASES_MAX, (long) CASES_PAR_SPHERE * spheres.nombre));
        Carte carte = Carte.deLaLampe(spheres, p, Faces.pour(spheres, p.x, p.y, p.z, cases));
        return carte.bonne ? new CarteLampe(spheres, carte, obstacleGeneral) : obstacleGeneral;
    }

    private Voisins deLOeil(Camera camera) {
        double pixels = (double) camera.getLargeur() * camera.getHauteur();
        double cote = Math.min(PIXELS_PAR_CASE, Math.sqrt(pixels / Math.min(CASES_MAX, Math.max(1, spheres.nombre))));
        Carte carte = Carte.deLOeil(spheres, Face.deLImage(camera, cote), general);
        return carte.bonne ? carte : general;
    }

    /**
     * Prépare une scène pour une image de cette taille : tout dessin du programme passe par ici, et ceux qu'on mesure
     * aussi.
     *
     * @param simple vrai pour les boucles du cours
     */
    public static Lancer preparer(Scene scene, int largeur, int hauteur, boolean simple) {
        Camera camera = new Camera(largeur, hauteur);
        scene.setRecherche(simple
                ? new RechercheSimple(scene.getObjets(), scene.getCompteurs()) : pour(scene, camera));
        return new Lancer(scene, camera);
    }

    /**
     * La recherche la plus rapide pour dessiner cette scène vue de cette caméra.
     *
     * @return une recherche de même image et mêmes comptes de rayons que {@link RechercheSimple}
     */
    public static Recherche pour(Scene scene, Camera camera) {
        return pour(scene, camera, new Reglage());
    }

    static Recherche pour(Scene scene, Camera camera, Reglage reglage) {
        Preparation p = de(scene, camera, reglage);
        return new RechercheRapide(p, p.premiers, p.suivants, p.obstacles, new Compteurs());
    }

    static Preparation de(Scene scene, Camera camera, Reglage reglage) {
        return new Preparation(scene, camera, reglage);
    }

    Spheres getSpheres() {
        return spheres;
    }

    Lampe[] lampes() {
        return lampes.toArray(new Lampe[0]);
    }

    /** Les obstacles d'une lampe qui n'est pas de la scène. */
    Obstacles obstacleGeneral() {
        return obstacleGeneral;
    }

    /**
     * Les structures choisies, par leurs noms : celle des premiers rayons, celle des réfléchis, celle de chaque lampe.
     */
    @Override
    public String toString() {
        StringBuilder noms = new StringBuilder(premiers.getClass().getSimpleName() + " "
                + suivants.getClass().getSimpleName());
        for (Obstacles obstacle : obstacles) {
            noms.append(' ').append(obstacle.getClass().getSimpleName());
        }
        return noms.toString();
    }

    /** Ce qu'un test peut imposer. */
    static final class Reglage {

        /** Vrai ou faux pour faire comme si les sphères étaient peu, ou non. */
        Boolean peu;

        /** Vrai pour l'arbre seul (ou la boucle seule, si elles sont peu). */
        boolean arbreSeul;

        /** Vrai pour garder les structures même là où l'arbre vaudrait mieux. */
        boolean sansChoix;
    }
}
