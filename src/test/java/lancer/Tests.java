package lancer;

import static org.junit.jupiter.api.Assertions.fail;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.ClassOrderer;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestClassOrder;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * Les vérifications élémentaires du cours, étape par étape, dans l'ordre de l'énoncé. À lancer avec le <i>runner</i>
 * JUnit 5. Elles ne demandent que ce que l'énoncé demande, et chaque échec dit ce qui était attendu et ce qui est venu.
 * Une étape que l'on n'a pas commencée ({@code getColor} rend encore du jaune vif, {@code getClosestIntersection} ne
 * trouve rien) est abandonnée, pas ratée.
 *
 * <p>Avec {@code -Dtests.graine=7}, ou tout autre nombre, les valeurs ne sont plus celles qu'on lit ici : elles sont
 * tirées de ce nombre, et la scène est tournée et déplacée. Ce qui est demandé reste le même.
 */
@DisplayName("Vérifications élémentaires du TP")
@TestClassOrder(ClassOrderer.OrderAnnotation.class)
@ExtendWith(Causes.class)
public class Tests extends Valeurs {

    /** La vérification qui explique, seule, que des boules restent noires. */
    static final String OMBRE_DE_SOI = "uneBouleNeSeCachePasElleMeme";

    /** Nombre de rayons voisins, l'un après l'autre, à qui demander une couleur que des arrondis peuvent changer. */
    private static final int ESSAIS = 60;

    private static final Couleur JAUNE = new Couleur(1, 1, 0);
    private static final Couleur VERT = new Couleur(0, 1, 0);

    /** La profondeur qui ne montre pas de reflet, négative si elle n'est pas encore connue. */
    private int sansReflet = -1;

    private static Couleur vue(Scene scene, Rayon rayon, int profondeur) {
        return vueParLuiMeme(scene, neuf(rayon), profondeur);
    }

    /** La couleur que voit ce rayon, à qui rien n'a été demandé : il doit rencontrer quelque chose. */
    private static Couleur vueParLuiMeme(Scene scene, Rayon rayon, int profondeur) {
        PointContact contact = scene.getClosestIntersection(rayon, null);
        if (contact == null) {
            return fail("ce rayon rencontre une boule : getClosestIntersection doit la trouver");
        }
        return objet(contact).getColor(scene, rayon, contact, profondeur);
    }

    /** La couleur vue sans reflet : à la profondeur 0, ou 1 pour qui compte à partir de 1, et rend noir à 0. */
    private Couleur vue(Scene scene, Rayon rayon) {
        if (sansReflet < 0) {
            Scene eclairee = scene(lampe(0, 0, 3), boule(gris, NOIR, 1));
            sansReflet = pres(NOIR, aCote(devant(), c -> !pres(NOIR, c), r -> vue(eclairee, r, 0))) ? 1 : 0;
        }
        return vue(scene, rayon, sansReflet);
    }

    /**
     * Ce que ces lampes ajoutent à la couleur que voit ce rayon : une couleur ambiante est la même sans elles. Qui divise
     * par leur nombre n'en a pas sans elles.
     */
    private Couleur apport(List<Lampe> lampes, Rayon rayon, Sphere... boules) {
        Couleur sans = vue(scene(null, boules), rayon);
        return vue(new Scene(Arrays.asList(boules), lampes), rayon).sub(Double.isNaN(sans.r) ? NOIR : sans);
    }

    /** Si Kd ne change rien, les vérifications de Lambert le disent : celles de Phong ôtent ce que montre alors une boule noire. */
    private boolean kdOublie;

    /** Le même rayon, qui n'a encore rien noté : qui ne note qu'un contact plus proche a raison aussi. */
    private static Rayon neuf(Rayon rayon) {
        return new Rayon(rayon.getP(), rayon.getV());
    }

    /** Un rayon que rien ne distingue de celui-ci, aux arrondis près : il part un peu plus loin, et d'un rien à côté. */
    private static Rayon aCote(Rayon rayon, int combien) {
        Point p = rayon.getP();
        Vecteur v = rayon.getV();
        double pas = combien / 100.0;
        return new Rayon(new Point(p.x + pas * v.x + 1e-6 * combien, p.y + pas * v.y + 3e-6 * combien, p.z + pas * v.z), v);
    }

    /**
     * Cette couleur, ici ou juste à côté : la première qui convienne. Une boule qui se cache elle-même, par des
     * arrondis, ne le fait pas partout, et une seule vérification est chargée de le dire : pour les ombres, puis pour
     * les reflets.
     */
    private static Couleur aCote(Rayon rayon, Predicate<Couleur> convient, Function<Rayon, Couleur> couleur) {
        Couleur ici = couleur.apply(rayon);
        Couleur trouvee = ici;
        for (int k = 1; k < ESSAIS && !convient.test(trouvee); k++) {
            trouvee = couleur.apply(aCote(rayon, k));
        }
        return convient.test(trouvee) ? trouvee : ici;
    }

    private Couleur apport(Predicate<Couleur> convient, List<Lampe> lampes, Rayon rayon, Sphere boule) {
        return aCote(rayon, convient, r -> apport(lampes, r, boule).sub(kdOublie
                ? apport(lampes, r, boule(NOIR, NOIR, 1)) : NOIR));
    }

    private void verifierApport(String demande, Couleur attendue, List<Lampe> lampes, Rayon rayon, Sphere boule) {
        verifier(demande + " (contact " + point(0, 0, 4) + ", lampe en " + lampes.stream().map(Lampe::getPosition)
                .map(p -> texte(p.x, p.y, p.z)).collect(Collectors.joining(" et en ")) + ")", attendue,
                apport(c -> pres(attendue, c), lampes, rayon, boule));
    }

    /** Une boule qui se met elle-même à l'ombre, ici ou là : en combien de points ; {@code null} si elle ne le fait pas. */
    String ombreDeSoi() {
        vue(scene(null, boule(gris, NOIR, 1)), devant());
        Sphere boule = boule(gris, NOIR, 1);
        Lampe lampe = lampe(1, 2, -7);
        Scene seule = scene(lampe, ailleurs(), boule);
        List<Rayon> noirs = new ArrayList<>();
        int points = 0;
        double pas = tirer(0.1, 0.1, 0.13);
        for (double y = -0.55; y < 0.6; y += pas) {
            for (double x = -0.53; x < 0.6; x += pas) {
                points++;
                if (pres(vue(scene(null, boule), rayon(x, y, 0, 0.01, 0.02, 1)), vue(seule, rayon(x, y, 0, 0.01, 0.02, 1)))) {
                    noirs.add(rayon(x, y, 0, 0.01, 0.02, 1));
                }
            }
        }
        if (!noirs.isEmpty() && eclaireeParUnObstacle(boule, lampe, noirs.get(0))) {
            return "une boule est noire quand rien ne la cache, et éclairée quand une autre la cache : la condition de l'ombre "
                    + "est à l'envers";
        }
        // le rayon d'ombre en est la cause si, sans la boule, le même point est éclairé ; ou, pour qui veut toujours la
        // retrouver, si un point dont rien n'est arrondi est éclairé
        boolean ombre = !noirs.isEmpty() && (eclaireSansElle(seule, lampe, noirs.get(0)) || noirs.size() < points && sansArrondi());
        return ombre ? noirs.size() + " points noirs sur " + points
                + ", tous face à la lampe : le rayon d'ombre retrouve la boule elle-même" : null;
    }

    /** Dit si ce que voit ce rayon, noir, s'éclaire quand une autre boule le cache à la lampe. */
    private boolean eclaireeParUnObstacle(Sphere boule, Lampe lampe, Rayon rayon) {
        PointContact contact = scene(null, boule).getClosestIntersection(neuf(rayon), null);
        Point p = lampe.getPosition();
        Sphere obstacle = new Sphere(new Point((contact.x + p.x) / 2, (contact.y + p.y) / 2, (contact.z + p.z) / 2), 1);
        return !pres(vue(scene(null, boule, obstacle), rayon), vue(scene(lampe, boule, obstacle), rayon));
    }

    /** La première boule d'une scène, loin de tout : elle n'est pas celle qu'un rayon d'ombre doit ignorer. */
    private Sphere ailleurs() {
        return boule(0, 0, -60, 1);
    }

    /** Dit si le point que voit ce rayon est éclairé quand sa boule n'est pas dans la scène. */
    private boolean eclaireSansElle(Scene seule, Lampe lampe, Rayon celuiLa) {
        Rayon rayon = neuf(celuiLa);
        PointContact contact = seule.getClosestIntersection(rayon, null);
        try {
            return !pres(objet(contact).getColor(scene(null, ailleurs()), rayon, contact, sansReflet),
                    objet(contact).getColor(scene(lampe, ailleurs()), rayon, contact, sansReflet));
        } catch (RuntimeException e) {
            return false;
        }
    }

    /** Dit si un contact aux coordonnées entières, dans l'axe de la lampe, n'est éclairé que dans la scène où est sa boule. */
    private boolean sansArrondi() {
        devantLaCamera();
        Lampe lampe = lampe(0, 0, 3);
        Scene seule = scene(lampe, ailleurs(), boule(gris, NOIR, 1));
        return !pres(NOIR, vue(seule, devant())) && !eclaireSansElle(seule, lampe, devant());
    }

    /** Les rayons que lance getColor, là où celui-ci rencontre cette boule : une autre, loin de tout, les retient. */
    private List<Rayon> lances(List<Lampe> lampes, Rayon rayon, int profondeur, Sphere boule) {
        List<Rayon> lances = new ArrayList<>();
        double[] loin = lieu(-60, 0, 20);
        Scene scene = new Scene(Arrays.asList(boule, new Sphere(new Point(loin[0], loin[1], loin[2]), 1) {
            @Override
            public double getIntersectionDistance(Rayon incident) {
                lances.add(incident);
                return super.getIntersectionDistance(incident);
            }
        }), lampes);
        PointContact contact = scene.getClosestIntersection(rayon, null);
        lances.clear();
        if (contact != null) {
            objet(contact).getColor(scene, rayon, contact, profondeur);
        }
        return lances;
    }

