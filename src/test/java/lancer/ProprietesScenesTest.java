package lancer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.Collections;
import lancer.contrat.Recherche;
import lancer.contrat.RechercheSimple;
import lancer.rapide.Preparation;
import org.junit.jupiter.api.Test;

/** Ce qui est vrai de tous les rayons de toutes les scènes : au moins cent mille rayons par propriété, à graine fixe. */
class ProprietesScenesTest {

    private static final int RAYONS = 100_000;
    private static final int RAYONS_PAR_SCENE = 1_000;
    private static final Camera CAMERA = new Camera(50, 40);

    private static Recherche simple(Scene scene) {
        return new RechercheSimple(scene.getObjets(), scene.getCompteurs());
    }

    private static Rayon copie(Rayon rayon) {
        return new Rayon(rayon.getP(), rayon.getV(), new Couleur(1));
    }

    @Test
    void laRechercheRapideRepondCommeLesBouclesDuCoursAuBitPres() {
        Tirages tirages = new Tirages(42);
        for (int n = 0; n < RAYONS; n += RAYONS_PAR_SCENE) {
            Scene scene = tirages.scene(1 + tirages.hasard.nextInt(n % 3 == 0 ? 120 : 20));
            Recherche simple = simple(scene);
            Recherche rapide = Preparation.pour(scene, CAMERA);
            for (int k = 0; k < RAYONS_PAR_SCENE; k++) {
                String cas = "graine 42, rayon " + (n + k);
                Rayon rayon = new Rayon(tirages.point(), tirages.direction());
                Objet3D sauf = k % 2 == 0 ? null : scene.getObjets().get(tirages.hasard.nextInt(scene.getObjets().size()));
                Rayon memeRayon = copie(rayon);
                simple.plusProche(rayon, sauf);
                rapide.plusProche(memeRayon, sauf);
                assertSame(rayon.getObjet(), memeRayon.getObjet(), cas);
                assertEquals(rayon.getDistance(), memeRayon.getDistance(), cas);
                PointContact contact = rayon.calcContact();
                for (Lampe lampe : contact == null ? Collections.<Lampe>emptyList() : scene.getLampes()) {
                    if (!contact.sub(lampe.getPosition()).equals(new Vecteur())) {
                        assertEquals(simple.estCachee(lampe, contact, contact.objet), rapide.estCachee(lampe, contact, contact.objet), cas);
                    }
                }
            }
        }
    }
}
