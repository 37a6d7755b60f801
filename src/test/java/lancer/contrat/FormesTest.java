package lancer.contrat;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import lancer.Main;
import lancer.Point;
import lancer.Rayon;
import lancer.Vecteur;
import lancer.essai.Essai;
import lancer.essai.Ressources;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Une forme d'étudiant, le plan de docs/etendre.md, se voit, s'éclaire, se reflète et porte ombre comme une boule ; ce qui ne va pas
 * dans sa classe, sa section ou sa ligne de services se dit en une ligne. Il s'appelle ici {@code Panneau}, pour que ces tests restent
 * vrais là où quelqu'un a copié la page dans la base.
 */
class FormesTest {

    static final String SERVICE = "META-INF/services/lancer.contrat.Forme";

    static final String MUR = "[Panneau mur]\npoint=7 8 5\nnormale=0 0 -3\n";

    @TempDir
    static Path commun;
    static List<String> blocs;
    static String panneau;
    static Path classesDuPanneau;

    @TempDir
    Path dossier;
    Path scene;

    @BeforeAll
    static void copierLaPage() throws IOException {
        String section = Essai.texte("docs/etendre.md").split("\n## Une forme à soi\n")[1].split("\n## ")[0];
        blocs = new ArrayList<>();
        for (String paragraphe : section.split("\n(?=[^ \n])")) {
            int bloc = paragraphe.indexOf("\n    ");
            if (bloc >= 0) {
                blocs.add(paragraphe.substring(bloc + 1).replaceAll("(?m)^    ", ""));
            }
        }
        assertTrue(section.contains("`src/main/java/lancer/Plan.java`") && section.contains("> src/main/resources/" + SERVICE + "\n"));
        panneau = blocs.get(0).replace("Plan", "Panneau").replace("plan", "panneau");
        classesDuPanneau = Files.createDirectory(commun.resolve("panneau"));
        inscrire(classesDuPanneau, SERVICE, panneau);
    }

    @BeforeEach
    void nommerLaScene() throws IOException {
        dossier = dossier.toRealPath();
        scene = dossier.resolve("s.ini");
    }

    /** Compile ces classes dans le dossier, et les inscrit chacune sur une ligne de ce fichier de services. */
    static void inscrire(Path classes, String service, String... sources) throws IOException {
        JavaCompiler javac = ToolProvider.getSystemJavaCompiler();
        List<String> noms = new ArrayList<>();
        for (String source : sources) {
            String nom = source.replaceAll("(?s).*?public (?:final )?class (\\w+).*", "$1");
            noms.add(source.replaceAll("(?s).*?package (\\w+);.*", "$1") + "." + nom);
            Path fichier = Files.createDirectories(classes.resolve("sources")).resolve(nom + ".java");
            Files.writeString(fichier, source);
            assertEquals(0, javac.run(null, null, null, "-encoding", "UTF-8", "-Xlint:all", "-Werror", "-d", classes.toString(),
                    "-cp", Essai.origine(Main.class) + File.pathSeparator + classes, fichier.toString()), source);
        }
        Files.createDirectories(classes.resolve(service).getParent());
        Files.write(classes.resolve(service), noms, StandardCharsets.UTF_8);
    }

    Path inscrire(String service, String... sources) throws IOException {
        Path classes = Files.createDirectory(dossier.resolve("classes"));
        inscrire(classes, service, sources);
        return classes;
    }

    private float[] dessiner(String taille, String... lignes) throws IOException {
        return Essai.dessinerAvec(List.of(classesDuPanneau), dossier, Essai.scene(scene, lignes), "--taille", taille);
    }

    @Test
    void laClasseLaLigneEtLaSceneDuReadmeSeCopientTellesQuelles() throws IOException {
        inscrire(dossier, SERVICE, blocs.get(0));
        assertTrue(blocs.get(1).contains("\necho " + Files.readString(dossier.resolve(SERVICE)).trim() + " >> "), blocs.get(1));
        float[] image = Essai.dessinerAvec(List.of(dossier), dossier, Essai.scene(scene, blocs.get(2)), "--taille=4x2");
        // en haut le ciel ; en bas, sans lampe, un cinquième de ce ciel, que le sol reflète
        assertEquals(image[12] * 0.2, image[0], 1e-7);
    }

