package lancer.correction.jugement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lancer.correction.isolement.Confinement;
import lancer.correction.modele.SourcesDuCours;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledForJreRange;
import org.junit.jupiter.api.condition.JRE;
import org.junit.jupiter.api.io.TempDir;

/** Des rendus qui voudraient empêcher de noter, ou mieux noter qu'ils ne valent ; un rendu ordinaire au milieu d'eux. */
@EnabledForJreRange(min = JRE.JAVA_17)
class HostilesTest extends JuryEssai {

    private static final String SOUSTRACTION = "vecteurs.unVecteurSeSoustrait";

    @TempDir
    Path dossier;
    @TempDir
    Path rendus;

    /** Ceux de {@code hostiles.txt} qui ont ces noms ; deux d'entre eux ont aussi une classe qui cacherait la nôtre. */
    private void ecrireHostiles(Predicate<String> lesquels) throws IOException {
        for (String[] parts : blocs("hostiles.txt")) {
            if (lesquels.test(parts[0])) {
                Path sources = attaque(rendus.resolve(parts[0]), parts[1]);
                if (parts[0].equals("mathematiques")) {
                    ecrire(sources, "Math", "package lancer; class Math { static double abs(double x) { return 0; } }");
                } else if (parts[0].equals("faux-junit")) {
                    ecrire(Files.createDirectories(sources.resolveSibling("org/junit/jupiter/api")), "Assertions",
                            "package org.junit.jupiter.api; public class Assertions { "
                            + "public static <V> V fail(String message) { return null; } "
                            + "public static void assertEquals(Object attendu, Object obtenu, String message) { } }");
                }
            }
        }
    }

    @Test
    void confineUnRenduSansFinOuQuiSArreteOuQuiTricheNEmpechePasDeNoterUnAutre() throws IOException {
        Confinement confinement = Confinement.essayer();
        assumeTrue(confinement.confine, confinement.manque);
        ecrireHostiles(List.of("boucle", "sortie", "falsification")::contains);
        ecrireCorrige(rendus.resolve("ordinaire"));
        Map<String, Resultat> resultats = juger(rendus, confinement, COURTES);
        assertEquals(new TreeSet<>(), ratees(resultats.get("ordinaire")));
        rate(resultats, "boucle", "s de calcul");
        rate(resultats, "sortie", "s'est arrêté, statut 0 (Vecteur.sub)");
        rate(resultats, "falsification", "obtenu : (1.0, 1.0, 1.0)");
    }

    @Tag("long")
    @Test
    void confinesAucunNEmpecheDeNoterLesAutres() throws IOException {
        assumeTrue(Boolean.getBoolean("tests.longs"), "c'est un test long");
        Confinement confinement = Confinement.essayer();
        assumeTrue(confinement.confine, confinement.manque);
        ecrire(ecrireCorrige(rendus.resolve("tout-noir")), "Couleur", SourcesDuCours.corrige("Couleur")
                .replaceAll("this\\.([rvb]) = \\1;", "this.$1 = 0;"));
        ecrireHostiles(nom -> true);
        attaque(rendus.resolve("fils-sans-fin"), "for (int k = 0; k < 9000; k++) new Thread(() -> { try { Thread.sleep(99999); } "
                + "catch (InterruptedException e) { } }).start();");
        attaque(rendus.resolve("message"), "throw new RuntimeException() { public String getMessage() { while (true) { } } };");
        attaque(rendus.resolve("pile"),
                "throw new RuntimeException() { public StackTraceElement[] getStackTrace() { throw new Error(); } };");
        ecrire(ecrireCorrige(rendus.resolve("java-lang")), "Deux", "p\\u0061ckage java.lang;\npublic cl\\u0061ss Deux { }\n");
        // dans chacune, une table de 15 000 méthodes : des classes qu'une machine ne peut prendre
        Path classes = ecrireCorrige(rendus.resolve("classes"));
        ecrire(classes, "A", "package lancer; class A { " + repeter(15_000, "void m%d() {}") + "}");
        for (int k = 0; k < 19; k++) {
            ecrire(classes, "B" + k + "x", "package lancer;\n" + repeter(99, "class B" + k + "x%d extends A {}\n"));
        }
        ecrireCorrige(rendus.resolve("ordinaire"));
        // remplir la mémoire, ou la sortie, demande du calcul, et plus encore sur une machine chargée
        Path gourmands = Files.createDirectories(dossier.resolve("gourmands"));
        for (String nom : List.of("memoire", "memoire-native")) {
            Files.move(rendus.resolve(nom), gourmands.resolve(nom));
        }
        Map<String, Resultat> resultats = juger(rendus, confinement, COURTES);
        assertEquals(new TreeSet<>(List.of(rendus.toFile().list())), new TreeSet<>(resultats.keySet()), "une ligne chacun");
        // là où la mémoire suffit, elles se chargent : ailleurs, le noyau tue ce rendu
        resultats.remove("classes");
        resultats.putAll(juger(gourmands, confinement, PATIENTES));

        assertEquals(new TreeSet<>(), ratees(resultats.get("ordinaire")));
        assertTrue(imageJuste(resultats.get("ordinaire")));
        rate(resultats, "imprime", "a répondu ce qu'on ne lui demandait pas");
        rate(resultats, "boucle", "s de calcul");
        rate(resultats, "interblocage", "bloqué");
        rate(resultats, "sortie", "s'est arrêté, statut 0 (Vecteur.sub)");
        rate(resultats, "memoire", "s'est arrêté, statut 3");
        rate(resultats, "memoire-native", "OutOfMemoryError");
        rate(resultats, "processus", "Operation not permitted");
        rate(resultats, "fils-sans-fin", "lance sans fin des fils");
        rate(resultats, "message", "s de calcul");
        rate(resultats, "pile", "s'est arrêté, statut");
        rate(resultats, "mathematiques", "obtenu : (1.0, 1.0, 1.0)");
        rate(resultats, "falsification", "obtenu : (1.0, 1.0, 1.0)");
        rate(resultats, "faux-junit", "obtenu : (1.0, 1.0, 1.0)");
        assertTrue(resultats.get("faux-junit").remarques.stream().anyMatch(r -> r.contains("org/junit/jupiter/api/Assertions.java")),
                resultats.get("faux-junit").remarques.toString());
        assertEquals(new TreeSet<>(List.of(GrilleDeNotation.IMAGE, "vecteurs")), ratees(resultats.get("tout-noir")),
                "une Couleur qui confond toutes les couleurs ne rend pas égales l'attendue et l'obtenue");
        assertFalse(imageJuste(resultats.get("tout-noir")));
        assertEquals(Verdict.Etat.REUSSI, resultats.get("fils").verdicts.get(SOUSTRACTION).etat,
                "des fils laissés ne changent pas le résultat");
        for (String nom : List.of("disque", "processus", "imprime", "boucle", "sortie", "memoire", "memoire-native")) {
            assertEquals(Verdict.Etat.REUSSI,
                    resultats.get(nom).verdicts.get("vecteurs.leProduitScalaireAjouteLesProduitsDesComposantes").etat,
                    nom + " ne coûte pas les autres vérifications");
        }
        assertEquals(Verdict.Etat.REUSSI, resultats.get("java-lang").verdicts.get(SOUSTRACTION).etat);
        resultats.forEach((nom, resultat) -> {
            assertFalse(resultat.nonCorrige, nom + " : " + resultat.refus);
            assertEquals(List.of(), resultat.refus, nom);
        });
    }

