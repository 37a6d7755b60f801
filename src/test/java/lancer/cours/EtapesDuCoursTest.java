package lancer.cours;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.nio.file.Paths;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Vecteur;
import lancer.essai.Essai;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Chaque étape du cours est l'image que donne un programme arrêté là. */
class EtapesDuCoursTest {

    private static final Path SCENE = Paths.get("scenes/scene1.ini");
    private static final String TAILLE = "--taille=80x60";

    @TempDir
    Path dossier;

    @Test
    void lambertEtPhongSontLesSommesDuCoursSansOmbre() throws Exception {
        Scene scene = new Scene(SCENE.toString());
        Camera camera = new Camera(80, 60);
        for (String etape : new String[] {"lambert", "phong"}) {
            float[] image = Essai.dessiner(dossier, SCENE, TAILLE, "--etape=" + etape);
            for (int k = 0; k < 80 * 60; k++) {
                Couleur attendue = couleur(scene, camera.getRayon(k % 80 + 0.5, k / 80 + 0.5), etape.equals("phong"));
                // un PFM commence par la ligne du bas
                int p = 3 * ((59 - k / 80) * 80 + k % 80);
                assertEquals(attendue.r, image[p], 1e-6, etape + ", pixel " + k % 80 + ", " + k / 80);
                assertEquals(attendue.v, image[p + 1], 1e-6);
                assertEquals(attendue.b, image[p + 2], 1e-6);
            }
        }
    }

    /** Le cours, récrit : Kd ⊗ KL max(0, N·L), plus Ks ⊗ KL max(0, R·L)^ns. */
    private static Couleur couleur(Scene scene, Rayon rayon, boolean phong) {
        PointContact contact = scene.getClosestIntersection(rayon);
        if (contact == null) {
            return rayon.getSkyColor();
        }
        Objet3D objet = contact.objet;
        Vecteur N = objet.getNormale(contact);
        Vecteur V = rayon.getV();
        Vecteur R = V.sub(N.mul(2 * V.dot(N)));
        Couleur somme = new Couleur();
        for (Lampe lampe : scene.getLampes()) {
            Vecteur L = new Vecteur(contact, lampe.getPosition()).normalized();
            if (N.dot(L) > 0) {
                somme = somme.add(objet.getKd().mul(lampe.getCouleur()).mul(N.dot(L)));
                if (phong) {
                    somme = somme.add(objet.getKs().mul(lampe.getCouleur()).mul(Math.pow(Math.max(0, R.dot(L)), objet.getNs())));
                }
            }
        }
        return somme;
    }

    @Test
    void ombresEstSansReflexionEtRefletsEstLeProgrammeEntier() throws Exception {
        for (String simple : new String[] {"--fils=2", "--simple"}) {
            assertArrayEquals(Essai.dessiner(dossier, SCENE, TAILLE, simple, "--reflets=0"),
                    Essai.dessiner(dossier, SCENE, TAILLE, simple, "--etape=ombres"));
            assertArrayEquals(Essai.dessiner(dossier, SCENE, TAILLE, simple),
                    Essai.dessiner(dossier, SCENE, TAILLE, simple, "--etape=reflets"));
            assertArrayEquals(Essai.dessiner(dossier, SCENE, TAILLE, "--fils=1", "--etape=lambert"),
                    Essai.dessiner(dossier, SCENE, TAILLE, simple, "--etape=lambert"));
        }
    }

    @Test
    void sansOmbreNiReflexionAucunDeCesRayonsNEstDemande() {
        Essai essai = Essai.executer(TAILLE, "--etape=phong", "--statistiques", "--image", dossier.resolve("i.png").toString(),
                SCENE.toString());
        assertEquals(0, essai.code, essai.toString());
        assertEquals("rayons.primaires: 4800\nrayons.ombre: 0\nrayons.reflechis: 0",
                essai.sortie.replace(System.lineSeparator(), "\n").substring(0, essai.sortie.indexOf("\ntests")));
    }
}
