package lancer.correction.isolement;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.FutureTask;
import java.util.stream.Collectors;
import lancer.correction.enfant.Echange;
import lancer.correction.enfant.Execution;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledForJreRange;
import org.junit.jupiter.api.condition.JRE;

/** Ce qui tue une machine virtuelle à part, et ce qui ne la tue pas. */
@EnabledForJreRange(min = JRE.JAVA_17)
class EnfantTest {

    private static final Limites LIMITES = new Limites(2, 1, 64);

    /** Répète ce qu'on lui dit, ou fait autre chose de ce qui l'y invite. */
    static final class Echo {

        public static void main(String[] args) throws IOException, InterruptedException {
            DataInputStream entree = new DataInputStream(System.in);
            DataOutputStream sortie = new DataOutputStream(System.out);
            while (true) {
                int numero = entree.readInt();
                byte[] dit = entree.readNBytes(entree.readInt());
                String texte = new String(dit, StandardCharsets.UTF_8);
                Thread.sleep(texte.equals("dort") ? 800 : 0);
                int longueur = texte.equals("trop long") ? Integer.MAX_VALUE : texte.equals("négatif") ? -1 : dit.length;
                for (int k = texte.equals("deux fois") ? 2 : 1; k > 0; k--) {
                    sortie.writeInt(texte.equals("autre numéro") ? numero + 1 : numero);
                    sortie.writeInt(longueur);
                    sortie.write(dit);
                }
                sortie.flush();
            }
        }
    }

    private static Enfant echo(Confinement confinement) throws Exception {
        String classes = new File(Echo.class.getProtectionDomain().getCodeSource().getLocation().toURI()).toString();
        Enfant enfant = new Enfant(confinement.java(Echo.class, classes, true, Path.of("target"), LIMITES), LIMITES, confinement.confine);
        enfant.commencer(LIMITES.calcul);
        return enfant;
    }

    private static byte[] demander(Enfant enfant, String texte) throws Arret, IOException {
        return enfant.demander(texte.getBytes(StandardCharsets.UTF_8), Echange.REPONSE_MAX).readAllBytes();
    }

    private static void repete(Enfant enfant, String texte) throws Arret, IOException {
        assertArrayEquals(texte.getBytes(StandardCharsets.UTF_8), demander(enfant, texte));
    }

    @Test
    void ilSurvitAuFilQuiLADemande() throws Exception {
        Confinement confinement = Confinement.essayer();
        assumeTrue(confinement.confine, confinement.manque);
        FutureTask<Enfant> demande = new FutureTask<>(() -> echo(confinement));
        Thread demandeur = new Thread(demande);
        demandeur.start();
        try (Enfant enfant = demande.get()) {
            repete(enfant, "avant");
            demandeur.join();
            repete(enfant, "après");
        }
    }

    @Test
    void uneReponseEstCelleDeSaDemandeQuoiQuElleContienne() throws Exception {
        try (Enfant enfant = echo(new Confinement(false, ""))) {
            for (String texte : List.of("", "\n\n", "FIN\n", "\t\u0000\u0001", "réponse\tR\t1", "é".repeat(30_000))) {
                repete(enfant, texte);
            }
        }
    }

    @Test
    void ceQuiNEstPasLaReponseAttendueArrete() throws Exception {
        for (String texte : List.of("autre numéro", "trop long", "négatif", "x".repeat(Echange.REPONSE_MAX + 1))) {
            try (Enfant enfant = echo(new Confinement(false, ""))) {
                assertEquals("arrêté : a répondu ce qu'on ne lui demandait pas",
                        assertThrows(Arret.class, () -> demander(enfant, texte)).getMessage(), texte);
            }
        }
        try (Enfant enfant = echo(new Confinement(false, ""))) {
            repete(enfant, "deux fois");
            Arret arret = assertThrows(Arret.class, () -> {
                demander(enfant, "ensuite");
                demander(enfant, "et encore");
            });
            assertEquals("arrêté : a répondu ce qu'on ne lui demandait pas", arret.getMessage());
        }
    }

    @Test
    void sansConfinementUneDureeEstToutCeQuiLimite() throws Exception {
        try (Enfant enfant = new Enfant(List.of("/bin/sleep", "30"), new Limites(0.25, 1, 64), false)) {
            enfant.commencer(0.25);
            assertEquals("arrêté : plus de 1 s, trop long ou sans fin",
                    assertThrows(Arret.class, () -> enfant.demander(new byte[0], 0)).getMessage());
        }
    }

