package lancer.auto;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import lancer.Couleur;
import lancer.contrat.Pave;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Les pixels qu'on essaie, et ce qu'on en conclut. */
class SemisTest {

    @ParameterizedTest
    @CsvSource({"1, 1", "2, 2", "3, 2", "1, 16384", "200, 150", "201, 151", "800, 600", "10000, 10000"})
    void lesBlocsDuChoixEtDuControleSontDansLImageEtTousDifferents(int largeur, int hauteur) {
        Semis semis = new Semis(largeur, hauteur);
        Set<Integer> vus = new HashSet<>();
        for (List<Pave> blocs : Arrays.asList(semis.choix, semis.controle)) {
            for (Pave bloc : blocs) {
                assertTrue(0 <= bloc.i0 && bloc.i0 < bloc.i1 && bloc.i1 <= largeur && 0 <= bloc.j0 && bloc.j0 < bloc.j1
                        && bloc.j1 <= hauteur);
                assertTrue(vus.add(bloc.j0 * largeur + bloc.i0), "un bloc deux fois");
            }
        }
        assertEquals(Math.max(1, Math.min(4000, Pave.nombre(largeur, hauteur, Essais.COTE) / 2)), semis.choix.size());
        assertEquals(Pave.nombre(largeur, hauteur, Essais.COTE) == 1 ? 0 : semis.choix.size(), semis.controle.size());
    }

    @Test
    void uneMesureQuiSuitLesPromessesEstEstimeeSansErreur() {
        List<Pave> blocs = new Semis(200, 150).choix;
        Random hasard = new Random(3);
        double[] promesses = hasard.doubles(blocs.size(), 0.05, 1).toArray();
        Tirage tirage = new Tirage(100, blocs, promesses, 1);
        double[] mesures = new double[tirage.blocs.size()];
        for (int k = 0; k < mesures.length; k++) {
            mesures[k] = 7 * promesses[blocs.indexOf(tirage.blocs.get(k))];
        }
        double moyenne = 7 * Arrays.stream(promesses).average().getAsDouble();
        assertEquals(Math.sqrt(moyenne), tirage.estimer(mesures).erreur(), 1e-9);
    }

    @Test
    void leTirageEstSansBiais() {
        // une mesure sans rapport avec les promesses, sur beaucoup de semis de même loi
        int semis = 400;
        double somme = 0;
        for (int graine = 0; graine < semis; graine++) {
            Random hasard = new Random(graine);
            List<Pave> blocs = new Semis(200, 150).choix;
            double[] promesses = hasard.doubles(blocs.size(), 0.05, 1).toArray();
            Tirage tirage = new Tirage(100, blocs, promesses, 1);
            double carre = tirage.estimer(hasard.doubles(tirage.blocs.size(), 0, 2).toArray()).erreur();
            somme += carre * carre;
        }
        // l'écart type de chaque estimation est d'environ 0,2
        assertEquals(1, somme / semis, 4 * 0.2 / Math.sqrt(semis));
    }

    @Test
    void lIncertitudeEstCelleDuHasard() {
        double[] mesures = new Random(5).doubles(10_000, 0, 12).toArray();
        Estimation e = Estimation.de(mesures);
        // moyenne 6 et variance 12² / 12 d'un nombre au hasard de 0 à 12
        assertEquals(Math.sqrt(6), e.erreur(), 0.02);
        assertEquals(Math.sqrt(12 / 10_000.0) / (2 * Math.sqrt(6)), e.ecartType(), 1e-4);
        assertEquals(Math.sqrt(6 + 2 * Math.sqrt(12 / 10_000.0)), e.auPlus(), 0.02);
        assertEquals(5, new Estimation(9, 0).plus(new Estimation(16, 0)).erreur());
    }

    @ParameterizedTest
    @CsvSource({"13, 13", "14, 21", "55, 55", "233, 233"})
    void unReseauAUnPointParColonneEtParLigne(int auMoins, int points) {
        Reseau reseau = new Reseau(auMoins);
        assertEquals(points, reseau.points);
        for (double decalage : new double[] {0, 0.37, 0.999}) {
            Set<Integer> colonnes = new HashSet<>();
            Set<Integer> lignes = new HashSet<>();
            for (int k = 0; k < points; k++) {
                assertTrue(reseau.x(k, decalage) >= 0 && reseau.x(k, decalage) < 1);
                assertTrue(reseau.y(k, decalage) >= 0 && reseau.y(k, decalage) < 1);
                colonnes.add((int) Math.floor((reseau.x(k, decalage) - decalage + 1) * points) % points);
                lignes.add((int) Math.floor((reseau.y(k, decalage) - decalage + 1) * points) % points);
            }
            assertEquals(points, colonnes.size());
            assertEquals(points, lignes.size());
        }
    }

    @Test
    void unSouvenirNeDemandeChaquePointQuUneFois() {
        int[] demandes = new int[1];
        Pave bloc = Pave.deRang(0, 10, 10, Essais.COTE);
        Souvenir souvenir = new Souvenir(bloc, (x, y) -> {
            demandes[0]++;
            return new Couleur(x, y, x * y);
        });
        for (int fois = 0; fois < 3; fois++) {
            for (int k = 0; k < 5000; k++) {
                double x = k % 100 / 20.0;
                double y = k / 100 / 10.0;
                assertEquals(new Couleur(x, y, x * y), souvenir.couleur(x, y));
            }
            // 40 colonnes et 20 lignes de points sont dans les deux pixels sur deux du bloc
            assertEquals(40 * 20, souvenir.vus());
        }
        assertEquals(5000, demandes[0]);
    }

    @Test
    void deuxReferencesDUnPaveSontToujoursLesMemesEtDifferentEntreElles() {
        Pave bloc = Pave.deRang(7, 100, 100, Essais.COTE);
        Niveaux[] premieres = Niveaux.references(bloc, (x, y) -> new Couleur(x * y % 1), new Reseau(13));
        Niveaux[] secondes = Niveaux.references(bloc, (x, y) -> new Couleur(x * y % 1), new Reseau(13));
        assertEquals(0, premieres[0].ecart(new Niveaux[] {secondes[0], secondes[0]}));
        assertEquals(0, premieres[1].ecart(new Niveaux[] {secondes[1], secondes[1]}));
        assertFalse(premieres[0].ecart(new Niveaux[] {premieres[1], premieres[1]}) == 0);
    }
}
