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
import lancer.fils.Calcul;
import lancer.fils.Equipe;

/**
 * Le choix des structures : ce que la scène et l'image demandent, et rien de plus ; d'une ou deux sphères, ou de
 * quelques pixels de peu de sphères, les boucles du cours répondent seules, et rien n'est sondé. Une préparation vaut
 * pour un dessin : la place des objets et les lampes sont celles du moment où elle est faite. Un mauvais choix ne coûte
 * qu'une construction : ce que les structures examinent est compté, rayon par rayon ({@link EtatDeRecherche}).
 *
 * <p>Mémoire, pour N sphères : 40 N octets pour leur copie, 4 N + 26 N pour l'arbre, s'il sert ; la grille, au plus 4 N
 * cases et 12 N places de 4 octets ; les cartes, toutes ensemble, au plus {@value #PLACES_PAR_SPHERE} N places de 8
 * octets, ou 8 Mo si c'est plus, et autant de cases, de 12 octets, que de tuiles de l'image et que
 * {@value #CASES_PAR_SPHERE} N, ou 3 Mo si c'est plus. Les masques d'une petite scène en prennent 170 ko, et ceux de
 * ses ombres 1 Mo au plus.
 */
public final class Preparation implements IntConsumer, Calcul {

    /** Nombre d'objets jusqu'auquel les boucles du cours répondent plus vite que toute structure. */
    private static final int DEUX = 2;

    /**
     * Produit des pixels, des objets et des rayons d'un contact jusqu'auquel une petite scène se dessine par ces
     * boucles avant qu'une structure soit faite et sondée. Mesuré sur des programmes entiers, avec et sans
     * {@code --simple} : {@code make mesure-processus}.
     */
    private static final long VITE_FAIT = 1 << 20;

    /** Nombre de sphères jusqu'auquel ce sont des masques. */
    static final int PEU = 40;

    /** Bornes hors desquelles les carrés et les cubes des longueurs ne se calculent plus sans détour. */
    private static final double LONGUEUR_MIN = 1e-90;
    private static final double LONGUEUR_MAX = 1e101;

    /** Nombre de sphères par pixel au-delà duquel ni carte, ni grille ne vaut d'être faite. */
    private static final int SPHERES_PAR_PIXEL = 8;

    /** Les masques des ombres d'une lampe regardent chaque sphère de chaque autre : il leur faut assez de pixels. */
    private static final int PAIRES_PAR_PIXEL = 4;

    /** Masques des ombres, au plus : un par lampe et par sphère. */
    private static final int MASQUES_D_OMBRES = 1 << 16;

    /**
     * Places de toutes les cartes, par sphère ; cases de celles des lampes, par sphère, et d'une lampe, par sphère et
     * en tout.
     */
    private static final int PLACES_PAR_SPHERE = 26;
    private static final int CASES_PAR_SPHERE = 8;

    /** Places et cases de toutes les cartes que l'on a toujours : de quoi faire celles de cent lampes. */
    private static final long PLACES_TOUJOURS = 1 << 20;
    private static final long CASES_TOUJOURS = 1 << 18;
    private static final int CASES_PAR_LAMPE = 2;
    private static final int CASES_MAX = 1 << 19;
    private static final int CASES_MIN = 1 << 10;

    /**
     * Côté d'une case de la carte de l'œil, en pixels : au plus celui-ci, et à peu près autant de cases que de sphères.
     */
    private static final int PIXELS_PAR_CASE = 16;

    /** Nombre de sphères au-dessous duquel un fil coûte plus à lancer qu'il ne fait gagner. */
    private static final int SPHERES_PAR_FIL = 200;

    /** Part du travail faite après la copie, à peu près. */
    private static final double PART_COPIE = 0.3;

    /** Les structures possibles : ce que le choix dit, ou qu'un test impose. */
    enum Genre { MASQUES, CARTES, ARBRE }

    private final Camera camera;
    private final Spheres spheres;
    private final List<Lampe> lampes;
    private final Structures structures;
    private final long pixels;
    private final DoubleConsumer suivi;
    /** La plus grande coordonnée des sphères : une lampe qui en est lointaine l'est de tous leurs contacts. */
    private Point bout;
    private final Equipe equipe = new Equipe("preparation");

    private Preparation(Scene scene, Camera camera, DoubleConsumer suivi) {
        this.camera = camera;
        this.suivi = suivi;
        spheres = new Spheres(scene.getObjets());
        lampes = scene.getLampes();
        structures = new Structures(spheres, lampes);
        pixels = (long) camera.getLargeur() * camera.getHauteur();
    }

    /** Dit si préparer une recherche pour cette image prend moins de temps que les boucles du cours. */
    public static boolean estUtile(Scene scene, Camera camera) {
        int objets = scene.getObjets().size();
        long pixels = (long) camera.getLargeur() * camera.getHauteur();
        return objets > PEU || objets > DEUX && pixels * objets * (1 + scene.getLampes().size()) > VITE_FAIT;
    }