    private static String vers(Rayon rayon) {
        return "un rayon de " + texte(rayon.getP().x, rayon.getP().y, rayon.getP().z) + " dans la direction "
                + texte(rayon.getV().x, rayon.getV().y, rayon.getV().z);
    }

    /** Abandonne le test tant que getClosestIntersection ne trouve rien, même parmi deux boules. */
    private void sceneCommencee() {
        Sphere boule = boule(0, 0, 5, 1);
        siCommencee(scene(null, boule).getClosestIntersection(devant(), null) != null
                || scene(null, boule, boule(0, 0, 9, 1)).getClosestIntersection(devant(), null) != null
                || scene(null, boule(9, 0, 5, 1), boule).getClosestIntersection(devant(), boule(0, 0, 5, 1)) != null,
                Scene.class, "getClosestIntersection", "getClosestIntersection ne trouve encore rien, ou ne garde pas ce qu'elle trouve");
    }

    /** Abandonne le test tant que getColor rend du jaune vif. */
    private void couleurCommencee() {
        sceneCommencee();
        siCommencee(!pres(JAUNE, vue(scene(null, boule(NOIR, NOIR, 1)), devant(), 0)),
                Objet3D.class, "getColor", "getColor rend encore du jaune vif");
    }

    @Nested @Order(1) @Tag("vecteurs") @TestMethodOrder(MethodOrderer.OrderAnnotation.class)
    @DisplayName("1. Points et vecteurs")
    class Vecteurs {

        @Test @Order(1) @Demande(classe = Tuple.class)
        @DisplayName("la classe Tuple, donnée : ses coordonnées sont celles qu'on lui donne")
        void unTripletGardeSesCoordonnees() {
            Point p = new Point(0.1, -0.2, 12345.6789);
            dire(p.x == 0.1 && p.y == -0.2 && p.z == 12345.6789, "new Point(0.1, -0.2, 12345.6789), d'un Tuple de trois double",
                    "0.1, -0.2, 12345.6789", p.x + ", " + p.y + ", " + p.z);
        }

        @Test @Order(2) @Demande(classe = Constantes.class)
        @DisplayName("la classe Constantes, donnée : ce sont celles de l'énoncé")
        void lesConstantesSontCellesDuCours() {
            constante("ECHELLE", 2);
            constante("CHAMP", 30);
            constante("INFINI", Double.POSITIVE_INFINITY);
        }

        /** Par son nom : le compilateur recopierait ici la valeur qu'elle avait. */
        private void constante(String nom, double attendue) {
            verifier("Constantes." + nom, attendue, (Double) champ(Constantes.class, nom, null));
        }

        @Test @Order(3) @Demande(classe = PointContact.class)
        @DisplayName("la classe PointContact, donnée : un contact garde son objet et sa distance")
        void unContactGardeSonObjetEtSaDistance() {
            Sphere sphere = new Sphere(p, 1);
            PointContact contact = new PointContact(p, sphere, 3);
            verifier("new PointContact(p, objet, 3) est en p" + texte(a), a, contact);
            verifier("sa distance", 3, distance(contact));
            dire(objet(contact) == sphere, "son objet", sphere, objet(contact));
        }

        private final double[] a = demis(1.5, 2, 3);
        private final double[] b = demis(4, -5, 6.5);
        private final double[] c = demis(0, 3, -4);
        private final double k = Math.abs(demi(2));
        private final Vecteur u = new Vecteur(a[0], a[1], a[2]);
        private final Vecteur v = new Vecteur(b[0], b[1], b[2]);
        private final Vecteur w = new Vecteur(c[0], c[1], c[2]);
        private final Point p = new Point(a[0], a[1], a[2]);
        private final Point q = new Point(b[0], b[1], b[2]);

        @Test @Order(4) @Demande(classe = Vecteur.class, methodes = "Vecteur") @DisplayName("new Vecteur(a, b) va de a à b")
        void entreDeuxPointsUnVecteurVaDuPremierAuSecond() {
            verifier("le vecteur de a" + texte(a) + " à b" + texte(b) + " est b - a", somme(b, -1, a), new Vecteur(p, q));
        }

        @Test @Order(5) @Demande(classe = Vecteur.class, methodes = "sub") @DisplayName("u.sub(v) soustrait deux vecteurs")
        void unVecteurSeSoustrait() {
            verifier(texte(a) + " - " + texte(b), somme(a, -1, b), u.sub(v));
            verifier("Vecteur.sub(u, v) vaut u.sub(v)", somme(a, -1, b), Vecteur.sub(u, v));
        }

        @Test @Order(6) @Demande(classe = Point.class, methodes = "sub") @DisplayName("p.sub(v) translate le point de -v")
        void unPointMoinsUnVecteurEstUnPoint() {
            verifier("le point " + texte(a) + " translaté de -" + texte(b), somme(a, -1, b), p.sub(v));
            verifier("Point.sub(p, v) vaut p.sub(v)", somme(a, -1, b), Point.sub(p, v));
        }

        @Test @Order(7) @Demande(classe = Point.class, methodes = "sub") @DisplayName("p.sub(q) est le vecteur de q à p")
        void unPointMoinsUnPointEstUnVecteur() {
            verifier("p" + texte(a) + " - q" + texte(b) + ", le vecteur qui va de q à p", somme(a, -1, b), p.sub(q));
            verifier("Point.sub(p, q) vaut p.sub(q)", somme(a, -1, b), Point.sub(p, q));
        }

        @Test @Order(8) @Demande(classe = Vecteur.class, methodes = "dot") @DisplayName("u.dot(v) est le produit scalaire")
        void leProduitScalaireAjouteLesProduitsDesComposantes() {
            verifier(texte(a) + "·" + texte(b) + " = " + nb(a[0] * b[0]) + plus(a[1] * b[1]) + plus(a[2] * b[2]),
                    produit(a, b), u.dot(v));
            verifier("le même, un des vecteurs étant changé de signe", -produit(a, b), u.dot(v.neg()));
            verifier("Vecteur.dot(u, v) vaut u.dot(v)", produit(a, b), Vecteur.dot(u, v));
        }

        @Test @Order(9) @Demande(classe = Vecteur.class, methodes = "norme2") @DisplayName("norme2 est le carré de la norme")
        void laNormeAuCarreEstLeProduitScalaireDuVecteurParLuiMeme() {
            verifier("le carré de la norme de " + texte(a) + " : " + nb(a[0] * a[0]) + plus(a[1] * a[1]) + plus(a[2] * a[2]),
                    produit(a, a), u.norme2());
            verifier("la norme de " + texte(c), Math.sqrt(produit(c, c)), w.norme());
        }

        @Test @Order(10) @Demande(classe = Vecteur.class, methodes = "norme2")
        @DisplayName("les deux façons de normaliser donnent la longueur 1, sans changer la direction")
        void normaliseUnVecteurEstDeLongueurUnEtDeMemeDirection() {
            verifier("norme2, qui sert à normaliser : le carré de la norme de " + texte(c), produit(c, c), w.norme2());
            verifier(texte(c) + " normalisé par normalized()", unitaire(c), w.normalized());
            verifier(texte(c) + " normalisé par Vecteur.normalize", unitaire(c), Vecteur.normalize(w));
            verifier("un vecteur plus court que 1, normalisé par normalized()", unitaire(c), new Vecteur(c[0] / 16, c[1] / 16, c[2] / 16)
                    .normalized());
        }

        @Test @Order(11) @Demande(classe = Vecteur.class) @DisplayName("les opérations fournies marchent toujours")
        void lesAutresOperationsSontIntactes() {
            verifier(texte(a) + " + " + texte(b), somme(a, 1, b), u.add(v));
            verifier(nb(k) + " " + texte(a), somme(a, k - 1, a), u.mul(k));
            verifier(texte(a) + " / " + nb(k), somme(a, 1 / k - 1, a), u.div(k));
            verifier("l'opposé de " + texte(a), somme(a, -2, a), u.neg());
            verifier("le point " + texte(a) + " translaté de " + texte(b), somme(a, 1, b), p.add(v));
        }

        @Test @Order(12) @Demande(classe = Couleur.class) @DisplayName("une couleur n'est limitée à [0, 1] qu'à l'écran, par getCode")
        void uneCouleurNEstLimiteeQuALEcran() {
            Couleur vive = new Couleur(1.5, -0.5, 0.25);
            verifier("new Couleur(1.5, -0.5, 0.25), fois 2", new Couleur(3, -1, 0.5), vive.mul(2));
            dire(vive.r == 1.5 && vive.v == -0.5, "les composantes de new Couleur(1.5, -0.5, 0.25)", "1.5 et -0.5",
                    vive.r + " et " + vive.v);
            code("au-delà de 1, en dessous de 0, et NaN", 0xFF0000, new Couleur(1.5, -0.5, Double.NaN));
            code("entre 0 et 1", 0x3366CC, new Couleur(0.2, 0.4, 0.8));
        }

        private void code(String demande, int attendu, Couleur couleur) {
            dire((couleur.getCode() & 0xFFFFFF) == attendu, "le code d'une couleur aux composantes " + demande,
                    Integer.toHexString(attendu), Integer.toHexString(couleur.getCode() & 0xFFFFFF));
        }
    }

    @Nested @Order(2) @Tag("rayons") @TestMethodOrder(MethodOrderer.OrderAnnotation.class)
    @Demande(classe = Camera.class, methodes = "getRayon") @DisplayName("2. Rayons et caméra")
    class RayonsEtCamera {

        private final int L = 2 * entier(400, 150, 750);
        private final int H = 2 * entier(300, 100, 550);
        private final Camera camera = new Camera(L, H);
        private final double[] p = demis(1, 1, 1);
        private final double[] v = demis(0, 3, 4);

        /** Un demi-pixel, si c'est le centre du pixel que vise cette caméra : la première vérification le dit seule. */
        private double decalage() {
            return pres(-1 + 1.0 / L, camera.getRayon(0, 0).getP().x) ? 0.5 : 0;
        }

