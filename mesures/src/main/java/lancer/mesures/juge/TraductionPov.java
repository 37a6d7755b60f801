package lancer.mesures.juge;

import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lancer.Camera;
import lancer.Couleur;
import lancer.Objet3D;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.systeme.Echec;

/**
 * Traduction d'une scène pour POV-Ray 3.7. Les axes sont les mêmes. Il n'y a ni lumière ambiante, ni gamma. Le ciel est une fonction de la
 * hauteur du rayon.
 *
 * <p>Les termes se correspondent un à un (source de POV-Ray 3.7, {@code source/backend/render/trace.cpp}). {@code diffuse} est Kd ⊗ K_L
 * (N·L). {@code phong} est K_L (R·L)^phong_size, multiplié par un seul nombre : si un Ks est coloré, il faut un dessin par composante.
 * {@code reflection} est Ks ⊗ la couleur du rayon réfléchi. Un rayon de niveau n (0 pour le premier) est tracé si n est inférieur à
 * {@code max_trace_level} et si le produit des plus grandes composantes de Ks atteint {@code adc_bailout}. Si les Ks sont gris, ce seuil
 * est celui de ce programme.
 *
 * <p>POV-Ray ignore un contact à moins de 1e-4 du départ d'un rayon, un obstacle à moins de 1e-3, et tout objet au-delà de 1e7 (source,
 * {@code MIN_ISECT_DEPTH}, {@code SHADOW_TOLERANCE}, {@code MAX_DISTANCE}). La scène est donc agrandie d'une puissance de deux, ce qui ne
 * change ni les chiffres de ses nombres, ni son image.
 */
final class TraductionPov {

    /** Plus grande valeur que POV-Ray accepte pour {@code max_trace_level}. */
    private static final int NIVEAUX_MAX = 256;

    /** Plus grande échelle, et plus grande coordonnée après agrandissement. */
    private static final double ECHELLE_MAX = 1024;
    private static final double ETENDUE_MAX = 4e6;

    private static final String CIEL = "sky_sphere {\n"
            + "  pigment {\n"
            // y va de -1 à 1 : la fonction reste loin de 0 et de 1, car la table des couleurs est périodique
            + "    function { 0.5 + y / 4 }\n"
            + "    color_map {\n"
            + "      [0.25 rgb <0.5, 0.2, 0.1>]\n"
            + "      [0.5 rgb <0.5, 0.4, 0.1>]\n"
            + "      [0.5 rgb <0.7, 0.7, 1>]\n"
            + "      [0.75 rgb <0, 0, 1>]\n"
            + "    }\n"
            + "  }\n"
            + "}\n";

    private final Scene scene;
    private final int reflets;
    private final Camera camera;
    private final Set<Objet3D> derriere;
    private final double echelle;

    /**
     * @param scene préparée pour cette caméra
     * @throws Echec si POV-Ray ne peut faire le même calcul
     */
    TraductionPov(Scene scene, int reflets, Camera camera) {
        this.scene = scene;
        this.reflets = reflets;
        this.camera = camera;
        if (reflets + 1 > NIVEAUX_MAX) {
            throw Echec.demande("POV-Ray ne suit pas plus de " + (NIVEAUX_MAX - 1) + " reflets");
        }
        for (Objet3D objet : scene.getObjets()) {
            if (!(objet instanceof Sphere)) {
                throw Echec.demande("un objet n'est pas une sphère : " + objet);
            }
            if (objet.getNs() == 0 && !objet.getKs().estNoire()) {
                throw Echec.demande("ns=0 : pour POV-Ray, 0^0 vaut 0");
            }
        }
        derriere = derriere();
        echelle = echelle();
    }