    @Test
    void leDamierDeLaPageADeuxCouleursDontLesTermesSAjoutent() throws IOException {
        inscrire(dossier, SERVICE, blocs.get(0).replaceFirst("\n}\n", "\n\n" + bloc("getKd(Point contact)") + "}\n"));
        String sol = "[Plan]\npoint=0 -1 0\nnormale=0 1 0\nKd=0.9 0.9 0.9\n[Lampe 1]\nposition=0 9 3\ncouleur=1 1 1";
        float[] image = Essai.dessinerAvec(List.of(dossier), dossier, Essai.scene(scene, sol), "--taille", "8x6");
        // la première rangée d'un PFM est celle du bas : le sol, où deux cases voisines sont de Kd 0.9 et 0.1
        double[] rangee = IntStream.range(0, 8).mapToDouble(x -> image[3 * x]).sorted().toArray();
        assertTrue(rangee[7] > 0.5 && rangee[0] > 0 && rangee[0] < 0.1, Arrays.toString(rangee));
        try (Essai.Isole isole = new Essai.Isole(List.of(dossier))) {
            String recit = isole.executer("--taille=8x6", "--pixel=0,5", scene.toString()).toString();
            assertTrue(recit.startsWith("statut 0") && recit.contains("somme ") && !recit.contains("que le récit ne connaît pas"), recit);
        }
    }

    private static String bloc(String contient) {
        return blocs.stream().filter(bloc -> bloc.contains(contient)).findFirst().get();
    }

    // ce que voit le rayon du milieu, qui part de (0, 0, 0) vers les z croissants

    private static final String BLANC = "Kd=1 1 1";
    /** Vue de (0, 0, 5) : 3 de côté, 4 en arrière. */
    private static final String LAMPE = "[Lampe 1]\nposition=3 0 1\ncouleur=1 1 1";

    private void verifierVue(double attendu, String... lignes) throws IOException {
        assertEquals(attendu, dessiner("1x1", lignes)[0], 1e-7);
    }

    @Test
    void elleEstVueEtEclaireeSelonSaMatiere() throws IOException {
        verifierVue(0.8, MUR, BLANC, LAMPE);
        verifierVue(0.2, MUR, "Kd=0.25 0 0", LAMPE);
        // le reflet de la lampe, et celui du ciel à l'horizon
        double ciel = new Rayon(new Point(), new Vecteur(0, 0, -1)).getSkyColor().r;
        verifierVue(1 + ciel, MUR, "Kr=1 1 1", "ns=0", LAMPE);
        verifierVue(0, MUR, LAMPE);
    }

    @Test
    void laPlusProcheCacheLesAutres() throws IOException {
        verifierVue(0.8, "[Sphere 1]", "centre=0 0 8", "rayon=1", MUR, BLANC, LAMPE);
        verifierVue(0.8, MUR, BLANC, LAMPE, "[Sphere 1]", "centre=0 0 8", "rayon=1");
        verifierVue(0, "[Sphere 1]", "centre=0 0 3", "rayon=1", MUR, BLANC, LAMPE);
        verifierVue(0, MUR, BLANC, LAMPE, "[Sphere 1]", "centre=0 0 3", "rayon=1");
        // au même endroit, la première du fichier
        verifierVue(0, MUR, "[panneau noir]", "point=0 0 5", "normale=0 0 -1", "[PANNEAU]", "point=0 0 5", "normale=0 0 -1", BLANC, LAMPE);
    }

    @Test
    void elleRecoitDesOmbresEtEnPorte() throws IOException {
        verifierVue(0, MUR, BLANC, LAMPE, "[Sphere 1]", "centre=1.5 0 3", "rayon=0.3");
        String[] boule = {"[Sphere 1]", "centre=0 0 5", "rayon=1", BLANC, LAMPE, ""};
        verifierVue(Math.sqrt(0.5), boule);
        boule[5] = "[Panneau]\npoint=2 0 0\nnormale=1 0 0";
        verifierVue(0, boule);
    }

    @Test
    void uneBouleLaReflete() throws IOException {
        verifierVue(0.8, "[Sphere miroir]", "centre=0 0 5", "rayon=1", "Ks=1 1 1", "ns=1e9",
                "[Panneau derrière l'œil]", "point=0 0 -3", "normale=0 0 1", BLANC, LAMPE);
    }

    @Test
    void chaqueQuestionQuOnLuiPoseEstComptee() throws IOException {
        Path fichier = Essai.scene(scene, MUR, BLANC, "[Panneau sol]", "point=0 -1 0", "normale=0 1 0", LAMPE);
        for (String option : new String[] {"--simple", "--fils=2"}) {
            Essai e = Essai.executerAvec(List.of(classesDuPanneau), "--statistiques", option,
                    "--taille=1x1", "--lineaire", dossier.resolve("image.pfm").toString(), fichier.toString());
            assertEquals(1, e.statistique("rayons.ombre"), e.toString());
            // les deux par le rayon de l'écran, le sol par celui de la lampe
            assertEquals(3, e.statistique("tests.spheres"), e.toString());
        }
    }