        /** Le point (xe, ye) est en x = (xe - L/2) ECHELLE / L, et en y de même. */
        private void ecran(String demande, int largeur, int hauteur, double xe, double ye) {
            double d = decalage();
            verifier(demande, new double[] {2 * (xe + d) / largeur - 1, (hauteur - 2 * (ye + d)) / largeur, 0},
                    new Camera(largeur, hauteur).getRayon(xe, ye).getP());
        }

        private String ecran(int largeur, int hauteur) {
            return " d'un écran " + largeur + " x " + hauteur;
        }

        @Test @Order(1) @Demande(classe = Rayon.class, methodes = "Rayon")
        @DisplayName("new Rayon(p1, p2) part de p1 vers p2, et son vecteur est normalisé")
        void unRayonVaDUnPointVersUnAutre() {
            double[] q = somme(p, 1, v);
            String demande = "le rayon de " + texte(p) + " vers " + texte(q);
            Rayon rayon = new Rayon(new Point(p[0], p[1], p[2]), new Point(q[0], q[1], q[2]));
            verifier(demande + " part de " + texte(p), p, rayon.getP());
            verifier(demande + " a pour vecteur " + texte(v) + " normalisé", unitaire(v), rayon.getV());
        }

        @Test @Order(2) @Demande(classe = Rayon.class, methodes = "Rayon")
        @DisplayName("new Rayon(p, v) part de p, et son vecteur est normalisé")
        void unRayonNormaliseSonVecteur() {
            double[] q = demis(1, 2, 3);
            double[] dix = somme(v, 9, v);
            Rayon rayon = new Rayon(new Point(q[0], q[1], q[2]), new Vecteur(dix[0], dix[1], dix[2]));
            verifier("le rayon de départ " + texte(q), q, rayon.getP());
            verifier("le rayon de direction " + texte(dix) + " a pour vecteur cette direction normalisée", unitaire(v),
                    rayon.getV());
        }

        @Test @Order(3) @Demande(classe = Rayon.class, methodes = "getSkyColor")
        @DisplayName("getSkyColor, donnée : la couleur du ciel dans la direction du rayon")
        void leCielEstCeluiDuCours() {
            for (int sens = -1; sens <= 1; sens += 2) {
                Rayon rayon = new Rayon(new Point(p[0], p[1], p[2]), new Vecteur(v[0], sens * Math.abs(v[1]), v[2]));
                // dans la direction qu'a ce rayon : qu'elle soit juste, d'autres vérifications le disent
                verifier("Rayon.getSkyColor, V.y = " + nb(rayon.getV().y), ciel(rayon.getV().y), rayon.getSkyColor());
            }
        }

        @Test @Order(4) @DisplayName("le pixel (0, 0) est en haut à gauche, à x = -ECHELLE/2")
        void leCoinEnHautAGaucheEstAMoinsUn() {
            int autreL = 2 * entier(640, 150, 750);
            int autreH = 2 * entier(512, 100, 550);
            verifier("le pixel (0,0)" + ecran(L, H) + ", avec ECHELLE = 2" + (decalage() > 0
                    ? " (le vôtre est un demi-pixel plus loin)" : ""), new double[] {-1, H / (double) L, 0},
                    camera.getRayon(0, 0).getP());
            verifier("le pixel (0,0)" + ecran(autreL, autreH), new double[] {-1, autreH / (double) autreL, 0},
                    new Camera(autreL, autreH).getRayon(0, 0).getP());
        }

        @Test @Order(5) @DisplayName("le coin (L, H) est en bas à droite, à x = ECHELLE/2")
        void leCoinEnBasADroiteEstAPlusUn() {
            ecran("le coin (" + L + "," + H + ")" + ecran(L, H), L, H, L, H);
        }

        @Test @Order(6) @DisplayName("le cadrage ne dépend pas de la taille de l'écran")
        void leCadrageEstLeMemeAToutesLesTailles() {
            // loin du milieu de l'écran, où une image retournée a le même point
            int xe = entier(200, 20, 140);
            int ye = entier(150, 20, 90);
            ecran("(" + xe + "," + ye + ")" + ecran(L, H), L, H, xe, ye);
            ecran("(" + 2 * xe + "," + 2 * ye + ")" + ecran(2 * L, 2 * H) + " : le même point", 2 * L, 2 * H, 2 * xe, 2 * ye);
        }

        @Test @Order(7) @Demande(classe = Camera.class, methodes = {"Camera", "getRayon"})
        @DisplayName("au centre de l'écran, le rayon va droit devant")
        void auCentreLeRayonVaDroitDevant() {
            double d = decalage();
            Rayon rayon = camera.getRayon(L / 2.0 - d, H / 2.0 - d);
            verifier("le centre de l'écran est l'origine", new double[3], rayon.getP());
            boolean versLOeil = camera.getRayon(L, H / 2.0).getV().x < 0;
            verifier(versLOeil ? "getRayon : un rayon va de l'œil à l'écran, puis s'éloigne vers la scène (z > 0)"
                    : "l'œil, que place new Camera(L, H), est derrière l'écran, la scène devant (z > 0)", new double[] {0, 0, 1},
                    rayon.getV());
        }

        @Test @Order(8) @Demande(classe = Camera.class, methodes = "Camera")
        @DisplayName("new Camera(L, H) : l'œil voit la largeur de l'écran sous 30° (distance focale)")
        void laLargeurDeLEcranEstVueSousTrenteDegres() {
            double d = decalage();
            double part = tirer(1, 0.4, 0.99);
            double sinus = camera.getRayon(L * (1 + part) / 2 - d, H / 2.0 - d).getV().x;
            verifier(part == 1 ? "au milieu du bord droit, le rayon s'écarte de l'axe de CHAMP/2 = 15° ; en degrés"
                    : "à " + part + " du chemin qui va du centre au bord droit, l'écart du rayon à l'axe, de tangente "
                    + part + " tan(CHAMP/2) ; en degrés", Math.toDegrees(Math.atan(part * Math.tan(Math.toRadians(15)))),
                    Math.toDegrees(Math.asin(sinus)));
        }

        @Test @Order(9) @Demande(classe = Camera.class, methodes = {"Camera", "getRayon"})
        @DisplayName("chaque rayon vient de l'œil")
        void tousLesRayonsPassentParLOeil() {
            double focale = 1 / Math.tan(Math.toRadians(15));
            for (double[] pixel : new double[][] {{0, 0}, {L, H}, {entier(123, 0, L), entier(456, 0, H)}}) {
                Rayon rayon = camera.getRayon(pixel[0], pixel[1]);
                double recul = focale / rayon.getV().z;
                String demande = "en reculant sur le rayon du pixel (" + pixel[0] + "," + pixel[1] + "), on arrive à l'œil";
                verifier(demande, new double[] {0, 0, -focale}, rayon.getP().add(rayon.getV().mul(-recul)));
            }
        }

        @Test @Order(10) @DisplayName("rien n'est arrondi à l'entier : ni L/2, ni H/2, ni xe, ni ye")
        void uneTailleImpaireOuUnPointEntreDeuxPixelsNArronditRien() {
            int l = 2 * entier(40, 20, 100) + 1;
            int h = 2 * entier(30, 20, 100) + 1;
            double xe = entier(200, 0, L) + 0.5;
            double ye = entier(150, 0, H) + 0.25;
            ecran("le pixel (0,0)" + ecran(l, h) + " : L/2 = " + l / 2.0, l, h, 0, 0);
            ecran("le point (" + xe + "," + ye + ")" + ecran(L, H), L, H, xe, ye);
        }
    }

    @Nested @Order(3) @Tag("sphere") @TestMethodOrder(MethodOrderer.OrderAnnotation.class)
    @Demande(classe = Sphere.class, methodes = "getIntersectionDistance") @DisplayName("3. Intersection d'un rayon et d'une sphère")
    class UneSphere {

        /** Son rayon, et la distance de son centre. */
        private final double r = tirer(1, 0.7, 1.4);
        private final double D = tirer(5, 4, 7);
        private final Sphere sphere = boule(0, 0, D, r);

        private void distance(String demande, double attendue, Sphere sphere, Rayon rayon) {
            verifier(demande, attendue, sphere.getIntersectionDistance(rayon));
        }

        /** Au bord, les arrondis comptent davantage : un programme en float n'a pas tort. */
        private void aPeuPres(String demande, double attendue, Sphere sphere, Rayon rayon) {
            double obtenue = sphere.getIntersectionDistance(rayon);
            dire(Math.abs(obtenue - attendue) < 0.01, demande, arrondi(attendue), obtenue);
        }

        @Test @Order(1) @DisplayName("des deux points touchés, la distance est celle du plus proche")
        void laDistanceEstCelleDuPlusProcheDesDeuxPoints() {
            distance("sphère de centre " + point(0, 0, D) + " et de rayon " + nb(r) + ", vue de " + point(0, 0, 0)
                    + " : points à " + nb(D - r) + " et " + nb(D + r), D - r, sphere, devant());
            // de biais, sa direction n'étant pas de longueur 1
            double R = tirer(2, 0.8, 2.5);
            double v = tirer(5, 2, 9);
            distance("sphère de centre " + point(1 + s * D, 0, -7 + c * D) + " et de rayon " + nb(R) + ", vue de "
                    + point(1, 0, -7) + " : points à " + nb(D - R) + " et " + nb(D + R), D - R,
                    boule(1 + s * D, 0, -7 + c * D, R), rayon(1, 0, -7, v * s, 0, v * c));
            distance("la première, vue de tout près, à 0.2", 0.2, sphere, rayon(0, 0, D - r - 0.2, 0, 0, 1));
        }

