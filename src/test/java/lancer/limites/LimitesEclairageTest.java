package lancer.limites;

import static lancer.essai.Ressources.boule;
import static lancer.essai.Ressources.image;
import static lancer.essai.Ressources.scene;
import static lancer.essai.Tirages.direction;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Collections;
import java.util.Random;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.Vue;
import lancer.contrat.Specularite;
import lancer.essai.Rangee;
import lancer.essai.Ressources;
import lancer.essai.TraceurNaif;
import org.junit.jupiter.api.Test;

/** Où les formules d'éclairement, recopiées telles quelles, échouent : miroirs, reflets de lampes, lampes mal placées. */
class LimitesEclairageTest {

    private static final Rayon DEVANT = new Rayon(new Point(), new Vecteur(0, 0, 1));

    /** Le rayon réfléchi part d'un contact qu'un arrondi met sous la surface : sans exclure le départ, il la retouche aussitôt. */
    @Test
    void sansExclureLeDepartUnMiroirSeReflechitLuiMeme() {
        int cote = 101;
        Scene scene = scene(Collections.singletonList(boule(0, 0, 5, 1.5, 0, 0.5, 1)));
        Ressources.Image juste = image(scene, cote, cote, 1, 1);
        Vue sansExclure = new TraceurNaif(scene, new Camera(cote, cote), 1, TraceurNaif.Ombre.AUCUNE, 0);
        int faux = 0;
        for (int k = 0; k < cote * cote; k++) {
            faux += juste.composantes[3 * k] == (float) sansExclure.couleur(k % cote + 0.5, k / cote + 0.5).r ? 0 : 1;
        }
        // les nôtres sont comparés au ciel, en forme close, par
        // ProprietesScenesTest.sansLampeOnNeVoitJamaisPlusBrillantQueLeCielAuBoutDesMiroirs
        assertTrue(faux > 100, faux + " pixels faux");
        Rangee.montre("sansExclureLeDepartUnMiroirSeReflechitLuiMeme", faux, 0, 0);
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
        double notre = 0;
        for (int k = 0; k < 10_000; k++) {
            Vecteur d = direction(hasard);
            // la même direction, normalisée après un autre calcul
            Vecteur e = d.mul(1 + hasard.nextDouble()).normalized();
            double cosinus = d.dot(e);
            plusGrands += cosinus > 1 ? 1 : 0;
            pire = Math.max(pire, Math.pow(Math.max(0, cosinus), 1e17));
            for (double ns : new double[] {1, 1e5, 1e9, 1e15, 1e17}) {
                notre = Math.max(notre, Specularite.puissance(cosinus, ns));
                assertTrue(Specularite.puissance(cosinus, ns) <= 1, "graine 26, tirage " + k);
            }
        }
        assertTrue(plusGrands > 500, plusGrands + " produits sur dix mille dépassent 1");
        assertTrue(pire > 1e6, "Math.pow rend jusqu'à " + pire);
        Rangee.montre("unCosinusPlusGrandQueUnDevientEnormeALaPuissanceNs", pire, notre, 1);
    }

    /** Et par l'éclairement entier, la lampe exactement dans la direction du reflet : jamais plus que Kd + Ks. */
    @Test
    void unPoliSansBorneNEclairePasPlusQueKdPlusKs() {
        Random hasard = new Random(27);
        Sphere boule = boule(0, 0, 5, 1, 0.5, 0.5, 1e17);
        int eclaires = 0;
        for (int k = 0; k < 10_000; k++) {
            Rayon rayon = new Rayon(new Point(), boule.getCentre().add(direction(hasard).mul(0.9)));
            PointContact contact = scene(Collections.singletonList(boule)).getClosestIntersection(rayon);
            Vecteur N = boule.getNormale(contact);
            Vecteur R = rayon.getV().sub(N.mul(2 * N.dot(rayon.getV())));
            Scene scene = scene(Collections.singletonList(boule), new Lampe(contact.add(R.mul(3 + hasard.nextDouble())), new Couleur(1)));
            double vue = boule.getColor(scene, rayon, contact, 0).r;
            assertTrue(vue <= 1, "graine 27, tirage " + k + " : " + vue);
            eclaires += vue > 0.5 ? 1 : 0;
        }
        assertTrue(eclaires > 100, "sans quoi rien n'est essayé : " + eclaires);
    }

