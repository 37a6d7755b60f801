package lancer.correction.depot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Test;

/** Ce que les étudiants mettent dans un rendu : des projets, des copies, des classes. */
class ProjetTest extends DepotEssai {

    @Test
    void lesAccentsDAutresCodagesEtUnPaquetOublieSArrangent() throws IOException {
        Path projet = rendus.resolve("Étudiant 1_11_assignsubmission_file/TP");
        Files.createDirectories(projet);
        Files.write(projet.resolve("Vecteur.java"), "// été\npublic class Vecteur {}\n".getBytes(StandardCharsets.ISO_8859_1));
        ecrire(projet.resolve("Point.java"), "\uFEFFpackage monpaquet;\nimport monpaquet.Vecteur;\nclass Point {}\n");
        Projet lu = projet(lire(rendus).get("11"));
        assertEquals("package lancer; // été\npublic class Vecteur {}\n", lu.texte("Vecteur"));
        assertEquals("package lancer;\nimport lancer.Vecteur;\nclass Point {}\n", lu.texte("Point"));
        assertEquals(2, lu.remarques.size(), lu.remarques.toString());
    }

    @Test
    void lesVariantesSontDesCopiesAPart() throws IOException {
        for (String partie : List.of("lancer-base", "brume", "Antialias", "blinn")) {
            ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/" + partie + "/src/main/java/lancer/Vecteur.java"), CLASSE);
        }
        ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer-base/src/test/java/lancer/Tests.java"),
                "package lancer; class Tests {}");
        Projet projet = projet(lire(rendus).get("11"));
        assertEquals(List.of("brume", "antialias", "blinn"), List.copyOf(projet.variantes.keySet()));
        assertEquals(1, projet.base.size(), "Tests, de l'étudiant, n'en est pas");
    }

    @Test
    void desSourcesEnDeuxDossiersSontUnSeulProjetEtUneAncienneVersionEstLaissee() throws IOException {
        Path projet = rendus.resolve("Étudiant 1_11_assignsubmission_file");
        for (String classe : List.of("src/Vecteur", "src/Point", "src/Rayon", "src/Camera", "src2/Sphere", "src2/Scene", "src2/Objet3D",
                "vieux/Vecteur", "vieux/Point", "vieux/Rayon")) {
            ecrire(projet.resolve(classe.replace("/", "/lancer/") + ".java"), "package lancer; // " + classe);
        }
        Projet lu = projet(lire(rendus).get("11"));
        assertEquals(7, lu.base.size(), lu.base.keySet().toString());
        assertEquals("package lancer; // src/Vecteur", lu.texte("Vecteur"));
        assertEquals(List.of("plusieurs copies du projet : jugée, « src/ » ; laissée, « vieux/ »"), lu.remarques);
    }

    @Test
    void plusieursClassesDansUnFichierSontAutantDeClassesAuxMemesLignes() throws IOException {
        Path projet = rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer");
        ecrire(projet.resolve("TP.java"), "import java.util.List; // {\nclass Vecteur { char c = '}';\n static class Point { } }\n"
                + "/** Un point. */ @Deprecated final class Point { }\nenum Outil { A }\n");
        ecrire(projet.resolve("Sphere.java"), "package lancer; class Sphere { } }\n void f() { }\n class Scene { }");
        Projet lu = projet(lire(rendus).get("11"));
        assertEquals("[lancer/Outil, lancer/Point, lancer/Sphere, lancer/Vecteur]", lu.base.keySet().toString(),
                "une accolade de trop ne fait pas deux classes");
        assertEquals("package lancer; import java.util.List; // {\nclass Vecteur { char c = '}';\n static class Point { } }",
                lu.texte("Vecteur"));
        assertEquals("package lancer; import java.util.List;\n\n\n/** Un point. */ @Deprecated final class Point { }",
                lu.texte("Point").replaceAll(" +(?=\n)", ""));
    }

    @Test
    void unTexteDemesureSeLitCommeUnAutre() throws IOException {
        Path projet = rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer");
        ecrire(projet.resolve("A.java"), "\n".repeat(900_000));
        ecrire(projet.resolve("B.java"), "package lancer; class B { String s = \"" + "ab".repeat(300_000) + "\"; }");
        ecrire(projet.resolve("C.java"), "package lancer; class C { void f() " + "{".repeat(300_000) + "}".repeat(300_000) + " }");
        ecrire(projet.resolve("D.java"), "package lancer; class D { " + "/*".repeat(3) + " /*".repeat(300_000));
        ecrire(projet.resolve("Vecteur.java"), "package lancer; class Vecteur { " + "public ".repeat(100_000) + "}");
        assertEquals(5, projet(lire(rendus).get("11")).base.size());
    }

    @Test
    void ceQuiCacheUneClasseDeJavaEstLaisseDeCoteOuQuIlSoitDansLeFichier() throws IOException {
        Path projet = rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer");
        ecrire(projet.resolve("A.java"), "package lancer; class A { char c = '{'; String s = \"{ // \"; } /* { */ class Math { }");
        ecrire(projet.resolve("B.java"), "package lancer; class B { static class Math { } String s = \"} class Math\"; }");
        Projet lu = projet(lire(rendus).get("11"));
        assertEquals("[lancer/B]", lu.base.keySet().toString(), "Math n'y est pas");
        assertEquals(List.of("lancer/A.java : laissé de côté, il déclare une classe Math qui cacherait celle de Java"),
                lu.remarques);
    }

    @Test
    void unAutreOrdreDeParametresEstUneRemarqueEtNonUneFaute() throws IOException {
        ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer/Objet3D.java"),
                "package lancer;\nabstract class Objet3D {\n    public Couleur getColor(Rayon r, Scene s, PointContact c, int p) {\n"
                        + "        return null;\n    }\n}\n");
        ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer/Scene.java"),
                "package lancer;\nclass Scene {\n    public PointContact getClosestIntersection(Rayon r) {\n        return null;\n    }\n"
                        + "    public PointContact getClosestIntersection(final Rayon r, Objet3D o) {\n        return null;\n    }\n}\n");
        Projet projet = projet(lire(rendus).get("11"));
        assertTrue(projet.texte("Objet3D").contains(
                "getColor(Scene p0, Rayon p1, PointContact p2, int p3) { return getColor(p1, p0, p2, p3); }"));
        assertEquals(1, projet.remarques.size(), projet.remarques.toString());
    }

    @Test
    void unReelDUneAutreSorteEstLaisseTelQuelEtDesEntiersSeLaissentAppeler() throws IOException {
        ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer/Lancer.java"), "package lancer;\nclass Lancer {\n"
                + "    public Couleur getCouleurPixel(int xe, int ye, int p) {\n        return null;\n    }\n}\n");
        String vecteur = "package lancer;\nclass Vecteur {\n    public float dot(Vecteur v) {\n        return dot (v);\n    }\n}\n";
        ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer/Vecteur.java"), vecteur);
        Projet projet = projet(lire(rendus).get("11"));
        assertTrue(projet.texte("Lancer").contains("getCouleurPixel(double p0, double p1, int p2) { "
                + "return getCouleurPixel((int) p0, (int) p1, p2); }"), projet.texte("Lancer"));
        assertEquals(vecteur, projet.texte("Vecteur"));
        assertEquals(1, projet.remarques.size(), projet.remarques.toString());
    }

    @Test
    void unNomQuiNEstPasCeluiDUneClasseNeFaitPasUnChemin() throws IOException {
        Path archive = Files.createDirectories(rendus.resolve("Étudiant 1_11_assignsubmission_file")).resolve("tp.zip");
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(archive))) {
            int k = 0;
            for (String paquet : List.of(".tmp.x.y", "..", "a..b", "a.", "a".repeat(300), "java.lang", "lancer.correction.x")) {
                entree(zip, "p" + k++ + "/Mal.java", "package " + paquet + ";\nclass Mal { }\n");
            }
            for (String nom : List.of("A\nFIN\n.java", "A\tB.java", " .java", ".java", "A\u202Egpj.java", "b".repeat(200) + ".java",
                    "c".repeat(9000) + ".java", "A\u0000.java", "CON .java")) {
                entree(zip, nom, "package x; interface " + "Z" + k++ + " {}");
            }
            entree(zip, "lancer/Vecteur (1).java", CLASSE);
            StringBuilder milliers = new StringBuilder("package lancer;\n");
            for (int n = 0; n < 40_000; n++) {
                milliers.append("class C").append(n).append("{}\n");
            }
            entree(zip, "lancer/Milliers.java", milliers.toString());
            entree(zip, "lancer/Point.java", milliers + "class Point { }\n");
        }
        Rendu rendu = lire(rendus).get("11");
        Projet projet = projet(rendu);
        // ce que déclare un fichier mal nommé le nomme
        assertEquals("lancer/Vecteur", projet.base.keySet().stream().filter(cle -> !cle.matches("x/Z\\d+"))
                .collect(Collectors.joining(" ")));
    }

    private static void entree(ZipOutputStream zip, String nom, String texte) throws IOException {
        zip.putNextEntry(new ZipEntry(nom));
        zip.write(texte.getBytes(StandardCharsets.UTF_8));
    }
}