        @Test @Order(2) @DisplayName("un rayon qui ne passe pas par le centre touche plus loin")
        void lEcartALAxeCompte() {
            distance("rayon de " + point(0, r * s, 0) + " vers " + vers(0, 0, 1) + " : demi-corde " + nb(r * c) + ", donc "
                    + nb(D) + " - " + nb(r * c), D - r * c, sphere, rayon(0, r * s, 0, 0, 0, 1));
            // d'un autre rayon que 1, et près du bord
            double R = tirer(2, 1.7, 2.5);
            double y = 0.9 * R;
            distance("la même, de rayon " + nb(R) + ", vue de " + point(0, y, 0), D - sinus(0.9) * R, boule(0, 0, D, R),
                    rayon(0, y, 0, 0, 0, 1));
            double petit = 0.1;
            aPeuPres("la même, de rayon " + petit + ", vue de " + point(0, 0.6 * petit, 0), D - 0.8 * petit, boule(0, 0, D, petit),
                    rayon(0, 0.6 * petit, 0, 0, 0, 1));
            aPeuPres("la première, presque au bord : demi-corde " + nb(0.02 * r), D - 0.02 * r, sphere,
                    rayon(0, Math.sqrt(1 - 0.02 * 0.02) * r, 0, 0, 0, 1));
        }

        @Test @Order(3) @DisplayName("sans intersection, la distance est +∞")
        void aCoteLaDistanceEstInfinie() {
            double y = tirer(2, 1.7, 3);
            distance("rayon de " + point(0, y, 0) + " vers " + vers(0, 0, 1) + ", qui passe à " + nb(y) + " du centre",
                    Double.POSITIVE_INFINITY, sphere, rayon(0, y, 0, 0, 0, 1));
            distance("la même distance du centre, d'une sphère de rayon " + nb(0.9 * y), Double.POSITIVE_INFINITY,
                    boule(0, 0, D, 0.9 * y), rayon(0, y, 0, 0, 0, 1));
        }

        @Test @Order(4) @DisplayName("une sphère dans le dos du rayon n'est pas touchée")
        void dansLeDosLaDistanceEstInfinie() {
            distance("rayon de " + point(0, 0, 0) + " vers " + vers(0, 0, -1) + " : la sphère est derrière, à " + nb(r - D)
                    + " et " + nb(-r - D), Double.POSITIVE_INFINITY, sphere, rayon(0, 0, 0, 0, 0, -1));
        }

        @Test @Order(5) @DisplayName("de l'intérieur, la distance est celle de la sortie, jamais négative")
        void deLInterieurLaDistanceEstCelleDeLaSortie() {
            double e = tirer(0.5, 0.1, 0.5);
            distance("rayon parti de " + point(0, 0, D + e) + " vers " + vers(0, 0, -1) + " : points à " + nb(e - r)
                    + ", dans le dos, et à " + nb(e + r), e + r, sphere, rayon(0, 0, D + e, 0, 0, -1));
            distance("le même, vers " + vers(0, 0, 1) + ", dos au centre : points à " + nb(-e - r) + " et à " + nb(r - e), r - e, sphere,
                    rayon(0, 0, D + e, 0, 0, 1));
        }

        @Test @Order(6) @DisplayName("la distance trouvée est aussi notée dans le rayon")
        void laDistanceEstNoteeDansLeRayon() {
            Rayon rayon = devant();
            sphere.getIntersectionDistance(rayon);
            verifier("rayon.getDistance() après getIntersectionDistance", D - r, rayon.getDistance());
        }

        @Test @Order(7) @DisplayName("une sphère géante, comme le sol des scènes, est touchée au même endroit qu'une petite")
        void uneSphereGeanteEstToucheeSansGrain() {
            // trois : les arrondis d'une seule peuvent, par chance, ne rien changer
            for (double rayon : new double[] {9998.77, 9412.35, 10321.6}) {
                double R = tirer(rayon, rayon - 300, rayon + 100);
                double d = tirer(4, 3, 6);
                distance("sphère de centre " + point(0, 0, R + d) + " et de rayon " + R + " (en float, il y a du grain)", d,
                        boule(0, 0, R + d, R), devant());
            }
        }
    }

    @Nested @Order(4) @Tag("scene") @TestMethodOrder(MethodOrderer.OrderAnnotation.class)
    @Demande(classe = Scene.class, methodes = "getClosestIntersection") @DisplayName("4. Scène de sphères")
    class UneScene {

        /** Le rayon de deux boules, et leurs distances. */
        private final double r = tirer(1, 0.7, 1.4);
        private final double d = tirer(4, 3, 5);
        private final double D = tirer(8, 6, 10);
        private final Sphere pres = boule(0, 0, d + r, r, NOIR, NOIR, 1);
        private final Sphere loin = boule(0, 0, D + r, r, NOIR, NOIR, 1);
        private final String boules = "boules à " + nb(d) + " (proche) et à " + nb(D) + " (lointaine), la ";
        /** Une boule que le rayon manque. */
        private final Sphere aCote = boule(0, 9, d + r, r);

        /** Ce que rencontre un rayon neuf, parmi ces boules. */
        private PointContact contact(Rayon rayon, Sphere saufLui, Sphere... boules) {
            return scene(null, boules).getClosestIntersection(rayon, saufLui);
        }

        private void plusProche(String demande, Sphere attendue, Sphere saufLui, Sphere... boules) {
            plusProche(demande, devant(), attendue, saufLui, boules);
        }

        private void plusProche(String demande, Rayon rayon, Sphere attendue, Sphere saufLui, Sphere... boules) {
            PointContact contact = contact(rayon, saufLui, boules);
            dire(contact != null && objet(contact) == attendue, demande, nom(attendue), contact == null ? null : nom(objet(contact)));
        }

        private String nom(Objet3D objet) {
            return objet == pres ? "la boule proche" : objet == loin ? "la boule lointaine" : String.valueOf(objet);
        }

        @Test @Order(1) @Demande(classe = Rayon.class, methodes = "calcContact")
        @DisplayName("calcContact : le point P + distance V")
        void leContactEstSurLeRayonALaDistanceTrouvee() {
            double x = tirer(1, 0.5, 3);
            Rayon rayon = rayon(x, 0, 0, 0, 0, 1);
            Sphere sphere = boule(x, 0, d + r, r);
            sphere.getIntersectionDistance(rayon);
            siCommencee(Double.isInfinite(rayon.getDistance()) || rayon.calcContact() != null,
                    Rayon.class, "calcContact", "calcContact ne rend encore rien");
            PointContact contact = rayon.calcContact();
            verifier("le contact du rayon de " + point(x, 0, 0) + " vers " + vers(0, 0, 1) + " avec la sphère de centre "
                    + point(x, 0, d + r) + " et de rayon " + nb(r), lieu(x, 0, d), contact);
            dire(objet(contact) == sphere, "l'objet du contact est la sphère touchée", sphere, objet(contact));
            verifier("la distance que porte ce contact", d, distance(contact));
        }

        @Test @Order(2) @Demande(classe = Rayon.class, methodes = "calcContact")
        @DisplayName("calcContact : null si la distance est infinie")
        void sansDistanceIlNYAPasDeContact() {
            dire(devant().calcContact() == null, "calcContact d'un rayon qui n'a rien touché", null, "un contact");
        }

        @Test @Order(3) @DisplayName("getClosestIntersection : la plus proche des sphères, quel que soit leur ordre")
        void laPlusProcheDesSpheresEstTrouvee() {
            sceneCommencee();
            plusProche("une seule boule", pres, null, pres);
            plusProche(boules + "lointaine en premier", pres, null, loin, pres);
            plusProche(boules + "proche en premier", pres, null, pres, loin);
            plusProche("une boule que le rayon manque, puis une à " + nb(d), pres, null, aCote, pres);
            plusProche("une boule à " + nb(d) + ", puis une que le rayon manque", pres, null, pres, aCote);
            Sphere bord = boule(0, 0, r + 0.2, r);
            plusProche("une boule à 0.2", bord, null, bord, loin);
            Sphere horizon = boule(0, 0, 1e5, 50);
            plusProche("une boule à 99950", horizon, null, aCote, horizon);
        }

        @Test @Order(4) @DisplayName("getClosestIntersection : la plus proche le long du rayon, où que soient les centres")
        void laPlusProcheEstCelleDuPointTouche() {
            sceneCommencee();
            Sphere petite = boule(0, 0, d + 1, 0.2);
            Sphere grosse = boule(0, 0, d + 9, 9);
            plusProche("une grosse boule à " + nb(d) + ", devant une petite dont le centre est plus près", grosse, null, petite, grosse);
            for (int sens = -1; sens <= 1; sens += 2) {
                Sphere premiere = boule(0, 0, sens * (d + r), r);
                plusProche("rayon vers " + vers(0, 0, sens) + ", deux boules devant lui : la première", rayon(0, 0, 0, 0, 0, sens),
                        premiere,
                        null, boule(0, 0, sens * (D + r), r), premiere);
            }
        }

        @Test @Order(5) @DisplayName("getClosestIntersection : le contact a la distance et la position de la plus proche")
        void leContactEstCeluiDeLaPlusProche() {
            sceneCommencee();
            PointContact contact = contact(devant(), null, pres, loin);
            verifier("la distance du contact, la boule proche étant à " + nb(d) + " et la lointaine à " + nb(D), d,
                    distance(contact));
            verifier("le point de contact", lieu(0, 0, d), contact);
        }

        @Test @Order(6) @DisplayName("getClosestIntersection : à la fin, le rayon a noté la plus proche")
        void leRayonGardeLaPlusProche() {
            sceneCommencee();
            Rayon rayon = devant();
            contact(rayon, null, pres, loin, aCote);
            String note = nom(rayon.getObjet()) + " à " + rayon.getDistance();
            devantLaCamera();
            // qui n'emploie que le contact rendu n'en est pas gêné : le pixel est alors le même, dans quelque ordre que soient les boules
            List<Sphere> boules = Arrays.asList(loin(), boule(0, 0, d + r, r, gris, gris, 20), boule(2, 0, d - 2, 0.5),
                    boule(0.5, 0, -9, 3, gris, NOIR, 1), boule(0, 0, -30, 3, BLANC, NOIR, 1), boule(0, 9, d, r));
            String juste = pixelDuCentre(boules);
            for (int k = 1; k < boules.size() && rayon.getObjet() != pres; k++) {
                Collections.rotate(boules, 1);
                dire(juste.equals(pixelDuCentre(boules)), "le rayon, que getClosestIntersection a reçu, a noté un autre contact : un pixel "
                        + "dépend de l'ordre des boules", nom(pres) + " à " + nb(d), note);
            }
        }

