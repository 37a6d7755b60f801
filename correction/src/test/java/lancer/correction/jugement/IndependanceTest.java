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
import lancer.correction.isolement.Confinement;
import lancer.correction.modele.SourcesDuCours;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledForJreRange;
import org.junit.jupiter.api.condition.JRE;
import org.junit.jupiter.api.io.TempDir;

/** Ce qu'un rendu porte dans ses noms, ses réponses ou ses archives ne change rien au résultat des autres. */
@EnabledForJreRange(min = JRE.JAVA_17)
class IndependanceTest extends JuryEssai {

    private static final String SOUSTRACTION = "vecteurs.unVecteurSeSoustrait";

    @TempDir
    Path dossier;

    /** Deux témoins : l'un achevé, l'autre qui a une faute. */
    private void temoins(Path rendus) throws IOException {
        ecrireCorrige(rendus.resolve("acheve"));
        ecrire(ecrireCorrige(rendus.resolve("fautif")), "Vecteur", SourcesDuCours.corrige("Vecteur").replace("x * v.x + y", "x * v.x - y"));
    }

    private static Map<String, String> etats(Resultat resultat) {
        Map<String, String> etats = new TreeMap<>();
        resultat.verdicts.forEach((id, verdict) -> etats.put(id, verdict.etat + " " + verdict.message));
        etats.put("refus", resultat.refus.toString());
        return etats;
    }

    @Tag("long")
    @Test
    void niLesNomsNiLesReponsesNiLesArchivesNeChangentRienAuxTemoins() throws IOException {
        assumeTrue(Boolean.getBoolean("tests.longs"), "c'est un test long");
        Confinement confinement = Confinement.essayer();
        assumeTrue(confinement.confine, confinement.manque);
        Path seuls = Files.createDirectories(dossier.resolve("seuls"));
        temoins(seuls);
        Map<String, Resultat> attendus = juger(seuls, confinement, PATIENTES);
        Path rendus = Files.createDirectories(dossier.resolve("rendus"));
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
        attaque(rendus.resolve("avance"), "try { java.io.DataOutputStream s = new java.io.DataOutputStream("
                + "new java.io.FileOutputStream(java.io.FileDescriptor.out)); for (int k = 0; k < 99; k++) { "
                + "s.writeInt(k); s.writeInt(2); s.writeChar('R'); } } catch (Exception e) { }");
        attaque(rendus.resolve("sans-retour"), "throw new Error(\"Unresolved compilation problem: \\n\\tThe method \" + \"from the type "
                + "refers to in the type \".repeat(20_000));");
        attaque(rendus.resolve("curieux"), "StringBuilder t = new StringBuilder(\"vu\"); for (String c : new String[] {"
                + "\"/lancer/Objet3D.class\", \"/lancer/Vecteur.class\", \"/modele/lancer/Vecteur.java\"}) "
                + "if (Vecteur.class.getResource(c) != null) t.append(c); for (String f : new String[] {\"/proc/1/cmdline\", "
                + "\"/proc/self/mountinfo\", \"/proc/self/environ\", \"/etc/passwd\", \"/home\", \"/root\", \"/work\"})"
                + "if (new java.io.File(f).exists()) t.append(f); t.append(System.getProperties()).append(System.getenv());"
                + " throw new IllegalStateException(t.toString().replace('\\n', ' '));");
        attaque(rendus.resolve("ecrit"), "for (String f : new String[] {\"/a\", \"/dev/shm/a\", \"/usr/a\", \"/proc/a\", \"/boite.jar\"})"
                + "try { java.nio.file.Files.write(java.nio.file.Paths.get(f), new byte[9]); throw new IllegalStateException(f); }"
                + "catch (java.io.IOException e) { }");
        ecrireCorrige(rendus.resolve("liens"));
        Files.createSymbolicLink(rendus.resolve("liens/Secret.java"), Path.of("/etc/passwd"));
        Files.createSymbolicLink(rendus.resolve("liens/racine"), Path.of("/"));
        Map<String, Resultat> resultats = juger(rendus, confinement, PATIENTES);
        for (String temoin : attendus.keySet()) {
            assertEquals(etats(attendus.get(temoin)), etats(resultats.get(temoin)), temoin);
        }
        assertFalse(Files.exists(evade));
        String dit = resultats.get("avance").verdicts.get(SOUSTRACTION).message;
        assertTrue(dit.startsWith("arrêté : a répondu"), dit);
        assertTrue(resultats.get("avance").aRegarder.toString().contains("arrêté : a répondu"), "cela se voit à l'index");
        assertTrue(resultats.get("paquet").aRegarder.toString().contains(" : laissé de côté, "));
        Resultat curieux = resultats.get("curieux");
        String vu = curieux.verdicts.get(SOUSTRACTION).message;
        assertTrue(vu.contains("vu{") && !vu.contains(dossier.getFileName().toString()), vu);
        for (String nom : List.of("paquet", "fin", "tabulation", "liens", "ecrit")) {
            assertEquals(new TreeSet<>(), ratees(resultats.get(nom)), nom + " est par ailleurs achevé, et rien ne s'y écrit");
        }
        resultats.forEach((nom, resultat) -> assertFalse(resultat.nonCorrige, nom + " : " + resultat.refus));
    }
}
