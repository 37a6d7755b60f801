package lancer.rapide;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BooleanSupplier;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Modele;
import lancer.contrat.Pave;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/**
 * Ce que la recherche pourrait cacher, demandé au hasard : un objet qui répond hors de son enveloppe, un objet qui bouge,
 * une réponse qui change d'un appel à l'autre. C'est un échantillon : une faute qu'il ne rencontre pas n'est pas vue. Rien
 * n'en est compté dans les statistiques. Pendant le dessin, cette toile en retient quelques pixels.
 */
public final class Regard implements Toile {

    private static final String CACHE = "un objet bouge, ou répond hors de son enveloppe ou selon l'ordre des questions : ce sont "
            + "les boucles sur tous les objets qui dessinent";
    private static final String CHANGE = "la réponse change d'un appel à l'autre : un champ garde-t-il quelque chose ?";

    /** Nombre de rayons avant le dessin ; nombre d'objets que demandent les boucles, avant puis après lui, à peu près. */
    private static final int RAYONS = 120;
    private static final int EXAMENS = 1 << 17;

    /** Nombre de pixels demandés de nouveau après le dessin, et leur part de l'image, au plus. */
    private static final int PIXELS = 200;
    private static final double PART = 0.01;

    private final Camera camera;
    private final int pixels;
    private final Random hasard = new Random(1);
    private final Map<Integer, Couleur> dessines = new ConcurrentHashMap<>();
    private final BooleanSupplier enPlace;
    private Toile toile;
    private String ecart;

    /**
     * Compare la recherche de cette scène à toutes les réponses de ses objets, et l'ôte du modèle si elle en cache une.
     *
     * @param enPlace dit si les objets sont là où elle les croit
     */
    Regard(Scene scene, Camera camera, BooleanSupplier enPlace) {
        this.camera = camera;
        pixels = camera.getLargeur() * camera.getHauteur();
        this.enPlace = enPlace;
        if (scene.getModele().getRecherche() != null && cache(scene)) {
            oter(scene);
        }
    }

    private void oter(Scene scene) {
        scene.getModele().setRecherche(null);
        ecart = CACHE;
    }

    /** Une phrase, si la recherche cachait une réponse, ou si une réponse change ; {@code null} sinon. */
    public String getEcart() {
        return ecart;
    }

    private boolean cache(Scene scene) {
        // les objets de chaque classe, pour autant de rayons
        Map<Class<?>, List<Objet3D>> parClasse = new LinkedHashMap<>();
        for (Objet3D objet : scene.getObjets()) {
            if (objet.getEnveloppe() != null) {
                parClasse.computeIfAbsent(objet.getClass(), classe -> new ArrayList<>()).add(objet);
            }
        }
        List<List<Objet3D>> classes = new ArrayList<>(parClasse.values());
        Scene toutes = scene.avec(sansRecherche(scene.getModele()));
        Scene cherchee = scene.avec(scene.getModele());
        try {
            boolean cache = false;
            for (int k = 0; k < RAYONS && !cache && toutes.getCompteurs().testsSpheres < EXAMENS; k++) {
                List<Objet3D> classe = classes.isEmpty() ? null : classes.get(k % classes.size());
                Objet3D depart = classe == null || k % 3 != 2 ? null : classe.get(hasard.nextInt(classe.size()));
                Objet3D cible = classe == null ? null : classe.get(hasard.nextInt(classe.size()));
                Lampe lampe = scene.getLampes().isEmpty() ? null
                        : scene.getLampes().get(hasard.nextInt(scene.getLampes().size()));
                Rayon rayon = tirer(k % 3 == 1 ? lampe : null, depart, cible);
                cache = rayon != null && (deborde(cible, rayon) || differe(toutes, cherchee, rayon, depart, lampe));
            }
            return cache;
        } catch (CancellationException | OutOfMemoryError e) {
            throw e;
        } catch (RuntimeException | Error e) {
            // le dessin nommera le pixel qui échoue
            return false;
        }
    }

    /** Un rayon de la lampe ou de l'enveloppe de {@code depart} vers celle de {@code cible}, ou un rayon de l'écran. */
    private Rayon tirer(Lampe lampe, Objet3D depart, Objet3D cible) {
        if (cible == null || lampe == null && depart == null) {
            return camera.getRayon(camera.getLargeur() * hasard.nextDouble(), camera.getHauteur() * hasard.nextDouble());
        }
        Point P = lampe != null ? lampe.getPosition() : dans(depart, 1);
        Vecteur V = new Vecteur(P, dans(cible, hasard.nextDouble()));
        return V.norme() > 0 && V.norme() <= Double.MAX_VALUE ? new Rayon(P, V) : null;
    }

    /** Un point de l'enveloppe de cet objet, à cette part de son rayon. */
    private Point dans(Objet3D objet, double part) {
        Vecteur direction = new Vecteur(hasard.nextGaussian(), hasard.nextGaussian(), hasard.nextGaussian());
        Sphere enveloppe = objet.getEnveloppe();
        return enveloppe.getCentre().add(part * enveloppe.getRayon(), direction.normalized());
    }

