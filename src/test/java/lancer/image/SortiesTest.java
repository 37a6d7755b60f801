package lancer.image;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.nio.file.attribute.UserPrincipal;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import javax.imageio.ImageIO;
import lancer.Couleur;
import lancer.commande.Messages;
import lancer.essai.Essai;
import lancer.essai.EssaiCommande;
import lancer.essai.Ressources;
import lancer.systeme.Echec;
import lancer.systeme.Ecriture;
import org.junit.jupiter.api.Test;

/** Les fichiers que le programme écrit, ce qu'ils contiennent, et ce qu'il dit quand il ne le peut pas. */
class SortiesTest extends EssaiCommande {

    @Test
    void unDossierAbsentOuUnDossierEnSortieEstUnePanne() throws IOException {
        Path absent = dossier.resolve("absent").resolve("image.png");
        verifierRefus(1, absent + " : écriture impossible, le dossier n'existe pas", executer("--image", absent.toString()));
        Path plein = Files.createDirectory(dossier.resolve("plein.pfm"));
        verifierRefus(1, plein + " : écriture impossible, c'est un dossier", executer("--lineaire", plein.toString()));
        Files.writeString(png, "pas un dossier");
        Path dessous = png.resolve("image.png");
        verifierPanne(dessous, executer("--image", dessous.toString()));
        verifierFichiers("image.png", "plein.pfm");
    }

    @Test
    void unEchecNeDitQueLui() throws IOException {
        assumeTrue(Files.exists(Path.of("/dev/full")), "pas de /dev/full ici");
        Path pleine = lien("pleine.png", Path.of("/dev/full"));
        String scene = Ressources.chemin("valides/avertie-brume.ini");
        verifierPanne(pleine, Essai.executer("--taille=4x4", "--image=" + pleine, scene));
    }

    /** Une ligne, dont le système dit la fin, dans sa langue. */
    private static void verifierPanne(Path fichier, Essai e) {
        assertEquals(1, e.code);
        assertTrue(e.erreur.matches("lancer : \\Q" + fichier + "\\E : écriture impossible, .+\\R"), e.erreur);
    }

    @Test
    void desLiensSansFinSontUnePanne() throws IOException {
        Path boucle = lien("boucle.png", Path.of("boucle.png"));
        verifierPanne(boucle, executer("--image", boucle.toString()));
    }

    @Test
    void unePanneDeLaMachineDitQuoiFaire() {
        assertEquals("trop de fils d'exécution pour cette machine ; en demander moins, par exemple --fils 2",
                Messages.message(new OutOfMemoryError("unable to create native thread: possibly out of memory")));
        assertEquals("mémoire épuisée ; donner plus à Java, par exemple java -Xmx2g -jar …", Messages.message(new OutOfMemoryError()));
        assertEquals("échec du programme : java.lang.IllegalStateException: a\\nb (lancer.image.SortiesTest."
                + "unePanneDeLaMachineDitQuoiFaire, SortiesTest.java)",
                Messages.message(new RuntimeException(new IllegalStateException("a\nb"))).replaceAll("java:\\d+", "java"));
    }

    @Test
    void uneSortieStandardPleineEstUnePanne() throws IOException {
        assumeTrue(Files.exists(Path.of("/dev/full")), "pas de /dev/full ici");
        ByteArrayOutputStream erreur = new ByteArrayOutputStream();
        try (PrintStream pleine = new PrintStream("/dev/full", "UTF-8"); PrintStream e = new PrintStream(erreur, true, "UTF-8")) {
            assertEquals(1, Essai.executer(pleine, e, "--aide"));
            assertEquals(1, Essai.executer(pleine, e, "--pixel=1,1", SCENE));
        }
        String ligne = "lancer : sortie standard : écriture impossible" + System.lineSeparator();
        assertEquals(ligne + ligne, erreur.toString("UTF-8"));
    }

    @Test
    void uneImageRemplaceLAncienneEnEntierEtRienNeTraine() throws IOException {
        Files.writeString(png, "vieux".repeat(100_000));
        dessiner("--image", png.toString(), "--lineaire", pfm.toString());
        assertTrue(Files.size(png) < 10_000);
        assertEquals(40, ImageIO.read(png.toFile()).getWidth());
        verifierFichiers("image.png", "image.pfm");
    }

    @Test
    void uneEcritureQuiEchoueLaisseLeFichierCommeAvant() throws IOException {
        Files.writeString(png, "avant");
        ImageMemoire image = new ImageMemoire(3, 2, true);
        Ecriture.Format<ImageMemoire> panne = (i, sortie) -> {
            new FichierPng().ecrire(i, sortie);
            sortie.write(new byte[1 << 20]);
            throw new IOException("plus de place");
        };
        for (Path sortie : List.of(png, pfm)) {
            Echec e = assertThrows(Echec.class, () -> new Ecriture<>(sortie.toString(), panne).ecrire(image));
            assertEquals(sortie + " : écriture impossible, plus de place", e.getMessage());
            assertEquals(1, e.code);
        }
        assertThrows(OutOfMemoryError.class, () -> new Ecriture<ImageMemoire>(png.toString(), (i, sortie) -> {
            throw new OutOfMemoryError();
        }).ecrire(image));
        assertEquals("avant", Files.readString(png));
        verifierFichiers("image.png");
    }

