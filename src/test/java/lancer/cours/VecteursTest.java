package lancer.cours;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import lancer.Constantes;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.essai.Essai;
import lancer.essai.Exact;
import org.junit.jupiter.api.Test;

/**
 * 1600 intersections dont la réponse exacte est connue (rationnels, puis racines sur 1200 bits) : sphères lointaines, minuscules,
 * vues de l'intérieur, de la surface, rasées, de toutes tailles de 1e-305 à 1e290. Colonnes du fichier : voir son en-tête. Au
 * niveau 2, seul l'arrondi de la direction est pardonné.
 */
class VecteursTest {

    private static final double U = 0x1p-53;

    /** Ce qu'il reste d'une tolérance, dans le pire cas : mesuré 0,235. */
    private static final double PART = 0.5;

    /** Un cas du fichier. */
    private static final class Cas {
        private final String[] c;
        private final Rayon rayon;
        private final Sphere sphere;

        Cas(String ligne) {
            c = ligne.split(" ");
            rayon = new Rayon(point(3), point(6));
            sphere = new Sphere(point(9), nombre(12));
        }

        private double nombre(int k) {
            return c[k].equals("inf") ? Constantes.INFINI : Double.parseDouble(c[k]);
        }

        private Point point(int k) {
            return new Point(nombre(k), nombre(k + 1), nombre(k + 2));
        }

        boolean convient(double t) {
            return convient(t, nombre(13), nombre(15)) || !c[16].equals("-") && convient(t, nombre(16), nombre(17));
        }

        private static boolean convient(double t, double attendu, double tolerance) {
            return attendu == Constantes.INFINI ? t == attendu : t > 0 && Math.abs(t - attendu) <= PART * tolerance;
        }

        @Override
        public String toString() {
            return "cas " + c[0] + ", " + c[1];
        }
    }

    private static List<Cas> cas() throws IOException {
        return Essai.ressource(VecteursTest.class, "/vecteurs/vecteurs.txt").lines().filter(ligne -> !ligne.startsWith("#")).map(Cas::new)
                .collect(Collectors.toList());
    }

    @Test
    void chaqueIntersectionEstDansLaMoitieDeSaTolerance() throws IOException {
        List<String> fautes = new ArrayList<>();
        for (Cas un : cas()) {
            double t = un.sphere.getIntersectionDistance(un.rayon);
            if (!un.convient(t)) {
                fautes.add(un + " : " + t + " au lieu de " + un.c[13]);
            }
        }
        assertEquals(List.of(), fautes);
    }

    @Test
    void chaqueContactEstSurSaSphereEtChaqueNormaleEstDeLongueurUn() throws IOException {
        int touches = 0;
        for (Cas un : cas()) {
            un.sphere.getIntersectionDistance(un.rayon);
            PointContact contact = un.rayon.calcContact();
            if (contact != null) {
                touches++;
                Point centre = un.sphere.getCentre();
                double r = un.sphere.getRayon();
                // + MIN_VALUE : les plus petits cas sont au bord des nombres dénormalisés
                double permis = 4 * U * (r + new Vecteur(new Point(), centre).norme()) + Double.MIN_VALUE;
                double ecart = Exact.ecartALaSurface(contact, centre, r);
                assertTrue(ecart <= permis, un + " : à " + ecart + " de la surface, permis " + permis);
                double longueur = Exact.ecartALUnite(un.sphere.getNormale(contact));
                assertTrue(Math.abs(longueur) <= 4 * U, un + " : normale de longueur 1 + " + longueur);
            }
        }
        assertTrue(touches > 1000, touches + " contacts");
    }
}