        /** Une boule lointaine, noire quoi que rende getColor. */
        private Sphere loin() {
            return new Sphere(new Point(0, 0, D + r), r) {
                @Override
                public Couleur getColor(Scene scene, Rayon incident, PointContact contact, int profondeur) {
                    return NOIR;
                }
            };
        }

        /** La couleur du pixel au milieu de l'image de ces boules, ou ce qui l'empêche d'en avoir une. */
        private String pixelDuCentre(List<Sphere> boules) {
            try {
                Couleur couleur = new Lancer(new Scene(boules, Collections.singletonList(orange(4, 0, d - 4))), new Camera(8, 6))
                        .getCouleurPixel(4, 3, 2);
                return texte(couleur.r, couleur.v, couleur.b);
            } catch (RuntimeException | StackOverflowError e) {
                return e.getClass().getSimpleName();
            }
        }

        @Test @Order(7) @DisplayName("getClosestIntersection : la sphère à ignorer est ignorée")
        void laSphereAIgnorerEstIgnoree() {
            sceneCommencee();
            plusProche("sauf la boule proche", loin, pres, loin, pres);
            plusProche("sauf la boule lointaine", pres, loin, pres, loin);
            plusProche("sauf la boule proche, qui est la première", loin, pres, pres, loin);
        }

        @Test @Order(8) @DisplayName("getClosestIntersection : null où il n'y a rien, même derrière le rayon")
        void ouIlNYARienIlNYAPasDeContact() {
            sceneCommencee();
            dire(contact(rayon(0, 0, 0, 0, 1, 0), null, pres, loin) == null, "rayon vers le haut, boules devant", null, "un contact");
            dire(contact(rayon(0, 0, 0, 0, 0, -1), null, pres, loin) == null, "rayon dos aux boules", null, "un contact");
            dire(contact(devant(), null, pres, loin) != null && contact(devant(), pres, pres) == null, "une seule boule, à ignorer", null,
                    "un contact");
        }

        private Couleur pixel(Scene scene, Camera camera, double xe, double ye, int profondeur) {
            sceneCommencee();
            Couleur couleur = new Lancer(scene, camera).getCouleurPixel(xe, ye, profondeur);
            siCommencee(!pres(VERT, couleur), Lancer.class, "getCouleurPixel", "getCouleurPixel rend encore du vert");
            return couleur;
        }

        /** La couleur du ciel à travers un point d'un écran. */
        private Couleur ciel(int largeur, int hauteur, double xe, double ye) {
            double[] v = {2 * xe / largeur - 1, (hauteur - 2 * ye) / largeur, 1 / Math.tan(Math.toRadians(15))};
            return Tests.ciel(unitaire(v)[1]);
        }

        /** La couleur que rend getColor ; qu'elle échoue n'est pas la faute de getCouleurPixel. */
        private Couleur selonGetColor(Scene scene, Camera camera, double xe, double ye, int profondeur) {
            sceneCommencee();
            siEvaluable(scene.getClosestIntersection(camera.getRayon(xe, ye), null) != null,
                    "le rayon de ce pixel, que donne la caméra, ne rencontre pas la boule qui est devant l'écran");
            try {
                return vueParLuiMeme(scene, camera.getRayon(xe, ye), profondeur);
            } catch (RuntimeException | StackOverflowError e) {
                // à l'étape où getColor s'écrit de le dire
                throw new Demande.NonEvaluable("getColor, que les étapes suivantes vérifient, échoue");
            }
        }

        /** Ce que rend getColor pour le rayon de ce point ou, un demi-pixel plus loin, pour celui du centre du pixel. */
        private void commeGetColor(String demande, Scene scene, Camera camera, double xe, double ye, int profondeur) {
            Couleur coin = selonGetColor(scene, camera, xe, ye, profondeur);
            Couleur centre = selonGetColor(scene, camera, xe + 0.5, ye + 0.5, profondeur);
            Couleur pixel = pixel(scene, camera, xe, ye, profondeur);
            verifier(demande, pres(centre, pixel) ? centre : coin, pixel);
        }

        @Test @Order(9) @Demande(classe = Lancer.class, methodes = "getCouleurPixel")
        @DisplayName("getCouleurPixel : la couleur du ciel où il n'y a rien")
        void unPixelVideALaCouleurDuCiel() {
            int L = entier(800, 300, 1500);
            int H = entier(600, 200, 1100);
            int xe = entier(400, 0, L);
            int ye = entier(300, 0, H);
            Couleur couleur = pixel(scene(null), new Camera(L, H), xe, ye, 1);
            // le rayon passe par les coordonnées entières, ou par le centre du pixel, un demi-pixel plus bas
            Couleur centre = ciel(L, H, xe + 0.5, ye + 0.5);
            verifier((hasard == null ? "le pixel du centre" : "le pixel (" + xe + "," + ye + "), écran " + L + " x " + H + ",")
                    + " d'une scène vide : getSkyColor du rayon", pres(centre, couleur) ? centre : ciel(L, H, xe, ye), couleur);
        }

        @Test @Order(10) @Demande(classe = Lancer.class, methodes = "getCouleurPixel")
        @DisplayName("getCouleurPixel : la couleur de la sphère la plus proche")
        void unPixelALaCouleurDeLaPlusProcheSphere() {
            devantLaCamera();
            int L = entier(800, 300, 1500);
            int H = entier(600, 200, 1100);
            Sphere rouge = boule(teinte(0.8, 0, 0), NOIR, 1);
            commeGetColor("le pixel du centre : getColor de la boule proche", scene(lampe(0, 0, -9), loin(), rouge),
                    new Camera(L, H), L / 2, H / 2, 1);
        }

        @Test @Order(11) @Demande(classe = Lancer.class, methodes = "getCouleurPixel")
        @DisplayName("getCouleurPixel : transmet à getColor la profondeur qu'on lui donne")
        void unPixelALaProfondeurDemandee() {
            devantLaCamera();
            int L = entier(80, 60, 120);
            int H = entier(60, 40, 100);
            double R = tirer(2, 1.5, 2);
            // hors de l'axe : deux miroirs y renverraient le rayon sans fin
            for (int p = 1; p < 3; p++) {
                commeGetColor("une boule qui en reflète une autre, profondeur " + p + " : ce que rend getColor",
                        scene(orange(0, 3, 1), boule(gris, gris, 20), boule(0, 0, -2 - R, R, gris, gris, 20)),
                        new Camera(L, H), L / 2 + 1, H / 2 + 1, p);
            }
        }

        @Test @Order(12) @Demande(classe = Lancer.class, methodes = "getCouleurPixel")
        @DisplayName("getCouleurPixel : n'arrondit rien à l'entier, ni xe, ni ye")
        void unPointEntreDeuxPixelsASaCouleur() {
            devantLaCamera();
            int L = entier(8, 7, 20);
            int H = entier(6, 5, 15);
            Camera camera = new Camera(L, H);
            boolean auCentre = pres(ciel(L, H, 1.5, 1.5), pixel(scene(null), camera, 1, 1, 1));
            for (double d : new double[] {0, 0.5, 0.25}) {
                double e = auCentre ? d + 0.5 : d;
                verifier("le ciel au point (1," + (1 + d) + ") d'un écran " + L + " x " + H, ciel(L, H, 1 + e - d, 1 + e),
                        pixel(scene(null), camera, 1, 1 + d, 1));
                commeGetColor("une boule au point (" + (L / 2 + d) + "," + H / 2 + ") d'un écran " + L + " x " + H,
                        scene(lampe(-9, 0, 0), boule(0, 0, 5, 3, gris, NOIR, 1)), camera, L / 2 + d, H / 2, 1);
            }
        }
    }

    @Nested @Order(5) @Tag("lambert") @TestMethodOrder(MethodOrderer.OrderAnnotation.class)
    @Demande(classe = Objet3D.class, methodes = "getColor") @DisplayName("5. Éclairement diffus (Lambert)")
    class Lambert {

        private void eclairee(String demande, Couleur attendue, Lampe lampe, Sphere boule) {
            couleurCommencee();
            verifierApport(demande, attendue, Collections.singletonList(lampe), devant(), boule);
        }

        /** Une lampe à cette distance du contact (0,0,4), dans la direction de biais. */
        private Lampe deBiais(double distance, Couleur couleur) {
            return lampe(s * distance, 0, 4 - c * distance, couleur);
        }

        @Test @Order(1) @Demande(classe = Sphere.class, methodes = "getNormale")
        @DisplayName("getNormale : vers l'extérieur, de longueur 1")
        void laNormaleEstVersLExterieurEtDeLongueurUn() {
            double R = tirer(2, 0.6, 3);
            double[] centre = lieu(0, 0, 5);
            Sphere sphere = boule(0, 0, 5, R);
            double[][] normales = {direction(0, 0, -1), direction(1, 0, 0)};
            for (double[] n : normales) {
                double[] p = somme(centre, R, n);
                Vecteur obtenue = sphere.getNormale(new Point(p[0], p[1], p[2]));
                siCommencee(!new Vecteur().equals(obtenue), Sphere.class, "getNormale",
                        "getNormale rend encore le vecteur nul");
                verifier("la normale en " + texte(p) + (n == normales[0] ? " de la sphère de centre " + texte(centre)
                        + " et de rayon " + nb(R) : ""), n, obtenue);
            }
        }

        @Test @Order(2) @DisplayName("face à la lampe : Kd")
        void faceALaLampeLaCouleurEstKd() {
            Couleur Kd = teinte(0.5, 0.25, 0.75);
            eclairee("lampe blanche droit devant, N.L = 1 : Kd", Kd, lampe(0, 0, 3), boule(Kd, NOIR, 1));
        }