    /** Deux témoins : l'un achevé, l'autre qui a une faute. */
    private static Path temoins(Path rendus) throws IOException {
        ecrireCorrige(rendus.resolve("acheve"));
        changer(ecrireCorrige(rendus.resolve("fautif")), "Vecteur", "x * v.x + y", "x * v.x - y");
        return rendus;
    }

    private static Map<String, String> etats(Resultat resultat) {
        Map<String, String> etats = new TreeMap<>();
        resultat.verdicts.forEach((id, verdict) -> etats.put(id, verdict.etat + " " + verdict.message));
        etats.put("refus", resultat.refus.toString());
        return etats;
    }

    /** Ce qu'un rendu porte dans ses noms, ses réponses ou ses archives ne change rien au résultat des autres. */
    @Tag("long")
    @Test
    void niLesNomsNiLesReponsesNiLesArchivesNeChangentRienAuxTemoins() throws IOException {
        assumeTrue(Boolean.getBoolean("tests.longs"), "c'est un test long");
        Confinement confinement = Confinement.essayer();
        assumeTrue(confinement.confine, confinement.manque);
        Map<String, Resultat> attendus = juger(temoins(dossier.resolve("seuls")), confinement, PATIENTES);
        temoins(rendus);
        // sans rien qu'un nom de paquet n'ait : ce serait bien un chemin, à son point près
        Path evade = Files.createTempDirectory("evade").resolve("x");
        ecrire(ecrireCorrige(rendus.resolve("paquet")), "Evade", "package " + evade.toString().replace('/', '.')
                + ";\npublic class Evade { }\n");
        ecrire(ecrireCorrige(rendus.resolve("fin")), "A\nFIN\nFAUTE\tB", "package lancer; class A { int f() { return x; } }");
        ecrire(ecrireCorrige(rendus.resolve("tabulation")), "A\tB", "package lancer; class A { int f() { return x; } }");
        ecrire(sources(rendus.resolve("emboitees")), "Vecteur", "package lancer; class Vecteur {" + "class A {".repeat(2000)
                + "}".repeat(2001));
        ecrire(sources(rendus.resolve("milliers")), "Vecteur", SourcesDuCours.corrige("Vecteur") + "class Z {}\n".repeat(40_000));
        ecrire(sources(rendus.resolve("parentheses")), "Vecteur", SourcesDuCours.corrige("Vecteur")
                .replaceFirst("return new Vecteur\\(x \\+", "return new Vecteur(" + "(".repeat(20_000) + "x +"));
        ecrireHostiles(List.of("avance", "sans-retour", "curieux", "ecrit")::contains);
        ecrireCorrige(rendus.resolve("liens"));
        Files.createSymbolicLink(rendus.resolve("liens/Secret.java"), Path.of("/etc/passwd"));
        Files.createSymbolicLink(rendus.resolve("liens/racine"), Path.of("/"));
        Map<String, Resultat> resultats = juger(rendus, confinement, PATIENTES);
        for (String temoin : attendus.keySet()) {
            assertEquals(etats(attendus.get(temoin)), etats(resultats.get(temoin)), temoin);
        }
        assertFalse(Files.exists(evade));
        rate(resultats, "avance", "arrêté : a répondu");
        assertTrue(resultats.get("avance").aRegarder.toString().contains("arrêté : a répondu"), "cela se voit à l'index");
        assertTrue(resultats.get("paquet").aRegarder.toString().contains(" : laissé de côté, "));
        String vu = resultats.get("curieux").verdicts.get(SOUSTRACTION).message;
        assertTrue(vu.contains("vu{") && !vu.contains(rendus.getFileName().toString()), vu);
        for (String nom : List.of("paquet", "fin", "tabulation", "liens", "ecrit")) {
            assertEquals(new TreeSet<>(), ratees(resultats.get(nom)), nom + " est par ailleurs achevé, et rien ne s'y écrit");
        }
        resultats.forEach((nom, resultat) -> assertFalse(resultat.nonCorrige, nom + " : " + resultat.refus));
    }

