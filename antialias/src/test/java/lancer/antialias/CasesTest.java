package lancer.antialias;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import lancer.Couleur;
import lancer.contrat.Modele;
import lancer.contrat.Pave;
import lancer.contrat.Section;
import lancer.contrat.Vue;
import lancer.scene.SectionLue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Les comptes et les bornes que les mutations de cette variante ont montré que personne ne vérifiait. */
class CasesTest extends EssaiEchantillons {

    private static final Pave TRENTE_DEUX = new Pave(0, 0, 32, 32);

    @Test
    void leContrasteEstCeluiDesDeuxExtremesOuQuIlsSoient() {
        Random hasard = new Random(53);
        for (int k = 0; k < 1000; k++) {
            double[] x = hasard.doubles(4, -0.5, 1.5).toArray();
            double[] l = new double[4];
            for (int i = 0; i < 4; i++) {
                l[i] = Math.max(0, Math.min(1, x[i]));
            }
            double attendu = Math.max(Math.max(l[0], l[1]), Math.max(l[2], l[3])) - Math.min(Math.min(l[0], l[1]), Math.min(l[2], l[3]));
            for (int c = 0; c < 3; c++) {
                Couleur[] q = new Couleur[4];
                for (int i = 0; i < 4; i++) {
                    q[i] = new Couleur(c == 0 ? x[i] : 0.5, c == 1 ? x[i] : 0.5, c == 2 ? x[i] : 0.5);
                }
                assertEquals(attendu, Coins.contraste(q[0], q[1], q[2], q[3]), "graine 53, tirage " + k);
            }
        }
    }

    /** Un point clair est un coin de quatre cases. */
    @Test
    void unContrasteNeFaitDiviserQueLesCasesQuiLeVoient() {
        Pave seize = new Pave(0, 0, 16, 16);
        for (double gris : new double[] {0.249, 0.251}) {
            Vue vue = (xe, ye) -> new Couleur((int) (2 * xe) == 16 && (int) (2 * ye) == 16 ? gris : 0);
            assertEquals(gris > 0.25 ? 4 : 0, raffines(new Partage(4, 0.25), seize, vue), "contraste " + gris);
        }
    }

    /** Coupé jusqu'au bout, un pavé a tous ses sous-pixels vus une fois ; seul son dernier pixel, qui n'a qu'une case, n'est pas coupé. */
    @Test
    void deDeuxSurDeuxToutEstCoupeSaufLeDernierPixel() {
        for (int largeur = 1; largeur <= 4; largeur++) {
            for (int hauteur = 1; hauteur <= 4; hauteur++) {
                Pave pave = new Pave(7, 9, 7 + largeur, 9 + hauteur);
                Vue vue = comptee((xe, ye) -> new Couleur(Math.sin(xe * ye)));
                assertEquals(largeur * hauteur - 1, raffines(new Partage(2, 1e-3), pave, vue), largeur + " × " + hauteur);
                assertEquals(4 * largeur * hauteur, rayons, largeur + " × " + hauteur);
            }
        }
    }

    /** Un coin dont le poids est nul n'a pas à être vu : hors des milieux d'une case sur deux, seuls les pixels coupés coûtent. */
    @Test
    void deDeuxSurDeuxUnPixelCoupeCouteTroisRayonsDePlus() {
        Vue vue = comptee((xe, ye) -> new Couleur(xe >= 16 && xe < 19 && ye >= 16 && ye < 19 ? 1 : 0));
        int coupes = raffines(new Partage(2, 0.1), TRENTE_DEUX, vue);
        assertEquals(12, coupes, "les cases que le bord du carré clair traverse");
        // un milieu par case coupée sur deux est un de ses trois rayons ; la dernière case, d'un seul sous-pixel, n'a pas de milieu
        assertEquals(33 * 33 + 511 + 3 * coupes - coupes / 2, rayons);
    }

    /** Un seul point qui ne ressemble à aucun de ses voisins ne suffit que s'il surprend assez, en moyenne, pour un pavé et un seuil. */
    @Test
    void unPaveOuLesPointsSurprennentEstDiviseEnEntier() {
        int points = 31 * 31 + 512;
        for (int n : new int[] {4, 8}) {
            for (double seuil : new double[] {0.06, 0.18}) {
                double juste = 0.125 * seuil * Math.sqrt(points);
                for (double gris : new double[] {0.99 * juste, 1.01 * juste}) {
                    Vue vue = comptee((xe, ye) -> new Couleur((int) xe == 16 && (int) ye == 16 && xe < 16 + 1.0 / n && ye < 16 + 1.0 / n
                            ? gris : 0));
                    int coupes = raffines(new Partage(n, seuil), TRENTE_DEUX, vue);
                    assertEquals(gris > juste ? 32 * 32 : 4, coupes, n + ", " + seuil + ", " + gris);
                }
            }
        }
    }

    /** Un pavé de détails où que l'on regarde a tous ses sous-pixels, au plus seize par côté, quel que soit n. */
    @ParameterizedTest
    @CsvSource({"2, 2", "3, 3", "5, 5", "7, 7", "12, 12", "16, 16", "32, 16", "64, 16"})
    void unPaveDeDetailsEstDiviseAuPlusSeizeFoisParCote(int n, int cote) {
        Pave pave = new Pave(0, 0, 8, 8);
        Random hasard = new Random(68);
        // une case d'un seizième de pixel a trop peu de contraste
        raffines(new Partage(n, 0.06), pave, comptee((xe, ye) -> new Couleur(hasard.nextBoolean() ? 0.3 : 0)));
        assertTrue(rayons >= cote * cote * 64 && rayons <= Math.min(n * n, 17 * 17) * 64, n + " : " + rayons / 64.0);
    }

    @Test
    void laMemoireDUnPaveNeDependPasDeSaPlaceDansLImage() {
        int loin = 1 << 29;
        new SousPixels(2, new Pave(loin, loin, loin + 2, loin + 2), (xe, ye) -> new Couleur(1)).voir(3, 3);
    }

    /** --auto n'a que ceux-là entre quoi choisir : la lecture les accepte tous, et chacun donne un autre échantillonnage que la base. */
    @Test
    void lesReglagesProposesSontTousPossibles() {
        Antialias antialias = new Antialias();
        Map<Section, Double> proposees = antialias.getSectionsProposees(new SectionLue("Antialias"));
        List<Section> sections = new ArrayList<>(proposees.keySet());
        assertEquals("[Antialias] n=1 methode=coins seuil=0", sections.get(0).toString(), "un rayon d'abord");
        double seuil = 1;
        for (Section section : sections) {
            Modele.Construction modele = new Modele.Construction();
            antialias.installer(section, modele);
            assertTrue(modele.construire().getEchantillonnage().isPresent(), section.toString());
            assertTrue(proposees.get(section) <= seuil, "de moins cher en plus juste");
            seuil = proposees.get(section);
        }
    }
}