    @Test
    void aCourtDeMemoireLeNoyauTueDAbordCeQuiEstJugeEtSonStatutEstDit() throws Exception {
        Confinement confinement = Confinement.essayer();
        assumeTrue(confinement.confine, confinement.manque);
        try (Enfant enfant = echo(confinement)) {
            repete(enfant, "avant");
            List<ProcessHandle> siens = ProcessHandle.current().descendants().filter(p -> p.info().command().orElse("").endsWith("java")
                    && lire(p, "cmdline").contains(Echo.class.getName())).collect(Collectors.toList());
            assertEquals(1, siens.size());
            assertEquals("1000", lire(siens.get(0), "oom_score_adj").trim());
            // ce que fait le noyau à court de mémoire
            siens.get(0).destroyForcibly();
            Arret arret = assertThrows(Arret.class, () -> demander(enfant, "après"));
            assertEquals("arrêté : s'est arrêté, statut 137", arret.getMessage());
            assertTrue(arret.tue);
        }
    }

    @Test
    void leTempsPasseADormirSAjouteDUneDemandeALAutre() throws Exception {
        Confinement confinement = Confinement.essayer();
        assumeTrue(confinement.confine, confinement.manque);
        try (Enfant enfant = echo(confinement)) {
            repete(enfant, "dort");
            repete(enfant, "dort");
            assertEquals("arrêté : plus de 2 s sans rien faire, bloqué ou endormi", assertThrows(Arret.class, () -> {
                demander(enfant, "dort");
                demander(enfant, "dort");
            }).getMessage());
        }
    }

    private static String lire(ProcessHandle processus, String quoi) {
        try {
            return Files.readString(Path.of("/proc", "" + processus.pid(), quoi), StandardCharsets.ISO_8859_1);
        } catch (IOException e) {
            return "";
        }
    }

    @Test
    void confineNiProgrammeNiRetourSurLOrdreDuNoyau() throws Exception {
        String appel = System.getProperty("os.arch").equals("aarch64") ? "97" : "272";
        assertEquals("-1 non non", confine("/usr/bin/perl", "-e", "print syscall(" + appel + ", 0x10000000), ' ', fork // 'non', ' ', "
                + "(open(my $f, '>', '/proc/self/oom_score_adj') ? 'oui' : 'non')"));
    }

    /** Ce que dit cette commande, dans la boîte où s'exécute un rendu, à la place de Java. */
    private static String confine(String... dedans) throws Exception {
        Confinement confinement = Confinement.essayer();
        assumeTrue(confinement.confine && new File(dedans[0]).canExecute(), confinement.manque);
        String archive = Path.of("pom.xml").toAbsolutePath().toString();
        List<String> java = confinement.java(Echo.class, archive, false, Path.of("target"), LIMITES);
        List<String> commande = new ArrayList<>(java.subList(0, java.lastIndexOf(System.getProperty("java.home") + "/bin/java")));
        commande.addAll(List.of(dedans));
        Process processus = new ProcessBuilder(commande).redirectErrorStream(true).start();
        return new String(processus.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    }

    @Test
    void uneClasseQueJavaRefuseNeCouteQuElle() throws Exception {
        byte[] classe;
        try (InputStream flux = Echo.class.getResourceAsStream("EnfantTest$Echo.class")) {
            classe = flux.readAllBytes();
        }
        String nom = Echo.class.getName();
        String interdit = "java.lang." + "x".repeat(nom.length() - 10);
        byte[] volee = new String(classe, StandardCharsets.ISO_8859_1).replace(nom.replace('.', '/'), interdit.replace('.', '/'))
                .getBytes(StandardCharsets.ISO_8859_1);
        ClassLoader chargeur = new Execution.Classes(Map.of(interdit, volee, nom, classe), getClass().getClassLoader());
        assertSame(chargeur, Class.forName(nom, true, chargeur).getClassLoader());
        assertThrows(ClassNotFoundException.class, () -> Class.forName(interdit, true, chargeur));
    }

    @Test
    void quiNeLitPasSesDemandesNeBloqueQueLui() throws Exception {
        // plus que n'en retient un tube : l'écrire n'attend personne
        Enfant enfant = new Enfant(List.of("/bin/sleep", "30"), LIMITES, true);
        try (enfant) {
            enfant.commencer(1);
            assertTrue(assertThrows(Arret.class, () -> enfant.demander(new byte[1 << 20], 0)).getMessage().contains("bloqué"));
        }
    }
}
