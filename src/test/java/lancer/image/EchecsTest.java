package lancer.image;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import javax.imageio.ImageIO;
import lancer.essai.EssaiProcessus;
import lancer.essai.Ressources;
import lancer.systeme.Echec;
import lancer.systeme.Ecriture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Ce qui arrive quand la machine fait défaut : rien d'à moitié écrit, aucun fichier provisoire, une ligne, et le statut dit. Les
 * écritures qui échouent d'elles-mêmes, sans toucher à la machine, sont dans {@link SortiesTest}.
 */
@Timeout(120)
class EchecsTest extends EssaiProcessus {

    private static final byte[] AVANT = {1, 2, 3};

    // le disque

    /** La limite d'un fichier, {@code ulimit -f}, fait comme un disque qui se remplit pendant l'écriture. */
    @Test
    void unDisqueQuiSeRemplitLaisseLAncienneImage() throws Exception {
        supposerUnix();
        Path pfm = Files.write(dossier.resolve("a.pfm"), AVANT);
        List<String> commande = java("-XX:-UsePerfData -Xshare:off", "--lineaire=a.pfm", "--taille=400x300", SCENE);
        commande.addAll(0, List.of("/bin/sh", "-c", "ulimit -f 64 && exec \"$@\"", "sh"));
        assertEquals(1, statut(preparer(commande)), erreur());
        assertTrue(erreur().matches("lancer : a.pfm : .*\n"), erreur());
        assertArrayEquals(AVANT, Files.readAllBytes(pfm));
        verifierDossier("a.pfm");
    }

    /**
     * La commande, dans un dossier « disque » qui est un vrai disque à lui, avec une ancienne image « a.pfm » ; il n'est vu que d'elle
     * et disparaît avec elle. Ce qui reste dessus est ensuite copié dans « flux/reste ».
     */
    private int surUnDisque(String options, String... arguments) throws Exception {
        supposerUnix();
        Files.createDirectories(dossier.resolve("disque"));
        Files.createDirectories(dossier.resolve("flux/reste"));
        assumeTrue(new File("/usr/bin/unshare").canExecute()
                && statut(preparer(List.of("unshare", "-m", "/bin/sh", "-c", "mount -t tmpfs tmpfs disque"))) == 0,
                "il faut pouvoir monter un disque");
        String script = "mount -t tmpfs tmpfs disque && cp avant disque/a.pfm && mount -o remount," + options + " tmpfs disque && \"$@\"; "
                + "statut=$?; cp -a disque/. flux/reste && exit $statut";
        Files.write(dossier.resolve("avant"), AVANT);
        List<String> commande = java("", arguments);
        commande.addAll(0, List.of("unshare", "-m", "/bin/sh", "-c", script, "sh"));
        return statut(preparer(commande));
    }

    private void verifierReste(String... noms) throws IOException {
        String[] reste = dossier.resolve("flux/reste").toFile().list();
        Arrays.sort(reste);
        assertArrayEquals(noms, reste);
        assertArrayEquals(AVANT, Files.readAllBytes(dossier.resolve("flux/reste/a.pfm")));
    }

    @Test
    void deDeuxImagesDontUneNeTientPasSurLeDisqueAucuneNEstEcrite() throws Exception {
        assertEquals(1, surUnDisque("size=128k", "--lineaire=disque/a.pfm", "--image=disque/a.png", "--taille=400x300", SCENE), erreur());
        assertTrue(erreur().matches("lancer : disque/a.pfm : écriture impossible, .+\n"), erreur());
        verifierReste("a.pfm");
    }

    @Test
    void unDisqueEnLectureSeuleEstRefuseAvantDeDessiner() throws Exception {
        // un dessin si long que le test n'en verrait pas la fin
        assertEquals(1, surUnDisque("ro", "--lineaire=disque/a.pfm", "--repeter=100000", "--taille=4000x3000", SCENE), erreur());
        assertTrue(erreur().matches("lancer : disque/a.pfm : écriture impossible, .+\n"), erreur());
        verifierReste("a.pfm");
    }

    /** Là où le test est lancé par root, qui passe outre aux permissions, le programme l'est sans ce pouvoir. */
    @Test
    void unDossierOuUneSceneInterditsSeDisentEnUneLigne() throws Exception {
        supposerUnix();
        Path protege = Files.createDirectory(dossier.resolve("protege"));
        Path scene = Files.copy(Path.of(SCENE), dossier.resolve("s.ini"));
        List<String> sansPouvoir = new ArrayList<>();
        if (Files.isWritable(Path.of("/"))) {
            assumeTrue(new File("/usr/bin/setpriv").canExecute(), "il faut setpriv pour ne plus pouvoir tout écrire");
            sansPouvoir.addAll(List.of("/usr/bin/setpriv", "--bounding-set=-dac_override,-dac_read_search",
                    "--inh-caps=-dac_override,-dac_read_search"));
        }
        assertTrue(protege.toFile().setWritable(false, false));
        assertTrue(scene.toFile().setReadable(false, false));
        assertTrue(Files.write(dossier.resolve("i.png"), AVANT).toFile().setReadable(false, false));
        Files.copy(Path.of(SCENE), dossier.resolve("lisible.ini"));
        String[][] demandes = {{"1", "--image=protege/a.png", "lisible.ini", "protege/a.png : écriture impossible, accès interdit"},
            {"2", "--image=a.png", "s.ini", "s.ini : lecture impossible \\(accès interdit\\) ; attendu : .+"},
            {"2", "--comparer=i.png", "i.png", "i.png : image illisible : accès interdit ; attendu : .+"}};
        for (String[] demande : demandes) {
            List<String> commande = java("", demande[1], demande[2]);
            commande.addAll(0, sansPouvoir);
            assertEquals(demande[0], String.valueOf(statut(preparer(commande))), erreur());
            assertTrue(erreur().matches("lancer : " + demande[3] + "\n"), erreur());
        }
        assertTrue(protege.toFile().setWritable(true));
        assertArrayEquals(new String[0], protege.toFile().list());
        assertFalse(Files.exists(dossier.resolve("a.png")));
    }

