package lancer.rapide;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import lancer.essai.Essai;
import lancer.essai.Modification;
import lancer.essai.Sommes;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Aucune modification sans effet : des lignes des classes du cours sont changées, les classes recompilées, et l'image par défaut est au
 * bit près celle des boucles du cours, qui n'est plus celle d'avant ; le récit d'un pixel ne compte pas ce qui n'y est pas.
 */
class ModificationsTest {

    private static final String SCENE = "scenes/scene1.ini";

    private static final String MOBILE = "Sphere|private final Point centre|public Point centre"
            + "|Sphere|private final double rayon|public double rayon"
            + "|Lancer|private final Atelier atelier;|static void placer(Scene scene, double x) { "
            + "Sphere s = (Sphere) scene.getObjets().get(2); s.centre = new Point(x, s.centre.y, s.centre.z); } "
            + "private final Atelier atelier;|";

    /** L'image du programme tel qu'il est. */
    private static float[] avant;

    @TempDir
    Path dossier;

    @BeforeAll
    static void dessinerSansRienChanger(@TempDir Path commun) throws IOException {
        try (Essai.Isole programme = new Essai.Isole(Collections.<Path>emptyList())) {
            avant = dessiner(programme, commun, SCENE, "--fils=2");
        }
    }

    private static float[] dessiner(Essai.Isole programme, Path dossier, String scene, String... options) throws IOException {
        List<String> args = new ArrayList<>(Arrays.asList(options));
        args.addAll(Arrays.asList("--taille=120x90", "--lineaire", dossier.resolve("i.pfm").toString(), scene));
        Essai essai = programme.executer(args.toArray(new String[0]));
        assertEquals(0, essai.code, essai.toString());
        return Essai.pfm(Files.readAllBytes(dossier.resolve("i.pfm")));
    }

    /** Rend l'image que les boucles du cours donnent de la scène : elle a changé, et c'est l'image par défaut. */
    private float[] verifierLImage(Essai.Isole programme, String fils) throws IOException {
        float[] simple = dessiner(programme, dossier, SCENE, "--simple", fils);
        assertArrayEquals(simple, dessiner(programme, dossier, SCENE, fils), "l'image par défaut n'est pas celle de --simple");
        assertFalse(Arrays.equals(avant, simple), "l'image n'a pas changé");
        return simple;
    }

