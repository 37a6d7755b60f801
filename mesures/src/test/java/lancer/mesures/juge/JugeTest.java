package lancer.mesures.juge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.UnsupportedEncodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lancer.Scene;
import lancer.atelier.Scenes;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Le juge. */
class JugeTest {

    private static final String TAILLE = ScenesJugees.LARGEUR + "x" + ScenesJugees.HAUTEUR;

    @TempDir
    Path dossier;

    private final ByteArrayOutputStream sortie = new ByteArrayOutputStream();
    private final ByteArrayOutputStream erreurs = new ByteArrayOutputStream();
    private Path grise;
    private Path coloree;

    /** Un juge qui dessine comme nous, sans rien devoir au texte, mais ajoute {@code ecart} niveaux au rouge d'un pixel. */
    private final class Sosie implements Peintre {

        private final Path scene;
        private final int ecart;
        private final List<String> dessins = new ArrayList<>();

        Sosie(Path scene, int ecart) {
            this.scene = scene;
            this.ecart = ecart;
        }

        @Override
        public String nom() {
            return "le sosie";
        }

        @Override
        public Raster dessiner(String texte, String nom, int largeur, int hauteur, String... options) {
            dessins.add(nom);
            Scene lue = Scenes.lire(scene);
            lue.setSeuil(texte.contains("adc_bailout 0.0") ? 0 : lue.getSeuil());
            WritableRaster image = ScenesJugees.image(ScenesJugees.couleurs(lue));
            image.setSample(5, 5, 0, image.getSample(5, 5, 0) + ecart);
            return image;
        }
    }

    @BeforeEach
    void ecrireLesScenes() throws IOException {
        grise = ecrire("grise.ini", "0.5 0.5 0.5");
        coloree = ecrire("coloree.ini", "0.5 0.4 0.3");
    }

    private Path ecrire(String nom, String Ks) throws IOException {
        return Files.write(dossier.resolve(nom), Arrays.asList("[Sphere 1]", "centre=-0.5 0 6", "rayon=0.8", "Kd=0.7 0.2 0.1",
                "Ks=" + Ks, "ns=40", "[Sphere 2]", "centre=0.75 0.25 5", "rayon=0.5", "Kd=0.4 0.4 0.5", "Ks=0.3 0.3 0.3", "ns=4.5",
                "[Lampe]", "position=-4 6 -3", "couleur=0.8 0.8 0.75"), StandardCharsets.UTF_8);
    }

    private int juger(Juge.Convocation convocation, String... args) {
        try {
            return Juge.executer(args, new PrintStream(sortie, true, "UTF-8"), new PrintStream(erreurs, true, "UTF-8"), convocation);
        } catch (UnsupportedEncodingException e) {
            throw new AssertionError(e);
        }
    }

    private static String texte(ByteArrayOutputStream flux) {
        return new String(flux.toByteArray(), StandardCharsets.UTF_8);
    }

    @Test
    void deuxImagesDAccordSontNotees() throws IOException {
        Path csv = dossier.resolve("nouveau/juge.csv");
        Sosie sosie = new Sosie(grise, 0);
        assertEquals(0, juger((c, d) -> sosie, "--taille", TAILLE, "--reflets", "3", "--csv", csv.toString(), grise.toString()));
        assertEquals("", texte(erreurs));
        assertTrue(texte(sortie).contains("d'accord"), texte(sortie));
        assertEquals(Arrays.asList("grise"), sosie.dessins);
        List<String> lignes = Files.readAllLines(csv);
        assertEquals(2, lignes.size());
        assertEquals(lignes.get(0).split(",").length, lignes.get(1).split(",").length);
        assertEquals(lignes.get(0), Files.readAllLines(Paths.get("resultats/juge.csv")).get(0), "make juge");
        assertTrue(lignes.get(1).startsWith("grise,40,30,2,3,1,0,0,0.00"), lignes.get(1));
        assertTrue(lignes.get(1).endsWith(",oui"), lignes.get(1));
    }

    @Test
    void unKsColoreAPeineSeJugeUneComposanteALaFoisEtSansSeuil() throws IOException {
        Sosie sosie = new Sosie(ecrire("coloree.ini", "0.5 0.5 0.49"), 0);
        assertEquals(0, juger((c, d) -> sosie, "--taille", TAILLE, "--reflets", "3", coloree.toString()));
        assertEquals(Arrays.asList("coloree-rouge", "coloree-verte", "coloree-bleue"), sosie.dessins);
    }