    @Test
    void unLienSymboliqueEstSuivi() throws IOException {
        Path ailleurs = Files.createDirectory(dossier.resolve("ailleurs"));
        Path vraie = ailleurs.resolve("vraie.png");
        Path lien = lien("lien.png", Path.of("ailleurs/vraie.png"));
        for (int fois = 0; fois < 2; fois++) {
            // la première fois, il ne mène encore à rien
            dessiner("--image", lien.toString());
            assertTrue(Files.isSymbolicLink(lien));
            assertTrue(Files.isRegularFile(vraie));
            assertEquals(40, ImageIO.read(vraie.toFile()).getWidth());
        }
        assertArrayEquals(new String[] {"vraie.png"}, ailleurs.toFile().list());
    }

    @Test
    void uneImageOuUneSceneGardeSesPermissionsSonProprietaireEtSesAutresNoms() throws IOException {
        assumeTrue(Files.getFileStore(dossier).supportsFileAttributeView("posix"), "pas de permissions ici");
        for (String permissions : new String[] {"rw-------", "rw-rw-rw-", "rwxr-x---"}) {
            Files.writeString(png, "avant");
            Files.setPosixFilePermissions(png, PosixFilePermissions.fromString(permissions));
            UserPrincipal qui = donner(png);
            new Ecriture<ImageMemoire>(png.toString(), (image, sortie) -> {
                for (File provisoire : dossier.toFile().listFiles()) {
                    assertEquals(permissions, PosixFilePermissions.toString(Files.getPosixFilePermissions(provisoire.toPath())));
                }
                new FichierPng().ecrire(image, sortie);
            }).ecrire(new ImageMemoire(40, 30, false));
            assertEquals(40, ImageIO.read(png.toFile()).getWidth());
            assertEquals(permissions, PosixFilePermissions.toString(Files.getPosixFilePermissions(png)));
            assertEquals(qui, Files.getOwner(png));
        }
        Path autreNom = Files.createLink(dossier.resolve("autre.png"), png);
        new Ecriture<>(png.toString(), new FichierPng()).ecrire(new ImageMemoire(7, 7, false));
        assertTrue(Files.isSameFile(png, autreNom));
        assertEquals(7, ImageIO.read(autreNom.toFile()).getWidth());
        verifierFichiers("image.png", "autre.png");
    }

    /** Donne ce fichier à un autre, si ce test en a le droit. @return son propriétaire */
    private static UserPrincipal donner(Path fichier) throws IOException {
        try {
            Files.setOwner(fichier, fichier.getFileSystem().getUserPrincipalLookupService().lookupPrincipalByName("nobody"));
        } catch (IOException e) {
            // il reste à qui lance ce test
        }
        return Files.getOwner(fichier);
    }

    @Test
    void unNomAussiLongQueLeSystemeLePermetConvient() {
        String nom = "n".repeat(251) + ".png";
        dessiner("--image", dossier.resolve(nom).toString());
        verifierFichiers(nom);
    }

    @Test
    void leNeantEstUneSortiePermise() throws IOException {
        assumeTrue(Files.exists(Path.of("/dev/null")), "pas de /dev/null ici");
        dessiner("--image", lien("neant.png", Path.of("/dev/null")).toString());
        dessiner("--lineaire", lien("neant.pfm", Path.of("/dev/null")).toString(), "--image", png.toString());
        assertFalse(Files.isRegularFile(Path.of("/dev/null")));
        verifierFichiers("image.png", "neant.pfm", "neant.png");
    }

    @Test
    void lePngEstJusteAToutesLesTailles() throws IOException {
        for (int[] taille : new int[][] {{1, 1}, {1, 100}, {100, 1}, {3, 2}, {257, 255}, {16384, 3}, {3, 16384}}) {
            ImageMemoire memoire = new ImageMemoire(taille[0], taille[1], false);
            Random hasard = new Random(taille[0]);
            for (int k = 0; k < memoire.codes.length; k++) {
                memoire.codes[k] = 0xFF000000 | hasard.nextInt();
            }
            new Ecriture<>(png.toString(), new FichierPng()).ecrire(memoire);
            BufferedImage lue = ImageIO.read(png.toFile());
            assertArrayEquals(memoire.codes, lue.getRGB(0, 0, taille[0], taille[1], null, 0, taille[0]), Arrays.toString(taille));
        }
    }

    @Test
    void lePfmCommenceParLeBasEtEstPetitBoutiste() throws IOException {
        ImageMemoire memoire = new ImageMemoire(2, 2, true);
        memoire.drawPixel(new Couleur(1, 2, 3), 0, 0);
        memoire.drawPixel(new Couleur(4, 5, 6), 1, 0);
        memoire.drawPixel(new Couleur(-7, 1e6, 0.1), 0, 1);
        memoire.drawPixel(new Couleur(0), 1, 1);
        new Ecriture<>(pfm.toString(), new FichierPfm()).ecrire(memoire);
        ByteBuffer octets = ByteBuffer.wrap(Files.readAllBytes(pfm)).order(ByteOrder.LITTLE_ENDIAN);
        byte[] entete = new byte["PF\n2 2\n-1.0\n".length()];
        octets.get(entete);
        assertEquals("PF\n2 2\n-1.0\n", new String(entete, StandardCharsets.US_ASCII));
        for (float attendu : new float[] {-7, 1e6f, 0.1f, 0, 0, 0, 1, 2, 3, 4, 5, 6}) {
            assertEquals(attendu, octets.getFloat());
        }
        assertFalse(octets.hasRemaining());
    }
}
