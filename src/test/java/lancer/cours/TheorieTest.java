package lancer.cours;

import static lancer.essai.Ressources.boule;
import static lancer.essai.Ressources.scene;
import static lancer.essai.Tirages.direction;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.Modele;
import lancer.contrat.Specularite;
import org.junit.jupiter.api.Test;

/**
 * Des scènes dont la théorie donne l'image ou une quantité, et les régimes où une méthode moins sûre se trompe.
 */
class TheorieTest {

    private static final Rayon DEVANT = new Rayon(new Point(), new Vecteur(0, 0, 1));

    @Test
    void leSeuilNOublieQueCeQuIlPromet() {
        Sphere fond = boule(0, 0, 5, 1, 0.5, 0.5, 1);
        Sphere face = boule(0, 0, -5, 1, 0.5, 0.5, 1);
        Scene scene = scene(List.of(fond, face), new Lampe(new Point(0, 3, 0), new Couleur(1)));
        double limite = 2 * 0.8;
        for (double seuil : new double[] {0.5, 0.1, 1.0 / 1024, 1e-9}) {
            double oubli = limite - scene.avec(new Modele().avecSeuil(seuil)).getCouleurVue(DEVANT, null, 1000).r;
            assertTrue(oubli > 0 && oubli <= seuil * limite, "seuil " + seuil + ", oubli " + oubli);
        }
    }

    @Test
    void leSeuilPorteSurLaPlusGrandeComposanteDuProduitDesKs() {
        Sphere fond = boule(0, 0, 5, 1, 0.01, 0, 1);
        Sphere face = boule(0, 0, -5, 1, 0.01, 0, 1);
        for (Couleur seule : new Couleur[] {new Couleur(1, 0.1, 0), new Couleur(0.1, 1, 0), new Couleur(0.1, 0, 1)}) {
            fond.setKs(seule);
            face.setKs(seule);
            Scene scene = scene(List.of(fond, face), new Lampe(new Point(0, 3, 0), new Couleur(1))).avec(new Modele().avecSeuil(1));
            scene.getCouleurVue(DEVANT, null, 40);
            assertEquals(40, scene.getCompteurs().reflechis, "une composante suffit : " + seule);
        }
        // égal au seuil : encore suivi
        fond.setKs(new Couleur(0.5));
        face.setKs(new Couleur(0.5));
        Scene demi = scene(List.of(fond, face), new Lampe(new Point(0, 3, 0), new Couleur(1))).avec(new Modele().avecSeuil(0.125));
        demi.getCouleurVue(DEVANT, null, 40);
        assertEquals(3, demi.getCompteurs().reflechis);
    }

    @Test
    void unPoliNulDonneUnRefletEntierSurToutLeCoteEclaire() {
        Sphere boule = boule(0, 0, 5, 1, 0, 0.5, 0);
        // le contact est en (−0.8, 0, 4.4) : N = (−0.8, 0, −0.6), R = (−0.96, 0, 0.28), N·L = 0.352 et R·L = −0.5376
        Rayon deCote = new Rayon(new Point(-0.8, 0, 0), new Vecteur(0, 0, 1));
        Scene cote = scene(List.of(boule), new Lampe(new Point(2, 0, -5.2), new Couleur(1)));
        assertEquals(0.5, cote.getCouleurVue(deCote, null, 0).r, 0, "R·L < 0, mais 0^0 = 1");
        boule.setNs(1e-3);
        assertEquals(0, cote.getCouleurVue(deCote, null, 0).r, 0, "0^ns = 0 pour tout autre ns");
        boule.setNs(0);
        Scene dos = scene(List.of(boule), new Lampe(new Point(0, 0, 50), new Couleur(1)));
        assertEquals(new Couleur(), dos.getCouleurVue(DEVANT, null, 0));
    }

    @Test
    void laDirectionReflechieEstDeLongueurUnMemeSiLaNormaleNeLEstPas() {
        Vecteur R = new Sphere(new Point(), 1).getReflexion(new Vecteur(0, 0, 1), new Vecteur(0.8, 0, -0.8));
        assertEquals(1, R.norme(), 0x1p-52);
    }

