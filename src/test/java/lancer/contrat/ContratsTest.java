package lancer.contrat;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.Field;
import java.util.List;
import java.util.Random;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import org.junit.jupiter.api.Test;

/** Les contrats par défaut : le partage de l'image, la recherche du cours. */
class ContratsTest {

    @Test
    void lesPavesCouvrentLImageUneSeuleFoisEtAucunNEstVide() {
        int[] cotes = {1, 2, 31, 32, 33, 63, 64, 65, 100};
        for (int largeur : cotes) {
            for (int hauteur : cotes) {
                int[] fois = new int[largeur * hauteur];
                for (Pave p : Pave.battus(largeur, hauteur)) {
                    assertTrue(p.i0 < p.i1 && p.j0 < p.j1, "pavé vide, " + largeur + " × " + hauteur);
                    for (int j = p.j0; j < p.j1; j++) {
                        for (int i = p.i0; i < p.i1; i++) {
                            fois[j * largeur + i]++;
                        }
                    }
                }
                for (int f : fois) {
                    assertEquals(1, f, largeur + " × " + hauteur);
                }
            }
        }
    }

    @Test
    void lesBouclesDuCoursEssaientUneFoisChaqueAutreObjet() {
        List<Objet3D> objets = List.of(boule(5), boule(20), boule(10));
        Lampe lampe = new Lampe(new Point(0, 0, 40), new Couleur(1));
        Scene scene = new Scene(objets, List.of(lampe));
        Compteurs compteurs = scene.getCompteurs();
        Rayon rayon = new Rayon(new Point(0, 0, 0), new Point(0, 0, 1));
        assertSame(objets.get(2), scene.getClosestIntersection(rayon, objets.get(0)).objet);
        assertSame(objets.get(2), rayon.getObjet());
        assertEquals(2, compteurs.testsSpheres);
        assertSame(objets.get(0), scene.getClosestIntersection(rayon).objet);
        assertEquals(5, compteurs.testsSpheres);

        // une lampe derrière tout : seul le premier objet trouvé est essayé
        assertTrue(scene.estCachee(lampe, new Point(0, 0, 4), new Vecteur(0, 0, 1), 36, objets.get(0)));
        assertEquals(6, compteurs.testsSpheres);
    }

    @Test
    void unRayonDOmbreEnDeuxMoitiesEstCompteUneFoisEtRencontreCeQuiEstDansChacune() {
        Scene scene = new Scene(List.of(boule(5)), List.of());
        double loin = 2 * Constantes.LOINTAINE * 4;
        Lampe lampe = new Lampe(new Point(0, 0, -loin), new Couleur(1));
        Point contact = new PointContact(new Point(0, 0, 4), scene.getObjets().get(0), 4);
        assertTrue(Scene.estLointaine(lampe, contact));
        assertFalse(scene.estCachee(lampe, contact, new Vecteur(0, 0, -1), loin + 4, null));
        assertEquals(1, scene.getCompteurs().ombre);
        assertEquals(2, scene.getCompteurs().testsSpheres);
        for (double part : new double[] {0.1, 0.4, 0.6, 0.9}) {
            Scene cachee = new Scene(List.of(boule(4 - part * loin)), List.of());
            assertTrue(cachee.estCachee(lampe, contact, new Vecteur(0, 0, -1), loin + 4, null), "à " + part + " du chemin");
        }
    }

    /** Strictement entre les deux : deux boules qui se touchent là où l'on regarde ne s'y font pas d'ombre. */
    @Test
    void unObjetQuiToucheLeContactNeLeCachePas() {
        Objet3D eclairee = new Sphere(new Point(0, 3, 4), 3);
        Objet3D autre = new Sphere(new Point(0, 0, 5), 1);
        Lampe lampe = new Lampe(new Point(0, 0, 0), new Couleur(1));
        Scene scene = new Scene(List.of(eclairee, autre), List.of(lampe));
        Vecteur L = new Vecteur(0, 0, -1);
        assertEquals(4, autre.getIntersectionDistance(new Rayon(new Point(0, 0, 0), new Point(0, 0, 4))));
        assertFalse(scene.estCachee(lampe, new Point(0, 0, 4), L, 4, eclairee));
        double loin = Math.nextUp(4.0);
        assertTrue(scene.estCachee(lampe, new Point(0, 0, loin), L, loin, eclairee));
    }

    @Test
    void lesComptesDeDeuxFilsSAdditionnent() throws IllegalAccessException {
        Compteurs un = new Compteurs();
        Compteurs deux = new Compteurs();
        long k = 1;
        for (Field compte : Compteurs.class.getFields()) {
            compte.setLong(un, k);
            compte.setLong(deux, 1000 * k++);
        }
        un.ajouter(deux);
        k = 1;
        for (Field compte : Compteurs.class.getFields()) {
            assertEquals(1001 * k++, compte.getLong(un), compte.getName());
        }
        assertEquals(un.primaires + un.ombre + un.reflechis, un.rayons());
        assertTrue(un.ombre > 0 && un.reflechis > 0);
    }

    /** Un exposant puissance de deux est une suite de carrés, sans un arrondi de plus ; l'autre bord est celui de {@link Math#pow}. */
    @Test
    void unPetitExposantEntierSeFaitParCarresSuccessifsEtToutAutreParPow() {
        Random hasard = new Random(47);
        for (int k = 0; k < 2_000; k++) {
            double cosinus = k % 2 == 0 ? hasard.nextDouble() : Math.nextDown(1 - hasard.nextDouble() / 1000);
            double carre = cosinus;
            for (int n = 1; n <= Specularite.EXPOSANT_ENTIER_MAX; n *= 2) {
                assertEquals(carre, Specularite.puissance(cosinus, n), cosinus + "^" + n);
                carre *= carre;
            }
            int n = 1 + hasard.nextInt(Specularite.EXPOSANT_ENTIER_MAX);
            double pow = Math.pow(cosinus, n);
            assertEquals(pow, Specularite.puissance(cosinus, n), 2 * n * 0x1p-53 * pow + Double.MIN_NORMAL, cosinus + "^" + n);
            for (double exposant : new double[] {0.3, 7.5, n + 0.25, Specularite.EXPOSANT_ENTIER_MAX + n, 1e9}) {
                assertEquals(Math.pow(cosinus, exposant), Specularite.puissance(cosinus, exposant), cosinus + "^" + exposant);
            }
        }
    }

    private static Sphere boule(double z) {
        return new Sphere(new Point(0, 0, z), 1);
    }
}