    /**
     * La recherche la plus rapide pour dessiner cette scène vue de cette caméra.
     *
     * @param suivi à qui se dit la part faite, de 0 à 1, après chaque étape
     * @return une recherche de même image et mêmes comptes de rayons que les boucles du cours
     * @throws java.util.concurrent.CancellationException si le fil appelant est interrompu
     */
    public static RechercheRapide pour(Scene scene, Camera camera, DoubleConsumer suivi) {
        return pour(scene, camera, null, suivi);
    }

    /** @param impose {@code null} pour laisser le choix entre les structures */
    static RechercheRapide pour(Scene scene, Camera camera, Genre impose, DoubleConsumer suivi) {
        Preparation preparation = new Preparation(scene, camera, suivi);
        suivi.accept(PART_COPIE);
        preparation.faire(impose);
        return new RechercheRapide(preparation.structures, new Compteurs());
    }

    private void faire(Genre impose) {
        int n = spheres.nombre;
        Boite boite = Boite.de(spheres, spheres.toutes());
        bout = new Point(boite.portee(), 0, 0);
        double portee = Math.max(bout.x, Math.abs(camera.getOeil().z));
        boolean ordinaire = n > 0 && portee < LONGUEUR_MAX && bout.x > LONGUEUR_MIN;
        Genre genre = impose != null ? impose
                : n <= PEU ? Genre.MASQUES : n <= SPHERES_PAR_PIXEL * pixels ? Genre.CARTES : Genre.ARBRE;
        if (genre == Genre.MASQUES && n <= Masques.MAX && ordinaire) {
            masquer(portee);
        } else if (genre == Genre.CARTES && ordinaire) {
            construire();
        }
    }

    private void masquer(double portee) {
        Masques parBits = new Masques(spheres, structures.arbre, portee, camera);
        structures.premiers = parBits;
        structures.suivants = parBits;
        boolean assez = pixels * PAIRES_PAR_PIXEL >= (long) spheres.nombre * spheres.nombre;
        int masquees = Math.min(MASQUES_D_OMBRES / spheres.nombre, lampes.size());
        for (int l = 0; assez && l < masquees; l++) {
            Recherche.obeir();
            if (!Scene.estLointaine(lampes.get(l), bout)) {
                structures.ombres[l] = parBits.new Ombres(lampes.get(l).getPosition());
            }
        }
    }

    /** La grille et les cartes, sans rapport entre elles, par autant de fils que de cœurs si cela en vaut la peine. */
    private void construire() {
        int nombre = 2 + structures.ombres.length;
        int fils = spheres.nombre < SPHERES_PAR_FIL ? 1 : Math.min(nombre, Runtime.getRuntime().availableProcessors());
        equipe.faire(nombre, Collections.nCopies(fils, this), Collections.nCopies(fils, this));
    }

    /** Fait la grille, la carte de la lampe de ce rang moins un, ou enfin celle de l'œil. */
    @Override
    public void accept(int k) {
        Recherche.obeir();
        if (k == 0) {
            Grille grille = Grille.de(spheres, structures.arbre);
            structures.suivants = grille == null ? structures.arbre : grille;
        } else if (k <= structures.ombres.length) {
            structures.ombres[k - 1] = deLaLampe(lampes.get(k - 1));
        } else {
            structures.premiers = deLOeil();
        }
        suivi.accept(PART_COPIE + (1 - PART_COPIE) * (1 + equipe.getFaites()) / (2 + structures.ombres.length));
    }

    private Occultations deLaLampe(Lampe lampe) {
        long sienne = Math.max((long) spheres.nombre * CASES_PAR_SPHERE, CASES_TOUJOURS) / lampes.size();
        if (Scene.estLointaine(lampe, bout) || sienne < spheres.nombre / 16) {
            return structures.arbre;
        }
        Point p = lampe.getPosition();
        int cases = (int) Math.min(Math.min(sienne, (long) CASES_PAR_LAMPE * spheres.nombre), CASES_MAX);
        Carte carte = Carte.de(spheres, p, false, Faces.pour(spheres, p.x, p.y, p.z, Math.max(CASES_MIN, cases)),
                structures.arbre, places());
        return carte == null ? structures.arbre : carte;
    }

    private Intersections deLOeil() {
        double cote = Math.min(PIXELS_PAR_CASE, Math.sqrt(pixels / (double) Math.min(CASES_MAX, spheres.nombre)));
        // un œil hors de l'axe n'a pas de rayon dans cette carte
        Carte carte = Carte.de(spheres, new Point(0, 0, camera.getOeil().z), true,
                new Face[] {Face.deLImage(camera, cote)}, structures.arbre, places());
        return carte == null ? structures.arbre : carte;
    }

    /** La part d'une carte : celle de l'œil en a une aussi. */
    private long places() {
        return CASES_MIN + Math.max((long) spheres.nombre * PLACES_PAR_SPHERE, PLACES_TOUJOURS) / (1 + lampes.size());
    }
}
