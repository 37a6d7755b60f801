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
import lancer.contrat.Cause;
import lancer.contrat.TousLesObjets;

/**
 * Ce que la recherche pourrait cacher, demandé au hasard avant le dessin : un objet qui répond hors de son enveloppe,
 * qui bouge ou qui échoue. C'est un échantillon : une faute qu'il ne rencontre pas n'est pas vue. Rien n'en est compté.
 */
public final class Regard {

    /** Nombre de rayons, et d'objets demandés, à peu près. */
    private static final int RAYONS = 120;
    private static final int EXAMENS = 1 << 17;

    private static final String BOUCLES = "image dessinée par les boucles, plus lentement : ";

    private final Random hasard = new Random(1);
    /** Le dernier rayon tiré. */
    private Rayon rayon;

    private Regard() {
    }

    /**
     * Compare la recherche d'une scène préparée aux réponses de tous les objets.
     *
     * @return pourquoi ce sont les boucles qui dessinent, en une phrase ; {@code null} si rien ne s'y oppose
     * @throws CancellationException si ce fil est interrompu
     */
    public static String regarder(Scene preparee, Camera camera) {
        Regard regard = new Regard();
        try {
            // chaque classe d'objets reçoit autant de rayons
            Map<String, List<Objet3D>> classes = preparee.getObjets().stream().filter(o -> o.getEnveloppe() != null)
                    .collect(Collectors.groupingBy(o -> o.getClass().getName(), TreeMap::new, Collectors.toList()));
            return regard.compare(preparee.pourUnFil(), new ArrayList<>(classes.values()), camera) ? BOUCLES
                    + "une forme a bougé, répond selon l'ordre des questions, ou touche un rayon hors de son enveloppe"
                    : null;
        } catch (CancellationException | OutOfMemoryError e) {
            throw e;
        } catch (RuntimeException | Error e) {
            return BOUCLES + "une forme échoue" + regard.ou() + " : " + Cause.dire(e);
        }
    }

    /** La classe de l'objet que touchait ce rayon, s'il en touchait un. */
    private String ou() {
        return rayon == null || rayon.getObjet() == null ? ""
                : ", sur un rayon qui touche " + rayon.getObjet().getClass().getName();
    }

    private boolean compare(Scene preparee, List<List<Objet3D>> classes, Camera camera) {
        Scene sansRecherche = preparee.avec(new TousLesObjets(preparee.getObjets()));
        boolean cache = false;
        int rayons = classes.isEmpty() ? 0 : RAYONS;
        for (int k = 0; k < rayons && !cache && sansRecherche.getCompteurs().testsSpheres < EXAMENS; k++) {
            List<Objet3D> classe = classes.get(k / 2 % classes.size());
            Objet3D depart = k % 2 == 0 ? null : tirer(classe);
            Point vers = dans(tirer(classe), 2 * hasard.nextDouble());
            try {
                rayon = k % 4 == 0 ? camera.getRayon(camera.getLargeur() * hasard.nextDouble(),
                        camera.getHauteur() * hasard.nextDouble())
                        : new Rayon(depart == null ? camera.getOeil() : dans(depart, 1), vers);
            } catch (ArithmeticException e) {
                // deux points confondus : ce rayon n'existe pas
                continue;
            }
            Couleur vue = sansRecherche.getCouleurVue(rayon, depart, 0);
            // une couleur qui ne se répète pas ne dit rien de la recherche
            cache = !vue.equals(preparee.getCouleurVue(rayon, depart, 0))
                    && vue.equals(sansRecherche.getCouleurVue(rayon, depart, 0));
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