        @Test @Order(3) @DisplayName("de biais : Kd fois le cosinus N.L")
        void deBiaisLaCouleurSuitLeCosinus() {
            Couleur Kd = teinte(0.75, 0.5, 0.25);
            eclairee("N.L = " + nb(c), Kd.mul(c), deBiais(1, BLANC), boule(Kd, NOIR, 1));
            verifierApport("vu de biais aussi : N.L = " + nb(c), Kd.mul(c), Collections.singletonList(deBiais(1, BLANC)),
                    rayon(-3 * s, 0, 4 - 3 * c, s, 0, c), boule(Kd, NOIR, 1));
        }

        @Test @Order(4) @DisplayName("L est normalisé : l'éclairement ne dépend pas de la distance de la lampe")
        void laDistanceDeLaLampeNeChangeRien() {
            for (double k : new double[] {0.5, 1, 5}) {
                double d = arrondi(k * tirer(1, 0.7, 1.3));
                eclairee("lampe dans la direction " + vers(s, 0, -c) + ", à la distance " + d + ", N.L = " + nb(c),
                        gris.mul(c), deBiais(d, BLANC), boule(gris, NOIR, 1));
            }
        }

        @Test @Order(5) @DisplayName("N est normalisé : l'éclairement ne dépend pas du rayon de la sphère")
        void leRayonDeLaSphereNeChangeRien() {
            for (double k : new double[] {0.5, 1, 3}) {
                double R = arrondi(k * tirer(1, 0.7, 1.3));
                eclairee("sphère de rayon " + R + ", lampe à une distance de 1, N.L = " + nb(c), gris.mul(c),
                        deBiais(1, BLANC), boule(0, 0, 4 + R, R, gris, NOIR, 1));
            }
        }

        @Test @Order(6) @DisplayName("dans le dos (N.L négatif), rien")
        void dansLeDosIlFaitNoir() {
            couleurCommencee();
            siEvaluable(!pres(NOIR, apport(c -> !pres(NOIR, c), Collections.singletonList(lampe(0, 0, 3)), devant(),
                    boule(gris, NOIR, 1))), "une boule face à une lampe reste noire");
            eclairee("lampe derrière la boule, N.L = -1", NOIR, lampe(0, 0, tirer(9, 7.5, 12)), boule(gris, NOIR, 1));
        }

        @Test @Order(7) @DisplayName("la couleur de la lampe multiplie Kd, composante par composante")
        void laCouleurDeLaLampeMultiplieKd() {
            Couleur Kd = teinte(0.5, 0.5, 0.8);
            eclairee("Kd " + texte(Kd) + ", lampe " + texte(couleurOrange) + ", N.L = 1", Kd.mul(couleurOrange),
                    orange(0, 0, 3), boule(Kd, NOIR, 1));
        }

        @Test @Order(8) @DisplayName("plusieurs lampes s'ajoutent")
        void lesLampesSAjoutent() {
            couleurCommencee();
            verifierApport("une lampe blanche à N.L = 1, une " + texte(couleurOrange) + " à N.L = " + nb(c) + ", Kd = "
                    + texte(gris), gris.add(gris.mul(couleurOrange).mul(c)),
                    Arrays.asList(lampe(0, 0, 3), deBiais(1, couleurOrange)), devant(), boule(gris, NOIR, 1));
            verifierApport("une lampe derrière la boule, puis une droit devant : Kd = " + texte(gris), gris,
                    Arrays.asList(lampe(0, 0, 9), lampe(0, 0, 3)), devant(), boule(gris, NOIR, 1));
        }

        @Test @Order(9) @DisplayName("sans lampe, une boule mate est noire : rien d'autre ne s'ajoute")
        void sansLampeIlFaitNoir() {
            couleurCommencee();
            verifier("aucune lampe, Ks nul ; le cours n'a pas de couleur ambiante", NOIR,
                    vue(scene(null, boule(gris, NOIR, 1)), devant()));
        }
    }

    @Nested @Order(6) @Tag("phong") @TestMethodOrder(MethodOrderer.OrderAnnotation.class)
    @Demande(classe = Objet3D.class, methodes = "getColor") @DisplayName("6. Éclairement spéculaire (Phong)")
    class Phong {

        @BeforeEach
        void commencee() {
            couleurCommencee();
            Lampe devant = lampe(0, 0, 3);
            kdOublie = pres(vue(scene(devant, boule(NOIR, NOIR, 1)), devant()), vue(scene(devant, boule(gris, NOIR, 1)), devant()));
            siCommencee(!pres(NOIR, deFace()) || refletAilleurs() || matiereBrillante(),
                    Objet3D.class, "getColor", "pour l'instant, Ks et ns ne changent encore aucune couleur");
        }

        private final double ns = tirer(8, 3, 40);
        /** Le sinus et le cosinus d'un regard de biais, et ceux d'une lumière rasante. */
        private final double sv = tirer(0.6, 0.6, 0.8);
        private final double cv = sinus(sv);
        private final double sr = tirer(0.96, 0.94, 0.98);
        private final double cr = sinus(sr);

        /** Ce que ces lampes ajoutent à une boule noire parce que Ks n'est pas nul : qui oublie Kd ne perd pas aussi ces points. */
        private Couleur eclat(Predicate<Couleur> convient, List<Lampe> lampes, Rayon rayon, Couleur Ks, double ns) {
            return aCote(rayon, convient, r -> apport(lampes, r, boule(NOIR, Ks, ns)).sub(apport(lampes, r, boule(NOIR, NOIR, ns))));
        }

        /** La même chose pour une lampe à une distance de 1 du contact (0, 0, 4). */
        private void reflet(String demande, Couleur attendue, Couleur Ks, double ns, double vx, double vz, double lx, double lz) {
            verifier(demande + " (contact " + point(0, 0, 4) + ", lampe en " + point(lx, 0, 4 + lz) + ")", attendue,
                    eclat(c -> pres(attendue, c), Collections.singletonList(lampe(lx, 0, 4 + lz)), rayon(-vx, 0, 4 - vz, vx, 0, vz),
                            Ks, ns));
        }

        private Couleur deFace() {
            return eclat(c -> !pres(NOIR, c), Collections.singletonList(lampe(0, 0, 3)), devant(), gris, 1);
        }

        /** Rien de faux où il ne faut rien ne prouve rien tant qu'il n'y a rien où il faut. */
        private void refletDeFace() {
            dire(!pres(NOIR, deFace()), "face à la lampe et à l'œil, R.-V = 1" + (refletAilleurs()
                    ? " ; il y a un reflet, mais ailleurs : un signe faux ?" : ""), texte(gris), "rien");
        }

        /** Un signe faux met le reflet là où la lumière est rasante. */
        private boolean refletAilleurs() {
            return Stream.of(-0.995, 0.995).anyMatch(x -> !pres(NOIR, eclat(c -> !pres(NOIR, c),
                    Collections.singletonList(lampe(x, 0, 4 - sinus(0.995))), rayon(-sv, 0, 4 - cv, sv, 0, cv), gris, 1)));
        }

        /** Dit si Ks ou ns changent quoi que ce soit d'une boule éclairée. */
        private boolean matiereBrillante() {
            Lampe lampe = lampe(s, 0, 4 - c);
            // de face et de biais : R.V, au lieu de R.-V, n'est positif que vu de très près de la surface
            return Stream.of(devant(), rayon(-4 * sr, 0, 4 - 4 * cr, sr, 0, cr)).anyMatch(r -> {
                Couleur mate = vue(scene(lampe, boule(gris, NOIR, 1)), r);
                return Stream.of(boule(gris, BLANC, 1), boule(gris, gris, 50))
                        .anyMatch(boule -> !pres(mate, vue(scene(lampe, boule), r)));
            });
        }

        @Test @Order(1) @DisplayName("face à la lampe et à l'œil : Ks")
        void faceALaLampeEtALOeilLeRefletEstKs() {
            Couleur Ks = teinte(0.5, 0.25, 0.125);
            reflet("L, N et -V confondus : R.-V = 1, donc Ks", Ks, Ks, ns, 0, 1, 0, -1);
        }

        @Test @Order(2) @DisplayName("dans la direction du miroir : Ks")
        void dansLaDirectionDuMiroirLeRefletEstKs() {
            reflet("V " + vers(s, 0, c) + ", N " + texte(direction(0, 0, -1)) + ", L " + vers(s, 0, -c)
                    + " : l'œil est sur le miroir de L, R.-V = 1", gris, gris, ns, s, c, s, -c);
        }

        @Test @Order(3) @DisplayName("hors du miroir : Ks fois le cosinus R.-V à la puissance ns")
        void leRefletEstUnePuissanceDuCosinus() {
            for (double n : new double[] {1, tirer(2.5, 1.5, 4)}) {
                reflet("R.-V = " + nb(c) + ", ns = " + nb(n) + ", Ks = " + texte(gris), gris.mul(Math.pow(c, n)), gris, n,
                        0, 1, s, -c);
            }
            // la lampe s'écarte de la normale d'un angle de plus que l'œil, de l'autre côté
            double cosinus = tirer(0.96, 0.95, 0.98);
            double lx = arrondi(s * cosinus + c * sinus(cosinus));
            double lz = arrondi(c * cosinus - s * sinus(cosinus));
            double n = tirer(50, 20, 60);
            reflet("V " + vers(s, 0, c) + ", L " + vers(lx, 0, -lz) + " : R.-V = " + nb(cosinus) + ", ns = " + nb(n)
                    + ", Ks = " + texte(gris), gris.mul(Math.pow(cosinus, n)), gris, n, s, c, lx, -lz);
        }

        @Test @Order(4) @DisplayName("un cosinus négatif ne donne pas de reflet, même élevé au carré")
        void unCosinusNegatifNeDonneRien() {
            refletDeFace();
            reflet("V " + vers(sv, 0, cv) + ", L " + vers(-sr, 0, -cr) + " : R.-V = " + nb(cv * cr - sv * sr) + ", ns = 2",
                    NOIR, gris, 2, sv, cv, -sr, -cr);
        }

