package lancer.contrat;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Collections;
import lancer.essai.Essai;
import lancer.essai.Ressources;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Ce qui ne va pas dans une forme d'étudiant, sa section ou sa ligne de services : une ligne le dit, et rien ne se dessine. */
class FormesRefuseesTest extends EssaiFormes {

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
        return Essai.executerAvec(Collections.singletonList(classes), "--lineaire", dossier.resolve("image.pfm").toString(), "--taille=1x1",
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
                + "Sphere, Panneau, Lampe, Camera, Brume, Antialias, Blinn"})
    void uneSectionFautiveEstRefuseeEnUneLigne(String lignes, String message) throws IOException {
        refuser(Essai.message("{fichier}, " + message, scene), executer(classesDuPanneau, ("[Panneau sol]~" + lignes).split("~")));
    }

    @Test
    void toutMessageEstCeluiDUneSphere() throws IOException {
        Path fautives = Paths.get(Ressources.chemin("fautives"));
        Path pfm = dossier.resolve("image.pfm");
        int refusees = 0;
        try (Essai.Isole programme = new Essai.Isole(Collections.singletonList(inscrire(SERVICE, BALLON)));
                DirectoryStream<Path> fichiers = Files.newDirectoryStream(fautives, "*.ini")) {
            for (Path fichier : fichiers) {
                String octets = new String(Files.readAllBytes(fichier), StandardCharsets.ISO_8859_1);
                Files.write(scene, octets.replaceAll("\\[(?i:sphere)", "[Ballon").getBytes(StandardCharsets.ISO_8859_1));
                String message = lireTexte(fichier.resolveSibling(fichier.getFileName().toString().replace(".ini", ".message")));
                Essai e = programme.executer("--taille=1x1", "--lineaire", pfm.toString(), scene.toString());
                assertEquals(Essai.message(message, scene).replaceAll("\\[(?i:sphere)", "[Sphere"),
                        e.sansAutresFormes("").replace("[Ballon", "[Sphere"), fichier.toString());
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
                "    public void installer(lancer.contrat.Section valeurs, lancer.contrat.Modele modele) { }",
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
        String ou = e.erreur.replaceAll(" \\(lancer\\.Panneau\\.lire, Panneau\\.java:\\d+\\)", "");
        assertEquals(!fautive.startsWith("return"), !ou.equals(e.erreur), "la ligne de lire qui échoue : " + e);
        assertEquals("lancer : " + scene + ", ligne 1, [Panneau mur] : section que lancer.Panneau ne sait pas lire : java.lang."
                + dit + " ; attendu : des valeurs qui lui conviennent" + System.lineSeparator(), ou);
        assertEquals(2, e.code);
    }

    @ParameterizedTest
    @CsvSource({"lancer.Sphere, lancer.Sphere", "lancer.Objet3D, lancer.Objet3D",
        "pas un nom, lancer.contrat.Forme:1"})
    void uneLigneDeServicesQuiNeConvientPasEstRefusee(String ligne, String dit) throws IOException {
        Path services = Files.createDirectories(dossier.resolve(SERVICE).getParent());
        Files.write(services.resolve("lancer.contrat.Forme"), Collections.singletonList(ligne));
        Essai e = executer(dossier, "[Sphere 1]", "centre=0 0 6", "rayon=1");
        assertTrue(e.erreur.matches("lancer : META-INF/services, ligne qui ne convient pas : lancer\\.contrat\\.Forme: .*" + dit
                + ".* ; attendu : une classe publique de ce contrat, à constructeur public sans argument, .*\\R"), e.toString());
        assertEquals(2, e.code);
    }

    @Test
    void uneClasseDeServicesQuiNExistePasEstNommeeAvecLeRemede() throws IOException {
        Path services = Files.createDirectories(dossier.resolve(SERVICE).getParent());
        Files.write(services.resolve("lancer.contrat.Forme"), Collections.singletonList("lancer.Pnaneau"));
        Essai e = executer(dossier, "[Sphere 1]", "centre=0 0 6", "rayon=1");
        assertTrue(e.erreur.matches("lancer : META-INF/services, ligne .* lancer\\.Pnaneau .* ; attendu : .* make propre\\R"),
                e.toString());
        assertEquals(2, e.code);
    }

    @Test
    void sansLaLigneSaSectionEstRefusee() throws IOException {
        refuser(scene + ", ligne 1, [Panneau mur] : type de section inconnu ; attendu : Sphere, Lampe, Camera, Brume, Antialias, Blinn",
                executer(dossier, MUR));
    }
}
