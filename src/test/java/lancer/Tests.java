package lancer;

import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
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

/**
 * Les vérifications élémentaires du cours, étape par étape, dans l'ordre de l'énoncé. À lancer avec le <i>runner</i>
 * JUnit 5. Elles ne demandent que ce que l'énoncé demande, et chaque échec dit ce qui était attendu et ce qui est venu.
 * Une étape que l'on n'a pas commencée ({@code getColor} rend encore du jaune vif, {@code getClosestIntersection} ne
 * trouve rien) est abandonnée, pas ratée.
 */
@DisplayName("Vérifications élémentaires du TP")
@TestClassOrder(ClassOrderer.OrderAnnotation.class)
public class Tests {

    /** Ce qui sépare deux réels que l'on tient pour égaux : le cours ne cherche ici que des erreurs très grossières. */
    private static final double PRES = 1e-5;

    /** La même chose pour une composante d'une couleur : un quart de ce qui se voit à l'écran. */
    private static final double PRES_COULEUR = 1e-3;

    private static final Couleur NOIR = new Couleur(0, 0, 0);
    private static final Couleur BLANC = new Couleur(1, 1, 1);
    private static final Couleur GRIS = new Couleur(0.5, 0.5, 0.5);
    private static final Couleur JAUNE = new Couleur(1, 1, 0);
    private static final Couleur VERT = new Couleur(0, 1, 0);

    private static boolean pres(double a, double b) {
        // l'égalité d'abord : elle seule compare deux infinis
        return a == b || Math.abs(a - b) <= PRES;
    }

    private static boolean pres(Couleur c, Couleur d) {
        return Math.abs(c.r - d.r) <= PRES_COULEUR && Math.abs(c.v - d.v) <= PRES_COULEUR
                && Math.abs(c.b - d.b) <= PRES_COULEUR;
    }

    private static void verifier(String demande, double attendu, double obtenu) {
        dire(pres(attendu, obtenu), demande, lisible(attendu), lisible(obtenu));
    }

    private static void verifier(String demande, double x, double y, double z, Tuple t) {
        dire(t != null && pres(x, t.x) && pres(y, t.y) && pres(z, t.z), demande, triplet(x, y, z), t == null ? t
                : triplet(t.x, t.y, t.z));
    }

    private static void verifier(String demande, Couleur attendue, Couleur c) {
        dire(c != null && pres(attendue, c), demande, triplet(attendue.r, attendue.v, attendue.b), c == null ? c
                : triplet(c.r, c.v, c.b));
    }

    private static void dire(boolean juste, String demande, Object attendu, Object obtenu) {
        if (!juste) {
            fail(demande + " ; attendu : " + attendu + ", obtenu : " + obtenu);
        }
    }

    private static String triplet(double x, double y, double z) {
        return "(" + lisible(x) + ", " + lisible(y) + ", " + lisible(z) + ")";
    }

    /** Sans les derniers chiffres, qui ne sont que des arrondis : 0,8 et non 0,7999999999999999. */
    private static double lisible(double x) {
        return Math.rint(x * 1e9) / 1e9;
    }

    private static Sphere boule(double x, double y, double z, double rayon, Couleur Kd, Couleur Ks, double ns) {
        Sphere boule = new Sphere(new Point(x, y, z), rayon);
        boule.setKd(Kd);
        boule.setKs(Ks);
        boule.setNs(ns);
        return boule;
    }

    private static Lampe lampe(double x, double y, double z) {
        return new Lampe(new Point(x, y, z), BLANC);
    }

    /** Une lampe dont chaque composante est autre : qui en oublie la couleur se voit. */
    private static Lampe orange(double x, double y, double z) {
        return new Lampe(new Point(x, y, z), new Couleur(1, 0.5, 0.25));
    }

    private static Scene scene(Lampe lampe, Sphere... boules) {
        return new Scene(Arrays.asList(boules), lampe == null ? Collections.<Lampe>emptyList()
                : Collections.singletonList(lampe));
    }

    private static Rayon rayon(double px, double py, double pz, double vx, double vy, double vz) {
        return new Rayon(new Point(px, py, pz), new Vecteur(vx, vy, vz));
    }

    /** La couleur que voit ce rayon : il doit rencontrer quelque chose. */
    private static Couleur vue(Scene scene, Rayon rayon, int profondeur) {
        PointContact contact = scene.getClosestIntersection(rayon, null);
        if (contact == null) {
            return fail("ce rayon rencontre une boule : getClosestIntersection doit la trouver");
        }
        return contact.objet.getColor(scene, rayon, contact, profondeur);
    }

    /** La couleur vue sans reflet : à la profondeur 0, ou 1 pour qui compte à partir de 1, et rend noir à 0. */
    private static Couleur vue(Scene scene, Rayon rayon) {
        Scene eclairee = scene(lampe(0, 0, 3), boule(0, 0, 5, 1, GRIS, NOIR, 1));
        boolean desUn = pres(NOIR, vue(eclairee, rayon(0, 0, 0, 0, 0, 1), 0));
        return vue(scene, rayon, desUn ? 1 : 0);
    }

    /** Ce que ces lampes ajoutent à la couleur que voit ce rayon : une couleur ambiante est la même sans elles. */
    private static Couleur apport(List<Lampe> lampes, Rayon rayon, Sphere... boules) {
        Rayon encore = new Rayon(rayon.getP(), rayon.getV());
        return vue(new Scene(Arrays.asList(boules), lampes), rayon).sub(vue(scene(null, boules), encore));
    }

    private static Couleur apport(Lampe lampe, Rayon rayon, Sphere... boules) {
        return apport(Collections.singletonList(lampe), rayon, boules);
    }

    /** Abandonne le test tant que getClosestIntersection ne trouve rien. */
    private static void sceneCommencee() {
        assumeTrue(scene(null, new Sphere(new Point(0, 0, 5), 1))
                .getClosestIntersection(rayon(0, 0, 0, 0, 0, 1), null) != null,
                "étape non commencée : getClosestIntersection ne trouve encore rien, ou ne garde pas ce qu'elle "
                + "trouve");
    }

    /** Abandonne le test tant que getColor rend du jaune vif. */
    private static void couleurCommencee() {
        sceneCommencee();
        Scene scene = scene(null, boule(0, 0, 5, 1, NOIR, NOIR, 1));
        assumeTrue(!pres(JAUNE, vue(scene, rayon(0, 0, 0, 0, 0, 1), 1)),
                "étape non commencée : getColor rend encore du jaune vif");
    }