    /**
     * Les objets qu'un rayon de l'œil au centre d'un pixel rencontre avant l'écran. Les rayons de ce programme partent de l'écran, ceux de
     * POV-Ray de l'œil : un objet situé entre les deux n'est ici visible que dans les reflets. L'option {@code no_image} de POV-Ray a le
     * même effet, si aucun rayon de l'écran ne voit cet objet.
     */
    private Set<Objet3D> derriere() {
        double ecran = camera.depuisLOeil(camera.getEcran(0, 0)).z;
        Set<Objet3D> derriere = scene.getObjets().stream().map(Sphere.class::cast)
                .filter(s -> camera.depuisLOeil(s.getCentre()).z - s.getRayon() < ecran && rayons().map(Rayon::getP).anyMatch(
                        p -> s.getIntersectionDistance(new Rayon(camera.getOeil(), p)) <= distance(p)))
                .collect(Collectors.toSet());
        Optional<PointContact> vu = derriere.isEmpty() ? Optional.empty()
                : rayons().map(scene::getClosestIntersection).filter(c -> c != null && derriere.contains(c.objet)).findFirst();
        if (vu.isPresent()) {
            throw Echec.demande(vu.get().objet + " traverse l'écran, et se voit derrière lui");
        }
        return derriere;
    }

    /** Les rayons de l'écran de ce programme. */
    private Stream<Rayon> rayons() {
        int largeur = camera.getLargeur();
        return IntStream.range(0, largeur * camera.getHauteur()).mapToObj(k -> camera.getRayon(k % largeur + 0.5, k / largeur + 0.5));
    }

    private double echelle() {
        double etendue = DoubleStream.concat(scene.getLampes().stream().mapToDouble(l -> distance(l.getPosition())),
                scene.getObjets().stream().map(Sphere.class::cast).mapToDouble(s -> distance(s.getCentre()) + s.getRayon()))
                .reduce(distance(camera.getEcran(0, 0)), Math::max);
        double echelle = ECHELLE_MAX;
        while (echelle > 1 && echelle * etendue > ETENDUE_MAX) {
            echelle /= 2;
        }
        return echelle;
    }

    private double distance(Point p) {
        return new Vecteur(camera.getOeil(), p).norme();
    }

    /** Dit si tous les Ks sont gris : un seul dessin suffit alors. */
    static boolean estGrise(Scene scene) {
        return scene.getObjets().stream().map(Objet3D::getKs).allMatch(Ks -> Ks.r == Ks.v && Ks.v == Ks.b);
    }

    /** @param juste rang, de 0 à 2, de la composante dont les reflets des lampes sont justes ; toutes le sont si les Ks sont gris */
    String texte(int juste) {
        int largeur = camera.getLargeur();
        int hauteur = camera.getHauteur();
        String entete = "#version 3.7;\n"
                + "global_settings { assumed_gamma 1 ambient_light 0 max_trace_level " + (reflets + 1)
                + " adc_bailout " + scene.getModele().getSeuil() + " }\n"
                + "camera { perspective location " + position(camera.getOeil())
                + " direction " + vecteur(camera.getOeil(), camera.getEcran(largeur / 2.0, hauteur / 2.0))
                + " right " + vecteur(camera.getEcran(0, 0), camera.getEcran(largeur, 0))
                + " up " + vecteur(camera.getEcran(0, hauteur), camera.getEcran(0, 0)) + " }\n";
        Stream<String> lampes = scene.getLampes().stream()
                .map(l -> "light_source { " + position(l.getPosition()) + " rgb " + triplet(l.getCouleur()) + " }\n");
        Stream<String> spheres = scene.getObjets().stream().map(objet -> sphere((Sphere) objet, juste));
        return Stream.concat(lampes, spheres).collect(Collectors.joining("", entete + CIEL, ""));
    }

    private String sphere(Sphere sphere, int juste) {
        Couleur Ks = sphere.getKs();
        String brillant = Ks.estNoire() ? "" : " phong " + new double[] {Ks.r, Ks.v, Ks.b}[juste] + " phong_size " + sphere.getNs()
                + " reflection { rgb " + triplet(Ks) + " }";
        return "sphere { " + position(sphere.getCentre()) + ", " + sphere.getRayon() * echelle
                + " pigment { rgb " + triplet(sphere.getKd()) + " } finish { ambient 0 diffuse 1" + brillant + " }"
                + (derriere.contains(sphere) ? " no_image }\n" : " }\n");
    }

    private String position(Point p) {
        return "<" + p.x * echelle + ", " + p.y * echelle + ", " + p.z * echelle + ">";
    }

    private static String vecteur(Point a, Point b) {
        return "<" + (b.x - a.x) + ", " + (b.y - a.y) + ", " + (b.z - a.z) + ">";
    }

    private static String triplet(Couleur c) {
        return "<" + c.r + ", " + c.v + ", " + c.b + ">";
    }
}
