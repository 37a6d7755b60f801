package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static lancer.fenetre.BancFenetre.texte;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.event.KeyEvent;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.DoubleConsumer;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
import lancer.Camera;
import lancer.Constantes;
import lancer.Lancer;
import lancer.Scene;
import lancer.image.ImageMemoire;
import lancer.scene.SceneLue;
import org.junit.jupiter.api.Test;

/** La vie d'un dessin dans la fenêtre : lecture, préparation, brouillon puis image, arrêt, échec ; elle ne l'attend jamais. */
class FenetreDessinTest extends EssaiFenetre {

    @Test
    void leBrouillonParaitPuisLImageSAcheve() throws Exception {
        Lancer lancer = new Lancer(new Scene(scene.toString()), new Camera(L, H));
        ImageMemoire brouillon = new ImageMemoire(L, H, false);
        lancer.TracerBrouillon(brouillon, Constantes.REFLETS_BROUILLON, 1);
        banc = new BancFenetre(lente().lent());
        // le dernier pavé : l'image, ralentie, en est loin
        int[] bas = Arrays.copyOfRange(brouillon.codes, (H - 16) * L, H * L);
        attendre("le brouillon est à l'écran", () -> Ecran.trouver(bas, L) != null);
        assertTrue(banc.etat().enCours());
        assertNull(banc.etat().getImageEntiere());
        banc.main.lent = false;
        banc.attendreImage("l'image remplace le brouillon", attendue(L, H));
    }

    @Test
    void lImageEstCelleQuEcriraitLeProgrammeSansFenetre() throws Exception {
        banc = new BancFenetre(lente());
        assertArrayEquals(attendue(L, H), banc.imageAchevee().codes);
        banc.attendreImage("l'écran montre les mêmes pixels", attendue(L, H));
        assertEquals("lancer — boule.ini", banc.cadre.getTitle());
        assertEquals("", texte(banc.sortie) + texte(banc.erreur));
    }

    @Test
    void lAncienneImageResteJusquAuBrouillonDeLaSuivante() throws Exception {
        banc = new BancFenetre(new MainLent(args()) {
            private boolean premiere = true;

            @Override
            void peindre(int ye, Runnable peindre) {
                if (!premiere) {
                    retenir();
                }
                super.peindre(ye, peindre);
            }

            @Override
            public SceneLue lire(String fichier, DoubleConsumer suivi) {
                premiere = getDessin() == null;
                return super.lire(fichier, suivi);
            }
        });
        banc.imageAchevee();
        int[] avant = attendue(L, H);
        attendre("le coût se dit", () -> banc.resume().contains("rayons"));
        banc.frapper(KeyEvent.VK_F5);
        attendre("le dessin suivant a commencé", () -> banc.etat().enCours() && banc.main.getDessin() != null);
        assertArrayEquals(avant, BancFenetre.codes(peinte().getSubimage((banc.panneau.getWidth() - L) / 2, 0, L, H)));
        assertFalse(banc.resume().contains("rayons"), "le coût n'est plus celui de l'image qui vient");
        suite.countDown();
        banc.attendreImage("elle la remplace", avant);
    }

    @Test
    void echapArreteEtF5Recommence() throws Exception {
        banc = new BancFenetre(lente().lent());
        attendre("le brouillon est montré", () -> banc.resume().startsWith("dessin "));
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("le dessin est arrêté", () -> !banc.etat().enCours());
        assertTrue(banc.resume().startsWith("dessin "));
        attendre("plus aucun fil ne dessine", () -> !BancFenetre.vivent("lancer-1") && !BancFenetre.vivent("lancer-2"));
        assertNull(banc.etat().getImageEntiere());
        banc.main.lent = false;
        banc.frapper(KeyEvent.VK_F5);
        banc.attendreImage("F5 recommence", attendue(L, H));
        attendre("le coût remplace l'avancement", () -> banc.resume().startsWith("320 × 240 pixels, "));
    }

    @Test
    void unePanneDuDessinSeLitDansLaFenetreQuiResteUtilisable() throws Exception {
        CountDownLatch repare = new CountDownLatch(1);
        banc = new BancFenetre(new MainLent(args()) {
            @Override
            void tracer(Runnable dessiner) {
                if (repare.getCount() > 0) {
                    throw new IllegalStateException("objet\nmal fait");
                }
                super.tracer(dessiner);
            }
        });
        banc.attendreMessage("échec du programme : java.lang.IllegalStateException: objet\\nmal fait");
        repare.countDown();
        banc.frapper(KeyEvent.VK_F5);
        banc.attendreMessage("");
        banc.attendreImage("l'image est là", attendue(L, H));
        assertEquals("", texte(banc.erreur));
    }

    @Test
    void fermerNeLaisseAucunFil() throws Exception {
        banc = new BancFenetre(lente().lent());
        attendre("le brouillon est fait", () -> banc.main.brouillonFait());
        banc.fermer();
        assertFalse(surFilEvenements(banc.cadre::isDisplayable));
        attendre("plus aucun fil du programme", () -> !BancFenetre.vivent("lancer-"));
    }

