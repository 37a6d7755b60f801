package lancer;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * 1500 intersections dont la réponse exacte est connue (rationnels, puis racines sur 1200 bits) : sphères lointaines, minuscules,
 * vues de l'intérieur, de la surface, rasées. Colonnes du fichier : voir son en-tête.
 */
class VecteursTest {

    private static final int NIVEAU_EXIGE = 1;

    @Test
    void chaqueIntersectionDeNiveauUnEstDansSaTolerance() throws IOException {
        List<String> fautes = new ArrayList<>();
        int cas = 0;
        try (BufferedReader entree = new BufferedReader(
                new InputStreamReader(Ressources.ouvrir("vecteurs/vecteurs.txt"), StandardCharsets.UTF_8))) {
            for (String ligne = entree.readLine(); ligne != null; ligne = entree.readLine()) {
                String[] c = ligne.split(" ");
                if (!ligne.startsWith("#") && Integer.parseInt(c[2]) == NIVEAU_EXIGE) {
                    cas++;
                    double t = new Sphere(point(c, 9), nombre(c[12])).getIntersectionDistance(new Rayon(point(c, 3), point(c, 6)));
                    boolean autre = !c[16].equals("-") && convient(t, nombre(c[16]), nombre(c[17]));
                    if (!autre && !convient(t, nombre(c[13]), nombre(c[15]))) {
                        fautes.add("cas " + c[0] + ", " + c[1] + " : " + t + " au lieu de " + c[13]);
                    }
                }
            }
        }
        int lus = cas;
        assertAll(() -> assertEquals(1500, lus), () -> assertTrue(fautes.isEmpty(), fautes::toString));
    }

    private static boolean convient(double t, double attendu, double tolerance) {
        return attendu == Constantes.INFINI ? t == attendu : t > 0 && Math.abs(t - attendu) <= tolerance;
    }

    private static Point point(String[] c, int k) {
        return new Point(nombre(c[k]), nombre(c[k + 1]), nombre(c[k + 2]));
    }

    private static double nombre(String s) {
        return s.equals("inf") ? Constantes.INFINI : Double.parseDouble(s);
    }
}
