package lancer.auto;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import lancer.essai.Essai;
import lancer.essai.EssaiCommande;
import org.junit.jupiter.api.Test;

/** {@code --auto} sur la ligne de commande : ce qu'il choisit, ce qu'il dit, ce qu'il mesure. */
class CommandeAutoTest extends EssaiCommande {

    @Test
    void leChoixEtLaMesureSeDisentEnDeuxLignesEtLImageEstEcrite() {
        Essai e = executer("--auto", "erreur=30", "--repeter=2", "--image=" + png, "--lineaire=" + pfm);
        assertEquals(0, e.code, e.toString());
        assertEquals("", e.sortie);
        String[] lignes = e.erreur.split(System.lineSeparator());
        assertEquals(2, lignes.length, e.erreur);
        assertTrue(lignes[0].matches("lancer : auto, choisi : un rayon par pixel, --reflets [0-9]+ --seuil [0-9.]+"), lignes[0]);
        assertTrue(lignes[1].matches("lancer : auto, mesuré : erreur de [0-9.]+ ± [0-9.]+ ; "
                + "pixels tirés au hasard : un détail plus petit que 1/[0-9]+ de l'image a pu échapper ; "
                + "erreur voulue tenue"), lignes[1]);
        verifierFichiers("image.png", "image.pfm");
    }

    @Test
    void leCheminLisibleChoisitDeMeme() {
        String choisi = executer("--auto", "erreur=12", "--image=" + png).erreur.split(System.lineSeparator())[0];
        assertEquals(choisi, executer("--auto", "erreur=12", "--simple", "--image=" + png).erreur.split(System.lineSeparator())[0]);
    }

    @Test
    void uneErreurHorsDePorteeSeDitEtLImageEstLaPlusJuste() {
        Essai e = executer("--auto", "erreur=0.2", "--image=" + png);
        assertEquals(0, e.code, e.toString());
        assertTrue(e.erreur.matches("(?s).*--reflets 1000 .*\\R.* ; erreur voulue dépassée\\R"), e.erreur);
        e = executer("--auto", "erreur=0.2", "--reflets=2", "--seuil=0", "--image=" + png);
        assertTrue(e.erreur.contains("un rayon par pixel, --reflets 2 --seuil 0.0" + System.lineSeparator()), e.erreur);
    }

    @Test
    void lesStatistiquesDuChoixSAjoutentAuxAutres() {
        Essai e = executer("--auto", "erreur=30", "--statistiques", "--image=" + png);
        String[] lignes = e.sortie.split("\r?\n");
        for (String ligne : lignes) {
            assertTrue(ligne.matches("[a-z]+(\\.[a-z]+)+: [0-9]+(\\.[0-9]+)?"), ligne);
        }
        assertEquals("[auto.erreur.mesuree, auto.erreur.incertitude, auto.rayons.essais]",
                Arrays.toString(Arrays.stream(lignes).filter(l -> l.startsWith("auto.")).map(l -> l.replaceAll(":.*", "")).toArray()));
        // les rayons des essais n'en sont pas
        assertEquals(1200, e.statistique("rayons.primaires"));
    }
}