    @Test
    void unDossierEffaceOuUnDossierMisALaPlacePendantLeDessinEstUnePanne() throws IOException {
        Path sous = Files.createDirectory(dossier.resolve("sous"));
        Path png = sous.resolve("a.png");
        Ecriture<ImageMemoire> ecriture = new Ecriture<>(png.toString(), new FichierPng());
        Files.delete(sous);
        ImageMemoire image = new ImageMemoire(3, 2, false);
        Echec e = assertThrows(Echec.class, () -> ecriture.ecrire(image));
        assertEquals("1 " + png + " : écriture impossible, le dossier n'existe pas", e.code + " " + e.getMessage());

        Files.createDirectories(png.resolve("plein"));
        e = assertThrows(Echec.class, () -> ecriture.remplacer(image));
        assertEquals("1 " + png + " : écriture impossible, c'est un dossier", e.code + " " + e.getMessage());
        assertArrayEquals(new String[] {"a.png"}, sous.toFile().list());
    }

    /** Un dossier qui n'est pas vide ne se remplace pas : c'est, sur tout système, comme un fichier qu'un autre programme tient. */
    @Test
    void uneImageDontLaPlaceEstPriseEstEcriteEntiereACote() throws IOException {
        Path png = dossier.resolve("a.png");
        Path pfm = dossier.resolve("a.pfm");
        Ecriture<ImageMemoire> prise = new Ecriture<>(png.toString(), new FichierPng());
        Ecriture<ImageMemoire> libre = new Ecriture<>(pfm.toString(), new FichierPfm());
        Files.createDirectories(png.resolve("plein"));
        Files.write(dossier.resolve("a-2.png"), AVANT);
        ImageMemoire image = new ImageMemoire(3, 2, true);
        Echec e = assertThrows(Echec.class, () -> Ecriture.ecrire(image, List.of(prise, libre)));
        assertEquals(1, e.code);
        assertTrue(e.getMessage().matches("\\Q" + png + "\\E : remplacement impossible, .* ; écrit à côté, dans a-3.png"), e.getMessage());
        assertEquals(3, ImageIO.read(dossier.resolve("a-3.png").toFile()).getWidth());
        assertTrue(Files.size(pfm) > 0);
        assertArrayEquals(AVANT, Files.readAllBytes(dossier.resolve("a-2.png")));
        verifierDossier("a.png", "a-2.png", "a-3.png", "a.pfm");
    }

    @Test
    void unLecteurQuiSEnVaEstUnePanne() throws Exception {
        supposerUnix();
        Files.createSymbolicLink(dossier.resolve("flux/tube.pfm"), Path.of("/dev/stdout"));
        List<String> commande = java("", "--lineaire=flux/tube.pfm", "--taille=400x300", SCENE);
        commande.addAll(0, List.of("/bin/sh", "-c", "{ \"$@\"; echo $? > flux/statut; } | head -c 1", "sh"));
        statut(preparer(commande));
        attendre(() -> Files.readString(dossier.resolve("flux/statut")).equals("1\n"));
        Files.delete(dossier.resolve("flux/tube.pfm"));
        assertTrue(erreur().matches("lancer : flux/tube.pfm : écriture impossible, .+\n"), erreur());
    }

    // Ctrl+C

    @Test
    void ctrlCPendantLeDessinRend130EtNeLaisseRien() throws Exception {
        verifierCtrlC(SCENE, "--image=a.png", "--lineaire=a.pfm", "--repeter=100000", "--taille=400x300");
    }

    @Test
    void ctrlCPendantLEcritureLaisseLAncienneImage() throws Exception {
        supposerUnix();
        Path pfm = Files.write(dossier.resolve("a.pfm"), AVANT);
        int pid = demarrerInterruptible(Ressources.chemin("valides/vide.ini"), "--lineaire=a.pfm", "--taille=2500x2000");
        attendre(() -> dossier.toFile().list().length > 2 || !processus.isAlive());
        interrompre(pid);
        int statut = processus.waitFor();
        verifierDossier("a.pfm");
        if (statut == 130 && Files.size(pfm) == AVANT.length) {
            assertArrayEquals(AVANT, Files.readAllBytes(pfm));
        } else {
            // l'image était déjà finie
            assertEquals("PF\n2500 2000\n-1.0\n".length() + 12L * 2500 * 2000, Files.size(pfm));
        }
    }

    @Test
    void ctrlCPendantLaCreationDuFichierProvisoireNEnLaisseAucun() throws Exception {
        supposerUnix();
        // une ancienne image si grande que sa copie, qui garde ses permissions, est encore en cours
        long taille = 300_000_000;
        try (FileChannel ancienne = FileChannel.open(dossier.resolve("a.pfm"), StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
            ancienne.write(ByteBuffer.wrap(AVANT), taille - AVANT.length);
        }
        int pid = demarrerInterruptible(Ressources.chemin("valides/vide.ini"), "--lineaire=a.pfm", "--taille=4x4");
        attendre(() -> dossier.toFile().list((ou, nom) -> nom.endsWith(".tmp") && new File(ou, nom).length() > 0).length > 0
                || !processus.isAlive());
        interrompre(pid);
        processus.waitFor();
        verifierDossier("a.pfm");
    }
}
