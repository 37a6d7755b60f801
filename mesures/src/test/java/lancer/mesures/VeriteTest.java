package lancer.mesures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Paths;
import java.util.Arrays;
import java.util.Collections;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Main;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.antialias.Antialias;
import lancer.brume.Brume;
import lancer.contrat.Echantillonnage;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

@DisplayName("La vérité")
class VeriteTest {

    private static final int LARGEUR = 40;
    private static final int HAUTEUR = 30;

    private static Scene cours() {
        return Scenes.lire(Paths.get("scenes/scene1.ini"));
    }

    private static ImageLineaire image(Scene scene, Echantillonnage echantillonnage, int profondeur) {
        Scene copie = Scenes.nue(scene);
        copie.setEchantillonnage(echantillonnage);
        return ImageLineaire.de(Main.preparer(copie, LARGEUR, HAUTEUR, false), profondeur, 1);
    }

    @Test
    @DisplayName("du ciel seul est celle de la formule : un dégradé que les sous-pixels suivent au carré de leur pas")
    void leCielSeul() {
        Scene vide = new Scene(Collections.<Sphere>emptyList(), Collections.<Lampe>emptyList());
        Verite fine = Verite.desPixels(vide, LARGEUR, HAUTEUR, 5, 0, 0);
        assertEquals(Verite.N_MAX, fine.effort);
        // la formule du milieu : l'erreur d'une moyenne de n × n points décroît comme 1/n² là où la fonction est lisse
        double reste = Erreur.rmse(image(vide, new Moyenne(4), 5), image(vide, new Moyenne(8), 5));
        double moitie = Erreur.rmse(image(vide, new Moyenne(8), 5), image(vide, new Moyenne(16), 5));
        assertTrue(reste < 2e-4 && moitie < reste, reste + " puis " + moitie);
        Couleur haut = new Lancer(vide, new Camera(LARGEUR, HAUTEUR)).getCouleurPixel(20, 0.5, 5);
        assertEquals(haut.r, fine.image.getCouleur(20).r, 1e-3);
    }

    @Test
    @DisplayName("ne s'arrête de doubler que si deux images de suite se ressemblent assez, et dit de combien")
    void elleDouble() {
        Scene scene = cours();
        Verite grossiere = Verite.desPixels(scene, LARGEUR, HAUTEUR, 5, Constantes.SEUIL, 1);
        assertEquals(8, grossiere.effort);
        Verite fine = Verite.desPixels(scene, LARGEUR, HAUTEUR, 5, Constantes.SEUIL, grossiere.reste * 0.9);
        assertTrue(fine.effort > 8, "n = " + fine.effort);
        assertTrue(fine.reste <= grossiere.reste * 0.9);
        assertEquals(fine.reste, Erreur.rmse(image(scene, new Moyenne(fine.effort / 2), 5), fine.image));
    }

    @Test
    @DisplayName("d'un bord est l'aire qu'il découpe dans le pixel")
    void unBord() {
        // une boule blanche, sans lampe : noire sur le ciel ; la part noire est l'aire du disque (vu de face, un cercle)
        Sphere boule = new Sphere(new Point(0, 0, 4), 0.5);
        boule.setKd(new Couleur(1));
        Scene scene = new Scene(Collections.singletonList(boule), Collections.<Lampe>emptyList());
        Verite verite = Verite.desPixels(scene, LARGEUR, HAUTEUR, 5, 0, 0);
        Scene vide = new Scene(Collections.<Sphere>emptyList(), Collections.<Lampe>emptyList());
        Verite ciel = Verite.desPixels(vide, LARGEUR, HAUTEUR, 5, 0, 0);
        double aire = 0;
        for (int k = 0; k < LARGEUR * HAUTEUR; k++) {
            aire += 1 - verite.image.getCouleur(k).r / ciel.image.getCouleur(k).r;
        }
        double distance = 4 - Camera.OEIL.z;
        double rayon = Camera.FOCALE * 0.5 / Math.sqrt(distance * distance - 0.25) * LARGEUR / Constantes.ECHELLE;
        assertEquals(Math.PI * rayon * rayon, aire, 0.02);
    }

    @Test
    @DisplayName("de tous les sous-pixels est, au bit près, la grille complète du module antialias")
    void laMoyenneEstCelleDeLAntialias() {
        Scene scene = cours();
        assertTrue(image(scene, new Moyenne(3), 5).memesBits(image(scene, Antialias.coins(3, 0), 5)));
        assertFalse(image(scene, new Moyenne(3), 5).memesBits(image(scene, new Moyenne(4), 5)));
    }

    @Test
    @DisplayName("sans limite de réflexions est atteinte entre deux miroirs")
    void deuxMiroirs() {
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
    @DisplayName("garde la brume de la scène, et ne change rien à celle-ci")
    void laBrumeEstGardee() {
        Scene scene = cours();
        Verite claire = Verite.sansLimite(scene, LARGEUR, HAUTEUR);
        scene.setAtmosphere(new Brume());
        Verite brumeuse = Verite.sansLimite(scene, LARGEUR, HAUTEUR);
        assertTrue(Erreur.rmse(claire.image, brumeuse.image) > 0.05);
        assertEquals(Constantes.SEUIL, scene.getSeuil());
        assertEquals(Echantillonnage.CENTRE, scene.getEchantillonnage());
    }
}
