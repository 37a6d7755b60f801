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
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import lancer.essai.Essai;
import lancer.essai.Modification;
import lancer.essai.Sommes;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
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
    private static final boolean LONGS = System.getProperty("tests.longs") != null;

    private static final String CHAMP = "Scene|final Lampe[] lampes;|final Lampe[] lampes; Objet3D absent;"
            + "|Scene|objets[k] != saufLui|objets[k] != saufLui && objets[k] != absent|";

    private static final String MOBILE = "Sphere|private final Point centre|public Point centre"
            + "|Sphere|private final double rayon|public double rayon"
            + "|Lancer|private Compteurs compteurs|static void placer(Scene scene, double x) { "
            + "Sphere s = (Sphere) scene.getObjets().get(2); s.centre = new Point(x, s.centre.y, s.centre.z); } "
            + "private Compteurs compteurs|";

    private static final String[] VERRE = {
        "Objet3D", "private double ns = 1;", "private double ns = 1; private Couleur Kt = new Couleur(); "
                + "public Couleur getKt() { return Kt; } public void setKt(Couleur Kt) { this.Kt = Kt; }",
        "scene/LecteurSections", "Arrays.asList(\"Kd\"", "Arrays.asList(\"Kt\", \"Kd\"",
        "scene/LecteurSections", "lu.setKd(", "lu.setKt(section.couleur(\"Kt\", lu.getKt(), 1)); lu.setKd(",
        "Scene", "objets[k] != objet && demander", "objets[k] != objet && objets[k].getKt().estNoire() && demander"};

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
        "Objet3D | new Lumiere(scene.getModele(), N, R); | new Lumiere(scene.getModele(), N, R); lumiere.ajouter(Kd.mul(0.1));",
        "Objet3D | && !scene.estCachee(lampe, contact, L, versLampe.norme(), this) | ",
        "Objet3D | Math.min(1, N.dot(L)) | 1",
        "Objet3D | V.add(-2 * V.dot(N), N) | V.add(-1.9 * V.dot(N), N)",
        "Objet3D | new Rayon(contact, R, produitKs) | new Rayon(contact.add(0.01, N), R, produitKs)",
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
        "Lumiere | r += c.r | r += 0.5 * c.r",
        "Lumiere | Kd.mul(KL).mul(cosinus) | Kd.mul(KL).mul(0.5 * cosinus)",
        "Lumiere | Ks.mul(KL).mul(eclat) | Ks.mul(KL).mul(0.5 * eclat)",
        "Lampe | return couleur; | return couleur.mul(0.5);",
        "Scene | lampe.getPosition(), L.neg(), distance, objet | lampe.getPosition(), L, distance, objet",
        "Rayon | return V; | return V.add(new Vecteur(0, 1e-10, 0));",
        "precision/Intersection | h2 >= 0 ? c / | h2 >= 0 ? 1.01 * c /",
        "Scene | if (d < distance | if (d < 0.8 * distance",
        "Scene | if (d < distance | if (d < Constantes.INFINI",
        "Scene | if (objets[k] != saufLui) { | if (objets[k] != saufLui && k != 0) {",
        "Scene | objets[plusProche], distance) | objets[plusProche], 1.001 * distance)",
        "Scene | distance = d; | distance = d + 0.01;",
        "Scene | demander(objets[k], ombre) < distance | demander(objets[k], ombre) < 0.7 * distance",
        "Scene | objets[k] != objet && demander | objets[k] != objet && k != 1 && demander",
        "Scene | if (objets[k] != objet | if (k == 0 && objets[k] != objet"})
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
        // un champ de la scène, copié de fil en fil, ou donné à la scène de chaque fil
        CHAMP + "Lancer|this.scene = scene;|this.scene = scene; scene.absent = scene.getObjets().get(1);"
                + "|Scene|lampes = autre.lampes;|lampes = autre.lampes; absent = autre.absent;",
        CHAMP + "Lancer|scene = autre.scene.avec(autre.scene.getModele());|scene = autre.scene.avec(autre.scene.getModele()); "
                + "scene.absent = scene.getObjets().get(1);",
        "Scene|private final Modele|public double jusqua = 7; private final Modele"
                + "|Scene|if (d < distance |if (d < Math.min(jusqua, distance) ",
        // une liste filtrée par les boucles, ou par elles et par la scène
        "Scene|if (objets[k] != saufLui)|if (k < 5 && objets[k] != saufLui)",
        "Scene|if (objets[k] != objet|if (k >= 3 && objets[k] != objet",
        "Scene|return Collections.unmodifiableList(Arrays.asList(objets));|return Arrays.asList(objets).subList(0, 6);"
                + "|Scene|if (objets[k] != saufLui|if (k < 6 && objets[k] != saufLui"
                + "|Scene|if (objets[k] != objet|if (k < 6 && objets[k] != objet",
        // des sphères qui bougent : avant le dessin, pendant, ou d'une ligne à l'autre
        MOBILE + "Lancer|Echantillonnage prepare =|"
                + "placer(scene, ((Sphere) scene.getObjets().get(2)).centre.x + 0.5); Echantillonnage prepare =",
        MOBILE + "Lancer|TracerPixels(pave, pave,|placer(scene, pave.i0 < 64 ? 1 : 0); TracerPixels(pave, pave,",
        MOBILE + "Lancer|Rayon initial =|placer(scene, ye / 100); Rayon initial ="
                + "|Lancer|equipe.obeir();|placer(scene, 1); equipe.obeir();",
        MOBILE + "Lancer|equipe.faire(paves.size(),|((Sphere) scene.getObjets().get(1)).rayon = 2; equipe.faire(paves.size(),",
        // une lampe qui bouge, un objet qui n'a pas d'ombre, une ombre qui dépend de la distance
        "Lampe|private final Point position|public Point position|Lancer|equipe.faire(paves.size(),|scene.lampes[0].position "
                + "= scene.lampes[0].position.add(new Vecteur(3, 0, 0)); equipe.faire(paves.size(),",
        "Scene|objets[k] != objet && demander|objets[k] != objet && objets[k].getKs().r < 0.2 && demander",
        "Scene|demander(objets[k], ombre) < distance|demander(objets[k], ombre) < Math.min(distance, 9)",
        "Scene|objets[k] != objet && demander|demander"})
    void unAjoutSeVoit(String changements) throws IOException {
        try (Essai.Isole programme = Modification.de(dossier, changements.split("\\|"))) {
            // à deux fils, une sphère qui bouge ne donnerait pas deux fois la même image
            verifierLImage(programme, "--fils=1");
        }
    }

    @Tag("long")
    @Test
    void leVerreDeChaqueBouleSeVoitDansNeufCasSurDix() throws IOException {
        int changeantes = 0;
        List<String> pasVues = new ArrayList<>();
        try (Essai.Isole verre = Modification.de(dossier, VERRE)) {
            for (String nom : (LONGS ? "scene1 bowling ombres miroirs diffus" : "scene1 bowling").split(" ")) {
                String texte = Essai.texte("scenes/" + nom + ".ini");
                float[] opaque = dessiner(verre, dossier, "scenes/" + nom + ".ini", "--simple");
                Matcher boule = Pattern.compile("(?m)^\\[Sphere.*\n").matcher(texte);
                while (boule.find()) {
                    Path scene = Essai.scene(dossier.resolve(nom + ".ini"), texte.substring(0, boule.end()) + "Kt=1 1 1\n"
                            + texte.substring(boule.end()));
                    float[] simple = dessiner(verre, dossier, scene.toString(), "--simple");
                    int faux = differents(simple, dessiner(verre, dossier, scene.toString()));
                    // un cas compte s'il change plus d'un pixel sur mille, par les boucles ou par la recherche
                    if (Math.max(faux, differents(opaque, simple)) * 1000 > simple.length / 3) {
                        changeantes++;
                        if (faux > 0) {
                            pasVues.add(nom + " " + boule.group().trim() + " : " + faux);
                        }
                    }
                }
            }
        }
        assertTrue(changeantes >= (LONGS ? 20 : 8) && pasVues.size() * 10 <= changeantes, changeantes + " cas, dont " + pasVues);
    }

    private static int differents(float[] a, float[] b) {
        return (int) IntStream.range(0, a.length / 3).filter(k -> a[3 * k] != b[3 * k] || a[3 * k + 1] != b[3 * k + 1]
                || a[3 * k + 2] != b[3 * k + 2]).count();
    }

    /** Aucun rayon du sondage ne rencontre la dernière boule, mais les boucles l'interrogent. */
    @Test
    void uneListeSansLaDerniereDeMilleBoulesSeVoit() throws IOException {
        try (Essai.Isole change = Modification.de(dossier, "Scene", "return Collections.unmodifiableList(Arrays.asList(objets));",
                "return Arrays.asList(objets).subList(0, objets.length - 1);")) {
            String scene = "scenes/tournesol.ini";
            assertArrayEquals(dessiner(change, dossier, scene, "--simple"), dessiner(change, dossier, scene));
        }
    }

    @Test
    void comparerDitAussiQueLesBouclesDessinent() throws IOException {
        try (Essai.Isole change = Modification.de(dossier, "Sphere", "setContact(this, d)", "setContact(this, d = d - 1)")) {
            String image = dossier.resolve("i.png").toString();
            assertEquals(0, change.executer("--simple", "--taille=200x150", "--image", image, "scenes/scene1.ini").code);
            Essai essai = change.executer("--comparer", image, "scenes/scene1.ini");
            assertEquals(0, essai.code, essai.toString());
            assertTrue(essai.erreur.contains("ce sont les boucles sur tous les objets qui dessinent"), essai.toString());
        }
    }
}
