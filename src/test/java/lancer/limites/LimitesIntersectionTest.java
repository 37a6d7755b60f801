package lancer.limites;

import static lancer.essai.Tirages.direction;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import lancer.Constantes;
import lancer.Point;
import lancer.Rayon;
import lancer.Vecteur;
import lancer.essai.Exact;
import lancer.essai.Formule;
import lancer.essai.Rangee;
import lancer.precision.Intersection;
import org.junit.jupiter.api.Test;

/**
 * Où les formules des manuels échouent, et pourquoi {@link Intersection#distance} est écrite autrement. Chaque test montre
 * où la formule naïve va, où elle se trompe, et que la nôtre y va encore. Celles que l'on trouve partout sont dans {@link Formule}, à
 * lire d'abord ; le juge est {@link Exact}.
 *
 * <p>u = 2^-53 est la précision relative d'un double : chaque opération se trompe d'au plus une part u de son résultat.
 */
class LimitesIntersectionTest {

    private static final double U = 0x1p-53;
    private static final double INFINI = Constantes.INFINI;

    /** Une formule que seul un test connaît. */
    private interface FormuleDEssai {
        double distance(Point P, Vecteur V, Point C, double r);
    }

    /** Ce que valent les réponses d'une méthode : combien se trompent de genre (touche ou manque), et la pire erreur des autres. */
    private static final class Bilan {
        int cas;
        int malClasses;
        double pireErreur;
        double pireEnTolerances;
    }

    /** Des rayons vers une sphère de rayon 1, de loin ; ceux qui la rasent à ce que l'arrondi des données permet sont laissés. */
    private static Bilan deLoin(Formule formule, double distance) {
        Random hasard = new Random(1);
        Bilan bilan = new Bilan();
        while (bilan.cas < 300) {
            Point P = new Point(hasard.nextGaussian(), hasard.nextGaussian(), hasard.nextGaussian());
            Vecteur vers = direction(hasard);
            Point C = P.add(vers.mul(distance));
            Vecteur cote = vers.mul(0.3).sub(new Vecteur(vers.y, vers.z, vers.x)).normalized();
            Point vise = C.add(cote.mul(2 * hasard.nextDouble()));
            Exact exact = new Exact(P, vise, C, 1);
            if (Math.abs(exact.enfoncement) < 8 * U * distance) {
                continue;
            }
            bilan.cas++;
            double t = formule.distance(P, new Rayon(P, vise).getV(), C, 1);
            if ((t == INFINI) != (exact.distance == INFINI) || Double.isNaN(t)) {
                bilan.malClasses++;
            } else if (t != INFINI) {
                bilan.pireErreur = Math.max(bilan.pireErreur, Math.abs(t - exact.distance));
                bilan.pireEnTolerances = Math.max(bilan.pireEnTolerances, Math.abs(t - exact.distance) / exact.tolerance(8, P, C, 1));
            }
        }
        return bilan;
    }

    @Test
    void leDiscriminantDuManuelPerdUneSphereLointaine() {
        // à cent rayons personne ne se trompe de genre ; dès un million l'erreur du manuel se voit sur le contact
        assertEquals(0, deLoin(Formule.MANUEL, 1e2).malClasses);
        assertTrue(deLoin(Formule.MANUEL, 1e6).pireErreur > 1e-6, "l'erreur de t, en rayons de la sphère");
        // à 1/√u = 1e8 rayons, u·|PC|² vaut r² : toucher ou non se joue à pile ou face
        assertTrue(deLoin(Formule.MANUEL, 1e8).malClasses > 300 / 5);
        assertTrue(deLoin(Formule.MANUEL, 1e12).malClasses > 300 / 5);
        Rangee.montre("leDiscriminantDuManuelPerdUneSphereLointaine", deLoin(Formule.MANUEL, 1e8).malClasses,
                deLoin(Formule.PROGRAMME, 1e8).malClasses, 0);
        for (double distance : new double[] {1e2, 1e4, 1e6, 1e8, 1e10, 1e12}) {
            Bilan notre = deLoin(Formule.PROGRAMME, distance);
            assertEquals(0, notre.malClasses, "à " + distance);
            assertTrue(notre.pireEnTolerances <= 1, "à " + distance + " : " + notre.pireEnTolerances);
        }
    }