        @Test @Order(5) @DisplayName("une lampe derrière la surface ne s'y reflète pas")
        void uneLampeDerriereNeSeRefletePas() {
            refletDeFace();
            reflet("N.L = " + nb(-cr) + " et R.-V = " + nb(sv * sr - cv * cr), NOIR, gris, 1, sv, cv, sr, cr);
        }

        @Test @Order(6) @DisplayName("le reflet s'ajoute à l'éclairement diffus")
        void leRefletSAjouteAuDiffus() {
            List<Lampe> lampe = Collections.singletonList(lampe(0, 0, 3));
            Couleur Kd = teinte(0.3, 0.25, 0.125);
            Couleur Ks = teinte(0.2, 0.3, 0.25);
            Couleur mate = apport(c -> !pres(NOIR, c), lampe, devant(), boule(Kd, NOIR, ns));
            Couleur noire = eclat(c -> !pres(NOIR, c), lampe, devant(), Ks, ns);
            verifierApport("une boule mate et brillante : ce que donne la mate (Ks nul), plus ce que donne la brillante (Kd nul)",
                    mate.add(noire), lampe, devant(), boule(Kd, Ks, ns));
        }

        @Test @Order(7) @DisplayName("la couleur de chaque lampe multiplie Ks, composante par composante")
        void laCouleurDesLampesMultiplieKs() {
            Couleur Ks = teinte(0.3, 0.2, 0.4);
            Couleur attendue = Ks.mul(couleurOrange).add(Ks);
            verifier("L, N et -V confondus, lampes " + texte(couleurOrange) + " et blanche : Ks " + texte(couleurOrange) + " + Ks",
                    attendue, eclat(c -> pres(attendue, c), Arrays.asList(orange(0, 0, 3), lampe(0, 0, 3)), devant(), Ks, ns));
        }
    }

    @Nested @Order(7) @Tag("ombres") @TestMethodOrder(MethodOrderer.OrderAnnotation.class)
    @Demande(classe = Objet3D.class, methodes = "getColor") @DisplayName("7. Ombres portées")
    class Ombres {

        private final Sphere boule = boule(gris, teinte(0.25, 0.25, 0.25), 1);
        /** Du contact (0, 0, 4) à la lampe, qui est de biais. */
        private final double D = tirer(10, 8, 12);
        private final Lampe lampe = orange(s * D, 0, 4 - c * D);
        private final double R = tirer(1, 0.7, 1.2);

        /** Où l'on regarde : si la boule se met elle-même à l'ombre, ce n'est pas partout. */
        private int ou;

        private Couleur couleur(Lampe lampe, Sphere... boules) {
            return vue(scene(lampe, boules), aCote(devant(), ou));
        }

        /** Une boule sur le chemin qui va du contact (à 0) à la lampe (à 1), ou d'autant plus haut. */
        private Sphere surLeChemin(double ou, double plusHaut) {
            return boule(s * D * ou, plusHaut, 4 - c * D * ou, R, BLANC, NOIR, 1);
        }

        private Sphere aMiChemin() {
            return surLeChemin(0.5, 0);
        }

        private Couleur eclairee;
        private Couleur eteinte;
        /** Le rayon que lance getColor, s'il ne joint pas la lampe et le contact ; vide s'il les joint, ou s'il n'y en a pas. */
        private String autreRayon;

        /** Dit si ce rayon part de là, dans cette direction. */
        private boolean va(Rayon r, double[] depart, double[] direction) {
            double[] ecart = somme(depart, -1, new double[] {r.getP().x, r.getP().y, r.getP().z});
            return produit(ecart, ecart) < 0.01 && produit(direction, new double[] {r.getV().x, r.getV().y, r.getV().z}) > 0.999;
        }

        /** Dit si ce rayon va de la lampe au contact, ou du contact à la lampe. */
        private boolean joint(Rayon r) {
            return va(r, lieu(s * D, 0, 4 - c * D), direction(-s, 0, c)) || va(r, lieu(0, 0, 4), direction(s, 0, -c));
        }

        @BeforeEach
        void commencee() {
            couleurCommencee();
            eteinte = couleur(null, boule);
            for (eclairee = couleur(lampe, boule); ou < ESSAIS && pres(eclairee, eteinte); eclairee = couleur(lampe, boule)) {
                ou++;
            }
            siEvaluable(!pres(eclairee, eteinte) || ombreDeSoi() != null,
                    "une boule seule, face à une lampe, n'en est pas éclairée");
            List<Rayon> lances = lances(Collections.singletonList(lampe), aCote(devant(), ou), sansReflet, boule);
            // un reflet n'est pas d'une ombre
            lances.removeIf(r -> va(r, lieu(0, 0, 4), direction(0, 0, -1)));
            autreRayon = lances.isEmpty() || lances.stream().anyMatch(this::joint) ? ""
                    : " ; getColor lance " + vers(lances.get(0)) + ", qui ne joint pas la lampe " + point(s * D, 0, 4 - c * D)
                    + " et le contact " + point(0, 0, 4);
            siCommencee(Stream.of(aMiChemin(), surLeChemin(0.8, 0), surLeChemin(2, 0), surLeChemin(-1, 0), surLeChemin(0.5, 3))
                    .anyMatch(autre -> !pres(eclairee, couleur(lampe, boule, autre))
                    || !pres(eclairee, couleur(lampe, autre, boule))) || ombreDeSoi() != null || !lances.isEmpty(),
                    Objet3D.class, "getColor", "pour l'instant, une boule entre la lampe et le contact ne change encore rien");
        }

        @Test @Order(1) @DisplayName("une boule entre la lampe et le contact le met à l'ombre")
        void unObstacleMetALOmbre() {
            verifier("une boule à mi-chemin de la lampe : comme si la lampe était éteinte" + autreRayon, eteinte,
                    couleur(lampe, boule, aMiChemin()));
        }

        @Test @Order(2) @DisplayName("un obstacle est un obstacle, où qu'il soit dans la liste")
        void lOrdreDesBoulesNeComptePas() {
            verifier("la boule qui cache est la première de la scène", eteinte, couleur(lampe, aMiChemin(), boule));
        }

        @Test @Order(3) @DisplayName("une boule derrière la lampe ne fait pas d'ombre")
        void derriereLaLampeRienNeCache() {
            verifier("une boule au-delà de la lampe : rien ne change", eclairee, couleur(lampe, boule, surLeChemin(2, 0)));
        }

        @Test @Order(4) @DisplayName("une boule à côté, ou de l'autre côté, ne fait pas d'ombre")
        void aCoteRienNeCache() {
            verifier("une boule à côté du chemin de la lumière", eclairee, couleur(lampe, boule, surLeChemin(0.5, tirer(3, 2, 4))));
            verifier("une boule derrière la boule éclairée, dans le prolongement", eclairee,
                    couleur(lampe, boule, surLeChemin(-1, 0)));
        }

        @Test @Order(5) @DisplayName("c'est le contact qui est à l'ombre, et non sa boule, ni un point voisin")
        void lOmbreEstCelleDuContact() {
            // de centre (0, 0, 9), et de rayon 5 : le chemin de la lampe à son centre n'est pas celui de la lampe au contact
            Sphere grosse = boule(0, 0, 9, 5, gris, NOIR, 1);
            Couleur claire = couleur(lampe, grosse);
            verifier("une grosse boule, un obstacle entre elle et la lampe" + autreRayon, couleur(null, grosse),
                    couleur(lampe, grosse, aMiChemin()));
            verifier("un obstacle entre la lampe et le centre de cette boule, mais non entre la lampe et le contact", claire,
                    couleur(lampe, grosse, boule(s * D / 2, 0, 6.5 - c * D / 2, 0.5)));
            verifier("une petite boule tout près du contact, entre lui et la lampe", eteinte,
                    couleur(lampe, boule, boule(s * 0.4, 0, 4 - c * 0.4, 0.15)));
        }

        @Test @Order(6) @DisplayName("une boule seule n'est pas dans sa propre ombre")
        void uneBouleNeSeCachePasElleMeme() {
            String ombre = ombreDeSoi();
            if (ombre != null) {
                fail(ombre);
            }
        }

        @Test @Order(7) @DisplayName("l'ombre d'une lampe n'enlève rien aux autres")
        void lesAutresLampesRestent() {
            List<Sphere> boules = Arrays.asList(boule, aMiChemin());
            Lampe autre = lampe(-s * D, 0, 4 - c * D);
            verifier("la première de deux lampes est cachée : il reste l'autre", couleur(autre, boule),
                    vue(new Scene(boules, Arrays.asList(lampe, autre)), aCote(devant(), ou)));
            verifier("la seconde de deux lampes est cachée : il reste la première", couleur(autre, boule),
                    vue(new Scene(boules, Arrays.asList(autre, lampe)), aCote(devant(), ou)));
        }
    }

    @Nested @Order(8) @Tag("reflets") @TestMethodOrder(MethodOrderer.OrderAnnotation.class)
    @Demande(classe = Objet3D.class, methodes = "getColor") @DisplayName("8. Reflets des objets")
    class Reflets {

        private final Couleur Ks = teinte(0.5, 0.25, 0.75);
        /** Le rayon rencontre le miroir à cette distance ; il en repart dans la direction (0, ry, rz). */
        private final double z = tirer(4.2, 3.5, 4.8);
        private final double sn = tirer(0.6, 0.52, 0.66);
        private final double cn = sinus(sn);
        private final double ry = arrondi(2 * sn * cn);
        private final double rz = arrondi(1 - 2 * cn * cn);
        private final Couleur ciel = ciel(ry);
        /** À une distance de 1 du contact du miroir ; sa tache brillante est ailleurs, ns étant très grand. */
        private final Lampe lampe = orange(s, 0, z - c);

        @BeforeEach
        void commencee() {
            couleurCommencee();
            try {
                lances = lances(Collections.<Lampe>emptyList(), devant(), 1, miroir(NOIR, Ks));
                siCommencee(!pres(NOIR, reflet(NOIR, c -> !pres(NOIR, c), Collections.singletonList(lampe), 1)) || profondeurVue()
                        || !lances.isEmpty(),
                        Objet3D.class, "getColor", "pour l'instant, la profondeur ne change encore aucune couleur");
            } catch (StackOverflowError e) {
                // commencée, et sans fin : la vérification le dira mieux
            }
        }

