package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.event.KeyEvent;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import lancer.essai.Essai;
import lancer.image.ImageMemoire;
import org.junit.jupiter.api.Test;

/** La fenêtre et le fichier de sa scène : ouvert, modifié, fautif. */
class FenetreFichiersTest extends EssaiFenetre {

    @Test
    void enregistrerLaSceneDansUnEditeurLaRedessine() throws Exception {
        ouvrir();
        ecrire(BLEUE);
        banc.attendreImage("la boule est bleue", attendue(L, H));
        // à la manière des éditeurs qui renomment, et à taille égale
        Path nouveau = dossier.resolve("boule.ini.tmp");
        Files.write(nouveau, BLEUE.replace("0.1 0.2 0.9", "0.9 0.9 0.1").getBytes(StandardCharsets.UTF_8));
        Files.move(nouveau, scene, StandardCopyOption.REPLACE_EXISTING);
        banc.attendreImage("la boule est jaune", attendue(L, H));
    }

    @Test
    void unFichierEffaceSeDitEtLImageResteJusquACeQuIlRevienne() throws Exception {
        ImageMemoire image = ouvrir();
        Files.delete(scene);
        banc.attendreMessage(scene + " : fichier introuvable ; attendu : un fichier de scène");
        assertSame(image, banc.etat().getImageEntiere());
        ecrire(ROUGE);
        banc.attendreMessage("");
        attendre("relue", () -> banc.etat().getImageEntiere() != null
                && banc.etat().getImageEntiere() != image);
    }

    @Test
    void uneFauteCorrigeeNeSeLitPlusMemeSiLImageSeFaitAttendre() throws Exception {
        banc = new BancFenetre(new MainLent(args()) {
            @Override
            void peindre(int ye, Runnable peindre) {
                if (lent) {
                    retenir();
                }
                super.peindre(ye, peindre);
            }
        });
        int[] avant = banc.imageAchevee().codes;
        ecrire(FAUTIVE);
        banc.attendreMessage(scene + ", ligne");
        banc.main.lent = true;
        ecrire(BLEUE);
        banc.attendreMessage("");
        assertArrayEquals(avant, banc.etat().montre.dessin.image.codes, "elle n'est pas encore dessinée");
        banc.main.lent = false;
        suite.countDown();
        banc.attendreImage("l'image suit", attendue(L, H));
    }

    @Test
    void ctrlOOuvreUneAutreSceneDontLeNomSeComplete() throws Exception {
        ouvrir();
        scene = dossier.resolve("autre.ini");
        ecrire(BLEUE);
        banc.frapperCtrl('O');
        choisir(dossier.resolve("autre"));
        banc.attendreImage("l'autre scène", attendue(L, H));
        assertEquals("lancer — autre.ini", banc.cadre.getTitle());
        // c'est elle, maintenant, qui est surveillée
        ecrire(ROUGE);
        banc.attendreImage("l'autre scène, modifiée", attendue(L, H));
    }

    @Test
    void laSceneDemandeeEnDernierEstSurveilleeMemeFautiveEtSonMessageDitDeQuiEstLImageQuiReste() throws Exception {
        int[] rouge = ouvrir().codes;
        scene = dossier.resolve("fautive.ini");
        ecrire(FAUTIVE);
        banc.frapperCtrl('O');
        choisir(scene);
        banc.attendreMessage(scene.toString());
        assertTrue(banc.message().endsWith("\nl'image qui reste est celle de boule.ini"), banc.message());
        assertEquals("lancer — fautive.ini", banc.cadre.getTitle());
        assertArrayEquals(rouge, banc.imageAchevee().codes);
        banc.frapper(KeyEvent.VK_F5);
        attendre("F5 la relit", () -> !banc.etat().enCours());
        banc.attendreMessage(scene.toString());
        ecrire(BLEUE);
        banc.attendreMessage("");
        banc.attendreImage("enregistrée sans sa faute, elle est dessinée", attendue(L, H));
    }

    @Test
    void uneToucheQuiSeRepeteNOuvreQuUnDialogue() throws Exception {
        ouvrir();
        scene = dossier.resolve("autre.ini");
        ecrire(BLEUE);
        banc.frapper(KeyEvent.VK_CONTROL);
        banc.robot.keyPress(KeyEvent.VK_CONTROL);
        for (int k = 0; k < 3; k++) {
            banc.robot.keyPress(KeyEvent.VK_O);
            banc.robot.keyRelease(KeyEvent.VK_O);
        }
        banc.robot.keyRelease(KeyEvent.VK_CONTROL);
        choisir(scene);
        banc.attendreImage("rien ne la recouvre", attendue(L, H));
    }

    @Test
    void uneSceneFautiveOuverteLaPremiereEstRelueDesQuElleEstCorrigee() throws Exception {
        ecrire(FAUTIVE);
        banc = new BancFenetre(TAILLE);
        choisir(scene);
        banc.attendreMessage(scene + ", ligne 3, [Sphere 1], rayon : ");
        assertEquals("lancer — boule.ini", banc.cadre.getTitle());
        ecrire(BLEUE);
        attendre("la faute ne se lit plus", () -> !banc.bandeau.getText().contains("rayon"));
        banc.attendreCodes("corrigée, elle est dessinée", attendue(L, H));
    }

    @Test
    void uneSceneFautiveAuDepartNOuvrePasDeFenetre() throws Exception {
        ecrire(FAUTIVE);
        Essai essai = Essai.executer(scene.toString());
        assertEquals(2, essai.code);
        assertTrue(essai.erreur.matches("lancer : .*boule.ini.*rayon.*\\R"), essai.erreur);
    }
}