    /** Ceux dont le confinement n'est pas ce qui les arrête : il faut juger le corrigé une fois de plus. */
    @Tag("long")
    @Test
    void sansConfinementNonPlus() throws IOException {
        assumeTrue(Boolean.getBoolean("tests.longs"), "c'est un test long");
        List<String> noms = List.of("mathematiques", "falsification", "faux-junit");
        ecrireHostiles(noms::contains);
        Map<String, Resultat> resultats = juger(rendus, new Confinement(false, ""), COURTES);
        for (String nom : noms) {
            rate(resultats, nom, "obtenu : (");
        }
    }

    /** Écrites sur la sortie à la place de l'image, sous le numéro de sa demande : une liste sans texte, des listes l'une dans l'autre. */
    @Test
    void uneReponseForgeeNeCouteQueLImage() throws IOException {
        for (String[] forge : new String[][] {{"sans-texte", "13", "s.writeBytes(\"l\\0\\0\\0\\3t\\0\\0\\0\\1Enn\");"},
            {"emboitees", "500000", "for (int k = 0; k < 100000; k++) s.writeBytes(\"l\\0\\0\\0\\1\");"}}) {
            Path sources = ecrireCorrige(rendus.resolve(forge[0]));
            changer(sources, "Lancer", "this.scene = scene;", "this.scene = scene;\n"
                    + "for (StackTraceElement e : new Throwable().getStackTrace()) if (e.getMethodName().equals(\"dessiner\")) try {\n"
                    + "java.io.ByteArrayOutputStream o = new java.io.ByteArrayOutputStream();\n"
                    + "java.io.DataOutputStream s = new java.io.DataOutputStream(o); s.writeInt(3); s.writeInt(" + forge[1] + "); "
                    + forge[2]
                    + "\no.writeTo(new java.io.FileOutputStream(java.io.FileDescriptor.out)); } catch (java.io.IOException x) { }\n");
        }
        Map<String, Resultat> resultats = juger(rendus, Confinement.essayer(), PATIENTES);
        resultats.forEach((nom, resultat) -> {
            assertEquals(new TreeSet<>(List.of(GrilleDeNotation.IMAGE)), ratees(resultat), nom);
            assertEquals("arrêté : a répondu ce qui n'a pas de sens", resultat.verdicts.get("image.scene1").message, nom);
        });
    }

    private static String repeter(int combien, String texte) {
        return IntStream.range(0, combien).mapToObj(k -> String.format(texte, k)).collect(Collectors.joining());
    }

    @Test
    void unRenduQuiDureTropEnToutEstRefuse() throws IOException {
        ecrireCorrige(rendus.resolve("un"));
        ecrireCorrige(rendus.resolve("deux"));
        Confinement confinement = Confinement.essayer();
        Jury jury = JuryPartage.de(confinement);
        int dureeMax = jury.dureeMax;
        jury.dureeMax = 0;
        Resultat resultat = juger(rendus, confinement, PATIENTES).get("un");
        jury.dureeMax = dureeMax;
        assertFalse(resultat.nonCorrige, "ce n'est pas une panne");
        assertEquals(List.of("arrêté : plus de 0 s en tout"), resultat.refus);
    }

    private static void rate(Map<String, Resultat> resultats, String nom, String message) {
        Verdict verdict = resultats.get(nom).verdicts.get(SOUSTRACTION);
        assertEquals(Verdict.Etat.FAUSSE, verdict.etat, nom + " : " + verdict.message);
        assertTrue(verdict.message.contains(message), nom + " : " + verdict.message);
    }
}
