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
import lancer.fils.Equipe;

/**
 * Choix et construction des structures de recherche, selon la scène et l'image. Une préparation ne vaut que pour un
 * dessin : les objets et les lampes n'y changent pas. Un mauvais choix ne coûte que sa construction, car le crédit d'un
 * {@link EtatDeRecherche} borne les examens.
 *
 * <p>Mémoire pour N sphères : leur copie prend 40 N octets, et l'arbre, s'il est construit, 4 N + 26 N. La grille a au
 * plus 4 N cases et 12 N places de 4 octets. Toutes les cartes ensemble ont au plus {@value #PLACES_PAR_SPHERE} N
 * places de 8 octets, ou 8 Mo si c'est plus. Elles ont au plus une case de 12 octets par tuile de l'image, plus
 * {@value #CASES_PAR_SPHERE} N, ou 3 Mo si c'est plus. Les masques prennent 170 ko, et ceux des ombres 1 Mo au plus.
 */
public final class Preparation implements IntConsumer {

    /** Nombre d'objets jusqu'auquel les boucles du cours sont plus rapides que toute structure. */
    private static final int DEUX = 2;

    /**
     * Plus grand produit des pixels, des objets et des rayons par contact d'une petite scène. Les boucles du cours y
     * finissent avant la construction d'une structure et son sondage.
     */
    private static final long VITE_FAIT = 1 << 20;

    /** Nombre de sphères jusqu'auquel les structures sont des masques. */
    static final int PEU = 40;

    /** Bornes hors desquelles le calcul des carrés et des cubes des longueurs déborde. */
    private static final double LONGUEUR_MIN = 1e-90;
    private static final double LONGUEUR_MAX = 1e101;

    /** Nombre de sphères par pixel au-delà duquel ni carte ni grille n'est construite. */
    private static final int SPHERES_PAR_PIXEL = 8;

    /** Les masques d'ombre d'une lampe demandent N² examens, soit au plus ce nombre par pixel. */
    private static final int PAIRES_PAR_PIXEL = 4;

    /** Nombre maximal de masques d'ombre, un par lampe et par sphère. */
    private static final int MASQUES_D_OMBRES = 1 << 16;

    /** Par sphère : nombre de places de toutes les cartes, puis nombre de cases des cartes de toutes les lampes. */
    private static final int PLACES_PAR_SPHERE = 26;
    private static final int CASES_PAR_SPHERE = 8;

    /** Places et cases toujours permises ; nombre de cases d'une lampe : par sphère, maximum, minimum. */
    private static final long PLACES_TOUJOURS = 1 << 20;
    private static final long CASES_TOUJOURS = 1 << 18;
    private static final int CASES_PAR_LAMPE = 2;
    private static final int CASES_MAX = 1 << 19;
    private static final int CASES_MIN = 1 << 10;

    /** Côté maximal d'une case de la carte de l'œil, en pixels ; il y a à peu près autant de cases que de sphères. */
    private static final int PIXELS_PAR_CASE = 16;

    /** Nombre de sphères au-dessous duquel un seul fil construit les structures. */
    private static final int SPHERES_PAR_FIL = 200;

    /** Part approchée de la préparation faite après la copie des sphères. */
    private static final double PART_COPIE = 0.3;

    /** Les structures possibles, qu'un test peut imposer. */
    enum Genre { MASQUES, CARTES, ARBRE }

    private final Camera camera;
    private final Spheres spheres;
    private final List<Lampe> lampes;
    private final Structures structures;
    private final long pixels;
    private final DoubleConsumer suivi;
    /** Point de plus grande coordonnée des sphères : une lampe lointaine pour ce point l'est pour tout contact. */
    private Point bout;
    private final Equipe equipe = new Equipe("preparation");
    /** Nombre d'étapes faites. */
    private int faites;

    private Preparation(Scene scene, Camera camera, DoubleConsumer suivi) {
        this.camera = camera;
        this.suivi = suivi;
        spheres = new Spheres(scene.getObjets());
        lampes = scene.getLampes();
        structures = new Structures(spheres, lampes);
        pixels = (long) camera.getLargeur() * camera.getHauteur();
    }

    /** Choisit la recherche de cette scène pour une image. @param simple vrai pour les boucles du cours */
    public static void choisir(Scene scene, Camera camera, boolean simple, DoubleConsumer suivi) {
        scene.getModele().setRecherche(simple || !estUtile(scene, camera) ? null : pour(scene, camera, suivi));
    }

    /** Dit si les structures, construction comprise, répondent plus vite à cette image que les boucles du cours. */
    static boolean estUtile(Scene scene, Camera camera) {
        int objets = scene.getObjets().size();
        long pixels = (long) camera.getLargeur() * camera.getHauteur();
        return objets > PEU || objets > DEUX && pixels * objets * (1 + scene.getLampes().size()) > VITE_FAIT;
    }

    /**
     * La recherche la plus rapide pour dessiner cette scène vue de cette caméra.
     *
     * @param suivi reçoit la part faite, de 0 à 1, après chaque étape
     * @return une recherche qui donne la même image et les mêmes nombres de rayons que les boucles du cours
     * @throws java.util.concurrent.CancellationException si le fil appelant est interrompu
     */
    public static RechercheRapide pour(Scene scene, Camera camera, DoubleConsumer suivi) {
        return pour(scene, camera, null, suivi);
    }

    /** @param impose structure imposée par un test ; {@code null} pour laisser le choix */
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

    /** Construit la grille et les cartes, en plusieurs fils s'il y a assez de sphères. */
    private void construire() {
        int nombre = 2 + structures.ombres.length;
        int fils = spheres.nombre < SPHERES_PAR_FIL ? 1 : Math.min(nombre, Runtime.getRuntime().availableProcessors());
        equipe.faire(nombre, Collections.nCopies(fils, this));
    }

    /** Construit la grille (rang 0), la carte d'une lampe, ou celle de l'œil (dernier rang). */
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
        synchronized (this) {
            faites++;
            suivi.accept(PART_COPIE + (1 - PART_COPIE) * faites / (2 + structures.ombres.length));
        }
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
        // si l'œil est hors de l'axe, cette carte n'accepte aucun rayon
        Carte carte = Carte.de(spheres, new Point(0, 0, camera.getOeil().z), true,
                new Face[] {Face.deLImage(camera, cote)}, structures.arbre, places());
        return carte == null ? structures.arbre : carte;
    }

    /** Nombre maximal de places d'une carte : une part égale pour l'œil et pour chaque lampe. */
    private long places() {
        return CASES_MIN + Math.max((long) spheres.nombre * PLACES_PAR_SPHERE, PLACES_TOUJOURS) / (1 + lampes.size());
    }
}