    @Test
    void desRacinesStablesNeReparentPasUnMauvaisDiscriminant() {
        assertTrue(deLoin(Formule.RACINES, 1e8).malClasses > 300 / 5);
        assertEquals(0, deLoin(Formule.PROGRAMME, 1e8).malClasses);
    }

    /** Elle n'a rien à avancer au-dessus d'un sol : {@link LimitesSurfaceTest#repartirDePresNeGagneRienAuDessusDUnSol}. */
    @Test
    void repartirDePresRepareLeManuelPourUneSphereLointaine() {
        for (double distance : new double[] {1e6, 1e8, 1e12}) {
            assertEquals(0, deLoin(Formule.REPRISE, distance).malClasses, "à " + distance);
        }
    }

    /**
     * Le bon discriminant, h² = r² − l², puis la racine b − h : d'un point juste au-dessus de la surface, elle soustrait deux
     * nombres égaux à un arrondi près, et il n'en reste qu'un chiffre. c/(b + h) les garde tous, c = |PC|² − r² étant ici sans erreur.
     */
    @Test
    void deuxNombresPresqueEgauxQueLOnSoustraitPerdentTousLeursChiffres() {
        Random hasard = new Random(2);
        double pireNaive = 0;
        for (int k = 0; k < 1_000; k++) {
            Point P = new Point(0, 0, -(1 + (1 + k % 4) * 0x1p-52));
            Vecteur V = new Vecteur(hasard.nextGaussian(), hasard.nextGaussian(), 0.5 + Math.abs(hasard.nextGaussian())).normalized();
            double exacte = new Exact(P, P.add(V), new Point(), 1).distance;
            pireNaive = Math.max(pireNaive, Math.abs(Formule.PERPENDICULAIRE.distance(P, V, new Point(), 1) / exacte - 1));
            assertEquals(1, Formule.PROGRAMME.distance(P, V, new Point(), 1) / exacte, 1e-14, "graine 2, tirage " + k);
        }
        assertTrue(pireNaive > 0.3, "erreur relative de la racine soustraite : " + pireNaive);
    }

    /** « t > 1e-6 » évite qu'un rayon se touche lui-même ; c'est aussi une unité de longueur, que la scène n'a pas choisie. */
    @Test
    void unEpsilonFixeEffaceCeQuiEstPetitOuProche() {
        double epsilon = 1e-6;
        FormuleDEssai a_epsilon = (P, V, C, r) -> {
            double t = Formule.MANUEL.distance(P, V, C, r);
            return t > epsilon ? t : INFINI;
        };
        FormuleDEssai a_discriminant = (P, V, C, r) -> {
            Vecteur PC = new Vecteur(C, P);
            double b = V.dot(PC);
            return b * b - PC.dot(PC) + r * r > 1e-10 ? Formule.MANUEL.distance(P, V, C, r) : INFINI;
        };
        Vecteur devant = new Vecteur(0, 0, 1);
        Point proche = new Point(0, 0, 5e-7);
        assertEquals(INFINI, a_epsilon.distance(new Point(), devant, proche, 1e-7), "une bille juste devant l'écran");
        assertEquals(4e-7, Formule.PROGRAMME.distance(new Point(), devant, proche, 1e-7), 1e-21);
        Rangee.montre("unEpsilonFixeEffaceCeQuiEstPetitOuProche", a_epsilon.distance(new Point(), devant, proche, 1e-7),
                Formule.PROGRAMME.distance(new Point(), devant, proche, 1e-7), 4e-7);
        Point petite = new Point(0, 0, 1e-3);
        assertEquals(INFINI, a_discriminant.distance(new Point(), devant, petite, 1e-6), "une sphère d'un micron");
        assertEquals(1e-3 - 1e-6, Formule.PROGRAMME.distance(new Point(), devant, petite, 1e-6), 1e-18);
    }