    @Nested
    @Order(1)
    @Tag("vecteurs")
    @DisplayName("1. Points et vecteurs")
    @TestMethodOrder(MethodOrderer.OrderAnnotation.class)
    class Vecteurs {

        private final Vecteur u = new Vecteur(1, 2, 3);
        private final Vecteur v = new Vecteur(4, -5, 6);
        private final Point p = new Point(1, 2, 3);
        private final Point q = new Point(4, -5, 6);

        @Test
        @Order(1)
        @Tag("Vecteur")
        @DisplayName("new Vecteur(a, b) va de a à b")
        void entreDeuxPointsUnVecteurVaDuPremierAuSecond() {
            verifier("le vecteur de a(1,2,3) à b(4,-5,6) est b - a", 3, -7, 3, new Vecteur(p, q));
        }

        @Test
        @Order(2)
        @Tag("Vecteur")
        @DisplayName("u.sub(v) soustrait deux vecteurs")
        void unVecteurSeSoustrait() {
            verifier("(1,2,3) - (4,-5,6)", -3, 7, -3, u.sub(v));
            verifier("Vecteur.sub(u, v) vaut u.sub(v)", -3, 7, -3, Vecteur.sub(u, v));
        }

        @Test
        @Order(3)
        @Tag("Point")
        @DisplayName("p.sub(v) translate le point de -v")
        void unPointMoinsUnVecteurEstUnPoint() {
            verifier("le point (1,2,3) translaté de -(4,-5,6)", -3, 7, -3, p.sub(v));
            verifier("Point.sub(p, v) vaut p.sub(v)", -3, 7, -3, Point.sub(p, v));
        }

        @Test
        @Order(4)
        @Tag("Point")
        @DisplayName("p.sub(q) est le vecteur de q à p")
        void unPointMoinsUnPointEstUnVecteur() {
            verifier("p(1,2,3) - q(4,-5,6), le vecteur qui va de q à p", -3, 7, -3, p.sub(q));
            verifier("Point.sub(p, q) vaut p.sub(q)", -3, 7, -3, Point.sub(p, q));
        }

        @Test
        @Order(5)
        @Tag("Vecteur")
        @DisplayName("u.dot(v) est le produit scalaire")
        void leProduitScalaireAjouteLesProduitsDesComposantes() {
            verifier("(1,2,3)·(4,-5,6) = 4 - 10 + 18", 12, u.dot(v));
            verifier("Vecteur.dot(u, v) vaut u.dot(v)", 12, Vecteur.dot(u, v));
        }

        @Test
        @Order(6)
        @Tag("Vecteur")
        @DisplayName("norme2 est le carré de la norme")
        void laNormeAuCarreEstLeProduitScalaireDuVecteurParLuiMeme() {
            verifier("le carré de la norme de (1,2,3) : 1 + 4 + 9", 14, u.norme2());
            verifier("la norme de (0,3,-4)", 5, new Vecteur(0, 3, -4).norme());
        }

        @Test
        @Order(7)
        @Tag("Vecteur")
        @DisplayName("les deux façons de normaliser donnent la longueur 1, sans changer la direction")
        void normaliseUnVecteurEstDeLongueurUnEtDeMemeDirection() {
            verifier("(0,3,-4) normalisé par normalized()", 0, 0.6, -0.8, new Vecteur(0, 3, -4).normalized());
            verifier("(0,3,-4) normalisé par Vecteur.normalize", 0, 0.6, -0.8,
                    Vecteur.normalize(new Vecteur(0, 3, -4)));
        }

        @Test
        @Order(8)
        @Tag("Vecteur")
        @DisplayName("les opérations fournies marchent toujours")
        void lesAutresOperationsSontIntactes() {
            verifier("(1,2,3) + (4,-5,6)", 5, -3, 9, u.add(v));
            verifier("2 (1,2,3)", 2, 4, 6, u.mul(2));
            verifier("(1,2,3) / 2", 0.5, 1, 1.5, u.div(2));
            verifier("l'opposé de (1,2,3)", -1, -2, -3, u.neg());
            verifier("le point (1,2,3) translaté de (4,-5,6)", 5, -3, 9, p.add(v));
        }
    }

    @Nested
    @Order(2)
    @Tag("rayons")
    @DisplayName("2. Rayons et caméra")
    @TestMethodOrder(MethodOrderer.OrderAnnotation.class)
    class RayonsEtCamera {

        /** Un demi-pixel, si c'est le centre du pixel que vise cette caméra : la première vérification le dit seule. */
        private double decalage() {
            return pres(-1 + 1 / 800.0, new Camera(800, 600).getRayon(0, 0).getP().x) ? 0.5 : 0;
        }

        private void ecran(String demande, double x, double y, int largeur, int hauteur, double xe, double ye) {
            double d = decalage() * 2 / largeur;
            verifier(demande, x + d, y - d, 0, new Camera(largeur, hauteur).getRayon(xe, ye).getP());
        }

        @Test
        @Order(1)
        @Tag("Rayon")
        @DisplayName("new Rayon(p1, p2) part de p1 vers p2, et son vecteur est normalisé")
        void unRayonVaDUnPointVersUnAutre() {
            Rayon rayon = new Rayon(new Point(1, 1, 1), new Point(1, 4, 5));
            verifier("le rayon de (1,1,1) vers (1,4,5) part de (1,1,1)", 1, 1, 1, rayon.getP());
            verifier("le rayon de (1,1,1) vers (1,4,5) a pour vecteur (0,3,4) normalisé", 0, 0.6, 0.8, rayon.getV());
        }

        @Test
        @Order(2)
        @Tag("Rayon")
        @DisplayName("new Rayon(p, v) part de p, et son vecteur est normalisé")
        void unRayonNormaliseSonVecteur() {
            Rayon rayon = rayon(1, 2, 3, 0, 30, 40);
            verifier("le rayon de départ (1,2,3)", 1, 2, 3, rayon.getP());
            verifier("le rayon de direction (0,30,40) a pour vecteur cette direction normalisée", 0, 0.6, 0.8,
                    rayon.getV());
        }

