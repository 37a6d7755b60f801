package lancer.mesures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Paths;
import java.util.Arrays;
import java.util.Collections;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.antialias.Antialias;
import lancer.brume.Brume;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Modele;
import lancer.temoins.LancerSurveille;
import org.junit.jupiter.api.Test;

/** La vérité : la moyenne des couleurs de chaque pixel, de plus en plus de sous-pixels. */
class VeriteTest {

    private static final int LARGEUR = 40;
    private static final int HAUTEUR = 30;

    private static Scene cours() {
        return Scenes.lire(Paths.get("scenes/scene1.ini"));
    }

    private static ImageLineaire image(Scene scene, Echantillonnage echantillonnage, int profondeur) {
        Scene copie = Scenes.nue(scene).avec(echantillonnage, Constantes.SEUIL);
        return ImageLineaire.de(LancerSurveille.preparer(copie, LARGEUR, HAUTEUR, false), profondeur, 1);
    }

    /** Tous les sous-pixels, partout. */
    private static Verite entiere(Scene scene, int n) {
        return Verite.desPixels(scene, LARGEUR, HAUTEUR, 5, Constantes.SEUIL, -1, n);
    }

    @Test
    void laOuChaquePixelDoubleJusquAuBoutElleEstAuBitPresLaGrilleCompleteDeLAntialias() {
        Scene scene = cours();
        assertTrue(entiere(scene, 16).image.memesBits(image(scene, Antialias.coins(16, 0), 5)));
        assertTrue(entiere(scene, 32).image.memesBits(image(scene, Antialias.coins(32, 0), 5)));
    }

    @Test
    void elleDitDeCombienElleDiffereDeLImageDeMoitieMoinsDeSousPixels() {
        Scene scene = cours();
        Verite verite = entiere(scene, 32);
        assertEquals(Erreur.rmse(image(scene, Antialias.coins(16, 0), 5), verite.image), verite.reste);
        assertTrue(verite.reste < entiere(scene, 16).reste, "elle s'approche de quelque chose");
    }

    @Test
    void elleNeDoublePasLaOuRienNeChangeEtNYPerdPasPlusQueLaTolerance() {
        Scene scene = cours();
        double tolerance = 0.1 / 255;
        Verite partout = entiere(scene, 32);
        Verite ailleurs = Verite.desPixels(scene, LARGEUR, HAUTEUR, 5, Constantes.SEUIL, tolerance, 32);
        assertTrue(3 * ailleurs.compteurs.primaires < 2 * partout.compteurs.primaires, ailleurs.compteurs.primaires + " rayons");
        double ecart = Erreur.rmse(ailleurs.image, partout.image);
        assertTrue(ecart < tolerance, ecart * 255 + " pas");
    }

    @Test
    void duCielSeulElleSArreteAussitot() {
        Scene vide = new Scene(Collections.<Sphere>emptyList(), Collections.<Lampe>emptyList());
        Verite verite = Verite.desPixels(vide, LARGEUR, HAUTEUR, 5, 0, 1e-4, 64);
        // l'horizon est un bord du ciel, entre deux lignes de pixels
        assertEquals((8 * 8 + 16 * 16) * LARGEUR * HAUTEUR, verite.compteurs.primaires);
        assertTrue(verite.reste < 1e-5);
    }

    @Test
    void dUnBordElleEstLAireQuIlDecoupeDansLePixel() {
        // une boule blanche, sans lampe : noire sur le ciel ; la part noire est l'aire du disque (vu de face, un cercle)
        Sphere boule = new Sphere(new Point(0, 0, 4), 0.5);
        boule.setKd(new Couleur(1));
        Scene scene = new Scene(Collections.singletonList(boule), Collections.<Lampe>emptyList());
        Verite verite = Verite.desPixels(scene, LARGEUR, HAUTEUR, 5, 0, 1e-4, 64);
        Scene vide = new Scene(Collections.<Sphere>emptyList(), Collections.<Lampe>emptyList());
        Verite ciel = Verite.desPixels(vide, LARGEUR, HAUTEUR, 5, 0, 1e-4, 64);
        double aire = 0;
        for (int k = 0; k < LARGEUR * HAUTEUR; k++) {
            aire += 1 - verite.image.getCouleur(k).r / ciel.image.getCouleur(k).r;
        }
        double distance = 4 - Camera.OEIL.z;
        double rayon = Camera.FOCALE * 0.5 / Math.sqrt(distance * distance - 0.25) * LARGEUR / Constantes.ECHELLE;
        assertEquals(Math.PI * rayon * rayon, aire, 0.05);
    }

    @Test
    void sansLimiteDeReflexionsElleEstAtteinteEntreDeuxMiroirs() {
        Sphere devant = new Sphere(new Point(0, 0, -1010), 1000);
        Sphere fond = new Sphere(new Point(0, 0, 1010), 1000);
        for (Sphere miroir : Arrays.asList(devant, fond)) {
            miroir.setKs(new Couleur(0.9));
        }
        Scene scene = new Scene(Arrays.asList(devant, fond), Collections.singletonList(new Lampe(new Point(0, 8, 0), new Couleur(1))));
        Verite verite = Verite.sansLimite(scene, LARGEUR, HAUTEUR);
        assertEquals(0, verite.reste, 1e-12);
        double cinq = Erreur.rmse(image(scene, Echantillonnage.CENTRE, 5), verite.image);
        double vingt = Erreur.rmse(image(scene, Echantillonnage.CENTRE, 20), verite.image);
        assertTrue(cinq > vingt && vingt > 0, cinq + " puis " + vingt);
    }

    @Test
    void elleGardeLaBrumeDeLaSceneEtNeChangeRienACelleCi() {
        Scene scene = cours();
        Verite claire = Verite.sansLimite(scene, LARGEUR, HAUTEUR);
        Modele modele = new Modele();
        modele.setAtmosphere(new Brume());
        Verite brumeuse = Verite.sansLimite(new Scene(scene.getObjets(), scene.getLampes(), modele), LARGEUR, HAUTEUR);
        assertTrue(Erreur.rmse(claire.image, brumeuse.image) > 0.05);
        assertEquals(Constantes.SEUIL, scene.getSeuil());
        assertEquals(Echantillonnage.CENTRE, scene.getEchantillonnage());
    }
}
