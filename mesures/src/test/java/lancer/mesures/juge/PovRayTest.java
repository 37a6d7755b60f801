package lancer.mesures.juge;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import lancer.Couleur;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** La commande povray : une fausse, qui note ce qu'on lui demande et rend une image toute faite. */
class PovRayTest {

    @TempDir
    Path dossier;

    private String commande;

    @BeforeEach
    void ecrireLaCommande() throws IOException {
        commande = ScenesJugees.commande(dossier);
    }

    private void preparer(int echecs, WritableRaster image) throws IOException {
        ScenesJugees.preparer(dossier, echecs, image);
    }

    private Raster dessiner() throws IOException {
        return new PovRay(commande, dossier).dessiner("la scène", "essai", ScenesJugees.LARGEUR, ScenesJugees.HAUTEUR);
    }

    private static WritableRaster image() {
        return ScenesJugees.image(ScenesJugees.couleurs(ScenesJugees.deuxBoules(new Couleur(0.5))));
    }

    @Test
    void lImageDe16BitsSeLitTelleQuElleEstEcrite() throws IOException {
        preparer(0, image());
        Raster lue = dessiner();
        assertArrayEquals(image().getPixels(0, 0, ScenesJugees.LARGEUR, ScenesJugees.HAUTEUR, (int[]) null),
                lue.getPixels(0, 0, ScenesJugees.LARGEUR, ScenesJugees.HAUTEUR, (int[]) null));
        assertEquals("la scène", new String(Files.readAllBytes(dossier.resolve("essai.pov")), StandardCharsets.UTF_8));
        assertEquals(Arrays.asList("+I" + dossier.resolve("essai.pov") + " +O" + dossier.resolve("essai.png")
                + " +FN16 File_Gamma=1 +W40 +H30 -D -P -V -J -A"), Files.readAllLines(dossier.resolve("demandes")));
        assertEquals("POV-Ray 3.9.1", new PovRay(commande, dossier).nom());
    }

    @Test
    void sonTempsEstCeluiQuIlDitAvoirPasseATracer() throws IOException {
        preparer(0, image());
        PovRay povray = new PovRay(commande, dossier);
        povray.dessiner("la scène", "essai", ScenesJugees.LARGEUR, ScenesJugees.HAUTEUR, "+A0.1", "+R3");
        assertArrayEquals(new double[] {1.25e9, 2.5e9}, Arrays.copyOfRange(povray.temps(), 1, 3));
        assertTrue(Files.readAllLines(dossier.resolve("demandes")).get(0).endsWith(" -J +A0.1 +R3"));
    }

    @Test
    void unDessinManqueEstRedemandeUneFois() throws IOException {
        preparer(1, image());
        assertEquals(ScenesJugees.LARGEUR, dessiner().getWidth());
        assertEquals(2, Files.readAllLines(dossier.resolve("demandes")).size());
    }

    @Test
    void deuxDessinsManquesSontUnePanneQuiSeDit() throws IOException {
        preparer(9, image());
        String message = assertThrows(IOException.class, this::dessiner).getMessage();
        assertEquals(commande + " n'a pas dessiné essai, statut 3 : Fatal error: en retard", message);
    }

    @Test
    void uneImageDe8BitsEstRefusee() throws IOException {
        preparer(0, Raster.createInterleavedRaster(DataBuffer.TYPE_BYTE, ScenesJugees.LARGEUR, ScenesJugees.HAUTEUR, 3, null));
        String message = assertThrows(IOException.class, this::dessiner).getMessage();
        assertTrue(message.contains("image inattendue"), message);
    }
}