        @Test
        @Order(3)
        @Tag("Camera")
        @DisplayName("le pixel (0, 0) est en haut à gauche, à x = -ECHELLE/2")
        void leCoinEnHautAGaucheEstAMoinsUn() {
            Point coin = new Camera(800, 600).getRayon(0, 0).getP();
            verifier("le pixel (0,0) d'un écran 800 x 600, avec ECHELLE = 2" + (decalage() > 0
                    ? " (le vôtre est un demi-pixel plus loin)" : ""), -1, 0.75, 0, coin);
            verifier("le pixel (0,0) d'un écran 1280 x 1024", -1, 0.8, 0, new Camera(1280, 1024).getRayon(0, 0).getP());
        }

        @Test
        @Order(4)
        @Tag("Camera")
        @DisplayName("le coin (L, H) est en bas à droite, à x = ECHELLE/2")
        void leCoinEnBasADroiteEstAPlusUn() {
            ecran("le coin (800,600) d'un écran 800 x 600", 1, -0.75, 800, 600, 800, 600);
        }

        @Test
        @Order(5)
        @Tag("Camera")
        @DisplayName("le cadrage ne dépend pas de la taille de l'écran")
        void leCadrageEstLeMemeAToutesLesTailles() {
            ecran("(200,150) d'un écran 800 x 600", -0.5, 0.375, 800, 600, 200, 150);
            ecran("(400,300) d'un écran 1600 x 1200 : le même point", -0.5, 0.375, 1600, 1200, 400, 300);
        }

        @Test
        @Order(6)
        @Tag("Camera")
        @DisplayName("au centre de l'écran, le rayon va droit devant")
        void auCentreLeRayonVaDroitDevant() {
            double d = decalage();
            Rayon rayon = new Camera(800, 600).getRayon(400 - d, 300 - d);
            verifier("le centre de l'écran est l'origine", 0, 0, 0, rayon.getP());
            verifier("l'œil est derrière l'écran, la scène devant (z > 0)", 0, 0, 1, rayon.getV());
        }

        @Test
        @Order(7)
        @Tag("Camera")
        @DisplayName("l'œil voit la largeur de l'écran sous 30° (distance focale)")
        void laLargeurDeLEcranEstVueSousTrenteDegres() {
            double d = decalage();
            double sinus = new Camera(800, 600).getRayon(800 - d, 300 - d).getV().x;
            verifier("au milieu du bord droit, le rayon s'écarte de l'axe de CHAMP/2 = 15° ; en degrés", 15,
                    Math.toDegrees(Math.asin(sinus)));
        }

        @Test
        @Order(8)
        @Tag("Camera")
        @DisplayName("chaque rayon vient de l'œil")
        void tousLesRayonsPassentParLOeil() {
            double focale = 1 / Math.tan(Math.toRadians(15));
            for (double[] pixel : new double[][] {{0, 0}, {800, 600}, {123, 456}}) {
                Rayon rayon = new Camera(800, 600).getRayon(pixel[0], pixel[1]);
                double recul = focale / rayon.getV().z;
                String demande = "en reculant sur le rayon du pixel (" + pixel[0] + "," + pixel[1]
                        + "), on arrive à l'œil";
                verifier(demande, 0, 0, -focale, rayon.getP().add(rayon.getV().mul(-recul)));
            }
        }

        @Test
        @Order(9)
        @Tag("Camera")
        @DisplayName("rien n'est arrondi à l'entier : ni L/2, ni H/2, ni xe, ni ye")
        void uneTailleImpaireOuUnPointEntreDeuxPixelsNArronditRien() {
            ecran("le pixel (0,0) d'un écran 81 x 61 : L/2 = 40.5", -1, 61 / 81.0, 81, 61, 0, 0);
            ecran("le point (200.5,150.25) d'un écran 800 x 600", -0.49875, 0.374375, 800, 600, 200.5, 150.25);
        }
    }

    @Nested
    @Order(3)
    @Tag("sphere")
    @DisplayName("3. Intersection d'un rayon et d'une sphère")
    @TestMethodOrder(MethodOrderer.OrderAnnotation.class)
    class UneSphere {

        private final Sphere sphere = new Sphere(new Point(0, 0, 5), 1);

        private void distance(String demande, double attendue, Sphere sphere, Rayon rayon) {
            verifier(demande, attendue, sphere.getIntersectionDistance(rayon));
        }

        @Test
        @Order(1)
        @Tag("Sphere")
        @DisplayName("des deux points touchés, la distance est celle du plus proche")
        void laDistanceEstCelleDuPlusProcheDesDeuxPoints() {
            distance("sphère de centre (0,0,5) et de rayon 1, vue de (0,0,0) : points à 4 et 6", 4, sphere,
                    rayon(0, 0, 0, 0, 0, 1));
            distance("sphère de centre (4,0,-3) et de rayon 2, vue de (1,0,-7) : points à 3 et 7", 3,
                    new Sphere(new Point(4, 0, -3), 2), rayon(1, 0, -7, 3, 0, 4));
        }

        @Test
        @Order(2)
        @Tag("Sphere")
        @DisplayName("un rayon qui ne passe pas par le centre touche plus loin")
        void lEcartALAxeCompte() {
            distance("rayon de (0,0.6,0) vers +z : demi-corde 0.8, donc 5 - 0.8", 4.2, sphere,
                    rayon(0, 0.6, 0, 0, 0, 1));
        }

        @Test
        @Order(3)
        @Tag("Sphere")
        @DisplayName("sans intersection, la distance est +∞")
        void aCoteLaDistanceEstInfinie() {
            distance("rayon de (0,2,0) vers +z, qui passe à 2 du centre", Double.POSITIVE_INFINITY, sphere,
                    rayon(0, 2, 0, 0, 0, 1));
        }

        @Test
        @Order(4)
        @Tag("Sphere")
        @DisplayName("une sphère dans le dos du rayon n'est pas touchée")
        void dansLeDosLaDistanceEstInfinie() {
            distance("rayon de (0,0,0) vers -z : la sphère est derrière, à -4 et -6", Double.POSITIVE_INFINITY, sphere,
                    rayon(0, 0, 0, 0, 0, -1));
        }

        @Test
        @Order(5)
        @Tag("Sphere")
        @DisplayName("de l'intérieur, la distance est celle de la sortie, jamais négative")
        void deLInterieurLaDistanceEstCelleDeLaSortie() {
            distance("rayon parti de (0,0,5.5) vers -z : points à -0.5, dans le dos, et à 1.5", 1.5, sphere,
                    rayon(0, 0, 5.5, 0, 0, -1));
        }

