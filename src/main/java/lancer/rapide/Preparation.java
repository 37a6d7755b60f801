package lancer.rapide;

import java.util.Collections;
import java.util.List;
import java.util.function.DoubleConsumer;
import java.util.function.IntConsumer;
import lancer.Camera;
import lancer.Lampe;
import lancer.Point;
import lancer.Scene;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;
import lancer.contrat.RechercheSimple;
import lancer.fils.Equipe;

/**
 * Le choix des structures : ce que la scène et l'image demandent, et rien de plus. Une préparation vaut pour un
 * dessin : la place des objets et les lampes sont celles du moment où elle est faite.
 *
 * <p>Mémoire, pour N sphères : 40 N octets pour leur copie, 4 N + 26 N pour l'arbre, s'il sert ; la grille, au plus 4 N
 * cases et 12 N places de 4 octets ; les cartes, toutes ensemble, au plus {@value #PLACES_PAR_SPHERE} N places de 8
 * octets et autant de cases, de 12 octets, que de tuiles de l'image et que {@value #CASES_PAR_SPHERE} N ; une carte en
 * prend trois fois plus pendant qu'elle se fait. Les masques d'une petite scène en prennent 100 ko au plus.
 */
public final class Preparation {

    /** Jusqu'à ce nombre de sphères, des masques. */
    static final int PEU = 24;

    /** Hors de ces bornes, les carrés et les cubes des longueurs ne se calculent plus sans détour. */
    private static final double LONGUEUR_MIN = 1e-90;
    private static final double LONGUEUR_MAX = 1e101;

    /** Moins de questions que cela : toute structure coûterait plus que les boucles du cours. */
    private static final int QUESTIONS_MIN = 32;

    /** Plus de sphères que cela par pixel : seul l'arbre, et non une carte ou une grille, vaut d'être fait. */
    private static final int SPHERES_PAR_PIXEL = 8;

    /**
     * Places de toutes les cartes, par sphère ; cases de celles des lampes, par sphère, et d'une lampe, par sphère et
     * en tout.
     */
    private static final int PLACES_PAR_SPHERE = 26;
    private static final int CASES_PAR_SPHERE = 8;
    private static final int CASES_PAR_LAMPE = 2;
    private static final int CASES_MAX = 1 << 19;
    private static final int CASES_MIN = 1 << 10;

    /**
     * Côté d'une case de la carte de l'œil, en pixels : au plus celui-ci, et à peu près autant de cases que de sphères.
     */
    private static final int PIXELS_PAR_CASE = 16;

    /** Au-dessous de ce nombre de sphères, un fil coûte plus à lancer qu'il ne fait gagner. */
    private static final int SPHERES_PAR_FIL = 200;

    /** Ce qui est fait du travail après l'arbre, le rangement et les autres structures, à peu près. */
    private static final double PART_ARBRE = 0.3;
    private static final double PART_RANGEMENT = 0.4;
    private static final double PART_STRUCTURES = 0.9;

    /** Ce qu'un test peut imposer, au lieu du choix. */
    enum Genre { AU_CHOIX, MASQUES, CARTES, ARBRE }

    private final Equipe equipe = new Equipe("preparation");
    private final Scene scene;
    private final Camera camera;
    private final Spheres spheres;
    private final List<Lampe> lampes;
    private final Structures structures;

    private Preparation(Scene scene, Camera camera) {
        this.scene = scene;
        this.camera = camera;
        spheres = new Spheres(scene.getObjets());
        lampes = scene.getLampes();
        structures = new Structures(spheres, new Arbre(spheres, equipe), lampes);
    }

    /**
     * La recherche la plus rapide pour dessiner cette scène vue de cette caméra.
     *
     * @throws java.util.concurrent.CancellationException si le fil appelant est interrompu
     * @return une recherche de même image et mêmes comptes de rayons que {@link RechercheSimple}
     */
    public static Recherche pour(Scene scene, Camera camera) {
        return pour(scene, camera, part -> { });
    }

    /** De même, en disant à {@code suivi} la part faite, de 0 à 1, après chaque étape. */
    public static Recherche pour(Scene scene, Camera camera, DoubleConsumer suivi) {
        long questions = (long) camera.getLargeur() * camera.getHauteur() * (2 + scene.getLampes().size());
        return questions <= QUESTIONS_MIN ? new RechercheSimple(scene.getObjets(), scene.getCompteurs())
                : pour(scene, camera, Genre.AU_CHOIX, suivi);
    }

