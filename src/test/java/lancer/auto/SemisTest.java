package lancer.auto;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.function.Supplier;
import lancer.Camera;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.contrat.Pave;
import lancer.fils.Traceur;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Les pixels qu'on essaie, et ce qu'on en conclut. */
class SemisTest {

    @ParameterizedTest
    @CsvSource({"3, 2", "1, 16384", "200, 150", "201, 151", "800, 600", "10000, 10000"})
    void lesBlocsDuChoixEtDuControleSontDansLImageEtTousDifferents(int largeur, int hauteur) {
        Essais essais = essais(largeur, hauteur);
        List<Pave> choix = essais.semer(4000, false);
        List<Pave> autres = essais.semer(4000, true);
        Set<Integer> vus = new HashSet<>();
        for (List<Pave> blocs : Arrays.asList(choix, autres)) {
            for (Pave bloc : blocs) {
                assertTrue(0 <= bloc.i0 && bloc.i0 < bloc.i1 && bloc.i1 <= largeur && 0 <= bloc.j0 && bloc.j0 < bloc.j1
                        && bloc.j1 <= hauteur);
                assertTrue(vus.add(bloc.j0 * largeur + bloc.i0), "un bloc deux fois");
            }
        }
        assertEquals(Math.max(1, Math.min(4000, Pave.nombre(largeur, hauteur, Essais.COTE) / 2)), choix.size());
        assertEquals(choix.size(), autres.size());
    }

    private static Essais essais(int largeur, int hauteur) {
        Scene vide = new Scene(Collections.<Objet3D>emptyList(), Collections.<Lampe>emptyList());
        return new Essais(new Traceur(vide, new Camera(largeur, hauteur)), 1);
    }

    @Test
    void uneMesureQuiSuitLesPromessesEstEstimeeSansErreur() {
        List<Pave> blocs = essais(200, 150).semer(4000, false);
        Random hasard = new Random(3);
        double[] promesses = hasard.doubles(blocs.size(), 0.05, 1).toArray();
        Tirage tirage = new Tirage(100, blocs, promesses, 0.5);
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
            List<Pave> blocs = essais(200, 150).semer(4000, false);
            double[] promesses = hasard.doubles(blocs.size(), 0.05, 1).toArray();
            Tirage tirage = new Tirage(100, blocs, promesses, 0.5);
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
        // deux écarts types du carré, sur l'erreur
        assertEquals(2 * Math.sqrt(12 / 10_000.0) / (2 * Math.sqrt(6)), e.incertitude(), 1e-4);
        assertEquals(Math.sqrt(6 + 2 * Math.sqrt(12 / 10_000.0)), e.auPlus(), 0.02);
        assertEquals(5, new Estimation(9, 0).plus(new Estimation(16, 0)).erreur());
    }

    /** Aucun quart du pixel, dans les deux sens, n'a plus de deux points de plus ou de moins que sa part. */
    @ParameterizedTest
    @CsvSource({"8", "20", "42", "144"})
    void lesPointsDUneReferenceSontBienRepartis(int points) {
        for (double decalage : new double[] {0, 0.37, 0.999}) {
            int[] comptes = new int[16];
            for (int k = 0; k < points; k++) {
                double x = Niveaux.x(k, decalage);
                double y = Niveaux.y(k, decalage);
                assertTrue(x >= 0 && x < 1 && y >= 0 && y < 1);
                comptes[4 * (int) (4 * y) + (int) (4 * x)]++;
            }
            for (int compte : comptes) {
                assertEquals(points / 16.0, compte, 2, points + " points, " + Arrays.toString(comptes));
            }
        }
    }

    @Test
    void deuxReferencesDifferentEntreEllesEtSontLesMemesFaitesEnUneFoisOuEnPlusieurs() {
        Scene boule = new Scene(Collections.<Objet3D>singletonList(new Sphere(new Point(0, 0, 8), 2)),
                Collections.<Lampe>emptyList());
        Essais essais = new Essais(new Traceur(boule, new Camera(101, 101)), 2);
        LimitesDesReflets limites = new LimitesDesReflets(0, 0, new Estimation(0, 0), 1);
        // du ciel, dont la couleur change partout ; le dernier bloc d'une ligne n'a que deux pixels
        List<Pave> blocs = Arrays.asList(Pave.deRang(7, 101, 101, Essais.COTE), Pave.deRang(50, 101, 101, Essais.COTE));
        References enUneFois = new References(essais, blocs, limites);
        assertTrue(enUneFois.affiner(0, 1e9));
        assertFalse(enUneFois.affiner(0, 1e9));
        long cout = essais.rayons();
        assertEquals(0, cout % (2 * 6));
        References enPlusieurs = new References(essais, blocs, limites);
        for (double rayons : new double[] {0, 100, 500, 1e9}) {
            assertTrue(enPlusieurs.affiner(0, rayons));
        }
        assertEquals(2 * cout, essais.rayons(), "aucun point deux fois");
        assertArrayEquals(enUneFois.sommes, enPlusieurs.sommes);
        assertNotEquals(enUneFois.sommes[0][0], enUneFois.sommes[0][1]);
    }

    @Test
    void desPassesBorneesSArretentEtNeComptentPasPourPlus() {
        Essais essais = essais(200, 150);
        List<Pave> blocs = essais.semer(1000, false);
        Essais.Essai unRayon = (rang, bloc, fil) -> fil.vue(0, 0).couleur(bloc.i0, bloc.j0);
        Supplier<String> passes = () -> {
            essais.passer(blocs, unRayon);
            return "faites";
        };
        assertEquals("faites", essais.borner(1000, passes));
        assertEquals(1000, essais.rayons());
        assertNull(essais.borner(999, passes));
        assertEquals(1999, essais.rayons());
        assertNull(essais.borner(-5, passes));
        assertEquals(1999, essais.rayons());
        // rien n'en reste
        passes.get();
        assertEquals(2999, essais.rayons());
        assertThrows(CancellationException.class, () -> essais.borner(1000, () -> {
            throw new CancellationException("par un autre");
        }));
    }
}