        @Test
        @Order(6)
        @Tag("Sphere")
        @DisplayName("la distance trouvée est aussi notée dans le rayon")
        void laDistanceEstNoteeDansLeRayon() {
            Rayon rayon = rayon(0, 0, 0, 0, 0, 1);
            sphere.getIntersectionDistance(rayon);
            verifier("rayon.getDistance() après getIntersectionDistance", 4, rayon.getDistance());
        }

        @Test
        @Order(7)
        @Tag("Sphere")
        @DisplayName("une sphère géante, comme le sol des scènes, est touchée au même endroit qu'une petite")
        void uneSphereGeanteEstToucheeSansGrain() {
            double r = 9998.77;
            distance("sphère de centre (0,0," + (r + 4) + ") et de rayon " + r + " (en float, il y a du grain)", 4,
                    new Sphere(new Point(0, 0, r + 4), r), rayon(0, 0, 0, 0, 0, 1));
        }
    }

    @Nested
    @Order(4)
    @Tag("scene")
    @DisplayName("4. Scène de sphères")
    @TestMethodOrder(MethodOrderer.OrderAnnotation.class)
    class UneScene {

        private final Sphere pres = boule(0, 0, 5, 1, NOIR, NOIR, 1);
        private final Sphere loin = boule(0, 0, 9, 1, NOIR, NOIR, 1);
        private final Rayon devant = rayon(0, 0, 0, 0, 0, 1);

        private void plusProche(String demande, Sphere attendue, PointContact contact) {
            dire(contact != null && contact.objet == attendue, demande, nom(attendue), contact == null ? null
                    : nom(contact.objet));
        }

        private String nom(Objet3D objet) {
            return objet == pres ? "la boule proche" : objet == loin ? "la boule lointaine" : String.valueOf(objet);
        }

        @Test
        @Order(1)
        @Tag("Rayon")
        @DisplayName("calcContact : le point P + distance V")
        void leContactEstSurLeRayonALaDistanceTrouvee() {
            Rayon rayon = rayon(1, 0, 0, 0, 0, 1);
            Sphere sphere = new Sphere(new Point(1, 0, 5), 1);
            sphere.getIntersectionDistance(rayon);
            assumeTrue(Double.isInfinite(rayon.getDistance()) || rayon.calcContact() != null,
                    "étape non commencée : calcContact ne rend encore rien");
            PointContact contact = rayon.calcContact();
            verifier("le contact du rayon de (1,0,0) vers +z avec la sphère de centre (1,0,5) et de rayon 1", 1, 0, 4,
                    contact);
            dire(contact.objet == sphere, "l'objet du contact est la sphère touchée", sphere, contact.objet);
            verifier("la distance que porte ce contact", 4, contact.distance);
        }

        @Test
        @Order(2)
        @Tag("Rayon")
        @DisplayName("calcContact : null si la distance est infinie")
        void sansDistanceIlNYAPasDeContact() {
            dire(devant.calcContact() == null, "calcContact d'un rayon qui n'a rien touché", null, "un contact");
        }

        @Test
        @Order(3)
        @Tag("Scene")
        @DisplayName("getClosestIntersection : la plus proche des sphères, quel que soit leur ordre")
        void laPlusProcheDesSpheresEstTrouvee() {
            sceneCommencee();
            plusProche("boules à 4 (proche) et à 8 (lointaine), la lointaine en premier", pres,
                    scene(null, loin, pres).getClosestIntersection(devant, null));
            plusProche("boules à 4 (proche) et à 8 (lointaine), la proche en premier", pres,
                    scene(null, pres, loin).getClosestIntersection(devant, null));
        }

        @Test
        @Order(4)
        @Tag("Scene")
        @DisplayName("getClosestIntersection : le contact a la distance et la position de la plus proche")
        void leContactEstCeluiDeLaPlusProche() {
            sceneCommencee();
            PointContact contact = scene(null, pres, loin).getClosestIntersection(devant, null);
            verifier("la distance du contact, la boule proche étant à 4 et la lointaine à 8", 4, contact.distance);
            verifier("le point de contact", 0, 0, 4, contact);
        }

        @Test
        @Order(5)
        @Tag("Scene")
        @DisplayName("getClosestIntersection : la sphère à ignorer est ignorée")
        void laSphereAIgnorerEstIgnoree() {
            sceneCommencee();
            plusProche("sauf la boule proche", loin, scene(null, loin, pres).getClosestIntersection(devant, pres));
            plusProche("sauf la boule lointaine", pres, scene(null, pres, loin).getClosestIntersection(devant, loin));
            plusProche("sauf la boule proche, qui est la première", loin,
                    scene(null, pres, loin).getClosestIntersection(devant, pres));
        }

        @Test
        @Order(6)
        @Tag("Scene")
        @DisplayName("getClosestIntersection : null où il n'y a rien, même derrière le rayon")
        void ouIlNYARienIlNYAPasDeContact() {
            sceneCommencee();
            Scene scene = scene(null, pres, loin);
            dire(scene.getClosestIntersection(rayon(0, 0, 0, 0, 1, 0), null) == null,
                    "rayon vers le haut, boules devant", null, "un contact");
            dire(scene.getClosestIntersection(rayon(0, 0, 0, 0, 0, -1), null) == null, "rayon dos aux boules", null,
                    "un contact");
            dire(scene.getClosestIntersection(devant, null) != null && scene(null, pres)
                    .getClosestIntersection(devant, pres) == null,
                    "une seule boule, à ignorer", null, "un contact");
        }

        private Couleur pixel(Scene scene) {
            sceneCommencee();
            Couleur couleur = new Lancer(scene, new Camera(800, 600)).getCouleurPixel(400, 300, 1);
            assumeTrue(!pres(VERT, couleur), "étape non commencée : getCouleurPixel rend encore du vert");
            return couleur;
        }

        @Test
        @Order(7)
        @Tag("Lancer")
        @DisplayName("getCouleurPixel : la couleur du ciel où il n'y a rien")
        void unPixelVideALaCouleurDuCiel() {
            Couleur couleur = pixel(scene(null));
            // le rayon passe par les coordonnées entières, V.y = 0, ou par le centre du pixel, un demi-pixel plus bas
            double y = -0.5 * 2 / 800;
            double focale = 1 / Math.tan(Math.toRadians(15));
            Couleur centre = new Couleur(0.5, 0.4 + 0.2 * y / Math.sqrt(2 * y * y + focale * focale), 0.1);
            verifier("le pixel du centre d'une scène vide : getSkyColor du rayon",
                    pres(centre, couleur) ? centre : new Couleur(0.5, 0.4, 0.1), couleur);
        }

