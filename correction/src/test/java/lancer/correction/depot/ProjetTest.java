package lancer.correction.depot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import lancer.correction.modele.SourcesDuCours;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

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
        assertEquals(List.of("le paquet est aucun, « monpaquet » au lieu de « lancer » (2 fichiers)",
                "TP/Vecteur.java : n'est pas en UTF-8, lu en windows-1252"), lu.remarques);
    }

    @Test
    void unTexteEnUtf16SeLitQuIlAitUneMarqueOuNon() throws IOException {
        Path projet = Files.createDirectories(rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer"));
        String texte = "package lancer; // été\nclass %s {}\n";
        Files.write(projet.resolve("Vecteur.java"), String.format(texte, "Vecteur").getBytes(StandardCharsets.UTF_16LE));
        Files.write(projet.resolve("Point.java"), String.format(texte, "Point").getBytes(StandardCharsets.UTF_16BE));
        Files.write(projet.resolve("Rayon.java"), String.format(texte, "Rayon").getBytes(StandardCharsets.UTF_16));
        Projet lu = projet(lire(rendus).get("11"));
        for (String classe : List.of("Vecteur", "Point", "Rayon")) {
            assertEquals(String.format(texte, classe), lu.texte(classe));
        }
    }

    @Test
    void toutLePaquetArriveDansCeluiDuCoursEtCEstDitUneFois() throws IOException {
        Path projet = rendus.resolve("Étudiant 1_11_assignsubmission_file/src");
        ecrire(projet.resolve("fr/univ/tp1/maths/Vecteur.java"), "/* package x; */ package fr.univ\n.tp1.maths ;\nclass Vecteur { }\n");
        ecrire(projet.resolve("fr/univ/tp1/Scene.java"), "package fr.univ.tp1;\nimport fr.univ.tp1.maths.*;\nimport java.util.List;\n"
                + "import static fr.univ.tp1.Outils.f;\nclass Scene { String s = \"import fr.univ.tp1.maths.*;\"; }\n");
        ecrire(projet.resolve("fr/univ/tp1/Outils.java"), "package fr.univ.tp1;\nclass Outils { static void f() { } }\n");
        ecrire(projet.resolve("autre/Essai.java"), "package autre;\nclass Essai { }\n");
        Projet lu = projet(lire(rendus).get("11"));
        assertEquals("[autre/Essai, lancer/Outils, lancer/Scene, lancer/Vecteur]", lu.base.keySet().toString());
        assertEquals("/* package x; */ package lancer\n ;\nclass Vecteur { }\n", lu.texte("Vecteur"));
        assertEquals("package lancer;\nimport lancer.*;\nimport java.util.List;\nimport static lancer.Outils.f;\n"
                + "class Scene { String s = \"import fr.univ.tp1.maths.*;\"; }\n", lu.texte("Scene"));
        assertEquals(List.of("le paquet est « fr.univ.tp1 », « fr.univ.tp1.maths » au lieu de « lancer » (3 fichiers)"), lu.remarques);
    }

    @Test
    void unNomChangeSeConstateEtNeSeDevinePas() throws IOException {
        Path projet = rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer");
        for (String classe : SourcesDuCours.A_COMPLETER) {
            ecrire(projet.resolve(classe.replace("Scene", "Monde") + ".java"), SourcesDuCours.corrige(classe)
                    .replaceAll("\\bScene\\b", "Monde").replace("getNormale", "normale"));
        }
        Rendu rendu = lire(rendus).get("11");
        Projet lu = projet(rendu);
        assertEquals(List.of("Scene absente ; Monde a 3 de ses 3 méthodes : pour la juger, "
                + "remplacez partout Monde par Scene dans une copie "
                + "du rendu, et jugez cette copie", "Sphere.getNormale absente ; prend et rend la même chose : normale",
                "Objet3D.getNormale absente ; prend et rend la même chose : normale",
                "écrit comme le corrigé, aux noms et aux commentaires près : Monde.getClosestIntersection, "
                + "Sphere.getIntersectionDistance"), lu.aRegarder);
    }

    @Test
    void unAutreProjetSeDitEtUnDebutNEnEstPasUn() throws IOException {
        Path banque = rendus.resolve("Étudiant 1_11_assignsubmission_file/banque");
        ecrire(banque.resolve("Compte.java"), "package banque; class Compte { void debiter() { } }");
        ecrire(banque.resolve("Scene.java"), "package banque; class Scene { void jouer() { } }");
        ecrire(rendus.resolve("Étudiant 2_12_assignsubmission_file/lancer/Vecteur.java"), SourcesDuCours.squelette("Vecteur"));
        Map<String, Rendu> lus = lire(rendus);
        assertEquals(List.of("un autre projet : aucune des 8 classes à compléter n'y est comme dans le cours ; les siennes sont Compte"),
                projet(lus.get("11")).aRegarder);
        assertEquals(List.of(), projet(lus.get("12")).aRegarder);
    }

    @Test
    void uneBibliothequeJointeEstNommeeSaufCellesDuCours() throws IOException {
        ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer/Vecteur.java"), CLASSE);
        ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/lib/maths-2.0.jar"), "PK");
        ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/lib/ini4j-0.5.4.jar"), "PK");
        assertEquals(List.of("jugé sans la bibliothèque qu'il joint : maths-2.0.jar"), projet(lire(rendus).get("11")).aRegarder);
    }

    @Test
    void lesEchappementsNeCachentRien() throws IOException {
        Path projet = rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer");
        ecrire(projet.resolve("Deux.java"), "p\\u0061ckage java.lang; public cl\\u0061ss Deux { }");
        ecrire(projet.resolve("Trois.java"), "package lancer; /* \\u002a/ class S\\u006fnde { }");
        ecrire(projet.resolve("Vecteur.java"), "\\u0070ackage tp\\u0031;\npublic class Vecteur { }\n");
        Projet lu = projet(lire(rendus).get("11"));
        assertEquals("[lancer/Vecteur]", lu.base.keySet().toString());
        assertEquals("\\u0070ackage lancer;\npublic class Vecteur { }\n", lu.texte("Vecteur"));
        assertEquals(List.of("lancer/Deux.java : laissé de côté, le paquet « java.lang » n'est pas à vous",
                "lancer/Trois.java : laissé de côté, il déclare une classe Sonde qui cacherait celle de la correction"),
                lu.remarques.subList(0, 2));
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

    /** Écrit ces classes du corrigé dans ce dossier du rendu ; le texte de chacune dit où elle est. */
    private void projet(String dossier, String... classes) throws IOException {
        for (String classe : classes) {
            ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file").resolve(dossier).resolve(classe + ".java"),
                    "package lancer; public class " + SourcesDuCours.classes().stream().filter(classe::contains).findFirst().get()
                    + " { /* " + dossier + " */ }");
        }
    }

    @Test
    void leFichierQuiALeNomDeSaClasseEstLeSienEtLesAutresSontNommes() throws IOException {
        String src = "TP/src/main/java/lancer";
        projet(src, "Lancer", "Camera", "Rayon", "Point", "Scene", "Lancer - Copie", "Camera copie 2", "Copie de Rayon", "Копия Point");
        ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/" + src + "/AncienneScene.java"),
                "package lancer; class Scene { } class Outil { }");
        // du plus sûr au moins sûr : le dossier du paquet, puis le plus proche du projet
        projet(src + "/ancien", "Rayon");
        projet("TP", "Point");
        projet("TP/src", "Sphere");
        projet("vieux/src/lancer", "Sphere");
        Projet lu = projet(lire(rendus).get("11"));
        for (String classe : List.of("Lancer", "Camera", "Rayon", "Point", "Scene")) {
            assertTrue(lu.texte(classe).contains("/* " + src + " */"), lu.texte(classe));
        }
        assertTrue(lu.texte("Sphere").contains("/* vieux/src/lancer */"), lu.texte("Sphere"));
        assertTrue(lu.base.containsKey("lancer/Outil"), "d'un fichier laissé, la classe qu'il déclare seul reste");
        assertEquals(new TreeSet<>(List.of("Lancer - Copie", "Camera copie 2", "Copie de Rayon", "Копия Point", "AncienneScene",
                "ancien/Rayon", "Point", "Sphere")), lu.aRegarder.stream().filter(r -> r.contains(" : laissé de côté, "))
                .map(r -> r.replaceFirst("\\.java : .*", "").replaceFirst("(" + src + "|TP(/src)?)/", ""))
                .collect(Collectors.toCollection(TreeSet::new)));
    }

    @Test
    void unFichierMalNommeEtSeulEstCeluiDeSaClasse() throws IOException {
        projet("lancer", "AncienVecteur", "Point (1)");
        Projet lu = projet(lire(rendus).get("11"));
        assertEquals("[lancer/Point, lancer/Vecteur]", lu.base.keySet().toString());
        // celui qui a le nom de la classe ne la déclare plus
        ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer/Vecteur.java"), "package lancer; // class Vecteur { }");
        lu = projet(lire(rendus).get("11"));
        assertTrue(lu.texte("Vecteur").contains("class Vecteur {"), lu.texte("Vecteur"));
        assertTrue(lu.aRegarder.contains("lancer/Vecteur.java : laissé de côté, Vecteur est dans lancer/AncienVecteur.java"),
                lu.aRegarder.toString());
    }

    /** À gauche, les dossiers d'un rendu ; à droite, celui de la base, puis de chaque extension. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "TP1-base-brume-antialias-blinn/lancer-base;TP1-base-brume-antialias-blinn/brume | lancer-base brume=brume",
        "TP1 avec brume/base;TP1 avec brume/Brume;TP1 avec brume/anti-crénelage;TP1 avec brume/Blinn "
            + "| base brume=Brume antialias=anti-crénelage blinn=Blinn",
        "brume | brume brume=brume", "Мой проект blinn/x | x", "TP-brume-blinn | TP-brume-blinn",
        "rendu/base;rendu/extensions (brume)/AntialiasingAdaptatif;rendu/extensions (brume)/Brume "
            + "| base antialias=AntialiasingAdaptatif brume=Brume",
        "Base;PlanXZ;Creux | Base", "brume/lancer-java;base/lancer-java | base/lancer-java brume=brume/lancer-java",
        ".;brume | . brume=brume"})
    void uneExtensionEstNommeeParUnDossierQuiContientUnProjet(String dossiers, String attendus) throws IOException {
        for (String dossier : dossiers.split(";")) {
            projet(dossier + "/src/main/java/lancer", "Vecteur", "Point", "Rayon", "Camera");
        }
        Projet lu = projet(lire(rendus).get("11"));
        Map<String, String> lieux = new TreeMap<>();
        lu.variantes.forEach((nom, classes) -> lieux.put(nom, classes.get("lancer/Vecteur")));
        for (String attendu : attendus.split(" ")) {
            String[] deux = attendu.split("=");
            String texte = deux.length == 1 ? lu.texte("Vecteur") : lieux.remove(deux[0]);
            assertTrue(texte != null && texte.contains(deux[deux.length - 1] + "/src/main/java"), attendu + " : " + texte);
        }
        assertEquals(Map.of(), lieux);
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
        assertEquals(List.of("vieux/ : laissé de côté, le projet est dans src/, qui a moins de FIXME : Point, Rayon, Vecteur",
                "src2/ : hors du projet, le complète par Objet3D, Scene, Sphere"), lu.remarques);
    }

    @Test
    void deDeuxVersionsLaPlusAvanceeEstJugeeQuelsQueSoientLeursNoms() throws IOException {
        Path projet = rendus.resolve("Étudiant 1_11_assignsubmission_file");
        for (String classe : SourcesDuCours.A_COMPLETER) {
            String commencee = SourcesDuCours.squelette(classe).replaceFirst("(?m)^}", "    int commencee;\n}");
            ecrire(projet.resolve("TP1/lancer/" + classe + ".java"), commencee);
            ecrire(projet.resolve("TP1_final/lancer/" + classe + ".java"), SourcesDuCours.corrige(classe)
                    .replaceFirst("(?m)^}", "    int achevee;\n}"));
        }
        Projet lu = projet(lire(rendus).get("11"));
        SourcesDuCours.A_COMPLETER.forEach(c -> assertTrue(lu.texte(c).contains("achevee"), c));
        assertEquals(List.of("TP1/ : laissé de côté, le projet est dans TP1_final/, qui a moins de FIXME : Camera, Lancer, Objet3D, Point, "
                + "Rayon…"), lu.remarques);
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
        Projet lu = projet(lire(rendus).get("11"));
        assertEquals("[lancer/B, lancer/D, lancer/Vecteur]", lu.base.keySet().toString());
        assertTrue(lu.remarques.get(1).startsWith("lancer/C.java : laissé de côté, le compilateur ne peut pas le lire"),
                "seul celui qui est trop emboîté : " + lu.remarques);
    }

    @Test
    void ceQuiCacheUneClasseDeLaCorrectionEstLaisseDeCoteOuQuIlSoitDansLeFichier() throws IOException {
        Path projet = rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer");
        ecrire(projet.resolve("A.java"), "package lancer; class A { char c = '{'; String s = \"{ // \"; } /* { */ class Appels { }");
        ecrire(projet.resolve("B.java"), "package lancer; class B { static class Appels { } String s = \"} class Appels\"; }");
        ecrire(projet.resolve("Record.java"), "package lancer; class Record { }");
        Projet lu = projet(lire(rendus).get("11"));
        assertEquals("[lancer/B, lancer/Record]", lu.base.keySet().toString(), "une classe du paquet a le nom qu'elle veut");
        assertEquals(List.of("lancer/A.java : laissé de côté, il déclare une classe Appels qui cacherait celle de la correction"),
                lu.remarques);
    }

    @Test
    void unNomSEcritDansToutesLesLanguesEtAvecDesAccentsDecomposes() throws IOException {
        Path projet = rendus.resolve("Étudiant 1_11_assignsubmission_file/src/lancer");
        // macOS décompose les noms de fichiers, et un éditeur peut décomposer aussi le texte
        ecrire(projet.resolve("e\u0301clairage/Lampe.java"), "package lancer.éclairage;\npublic class Lampe { }\n");
        ecrire(projet.resolve("E\u0301clat.java"), "package lancer;\nclass Éclat { }\n");
        ecrire(projet.resolve("Materiau.java"), "package lancer;\nclass Mate\u0301riau { }\n");
        ecrire(projet.resolve("Vecteur.java"), "package lancer;\nimport lancer.éclairage.Lampe;\nclass Vecteur { }\n");
        Projet lu = projet(lire(rendus).get("11"));
        assertEquals(new TreeSet<>(List.of("lancer/Lampe", "lancer/Vecteur", "lancer/Éclat", "lancer/Mate\u0301riau")),
                new TreeSet<>(lu.base.keySet()));
        assertTrue(lu.texte("Vecteur").contains("import lancer.Lampe;"), lu.texte("Vecteur"));
        assertTrue(lu.aRegarder.stream().noneMatch(r -> r.contains("laissé de côté") || r.contains("copies")), lu.aRegarder.toString());
    }

    /** Écrit ces classes, prises au projet à compléter ou au corrigé, dans ce dossier du rendu. */
    private void classes(String dossier, UnaryOperator<String> texte, String... classes) throws IOException {
        for (String classe : classes) {
            ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file").resolve(dossier).resolve("src/lancer/" + classe + ".java"),
                    texte.apply(classe));
        }
    }

    @Test
    void leCorrigeLaisseDansUnRenduNeLEmporteSurAucunAutreTexte() throws IOException {
        String[] toutes = SourcesDuCours.A_COMPLETER.toArray(new String[0]);
        classes("base-java", SourcesDuCours::corrige, toutes);
        classes("lancer-base", SourcesDuCours::squelette, toutes);
        Projet intact = projet(lire(rendus).get("11"));
        assertEquals(Set.of(), intact.changees, "rien n'y est de lui");
        assertTrue(intact.aRegarder.contains("base-java/src/ : laissé de côté, c'est le texte du corrigé : Camera, Lancer, Objet3D, "
                + "Point, Rayon…"), intact.aRegarder.toString());
        // ce qu'il a écrit, même faux ; ce qu'il a laissé est celui du projet à compléter
        classes("lancer-base", c -> SourcesDuCours.corrige(c).replace("* v.y", "* v.x"), "Vecteur");
        Projet commence = projet(lire(rendus).get("11"));
        assertEquals(Set.of("Vecteur"), commence.changees);
        assertTrue(commence.texte("Vecteur").contains("y * v.x"));
    }

    @Test
    void quelquesClassesEcritesCommeLeCorrigeSontBienALEtudiant() throws IOException {
        String[] siennes = {"Sphere", "Scene", "Lancer", "Objet3D", "Camera"};
        classes("lancer-base", SourcesDuCours::corrige, "Vecteur", "Point", "Rayon");
        classes("lancer-base", c -> SourcesDuCours.corrige(c).replaceFirst("\\}\\s*$", "int enPlus; }"), siennes);
        classes("distribue", SourcesDuCours::squelette, SourcesDuCours.A_COMPLETER.toArray(new String[0]));
        assertEquals(new TreeSet<>(SourcesDuCours.A_COMPLETER), new TreeSet<>(projet(lire(rendus).get("11")).changees));
    }

    /** Hors du dossier du projet : les fichiers d'un autre travail, puis ce qu'il faut en dire. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "TP3/src/cartes/Couleur.java=package cartes; public enum Couleur { TREFLE, PIQUE }",
        "TP2/Constantes.java=public class Constantes { static final int TAILLE = 3; }",
        "TP2/src/Lampe.java=class Lampe { void allumer() { } }", "TP2/Main.java=class Main { void jouer() { } }",
        "TP2/src/geo/Vecteur.java=package geo; class Vecteur { double longueur() { return 0; } }",
        "lancer-base/src/lancer/ancien/Couleur.java=package lancer; class Couleur { int rouge() { return 0; } }"})
    void unAutreTravailNeRemplaceAucuneClasseDonneeOuEcrite(String fichier) throws IOException {
        classes("lancer-base", c -> SourcesDuCours.corrige(c).replaceFirst("\\}\\s*$", "int enPlus; }"),
                SourcesDuCours.classes().toArray(new String[0]));
        ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file").resolve(fichier.split("=")[0]), fichier.split("=")[1]);
        Projet lu = projet(lire(rendus).get("11"));
        String classe = fichier.replaceFirst("(?s).*/(\\w+)\\.java=.*", "$1");
        assertTrue(lu.texte(classe).contains("enPlus"), lu.texte(classe));
        assertEquals(List.of(fichier.replaceFirst("(cartes/|geo/)?\\w+\\.java=.*", "") + " : laissé de côté, hors du projet ; " + classe
                + " n'y est pas du cours", "écrit comme le corrigé, aux noms et aux commentaires près : Objet3D.getColor, "
                + "Scene.getClosestIntersection, Sphere.getIntersectionDistance"), lu.aRegarder);
        assertEquals(Map.of(), lu.ecarts);
    }

    @Test
    void uneAnnotationQueRienNeDefinitNeCouteRienEtCEstDit() throws IOException {
        ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer/Vecteur.java"), "package lancer;\nimport lombok.Getter;\n"
                + "import java.util.List;\n@Getter @Deprecated class Vecteur {\n@fr.moi.NotNull(\n1) List<String> f(@Mien int p) { }\n}\n"
                + "@interface Mien { }\n");
        Projet lu = projet(lire(rendus).get("11"));
        assertEquals("package lancer;\n\nimport java.util.List;\n@Deprecated class Vecteur {\n\nList<String> f(@Mien int p) { }\n}",
                lu.texte("Vecteur").replaceAll("(?m)^ +| +$", ""));
        assertEquals(List.of("lancer/Vecteur.java : jugé sans l'annotation @Getter, que rien ne définit ici",
                "lancer/Vecteur.java : jugé sans l'annotation @fr.moi.NotNull, que rien ne définit ici"), lu.aRegarder.subList(1, 3));
    }

    @Test
    void desNomsChangesSontUnEcartAuxConsignes() throws IOException {
        for (String classe : SourcesDuCours.A_COMPLETER) {
            ecrire(rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer/" + classe.replace("Vecteur", "Vecteur3D") + ".java"),
                    SourcesDuCours.corrige(classe).replaceAll("\\bVecteur\\b", "Vecteur3D").replace("getNormale", "normaleEn"));
        }
        assertEquals("Vecteur s'appelle Vecteur3D ; Sphere.getNormale s'appelle normaleEn ; Objet3D.getNormale s'appelle normaleEn",
                projet(lire(rendus).get("11")).ecarts.get(Projet.NOMS));
    }

    @Test
    void leTexteDuCorrigeQuiEstSeulEstJugeEtNomme() throws IOException {
        classes("mon projet", SourcesDuCours::corrige, "Sphere", "Scene");
        classes("mon projet", SourcesDuCours::squelette, "Vecteur");
        Projet lu = projet(lire(rendus).get("11"));
        assertEquals(Set.of("Sphere", "Scene"), lu.changees);
        assertTrue(lu.aRegarder.contains("écrit comme le corrigé, aux noms et aux commentaires près : "
                + "Scene.getClosestIntersection, Sphere.getIntersectionDistance"), lu.aRegarder.toString());
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
        assertEquals(projet.remarques, projet.aRegarder);
    }

    @Test
    void desParametresEnFloatSeLaissentAppelerAvecDesDoubleEtCEstDitUneFois() throws IOException {
        Path projet = rendus.resolve("Étudiant 1_11_assignsubmission_file/lancer");
        ecrire(projet.resolve("Vecteur.java"), SourcesDuCours.corrige("Vecteur").replace("double", "float"));
        ecrire(projet.resolve("Couleur.java"), SourcesDuCours.corrige("Couleur").replace("double", "float"));
        Projet lu = projet(lire(rendus).get("11"));
        String vecteur = lu.texte("Vecteur");
        assertTrue(vecteur.contains(" public  Vecteur(double p0, double p1, double p2) { this((float) p0, (float) p1, (float) p2); }"
                + " public Vecteur mul(double p0) { return mul((float) p0); }"), vecteur);
        assertTrue(vecteur.contains(" public static Vecteur div(Vecteur p0, double p1) { return div(p0, (float) p1); }"), vecteur);
        assertEquals(SourcesDuCours.corrige("Vecteur").split("\n").length, vecteur.split("\n").length);
        assertTrue(lu.texte("Couleur").contains("Couleur(double p0) { this((float) p0); }"), "une classe donnée aussi");
        assertEquals(1, lu.remarques.size(), lu.remarques.toString());
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
        assertEquals("lancer/Vecteur", projet.base.keySet().stream().filter(cle -> !cle.matches("x/Z\\d+|a/Mal"))
                .collect(Collectors.joining(" ")));
    }

    private static void entree(ZipOutputStream zip, String nom, String texte) throws IOException {
        zip.putNextEntry(new ZipEntry(nom));
        zip.write(texte.getBytes(StandardCharsets.UTF_8));
    }
}
