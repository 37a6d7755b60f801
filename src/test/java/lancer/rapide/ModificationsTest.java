package lancer.rapide;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import lancer.essai.Essai;
import lancer.essai.Modification;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Aucune modification sans effet : des lignes des classes du cours sont changées, les classes recompilées, et l'image que la recherche
 * dessine est au bit près celle des boucles du cours, qui n'est plus celle d'avant.
 */
class ModificationsTest {

    @TempDir
    Path dossier;

    /** L'image que ce programme donne d'une petite scène. */
    private float[] dessiner(Essai.Isole programme, String... options) throws IOException {
        Path pfm = dossier.resolve("i.pfm");
        Essai essai = programme.executer(Essai.suite(options, "--fils=1", "--taille=60x45", "--lineaire=" + pfm, "scenes/scene1.ini"));
        assertEquals(0, essai.code, essai.toString());
        return Essai.pfm(Files.readAllBytes(pfm));
    }

    /** Une barre sépare la classe, l'ancien texte et le nouveau. */
    @ParameterizedTest
    @ValueSource(strings = {
        // des rayons qui ne viennent ni de l'œil, ni d'un contact, ni de la lampe
        "Camera|new Vecteur(getOeil(), ecran)|new Vecteur(0, 0, 1)",
        "Objet3D|Rayon.reflechi(contact, R|Rayon.reflechi(contact.add(0.01, N), R",
        "Scene|Rayon.unitaire(lampe.getPosition(), L.neg())|Rayon.unitaire(contact, L.add(new Vecteur(0.3, 0, 0)).normalized())",
        // une question posée au milieu d'une autre, et une liste que la boucle filtre
        "Scene|private final Modele modele;|private final Modele modele; private boolean dedans;"
                + "|Scene|if (objet != saufLui) {|if (!dedans) { dedans = true; getClosestIntersection(new Rayon(incident.getP(), "
                + "incident.getV()), saufLui); dedans = false; } if (objet != saufLui && objet != objets.get(3)) {",
        // une sphère que le dessin déplace avant de commencer
        "Sphere|private final Point centre|public Point centre|Lancer|Lancer lancer = new|Sphere s = (Sphere) "
                + "scene.getObjets().get(2); s.centre = new Point(1, s.centre.y, s.centre.z); Lancer lancer = new"})
    void ceQuUnEtudiantChangeSeVoitAussiParLaRecherche(String changements) throws IOException {
        float[] sansChangement;
        try (Essai.Isole programme = new Essai.Isole(List.of())) {
            sansChangement = dessiner(programme, "--simple");
        }
        String recherche = "rapide/Preparation|return boucles ? scene :|return|";
        try (Essai.Isole programme = Modification.de(dossier, (recherche + changements).split("\\|"))) {
            float[] boucles = dessiner(programme, "--simple");
            assertArrayEquals(boucles, dessiner(programme), "la recherche ne donne pas l'image des boucles");
            assertFalse(Arrays.equals(sansChangement, boucles), "l'image n'a pas changé");
        }
    }

    /** Une sphère qui répond hors de son enveloppe. */
    @Test
    void ceQueLaRechercheCacheraitEstDitEtLesBouclesDessinent() throws IOException {
        try (Essai.Isole change = Modification.de(dossier, "Sphere", "setContact(this, d)", "setContact(this, d = d - 1)")) {
            String image = dossier.resolve("i.png").toString();
            assertEquals(0, change.executer("--simple", "--taille=200x150", "--image", image, "scenes/tournesol.ini").code);
            Essai essai = change.executerAvecRepli("--comparer", image, "scenes/tournesol.ini");
            assertEquals(0, essai.code, essai.toString());
        }
    }
}