        @Test
        @Order(8)
        @Tag("Lancer")
        @DisplayName("getCouleurPixel : la couleur de la sphère la plus proche")
        void unPixelALaCouleurDeLaPlusProcheSphere() {
            Sphere rouge = boule(0, 0, 5, 1, new Couleur(0.8, 0, 0), NOIR, 1);
            Scene scene = scene(lampe(0, 0, -9), boule(0, 0, 9, 1, BLANC, NOIR, 1), rouge);
            Couleur couleur = pixel(scene);
            verifier("le pixel du centre : getColor de la boule proche", vue(scene, devant, 1), couleur);
        }

        @Test
        @Order(9)
        @Tag("Lancer")
        @DisplayName("getCouleurPixel : transmet à getColor la profondeur qu'on lui donne")
        void unPixelALaProfondeurDemandee() {
            Camera camera = new Camera(80, 60);
            Scene scene = scene(orange(0, 3, 1), boule(0, 0, 5, 1, GRIS, GRIS, 20), boule(0, 0, -4, 2, GRIS, GRIS, 20));
            pixel(scene);
            for (int p = 1; p < 3; p++) {
                Couleur pixel = new Lancer(scene, camera).getCouleurPixel(41, 31, p);
                Couleur coin = vue(scene, camera.getRayon(41, 31), p);
                Couleur centre = vue(scene, camera.getRayon(41.5, 31.5), p);
                verifier("une boule qui en reflète une autre, profondeur " + p + " : ce que rend getColor",
                        pres(centre, pixel) ? centre : coin, pixel);
            }
        }
    }

    @Nested
    @Order(5)
    @Tag("lambert")
    @DisplayName("5. Éclairement diffus (Lambert)")
    @TestMethodOrder(MethodOrderer.OrderAnnotation.class)
    class Lambert {

        private final Rayon devant = rayon(0, 0, 0, 0, 0, 1);

        private Couleur eclairee(Lampe lampe, Sphere boule) {
            couleurCommencee();
            return apport(lampe, devant, boule);
        }

        @Test
        @Order(1)
        @Tag("Sphere")
        @DisplayName("getNormale : vers l'extérieur, de longueur 1")
        void laNormaleEstVersLExterieurEtDeLongueurUn() {
            Sphere sphere = new Sphere(new Point(0, 0, 5), 2);
            assumeTrue(!new Vecteur().equals(sphere.getNormale(new Point(0, 0, 3))),
                    "étape non commencée : getNormale rend encore le vecteur nul");
            verifier("la normale en (0,0,3) de la sphère de centre (0,0,5) et de rayon 2", 0, 0, -1,
                    sphere.getNormale(new Point(0, 0, 3)));
            verifier("la normale en (2,0,5)", 1, 0, 0, sphere.getNormale(new Point(2, 0, 5)));
        }

        @Test
        @Order(2)
        @Tag("Objet3D")
        @DisplayName("face à la lampe : Kd")
        void faceALaLampeLaCouleurEstKd() {
            Couleur Kd = new Couleur(0.5, 0.25, 0.75);
            verifier("lampe blanche droit devant, N.L = 1 : Kd", Kd,
                    eclairee(lampe(0, 0, 3), boule(0, 0, 5, 1, Kd, NOIR, 1)));
        }

        @Test
        @Order(3)
        @Tag("Objet3D")
        @DisplayName("de biais : Kd fois le cosinus N.L")
        void deBiaisLaCouleurSuitLeCosinus() {
            // de (0, 0, 4), la lampe est dans la direction (0.6, 0, -0.8), à une distance de 1
            verifier("N.L = 0.8", new Couleur(0.6, 0.4, 0.2),
                    eclairee(lampe(0.6, 0, 3.2), boule(0, 0, 5, 1, new Couleur(0.75, 0.5, 0.25), NOIR, 1)));
        }

        @Test
        @Order(4)
        @Tag("Objet3D")
        @DisplayName("L est normalisé : l'éclairement ne dépend pas de la distance de la lampe")
        void laDistanceDeLaLampeNeChangeRien() {
            for (double d : new double[] {0.5, 1, 5, 50}) {
                verifier("lampe dans la direction (0.6,0,-0.8), à la distance " + d + ", N.L = 0.8",
                        new Couleur(0.4, 0.4, 0.4),
                        eclairee(lampe(0.6 * d, 0, 4 - 0.8 * d), boule(0, 0, 5, 1, GRIS, NOIR, 1)));
            }
        }

        @Test
        @Order(5)
        @Tag("Objet3D")
        @DisplayName("N est normalisé : l'éclairement ne dépend pas du rayon de la sphère")
        void leRayonDeLaSphereNeChangeRien() {
            for (double r : new double[] {0.5, 1, 3}) {
                verifier("sphère de rayon " + r + ", lampe à une distance de 1, N.L = 0.8", new Couleur(0.4, 0.4, 0.4),
                        eclairee(lampe(0.6, 0, 3.2), boule(0, 0, 4 + r, r, GRIS, NOIR, 1)));
            }
        }

        @Test
        @Order(6)
        @Tag("Objet3D")
        @DisplayName("dans le dos (N.L négatif), rien")
        void dansLeDosIlFaitNoir() {
            verifier("lampe derrière la boule, N.L = -1", NOIR,
                    eclairee(lampe(0, 0, 9), boule(0, 0, 5, 1, GRIS, NOIR, 1)));
        }

        @Test
        @Order(7)
        @Tag("Objet3D")
        @DisplayName("la couleur de la lampe multiplie Kd, composante par composante")
        void laCouleurDeLaLampeMultiplieKd() {
            verifier("Kd (0.5,0.5,0.8), lampe (1,0.5,0.25), N.L = 1", new Couleur(0.5, 0.25, 0.2),
                    eclairee(orange(0, 0, 3), boule(0, 0, 5, 1, new Couleur(0.5, 0.5, 0.8), NOIR, 1)));
        }

