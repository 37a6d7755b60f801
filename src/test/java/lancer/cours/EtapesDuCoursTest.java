package lancer.cours;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Scene;
import lancer.Sphere;
import lancer.essai.Essai;
import lancer.essai.TraceurPlat;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Chaque étape du cours est l'image que donne un programme arrêté là. */
class EtapesDuCoursTest {

    private static final Path SCENE = Path.of("scenes/scene1.ini");
    private static final String TAILLE = "--taille=80x60";

    @TempDir
    Path dossier;

    @Test
    void lambertEtPhongSontLesSommesDuCoursSansOmbre() throws Exception {
        Scene scene = new Scene(SCENE.toString());
        for (String etape : new String[] {"lambert", "phong"}) {
            float[] image = Essai.dessiner(dossier, SCENE, TAILLE, "--etape=" + etape);
            TraceurPlat plat = new TraceurPlat(scene.getObjets(), scene.getLampes(), 80, 60, 0) {
                @Override
                protected Sphere cache(Lampe lampe, double[] X, Sphere boule) {
                    return null;
                }

                @Override
                protected double eclat(double[] V, double[] N, double[] L, double[] R, double ns) {
                    return etape.equals("phong") ? super.eclat(V, N, L, R, ns) : 0;
                }
            };
            for (int k = 0; k < 80 * 60; k++) {
                Couleur attendue = plat.couleur(k % 80 + 0.5, k / 80 + 0.5);
                // un PFM commence par la ligne du bas
                int p = 3 * ((59 - k / 80) * 80 + k % 80);
                assertEquals(attendue.r, image[p], 1e-6, etape + ", pixel " + k % 80 + ", " + k / 80);
                assertEquals(attendue.v, image[p + 1], 1e-6);
                assertEquals(attendue.b, image[p + 2], 1e-6);
            }
        }
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
