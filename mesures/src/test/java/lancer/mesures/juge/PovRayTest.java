package lancer.mesures.juge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import lancer.Couleur;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** La commande povray : une fausse, qui note ce qu'on lui demande et rend une image toute faite. */
class PovRayTest {

    @TempDir
    Path dossier;

    private PovRay povray;

    private Raster dessiner(int echecs, WritableRaster rendue) throws IOException {
        ScenesJugees.preparer(dossier, echecs, rendue);
        povray = new PovRay(ScenesJugees.commande(dossier), dossier);
        povray.ecrire("essai", "la scène");
        return povray.dessiner("essai", ScenesJugees.LARGEUR, ScenesJugees.HAUTEUR);
    }

    private String panne(int echecs, WritableRaster rendue) {
        return assertThrows(IOException.class, () -> dessiner(echecs, rendue)).getMessage();
    }

    private static WritableRaster image() {
        return ScenesJugees.image(ScenesJugees.deuxBoules(new Couleur(0.5)));
    }

    @Test
    void unDessinManqueEstRedemandeUneFois() throws IOException {
        assertEquals(ScenesJugees.LARGEUR, dessiner(1, image()).getWidth());
        assertEquals(2, Files.readAllLines(dossier.resolve("demandes")).size());
    }

    @Test
    void deuxDessinsManquesSontUnePanneQuiSeDit() throws IOException {
        assertEquals(dossier.resolve("povray") + " n'a pas dessiné essai, statut 3 : Fatal error: en retard", panne(9, image()));
    }

    @Test
    void uneImageDe8BitsEstRefusee() throws IOException {
        String panne = panne(0, Raster.createInterleavedRaster(DataBuffer.TYPE_BYTE, ScenesJugees.LARGEUR, ScenesJugees.HAUTEUR, 3, null));
        assertTrue(panne.contains("image inattendue"), panne);
    }
}
