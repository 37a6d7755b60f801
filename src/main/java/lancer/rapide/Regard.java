package lancer.rapide;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.concurrent.CancellationException;
import java.util.stream.Collectors;
import lancer.Camera;
import lancer.Couleur;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.TousLesObjets;

/**
 * Ce que la recherche pourrait cacher, demandé au hasard avant le dessin : un objet qui répond hors de son enveloppe,
 * ou qui bouge. C'est un échantillon : une faute qu'il ne rencontre pas n'est pas vue. Rien n'en est compté.
 */
public final class Regard {

    /** Nombre de rayons, et d'objets demandés, à peu près. */
    private static final int RAYONS = 120;
    private static final int EXAMENS = 1 << 17;

    private final Random hasard = new Random(1);

    private Regard() {
    }

    /**
     * Dit si la recherche de cette scène préparée cache une réponse de ses objets.
     *
     * @throws CancellationException si ce fil est interrompu
     */
    public static boolean trouveUneReponseCachee(Scene preparee, Camera camera) {
        try {
            // chaque classe d'objets reçoit autant de rayons
            Map<String, List<Objet3D>> classes = preparee.getObjets().stream().filter(o -> o.getEnveloppe() != null)
                    .collect(Collectors.groupingBy(o -> o.getClass().getName(), TreeMap::new, Collectors.toList()));
            return new Regard().compare(preparee.pourUnFil(), new ArrayList<>(classes.values()), camera);
        } catch (CancellationException | OutOfMemoryError e) {
            throw e;
        } catch (RuntimeException | Error e) {
            // le dessin nommera le pixel qui échoue
            return false;
        }
    }

    private boolean compare(Scene preparee, List<List<Objet3D>> classes, Camera camera) {
        Scene toutes = preparee.avec(new TousLesObjets(preparee.getObjets()));
        boolean cache = false;
        int rayons = classes.isEmpty() ? 0 : RAYONS;
        for (int k = 0; k < rayons && !cache && toutes.getCompteurs().testsSpheres < EXAMENS; k++) {
            List<Objet3D> classe = classes.get(k / 2 % classes.size());
            Objet3D depart = k % 2 == 0 ? null : tirer(classe);
            Point vers = dans(tirer(classe), 2 * hasard.nextDouble());
            Rayon rayon = k % 4 == 0 ? camera.getRayon(camera.getLargeur() * hasard.nextDouble(),
                    camera.getHauteur() * hasard.nextDouble())
                    : new Rayon(depart == null ? camera.getOeil() : dans(depart, 1), vers);
            Couleur vue = toutes.getCouleurVue(rayon, depart, 0);
            // une couleur qui ne se répète pas ne dit rien de la recherche
            cache = !vue.equals(preparee.getCouleurVue(rayon, depart, 0))
                    && vue.equals(toutes.getCouleurVue(rayon, depart, 0));
        }
        return cache;
    }

    private Objet3D tirer(List<Objet3D> liste) {
        return liste.get(hasard.nextInt(liste.size()));
    }

    /** Un point de l'enveloppe de cet objet, à cette part de son rayon. */
    private Point dans(Objet3D objet, double part) {
        Vecteur direction = new Vecteur(hasard.nextGaussian(), hasard.nextGaussian(), hasard.nextGaussian());
        Sphere enveloppe = objet.getEnveloppe();
        return enveloppe.getCentre().add(part * enveloppe.getRayon(), direction.normalized());
    }
}
