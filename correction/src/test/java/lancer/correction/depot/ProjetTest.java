package lancer.correction.depot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lancer.correction.modele.SourcesDuCours;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Ce que les étudiants mettent dans un rendu : des projets, des copies, des classes. */
class ProjetTest extends DepotEssai {

    private static final String[] TOUTES = SourcesDuCours.A_COMPLETER.toArray(new String[0]);
    private static final String COMME = "écrit comme le corrigé, aux noms et aux commentaires près : ";

    @Test
    void lesAccentsDAutresCodagesEtUnPaquetOublieSArrangent() throws IOException {
        Files.writeString(Files.createDirectories(rendu.resolve("TP")).resolve("Vecteur.java"), "// été\npublic class Vecteur {}\n",
                StandardCharsets.ISO_8859_1);
        Projet lu = rendre("TP", "Point", "\uFEFFpackage monpaquet;\nimport monpaquet.Vecteur;\nclass Point {}\n");
        assertEquals("package lancer; // été\npublic class Vecteur {}\n", lu.texte("Vecteur"));
        assertEquals("package lancer;\nimport lancer.Vecteur;\nclass Point {}\n", lu.texte("Point"));
        assertEquals(List.of("le paquet est aucun, « monpaquet » au lieu de « lancer » (2 fichiers)",
                "TP/Vecteur.java : n'est pas en UTF-8, lu en windows-1252"), lu.remarques);
    }

    @Test
    void unTexteEnUtf16SeLitQuIlAitUneMarqueOuNon() throws IOException {
        Path projet = Files.createDirectories(rendu.resolve("lancer"));
        String texte = "package lancer; // été\nclass %s {}\n";
        Map<String, Charset> codages = Map.of("Vecteur", StandardCharsets.UTF_16LE, "Point", StandardCharsets.UTF_16BE, "Rayon",
                StandardCharsets.UTF_16);
        for (String classe : codages.keySet()) {
            Files.writeString(projet.resolve(classe + ".java"), String.format(texte, classe), codages.get(classe));
            assertEquals(String.format(texte, classe), projet().texte(classe));
        }
    }

    @Test
    void toutLePaquetArriveDansCeluiDuCoursEtCEstDitUneFois() throws IOException {
        Projet lu = rendre("src",
                "fr/univ/tp1/maths/Vecteur", "/* package x; */ package fr.univ\n.tp1.maths ;\nclass Vecteur { }\n",
                "fr/univ/tp1/Scene", "package fr.univ.tp1;\nimport fr.univ.tp1.maths.*;\nimport java.util.List;\n"
                    + "import static fr.univ.tp1.Outils.f;\nclass Scene { String s = \"import fr.univ.tp1.maths.*;\"; }\n",
                "fr/univ/tp1/Outils", "package fr.univ.tp1;\nclass Outils { static void f() { } }\n",
                "autre/Essai", "package autre;\nclass Essai { }\n");
        assertEquals("[autre/Essai, lancer/Outils, lancer/Scene, lancer/Vecteur]", lu.base.keySet().toString());
        assertEquals("/* package x; */ package lancer\n ;\nclass Vecteur { }\n", lu.texte("Vecteur"));
        assertEquals("package lancer;\nimport lancer.*;\nimport java.util.List;\nimport static lancer.Outils.f;\n"
                + "class Scene { String s = \"import fr.univ.tp1.maths.*;\"; }\n", lu.texte("Scene"));
        assertEquals(List.of("le paquet est « fr.univ.tp1 », « fr.univ.tp1.maths » au lieu de « lancer » (3 fichiers)"), lu.remarques);
    }

    @Test
    void unNomChangeSeConstateEtNeSeDevinePas() throws IOException {
        classes("TP", c -> SourcesDuCours.corrige(c).replaceAll("\\bScene\\b", "Monde").replace("getNormale", "normale"), TOUTES);
        assertEquals(List.of("Scene absente ; Monde a 3 de ses 3 méthodes : pour la juger, remplacez partout Monde par Scene dans une "
                + "copie du rendu, et jugez cette copie", "Sphere.getNormale absente ; prend et rend la même chose : normale",
                "Objet3D.getNormale absente ; prend et rend la même chose : normale",
                COMME + "Monde.getClosestIntersection, Sphere.getIntersectionDistance"), projet().aRegarder);
    }

