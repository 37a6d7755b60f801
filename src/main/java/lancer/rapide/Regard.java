package lancer.rapide;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.CancellationException;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Recherche;
import lancer.image.ImageMemoire;

/**
 * Ce que la recherche pourrait cacher, demandé au hasard : un objet qui répond hors de son enveloppe, un objet qui
 * bouge, une réponse qui change d'un appel à l'autre. C'est un échantillon : une faute qu'il ne rencontre pas n'est pas
 * vue. Rien n'en est compté dans les statistiques.
 */
public final class Regard {

    private static final String CACHE = "un objet bouge, ou répond hors de son enveloppe ou selon l'ordre des "
            + "questions : ce sont les boucles sur tous les objets qui dessinent";
    private static final String CHANGE = "la réponse change d'un appel à l'autre : un champ garde-t-il quelque chose ?";

    /** Nombre de rayons avant le dessin, et d'objets demandés, à peu près, avant lui, puis après lui. */
    private static final int RAYONS = 120;
    private static final int EXAMENS = 1 << 17;

    /** Nombre de pixels demandés de nouveau après le dessin : au plus 200, et un sur cent. */
    private static final int PIXELS = 200;
    private static final int UN_SUR = 100;

    private final Random hasard = new Random(1);
    private String ecart;

    /** Compare la recherche de cette scène préparée aux réponses de tous ses objets, et l'ôte si elle en cache une. */
    public Regard(Scene scene, Camera camera) {
        if (scene.getModele().getRecherche() != null && cache(scene, camera)) {
            oter(scene);
        }
    }

    /** Une phrase, si la recherche cachait une réponse, ou si une réponse change ; {@code null} sinon. */
    public String getEcart() {
        return ecart;
    }

    private void oter(Scene scene) {
        scene.getModele().setRecherche(null);
        ecart = CACHE;
    }

    private static Scene sansRecherche(Scene scene) {
        Scene toutes = scene.avec(scene.getModele());
        toutes.getModele().setRecherche(null);
        return toutes;
    }

    private boolean cache(Scene scene, Camera camera) {
        // les objets de chaque classe, pour autant de rayons
        Map<Class<?>, List<Objet3D>> parClasse = new LinkedHashMap<>();
        for (Objet3D objet : scene.getObjets()) {
            if (objet.getEnveloppe() != null) {
                parClasse.computeIfAbsent(objet.getClass(), classe -> new ArrayList<>()).add(objet);
            }
        }
        List<List<Objet3D>> classes = new ArrayList<>(parClasse.values());
        Scene toutes = sansRecherche(scene);
        Scene cherchee = scene.avec(scene.getModele());
        try {
            // les boucles peuvent demander un objet que la scène ne donne pas à la recherche
            toutes.getClosestIntersection(camera.getRayon(0, 0));
            boolean cache = toutes.getCompteurs().testsSpheres > scene.getObjets().size();
            int rayons = classes.isEmpty() ? 0 : RAYONS;
            for (int k = 0; k < rayons && !cache && toutes.getCompteurs().testsSpheres < EXAMENS; k++) {
                List<Objet3D> classe = classes.get(k / 2 % classes.size());
                Objet3D depart = k % 2 == 0 ? null : tirer(classe);
                Point P = depart == null ? camera.getOeil() : dans(depart, 1);
                Rayon rayon = new Rayon(P, dans(tirer(classe), hasard.nextDouble()));
                Couleur vue = toutes.getCouleurVue(rayon, depart, 0);
                // une couleur qui ne se répète pas ne dit rien de la recherche
                cache = deborde(rayon) || !vue.equals(cherchee.getCouleurVue(rayon, depart, 0))
                        && vue.equals(toutes.getCouleurVue(rayon, depart, 0));
            }
            return cache;
        } catch (CancellationException | OutOfMemoryError e) {
            throw e;
        } catch (RuntimeException | Error e) {
            // le dessin nommera le pixel qui échoue
            return false;
        }
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

    /** Dit si le contact de ce rayon est hors de l'enveloppe de son objet. */
    private static boolean deborde(Rayon rayon) {
        Sphere enveloppe = rayon.getObjet() == null ? null : rayon.getObjet().getEnveloppe();
        if (enveloppe == null) {
            return false;
        }
        Point c = enveloppe.getCentre();
        double r = enveloppe.getRayon();
        double marge = 1e-6 * (Math.abs(rayon.getDistance()) + Enveloppes.plusGrande(c.x, c.y, c.z) + r);
        return new Vecteur(c, rayon.getP().add(rayon.getDistance(), rayon.getV())).norme() > r + marge;
    }

    /**
     * Demande de nouveau quelques pixels d'une image achevée. Si la recherche en cachait une réponse, elle est ôtée du
     * modèle.
     *
     * @param acheve le lancer qui a dessiné l'image
     * @return vrai si l'image est à dessiner de nouveau, par les boucles sur tous les objets
     */
    public boolean cachait(Lancer acheve, ImageMemoire image, int profondeur) {
        Scene scene = acheve.getScene();
        Recherche recherche = scene.getModele().getRecherche();
        boolean cache = recherche instanceof Preparation && !((Preparation) recherche).estEnPlace();
        if (!cache && acheve.getFautes().getPremiere() == null) {
            int[] pixels = choisir(image);
            if (differe(scene.avec(scene.getModele()), acheve.getCamera(), image, pixels, profondeur)) {
                ecart = CHANGE;
                return false;
            }
            cache = recherche != null && differe(sansRecherche(scene), acheve.getCamera(), image, pixels, profondeur);
        }
        if (cache) {
            oter(scene);
        }
        return cache;
    }

    /** Dans chaque bande de l'image, un pixel au hasard et le plus isolé : une faute n'en change parfois qu'un seul. */
    private int[] choisir(ImageMemoire image) {
        long nombre = (long) image.largeur * image.hauteur;
        int bandes = (int) Math.min(PIXELS, nombre / UN_SUR) / 2;
        int[] pixels = new int[2 * bandes];
        for (int b = 0; b < bandes; b++) {
            int debut = (int) (b * nombre / bandes);
            int fin = (int) ((b + 1) * nombre / bandes);
            pixels[2 * b] = debut + hasard.nextInt(fin - debut);
            pixels[2 * b + 1] = image.plusIsole(debut, fin);
        }
        return pixels;
    }

    /** Dit si, pour cette scène, un seul fil trouve à l'un de ces pixels une autre couleur que celle de l'image. */
    private static boolean differe(Scene scene, Camera camera, ImageMemoire image, int[] pixels, int profondeur) {
        Lancer lancer = new Lancer(scene, camera);
        lancer.getFautes().tolerer();
        Echantillonnage choisi = scene.getModele().getEchantillonnage();
        Echantillonnage prepare = choisi == null ? null : choisi.pour(scene.getObjets(), camera);
        boolean[] differe = new boolean[1];
        for (int p = 0; p < pixels.length && !differe[0] && scene.getCompteurs().testsSpheres < EXAMENS; p++) {
            int i = pixels[p] % image.largeur;
            int j = pixels[p] / image.largeur;
            lancer.TracerPixels(Pave.autour(i, j, image.largeur, image.hauteur), new Pave(i, j, i + 1, j + 1), prepare,
                    (couleur, x, y) -> differe[0] |= !image.contient(couleur, x, y), profondeur);
        }
        return differe[0];
    }
}
