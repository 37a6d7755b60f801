package lancer.mesures.juge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import lancer.Camera;
import lancer.CameraPlacee;
import lancer.Couleur;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.systeme.Echec;
import org.junit.jupiter.api.Test;

/** La traduction d'une scène pour POV-Ray. */
class TraductionPovTest {

    private static String texte(Scene scene, int reflets, int juste) {
        return new TraductionPov(scene, reflets, new Camera(ScenesJugees.LARGEUR, ScenesJugees.HAUTEUR)).texte(juste);
    }

    private static void refuse(String raison, Scene scene, int reflets) {
        Echec refus = assertThrows(Echec.class, () -> texte(scene, reflets, 0));
        assertTrue(refus.getMessage().contains(raison), refus.getMessage());
    }

    @Test
    void uneSceneSeTraduitTermeATerme() {
        Scene scene = ScenesJugees.scene(
                ScenesJugees.boule(-0.5, 0, 6, 0.75, new Couleur(0.75, 0.25, 0.125), new Couleur(0.5, 0.25, 0.125)),
                ScenesJugees.boule(1, 0.25, 8, 0.5, new Couleur(0.5), new Couleur()));
        String f = String.valueOf(Camera.FOCALE);
        String loin = String.valueOf(-1024 * Camera.FOCALE);
        assertEquals("#version 3.7;\n"
                + "global_settings { assumed_gamma 1 ambient_light 0 max_trace_level 6 adc_bailout 9.765625E-4 }\n"
                + "camera { perspective location <0.0, 0.0, " + loin + "> direction <0.0, 0.0, " + f + ">"
                + " right <2.0, 0.0, 0.0> up <0.0, 1.5, 0.0> }\n"
                + "sky_sphere {\n"
                + "  pigment {\n"
                + "    function { 0.5 + y / 4 }\n"
                + "    color_map {\n"
                + "      [0.25 rgb <0.5, 0.2, 0.1>]\n"
                + "      [0.5 rgb <0.5, 0.4, 0.1>]\n"
                + "      [0.5 rgb <0.7, 0.7, 1>]\n"
                + "      [0.75 rgb <0, 0, 1>]\n"
                + "    }\n"
                + "  }\n"
                + "}\n"
                + "light_source { <-4096.0, 6144.0, -3072.0> rgb <0.8, 0.8, 0.75> }\n"
                + "light_source { <5120.0, 3072.0, -2048.0> rgb <0.25, 0.25, 0.5> }\n"
                + "sphere { <-512.0, 0.0, 6144.0>, 768.0 pigment { rgb <0.75, 0.25, 0.125> } finish { ambient 0 diffuse 1"
                + " phong 0.25 phong_size 50.0 reflection { rgb <0.5, 0.25, 0.125> } } }\n"
                + "sphere { <1024.0, 256.0, 8192.0>, 512.0 pigment { rgb <0.5, 0.5, 0.5> } finish { ambient 0 diffuse 1 } }\n",
                texte(scene, 5, 1));
    }

    @Test
    void lOeilEtLEcranSontCeuxDeLaCameraDeLaScene() {
        Scene scene = new Scene(List.of(ScenesJugees.boule(5, 0, 0, 1, new Couleur(0.5), new Couleur())), List.of());
        String texte = new TraductionPov(scene, 5, new CameraPlacee(ScenesJugees.LARGEUR, ScenesJugees.HAUTEUR, new Point(1, 2, 3),
                new Vecteur(8, 0, 0), 90)).texte(0);
        assertTrue(texte.contains("location <1024.0, 2048.0, 3072.0> direction <1.0, 0.0, 0.0> right <0.0, 0.0, -2.0>"
                + " up <0.0, 1.5, 0.0> }"), texte);
    }

    @Test
    void ceQuiEstEntreLOeilEtLEcranNeSeVoitPasDirectement() {
        Sphere derriere = ScenesJugees.boule(0, 0, -2, 0.5, new Couleur(0.5), new Couleur());
        Sphere devant = ScenesJugees.boule(0, 0, 6, 0.5, new Couleur(0.5), new Couleur());
        Sphere acote = ScenesJugees.boule(5, 0, -2, 0.5, new Couleur(0.5), new Couleur());
        String[] lignes = texte(ScenesJugees.scene(derriere, devant, acote), 5, 0).split("\n");
        assertTrue(lignes[lignes.length - 3].endsWith(" no_image }"), lignes[lignes.length - 3]);
        assertFalse(lignes[lignes.length - 2].contains("no_image"), lignes[lignes.length - 2]);
        assertFalse(lignes[lignes.length - 1].contains("no_image"), lignes[lignes.length - 1]);
    }

    @Test
    void ceQuePovRayNeSaitPasFaireEstRefuse() {
        refuse("traverse l'écran", ScenesJugees.scene(ScenesJugees.boule(0, 0, 0, 0.5, new Couleur(), new Couleur())), 5);
        refuse("255 reflets", ScenesJugees.deuxBoules(new Couleur(0.5)), 256);
        Scene sansPoli = ScenesJugees.deuxBoules(new Couleur(0.5));
        sansPoli.getObjets().get(1).setNs(0);
        refuse("ns=0", sansPoli, 5);
        refuse("pas une sphère", ScenesJugees.scene(new Plan()), 5);
    }

    /** Un objet qui n'est pas une sphère. */
    private static final class Plan extends Objet3D {
        @Override
        public double getIntersectionDistance(Rayon incident) {
            incident.setContact(this, Double.POSITIVE_INFINITY);
            return Double.POSITIVE_INFINITY;
        }

        @Override
        public Vecteur getNormale(Point contact) {
            return new Vecteur(0, 1, 0);
        }
    }
}