    @Test
    void unPixelFauxDUnNiveauDEcranEstDenonce() {
        assertEquals(1, juger((c, d) -> new Sosie(grise, 300), "--taille", TAILLE, "--reflets", "3", grise.toString()));
        assertTrue(texte(sortie).contains("DÉSACCORD, le pire au pixel (5, 5) : lancer "), texte(sortie));
    }

    @Test
    void unReglageDeTropSeVoit() {
        // le juge a 3 reflets, nous 0
        assertEquals(1, juger((c, d) -> new Sosie(grise, 0), "--taille", TAILLE, "--reflets", "0", grise.toString()));
        assertTrue(texte(sortie).contains("DÉSACCORD"), texte(sortie));
    }

    @Test
    void sansPovRayUneLigneDitCommentLAvoir() {
        assertEquals(1, juger(PovRay::new, "--povray", dossier.resolve("absent").toString(), grise.toString()));
        assertEquals("", texte(sortie));
        String ligne = texte(erreurs);
        assertTrue(ligne.contains("sudo apt-get install povray"), ligne);
        assertEquals(1, ligne.split("\n").length);
    }

    @Test
    void uneCommandeQuiNeDessinePasEstUnePanne() {
        // elle se lance, rend un autre statut que 0, et ne dit rien
        assumeTrue(Files.isExecutable(Paths.get("/bin/false")));
        assertEquals(1, juger(PovRay::new, "--povray", "/bin/false", "--taille", TAILLE, grise.toString()));
        assertTrue(texte(erreurs).contains("n'a pas dessiné grise, statut 1"), texte(erreurs));
    }

    @Test
    void uneSceneQueLeJugeNePeutFaireEstSauteeEtDite() throws IOException {
        Path dedans = Files.write(dossier.resolve("dedans.ini"), Arrays.asList("[Sphere]", "centre=0 0 0", "rayon=1"));
        assertEquals(0, juger((c, d) -> new Sosie(grise, 0), "--taille", TAILLE, "--reflets", "3", dedans.toString(), grise.toString()));
        assertTrue(texte(sortie).contains("non jugée : Sphere("), texte(sortie));
        assertTrue(texte(sortie).contains("d'accord"), texte(sortie));
    }

    @ParameterizedTest(name = "« {0} »")
    @ValueSource(strings = {"--inconnue 3", "--csv", "--reflets -1 x.ini", "--reflets 3", "--taille 0x0 x.ini", "absente.ini"})
    void uneDemandeFausseTientEnUneLigneEtLeStatut2(String args) {
        assertEquals(2, juger((c, d) -> new Sosie(grise, 0), args.split(" ")));
        assertEquals("", texte(sortie).replaceAll("(?s)Le juge est.*verdict\\s*", ""));
        assertEquals(1, texte(erreurs).split("\n").length, texte(erreurs));
        assertTrue(texte(erreurs).startsWith("Juge : "), texte(erreurs));
    }

    @Test
    void sansSceneToutesLesScenesLivreesSontJugees() {
        List<String> noms = Arrays.asList(Juge.TOUTES);
        Path scenes = Paths.get("..", "scenes");
        String[] livrees = scenes.toFile().list((d, nom) -> nom.endsWith(".ini"));
        for (String livree : livrees) {
            assertTrue(noms.contains(livree.replace(".ini", "") + " 5"), livree + " n'est pas jugée");
        }
    }

    @Test
    void povRayDessineLaMemeImage() throws IOException {
        try {
            new PovRay("povray", dossier);
        } catch (IOException e) {
            assumeTrue(false, "povray n'est pas là");
        }
        Path garde = dossier.resolve("garde");
        assertEquals(0, juger(PovRay::new, "--taille", TAILLE, "--garder", garde.toString(), grise.toString(), coloree.toString()),
                texte(sortie) + texte(erreurs));
        assertEquals(2, texte(sortie).split("  d'accord", -1).length - 1, texte(sortie));
        assertTrue(Files.exists(garde.resolve("grise.pov")) && Files.exists(garde.resolve("coloree-verte.png")));
    }
}