    /** Dit si ce rayon rencontre cet objet hors de son enveloppe. */
    private static boolean deborde(Objet3D objet, Rayon rayon) {
        double d = objet == null ? Double.POSITIVE_INFINITY : objet.getIntersectionDistance(rayon);
        if (!(d < Double.POSITIVE_INFINITY)) {
            return false;
        }
        Sphere enveloppe = objet.getEnveloppe();
        Point contact = rayon.getP().add(d, rayon.getV());
        Point c = enveloppe.getCentre();
        double marge = 1e-6 * (Math.abs(d) + Enveloppes.plusGrande(c.x, c.y, c.z) + enveloppe.getRayon());
        return new Vecteur(c, contact).norme() > enveloppe.getRayon() + marge;
    }

    /** Dit si la recherche et les boucles sur tous les objets répondent autrement à ce rayon, ou à une ombre de son contact. */
    private static boolean differe(Scene toutes, Scene cherchee, Rayon rayon, Objet3D depart, Lampe lampe) {
        long avant = toutes.getCompteurs().testsSpheres;
        PointContact attendu = toutes.getClosestIntersection(rayon, depart);
        Rayon autre = Rayon.dOmbre(rayon.getP(), rayon.getV());
        cherchee.getClosestIntersection(autre, depart);
        if (toutes.getCompteurs().testsSpheres - avant > toutes.getObjets().size() || autre.getObjet() != rayon.getObjet()
                || Double.compare(autre.getDistance(), rayon.getDistance()) != 0) {
            return true;
        }
        Vecteur versLampe = attendu == null || lampe == null ? new Vecteur() : new Vecteur(attendu, lampe.getPosition());
        if (attendu == null || !(attendu.objet.getNormale(attendu).dot(versLampe) > 0)) {
            return false;
        }
        Vecteur L = versLampe.normalized();
        return toutes.estCachee(lampe, attendu, L, versLampe.norme(), attendu.objet)
                != cherchee.estCachee(lampe, attendu, L, versLampe.norme(), attendu.objet);
    }

    private static Modele sansRecherche(Modele modele) {
        Modele simple = modele.avec(modele.getEchantillonnage(), modele.getSeuil());
        simple.setRecherche(null);
        return simple;
    }

    /** La toile à donner au dessin à la place de celle-ci. */
    public Toile sur(Toile surveillee) {
        toile = surveillee;
        dessines.clear();
        return this;
    }

    @Override
    public void drawPixel(Couleur coul, int xe, int ye) {
        int rang = ye * camera.getLargeur() + xe;
        // les multiples du nombre d'or sont bien répartis
        if ((rang * 0x9E3779B9 >>> 1) < Integer.MAX_VALUE * Math.min(PART, (double) PIXELS / pixels)) {
            dessines.put(rang, coul);
        }
        toile.drawPixel(coul, xe, ye);
    }

    @Override
    public void finirBrouillon() {
        dessines.clear();
        toile.finirBrouillon();
    }

    /**
     * Demande de nouveau quelques pixels du dernier dessin. Si la recherche en cachait une réponse, elle est ôtée du
     * modèle.
     *
     * @param acheve le lancer qui a dessiné
     * @return vrai si l'image est à dessiner de nouveau, par les boucles sur tous les objets
     */
    public boolean cachait(Lancer acheve, int profondeur) {
        Scene scene = acheve.getScene();
        if (scene.getModele().getRecherche() != null && !enPlace.getAsBoolean()) {
            oter(scene);
            return true;
        }
        List<Integer> tous = new ArrayList<>(dessines.keySet());
        Modele modele = scene.getModele();
        Modele simple = sansRecherche(modele);
        double parPixel = scene.getObjets().size() * (double) acheve.getCompteurs().rayons() / pixels;
        List<Integer> quelques = tous.subList(0, (int) Math.min(tous.size(), 1 + EXAMENS / (1 + parPixel)));
        Map<Integer, Couleur> trouves = demander(scene, modele, profondeur, tous);
        Map<Integer, Couleur> attendus = modele.getRecherche() == null ? trouves
                : demander(scene, simple, profondeur, quelques);
        boolean cache = attendus.entrySet().stream().anyMatch(e -> !e.getValue().equals(trouves.get(e.getKey())));
        if (cache && attendus.equals(demander(scene, simple, profondeur, quelques))) {
            oter(scene);
            return true;
        }
        if (ecart == null && (cache || !trouves.equals(dessines))) {
            ecart = CHANGE;
        }
        return false;
    }

    /** La couleur de ces seuls pixels. */
    private Map<Integer, Couleur> demander(Scene scene, Modele modele, int profondeur, List<Integer> rangs) {
        Map<Integer, Couleur> couleurs = new HashMap<>();
        Lancer lancer = new Lancer(scene.avec(modele), camera);
        lancer.getFautes().tolerer();
        int largeur = camera.getLargeur();
        Vue vue = (xe, ye) -> lancer.getCouleurPixel(xe, ye, profondeur);
        Echantillonnage choisi = modele.getEchantillonnage() == null ? null
                : modele.getEchantillonnage().pour(scene.getObjets(), camera);
        for (int rang : rangs) {
            int i = rang % largeur;
            int j = rang / largeur;
            if (choisi == null) {
                couleurs.put(rang, vue.couleur(i + 0.5, j + 0.5));
            } else {
                choisi.tracer(Pave.autour(i, j, largeur, camera.getHauteur()), new Pave(i, j, i + 1, j + 1), vue,
                        (c, x, y) -> couleurs.put(y * largeur + x, c));
            }
        }
        couleurs.keySet().retainAll(rangs);
        return couleurs;
    }
}
