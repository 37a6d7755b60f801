package lancer.rapide;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import lancer.essai.Essai;
import lancer.essai.Modification;
import lancer.essai.Sommes;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Aucune modification sans effet : une ligne d'une classe du cours est changée, la classe recompilée, et l'image par défaut est au bit
 * près celle des boucles du cours, qui n'est plus celle d'avant ; le récit d'un pixel ne compte pas ce qui n'y est pas.
 */
class ModificationsTest {

    private static final String[] DEMANDE = {"--taille", "120x90", "--fils", "2"};

    /** L'image du programme tel qu'il est. */
    private static byte[] avant;

    @TempDir
    Path dossier;

    @BeforeAll
    static void dessinerSansRienChanger(@TempDir Path commun) throws IOException {
        try (Essai.Isole programme = new Essai.Isole(Collections.<Path>emptyList())) {
            avant = dessiner(programme, commun, "avant");
        }
    }

    private static byte[] dessiner(Essai.Isole programme, Path dossier, String nom, String... options) throws IOException {
        Path image = dossier.resolve(nom + ".pfm");
        String[] tout = Arrays.copyOf(DEMANDE, DEMANDE.length + options.length + 3);
        System.arraycopy(options, 0, tout, DEMANDE.length, options.length);
        tout[tout.length - 3] = "--lineaire";
        tout[tout.length - 2] = image.toString();
        tout[tout.length - 1] = "scenes/scene1.ini";
        Essai essai = programme.executer(tout);
        assertEquals(0, essai.code, essai.toString());
        return Files.readAllBytes(image);
    }