    /** Ne garder que la première racine : une sphère disparaît quand on est dedans. */
    @Test
    void laPremiereRacineSeuleRendUneSphereInvisibleDuDedans() {
        FormuleDEssai premiereRacine = (P, V, C, r) -> {
            Vecteur PC = new Vecteur(C, P);
            double b = V.dot(PC);
            double discriminant = b * b - PC.dot(PC) + r * r;
            double t = -b - Math.sqrt(discriminant);
            return discriminant >= 0 && t > 0 ? t : INFINI;
        };
        assertEquals(INFINI, premiereRacine.distance(new Point(), new Vecteur(0, 0, 1), new Point(), 3));
        assertEquals(3, Formule.PROGRAMME.distance(new Point(), new Vecteur(0, 0, 1), new Point(), 3), 4 * U);
        Rangee.montre("laPremiereRacineSeuleRendUneSphereInvisibleDuDedans", premiereRacine.distance(new Point(), new Vecteur(0, 0, 1),
                new Point(), 3), Formule.PROGRAMME.distance(new Point(), new Vecteur(0, 0, 1), new Point(), 3), 3);
    }

    /**
     * NaN n'est ni plus petit, ni plus grand, ni égal à rien : {@code if (discriminant < 0)} le laisse passer. Puis il perd en
     * silence ({@code t < meilleur} est faux), ou gagne contre tout ({@code !(t >= meilleur)} est vrai).
     */
    @Test
    void nanPasseParLeTestDuManuel() {
        Vecteur nul = new Vecteur();
        Vecteur sansDirection = nul.div(Math.sqrt(nul.norme2()));
        double t = Formule.MANUEL.distance(new Point(), sansDirection, new Point(0, 0, 5), 1);
        // ici les deux comparaisons t > 0 l'arrêtent par hasard ; une seule racine, et il sort
        assertEquals(INFINI, t);
        FormuleDEssai plusCourte = (P, V, C, r) -> {
            Vecteur PC = new Vecteur(C, P);
            double discriminant = V.dot(PC) * V.dot(PC) - PC.dot(PC) + r * r;
            return discriminant < 0 ? INFINI : -V.dot(PC) - Math.sqrt(discriminant);
        };
        t = plusCourte.distance(new Point(), sansDirection, new Point(0, 0, 5), 1);
        assertTrue(Double.isNaN(t));
        assertTrue(!(t < 4) && !(t >= 4), "perdant d'un côté, gagnant de l'autre");
        assertEquals(INFINI, Formule.PROGRAMME.distance(new Point(), sansDirection, new Point(0, 0, 5), 1));
        Rangee.montre("nanPasseParLeTestDuManuel", t, Formule.PROGRAMME.distance(new Point(), sansDirection, new Point(0, 0, 5), 1),
                INFINI);
        assertThrows(ArithmeticException.class, () -> new Rayon(new Point(), nul), "et un tel rayon ne se construit pas");
    }

    /** La racine c/q est un 0/0 quand le rayon part du point où il est tangent. */
    @Test
    void laRacineStableDuManuelDiviseZeroParZero() {
        Point P = new Point(1, 0, 0);
        Vecteur tangente = new Vecteur(0, 0, 1);
        double c = 0;
        double q = 0;
        assertTrue(Double.isNaN(c / q));
        // Math.min et Math.max rendent NaN, et t > 0 est faux : ici le bon résultat, pour une mauvaise raison
        assertEquals(INFINI, Formule.RACINES.distance(P, tangente, new Point(), 1));
        assertEquals(INFINI, Formule.PROGRAMME.distance(P, tangente, new Point(), 1));
        Rangee.montre("laRacineStableDuManuelDiviseZeroParZero", c / q, Formule.PROGRAMME.distance(P, tangente, new Point(), 1), INFINI);
        // du centre, b = 0 : copySign choisit, et les deux racines sont bonnes
        assertEquals(1, Formule.RACINES.distance(new Point(), tangente, new Point(), 1), 4 * U);
        assertEquals(1, Formule.PROGRAMME.distance(new Point(), tangente, new Point(), 1), 4 * U);
    }
}