    @ParameterizedTest(name = "{0} : {2}")
    @CsvSource(delimiter = '|', value = {
        "Objet3D | Couleur couleur = new Couleur(); | Couleur couleur = Kd.mul(0.1);",
        "Objet3D | && !scene.estCachee(lampe, contact, L, versLampe.norme(), this) | ",
        "Objet3D | Math.min(1, N.dot(L)) | 1",
        "Objet3D | V.add(-2 * V.dot(N), N) | V.add(-1.9 * V.dot(N), N)",
        "Objet3D | Rayon.reflechi(contact, R | Rayon.reflechi(contact.add(0.01, N), R",
        "Objet3D | Vecteur L = versLampe.normalized() | Vecteur L = versLampe.add(new Vecteur(1, 0, 0)).normalized()",
        "Objet3D | Vecteur L = versLampe.normalized() | Vecteur L = versLampe",
        "Objet3D | V.add(-2 * V.dot(N), N).normalized() | V.add(-2 * V.dot(N), N).mul(1.2)",
        "Sphere | double d = Intersection.distance( | double d = 1.01 * Intersection.distance(",
        "Sphere | return n.normalized() | return n.add(new Vecteur(0, 0.3, 0)).normalized()",
        "Sphere | Norme.ecart(carre, rayon) | Norme.ecart(carre, 1.01 * rayon)",
        "Rayon | P.add(distance, V) | P.add(0.99 * distance, V)",
        "Rayon | Couleur getSkyColor() { | Couleur getSkyColor() { if (V.y > 0.1) { return new Couleur(); }",
        "Rayon | Couleur getSkyColor() { | Couleur getSkyColor() { if (V.y < 0) { return new Couleur(); }",
        "Scene | .traverser(couleur, | .traverser(couleur.mul(0.5),",
        "Lancer | camera.getRayon(xe, ye) | camera.getRayon(xe + 0.3, ye)",
        "Camera | new Point(getX(xe), getY(ye), 0) | new Point(getX(xe), getY(ye), 0.1)",
        "Camera | new Vecteur(getOeil(), ecran) | new Vecteur(0, 0, 1)",
        "Camera | new Point(0, 0, -FOCALE) | new Point(0.5, 0.2, -FOCALE)",
        "Camera | new Point(0, 0, -FOCALE) | new Point(0.3, 0.2, -FOCALE - 0.5)",
        "Camera | double FOCALE = | double FOCALE = 0.6 *",
        "Camera | (hauteur / 2.0 - ye) * | (ye - hauteur / 2.0) *",
        "Vecteur | return new Vecteur(-x, -y, -z) | return new Vecteur(-x, y > 0.5 ? -1.2 * y : -y, -z)",
        "Objet3D | Vecteur L = versLampe.normalized() | Vecteur L = versLampe.normalized().mul(N.y > 0.8 ? 1.3 : 1)",
        "Rayon | return P; | return P.y > 1 ? P.add(new Vecteur(0, 0.1, 0)) : P;",
        "Vecteur | x * v.x + y * v.y + z * v.z | x * v.x + y * v.y + 0.9 * z * v.z",
        "Vecteur | new Vecteur(x + k * v.x, y + k * v.y, z + k * v.z) | new Vecteur(x + k * v.x, y + k * v.y, z)",
        "Vecteur | 1.5 - 0.5 * carre | 1.4 - 0.5 * carre",
        "Point | new Point(x + k * v.x, y + k * v.y, z + k * v.z) | new Point(x + k * v.x, y + k * v.y, z + 0.99 * k * v.z)",
        "Couleur | new Couleur(r * c.r, v * c.v, b * c.b) | new Couleur(r * c.r, v * c.v, 0)",
        "Couleur | v + c.v | v",
        "Objet3D | couleur = couleur.add(apport) | couleur = apport.add(couleur.mul(0.5))",
        "Objet3D | diffusion.mul(KL).mul(cosinus) | diffusion.mul(KL).mul(0.5 * cosinus)",
        "Objet3D | Ks.mul(KL).mul(eclat) | Ks.mul(KL).mul(0.5 * eclat)",
        "Lampe | return couleur; | return couleur.mul(0.5);",
        "Scene | Rayon.unitaire(lampe.getPosition(), L.neg()) | Rayon.unitaire(lampe.getPosition(), L)",
        "Rayon | return V; | return V.add(new Vecteur(0, 1e-10, 0));",
        "precision/Intersection | h2 >= 0 ? c / | h2 >= 0 ? 1.01 * c /",
        "Scene | if (d < distance | if (d < 0.8 * distance",
        "Scene | if (d < distance | if (d < Constantes.INFINI",
        "Scene | if (objet != saufLui) { | if (objet != saufLui && objet != objets.get(0)) {",
        "Scene | recherche.limiter(distance); | if (d > 9) { break; }",
        "Scene | (recherche.aEgalite(plusProche), distance) | (recherche.aEgalite(plusProche), 1.001 * distance)",
        "Scene | distance = d; | distance = d + 0.01;",
        "Scene | getIntersectionDistance(ombre) < distance | getIntersectionDistance(ombre) < 0.7 * distance",
        "Scene | if (objet != eclaire | if (objet != eclaire && objet != objets.get(1)",
        "Scene | if (objet != eclaire | if (objet == objets.get(0) && objet != eclaire"})
    void uneLigneChangeeDUneClasseDuCoursSeVoit(String classe, String ancienne, String nouvelle) throws IOException {
        try (Essai.Isole programme = Modification.de(dossier, classe, ancienne, nouvelle)) {
            float[] simple = verifierLImage(programme, "--fils=2");
            int contacts = 0;
            for (String pixel : new String[] {"60,55", "31,62", "88,49", "12,80"}) {
                Essai dit = programme.executer("--taille", "120x90", "--pixel", pixel, SCENE);
                assertEquals(0, dit.code, dit.toString());
                contacts += Sommes.de(dit.sortie).size();
                String[] mots = dit.sortie.substring(dit.sortie.lastIndexOf("somme ")).split(" ");
                String[] place = pixel.split(",");
                int debut = 3 * ((89 - Integer.parseInt(place[1])) * 120 + Integer.parseInt(place[0]));
                for (int c = 0; c < 3; c++) {
                    assertEquals(simple[debut + c], (float) Double.parseDouble(mots[1 + c]), dit.sortie);
                }
            }
            assertTrue(contacts > 0, contacts + " contacts dont les termes donnent la somme");
        }
    }

