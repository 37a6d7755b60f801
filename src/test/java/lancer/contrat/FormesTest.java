package lancer.contrat;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import lancer.Point;
import lancer.Rayon;
import lancer.Vecteur;
import lancer.essai.Essai;
import org.junit.jupiter.api.Test;

/** La forme d'étudiant de docs/etendre.md se voit, s'éclaire, se reflète et porte ombre comme une boule. */
class FormesTest extends EssaiFormes {

    private float[] dessiner(String taille, String... lignes) throws IOException {
        return Essai.dessinerAvec(Collections.singletonList(classesDuPanneau), dossier, Essai.scene(scene, lignes), "--taille", taille);
    }

    @Test
    void laClasseLaLigneEtLaSceneDuReadmeSeCopientTellesQuelles() throws IOException {
        inscrire(dossier, SERVICE, blocs.get(0));
        assertTrue(blocs.get(1).contains("\necho " + lireTexte(dossier.resolve(SERVICE)).trim() + " >> "), blocs.get(1));
        float[] image = Essai.dessinerAvec(Collections.singletonList(dossier), dossier, Essai.scene(scene, blocs.get(2)), "--taille=4x2");
        // en haut le ciel ; en bas, sans lampe, un cinquième de ce ciel, que le sol reflète
        assertEquals(image[12] * 0.2, image[0], 1e-7);
    }

    @Test
    void leDamierDeLaPageADeuxCouleursDontLesTermesSAjoutent() throws IOException {
        inscrire(dossier, SERVICE, blocs.get(0).replaceFirst("\n}\n", "\n\n" + bloc("getKd(Point contact)") + "}\n"));
        String sol = "[Plan]\npoint=0 -1 0\nnormale=0 1 0\nKd=0.9 0.9 0.9\n[Lampe 1]\nposition=0 9 3\ncouleur=1 1 1";
        float[] image = Essai.dessinerAvec(Collections.singletonList(dossier), dossier, Essai.scene(scene, sol), "--taille", "8x6");
        // la première rangée d'un PFM est celle du bas : le sol, où deux cases voisines sont de Kd 0.9 et 0.1
        double plusClair = 0;
        double plusSombre = 1;
        for (int x = 0; x < 8; x++) {
            plusClair = Math.max(plusClair, image[3 * x]);
            plusSombre = Math.min(plusSombre, image[3 * x]);
        }
        assertTrue(plusClair > 0.5 && plusSombre > 0 && plusSombre < 0.1, plusClair + " " + plusSombre);
        try (Essai.Isole isole = new Essai.Isole(Collections.singletonList(dossier))) {
            String recit = isole.executer("--taille=8x6", "--pixel=0,5", scene.toString()).toString();
            assertTrue(recit.startsWith("statut 0") && recit.contains("somme ") && !recit.contains("que le récit ne connaît pas"), recit);
        }
    }

    private static String bloc(String contient) {
        return blocs.stream().filter(bloc -> bloc.contains(contient)).findFirst().get();
    }

    // ce que voit le rayon du milieu, qui part de (0, 0, 0) vers les z croissants

    private static final String BLANC = "Kd=1 1 1";
    /** Vue de (0, 0, 5) : 3 de côté, 4 en arrière. */
    private static final String LAMPE = "[Lampe 1]\nposition=3 0 1\ncouleur=1 1 1";

    private void verifierVue(double attendu, String... lignes) throws IOException {
        assertEquals(attendu, dessiner("1x1", lignes)[0], 1e-7);
    }

    @Test
    void elleEstVueEtEclaireeSelonSaMatiere() throws IOException {
        verifierVue(0.8, MUR, BLANC, LAMPE);
        verifierVue(0.2, MUR, "Kd=0.25 0 0", LAMPE);
        // le reflet de la lampe, et celui du ciel à l'horizon
        double ciel = new Rayon(new Point(), new Vecteur(0, 0, -1)).getSkyColor().r;
        verifierVue(1 + ciel, MUR, "Kr=1 1 1", "ns=0", LAMPE);
        verifierVue(0, MUR, LAMPE);
    }

    @Test
    void laPlusProcheCacheLesAutres() throws IOException {
        verifierVue(0.8, "[Sphere 1]", "centre=0 0 8", "rayon=1", MUR, BLANC, LAMPE);
        verifierVue(0.8, MUR, BLANC, LAMPE, "[Sphere 1]", "centre=0 0 8", "rayon=1");
        verifierVue(0, "[Sphere 1]", "centre=0 0 3", "rayon=1", MUR, BLANC, LAMPE);
        verifierVue(0, MUR, BLANC, LAMPE, "[Sphere 1]", "centre=0 0 3", "rayon=1");
        // au même endroit, la première du fichier
        verifierVue(0, MUR, "[panneau noir]", "point=0 0 5", "normale=0 0 -1", "[PANNEAU]", "point=0 0 5", "normale=0 0 -1", BLANC, LAMPE);
    }

    @Test
    void elleRecoitDesOmbresEtEnPorte() throws IOException {
        verifierVue(0, MUR, BLANC, LAMPE, "[Sphere 1]", "centre=1.5 0 3", "rayon=0.3");
        String[] boule = {"[Sphere 1]", "centre=0 0 5", "rayon=1", BLANC, LAMPE, ""};
        verifierVue(Math.sqrt(0.5), boule);
        boule[5] = "[Panneau]\npoint=2 0 0\nnormale=1 0 0";
        verifierVue(0, boule);
    }

    @Test
    void uneBouleLaReflete() throws IOException {
        verifierVue(0.8, "[Sphere miroir]", "centre=0 0 5", "rayon=1", "Ks=1 1 1", "ns=1e9",
                "[Panneau derrière l'œil]", "point=0 0 -3", "normale=0 0 1", BLANC, LAMPE);
    }

    @Test
    void chaqueQuestionQuOnLuiPoseEstComptee() throws IOException {
        Path fichier = Essai.scene(scene, MUR, BLANC, "[Panneau sol]", "point=0 -1 0", "normale=0 1 0", LAMPE);
        for (String option : new String[] {"--simple", "--fils=2"}) {
            Essai e = Essai.executerAvec(Collections.singletonList(classesDuPanneau), "--statistiques", option,
                    "--taille=1x1", "--lineaire", dossier.resolve("image.pfm").toString(), fichier.toString());
            assertEquals(1, e.statistique("rayons.ombre"), e.toString());
            // les deux par le rayon de l'écran, le sol par celui de la lampe
            assertEquals(3, e.statistique("tests.spheres"), e.toString());
        }
    }

    @Test
    void unVecteurTresCourtOuTresLongDonneUneDirection() throws IOException {
        for (String z : new String[] {"-1e-300", "-4.9e-324", "-1e100"}) {
            verifierVue(0.8, "[Panneau]", "point=0 0 5", "normale=0 0 " + z, BLANC, LAMPE);
        }
    }

    @Test
    void uneCouleurDonneeParLaFormeVautLaOuLaSectionNEnDitRien() throws IOException {
        Path classes = inscrire(SERVICE, panneau.replace("return panneau;", "panneau.setKd(new Couleur(0.5)); return panneau;"));
        List<Path> chemin = Collections.singletonList(classes);
        assertEquals(0.4, Essai.dessinerAvec(chemin, dossier, Essai.scene(scene, MUR, LAMPE), "--taille=1x1")[0], 1e-7);
        assertEquals(0.8, Essai.dessinerAvec(chemin, dossier, Essai.scene(scene, MUR, BLANC, LAMPE), "--taille=1x1")[0], 1e-7);
    }
}