        @Test
        @Order(8)
        @Tag("Objet3D")
        @DisplayName("plusieurs lampes s'ajoutent")
        void lesLampesSAjoutent() {
            couleurCommencee();
            List<Lampe> deux = Arrays.asList(lampe(0, 0, 3), orange(0.6, 0, 3.2));
            verifier("une lampe blanche à N.L = 1, une (1,0.5,0.25) à N.L = 0.8, Kd = 0.5", new Couleur(0.9, 0.7, 0.6),
                    apport(deux, devant, boule(0, 0, 5, 1, GRIS, NOIR, 1)));
        }

        @Test
        @Order(9)
        @Tag("Objet3D")
        @DisplayName("sans lampe, une boule mate est noire : rien d'autre ne s'ajoute")
        void sansLampeIlFaitNoir() {
            couleurCommencee();
            verifier("aucune lampe, Ks nul ; le cours n'a pas de couleur ambiante", NOIR,
                    vue(scene(null, boule(0, 0, 5, 1, GRIS, NOIR, 1)), devant));
        }
    }

    @Nested
    @Order(6)
    @Tag("phong")
    @DisplayName("6. Éclairement spéculaire (Phong)")
    @TestMethodOrder(MethodOrderer.OrderAnnotation.class)
    class Phong {

        @BeforeEach
        void commencee() {
            couleurCommencee();
        }

        /** Ce qu'une lampe, à une distance de 1 du contact (0, 0, 4), ajoute à une boule noire et brillante. */
        private Couleur reflet(Couleur Ks, double ns, double vx, double vz, double lx, double lz) {
            return apport(lampe(lx, 0, 4 + lz), rayon(-vx, 0, 4 - vz, vx, 0, vz), boule(0, 0, 5, 1, NOIR, Ks, ns));
        }

        /** Rien de faux où il ne faut rien ne prouve rien tant qu'il n'y a rien nulle part. */
        private void refletCommence() {
            assumeTrue(!pres(NOIR, reflet(GRIS, 1, 0, 1, 0, -1)),
                    "étape non commencée : face à la lampe et à l'œil, aucun reflet");
        }

        @Test
        @Order(1)
        @Tag("Objet3D")
        @DisplayName("face à la lampe et à l'œil : Ks")
        void faceALaLampeEtALOeilLeRefletEstKs() {
            Couleur Ks = new Couleur(0.5, 0.25, 0.125);
            verifier("L, N et -V confondus : R.-V = 1, donc Ks", Ks, reflet(Ks, 8, 0, 1, 0, -1));
        }

        @Test
        @Order(2)
        @Tag("Objet3D")
        @DisplayName("dans la direction du miroir : Ks")
        void dansLaDirectionDuMiroirLeRefletEstKs() {
            verifier("V (0.6,0,0.8), N (0,0,-1), L (0.6,0,-0.8) : l'œil est sur le miroir de L, R.-V = 1", GRIS,
                    reflet(GRIS, 8, 0.6, 0.8, 0.6, -0.8));
        }

        @Test
        @Order(3)
        @Tag("Objet3D")
        @DisplayName("hors du miroir : Ks fois le cosinus R.-V à la puissance ns")
        void leRefletEstUnePuissanceDuCosinus() {
            verifier("R.-V = 0.8, ns = 1, Ks = 0.5", GRIS.mul(0.8), reflet(GRIS, 1, 0, 1, 0.6, -0.8));
            verifier("R.-V = 0.8, ns = 2.5, Ks = 0.5", GRIS.mul(Math.pow(0.8, 2.5)), reflet(GRIS, 2.5, 0, 1, 0.6, -0.8));
            verifier("V (0.6,0,0.8), L (0.8,0,-0.6) : R.-V = 0.96, ns = 50, Ks = 0.5", GRIS.mul(Math.pow(0.96, 50)),
                    reflet(GRIS, 50, 0.6, 0.8, 0.8, -0.6));
        }

        @Test
        @Order(4)
        @Tag("Objet3D")
        @DisplayName("un cosinus négatif ne donne pas de reflet, même élevé au carré")
        void unCosinusNegatifNeDonneRien() {
            refletCommence();
            verifier("V (0.6,0,0.8), L (-0.96,0,-0.28) : R.-V = -0.352, ns = 2", NOIR,
                    reflet(GRIS, 2, 0.6, 0.8, -0.96, -0.28));
        }

        @Test
        @Order(5)
        @Tag("Objet3D")
        @DisplayName("une lampe derrière la surface ne s'y reflète pas")
        void uneLampeDerriereNeSeRefletePas() {
            refletCommence();
            verifier("N.L = -0.28 et R.-V = 0.352", NOIR, reflet(GRIS, 1, 0.6, 0.8, 0.96, 0.28));
        }

        @Test
        @Order(6)
        @Tag("Objet3D")
        @DisplayName("le reflet s'ajoute à l'éclairement diffus")
        void leRefletSAjouteAuDiffus() {
            refletCommence();
            Lampe lampe = lampe(0, 0, 3);
            Rayon devant = rayon(0, 0, 0, 0, 0, 1);
            Couleur Kd = new Couleur(0.3, 0.25, 0.125);
            Couleur Ks = new Couleur(0.2, 0.3, 0.25);
            Couleur mate = apport(lampe, devant, boule(0, 0, 5, 1, Kd, NOIR, 8));
            Couleur noire = apport(lampe, devant, boule(0, 0, 5, 1, NOIR, Ks, 8));
            Couleur deux = apport(lampe, devant, boule(0, 0, 5, 1, Kd, Ks, 8));
            verifier("une boule mate et brillante : ce que donne la mate (Ks nul), plus ce que donne la brillante "
                    + "(Kd nul)",
                    mate.add(noire), deux);
        }

        @Test
        @Order(7)
        @Tag("Objet3D")
        @DisplayName("la couleur de chaque lampe multiplie Ks, composante par composante")
        void laCouleurDesLampesMultiplieKs() {
            refletCommence();
            Couleur Ks = new Couleur(0.3, 0.2, 0.4);
            verifier("L, N et -V confondus, lampes (1,0.5,0.25) et blanche : Ks (1,0.5,0.25) + Ks",
                    new Couleur(0.6, 0.3, 0.5),
                    apport(Arrays.asList(orange(0, 0, 3), lampe(0, 0, 3)), rayon(0, 0, 0, 0, 0, 1),
                            boule(0, 0, 5, 1, NOIR, Ks, 8)));
        }
    }

