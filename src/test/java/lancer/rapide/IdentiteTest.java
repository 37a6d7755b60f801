package lancer.rapide;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.File;
import java.util.Arrays;
import java.util.Collections;
import java.util.Map;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.contrat.Atmosphere;
import lancer.contrat.Compteurs;
import lancer.contrat.Modele;
import lancer.contrat.Recherche;
import lancer.contrat.Specularite;
import org.junit.jupiter.api.Test;

/** L'image rapide est l'image lisible, au bit près, pour autant de rayons, quel que soit le nombre de fils. */
class IdentiteTest {

    private static final int LARGEUR = 61;
    private static final int HAUTEUR = 47;
    private static final int FOULE = 60;

    @Test
    void scenesDeReference() {
        File[] fichiers = new File("src/test/resources/reference").listFiles((dossier, nom) -> nom.endsWith(".ini"));
        assertTrue(fichiers.length >= 4);
        for (File fichier : fichiers) {
            comparer(fichier.getName(), new Scene(fichier.getPath()), 12);
        }
    }

    @Test
    void scenesDEssai() {
        for (Map.Entry<String, Scene> e : ScenesDEssai.toutes(FOULE).entrySet()) {
            comparer(e.getKey(), e.getValue(), 5);
        }
    }

    @Test
    void longueursExtremes() {
        for (Map.Entry<String, Scene> e : ScenesDEssai.extremes(FOULE).entrySet()) {
            comparer(e.getKey(), e.getValue(), 5);
        }
    }

    @Test
    void reflexionsSansFin() {
        Scene scene = ScenesDEssai.toutes(FOULE).get("tout dans une sphère");
        scene.getModele().setSeuil(0);
        comparer("mille réflexions", scene, 1000);
        comparer("aucune réflexion", scene, 0);
    }

    /** À un cheveu de 1, le carré d'une longueur prend un autre chemin pour se normaliser : le même pour les deux images. */
    @Test
    void uneLampeADistanceUnDUnContact() {
        Sphere boule = new Sphere(new Point(0, 0, 6), 1);
        Sphere bille = new Sphere(new Point(0.74, 0, 4.82), 0.3);
        boule.setKd(new Couleur(0.8));
        bille.setKd(new Couleur(0.8));
        bille.setKs(new Couleur(0.3));
        Scene scene = new Scene(Arrays.asList(boule, bille), Collections.singletonList(new Lampe(new Point(0.8, 0, 4.4), new Couleur(1))));
        Camera camera = new Camera(801, 601);
        for (int k = 0; k < 2000; k++) {
            double xe = 400 + k % 50 * 2.5 + 0.5;
            double ye = 300 - 50 + k / 50 * 2.5 + 0.5;
            scene.getModele().setRecherche(null);
            Couleur lisible = new Lancer(scene, camera).getCouleurPixel(xe, ye, 5);
            scene.getModele().setRecherche(new Preparation(scene, camera).pourUnFil(new Compteurs()));
            assertEquals(lisible, new Lancer(scene, camera).getCouleurPixel(xe, ye, 5), xe + ", " + ye);
        }
    }

    @Test
    void autresContrats() {
        Scene foule = ScenesDEssai.toutes(FOULE).get("foule");
        Modele modele = new Modele();
        modele.setAtmosphere(new Voile());
        modele.setSpecularite((V, N, L, R, ns) -> Specularite.puissance(N.dot(L.sub(V).normalized()), ns / 2));
        comparer("voile et autre reflet", foule.avec(modele), 5);
    }

    /** Une atmosphère qui ne commute avec rien. */
    private static final class Voile implements Atmosphere {
        @Override
        public Couleur traverser(Couleur vue, double distance) {
            double k = 1 - Math.exp(-distance / 10);
            return new Couleur(0.8 * k + (1 - k) * vue.r, 0.7 * k + (1 - k) * vue.v, 0.6 * k + (1 - k) * vue.b);
        }
    }

    static void comparer(String nom, Scene scene, int profondeur) {
        Camera camera = new Camera(LARGEUR, HAUTEUR);
        scene.getModele().setRecherche(null);
        Dessin lisible = new Dessin(scene, camera, profondeur, 2);
        Compteurs premiers = null;
        Preparation preparation = new Preparation(scene, camera);
        if (scene.getObjets().size() <= Long.SIZE) {
            Dessin.de(scene, camera, preparation.masques(), profondeur).verifier(nom + ", masques", lisible);
        }
        Dessin.de(scene, camera, preparation.foule(true), profondeur).verifier(nom + ", cartes", lisible);
        Dessin.de(scene, camera, preparation.foule(false), profondeur).verifier(nom + ", arbre seul", lisible);
        for (int fils : new int[] {1, 2, 7}) {
            scene.getModele().setRecherche(new Preparation(scene, camera));
            Dessin rapide = new Dessin(scene, camera, profondeur, fils);
            rapide.verifier(nom + ", " + fils + " fils", lisible);
            premiers = premiers == null ? rapide.compteurs : premiers;
            assertEquals(premiers.testsSpheres, rapide.compteurs.testsSpheres, nom + ", sphères, fils");
            assertEquals(premiers.noeudsVisites, rapide.compteurs.noeudsVisites, nom + ", nœuds, fils");
        }
    }

    /** Une image et ses comptes. */
    static final class Dessin {

        final Couleur[] pixels;
        final Compteurs compteurs;
        private final int largeur;

        Dessin(Scene scene, Camera camera, int profondeur, int fils) {
            largeur = camera.getLargeur();
            pixels = new Couleur[largeur * camera.getHauteur()];
            Lancer lancer = new Lancer(scene, camera);
            lancer.TracerPixels((couleur, i, j) -> pixels[j * largeur + i] = couleur, profondeur, fils);
            compteurs = lancer.getCompteurs();
        }

        static Dessin de(Scene scene, Camera camera, Recherche recherche, int profondeur) {
            scene.getModele().setRecherche(recherche);
            return new Dessin(scene, camera, profondeur, 2);
        }

        void verifier(String nom, Dessin attendu) {
            for (int k = 0; k < pixels.length; k++) {
                if (!pixels[k].equals(attendu.pixels[k])) {
                    fail(nom + " : pixel (" + k % largeur + ", " + k / largeur + ") " + pixels[k] + ", lisible " + attendu.pixels[k]);
                }
            }
            assertEquals(attendu.compteurs.primaires, compteurs.primaires, nom + ", primaires");
            assertEquals(attendu.compteurs.ombre, compteurs.ombre, nom + ", ombre");
            assertEquals(attendu.compteurs.reflechis, compteurs.reflechis, nom + ", réfléchis");
        }
    }
}
