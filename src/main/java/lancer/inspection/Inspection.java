package lancer.inspection;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.PixelFautif;
import lancer.contrat.Toile;
import lancer.contrat.Vue;
import lancer.fils.Equipe;
import lancer.inspection.Chemin.Segment;
import lancer.inspection.Chemin.Terme;

/**
 * Explication d'un pixel. Le pixel est dessiné selon l'échantillonnage de la scène, avec les autres pixels de son pavé
 * s'il partage des points avec eux. Puis l'un de ses échantillons est recalculé en notant les détails.
 */
public final class Inspection implements Vue, Toile {

    /** Rang qui désigne l'échantillon le plus proche du centre. */
    public static final int AU_CENTRE = -1;

    public final Scene scene;
    private final Function<Object, String> origines;
    public final Camera camera;
    public final int profondeur;
    public final int x;
    public final int y;
    private final Chemin chemin = new Chemin();
    private final Equipe equipe = new Equipe("lancer");
    private final Lancer lancer;
    private Couleur couleur;
    private List<Echantillon> echantillons = Collections.emptyList();
    private Echantillon choisi;
    private PixelFautif faute;
    /** Échantillons pris près du pixel, par l'objet {@link Couleur} que la vue a rendu. */
    private final Map<Couleur, Echantillon> vus = new IdentityHashMap<>();

    /** Termes d'une somme pondérée, somme, diviseur ; {@code somme} est {@code null} si elle n'est pas notée. */
    final List<Echantillon> termes = new ArrayList<>();
    Couleur somme;
    double diviseur;

    /** @param profondeur nombre de réflexions permises @param x colonne, depuis 0 @param y ligne, depuis 0 en haut */
    public Inspection(Scene scene, Function<Object, String> origines, Camera camera, int profondeur, int x, int y) {
        this.scene = scene;
        this.origines = origines;
        this.camera = camera;
        this.profondeur = profondeur;
        this.x = x;
        this.y = y;
        lancer = new Lancer(scene.avec(scene.getModele()), camera);
    }

    /** Explique l'échantillon le plus proche du centre. @throws CancellationException si ce fil est interrompu */
    public void faire() {
        // un fil d'une équipe a une pile assez grande pour les réflexions permises
        equipe.faire(() -> expliquer(AU_CENTRE));
    }

    /** Explique l'échantillon de ce rang. Si le calcul échoue, garde la faute et les segments qui la précèdent. */
    public void faireOuEchouer(int rang) {
        try {
            equipe.faire(() -> expliquer(rang));
        } catch (PixelFautif e) {
            faute = e;
            chercherLesObstacles();
        }
    }

    private void expliquer(int rang) {
        Echantillonnage echantillonnage = scene.getModele().getEchantillonnage();
        Pave pave = Pave.autour(x, y, camera.getLargeur(), camera.getHauteur());
        echantillonnage.tracer(pave, new Pave(x, y, x + 1, y + 1), this, this);
        echantillons = vus.values().stream()
                .filter(e -> e.estDans(x, y) || termes.stream().anyMatch(t -> t.xe == e.xe && t.ye == e.ye))
                .sorted(Comparator.<Echantillon>comparingDouble(e -> e.ye).thenComparingDouble(e -> e.xe))
                .collect(Collectors.toList());
        if (!echantillons.isEmpty()) {
            choisi = rang == AU_CENTRE ? Collections.min(echantillons,
                    Comparator.comparingDouble(e -> Math.hypot(e.xe - x - 0.5, e.ye - y - 0.5)))
                    : echantillons.get(Math.min(rang, echantillons.size() - 1));
            lancer.getCouleurPixel(choisi.xe, choisi.ye, profondeur);
            chercherLesObstacles();
        }
    }

    /** Cherche l'objet qui cache chaque lampe cachée : le calcul de la couleur n'a pas besoin de le nommer. */
    private void chercherLesObstacles() {
        Scene sienne = scene.avec(scene.getModele());
        for (Segment segment : chemin.segments) {
            segment.lampes.stream().filter(lampe -> lampe.L != null && !lampe.ajouts.contains(lampe.produit))
                    .forEach(lampe -> lampe.cache = obstacle(lampe, segment.contact, sienne));
        }
    }

    private static PointContact obstacle(Terme cachee, PointContact contact, Scene scene) {
        boolean lointaine = Scene.estLointaine(cachee.lampe, contact);
        double portee = lointaine ? cachee.distance / 2 : cachee.distance;
        Rayon ombre = Rayon.norme(cachee.lampe.getPosition(), cachee.L.neg());
        PointContact depuisLaLampe = scene.getClosestIntersection(ombre, contact.objet);
        if (ombre.getDistance() < portee || !lointaine) {
            return ombre.getDistance() < portee ? depuisLaLampe : null;
        }
        Rayon versLampe = Rayon.norme(contact, cachee.L);
        return scene.getObjets().stream()
                .filter(objet -> objet != contact.objet && objet.getIntersectionDistance(versLampe) < portee)
                .map(objet -> versLampe.calcContact()).max(Comparator.comparingDouble(dernier -> dernier.distance))
                .orElse(null);
    }

    /** Échec du calcul de ce pixel ; {@code null} s'il a une couleur. */
    public PixelFautif getFaute() {
        return faute;
    }

    public Couleur getCouleur() {
        return couleur;
    }

    /** Échantillons du pixel, partagés compris, dans l'ordre de leur addition : ligne par ligne. */
    public List<Echantillon> getEchantillons() {
        return echantillons;
    }

    /** Rayon de l'échantillon choisi ou, à défaut, de celui qui échoue ; {@code null} s'il n'y en a pas. */
    public Rayon getDepart() {
        if (getSegments().isEmpty()) {
            return null;
        }
        return faute != null ? camera.getRayon(faute.xe, faute.ye) : camera.getRayon(choisi.xe, choisi.ye);
    }

    public Echantillon getChoisi() {
        return choisi;
    }

    /** Le rayon initial, puis les rayons réfléchis. */
    public List<Segment> getSegments() {
        return chemin.segments;
    }

    /** Nom de la forme {@code [Sphere ambre] ligne 52} ou, sans fichier, rang dans la scène. */
    public String nom(Object chose) {
        String origine = origines.apply(chose);
        if (origine != null) {
            return origine;
        }
        return chose instanceof Lampe ? "lampe " + (1 + scene.getLampes().indexOf(chose))
                : "objet " + (1 + scene.getObjets().indexOf(chose));
    }

    /** {@inheritDoc} La couleur est copiée : deux échantillons égaux restent des objets distincts. */
    @Override
    public Couleur couleur(double xe, double ye) {
        equipe.obeir();
        Couleur vu = lancer.getCouleurPixel(xe, ye, profondeur);
        Couleur sienne = new Couleur(vu.r, vu.v, vu.b);
        if (xe >= x && xe < x + 2 && ye >= y && ye < y + 2) {
            vus.put(sienne, new Echantillon(xe, ye, 1, sienne));
        }
        return sienne;
    }

    @Override
    public void drawPixel(Couleur coul, int i, int j) {
        if (i == x && j == y) {
            couleur = coul;
        } else if (couleur == null) {
            termes.clear();
            somme = null;
        }
    }
}
