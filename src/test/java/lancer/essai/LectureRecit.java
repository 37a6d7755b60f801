package lancer.essai;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import lancer.texte.Nombre;

/** Les lignes de {@code --pixel}, lues l'une après l'autre, et leurs nombres. */
class LectureRecit {

    List<String> lignes;
    int suivante;

    void ouvrir(String sortie) {
        lignes = dansLOrdreDesRayons(sortie.split("\\R"));
        suivante = 0;
    }

    /** Les lignes, le premier contact d'abord : le récit va du dernier, dont la somme sert, au premier. */
    private static List<String> dansLOrdreDesRayons(String[] dites) {
        List<String> lignes = new ArrayList<>();
        int debut = -1;
        int suite = 0;
        for (String ligne : dites) {
            debut = debut < 0 && ligne.matches("\\d+  .*") ? lignes.size() : debut;
            boolean fin = ligne.startsWith("somme ");
            int place = fin || debut < 0 ? lignes.size() : ligne.startsWith(" ") ? suite : debut;
            lignes.add(place, ligne);
            suite = place + 1;
        }
        return lignes;
    }

    String actuelle() {
        return lignes.get(suivante);
    }

    /** Ce que dit d'abord, plus bas, une ligne qui commence ainsi. */
    double[] chercher(String debut) {
        return nombres(lignes.stream().skip(suivante).filter(ligne -> ligne.startsWith(debut)).findFirst().get().substring(debut.length()));
    }

    double[] lire(String debut) {
        String ligne = lignes.get(suivante++);
        assertTrue(ligne.startsWith(debut), ligne + " au lieu de " + debut);
        return nombres(ligne.substring(debut.length()));
    }

    static double[] nombres(String texte) {
        List<Double> lus = new ArrayList<>();
        for (String mot : texte.trim().split(" +")) {
            if (mot.matches("-?[\\d.]+([eE]-?\\d+)?")) {
                double lu = Double.parseDouble(mot);
                lus.add(lu);
                assertTrue(mot.equals(Double.toString(lu)) || mot.equals(Nombre.ecrire(lu)), mot);
            }
        }
        return lus.stream().mapToDouble(n -> n).toArray();
    }

    /** Aux arrondis près, qui grandissent d'un reflet au suivant. */
    void proche(double[] attendu, double[] dit) {
        assertNotNull(dit);
        assertEquals(attendu.length, dit.length, () -> "ligne " + suivante + " : " + lignes.get(suivante - 1));
        for (int c = 0; c < attendu.length; c++) {
            assertEquals(attendu[c], dit[c], 1e-7 * (1 + Math.abs(attendu[c])), lignes.get(suivante - 1));
        }
    }
}