        /** Ceux de la profondeur 1, devant un miroir et sans lampe. */
        private List<Rayon> lances = Collections.emptyList();

        /** De normale (0, 0.6, -0.8), un miroir renvoie (0, 0, 1) dans la direction (0, 0.96, -0.28). */
        private Sphere miroir(Couleur Kd, Couleur Ks) {
            return boule(0, -sn, z + cn, 1, Kd, Ks, 1e5);
        }

        /** Le rayon réfléchi, parti un peu plus loin. */
        private Rayon reflechi(double t) {
            return rayon(0, ry * t, z + rz * t, 0, ry, rz);
        }

        /** Ce que montre une boule parce que Ks n'est pas nul. */
        private Couleur reflet(Couleur Kd, Predicate<Couleur> convient, List<Lampe> lampes, int profondeur, Sphere... autres) {
            List<Sphere> avec = new ArrayList<>(Arrays.asList(autres));
            List<Sphere> sans = new ArrayList<>(Arrays.asList(autres));
            avec.add(miroir(Kd, Ks));
            sans.add(miroir(Kd, NOIR));
            // sans Ks, à la profondeur qui ne montre rien : qui oublie Ks voit son reflet en entier
            return aCote(devant(), convient, rayon -> vue(new Scene(avec, lampes), rayon, profondeur)
                    .sub(vue(new Scene(sans, lampes), rayon)));
        }

        private void verifierReflet(String demande, Couleur attendue, List<Lampe> lampes, int profondeur, Sphere... autres) {
            verifier(demande, attendue, reflet(NOIR, c -> pres(attendue, c), lampes, profondeur, autres));
        }

        /** Dit si la profondeur change la couleur d'une boule, mate ou brillante, devant le ciel ou devant une autre. */
        private boolean profondeurVue() {
            Sphere autre = boule(0, ry * 5, z + rz * 5, 1, gris, gris, 1);
            return Stream.of(miroir(NOIR, BLANC), boule(0, -sn, z + cn, 1, gris, gris, 1), boule(0, -sn, z + cn, 1, gris, NOIR, 1))
                    .anyMatch(b -> Stream.of(scene(lampe, b), scene(lampe, b, autre), scene(null, b))
                    .anyMatch(scene -> !pres(vue(scene, devant()), vue(scene, devant(), 2))));
        }

        @Test @Order(1) @DisplayName("une boule seule reflète le ciel, multiplié par Ks")
        void uneBouleRefleteLeCiel() {
            verifierReflet("Ks = " + texte(Ks) + " fois le ciel dans la direction du miroir, " + vers(0, ry, rz)
                    + (lances.isEmpty() ? "" : " ; getColor lance " + vers(lances.get(0))), Ks.mul(ciel),
                    Collections.singletonList(lampe), 1);
        }

        @Test @Order(2) @DisplayName("le ciel reflété s'ajoute à l'éclairement, une fois quel que soit le nombre de lampes")
        void unRefletNeSAjouteQuUneFois() {
            verifierReflet("sans aucune lampe", Ks.mul(ciel), Collections.<Lampe>emptyList(), 1);
            List<Lampe> lampes = new ArrayList<>(Arrays.asList(lampe, lampe(-s, 0, z - c), lampe(0, 0, z - 1)));
            verifierReflet("à l'ombre d'une boule, le reflet est le même", Ks.mul(ciel), Collections.singletonList(lampe), 1,
                    boule(s / 2, 0, z - c / 2, 0.1));
            int combien = entier(2, 2, 4);
            verifierReflet("avec " + (combien == 2 ? "deux" : "trois") + " lampes", Ks.mul(ciel), lampes.subList(0, combien), 1);
            verifier("une boule mate et miroir, Kd = " + texte(gris) + ", moins la même où Ks est nul", Ks.mul(ciel),
                    reflet(gris, c -> pres(Ks.mul(ciel), c), Collections.singletonList(lampe), 1));
        }

        @Test @Order(3) @DisplayName("une boule mate (Ks nul) ne reflète rien")
        void sansKsIlNYAPasDeReflet() {
            for (Lampe eclaire : new Lampe[] {null, lampe(0, 0, 3)}) {
                Scene mate = scene(eclaire, boule(gris, NOIR, 1));
                verifier("Ks = (0,0,0), Kd = " + texte(gris) + (eclaire == null ? ", sans lampe"
                        : ", une lampe devant, à quoi un reflet s'ajoute") + " : la profondeur 1 moins la profondeur 0", NOIR,
                        vue(mate, rayon(0, s, 0, 0, 0, 1), 1).sub(vue(mate, rayon(0, s, 0, 0, 0, 1))));
            }
        }

        @Test @Order(4) @DisplayName("une boule reflète les autres boules")
        void uneBouleRefleteUneAutreBoule() {
            // sur le chemin du rayon réfléchi, suivi un peu plus loin
            double D = tirer(5, 4.5, 6);
            Sphere mate = boule(0, ry * D, z + rz * D, tirer(1, 0.7, 1.2), teinte(0.25, 0.5, 0.75), NOIR, 1);
            Lampe derriere = orange(0, 0, tirer(8, 7.8, 9));
            Scene scene = scene(derriere, miroir(NOIR, Ks), mate);
            Couleur reflechie = aCote(reflechi(1), c -> !pres(NOIR, c), r -> vue(scene, r, 1));
            for (double t = 0.25; t < 2; t += 0.25) {
                siEvaluable(!pres(NOIR, reflechie) && pres(reflechie, aCote(reflechi(t), c -> pres(reflechie, c),
                        r -> vue(scene, r, 1))), "la boule à refléter n'est pas éclairée, ou pas toujours de même");
            }
            verifierReflet("à la profondeur 2, Ks fois la couleur de la boule reflétée", Ks.mul(reflechie),
                    Collections.singletonList(derriere), 2, mate);
        }

        @Test @Order(5) @DisplayName("une boule ne se reflète pas elle-même")
        void uneBouleNeSeRefletePasElleMeme() {
            Sphere miroir = boule(NOIR, gris, 1e5);
            Scene seule = scene(null, miroir);
            for (double y = -0.55; y < 0.6; y += 0.1) {
                for (double x = -0.53; x < 0.6; x += 0.1) {
                    Couleur vue = vue(seule, rayon(x, y, 0, 0.01, 0.02, 1), 1);
                    dire(vue.b > 0.025, "une boule seule ne reflète que le ciel, jamais noir ; vue de (" + nb(x) + ", " + nb(y) + ")",
                            "le ciel", lisible(vue.r, vue.v, vue.b));
                }
            }
        }

        @Test @Order(6) @DisplayName("à profondeur 0, pas de reflet")
        void aProfondeurZeroIlNYAPasDeReflet() {
            verifierReflet("une boule noire et brillante, à profondeur 0 : ce que Ks y ajoute", NOIR,
                    Collections.singletonList(lampe), 0);
        }

        /** Ni trop faible, que la moitié de la moitié se voie, ni trop fort, que la somme de tous reste sous 1. */
        private final double k = tirer(0.5, 0.43, 0.5);
        private final double ecart = 5 + entier(0, -2, 3) / 4.0;

        /** Deux miroirs face à face, de même couleur. */
        private Couleur face(int profondeur, Lampe lampe) {
            // un axe : tourné ou déplacé, il ne serait plus exact
            devantLaCamera();
            Couleur Kd = lampe == null ? NOIR : new Couleur(k, k, k);
            Couleur Ks = new Couleur(k, k, k);
            return vue(scene(lampe, boule(0, 0, 4 + ecart, 1, Kd, Ks, 20), boule(0, 0, 4 - ecart, 1, Kd, Ks, 20)),
                    rayon(0, 0, 4, 0, 0, 1), profondeur);
        }

        @Test @Order(7) @DisplayName("deux miroirs face à face : un reflet de plus à chaque niveau de profondeur")
        void deuxMiroirsSeRenvoientLaLumiere() {
            try {
                devantLaCamera();
                Lampe milieu = lampe(0, 0, 4, couleurOrange.mul(0.4));
                for (int p = 2; p < 5; p++) {
                    Couleur ajoute = face(p, milieu).sub(face(p - 1, milieu));
                    dire(ajoute.r > PRES_COULEUR, "deux miroirs face à face : ce qu'ajoute le reflet de profondeur " + p,
                            "plus que rien", lisible(ajoute.r, ajoute.v, ajoute.b));
                    verifier("deux miroirs face à face, Ks = " + (k == 0.5 ? "1/2" : nb(k)) + " : le reflet de profondeur "
                            + (p + 1) + " ajoute " + (k == 0.5 ? "la moitié" : nb(k) + " fois") + " de ce qu'ajoute celui de "
                            + "profondeur " + p, ajoute.mul(k), face(p + 1, milieu).sub(face(p, milieu)));
                }
            } catch (StackOverflowError e) {
                fail("deux miroirs face à face se renvoient le rayon sans fin : la profondeur doit diminuer à chaque reflet");
            }
        }

        @Test @Order(8) @DisplayName("deux miroirs face à face : la récursion s'arrête")
        void laRecursionSArrete() {
            try {
                int p = entier(19, 17, 24);
                verifier("deux miroirs noirs face à face, sans lampe : de même à profondeur " + (p + 1) + " qu'à profondeur " + p,
                        face(p, null), face(p + 1, null));
            } catch (StackOverflowError e) {
                fail("deux miroirs face à face se renvoient le rayon sans fin : le paramètre profondeur doit arrêter les appels");
            }
        }
    }

    @Nested @Order(9) @Tag(Repetition.ETAPE) @TestMethodOrder(MethodOrderer.OrderAnnotation.class)
    @DisplayName("9. D'un appel à l'autre")
    class DUnAppelALAutre extends Repetition {
    }
}