    @Test
    void leFilDesEvenementsNAttendNiLaLectureNiLeDessin() throws Exception {
        AtomicBoolean premiere = new AtomicBoolean(true);
        banc = new BancFenetre(lente().lent().avantLecture((fichier, suivi) -> {
            if (!premiere.getAndSet(false)) {
                retenir();
            }
        }));
        attendre("le dessin a commencé", () -> banc.main.getDessin() != null);
        repondA(50);
        assertTrue(banc.etat().enCours(), "le dessin n'a pas eu à finir pour cela");
        banc.frapper(KeyEvent.VK_F5);
        attendre("la lecture se dit", () -> banc.resume().startsWith("lecture "));
        banc.frapper(KeyEvent.VK_F5);
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("arrêté", () -> !banc.etat().enCours());
        repondA(50);
        assertEquals(1, suite.getCount(), "la lecture n'a pas eu à finir pour cela");
        suite.countDown();
        banc.main.lent = false;
        banc.frapper(KeyEvent.VK_F5);
        banc.attendreImage("et tout se remet en marche", attendue(L, H));
    }

    private static void repondA(int questions) throws Exception {
        for (int k = 0; k < questions; k++) {
            surFilEvenements(() -> null);
        }
    }

    @Test
    void ouEnSontLaLectureEtLaPreparationSeDit() throws Exception {
        DoubleConsumer[] suivis = new DoubleConsumer[1];
        banc = new BancFenetre(lente().avantLecture((fichier, suivi) -> {
            if (banc != null) {
                suivis[0] = suivi;
                suivi.accept(0.42);
                retenir();
            }
        }));
        banc.imageAchevee();
        banc.frapper(KeyEvent.VK_F5);
        attendre("la part lue", () -> banc.resume().startsWith("lecture 42 % — ") && banc.avancement.getValue() == 420);
        suivis[0].accept(0.73);
        attendre("elle avance", () -> banc.resume().startsWith("lecture 73 % — "));
        suite.countDown();
        banc.imageAchevee();
    }

    @Test
    void echapPendantUneLectureLaisseLImageEtF5EstALaSceneDemandee() throws Exception {
        Path longue = dossier.resolve("longue.ini");
        Files.write(longue, BLEUE.getBytes(StandardCharsets.UTF_8));
        banc = new BancFenetre(lente().avantLecture((fichier, suivi) -> {
            if (fichier.equals(longue.toString())) {
                retenir();
            }
        }));
        banc.imageAchevee();
        banc.frapperCtrl('O');
        choisir(longue);
        attendre("elle se lit", () -> banc.resume().startsWith("lecture "));
        attendre("le titre est le sien", () -> banc.cadre.getTitle().equals("lancer — longue.ini"));
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("la lecture est arrêtée", () -> !banc.etat().enCours());
        inspecter();
        suite.countDown();
        banc.frapper(KeyEvent.VK_F5);
        scene = longue;
        banc.attendreImage("F5 est à la scène demandée", attendue(L, H));
    }

    /** Un clic sur l'image montrée dit ses rayons, quoi qu'il arrive à la suivante. */
    private void inspecter() throws Exception {
        cliquer(150, 100);
        JTextArea verdict = composant("verdict", JTextArea.class);
        attendre("l'inspecteur répond", () -> verdict.getText().startsWith("Au bit près"));
        banc.frapper(SwingUtilities.getWindowAncestor(verdict), KeyEvent.VK_ESCAPE);
        attendre("puis se ferme", () -> !verdict.isShowing());
    }

    /** Un programme dont la préparation ne finit pas d'elle-même, une fois retenue. */
    private final class PreparationRetenue extends MainLent {
        private volatile boolean retenue;

        PreparationRetenue() {
            super(args());
        }

        @Override
        void tracer(Runnable dessiner) {
            if (retenue) {
                retenir();
            }
            super.tracer(dessiner);
        }
    }

    @Test
    void echapPendantUnePreparationLaisseAussiLeCoutDeLImageMontree() throws Exception {
        Path longue = dossier.resolve("longue.ini");
        Files.write(longue, BLEUE.getBytes(StandardCharsets.UTF_8));
        PreparationRetenue programme = new PreparationRetenue();
        banc = new BancFenetre(programme);
        banc.imageAchevee();
        String avant = banc.resume();
        programme.retenue = true;
        banc.frapperCtrl('O');
        choisir(longue);
        attendre("elle se prépare", () -> banc.resume().startsWith("préparation "));
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("la préparation est arrêtée", () -> !banc.etat().enCours());
        inspecter();
        suite.countDown();
        assertEquals("lancer — longue.ini", banc.cadre.getTitle());
        assertEquals(avant, banc.resume());
    }

    @Test
    void tantQuUnReglageSePrepareLeDessinDAvantNePassePasPourLeSienEtUnAutrePeutSeFaire() throws Exception {
        PreparationRetenue programme = new PreparationRetenue();
        banc = new BancFenetre(programme);
        banc.imageAchevee();
        programme.retenue = true;
        banc.frapper(KeyEvent.VK_ADD);
        attendre("il se prépare", () -> banc.resume().startsWith("préparation "));
        assertNull(banc.main.getDessin());
        assertEquals(0, surFilEvenements(() -> banc.etat().travail.getAvancement()));
        programme.retenue = false;
        banc.frapper(KeyEvent.VK_F5);
        banc.attendreImage("le suivant se fait", attendue("--reflets=10"));
    }
}
