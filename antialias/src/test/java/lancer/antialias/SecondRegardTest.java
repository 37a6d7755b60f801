package lancer.antialias;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.contrat.Compteurs;
import lancer.contrat.Pave;
import lancer.contrat.Releve;
import lancer.contrat.Vue;
import lancer.dessin.Dessin;
import lancer.essai.Ressources;
import lancer.image.ImageMemoire;
import lancer.inspection.FaussesCouleurs;
import lancer.inspection.Inspection;
import org.junit.jupiter.api.Test;

/** Des détails plus petits qu'un pixel, un par pavé : ceux que l'on a vus disent combien ont échappé. */
class SecondRegardTest {

    private static final int L = 128;
    private static final int H = 96;
    private static final int PROFONDEUR = 5;

    /** Douze boules d'un tiers de pixel dans le noir, une par pavé, une sur deux entre les points que l'on regarde d'abord. */
    private static Lancer lancer() {
        List<Objet3D> objets = new ArrayList<>(List.of(new Sphere(new Point(0, 0, 0), 1000)));
        for (int k = 0; k < 12; k++) {
            double decale = k % 2 == 0 ? 0.1 : 0.55;
            Point ecran = new Camera(L, H).getEcran(Pave.COTE * (k % 4) + 16 + decale,
                    Pave.COTE * (k / 4) + 17 - 0.5 * (k % 2) + decale);
            objets.add(Ressources.boule(ecran.x, ecran.y, 0.01, 0.35 * Constantes.ECHELLE / L, 1, 0, 1));
        }
        Scene scene = new Scene(objets, List.of(new Lampe(new Point(-4, 6, -3), new Couleur(3))));
        return Dessin.lancer(scene.avec(scene.getModele().avec(Antialias.partage(12, 0.045), Constantes.SEUIL)), L, H, false);
    }

    private static Couleur[] dessiner(Lancer lancer, int fils) {
        Couleur[] image = new Couleur[L * H];
        lancer.TracerImage((couleur, i, j) -> image[L * j + i] = couleur, PROFONDEUR, fils);
        return image;
    }

    private static long clairs(Couleur... image) {
        return Arrays.stream(image).filter(couleur -> couleur.r > 0.05).count();
    }

    @Test
    void ceQuUnPaveADeSeulFaitChercherDansCeuxOuRienNASurpris() {
        Lancer lancer = lancer();
        Couleur[] image = dessiner(lancer, 2);
        assertTrue(lancer.getAtelier().seRegardeDeuxFois());
        for (int k = 0; k < 12; k++) {
            int pave = k;
            assertTrue(clairs(Arrays.stream(new int[] {0, 1, 2, 3}).mapToObj(q -> image[L * (Pave.COTE * (pave / 4) + 16 + q / 2)
                    + Pave.COTE * (pave % 4) + 16 + q % 2]).toArray(Couleur[]::new)) > 0, "la boule du pavé " + k);
        }
    }

    @Test
    void unDetailSeulDansTouteLImageNeFaitRienRevoir() {
        Releve seul = releve((xe, ye) -> new Couleur((int) xe == 16 && (int) ye == 16 ? 1 : 0));
        Releve aucun = releve((xe, ye) -> new Couleur(ye / H));
        Releve deux = releve((xe, ye) -> new Couleur(((int) xe == 16 || (int) xe == 25) && (int) ye == 16 ? 1 : 0));
        assertTrue(seul.soupcon > 0 && !seul.aRevoir, "il surprend, et fait chercher les autres");
        assertTrue(aucun.soupcon < 0 && aucun.aRevoir);
        assertTrue(deux.soupcon < 0 && !deux.aRevoir, "deux font déjà chercher dans leur pavé");
        // le carré d'un point blanc vaut 1, la limite un huitième du seuil, et un pavé compare 31² coins et 512 milieux
        double paves = 1 / Math.pow(0.125 * 0.045, 2) / ((31 * 31 + 512) / 2.0) - 1;
        assertEquals(0, seul.soupcon + paves * aucun.soupcon, 1e-6);
    }

    private static Releve releve(Vue vue) {
        Pave pave = new Pave(0, 0, Pave.COTE, Pave.COTE);
        return new Partage(12, 0.045).tracer(pave, pave, vue, (couleur, i, j) -> { });
    }

    @Test
    void niLImageNiLesComptesNeDependentDesFilsEtUnPixelEstCompteUneFois() {
        Lancer un = lancer();
        Couleur[] image = dessiner(un, 1);
        Compteurs comptes = un.getAtelier().getCompteurs();
        assertEquals(L * H - 12, comptes.pixelsRaffines, 12, "tous les pavés sont cherchés");
        for (int fils : new int[] {2, 7}) {
            Lancer plusieurs = lancer();
            assertEquals(List.of(image), List.of(dessiner(plusieurs, fils)));
            assertEquals(comptes.rayons(), plusieurs.getAtelier().getCompteurs().rayons());
            assertEquals(comptes.pixelsRaffines, plusieurs.getAtelier().getCompteurs().pixelsRaffines);
        }
    }

    @Test
    void lePixelExpliqueALaCouleurDeLImageQuiRetientCeQuElleAVu() {
        Lancer lancer = lancer();
        Couleur[] image = dessiner(lancer, 2);
        for (int p = 16 * L + 15; p < image.length; p += 8 * L + 3) {
            Inspection pixel = new Inspection(lancer.getScene(), chose -> null, lancer.getCamera(), PROFONDEUR, p % L, p / L);
            pixel.faire(lancer.getAtelier()::seRegardeDeuxFois);
            assertEquals(image[p], pixel.getCouleur());
        }
        int cachee = 17 * L + Pave.COTE + 16;
        Inspection pixel = new Inspection(lancer.getScene(), chose -> null, lancer.getCamera(), PROFONDEUR, cachee % L, cachee / L);
        Lancer autre = lancer.avec(lancer.getScene().getModele());
        pixel.faire(() -> autre.getAtelier().regarder(autre.getEchantillonnage(), autre.getVues(PROFONDEUR), 2));
        assertEquals(image[cachee], pixel.getCouleur(), "sans image, un premier regard suffit");
        pixel.faire(() -> false);
        assertFalse(image[cachee].equals(pixel.getCouleur()), "une fois ne suffit pas");
    }

    @Test
    void laVueDesRayonsCompteCeuxDesDeuxRegards() {
        Lancer lancer = lancer();
        dessiner(lancer, 2);
        long rayons = lancer.getAtelier().getCompteurs().rayons();
        ImageMemoire vue = new ImageMemoire(L, H, true);
        new FaussesCouleurs(lancer(), vue, PROFONDEUR, 2).dessiner("rayons");
        double somme = 0;
        for (int k = 0; k < vue.lineaire.length; k += 3) {
            somme += vue.lineaire[k];
        }
        assertEquals(rayons, somme);
    }

    @Test
    void lAvancementNeRecommencePasEtFinitAvecLeSecondRegard() {
        Lancer lancer = lancer();
        List<Double> suite = new ArrayList<>();
        lancer.TracerImage((couleur, i, j) -> suite.add(lancer.getAtelier().getAvancement()), PROFONDEUR, 1);
        assertTrue(suite.size() > L * H, "des pavés sont dessinés deux fois");
        assertTrue(suite.get(suite.size() - 1) < 1);
        assertEquals(1, lancer.getAtelier().getAvancement());
        double depuis = 0;
        for (double part : suite) {
            // le premier pavé isolé laisse attendre un second regard
            assertTrue(part >= depuis - 0.1, part + " après " + depuis);
            depuis = Math.max(depuis, part);
        }
    }
}
