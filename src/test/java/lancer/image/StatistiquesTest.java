package lancer.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import lancer.essai.EssaiCommande;
import org.junit.jupiter.api.Test;

/** Ce que dit {@code --statistiques}. */
class StatistiquesTest extends EssaiCommande {

    private Map<String, String> statistiques(String... options) {
        String[] arguments = Arrays.copyOf(options, options.length + 2);
        arguments[options.length] = "--statistiques";
        arguments[options.length + 1] = "--image=" + png;
        Map<String, String> valeurs = new LinkedHashMap<>();
        for (String ligne : dessiner(arguments).split("\r?\n")) {
            assertTrue(ligne.matches("[a-z]+(\\.[a-z]+)+: [0-9]+(\\.[0-9]+)?"), ligne);
            String[] moities = ligne.split(": ");
            assertEquals(null, valeurs.put(moities[0], moities[1]), ligne);
        }
        return valeurs;
    }

    @Test
    void lesStatistiquesOntUnPointDecimalDansToutesLesLangues() {
        Locale avant = Locale.getDefault();
        try {
            for (Locale langue : new Locale[] {Locale.FRANCE, Locale.ROOT, Locale.forLanguageTag("ar-EG-u-nu-arab"),
                Locale.forLanguageTag("tr-TR"), Locale.forLanguageTag("th-TH-u-nu-thai")}) {
                Locale.setDefault(langue);
                Map<String, String> valeurs = statistiques();
                for (String nom : new String[] {"rayons.primaires", "rayons.ombre", "rayons.reflechis", "tests.spheres", "noeuds.visites",
                    "pixels.raffines", "rayons.par.seconde"}) {
                    assertTrue(valeurs.get(nom).matches("[0-9]+"), nom + " : " + valeurs.get(nom));
                }
                for (String nom : new String[] {"lecture.ms", "preparation.ms", "trace.ms"}) {
                    assertTrue(valeurs.get(nom).matches("[0-9]+\\.[0-9]{3}"), nom + " : " + valeurs.get(nom));
                }
            }
        } finally {
            Locale.setDefault(avant);
        }
    }

    @Test
    void lesTempsSontVraisemblables() {
        long debut = System.nanoTime();
        Map<String, String> valeurs = statistiques("--fils=1");
        double mur = (System.nanoTime() - debut) / 1e6;
        double somme = Double.parseDouble(valeurs.get("lecture.ms")) + Double.parseDouble(valeurs.get("preparation.ms"))
                + Double.parseDouble(valeurs.get("trace.ms"));
        assertTrue(somme > 0 && somme <= mur, somme + " ms sur " + mur);
        long rayons = Long.parseLong(valeurs.get("rayons.primaires")) + Long.parseLong(valeurs.get("rayons.ombre"))
                + Long.parseLong(valeurs.get("rayons.reflechis"));
        double attendu = rayons / (Double.parseDouble(valeurs.get("trace.ms")) / 1000);
        assertEquals(1, Double.parseDouble(valeurs.get("rayons.par.seconde")) / attendu, 0.01);
    }
}