    @Test
    void unVecteurTresCourtOuTresLongDonneUneDirection() throws IOException {
        for (String z : new String[] {"-1e-300", "-4.9e-324", "-1e100"}) {
            verifierVue(0.8, "[Panneau]", "point=0 0 5", "normale=0 0 " + z, BLANC, LAMPE);
        }
    }

    @Test
    void uneCouleurDonneeParLaFormeVautLaOuLaSectionNEnDitRien() throws IOException {
        Path classes = inscrire(SERVICE, panneau.replace("return panneau;", "panneau.setKd(new Couleur(0.5)); return panneau;"));
        List<Path> chemin = List.of(classes);
        assertEquals(0.4, Essai.dessinerAvec(chemin, dossier, Essai.scene(scene, MUR, LAMPE), "--taille=1x1")[0], 1e-7);
        assertEquals(0.8, Essai.dessinerAvec(chemin, dossier, Essai.scene(scene, MUR, BLANC, LAMPE), "--taille=1x1")[0], 1e-7);
    }

    // ce qui est refusé

    /** Une boule que lit une autre classe que celle de la base, sous un nom aussi long que {@code Sphere}. */
    private static final String BALLON = String.join("\n",
            "package exo;",
            "public class Ballon implements lancer.contrat.Forme {",
            "    public String getSection() { return \"Ballon\"; }",
            "    public String[] getCles() { return new String[] {\"centre\", \"rayon\"}; }",
            "    public lancer.Objet3D lire(lancer.contrat.Section valeurs) {",
            "        return new lancer.Sphere(valeurs.point(\"centre\"), valeurs.longueur(\"rayon\"));",
            "    }",
            "}");

    private Essai executer(Path classes, String... lignes) throws IOException {
        return Essai.executerAvec(List.of(classes), "--lineaire", dossier.resolve("image.pfm").toString(), "--taille=1x1",
                Essai.scene(scene, lignes).toString());
    }