    /**
     * La lampe est exactement sur le contact : L = 0/0. NaN traverse les {@code Math.max}, devient 1 à la puissance 0, puis 0 une
     * fois converti en entier : un point noir ou blanc que rien n'annonce.
     */
    @Test
    void uneLampeSurLeContactNAPasDeDirection() {
        Point contact = new Point(0, 0, 4);
        Vecteur versLampe = new Vecteur(contact, contact);
        Vecteur L = versLampe.div(Math.sqrt(versLampe.norme2()));
        double cosinus = Math.max(0, new Vecteur(0, 0, -1).dot(L));
        assertTrue(Double.isNaN(cosinus), "max(0, NaN) est NaN");
        assertEquals(1, Math.pow(cosinus, 0), "mais NaN^0 est 1");
        assertEquals(0, (int) (255 * cosinus + 0.5), "et (int) NaN est 0");
        Scene scene = scene(Collections.singletonList(boule(0, 0, 5, 1, 0.5, 0.5, 0)), new Lampe(contact, new Couleur(1)));
        assertEquals(new Couleur(), scene.getCouleurVue(DEVANT, null, 0), "cette lampe n'apporte rien ici");
        Rangee.montre("uneLampeSurLeContactNAPasDeDirection", cosinus, scene.getCouleurVue(DEVANT, null, 0).r, 0);
    }

    /** (R·L)^0 = 1 partout : sans la condition N·L > 0, une sphère de poli nul brillerait dans le dos aussi. */
    @Test
    void unPoliNulEclaireraitLeDosSiLOnNeRegardaitQueLeReflet() {
        Scene dos = scene(Collections.singletonList(boule(0, 0, 5, 1, 0, 0.5, 0)), new Lampe(new Point(0, 0, 50), new Couleur(1)));
        double RL = -1;
        assertEquals(0.5, 0.5 * Math.pow(Math.max(0, RL), 0));
        assertEquals(0, dos.getCouleurVue(DEVANT, null, 0).r);
        Rangee.montre("unPoliNulEclaireraitLeDosSiLOnNeRegardaitQueLeReflet", 0.5 * Math.pow(Math.max(0, RL), 0),
                dos.getCouleurVue(DEVANT, null, 0).r, 0);
    }

    /** Limiter chaque couleur à [0, 1] dès qu'elle est calculée : une lampe forte ne se distingue plus dans un miroir sombre. */
    @Test
    void limiterAvantDeReflechirPerdLesLampesFortes() {
        Sphere mur = boule(0, 0, -6, 1, 1, 0, 1);
        Sphere miroir = boule(0, 0, 5, 1, 0, 0.125, 1e9);
        // dans l'axe, le miroir renvoie le regard sur le mur, que la lampe éclaire six fois trop
        Scene scene = scene(Arrays.asList(miroir, mur), new Lampe(new Point(0, 3, -1), new Couleur(6)));
        double vuDuMur = scene.getCouleurVue(new Rayon(new Point(), new Vecteur(0, 0, -1)), null, 0).r;
        assertTrue(vuDuMur > 4);
        double limite = 0.125 * Math.min(1, vuDuMur);
        assertEquals(0.125, limite, "trente fois trop sombre sur un écran à 255 niveaux");
        assertEquals(0.125 * vuDuMur, scene.getCouleurVue(DEVANT, null, 1).r, 1e-12);
    }

    /** Arrêter sur le dernier Ks, ou sur la clarté du produit : un miroir rouge pur ne montrerait rien. */
    @Test
    void laClarteDUnMiroirRougeNEstPasSonRouge() {
        Sphere fond = boule(0, 0, 5, 1, 0.5, 0, 1);
        Sphere face = boule(0, 0, -5, 1, 0.5, 0, 1);
        fond.setKs(new Couleur(1, 0, 0));
        face.setKs(new Couleur(1, 0, 0));
        Scene scene = scene(Arrays.asList(fond, face), new Lampe(new Point(0, 3, 0), new Couleur(1)));
        scene.getModele().setSeuil(0.25);
        double clarte = 0.2126 * fond.getKs().r + 0.7152 * fond.getKs().v + 0.0722 * fond.getKs().b;
        assertFalse(clarte >= scene.getModele().getSeuil(), "la clarté arrêterait au premier miroir");
        // 21 contacts, chacun de rouge 0,8·(0,5 + 1)
        assertEquals(21 * 0.8 * 1.5, scene.getCouleurVue(DEVANT, null, 20).r, 1e-11);
        Rangee.montre("laClarteDUnMiroirRougeNEstPasSonRouge", scene.getCouleurVue(DEVANT, null, 0).r,
                scene.getCouleurVue(DEVANT, null, 20).r, 21 * 0.8 * 1.5);
    }
}