    @Nested
    @Order(7)
    @Tag("ombres")
    @DisplayName("7. Ombres portées")
    @TestMethodOrder(MethodOrderer.OrderAnnotation.class)
    class Ombres {

        private final Sphere boule = boule(0, 0, 5, 1, new Couleur(0.5, 0.5, 0.5), new Couleur(0.25, 0.25, 0.25), 1);
        // du contact (0, 0, 4), dans la direction (0.6, 0, -0.8), à une distance de 10
        private final Lampe lampe = orange(6, 0, -4);

        private Couleur couleur(Lampe lampe, Sphere... boules) {
            return vue(scene(lampe, boules), rayon(0, 0, 0, 0, 0, 1));
        }

        private Couleur eclairee;
        private Couleur eteinte;

        @BeforeEach
        void commencee() {
            couleurCommencee();
            eclairee = couleur(lampe, boule);
            eteinte = couleur(null, boule);
            assumeTrue(!pres(eclairee, eteinte),
                    "étape non évaluable : une boule seule, face à une lampe, n'en est pas éclairée");
        }

        private void ombreCommencee() {
            assumeTrue(!pres(eclairee, couleur(lampe, boule, boule(3, 0, 0, 1, BLANC, NOIR, 1))),
                    "étape non commencée : une boule entre la lampe et le contact ne change rien");
        }

        @Test
        @Order(1)
        @Tag("Objet3D")
        @DisplayName("une boule entre la lampe et le contact le met à l'ombre")
        void unObstacleMetALOmbre() {
            verifier("une boule à mi-chemin de la lampe : comme si la lampe était éteinte", eteinte,
                    couleur(lampe, boule, boule(3, 0, 0, 1, BLANC, NOIR, 1)));
        }

        @Test
        @Order(2)
        @Tag("Objet3D")
        @DisplayName("un obstacle est un obstacle, où qu'il soit dans la liste")
        void lOrdreDesBoulesNeComptePas() {
            verifier("la boule qui cache est la première de la scène", eteinte,
                    couleur(lampe, boule(3, 0, 0, 1, BLANC, NOIR, 1), boule));
        }

        @Test
        @Order(3)
        @Tag("Objet3D")
        @DisplayName("une boule derrière la lampe ne fait pas d'ombre")
        void derriereLaLampeRienNeCache() {
            ombreCommencee();
            verifier("une boule au-delà de la lampe : rien ne change", eclairee,
                    couleur(lampe, boule, boule(12, 0, -12, 1, BLANC, NOIR, 1)));
        }

        @Test
        @Order(4)
        @Tag("Objet3D")
        @DisplayName("une boule à côté, ou de l'autre côté, ne fait pas d'ombre")
        void aCoteRienNeCache() {
            ombreCommencee();
            verifier("une boule à côté du chemin de la lumière", eclairee,
                    couleur(lampe, boule, boule(3, 3, 0, 1, BLANC, NOIR, 1)));
            verifier("une boule derrière la boule éclairée, dans le prolongement", eclairee,
                    couleur(lampe, boule, boule(-6, 0, 12, 1, BLANC, NOIR, 1)));
        }

        @Test
        @Order(5)
        @Tag("Objet3D")
        @DisplayName("une boule seule n'est pas dans sa propre ombre")
        void uneBouleNeSeCachePasElleMeme() {
            ombreCommencee();
            int noirs = 0;
            int points = 0;
            for (double y = -0.55; y < 0.6; y += 0.1) {
                for (double x = -0.53; x < 0.6; x += 0.1) {
                    Rayon rayon = rayon(x, y, 0, 0.01, 0.02, 1);
                    points++;
                    noirs += pres(NOIR, apport(lampe(1, 2, -7), rayon, boule(0, 0, 5, 1, GRIS, NOIR, 1))) ? 1 : 0;
                }
            }
            dire(noirs == 0, "points noirs sur " + points
                    + ", tous face à la lampe : le rayon d'ombre retrouve la boule elle-même", 0, noirs);
        }

        @Test
        @Order(6)
        @Tag("Objet3D")
        @DisplayName("l'ombre d'une lampe n'enlève rien aux autres")
        void lesAutresLampesRestent() {
            List<Sphere> boules = Arrays.asList(boule, boule(3, 0, 0, 1, BLANC, NOIR, 1));
            Lampe autre = lampe(-6, 0, -4);
            Rayon devant = rayon(0, 0, 0, 0, 0, 1);
            verifier("la première de deux lampes est cachée : il reste l'autre", couleur(autre, boule),
                    vue(new Scene(boules, Arrays.asList(lampe, autre)), devant));
        }
    }

    @Nested
    @Order(8)
    @Tag("reflets")
    @DisplayName("8. Reflets des objets")
    @TestMethodOrder(MethodOrderer.OrderAnnotation.class)
    class Reflets {

        private final Couleur Ks = new Couleur(0.5, 0.25, 0.75);
        private final Rayon devant = rayon(0, 0, 0, 0, 0, 1);
        /** À une distance de 1 du contact (0, 0, 4.2) du miroir ; sa tache brillante est ailleurs, ns étant très grand. */
        private final Lampe lampe = orange(0.6, 0, 3.4);

        @BeforeEach
        void commencee() {
            couleurCommencee();
        }

        /** De N (0, 0.6, -0.8), le rayon (0, 0, 1) repart de (0, 0, 4.2) dans la direction (0, 0.96, -0.28). */
        private Sphere miroir(Couleur Ks) {
            return boule(0, -0.6, 5, 1, NOIR, Ks, 1e5);
        }

        private final Couleur ciel = rayon(0, 0, 0, 0, 0.96, -0.28).getSkyColor();

        /** Ce que montre une boule parce que Ks n'est pas nul. */
        private Couleur reflet(List<Lampe> lampes, int profondeur, Sphere... autres) {
            List<Sphere> avec = new ArrayList<>(Arrays.asList(autres));
            List<Sphere> sans = new ArrayList<>(Arrays.asList(autres));
            avec.add(miroir(Ks));
            sans.add(miroir(NOIR));
            return vue(new Scene(avec, lampes), devant, profondeur)
                    .sub(vue(new Scene(sans, lampes), rayon(0, 0, 0, 0, 0, 1), profondeur));
        }

        private void commenceeOuSansFin() {
            try {
                refletCommence();
            } catch (StackOverflowError e) {
                // commencée, et sans fin : la vérification le dira mieux
            }
        }