    @Test
    void unCosinusDeLambertNeCompteJamaisPourPlusQueUn() {
        Random hasard = new Random(27);
        int plusGrands = 0;
        for (int k = 0; k < 2000; k++) {
            Vecteur d = direction(hasard);
            Point centre = new Point(hasard.nextGaussian(), hasard.nextGaussian(), hasard.nextGaussian());
            Sphere boule = boule(centre.x, centre.y, centre.z, 1, 1, 0, 1);
            Point oeil = centre.add(2 + hasard.nextDouble(), d);
            Scene scene = scene(List.of(boule), new Lampe(oeil, new Couleur(1)));
            Rayon rayon = new Rayon(oeil, d.neg());
            assertTrue(scene.getCouleurVue(rayon, null, 0).r <= 1, "tirage " + k);
            Point contact = rayon.calcContact();
            plusGrands += boule.getNormale(contact).dot(new Vecteur(contact, oeil).normalized()) > 1 ? 1 : 0;
        }
        assertTrue(plusGrands > 100, plusGrands + " produits N·L dépassent 1");
    }

    @Test
    void unRayonQuiNePeutRienChangerNEstPasLance() {
        Lampe lampe = new Lampe(new Point(0, 0, -9), new Couleur(1));
        Scene mate = scene(List.of(boule(0, 0, 5, 1, 1, 0, 1)), lampe);
        mate.getCouleurVue(DEVANT, null, 5);
        assertEquals(1, mate.getCompteurs().ombre);
        assertEquals(0, mate.getCompteurs().reflechis, "Ks = 0");
        Scene noire = scene(List.of(boule(0, 0, 5, 1, 0, 0, 1)), lampe);
        noire.getCouleurVue(DEVANT, null, 5);
        assertEquals(0, noire.getCompteurs().ombre, "ni Kd ni Ks");
        Scene dos = scene(List.of(boule(0, 0, 5, 1, 1, 0, 1)), new Lampe(new Point(0, 0, 9), new Couleur(1)));
        dos.getCouleurVue(DEVANT, null, 5);
        assertEquals(0, dos.getCompteurs().ombre, "N·L ≤ 0");
    }

    /**
     * Deux miroirs de Ks inégaux, 2m contacts : (c₁ + K₁c₂)(1 − (K₁K₂)^m)/(1 − K₁K₂) ; un contact de plus y ajoute (K₁K₂)^m c₁. La
     * lampe est en (0, 3, 0), les contacts en z = ±4 : N·L = R·L = 4/5.
     */
    @Test
    void deuxMiroirsInegauxDonnentUneSuiteDeRaisonK1K2() {
        Sphere fond = boule(0, 0, 5, 1, 0.5, 0.75, 1);
        Sphere face = boule(0, 0, -7, 3, 0.2, 0.5, 1);
        Scene scene = scene(List.of(fond, face), new Lampe(new Point(0, 3, 0), new Couleur(1)));
        double c1 = (0.5 + 0.75) * 0.8;
        double c2 = (0.2 + 0.5) * 0.8;
        double raison = 0.75 * 0.5;
        for (int n : new int[] {0, 1, 2, 3, 5, 19, 20, 59, 1000}) {
            int m = (n + 1) / 2;
            double attendu = (c1 + 0.75 * c2) * (1 - Math.pow(raison, m)) / (1 - raison) + (n % 2 == 0 ? Math.pow(raison, m) * c1 : 0);
            assertEquals(attendu, scene.getCouleurVue(DEVANT, null, n).r, 1e-12, n + " réflexions");
        }
    }

    /**
     * Deux vecteurs « de longueur 1 » le sont à u près : le produit d'une direction par elle-même dépasse 1 une fois sur dix, de
     * 4e-16 au plus. Ce n'est rien, jusqu'à ce qu'on l'élève à la puissance 1e17.
     */
    @Test
    void unCosinusPlusGrandQueUnDevientEnormeALaPuissanceNs() {
        Random hasard = new Random(26);
        int plusGrands = 0;
        double pire = 0;
        for (int k = 0; k < 10_000; k++) {
            Vecteur d = direction(hasard);
            // la même direction, normalisée après un autre calcul
            Vecteur e = d.mul(1 + hasard.nextDouble()).normalized();
            double cosinus = d.dot(e);
            plusGrands += cosinus > 1 ? 1 : 0;
            pire = Math.max(pire, Math.pow(Math.max(0, cosinus), 1e17));
            for (double ns : new double[] {1, 1e5, 1e9, 1e15, 1e17}) {
                assertEquals(1, Specularite.puissance(Math.max(1, cosinus), ns), "graine 26, tirage " + k);
            }
        }
        assertTrue(plusGrands > 500, plusGrands + " produits sur dix mille dépassent 1");
        assertTrue(pire > 1e6, "Math.pow rend jusqu'à " + pire);
    }
}
