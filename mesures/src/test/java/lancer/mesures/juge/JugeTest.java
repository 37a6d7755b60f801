package lancer.mesures.juge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Scene;
import lancer.contrat.Modele;
import lancer.mesures.ImageLineaire;
import lancer.mesures.scenes.Scenes;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Le juge : l'accord de deux images, et la commande povray, une fausse, qui note ce qu'on lui demande et rend une image toute faite. */
class JugeTest {

    private static final String TAILLE = ScenesJugees.LARGEUR + "x" + ScenesJugees.HAUTEUR;

    @TempDir
    Path dossier;

    private final ByteArrayOutputStream sortie = new ByteArrayOutputStream();
    private final ByteArrayOutputStream erreurs = new ByteArrayOutputStream();
    private Path csv;
    private Path grise;
    private Path coloree;

    @BeforeEach
    void ecrireLesScenes() throws IOException {
        csv = dossier.resolve("juge.csv");
        grise = ecrire("grise.ini", "0.5 0.5 0.5");
        coloree = ecrire("coloree.ini", "0.5 0.4 0.3");
    }

    /** Par une commande qui dessine toujours {@code dessinee}, comme nous, avec {@code ecart} niveaux de plus au rouge d'un pixel. */
    private int comparer(Path dessinee, double seuil, int ecart, String... args) throws IOException {
        Scene scene = Scenes.lire(dessinee).avec(new Modele().avecSeuil(seuil));
        WritableRaster image = ScenesJugees.image(scene);
        image.setSample(5, 5, 0, image.getSample(5, 5, 0) + ecart);
        ScenesJugees.preparer(dossier, 0, image);
        return juger(ScenesJugees.commande(dossier), args);
    }

    /** Les noms des dessins demandés. */
    private List<String> dessins() throws IOException {
        return Files.readAllLines(dossier.resolve("demandes")).stream().map(d -> d.replaceFirst(".* \\+O\\S*/(\\S+)\\.png .*", "$1"))
                .collect(Collectors.toList());
    }

    private Path ecrire(String nom, String Ks) throws IOException {
        return Files.write(dossier.resolve(nom), List.of("[Sphere 1]", "centre=-0.5 0 6", "rayon=0.8", "Kd=0.7 0.2 0.1",
                "Ks=" + Ks, "ns=40", "[Sphere 2]", "centre=0.75 0.25 5", "rayon=0.5", "Kd=0.4 0.4 0.5", "Ks=0.3 0.3 0.3", "ns=4.5",
                "[Lampe]", "position=-4 6 -3", "couleur=0.8 0.8 0.75"), StandardCharsets.UTF_8);
    }

    private int juger(String povray, String... args) throws IOException {
        return Juge.executer(povray, csv, new PrintStream(sortie, true, "UTF-8"), new PrintStream(erreurs, true, "UTF-8"), args);
    }

    private static String texte(ByteArrayOutputStream flux) {
        return new String(flux.toByteArray(), StandardCharsets.UTF_8);
    }

    @Test
    void deuxImagesDAccordSontNotees() throws IOException {
        assertEquals(0, comparer(grise, Constantes.SEUIL, 0, "--reflets", "3", "--taille", TAILLE, grise.toString()));
        assertEquals("", texte(erreurs));
        assertTrue(texte(sortie).contains("d'accord"), texte(sortie));
        assertEquals(List.of("grise"), dessins());
        List<String> lignes = Files.readAllLines(csv);
        assertEquals(2, lignes.size());
        assertEquals(lignes.get(0).split(",").length, lignes.get(1).split(",").length);
        assertEquals(lignes.get(0), Files.readAllLines(Path.of("resultats/juge.csv")).get(0), "make juge");
        assertTrue(lignes.get(1).startsWith("grise,40,30,2,3,1,0,0,0.00"), lignes.get(1));
        assertTrue(lignes.get(1).contains(",oui,"), lignes.get(1));
    }

    @Test
    void unKsColoreAPeineSeJugeUneComposanteALaFoisEtSansSeuil() throws IOException {
        ecrire("coloree.ini", "0.5 0.5 0.49");
        assertEquals(0, comparer(coloree, 0, 0, "--reflets", "3", "--taille", TAILLE, coloree.toString()));
        assertEquals(List.of("coloree-rouge", "coloree-verte", "coloree-bleue"), dessins());
    }

    @Test
    void unPixelFauxDUnNiveauDEcranEstDenonce() throws IOException {
        assertEquals(1, comparer(grise, Constantes.SEUIL, 300, "--reflets", "3", "--taille", TAILLE, grise.toString()));
        assertTrue(texte(sortie).contains("DÉSACCORD, le pire au pixel (5, 5) : lancer "), texte(sortie));
    }

    @Test
    void sansPovRayUneLigneDitCommentLAvoir() throws IOException {
        assertEquals(1, juger(dossier.resolve("absent").toString(), grise.toString()));
        assertEquals("", texte(sortie));
        String ligne = texte(erreurs);
        assertTrue(ligne.contains("sudo apt-get install povray"), ligne);
        assertEquals(1, ligne.split("\n").length);
    }

