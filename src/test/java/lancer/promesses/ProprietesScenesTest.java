package lancer.promesses;

import static lancer.essai.Ressources.scene;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.essai.Ombre;
import lancer.essai.Tirages;
import lancer.rapide.Preparation;
import org.junit.jupiter.api.Test;

/** Ce qui est vrai de tous les rayons de toutes les scènes : au moins cent mille rayons par propriété, à graine fixe. */
class ProprietesScenesTest {

    private static final int RAYONS = 100_000;
    private static final int RAYONS_PAR_SCENE = 1_000;
    private static final Camera CAMERA = new Camera(50, 40);

    private static Rayon copie(Rayon rayon) {
        return new Rayon(rayon.getP(), rayon.getV(), new Couleur(1));
    }

    private static Vecteur reflechi(Vecteur V, Vecteur N) {
        return V.sub(N.mul(2 * V.dot(N))).normalized();
    }

    @Test
    void unRayonQuiQuitteUneSurfaceNeLaRetouchePas() {
        Tirages tirages = new Tirages(41);
        int quittes = 0;
        while (quittes < RAYONS) {
            Scene scene = tirages.scene(2 + tirages.hasard.nextInt(30));
            Scene[] chemins = {scene, new Scene(scene.getObjets(), scene.getLampes())};
            scene.getModele().setRecherche(new Preparation(scene, CAMERA).pourUnFil(new Compteurs()));
            for (int k = 0; k < RAYONS_PAR_SCENE; k++) {
                Rayon rayon = new Rayon(tirages.point(), tirages.direction());
                Objet3D depart = null;
                for (int n = 0; n < 8; n++) {
                    PointContact contact = chemins[k % 2].getClosestIntersection(rayon, depart);
                    if (contact == null) {
                        break;
                    }
                    String cas = "graine 41, rayon " + quittes + ", " + contact.objet;
                    assertNotSame(depart, contact.objet, cas);
                    Vecteur N = contact.objet.getNormale(contact);
                    Vecteur R = reflechi(rayon.getV(), N);
                    if (rayon.getV().dot(N) < 0) {
                        // venu du dehors, le reflet s'éloigne du plan tangent, donc de la boule, qui est de l'autre côté
                        assertTrue(R.dot(N) > 0, cas);
                        for (Lampe lampe : scene.getLampes()) {
                            if (N.dot(new Vecteur(contact, lampe.getPosition())) > 0) {
                                assertFalse(Ombre.cachee(scene(Collections.singletonList(contact.objet)), lampe, contact, contact.objet),
                                        cas);
                            }
                        }
                    }
                    depart = contact.objet;
                    rayon = new Rayon(contact, R);
                    quittes++;
                }
            }
        }
    }

    /** Kd, Ks ≤ 1, aucune lampe : au bout des miroirs il n'y a que le ciel, et chaque miroir n'en rend qu'une part. */
    @Test
    void sansLampeOnNeVoitJamaisPlusBrillantQueLeCielAuBoutDesMiroirs() {
        Tirages tirages = new Tirages(44);
        int auCiel = 0;
        for (int n = 0; n < RAYONS; n += RAYONS_PAR_SCENE) {
            Scene scene = scene(tirages.boules(2 + tirages.hasard.nextInt(20)));
            scene.getModele().setRecherche(new Preparation(scene, CAMERA).pourUnFil(new Compteurs()));
            for (int k = 0; k < RAYONS_PAR_SCENE; k++) {
                Rayon premier = new Rayon(tirages.point(), tirages.direction());
                Couleur vue = scene.getCouleurVue(copie(premier), null, 12);
                Couleur part = new Couleur(1);
                Rayon rayon = premier;
                PointContact contact = scene.getClosestIntersection(rayon);
                for (int reflets = 0; contact != null && reflets < 12; reflets++) {
                    part = part.mul(contact.objet.getKs());
                    rayon = new Rayon(contact, reflechi(rayon.getV(), contact.objet.getNormale(contact)), part);
                    contact = scene.getClosestIntersection(rayon, contact.objet);
                }
                Couleur ciel = contact == null ? rayon.getSkyColor() : new Couleur();
                String cas = "graine 44, rayon " + (n + k) + " : " + vue + ", ciel " + ciel;
                assertTrue(vue.r <= ciel.r && vue.v <= ciel.v && vue.b <= ciel.b, cas);
                // et exactement cette part, à l'ordre des produits près
                assertEquals(part.r * ciel.r, vue.r, 1e-12, cas);
                assertEquals(part.v * ciel.v, vue.v, 1e-12, cas);
                assertEquals(part.b * ciel.b, vue.b, 1e-12, cas);
                auCiel += rayon != premier && contact == null ? 1 : 0;
            }
        }
        assertTrue(auCiel > RAYONS / 10, auCiel + " rayons réfléchis jusqu'au ciel");
    }

    /** Un nombre qui s'écrit avec peu de bits : la somme de deux d'entre eux ne s'arrondit pas. */
    private static double court(double x) {
        return Math.rint(x * 0x1p20) / 0x1p20;
    }

    @Test
    void deplacerEnsembleSphereEtRayonSansArrondiNeChangePasUnBit() {
        Tirages tirages = new Tirages(46);
        int touches = 0;
        for (int k = 0; k < RAYONS; k++) {
            Point p = new Point(court(tirages.entre(-4, 4)), court(tirages.entre(-4, 4)), court(tirages.entre(-4, 4)));
            Point c = new Point(court(tirages.entre(-4, 4)), court(tirages.entre(-4, 4)), court(tirages.entre(-4, 4)));
            Vecteur saut = new Vecteur(court(tirages.entre(-1e6, 1e6)), court(tirages.entre(-1e6, 1e6)), court(tirages.entre(-1e6, 1e6)));
            double r = tirages.entre(0.1, 2);
            Vecteur v = new Vecteur(p, c).add(tirages.direction().mul(1.2 * r)).normalized();
            double t = new Sphere(c, r).getIntersectionDistance(new Rayon(p, v));
            assertEquals(t, new Sphere(c.add(saut), r).getIntersectionDistance(new Rayon(p.add(saut), v)), "graine 46, tirage " + k);
            touches += t < Constantes.INFINI ? 1 : 0;
        }
        assertTrue(touches > RAYONS / 4, touches + " touchés");
    }
}