    @Test
    void unAutreProjetSeDitEtUnDebutNEnEstPasUn() throws IOException {
        ecrire(rendus.resolve("Étudiant 2_12_assignsubmission_file/lancer/Vecteur.java"), SourcesDuCours.squelette("Vecteur"));
        assertEquals(List.of("un autre projet : aucune des 8 classes à compléter n'y est comme dans le cours ; les siennes sont Compte"),
                rendre("banque", "Compte", "package banque; class Compte { void debiter() { } }",
                        "Scene", "package banque; class Scene { void jouer() { } }").aRegarder);
        assertEquals(List.of(), projet(lire(rendus).get("12")).aRegarder);
    }

    @Test
    void uneBibliothequeJointeEstNommeeSaufCellesDuCours() throws IOException {
        ecrire(rendu.resolve("lib/maths-2.0.jar"), "PK");
        ecrire(rendu.resolve("lib/ini4j-0.5.4.jar"), "PK");
        assertEquals(List.of("jugé sans la bibliothèque qu'il joint : maths-2.0.jar"), rendre("lancer", "Vecteur", CLASSE).aRegarder);
    }

    @Test
    void lesEchappementsNeCachentRien() throws IOException {
        Projet lu = rendre("lancer",
                "Deux", "p\\u0061ckage java.lang; public cl\\u0061ss Deux { }",
                "Trois", "package lancer; /* \\u002a/ class S\\u006fnde { }",
                "Vecteur", "\\u0070ackage tp\\u0031;\npublic class Vecteur { }\n");
        assertEquals("[lancer/Vecteur]", lu.base.keySet().toString());
        assertEquals("\\u0070ackage lancer;\npublic class Vecteur { }\n", lu.texte("Vecteur"));
        assertEquals(List.of("lancer/Deux.java : laissé de côté, le paquet « java.lang » n'est pas à vous",
                "lancer/Trois.java : laissé de côté, il déclare une classe Sonde qui cacherait celle de la correction"),
                lu.remarques.subList(0, 2));
    }

    @Test
    void lesVariantesSontDesCopiesAPart() throws IOException {
        for (String partie : List.of("lancer-base", "brume", "Antialias", "blinn")) {
            ecrire(partie + "/src/main/java/lancer", "Vecteur", CLASSE);
        }
        Projet projet = rendre("lancer-base/src/test/java/lancer", "Tests", "package lancer; class Tests {}");
        assertEquals(List.of("brume", "antialias", "blinn"), List.copyOf(projet.variantes.keySet()));
        assertEquals(1, projet.base.size(), "Tests, de l'étudiant, n'en est pas");
    }

    /** Écrit ces classes du corrigé dans ce dossier du rendu ; le texte de chacune dit où elle est. */
    private void situer(String dossier, String... classes) throws IOException {
        for (String classe : classes) {
            ecrire(dossier, classe, "package lancer; public class " + SourcesDuCours.classes().stream().filter(classe::contains).findFirst()
                    .get() + " { /* " + dossier + " */ }");
        }
    }