    @Test
    void uneSceneQueLeJugeNePeutFaireEstSauteeEtDite() throws IOException {
        Path dedans = Files.write(dossier.resolve("dedans.ini"), List.of("[Sphere]", "centre=0 0 0", "rayon=1"));
        assertEquals(0, comparer(grise, Constantes.SEUIL, 0, "--reflets", "3", "--taille", TAILLE, dedans.toString()));
        assertTrue(texte(sortie).contains("non jugée : Sphere("), texte(sortie));
    }

    @ParameterizedTest(name = "« {0} »")
    @ValueSource(strings = {"--inconnue 3", "--simple", "--reflets -1 x.ini", "a.ini b.ini", "--taille 0x0 x.ini", "absente.ini"})
    void uneDemandeFausseTientEnUneLigneEtLeStatut2(String args) throws IOException {
        assertEquals(2, juger(ScenesJugees.commande(dossier), args.split(" ")));
        assertEquals("", texte(sortie).replaceAll("(?s)Le juge est.*verdict\\s*", ""));
        assertEquals(1, texte(erreurs).split("\n").length, texte(erreurs));
        assertTrue(texte(erreurs).startsWith("Juge : "), texte(erreurs));
    }

    private Raster dessiner(int echecs, WritableRaster rendue) throws IOException {
        ScenesJugees.preparer(dossier, echecs, rendue);
        PovRay povray = new PovRay(ScenesJugees.commande(dossier), dossier);
        povray.ecrire("essai", "la scène");
        return povray.dessiner("essai", ScenesJugees.LARGEUR, ScenesJugees.HAUTEUR);
    }

    private String panne(int echecs, WritableRaster rendue) {
        return assertThrows(IOException.class, () -> dessiner(echecs, rendue)).getMessage();
    }

    @Test
    void unDessinManqueEstRedemandeUneFoisEtDeuxSontUnePanneQuiSeDit() throws IOException {
        WritableRaster image = ScenesJugees.image(ScenesJugees.deuxBoules(new Couleur(0.5)));
        assertEquals(ScenesJugees.LARGEUR, dessiner(1, image).getWidth());
        assertEquals(2, Files.readAllLines(dossier.resolve("demandes")).size());
        assertEquals(dossier.resolve("povray") + " n'a pas dessiné essai, statut 3 : Fatal error: en retard", panne(9, image));
    }

    @Test
    void uneImageDe8BitsEstRefusee() {
        String panne = panne(0, Raster.createInterleavedRaster(DataBuffer.TYPE_BYTE, ScenesJugees.LARGEUR, ScenesJugees.HAUTEUR, 3, null));
        assertTrue(panne.contains("image inattendue"), panne);
    }

    /** Une image noire où ces composantes ont autant de pas de 16 bits : trois nombres, le pixel, la composante et les pas. */
    private static Juge.Accord accord(double[]... ecarts) {
        ImageLineaire lui = new ImageLineaire(100, 50);
        for (double[] ecart : ecarts) {
            lui.getComposantes()[(int) (3 * ecart[0] + ecart[1])] += ecart[2] / 65535;
        }
        return new Juge.Accord(new ImageLineaire(100, 50), lui);
    }

    @Test
    void lesPixelsAuDelaDUnPasSontComptesUneFoisChacun() {
        // un pas de 8 bits en vaut 257 de 16
        Juge.Accord accord = accord(new double[][] {{203, 0, 258}, {203, 1, 300}, {2007, 2, 256}, {2009, 2, 0.9}});
        assertEquals(1, accord.auDela8);
        assertEquals(2, accord.auDela16);
        assertEquals(300 / 257.0, accord.pire, 1e-9);
        assertEquals(203, accord.pirePixel);
        assertFalse(accord.estLa());
    }

    @Test
    void lAccordTientAUnPixelSurMilleDePlusDUnPasDe16Bits() {
        double[][] six = {{0, 0, 40}, {1, 0, 40}, {2, 0, 40}, {3, 0, 40}, {4, 0, 40}, {5, 2, 40}};
        assertTrue(accord(Arrays.copyOf(six, 5)).estLa());
        assertFalse(accord(six).estLa());
    }

    @Test
    void povRayDessineLaMemeImage() throws IOException {
        try {
            new PovRay("povray", dossier);
        } catch (IOException e) {
            assumeTrue(false, "povray n'est pas là");
        }
        for (Path scene : new Path[] {grise, coloree}) {
            assertEquals(0, juger(PovRay.COMMANDE, "--taille", TAILLE, scene.toString()), texte(sortie) + texte(erreurs));
        }
        assertEquals(2, texte(sortie).split("  d'accord", -1).length - 1, texte(sortie));
        assertTrue(Files.exists(Path.of("target/juge/grise.pov")) && Files.exists(Path.of("target/juge/coloree-verte.png")));
    }
}