        private void refletCommence() {
            assumeTrue(!pres(NOIR, reflet(Collections.singletonList(lampe), 1)),
                    "étape non commencée : une boule brillante, seule, ne reflète rien");
        }

        @Test
        @Order(1)
        @Tag("Objet3D")
        @DisplayName("une boule seule reflète le ciel, multiplié par Ks")
        void uneBouleRefleteLeCiel() {
            verifier("Ks fois le ciel dans la direction du miroir, (0,0.96,-0.28)", Ks.mul(ciel),
                    reflet(Collections.singletonList(lampe), 1));
        }

        @Test
        @Order(2)
        @Tag("Objet3D")
        @DisplayName("le ciel reflété ne dépend pas du nombre de lampes")
        void unRefletNeSAjouteQuUneFois() {
            commenceeOuSansFin();
            verifier("sans aucune lampe", Ks.mul(ciel), reflet(Collections.<Lampe>emptyList(), 1));
            verifier("avec deux lampes", Ks.mul(ciel), reflet(Arrays.asList(lampe, lampe(-0.6, 0, 3.4)), 1));
        }

        @Test
        @Order(3)
        @Tag("Objet3D")
        @DisplayName("une boule mate (Ks nul) ne reflète rien")
        void sansKsIlNYAPasDeReflet() {
            commenceeOuSansFin();
            Scene mate = scene(null, boule(0, 0, 5, 1, NOIR, NOIR, 1));
            verifier("Ks = (0,0,0), sans lampe : la profondeur 1 moins la profondeur 0", NOIR,
                    vue(mate, devant, 1).sub(vue(mate, rayon(0, 0, 0, 0, 0, 1), 0)));
        }

        @Test
        @Order(4)
        @Tag("Objet3D")
        @DisplayName("une boule reflète les autres boules")
        void uneBouleRefleteUneAutreBoule() {
            // sur le chemin du rayon réfléchi, suivi un peu plus loin
            Sphere mate = boule(0, 4.8, 2.8, 1, new Couleur(0.25, 0.5, 0.75), NOIR, 1);
            Lampe derriere = orange(0, 0, 8);
            Scene scene = scene(derriere, miroir(Ks), mate);
            Couleur reflechie = vue(scene, rayon(0, 0.96, 3.92, 0, 0.96, -0.28), 1);
            for (double t = 0.25; t < 2; t += 0.25) {
                assumeTrue(!pres(NOIR, reflechie) && pres(reflechie,
                        vue(scene, rayon(0, 0.96 * t, 4.2 - 0.28 * t, 0, 0.96, -0.28), 1)),
                        "étape non évaluable : la boule à refléter n'est pas éclairée, ou pas toujours de même "
                        + "(ombre d'elle-même ?)");
            }
            verifier("à la profondeur 2, Ks fois la couleur de la boule reflétée", Ks.mul(reflechie),
                    reflet(Collections.singletonList(derriere), 2, mate));
        }

        @Test
        @Order(5)
        @Tag("Objet3D")
        @DisplayName("une boule ne se reflète pas elle-même")
        void uneBouleNeSeRefletePasElleMeme() {
            Sphere miroir = boule(0, 0, 5, 1, NOIR, GRIS, 1e5);
            for (double y = -0.55; y < 0.6; y += 0.1) {
                Couleur vue = vue(scene(null, miroir), rayon(0.13, y, 0, 0.01, 0.02, 1), 1);
                dire(vue.b > 0.025, "une boule seule ne reflète que le ciel, jamais noir ; vue à la hauteur " + y,
                        "le ciel", triplet(vue.r, vue.v, vue.b));
            }
        }

        @Test
        @Order(6)
        @Tag("Objet3D")
        @DisplayName("à profondeur 0, pas de reflet")
        void aProfondeurZeroIlNYAPasDeReflet() {
            commenceeOuSansFin();
            verifier("une boule noire et brillante, à profondeur 0 : ce que Ks y ajoute", NOIR,
                    reflet(Collections.singletonList(lampe), 0));
        }

        /** Deux miroirs face à face, Ks = 1/2, de même couleur. */
        private Couleur face(int profondeur, Lampe lampe) {
            Sphere loin = boule(0, 0, 9, 1, lampe == null ? NOIR : GRIS, GRIS, 20);
            Sphere pres = boule(0, 0, -1, 1, lampe == null ? NOIR : GRIS, GRIS, 20);
            return vue(scene(lampe, loin, pres), rayon(0, 0, 4, 0, 0, 1), profondeur);
        }

        @Test
        @Order(7)
        @Tag("Objet3D")
        @DisplayName("deux miroirs face à face : un reflet de plus à chaque niveau de profondeur")
        void deuxMiroirsSeRenvoientLaLumiere() {
            commenceeOuSansFin();
            try {
                // des couleurs qui restent sous 1, où l'on peut vouloir les limiter
                Lampe milieu = orange(0, 3, 4);
                for (int p = 2; p < 5; p++) {
                    Couleur ajoute = face(p, milieu).sub(face(p - 1, milieu));
                    dire(ajoute.r > PRES_COULEUR, "deux miroirs face à face : ce qu'ajoute le reflet de profondeur " + p,
                            "plus que rien", triplet(ajoute.r, ajoute.v, ajoute.b));
                    verifier("deux miroirs face à face, Ks = 1/2 : le reflet de profondeur " + (p + 1)
                            + " ajoute la moitié de ce qu'ajoute celui de profondeur " + p, ajoute.mul(0.5),
                            face(p + 1, milieu).sub(face(p, milieu)));
                }
            } catch (StackOverflowError e) {
                fail("deux miroirs face à face se renvoient le rayon sans fin : la profondeur doit diminuer à chaque "
                        + "reflet");
            }
        }

        @Test
        @Order(8)
        @Tag("Objet3D")
        @DisplayName("deux miroirs face à face : la récursion s'arrête")
        void laRecursionSArrete() {
            commenceeOuSansFin();
            try {
                verifier("deux miroirs noirs face à face, sans lampe : de même à profondeur 20 qu'à profondeur 19",
                        face(19, null), face(20, null));
            } catch (StackOverflowError e) {
                fail("deux miroirs face à face se renvoient le rayon sans fin : le paramètre profondeur doit arrêter "
                        + "les appels");
            }
        }
    }
}