    @ParameterizedTest(name = "{0} : {2}")
    @CsvSource(delimiter = '|', value = {
        "Objet3D | scene.getLumiere(N, R); | scene.getLumiere(N, R); lumiere.ajouter(Kd.mul(0.1));",
        "Objet3D | && !scene.estCachee(lampe, contact, L, versLampe.norme(), this) | ",
        "Objet3D | Math.min(1, N.dot(L)) | 1",
        "Objet3D | V.add(-2 * V.dot(N), N) | V.add(-1.9 * V.dot(N), N)",
        "Objet3D | new Rayon(contact, R, produitKs) | new Rayon(contact.add(0.01, N), R, produitKs)",
        "Objet3D | Vecteur L = versLampe.normalized() | Vecteur L = versLampe.add(new Vecteur(1, 0, 0)).normalized()",
        "Objet3D | Vecteur L = versLampe.normalized() | Vecteur L = versLampe",
        "Objet3D | V.add(-2 * V.dot(N), N).normalized() | V.add(-2 * V.dot(N), N).mul(1.2)",
        "Sphere | double d = Intersection.distance( | double d = 1.01 * Intersection.distance(",
        "Sphere | return n.normalized() | return n.add(new Vecteur(0, 0.3, 0)).normalized()",
        "Sphere | Norme.ecart(carre, rayon) | Norme.ecart(carre, 1.01 * rayon)",
        "Rayon | P.add(distance, V) | P.add(0.99 * distance, V)",
        "Rayon | Couleur getSkyColor() { | Couleur getSkyColor() { if (V.y > 0.1) { return new Couleur(); }",
        "Rayon | Couleur getSkyColor() { | Couleur getSkyColor() { if (V.y < 0) { return new Couleur(); }",
        "Scene | .traverser(couleur, | .traverser(couleur.mul(0.5),",
        "Lancer | camera.getRayon(xe, ye) | camera.getRayon(xe + 0.3, ye)",
        "Camera | new Point(getX(xe), getY(ye), 0) | new Point(getX(xe), getY(ye), 0.1)",
        "Camera | new Vecteur(getOeil(), ecran) | new Vecteur(0, 0, 1)",
        "Camera | new Point(0, 0, -FOCALE) | new Point(0.5, 0.2, -FOCALE)",
        "Camera | new Point(0, 0, -FOCALE) | new Point(0.3, 0.2, -FOCALE - 0.5)",
        "Camera | double FOCALE = | double FOCALE = 0.6 *",
        "Camera | (hauteur / 2.0 - ye) * | (ye - hauteur / 2.0) *",
        "Vecteur | return new Vecteur(-x, -y, -z) | return new Vecteur(-x, y > 0.5 ? -1.2 * y : -y, -z)",
        "Objet3D | Vecteur L = versLampe.normalized() | Vecteur L = versLampe.normalized().mul(N.y > 0.8 ? 1.3 : 1)",
        "Rayon | return P; | return P.y > 1 ? P.add(new Vecteur(0, 0.1, 0)) : P;",
        "Vecteur | x * v.x + y * v.y + z * v.z | x * v.x + y * v.y + 0.9 * z * v.z",
        "Vecteur | new Vecteur(x + k * v.x, y + k * v.y, z + k * v.z) | new Vecteur(x + k * v.x, y + k * v.y, z)",
        "Vecteur | 1.5 - 0.5 * carre | 1.4 - 0.5 * carre",
        "Point | new Point(x + k * v.x, y + k * v.y, z + k * v.z) | new Point(x + k * v.x, y + k * v.y, z + 0.99 * k * v.z)",
        "Couleur | new Couleur(r * c.r, v * c.v, b * c.b) | new Couleur(r * c.r, v * c.v, 0)",
        "Couleur | v + c.v * d.v * k | v",
        "Lumiere | r += c.r | r += 0.5 * c.r",
        "Lumiere | Kd.mul(cosinus, KL) | Kd.mul(0.5 * cosinus, KL)",
        "Lumiere | diffus.add(eclat, Ks, KL) | diffus.add(0.5 * eclat, Ks, KL)",
        "Lampe | return couleur; | return couleur.mul(0.5);",
        "Scene | lampe.getPosition(), L.neg(), distance, objet | lampe.getPosition(), L, distance, objet",
        "Rayon | return V; | return V.add(new Vecteur(0, 1e-10, 0));",
        "precision/Intersection | h2 >= 0 ? c / | h2 >= 0 ? 1.01 * c /",
        "Scene | if (d < distance | if (d < 0.8 * distance",
        "Scene | if (d < distance | if (d < Constantes.INFINI",
        "Scene | if (objets[k] != saufLui) { | if (objets[k] != saufLui && k != 0) {",
        "Scene | objets[plusProche], distance) | objets[plusProche], 1.001 * distance)",
        "Scene | distance = d; | distance = d + 0.01;",
        "Scene | demander(objets[k], ombre) < distance | demander(objets[k], ombre) < 0.7 * distance",
        "Scene | objets[k] != objet && demander | objets[k] != objet && k != 1 && demander",
        "Scene | if (objets[k] != objet | if (k == 0 && objets[k] != objet"})
    void uneLigneChangeeDUneClasseDuCoursSeVoit(String classe, String ancienne, String nouvelle) throws IOException {
        try (Essai.Isole programme = Modification.de(dossier, classe, ancienne, nouvelle)) {
            byte[] simple = dessiner(programme, dossier, "simple", "--simple");
            assertArrayEquals(simple, dessiner(programme, dossier, "defaut"), "l'image par défaut n'est pas celle de --simple");
            assertFalse(Arrays.equals(avant, simple), "l'image n'a pas changé");
            int contacts = 0;
            for (String pixel : new String[] {"60,55", "31,62", "88,49", "12,80"}) {
                Essai dit = programme.executer("--taille", "120x90", "--pixel", pixel, "scenes/scene1.ini");
                assertEquals(0, dit.code, dit.toString());
                contacts += Sommes.de(dit.sortie).size();
                String[] mots = dit.sortie.substring(dit.sortie.lastIndexOf("somme ")).split(" ");
                String[] place = pixel.split(",");
                int debut = 3 * ((89 - Integer.parseInt(place[1])) * 120 + Integer.parseInt(place[0]));
                for (int c = 0; c < 3; c++) {
                    assertEquals(Essai.pfm(simple)[debut + c], (float) Double.parseDouble(mots[1 + c]), dit.sortie);
                }
            }
            assertTrue(contacts > 0, contacts + " contacts dont les termes donnent la somme");
        }
    }
}