    private void refuser(String message, Essai essai) {
        assertEquals("lancer : " + message + System.lineSeparator(), essai.sansAutresFormes("Panneau"));
        assertEquals(2, essai.code);
        assertTrue(!Files.exists(dossier.resolve("image.pfm")), "une image est restée");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "point=0 0 0~normal=0 1 0 | ligne 3, [Panneau sol], normal : clé inconnue ; attendu : point, normale, {matière}",
        "point=0 0 0~normale=0 un 0 | ligne 3, [Panneau sol], normale : n'est pas un nombre : « un » ; attendu : 3 nombres séparés par des "
                + "blancs, chacun de -1e100 à 1e100",
        "point=0 0 0~normale=0 1e101 0 | ligne 3, [Panneau sol], normale : hors limites : « 1e101 » ; attendu : 3 nombres séparés par des "
                + "blancs, chacun de -1e100 à 1e100",
        "point=0 0 0~NORMALE=0 -0 0e5 | ligne 3, [Panneau sol], normale : vecteur nul : « 0 -0 0e5 » ; attendu : trois nombres "
                + "qui ne sont pas tous nuls",
        "point=0 0 0~normale=0 1 0~[Cube] | ligne 4, [Cube] : type de section inconnu ; attendu : "
                + "Sphere, Lampe, Camera, Brume, Antialias, Blinn, Panneau"})
    void uneSectionFautiveEstRefuseeEnUneLigne(String lignes, String message) throws IOException {
        refuser(Essai.message("{fichier}, " + message, scene), executer(classesDuPanneau, ("[Panneau sol]~" + lignes).split("~")));
    }

    @Test
    void toutMessageEstCeluiDUneSphere() throws IOException {
        Path fautives = Path.of(Ressources.chemin("fautives"));
        Path pfm = dossier.resolve("image.pfm");
        int refusees = 0;
        try (Essai.Isole programme = new Essai.Isole(List.of(inscrire(SERVICE, BALLON)))) {
            for (Path fichier : Ressources.scenes(fautives)) {
                String octets = new String(Files.readAllBytes(fichier), StandardCharsets.ISO_8859_1);
                Files.write(scene, octets.replaceAll("\\[(?i:sphere)", "[Ballon").getBytes(StandardCharsets.ISO_8859_1));
                String message = Files.readString(fichier.resolveSibling(fichier.getFileName().toString().replace(".ini", ".message")));
                Essai e = programme.executer("--taille=1x1", "--lineaire", pfm.toString(), scene.toString());
                assertEquals(Essai.message(message, scene).replaceAll("\\[(?i:sphere)", "[Sphere"),
                        e.sansAutresFormes("aucune").replace("[Ballon", "[Sphere"), fichier.toString());
                assertEquals(2, e.code);
                refusees += octets.contains("[Sphere") ? 1 : 0;
            }
        }
        assertTrue(refusees > 100, refusees + " seulement");
    }

    /** Le plan de docs/etendre.md, sous un autre nom de classe ou de section. */
    private static String panneau(String classe, String section) {
        return panneau.replace("class Panneau", "class " + classe)
                .replace("Panneau panneau = new Panneau()", classe + " panneau = new " + classe + "()")
                .replace("\"Panneau\"", section);
    }

    @ParameterizedTest
    @CsvSource({"Boule, Sphere, lancer.Sphere", "Spot, lampe, lancer.Lampe"})
    void unTypeDejaPrisEstRefuseEnNommantLesDeux(String classe, String section, String preneur) throws IOException {
        Path classes = inscrire(SERVICE, panneau(classe, '"' + section + '"'));
        refuser("deux classes veulent les sections [" + section + "] : " + preneur + " et lancer." + classe + " ; attendu : un type de "
                + "section pour chacune", executer(classes, "[Sphere 1]", "centre=0 0 6", "rayon=1"));
    }

    @Test
    void deuxFormesOuUneFormeEtUneVarianteNePrennentPasLeMemeType() throws IOException {
        Path classes = inscrire(SERVICE, panneau, panneau("Sol", "\"panneau\""));
        String message = "deux classes veulent les sections [panneau] : %s et lancer.Sol ; attendu : un type de section pour chacune";
        refuser(String.format(message, "lancer.Panneau"), executer(classes, MUR));
        inscrire(classes, SERVICE, panneau("Sol", "\"panneau\""));
        inscrire(classes, SERVICE.replace("Forme", "Variante"), String.join("\n",
                "package exo;",
                "public class Autre implements lancer.contrat.Variante {",
                "    public String getSection() { return \"Panneau\"; }",
                "    public void installer(lancer.contrat.Section valeurs, lancer.contrat.Modele.Construction modele) { }",
                "}"));
        refuser(String.format(message, "exo.Autre"), executer(classes, "[Lampe 1]", "position=3 0 1", "couleur=1 1 1"));
    }

    @ParameterizedTest
    @CsvSource({"return panneau;, return null;, IllegalStateException: lire n'a pas rendu un objet neuf",
        "return panneau;, return this;, IllegalStateException: lire n'a pas rendu un objet neuf",
        "valeurs.point(\"point\"), valeurs.point(\"depart\"), IllegalStateException: getCles ne nomme pas la clé depart",
        "return panneau;, throw new IllegalArgumentException(\"un panneau\\npenché\");, IllegalArgumentException: un panneau\\npenché"})
    void uneFormeQuiEchoueEstNommeeAvecLaSection(String bonne, String fautive, String dit) throws IOException {
        assertTrue(panneau.contains(bonne));
        Path classes = inscrire(SERVICE, panneau.replace(bonne, fautive));
        Essai e = executer(classes, MUR);
        String ou = e.erreur.replaceAll(" \\(lancer\\.(Panneau|scene\\.LecteurSections)\\.lire, \\w+\\.java:\\d+\\)", "");
        assertEquals(!fautive.startsWith("return"), e.erreur.contains("(lancer.Panneau.lire, Panneau.java:"),
                "la ligne de lire qui échoue : " + e);
        assertEquals("lancer : " + scene + ", ligne 1, [Panneau mur] : section que lancer.Panneau ne sait pas lire : java.lang."
                + dit + " ; attendu : des valeurs qui lui conviennent" + System.lineSeparator(), ou);
        assertEquals(2, e.code);
    }

    @ParameterizedTest
    @CsvSource({"lancer.Sphere, lancer.Sphere, 'une classe publique de ce contrat, à constructeur public sans argument, '",
        "lancer.Objet3D, lancer.Objet3D, une classe publique de ce contrat", "pas un nom, lancer.contrat.Forme:1, une classe publique",
        "lancer.Pnaneau, lancer\\.Pnaneau, .* make propre$"})
    void uneLigneDeServicesQuiNeConvientPasOuDontLaClasseNExistePasEstRefusee(String ligne, String dit, String attendu) throws IOException {
        Path services = Files.createDirectories(dossier.resolve(SERVICE).getParent());
        Files.write(services.resolve("lancer.contrat.Forme"), List.of(ligne));
        Essai e = executer(dossier, "[Sphere 1]", "centre=0 0 6", "rayon=1");
        assertTrue(e.erreur.trim().matches("lancer : META-INF/services, ligne qui ne convient pas : lancer\\.contrat\\.Forme: .*" + dit
                + ".* ; attendu : " + attendu + ".*"), e.toString());
        assertEquals(2, e.code);
    }

    @Test
    void sansLaLigneSaSectionEstRefusee() throws IOException {
        refuser(scene + ", ligne 1, [Panneau mur] : type de section inconnu ; attendu : Sphere, Lampe, Camera, Brume, Antialias, Blinn",
                executer(dossier, MUR));
    }
}
