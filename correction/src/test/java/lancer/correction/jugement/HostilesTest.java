package lancer.correction.jugement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.correction.isolement.Confinement;
import lancer.correction.isolement.Limites;
import lancer.correction.modele.Modele;
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

    @Test
    void confinesAucunNEmpecheDeNoterLesAutres() throws IOException {
        Confinement confinement = Confinement.essayer();
        assumeTrue(confinement.confine, confinement.manque);
        verifier(confinement);
    }

    @Test
    void sansConfinementNonPlus() throws IOException {
        verifier(new Confinement(false, ""));
    }

    private void verifier(Confinement confinement) throws IOException {
        Path rendus = Files.createDirectories(dossier.resolve("rendus"));
        ecrireCorrige(rendus.resolve("tout-noir"));
        try (Stream<Path> flux = Files.list(RENDUS.resolve("hostiles"))) {
            for (Path hostile : flux.collect(Collectors.toList())) {
                copier(hostile.resolve("Étudiant 1_101_assignsubmission_file"), rendus.resolve(hostile.getFileName().toString()));
            }
        }
        ecrireCorrige(rendus.resolve("ordinaire"));
        // remplir la mémoire, ou la sortie, demande du calcul, et plus encore sur une machine chargée
        Path gourmands = Files.createDirectories(dossier.resolve("gourmands"));
        for (String nom : List.of("memoire", "memoire-native")) {
            Files.move(rendus.resolve(nom), gourmands.resolve(nom));
        }
        Map<String, Resultat> resultats = juger(rendus, confinement, COURTES);
        assertEquals(new TreeSet<>(List.of(rendus.toFile().list())), new TreeSet<>(resultats.keySet()), "une ligne chacun");
        resultats.putAll(juger(gourmands, confinement, PATIENTES));

        assertEquals(new TreeSet<>(), ratees(resultats.get("ordinaire")));
        assertTrue(imageJuste(resultats.get("ordinaire")));
        rate(resultats, "imprime", "s de calcul");
        rate(resultats, "recursion", "appels sans fin");
        rate(resultats, "boucle", "s de calcul");
        rate(resultats, "interblocage", "bloqué");
        rate(resultats, "sortie", "arrêté de lui-même");
        rate(resultats, "memoire", "mémoire épuisée");
        rate(resultats, "memoire-native", "mémoire épuisée");
        rate(resultats, "imitation", "obtenu : (1.0, 1.0, 1.0)");
        rate(resultats, "balises", "<script>alert(1)</script>");
        assertTrue(resultats.get("mathematiques").remarques.stream().anyMatch(r -> r.contains("classe Math qui cacherait")),
                resultats.get("mathematiques").remarques.toString());
        rate(resultats, "mathematiques", "obtenu : (1.0, 1.0, 1.0)");
        rate(resultats, "falsification", "obtenu : (1.0, 1.0, 1.0)");
        rate(resultats, "faux-junit", "obtenu : (1.0, 1.0, 1.0)");
        assertTrue(resultats.get("faux-junit").remarques.stream().anyMatch(r -> r.contains("org/junit/jupiter/api/Assertions.java")),
                resultats.get("faux-junit").remarques.toString());
        assertEquals(Verdict.Etat.RATE, resultats.get("tout-noir").verdicts.get("lambert.faceALaLampeLaCouleurEstKd").etat,
                "une Couleur qui confond toutes les couleurs ne rend pas égales l'attendue et l'obtenue");
        assertFalse(imageJuste(resultats.get("tout-noir")));
        assertEquals(Verdict.Etat.REUSSI, resultats.get("fils").verdicts.get(SOUSTRACTION).etat,
                "des fils laissés ne changent pas le résultat");
        for (String nom : List.of("disque", "processus", "imprime", "boucle", "sortie", "memoire", "memoire-native")) {
            assertEquals(Verdict.Etat.REUSSI,
                    resultats.get(nom).verdicts.get("vecteurs.leProduitScalaireAjouteLesProduitsDesComposantes").etat,
                    nom + " ne coûte pas les autres vérifications");
        }
    }

    /** Trois témoins : l'un achevé, l'un qui a une faute, l'un qui n'a rien commencé. */
    private void temoins(Path rendus) throws IOException {
        ecrireCorrige(rendus.resolve("acheve"));
        ecrire(ecrireCorrige(rendus.resolve("fautif")), "Vecteur", Modele.corrige("Vecteur").replace("x * v.x + y", "x * v.x - y"));
        for (String classe : Modele.A_COMPLETER) {
            ecrire(Files.createDirectories(rendus.resolve("vide/src/lancer")), classe, Modele.squelette(classe));
        }
    }

    private static void ecrire(Path dossier, String classe, String texte) throws IOException {
        Files.write(dossier.resolve(classe + ".java"), texte.getBytes(StandardCharsets.UTF_8));
    }

    /** Un rendu achevé, dont la soustraction fait d'abord ceci. */
    private static Path attaque(Path rendu, String java) throws IOException {
        Path sources = ecrireCorrige(rendu);
        ecrire(sources, "Vecteur", Modele.corrige("Vecteur").replaceFirst("(public Vecteur sub\\(Vecteur v\\) \\{)",
                "$1 " + Matcher.quoteReplacement("if (true) { " + java + " }")));
        return sources;
    }

    private static Map<String, String> etats(Resultat resultat) {
        Map<String, String> etats = new TreeMap<>();
        resultat.verdicts.forEach((id, verdict) -> etats.put(id, verdict.etat + " " + verdict.message));
        etats.put("refus", resultat.refus.toString());
        return etats;
    }

    @Test
    void niLesNomsNiLesReponsesNiLesArchivesNeChangentRienAuxTemoins() throws IOException {
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
        ecrire(ecrireCorrige(rendus.resolve("emboitees")), "Vecteur", "package lancer; class Vecteur {" + "class A {".repeat(2000)
                + "}".repeat(2001));
        ecrire(ecrireCorrige(rendus.resolve("milliers")), "Vecteur", Modele.corrige("Vecteur") + "class Z {}\n".repeat(40_000));
        ecrire(ecrireCorrige(rendus.resolve("parentheses")), "Vecteur", Modele.corrige("Vecteur").replaceFirst("return new Vecteur\\(x \\+",
                "return new Vecteur(" + "(".repeat(20_000) + "x +"));
        String sortie = "try { java.lang.reflect.Field f = java.io.FileDescriptor.class.getDeclaredField(\"fd\"); f.setAccessible(true);"
                + " java.io.FileDescriptor un = new java.io.FileDescriptor(); f.setInt(un, 1);"
                + " java.io.DataOutputStream s = new java.io.DataOutputStream(new java.io.FileOutputStream(un));";
        attaque(rendus.resolve("brut"), sortie + " s.writeBytes(\"REUSSI\\n\"); } catch (Exception e) { }");
        attaque(rendus.resolve("avance"), sortie + " for (int k = 0; k < 99; k++) { s.writeInt(k); s.writeInt(2); s.writeChar('R'); } }"
                + " catch (Exception e) { }");
        attaque(rendus.resolve("demesure"), sortie + " for (int k = 0; k < 9; k++) { s.writeInt(k); s.writeInt(40 << 20); } } "
                + "catch (Exception e) { }");
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
        for (String nom : List.of("brut", "avance", "demesure")) {
            String dit = resultats.get(nom).verdicts.get(SOUSTRACTION).message;
            assertTrue(dit.startsWith("arrêté : a répondu"), nom + " : " + dit);
            assertTrue(resultats.get(nom).aRegarder.toString().contains("arrêté : a répondu"), nom + " se voit à l'index");
        }
        assertTrue(resultats.get("paquet").aRegarder.toString().contains("arrêté : "), resultats.get("paquet").aRegarder.toString());
        Resultat curieux = resultats.get("curieux");
        String vu = curieux.verdicts.get(SOUSTRACTION).message;
        assertTrue(vu.contains("vu{") && Stream.of(dossier, travail).noneMatch(lieu -> vu.contains(lieu.getFileName().toString())), vu);
        assertEquals(new TreeSet<>(), ratees(resultats.get("ecrit")), "rien ne s'y écrit");
        for (String nom : List.of("paquet", "fin", "tabulation", "liens")) {
            assertEquals(new TreeSet<>(), ratees(resultats.get(nom)), nom + " est par ailleurs achevé");
        }
        resultats.forEach((nom, resultat) -> assertFalse(resultat.nonCorrige, nom + " : " + resultat.refus));
    }

    @Test
    void unRenduQuiPrendToutLeTempsDuCorrecteurNEstPasCorrigeEtRienNEnEstRetenu() throws IOException {
        Path rendus = Files.createDirectories(dossier.resolve("rendus"));
        ecrireCorrige(rendus.resolve("un"));
        Path travail = Files.createDirectories(dossier.resolve("travail"));
        List<Resultat> resultats = new ArrayList<>();
        for (Limites limites : List.of(new Limites(10, 60, 160, 0), PATIENTES)) {
            try (Jury jury = new Jury(travail, new Confinement(false, ""), limites)) {
                resultats.add(juger(jury, rendus, travail).get("un"));
            }
        }
        assertTrue(resultats.get(0).nonCorrige);
        assertTrue(resultats.get(0).refus.get(0).startsWith("non corrigé : arrêté : plus de 0 s"), resultats.get(0).refus.toString());
        Resultat ensuite = resultats.get(1);
        assertFalse(ensuite.nonCorrige);
        assertEquals(new TreeSet<>(), ratees(ensuite));
    }

    private static void rate(Map<String, Resultat> resultats, String nom, String message) {
        Verdict verdict = resultats.get(nom).verdicts.get(SOUSTRACTION);
        assertEquals(Verdict.Etat.RATE, verdict.etat, nom + " : " + verdict.message);
        assertTrue(verdict.message.contains(message), nom + " : " + verdict.message);
    }
}