    static Recherche pour(Scene scene, Camera camera, Genre genre, DoubleConsumer suivi) {
        return new RechercheRapide(new Preparation(scene, camera).faire(genre, suivi), new Compteurs());
    }

    private Structures faire(Genre genre, DoubleConsumer suivi) {
        suivi.accept(PART_ARBRE);
        int n = spheres.nombre;
        Boite boite = Boite.de(spheres, spheres.toutes());
        double portee = Math.max(boite.portee(), Camera.FOCALE);
        boolean masques = genre == Genre.AU_CHOIX ? n <= PEU : genre == Genre.MASQUES && n <= Masques.MAX;
        long pixels = (long) camera.getLargeur() * camera.getHauteur();
        if (n == 0 || genre == Genre.ARBRE || !(portee < LONGUEUR_MAX && boite.portee() > LONGUEUR_MIN)) {
            return structures;
        }
        if (masques) {
            Masques parBits = new Masques(spheres, structures.arbre, portee, camera);
            structures.premiers = parBits;
            structures.suivants = parBits;
            for (int l = 0; l < structures.ombres.length; l++) {
                if (!Scene.estLointaine(lampes.get(l))) {
                    structures.ombres[l] = parBits.ombres(lampes.get(l).getPosition());
                }
            }
            return structures;
        }
        spheres.ranger(Morton.ordre(spheres, boite));
        if (genre == Genre.AU_CHOIX && n > SPHERES_PAR_PIXEL * pixels) {
            return structures;
        }
        suivi.accept(PART_RANGEMENT);
        construire(suivi);
        return genre == Genre.CARTES ? structures : new Sondage(scene, camera, equipe).choisir(structures);
    }

    /** La grille et les cartes, sans rapport entre elles, par autant de fils que de cœurs si cela en vaut la peine. */
    private void construire(DoubleConsumer suivi) {
        int nombre = 2 + structures.ombres.length;
        IntConsumer construction = new IntConsumer() {
            @Override
            public void accept(int k) {
                if (k == 0) {
                    Grille grille = Grille.de(spheres, structures.arbre, equipe);
                    structures.suivants = grille == null ? structures.arbre : grille;
                } else if (k <= structures.ombres.length) {
                    structures.ombres[k - 1] = deLaLampe(lampes.get(k - 1));
                } else {
                    structures.premiers = deLOeil();
                }
                int faites = 1 + equipe.getFaites();
                suivi.accept(PART_RANGEMENT + (PART_STRUCTURES - PART_RANGEMENT) * faites / nombre);
            }
        };
        if (spheres.nombre < SPHERES_PAR_FIL) {
            for (int k = 0; k < nombre; k++) {
                construction.accept(k);
            }
        } else {
            int fils = Math.min(nombre, Runtime.getRuntime().availableProcessors());
            equipe.faire(nombre, Collections.nCopies(fils, construction));
        }
    }

    private Occultations deLaLampe(Lampe lampe) {
        long sienne = (long) spheres.nombre * CASES_PAR_SPHERE / lampes.size();
        if (Scene.estLointaine(lampe) || sienne < spheres.nombre / 16) {
            return structures.arbre;
        }
        Point p = lampe.getPosition();
        int cases = (int) Math.min(Math.min(sienne, (long) CASES_PAR_LAMPE * spheres.nombre), CASES_MAX);
        Carte carte = Carte.deLaLampe(spheres, p, Faces.pour(spheres, p.x, p.y, p.z, Math.max(CASES_MIN, cases)),
                places(), equipe);
        return carte == null ? structures.arbre : new CarteLampe(spheres, p, carte, structures.arbre);
    }

    private Intersections deLOeil() {
        double pixels = (double) camera.getLargeur() * camera.getHauteur();
        double cote = Math.min(PIXELS_PAR_CASE, Math.sqrt(pixels / Math.min(CASES_MAX, spheres.nombre)));
        Carte carte = Carte.deLOeil(spheres, Face.deLImage(camera, cote), structures.arbre, places(), equipe);
        return carte == null ? structures.arbre : carte;
    }

    /** La part d'une carte : celle de l'œil en a une aussi. */
    private long places() {
        return CASES_MIN + (long) spheres.nombre * PLACES_PAR_SPHERE / (1 + lampes.size());
    }
}