    /** Une barre sépare la classe, l'ancien texte et le nouveau ; des changements se suivent. */
    @ParameterizedTest
    @ValueSource(strings = {
        // une liste filtrée par les boucles, ou par la scène
        "Scene|if (objet != saufLui)|if (objets.indexOf(objet) < 5 && objet != saufLui)",
        "Scene|if (objet != eclaire|if (objets.indexOf(objet) >= 3 && objet != eclaire",
        "Scene|return objets;|return objets.subList(0, 6);",
        // une question posée au milieu d'une autre
        "Scene|private final Compteurs compteurs|boolean dedans; private final Compteurs compteurs|Scene|if (objet != saufLui) {|if (!dedans) { "
                + "dedans = true; getClosestIntersection(new Rayon(incident.getP(), incident.getV()), saufLui); dedans = false; } "
                + "if (objet != saufLui && objet != objets.get(3)) {",
        // une forme qui rend sa distance sans la noter
        "Sphere|incident.setContact(this, d);|d = 1.05 * d;",
        // des sphères qui bougent : avant le dessin, ou d'une ligne à l'autre
        MOBILE + "Lancer|Lancer lancer = new|placer(scene, 1); Lancer lancer = new",
        MOBILE + "Lancer|Rayon initial =|placer(scene, ye / 100); Rayon initial =",
        // un objet qui n'a pas d'ombre, une ombre qui dépend de la distance, un objet qui se cache lui-même
        "Scene|if (objet != eclaire|if (objet.getKs().r < 0.2 && objet != eclaire",
        "Scene|getIntersectionDistance(ombre) < distance|getIntersectionDistance(ombre) < Math.min(distance, 9)",
        "Scene|if (objet != eclaire && |if ("})
    void unAjoutSeVoit(String changements) throws IOException {
        try (Essai.Isole programme = Modification.de(dossier, changements.split("\\|"))) {
            // à deux fils, une sphère qui bouge ne donnerait pas deux fois la même image
            verifierLImage(programme, "--fils=1");
        }
    }

    /** Au-delà de quinze objets, un regard avant le dessin compare la recherche aux réponses de tous les objets. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "Scene | return objets; | return objets.subList(0, objets.size() - 1);",
        "Sphere | centre.z, rayon); | centre.z, 2 * rayon);",
        "Sphere | setContact(this, d) | setContact(this, d = d - 1)",
        "Scene | if (d < distance | if (d < 0.8 * distance",
        "Objet3D | diffusion.mul(KL).mul(cosinus) | diffusion.mul(KL)"})
    void dansUneFouleAussiCeSontLesBouclesQuiDessinent(String classe, String ancienne, String nouvelle) throws IOException {
        try (Essai.Isole change = Modification.de(dossier, classe, ancienne, nouvelle)) {
            for (String scene : new String[] {"scenes/tournesol.ini", "scenes/diffus.ini"}) {
                assertArrayEquals(dessiner(change, dossier, scene, "--simple"), dessiner(change, dossier, scene), scene);
            }
        }
    }

    @Test
    void comparerDitAussiQueLesBouclesDessinent() throws IOException {
        try (Essai.Isole change = Modification.de(dossier, "Sphere", "setContact(this, d)", "setContact(this, d = d - 1)")) {
            String image = dossier.resolve("i.png").toString();
            assertEquals(0, change.executer("--simple", "--taille=200x150", "--image", image, "scenes/diffus.ini").code);
            Essai essai = change.executer("--comparer", image, "scenes/diffus.ini");
            assertEquals(0, essai.code, essai.toString());
            assertTrue(essai.erreur.contains("ce sont les boucles sur tous les objets qui dessinent"), essai.toString());
        }
    }
}
