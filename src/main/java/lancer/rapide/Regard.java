package lancer.rapide;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.PriorityQueue;
import java.util.Random;
import java.util.concurrent.CancellationException;
import java.util.stream.Collectors;
import java.util.stream.Stream;
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
import lancer.contrat.Modele;
import lancer.contrat.Pave;
import lancer.contrat.Recherche;
import lancer.contrat.Toile;
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
    private final Scene scene;
    private final Camera camera;
    private String ecart;

    /** Compare la recherche de cette scène préparée aux réponses de tous ses objets, et l'ôte si elle en cache une. */
    public Regard(Scene scene, Camera camera) {
        this.scene = scene;
        this.camera = camera;
        if (scene.getModele().getRecherche() != null && cache()) {
            oter(scene.getModele());
        }
    }

    /** Une phrase, si la recherche cachait une réponse, ou si une réponse change ; {@code null} sinon. */
    public String getEcart() {
        return ecart;
    }

    private void oter(Modele modele) {
        modele.setRecherche(null);
        ecart = CACHE;
    }

    private static Modele sansRecherche(Modele modele) {
        Modele simple = modele.avec(modele.getEchantillonnage(), modele.getSeuil());
        simple.setRecherche(null);
        return simple;
    }

    private boolean cache() {
        // les objets de chaque classe, pour autant de rayons
        List<List<Objet3D>> classes = new ArrayList<>(scene.getObjets().stream().filter(o -> o.getEnveloppe() != null)
                .collect(Collectors.groupingBy(Object::getClass, LinkedHashMap::new, Collectors.toList())).values());
        Scene toutes = scene.avec(sansRecherche(scene.getModele()));
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
                cache = cache(toutes, cherchee, new Rayon(P, dans(tirer(classe), hasard.nextDouble())), depart);
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

    /** Dit si le contact est hors de son enveloppe, ou si la recherche change une couleur qui, sans elle, se répète. */
    private static boolean cache(Scene toutes, Scene cherchee, Rayon rayon, Objet3D depart) {
        Couleur cherche = cherchee.getCouleurVue(rayon, depart, 0);
        Couleur vue = toutes.getCouleurVue(rayon, depart, 0);
        return deborde(rayon) || !vue.equals(cherche) && vue.equals(toutes.getCouleurVue(rayon, depart, 0));
    }

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
        Modele modele = acheve.getScene().getModele();
        Recherche recherche = modele.getRecherche();
        boolean cache = recherche instanceof Preparation && !((Preparation) recherche).estEnPlace();
        if (!cache && acheve.getFautes().getPremiere() == null) {
            List<Integer> pixels = choisir(image);
            if (differe(modele, image, pixels, profondeur)) {
                ecart = CHANGE;
                return false;
            }
            cache = recherche != null && differe(sansRecherche(modele), image, pixels, profondeur);
        }
        if (cache) {
            oter(modele);
        }
        return cache;
    }

    /** Des pixels, l'un au hasard, l'autre parmi les plus isolés : une faute n'en change parfois que quelques-uns. */
    private List<Integer> choisir(ImageMemoire image) {
        int nombre = image.largeur * image.hauteur;
        int combien = Math.min(PIXELS, nombre / UN_SUR) / 2;
        int[] voisins = {-1, 1, -image.largeur, image.largeur};
        // l'isolement d'un pixel, puis son rang ; un pixel moins isolé que tous ceux-là n'en fait pas partie
        PriorityQueue<Long> isoles = new PriorityQueue<>();
        int moindre = -1;
        for (int k = 0; k < nombre && combien > 0; k++) {
            int isolement = 255;
            for (int n = 0; n < voisins.length && isolement > moindre; n++) {
                int voisin = k + voisins[n];
                isolement = voisin < 0 || voisin >= nombre ? isolement : Math.min(isolement, image.ecart(k, voisin));
            }
            if (isolement > moindre) {
                isoles.add((long) isolement << 32 | k);
                if (isoles.size() > combien) {
                    isoles.remove();
                    moindre = (int) (isoles.peek() >> 32);
                }
            }
        }
        return isoles.stream().flatMap(cle -> Stream.of(hasard.nextInt(nombre), cle.intValue()))
                .collect(Collectors.toList());
    }

    /** Dit si, pour ce modèle, un seul fil trouve à l'un de ces pixels une autre couleur que celle de l'image. */
    private boolean differe(Modele modele, ImageMemoire image, List<Integer> pixels, int profondeur) {
        Lancer lancer = new Lancer(scene.avec(modele), camera);
        lancer.getFautes().tolerer();
        Echantillonnage choisi = modele.getEchantillonnage() == null ? null
                : modele.getEchantillonnage().pour(scene.getObjets(), camera);
        boolean[] differe = new boolean[1];
        Toile comparaison = (couleur, x, y) -> differe[0] |= !image.contient(couleur, x, y);
        for (int k : pixels) {
            if (differe[0] || lancer.getScene().getCompteurs().testsSpheres >= EXAMENS) {
                break;
            }
            int i = k % image.largeur;
            int j = k / image.largeur;
            lancer.TracerPixels(Pave.autour(i, j, image.largeur, image.hauteur), new Pave(i, j, i + 1, j + 1), choisi,
                    comparaison, profondeur);
        }
        return differe[0];
    }
}
