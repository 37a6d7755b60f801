package lancer.dessin;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.locks.LockSupport;
import lancer.essai.Essai;
import lancer.essai.EssaiProcessus;
import lancer.essai.Modification;
import lancer.fils.Equipe;
import lancer.fils.Fil;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Une classe qui ne rend jamais la main : après dix secondes, le programme dit où, une fois, et continue. */
@Timeout(120)
class SansFinTest extends EssaiProcessus {

    private static final String LA_SCENE = Paths.get("scenes/scene1.ini").toAbsolutePath().toString();
    private static final String DUREE = " : ce calcul dure depuis dix secondes (lancer.";

    /** Sans fin, et sourd à l'arrêt ; sans prendre de processeur aux autres essais. */
    private static final String SANS_FIN = "try { Thread.sleep(600_000); } catch (InterruptedException e) { /* sourd */ }";

    /** La classe, le texte qu'elle change, ce qui le précède, une option, et ce que le programme nomme. */
    private static final String[][] CAS = {
        {"Sphere", "double k = 1 / rayon;", "rayon > 0", "--fils=2", "pixel \\d+, \\d+"},
        {"Sphere", "double k = 1 / rayon;", "rayon > 0", "--pixel=200,150", "pixel 200, 150"},
        {"Sphere", "double k = 1 / rayon;", "rayon > 0", "--vue=normales", "pixel \\d+, \\d+"},
        {"Camera", "Point ecran", "xe > 0", "--simple", "pixel \\d+, \\d+"},
        {"Main", "dessin.getImage().drawPixel", "xe > 0", "--fils=1", "pixel \\d+, \\d+"},
        {"Lampe", "return position;", "position != null", "--fils=1", "préparation"},
        {"Sphere", "this.centre = centre;", "rayon > 0", "--fils=1", "lecture"},
        {"Objet3D", "Vecteur V = incident.getV();", "profondeur > 0", "--auto=erreur=2", "pixel \\d+, \\d+"}};

    /** Les cas se jugent ensemble : chacun attend dix secondes. */
    @Test
    void leProgrammeNommeUneFoisLaLigneQuiLeRetientEtContinue() throws Exception {
        Path attendue = dossier.resolve("attendue.png");
        assertEquals(0, Essai.executer("--taille=40x30", "--image", attendue.toString(), LA_SCENE).code);
        List<Callable<Void>> essais = new ArrayList<>();
        essais.add(() -> essayerUnPixelLent(attendue));
        essais.add(SansFinTest::seulLeFilRetenuEstNomme);
        for (String[] cas : CAS) {
            Path sien = Files.createDirectories(dossier.resolve("cas" + essais.size()));
            essais.add(() -> essayer(sien, cas));
        }
        ExecutorService fils = Executors.newFixedThreadPool(essais.size());
        try {
            for (Future<Void> essai : fils.invokeAll(essais)) {
                essai.get();
            }
        } finally {
            fils.shutdownNow();
        }
    }

    private static Void essayer(Path dossier, String[] cas) throws Exception {
        Modification.de(dossier, cas[0], cas[1], "while (" + cas[2] + ") { " + SANS_FIN + " } " + cas[1]).close();
        Path image = dossier.resolve("i.png");
        List<String> commande = cas[3].startsWith("--pixel") ? java("", "--taille=400x300", cas[3], LA_SCENE)
                : java("", "--taille=400x300", cas[3], "--image", image.toString(), LA_SCENE);
        int chemin = commande.indexOf("-cp") + 1;
        commande.set(chemin, dossier.resolve("classes") + File.pathSeparator + commande.get(chemin));
        Path erreur = dossier.resolve("erreur");
        Process programme = new ProcessBuilder(commande).redirectError(erreur.toFile())
                .redirectOutput(dossier.resolve("sortie").toFile()).start();
        try {
            attendre(() -> Files.size(erreur) > 0 || !programme.isAlive());
            assertTrue(programme.isAlive(), cas[0] + " " + cas[3] + " : le programme continue");
        } finally {
            programme.destroy();
            programme.waitFor();
        }
        List<String> dit = Files.readAllLines(erreur);
        assertEquals(1, dit.size(), dit.toString());
        assertTrue(dit.get(0).matches("lancer : " + cas[4] + " de \\Q" + LA_SCENE + DUREE + cas[0] + "\\E\\..*, " + cas[0]
                + "\\.java:\\d+\\).*"), dit.get(0));
        assertFalse(Files.exists(image));
        return null;
    }

    /** Il est nommé, et dessiné comme un autre. */
    private Void essayerUnPixelLent(Path attendue) throws IOException {
        Path image = dossier.resolve("i.png");
        try (Essai.Isole programme = Modification.de(dossier, "Lancer", "Rayon initial =", "if (xe == 20.5 && ye == 15.5) { "
                + "java.util.concurrent.locks.LockSupport.parkNanos(13_000_000_000L); } Rayon initial =")) {
            Essai essai = programme.executer("--taille=40x30", "--image", image.toString(), LA_SCENE);
            assertEquals(0, essai.code, essai.toString());
            assertTrue(essai.erreur.startsWith("lancer : pixel 20, 15 de " + LA_SCENE + DUREE
                    + "Lancer.getCouleurPixel, Lancer.java:"), essai.erreur);
            assertEquals(1, essai.erreur.trim().split("\n").length, essai.erreur);
        }
        assertArrayEquals(Files.readAllBytes(attendue), Files.readAllBytes(image));
        return null;
    }

    /** Ni le fil qui attend les autres, ni celui qui avance, ni une étape qui peut durer. */
    private static Void seulLeFilRetenuEstNomme() {
        List<String> dits = new CopyOnWriteArrayList<>();
        Runnable dureTreizeSecondes = () -> {
            for (int p = 0; p < 26; p++) {
                LockSupport.parkNanos(500_000_000);
            }
        };
        new Equipe("premier", fil -> dits.add(fil.getName() + " " + fil.getEtape())).faire(() -> {
            Fil.commencer("construction");
            new Equipe("second").faire(3, Arrays.asList(k -> dureTreizeSecondes.run(), k -> {
                Fil.commencer("");
                dureTreizeSecondes.run();
            }, k -> {
                for (int p = 0; p < 26; p++) {
                    Fil.avancer();
                    LockSupport.parkNanos(500_000_000);
                }
            }));
        });
        assertEquals(Collections.singletonList("second-1 construction"), dits);
        return null;
    }

    @Test
    void unFilQuiNeSArretePasEstAbandonneEtLaCauseDeLArretEstDite() {
        CountDownLatch fin = new CountDownLatch(1);
        try {
            Equipe equipe = new Equipe("sourd");
            assertThrows(IllegalStateException.class, () -> equipe.faire(2, Arrays.asList(k -> attendreSourd(fin), k -> {
                throw new IllegalStateException("la cause");
            })));
            assertThrows(CancellationException.class, () -> equipe.faire(() -> { }));
        } finally {
            fin.countDown();
        }
    }

    private static void attendreSourd(CountDownLatch fin) {
        while (fin.getCount() > 0) {
            LockSupport.parkNanos(10_000_000);
        }
    }
}
