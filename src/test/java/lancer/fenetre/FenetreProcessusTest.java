package lancer.fenetre;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.EventQueue;
import java.awt.Frame;
import java.awt.event.KeyEvent;
import java.awt.event.WindowEvent;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lancer.Main;
import lancer.essai.Essai;
import lancer.essai.EssaiProcessus;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Un programme dont la fenêtre s'ouvre, dans sa machine virtuelle : arrêté pendant qu'il dessine, ou mal installé. */
@Tag("fenetre")
@Timeout(900)
class FenetreProcessusTest extends EssaiProcessus {

    @Test
    void ctrlCFenetreOuverteRend130() throws Exception {
        EssaiFenetre.exigerEcran();
        verifierCtrlC("--taille=400x300", SCENE);
    }

    @Test
    void fermerLaFenetrePendantLeDessinFinitLeProgrammeSansRienDireEtLesTouchesYSontEnFrancais() throws Exception {
        EssaiFenetre.exigerEcran();
        List<String> commande = java("-Duser.language=en", "--taille=1200x700", "--reflets=1000", "--seuil=0", SCENE);
        int classe = commande.indexOf("lancer.Main");
        commande.set(classe, FermerEnDessinant.class.getName());
        commande.set(classe - 1, commande.get(classe - 1) + File.pathSeparator + Essai.origine(FenetreProcessusTest.class));
        assertEquals(0, statut(preparer(commande)), erreur());
        assertEquals("", erreur());
        assertEquals("Page suivante", sortie().trim());
        verifierDossier();
    }

    @Test
    void uneClasseDAccessibiliteAbsenteNEstPasUnEcranAbsent() throws Exception {
        EssaiFenetre.exigerEcran();
        assertEquals(1, statut(preparer(java("-Djavax.accessibility.assistive_technologies=absente.Classe", SCENE))));
        assertTrue(erreur().contains("absente.Classe") && !erreur().contains("pas d'écran"), erreur());
        assertEquals(1, erreur().split("\n").length, erreur());
    }

    /** Aucune fenêtre n'est faite : rien d'autre ne s'écrit que cette ligne, et le statut est 1. */
    @Test
    void sansPolicesUneLigneNommeLesPaquets() throws Exception {
        EssaiFenetre.exigerEcran();
        File polices = new File("/usr/lib/x86_64-linux-gnu/libfontconfig.so.1");
        assumeTrue(polices.exists() && new File("/usr/bin/bwrap").exists(), "ni fontconfig à cacher, ni bwrap");
        List<String> commande = new ArrayList<>(Arrays.asList("bwrap", "--dev-bind", "/", "/", "--bind", "/dev/null",
                polices.getCanonicalPath()));
        commande.addAll(java("", SCENE));
        assertEquals(1, statut(preparer(commande)));
        assertTrue(erreur().matches("lancer : pas de polices .* les paquets fontconfig et fonts-dejavu-core, ou --image FICHIER.png\n"),
                erreur());
    }

    @Test
    void unEcranDeTrenteBitsEstDitTel() throws Exception {
        assumeTrue(new File("/usr/bin/Xvfb").exists() && new File("/usr/bin/xvfb-run").exists(), "pas de Xvfb");
        List<String> commande = new ArrayList<>(Arrays.asList("xvfb-run", "-a", "-s", "-screen 0 640x480x30"));
        commande.addAll(java("", SCENE));
        assertEquals(1, statut(preparer(commande)));
        assertTrue(erreur().matches("lancer : écran de 30 bits, .* attendu : un écran de 24 bits, ou --image FICHIER.png\n"), erreur());
    }

    @Test
    void unUtilisateurSansDossierNEnAPasUnDeCeNom() throws Exception {
        EssaiFenetre.exigerEcran();
        processus = preparer(java("-Duser.home=?", "--statistiques", "--taille=32x24", SCENE)).start();
        attendre(() -> sortie().contains("trace.ms") || !processus.isAlive());
        assertTrue(processus.isAlive(), erreur());
        assertEquals(Arrays.asList("flux"), Arrays.asList(dossier.toFile().list()));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", ":98765"})
    void sansEcranUneLigneProposeDeSePasserDeFenetre(String affichage) throws Exception {
        // ailleurs qu'avec X11, l'écran ne se cache pas par une variable, et une fenêtre s'ouvrirait
        assumeTrue(System.getProperty("os.name").equals("Linux"), "pas un Linux");
        ProcessBuilder programme = preparer(java("", SCENE));
        programme.environment().put("DISPLAY", affichage);
        assertEquals(1, statut(programme));
        assertTrue(erreur().matches("lancer : .*--image.*\\R"), erreur());
    }

    /** Le même Java, sans la bibliothèque qui ouvre des fenêtres sous X11, que certains paquets n'ont pas. */
    @Test
    void unJavaSansFenetresDevantUnEcranLeDitAuLieuDeNierLEcran() throws Exception {
        EssaiFenetre.exigerEcran();
        Path vrai = Paths.get(System.getProperty("java.home")).toRealPath();
        assumeTrue(Files.exists(vrai.resolve("lib/libawt_xawt.so")), "pas un Java de Linux");
        Path java = dossier.resolve("java");
        Files.createDirectories(java.resolve("lib/server"));
        Files.createDirectories(java.resolve("bin"));
        Files.copy(vrai.resolve("bin/java"), java.resolve("bin/java"));
        Path classes = Files.createSymbolicLink(java.resolve("lib/modules"), vrai.resolve("lib/modules"));
        for (String ou : new String[] {"lib", "lib/server"}) {
            for (File f : vrai.resolve(ou).toFile().listFiles()) {
                // Java cherche ses bibliothèques à côté d'elles-mêmes, et non de leurs liens
                if (f.getName().matches("(?!libawt_xawt).*\\.(so|cfg|dat)")) {
                    Files.copy(f.toPath(), java.resolve(ou).resolve(f.getName()));
                }
            }
        }
        List<String> commande = java("", SCENE);
        commande.set(0, java.resolve("bin/java").toString());
        assertEquals(1, statut(preparer(commande)));
        Files.delete(classes);
        assertTrue(erreur().matches("lancer : impossible d'ouvrir une fenêtre : .*default-jdk.*--image.*\\R"), erreur());
    }

    /** Le programme, dont la fenêtre est fermée comme par la croix dès que l'image s'y dessine. */
    static final class FermerEnDessinant {

        private FermerEnDessinant() {
        }

        public static void main(String[] args) throws Exception {
            Main.main(args);
            while (!EssaiFenetre.vivent("lancer-1")) {
                Thread.sleep(1);
            }
            Frame fenetre = Frame.getFrames()[0];
            System.out.println(KeyEvent.getKeyText(KeyEvent.VK_PAGE_DOWN));
            // la croix se clique dans le fil des événements
            EventQueue.invokeAndWait(() -> fenetre.dispatchEvent(new WindowEvent(fenetre, WindowEvent.WINDOW_CLOSING)));
        }
    }
}
