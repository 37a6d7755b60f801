package lancer.rapide;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lancer.essai.Essai;
import lancer.essai.Modification;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Ce que l'on ajoute aux classes du cours : du verre, un champ de la scène, une liste filtrée, des sphères qui bougent. L'image
 * par défaut est celle de toutes les réponses, parce que les boucles du cours dessinent, ou parce que le regard l'a vu.
 */
class AjoutsTest {

    private static final String[] SCENES = {"scene1", "bowling", "ombres", "miroirs", "diffus"};

    private static final String[] VERRE = {
        "Objet3D", "private double ns = 1;", "private double ns = 1; private Couleur Kt = new Couleur(); "
                + "public Couleur getKt() { return Kt; } public void setKt(Couleur Kt) { this.Kt = Kt; }",
        "scene/LecteurSections", "Arrays.asList(\"Kd\"", "Arrays.asList(\"Kt\", \"Kd\"",
        "scene/LecteurSections", "lu.setKd(", "lu.setKt(section.couleur(\"Kt\", lu.getKt(), 1)); lu.setKd(",
        "Scene", "objets[k] != objet && demander", "objets[k] != objet && objets[k].getKt().estNoire() && demander"};

    private static final String CHAMP = "Scene|final Lampe[] lampes;|final Lampe[] lampes; Objet3D absent;"
            + "|Scene|objets[k] != saufLui|objets[k] != saufLui && objets[k] != absent|";

    private static final String MOBILE = "Sphere|private final Point centre|public Point centre"
            + "|Sphere|private final double rayon|public double rayon"
            + "|Lancer|private Compteurs compteurs|static void placer(Scene scene, double x) { "
            + "Sphere s = (Sphere) scene.getObjets().get(2); s.centre = new Point(x, s.centre.y, s.centre.z); } "
            + "private Compteurs compteurs|";

    @TempDir
    Path dossier;

    private int changeantes;
    private final List<String> pasVues = new ArrayList<>();

    private static final String TAILLE = System.getProperty("tests.longs") != null ? "200x150" : "80x60";

    private static float[] dessiner(Essai.Isole programme, Path dossier, Path scene, String... options) throws IOException {
        List<String> args = new ArrayList<>(Arrays.asList("--taille=" + TAILLE, "--fils=1",
                "--lineaire", dossier.resolve("i.pfm").toString(), scene.toString()));
        args.addAll(Arrays.asList(options));
        Essai essai = programme.executer(args.toArray(new String[0]));
        assertEquals(0, essai.code, essai.toString());
        return Essai.pfm(Files.readAllBytes(dossier.resolve("i.pfm")));
    }

    /** Un cas compte s'il change plus d'un pixel sur mille, par les boucles ou par la recherche. */
    private void essayer(String nom, Essai.Isole programme, float[] avant, Path scene) throws IOException {
        float[] simple = dessiner(programme, dossier, scene, "--simple");
        int faux = differents(simple, dessiner(programme, dossier, scene));
        if (Math.max(faux, differents(avant, simple)) * 1000 > simple.length / 3) {
            changeantes++;
            if (faux > 0) {
                pasVues.add(nom + " : " + faux + " sur " + differents(avant, simple));
            }
        }
    }

    private static int differents(float[] a, float[] b) {
        int n = 0;
        for (int k = 0; k < a.length; k += 3) {
            n += a[k] != b[k] || a[k + 1] != b[k + 1] || a[k + 2] != b[k + 2] ? 1 : 0;
        }
        return n;
    }

    @Tag("long")
    @Test
    void leVerreDeChaqueBouleDeCinqScenesSeVoitDansNeufCasSurDix() throws IOException {
        try (Essai.Isole verre = Modification.de(dossier, VERRE)) {
            for (String nom : SCENES) {
                String texte = new String(Files.readAllBytes(Paths.get("scenes", nom + ".ini")), StandardCharsets.UTF_8);
                float[] avant = dessiner(verre, dossier, Paths.get("scenes", nom + ".ini"), "--simple");
                Matcher boule = Pattern.compile("(?m)^\\[Sphere.*\n").matcher(texte);
                while (boule.find()) {
                    Path scene = Files.write(dossier.resolve(nom + ".ini"), (texte.substring(0, boule.end()) + "Kt=1 1 1\n"
                            + texte.substring(boule.end())).getBytes(StandardCharsets.UTF_8));
                    essayer(nom + " " + boule.group().trim(), verre, avant, scene);
                }
            }
        }
        assertTrue(changeantes >= 20 && pasVues.size() * 20 <= changeantes, changeantes + " cas, dont " + pasVues);
    }

    /** Une barre sépare la classe, l'ancien texte et le nouveau ; des changements se suivent. */
    @Tag("long")
    @ParameterizedTest
    @ValueSource(strings = {
        // un champ de la scène, copié de fil en fil, ou donné à la scène de chaque fil
        CHAMP + "Lancer|this.scene = scene;|this.scene = scene; scene.absent = scene.getObjets().get(1);"
                + "|Scene|lampes = autre.lampes;|lampes = autre.lampes; absent = autre.absent;",
        CHAMP + "Lancer|scene = autre.scene.avec(autre.scene.getModele());|scene = autre.scene.avec(autre.scene.getModele()); "
                + "scene.absent = scene.getObjets().get(1);",
        "Scene|private final Modele|public double jusqua = 7; private final Modele"
                + "|Scene|if (d < distance |if (d < Math.min(jusqua, distance) ",
        // une liste filtrée : par la scène, ou par ses seules boucles
        "Scene|return Collections.unmodifiableList(Arrays.asList(objets));"
                + "|List<Objet3D> l = new java.util.ArrayList<>(Arrays.asList(objets)); l.remove(2); return l;",
        "Scene|if (objets[k] != saufLui)|if (k < 5 && objets[k] != saufLui)",
        "Scene|if (objets[k] != objet|if (k >= 3 && objets[k] != objet",
        "Scene|return Collections.unmodifiableList(Arrays.asList(objets));|return Arrays.asList(objets).subList(0, 6);"
                + "|Scene|if (objets[k] != saufLui|if (k < 6 && objets[k] != saufLui"
                + "|Scene|if (objets[k] != objet|if (k < 6 && objets[k] != objet",
        // des sphères qui bougent : avant le dessin, pendant, ou d'une ligne à l'autre
        MOBILE + "Lancer|Echantillonnage prepare =|"
                + "placer(scene, ((Sphere) scene.getObjets().get(2)).centre.x + 0.5); Echantillonnage prepare =",
        MOBILE + "Lancer|if (brouillon) {|placer(scene, pave.i0 < 64 ? 1 : 0); if (brouillon) {",
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
        Path scene = Paths.get("scenes/scene1.ini");
        float[] avant;
        try (Essai.Isole tel = new Essai.Isole(Collections.<Path>emptyList())) {
            avant = dessiner(tel, dossier, scene, "--simple");
        }
        try (Essai.Isole change = Modification.de(dossier, changements.split("\\|"))) {
            essayer(changements, change, avant, scene);
        }
        assertEquals(0, pasVues.size(), pasVues.toString());
    }

    /** Aucun rayon du sondage ne rencontre la dernière boule, mais les boucles l'interrogent. */
    @Test
    void uneListeSansLaDerniereDeMilleBoulesSeVoit() throws IOException {
        try (Essai.Isole change = Modification.de(dossier, "Scene", "return Collections.unmodifiableList(Arrays.asList(objets));",
                "return Arrays.asList(objets).subList(0, objets.length - 1);")) {
            Path scene = Paths.get("scenes/tournesol.ini");
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