    @Test
    void leFichierQuiALeNomDeSaClasseEstLeSienEtLesAutresSontNommes() throws IOException {
        String src = "TP/src/main/java/lancer";
        situer(src, "Lancer", "Camera", "Rayon", "Point", "Scene", "Lancer - Copie", "Camera copie 2", "Copie de Rayon", "Копия Point");
        ecrire(src, "AncienneScene", "package lancer; class Scene { } class Outil { }");
        // du plus sûr au moins sûr : le dossier du paquet, puis le plus proche du projet
        situer(src + "/ancien", "Rayon");
        situer("TP", "Point");
        situer("TP/src", "Sphere");
        situer("vieux/src/lancer", "Sphere");
        Projet lu = projet();
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
        situer("lancer", "AncienVecteur", "Point (1)");
        assertEquals("[lancer/Point, lancer/Vecteur]", projet().base.keySet().toString());
        // celui qui a le nom de la classe ne la déclare plus
        Projet lu = rendre("lancer", "Vecteur", "package lancer; // class Vecteur { }");
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
            situer(dossier + "/src/main/java/lancer", "Vecteur", "Point", "Rayon", "Camera");
        }
        Projet lu = projet();
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
        for (String classe : List.of("src/Vecteur", "src/Point", "src/Rayon", "src/Camera", "src2/Sphere", "src2/Scene", "src2/Objet3D",
                "vieux/Vecteur", "vieux/Point", "vieux/Rayon")) {
            ecrire("", classe.replace("/", "/lancer/"), "package lancer; // " + classe);
        }
        Projet lu = projet();
        assertEquals(7, lu.base.size(), lu.base.keySet().toString());
        assertEquals("package lancer; // src/Vecteur", lu.texte("Vecteur"));
        assertEquals(List.of("vieux/ : laissé de côté, le projet est dans src/, qui a moins de FIXME : Point, Rayon, Vecteur",
                "src2/ : hors du projet, le complète par Objet3D, Scene, Sphere"), lu.remarques);
    }

    @Test
    void deDeuxVersionsLaPlusAvanceeEstJugeeQuelsQueSoientLeursNoms() throws IOException {
        classes("TP1", c -> SourcesDuCours.squelette(c).replaceFirst("(?m)^}", "    int commencee;\n}"), TOUTES);
        classes("TP1_final", c -> SourcesDuCours.corrige(c).replaceFirst("(?m)^}", "    int achevee;\n}"), TOUTES);
        Projet lu = projet();
        SourcesDuCours.A_COMPLETER.forEach(c -> assertTrue(lu.texte(c).contains("achevee"), c));
        assertEquals(List.of("TP1/src/ : laissé de côté, le projet est dans TP1_final/src/, qui a moins de FIXME : Camera, Lancer, "
                + "Objet3D, Point, Rayon…"), lu.remarques);
    }

    @Test
    void plusieursClassesDansUnFichierSontAutantDeClassesAuxMemesLignes() throws IOException {
        Projet lu = rendre("lancer",
                "TP", "import java.util.List; // {\nclass Vecteur { char c = '}';\n static class Point { } }\n"
                    + "/** Un point. */ @Deprecated final class Point { }\nenum Outil { A }\n",
                "Sphere", "package lancer; class Sphere { } }\n void f() { }\n class Scene { }");
        assertEquals("[lancer/Outil, lancer/Point, lancer/Sphere, lancer/Vecteur]", lu.base.keySet().toString(),
                "une accolade de trop ne fait pas deux classes");
        assertEquals("package lancer; import java.util.List; // {\nclass Vecteur { char c = '}';\n static class Point { } }",
                lu.texte("Vecteur"));
        assertEquals("package lancer; import java.util.List;\n\n\n/** Un point. */ @Deprecated final class Point { }",
                lu.texte("Point").replaceAll(" +(?=\n)", ""));
    }

    @Test
    void unTexteDemesureSeLitCommeUnAutre() throws IOException {
        Projet lu = rendre("lancer",
                "A", "\n".repeat(900_000),
                "B", "package lancer; class B { String s = \"" + "ab".repeat(300_000) + "\"; }",
                "C", "package lancer; class C { void f() " + "{".repeat(300_000) + "}".repeat(300_000) + " }",
                "D", "package lancer; class D { " + "/*".repeat(3) + " /*".repeat(300_000),
                "Vecteur", "package lancer; class Vecteur { " + "public ".repeat(100_000) + "}");
        assertEquals("[lancer/B, lancer/D, lancer/Vecteur]", lu.base.keySet().toString());
        assertTrue(lu.remarques.get(1).startsWith("lancer/C.java : laissé de côté, le compilateur ne peut pas le lire"),
                "seul celui qui est trop emboîté : " + lu.remarques);
    }

    @Test
    void ceQuiCacheUneClasseDeLaCorrectionEstLaisseDeCoteOuQuIlSoitDansLeFichier() throws IOException {
        Projet lu = rendre("lancer",
                "A", "package lancer; class A { char c = '{'; String s = \"{ // \"; } /* { */ class Appels { }",
                "B", "package lancer; class B { static class Appels { } String s = \"} class Appels\"; }",
                "Record", "package lancer; class Record { }");
        assertEquals("[lancer/B, lancer/Record]", lu.base.keySet().toString(), "une classe du paquet a le nom qu'elle veut");
        assertEquals(List.of("lancer/A.java : laissé de côté, il déclare une classe Appels qui cacherait celle de la correction"),
                lu.remarques);
    }

    @Test
    void unNomSEcritDansToutesLesLanguesEtAvecDesAccentsDecomposes() throws IOException {
        // macOS décompose les noms de fichiers, et un éditeur peut décomposer aussi le texte
        Projet lu = rendre("src/lancer",
                "e\u0301clairage/Lampe", "package lancer.éclairage;\npublic class Lampe { }\n",
                "E\u0301clat", "package lancer;\nclass Éclat { }\n",
                "Materiau", "package lancer;\nclass Mate\u0301riau { }\n",
                "Vecteur", "package lancer;\nimport lancer.éclairage.Lampe;\nclass Vecteur { }\n");
        assertEquals(Set.of("lancer/Lampe", "lancer/Vecteur", "lancer/Éclat", "lancer/Mate\u0301riau"), lu.base.keySet());
        assertTrue(lu.texte("Vecteur").contains("import lancer.Lampe;"), lu.texte("Vecteur"));
        assertTrue(lu.aRegarder.stream().noneMatch(r -> r.contains("laissé de côté") || r.contains("copies")), lu.aRegarder.toString());
    }

    /** Écrit ces classes, prises au projet à compléter ou au corrigé, dans ce dossier du rendu, sous le nom que dit leur texte. */
    private void classes(String dossier, UnaryOperator<String> texte, String... classes) throws IOException {
        for (String classe : classes) {
            String nom = texte.apply(classe).replaceFirst("(?s).*?\n(?:public |abstract |final )*(?:class|interface) (\\w+).*", "$1");
            ecrire(dossier + "/src/lancer", nom, texte.apply(classe));
        }
    }

    private static String deLui(String classe) {
        return SourcesDuCours.corrige(classe).replaceFirst("\\}\\s*$", "int enPlus; }");
    }

    @Test
    void leCorrigeLaisseDansUnRenduNeLEmporteSurAucunAutreTexte() throws IOException {
        classes("base-java", SourcesDuCours::corrige, TOUTES);
        classes("lancer-base", SourcesDuCours::squelette, TOUTES);
        Projet intact = projet();
        assertEquals(Set.of(), intact.changees, "rien n'y est de lui");
        assertTrue(intact.aRegarder.contains("base-java/src/ : laissé de côté, c'est le texte du corrigé : Camera, Lancer, Objet3D, "
                + "Point, Rayon…"), intact.aRegarder.toString());
        // ce qu'il a écrit, même faux ; ce qu'il a laissé est celui du projet à compléter
        classes("lancer-base", c -> SourcesDuCours.corrige(c).replace("* v.y", "* v.x"), "Vecteur");
        Projet commence = projet();
        assertEquals(Set.of("Vecteur"), commence.changees);
        assertTrue(commence.texte("Vecteur").contains("y * v.x"));
    }

    @Test
    void quelquesClassesEcritesCommeLeCorrigeSontBienALEtudiant() throws IOException {
        classes("lancer-base", SourcesDuCours::corrige, "Vecteur", "Point", "Rayon");
        classes("lancer-base", ProjetTest::deLui, "Sphere", "Scene", "Lancer", "Objet3D", "Camera");
        classes("distribue", SourcesDuCours::squelette, TOUTES);
        assertEquals(new TreeSet<>(SourcesDuCours.A_COMPLETER), new TreeSet<>(projet().changees));
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
        classes("lancer-base", ProjetTest::deLui, SourcesDuCours.classes().toArray(new String[0]));
        ecrire(rendu.resolve(fichier.split("=")[0]), fichier.split("=")[1]);
        Projet lu = projet();
        String classe = fichier.replaceFirst("(?s).*/(\\w+)\\.java=.*", "$1");
        assertTrue(lu.texte(classe).contains("enPlus"), lu.texte(classe));
        assertEquals(List.of(fichier.replaceFirst("(cartes/|geo/)?\\w+\\.java=.*", "") + " : laissé de côté, hors du projet ; " + classe
                + " n'y est pas du cours", COMME + "Objet3D.getColor, Scene.getClosestIntersection, Sphere.getIntersectionDistance"),
                lu.aRegarder);
        assertEquals(Map.of(), lu.ecarts);
    }

    @Test
    void uneAnnotationQueRienNeDefinitNeCouteRienEtCEstDit() throws IOException {
        Projet lu = rendre("lancer", "Vecteur", "package lancer;\nimport lombok.Getter;\n"
                + "import java.util.List;\n@Getter @Deprecated class Vecteur {\n@fr.moi.NotNull(\n1) List<String> f(@Mien int p) { }\n}\n"
                + "@interface Mien { }\n");
        assertEquals("package lancer;\n\nimport java.util.List;\n@Deprecated class Vecteur {\n\nList<String> f(@Mien int p) { }\n}",
                lu.texte("Vecteur").replaceAll("(?m)^ +| +$", ""));
        assertEquals(List.of("lancer/Vecteur.java : jugé sans l'annotation @Getter, que rien ne définit ici",
                "lancer/Vecteur.java : jugé sans l'annotation @fr.moi.NotNull, que rien ne définit ici"), lu.aRegarder.subList(1, 3));
    }

    @Test
    void desNomsChangesSontUnEcartAuxConsignes() throws IOException {
        classes("TP", c -> SourcesDuCours.corrige(c).replaceAll("\\bVecteur\\b", "Vecteur3D").replace("getNormale", "normaleEn"), TOUTES);
        assertEquals("Vecteur s'appelle Vecteur3D ; Sphere.getNormale s'appelle normaleEn ; Objet3D.getNormale s'appelle normaleEn",
                projet().ecarts.get(Projet.NOMS));
    }

    @Test
    void leTexteDuCorrigeQuiEstSeulEstJugeEtNomme() throws IOException {
        classes("mon projet", SourcesDuCours::corrige, "Sphere", "Scene");
        classes("mon projet", SourcesDuCours::squelette, "Vecteur");
        Projet lu = projet();
        assertEquals(Set.of("Sphere", "Scene"), lu.changees);
        assertTrue(lu.aRegarder.contains(COMME + "Scene.getClosestIntersection, Sphere.getIntersectionDistance"), lu.aRegarder.toString());
    }

    @Test
    void unReelDUneAutreSorteEstLaisseTelQuelEtDesEntiersSeLaissentAppeler() throws IOException {
        String vecteur = "package lancer;\nclass Vecteur {\n    public float dot(Vecteur v) {\n        return dot (v);\n    }\n}\n";
        Projet projet = rendre("lancer", "Vecteur", vecteur, "Lancer", "package lancer;\nclass Lancer {\n"
                + "    public Couleur getCouleurPixel(int xe, int ye, int p) {\n        return null;\n    }\n}\n");
        assertTrue(projet.texte("Lancer").contains("getCouleurPixel(double p0, double p1, int p2) { "
                + "return getCouleurPixel((int) p0, (int) p1, p2); }"), projet.texte("Lancer"));
        assertEquals(vecteur, projet.texte("Vecteur"));
        assertEquals(1, projet.remarques.size(), projet.remarques.toString());
        assertEquals(projet.remarques, projet.aRegarder);
    }

    @Test
    void desParametresEnFloatSeLaissentAppelerAvecDesDoubleEtCEstDitUneFois() throws IOException {
        Projet lu = rendre("lancer",
                "Vecteur", SourcesDuCours.corrige("Vecteur").replace("double", "float"),
                "Couleur", SourcesDuCours.corrige("Couleur").replace("double", "float"));
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
        Map<String, byte[]> entrees = new LinkedHashMap<>();
        for (String paquet : List.of(".tmp.x.y", "..", "a..b", "a.", "a".repeat(300), "java.lang", "lancer.correction.x")) {
            entrees.put("p" + entrees.size() + "/Mal.java", octets("package " + paquet + ";\nclass Mal { }\n"));
        }
        for (String nom : List.of("A\nFIN\n.java", "A\tB.java", " .java", ".java", "A\u202Egpj.java", "b".repeat(200) + ".java",
                "c".repeat(9000) + ".java", "A\u0000.java", "CON .java")) {
            entrees.put(nom, octets("package x; interface Z" + entrees.size() + " {}"));
        }
        entrees.put("lancer/Vecteur (1).java", octets(CLASSE));
        String milliers = IntStream.range(0, 40_000).mapToObj(n -> "class C" + n + "{}\n").collect(Collectors.joining());
        entrees.put("lancer/Milliers.java", octets("package lancer;\n" + milliers));
        entrees.put("lancer/Point.java", octets("package lancer;\n" + milliers + "class Point { }\n"));
        Files.write(Files.createDirectories(rendu).resolve("tp.zip"), zip(entrees));
        // ce que déclare un fichier mal nommé le nomme
        assertEquals("lancer/Vecteur", projet().base.keySet().stream().filter(cle -> !cle.matches("x/Z\\d+|a/Mal"))
                .collect(Collectors.joining(" ")));
    }
}
