package lancer.brume;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import lancer.Essai;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Une variante de plus ne demande qu'une classe et une ligne de services : rien de la base ne change. */
class QuatriemeVarianteTest {

    @TempDir
    Path dossier;

    private List<Path> nuit() {
        Path essais = Essai.origine(Nuit.class);
        return Arrays.asList(essais, essais.resolve("quatrieme"));
    }

    private String boule(String... suite) throws IOException {
        return Essai.scene(dossier.resolve("boule.ini"), "[Sphere 1]", "centre=0 0 6", "rayon=1", "Kd=1 1 1", "[Lampe 1]",
                "position=0 0 -10", "couleur=1 1 1", String.join("\n", suite)).toString();
    }

    @Test
    void elleSInstalleSansRienChangerALaBase() throws Exception {
        Path image = dossier.resolve("nuit.pfm");
        Essai essai = Essai.executerAvec(nuit(), "--lineaire", image.toString(), "--taille", "1x1", boule("[nuit]", "portee=2.5"));
        assertEquals("", essai.erreur);
        assertEquals(0, essai.code);
        // le contact est à 5 unités, soit deux portées, éclairé de face
        assertEquals(0.25, Essai.pfm(Files.readAllBytes(image))[0], 1e-7);
    }

    @Test
    void sonModulePeutAussiApporterUneForme() throws Exception {
        String[] lignes = {"[Disque 1]", "centre=0.5 0 5", "normale=0 0 -1", "rayon=1", "Kd=1 1 1", "[Lampe 1]", "position=0 0 -10",
            "couleur=1 1 1", "[Nuit]", "portee=2.5"};
        Path scene = Essai.scene(dossier.resolve("disque.ini"), lignes);
        assertEquals(0.25, Essai.dessinerAvec(nuit(), dossier, scene, "--taille=1x1")[0], 1e-7);
        assertArrayEquals(Essai.dessinerAvec(nuit(), dossier, scene, "--taille=40x30", "--simple"),
                Essai.dessinerAvec(nuit(), dossier, scene, "--taille=40x30"));
        lignes[1] = "centre=1.5 0 5";
        // à côté, le ciel, dans la nuit
        assertEquals(0, Essai.dessinerAvec(nuit(), dossier, Essai.scene(scene, lignes), "--taille=1x1")[0]);
        lignes[3] = "rayon=0";
        Essai essai = Essai.executerAvec(nuit(), "--lineaire", dossier.resolve("a.pfm").toString(), Essai.scene(scene, lignes).toString());
        assertEquals("lancer : " + scene + ", ligne 4, [Disque 1], rayon : hors limites : « 0 » ; attendu : un nombre de 1e-100 à 1e100"
                + System.lineSeparator(), essai.erreur);
    }

    @Test
    void saSectionALesMessagesDeLaBase() throws Exception {
        String scene = boule("[Nuit]", "portee=0");
        Essai essai = Essai.executerAvec(nuit(), "--lineaire", dossier.resolve("nuit.pfm").toString(), scene);
        assertEquals("lancer : " + scene + ", ligne 9, [Nuit], portee : hors limites : « 0 » ; attendu : un nombre plus grand que 0, "
                + "au plus 1000000" + System.lineSeparator(), essai.erreur);
        assertEquals(2, essai.code);
    }

    @Test
    void sansElleSaSectionEstRefusee() throws Exception {
        String scene = boule("[Nuit]", "portee=2.5");
        Essai essai = Essai.executerAvec(Collections.<Path>emptyList(), "--lineaire", dossier.resolve("nuit.pfm").toString(), scene);
        assertEquals("lancer : " + scene + ", ligne 8, [Nuit] : type de section inconnu ; attendu : Sphere, Lampe, Brume, Antialias, "
                + "Blinn" + System.lineSeparator(), essai.sansAutresFormes(""));
        assertEquals(2, essai.code);
    }

    @Test
    void deuxVariantesQuiVeulentLAirSontNommeesToutesDeux() throws Exception {
        Path image = dossier.resolve("nuit.pfm");
        List<Path> nuit = nuit();
        List<Path> classes = Arrays.asList(nuit.get(0), nuit.get(1), Essai.origine(Brume.class));
        Essai essai = Essai.executerAvec(classes, "--lineaire", image.toString(), boule());
        assertEquals("lancer : deux variantes veulent changer l'air : lancer.brume.Nuit$Obscurite et lancer.brume.Brume ; attendu : "
                + "une seule des deux dans le chemin des classes" + System.lineSeparator(), essai.erreur);
        assertEquals(2, essai.code);
        assertFalse(Files.exists(image));
    }
}
