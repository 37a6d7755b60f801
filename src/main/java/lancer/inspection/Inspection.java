package lancer.inspection;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Point;
import lancer.Scene;
import lancer.contrat.Pave;
import lancer.contrat.PixelFautif;
import lancer.contrat.Releve;
import lancer.contrat.Vue;
import lancer.fils.Equipe;

/**
 * Explication d'un pixel. Le pixel est dessiné selon l'échantillonnage de la scène, avec les autres pixels de son pavé
 * s'il partage des points avec eux. Puis les rayons de l'un de ses échantillons sont suivis par les méthodes publiques
 * des classes du cours.
 */
public final class Inspection {

    public final Scene scene;
    private final Function<Object, String> origines;
    public final Camera camera;
    public final int profondeur;
    public final int x;
    public final int y;
    private final Equipe equipe = new Equipe();
    private final Lancer lancer;
    private Couleur couleur;
    private PixelFautif faute;

    /** Les échantillons du pixel, ceux qu'il partage compris : points de l'écran, ligne par ligne, et couleurs. */
    final Map<Point, Couleur> echantillons =
            new TreeMap<>(Comparator.<Point>comparingDouble(p -> p.y).thenComparingDouble(p -> p.x));

    /** L'échantillon expliqué, le plus proche du centre ; ce que les segments n'expliquent pas dans sa couleur. */
    Point choisi;
    Couleur autre = new Couleur();

    private final List<Segment> segments = new ArrayList<>();

    /** Le premier échec du dessin ou, à défaut, de l'explication ; {@code null} s'il n'y en a pas. */
    Throwable echec;

    /** @param profondeur nombre de réflexions permises @param x colonne, depuis 0 @param y ligne, depuis 0 en haut */
    public Inspection(Scene scene, Function<Object, String> origines, Camera camera, int profondeur, int x, int y) {
        this.scene = scene;
        this.origines = origines;
        this.camera = camera;
        this.profondeur = profondeur;
        this.x = x;
        this.y = y;
        lancer = new Lancer(scene.pourUnFil(), camera);
    }

    /**
     * Explique l'échantillon le plus proche du centre. Si son calcul échoue, la faute et ce qui la précède sont gardés.
     *
     * @param deuxFois dit si l'image se regarde deux fois : n'est demandé que si ce pixel peut en dépendre
     * @throws CancellationException si ce fil est interrompu
     */
    public void faire(BooleanSupplier deuxFois) {
        // un fil d'une équipe a une pile assez grande pour les réflexions permises
        equipe.faire(() -> {
            try {
                dessiner(deuxFois);
                expliquer();
            } catch (PixelFautif e) {
                faute = e;
                echec = e;
                echantillons.clear();
                suivre(e.xe, e.ye);
            }
        });
    }

    private void dessiner(BooleanSupplier deuxFois) {
        Vue vue = this::voir;
        if (dessiner(vue).aRevoir && deuxFois.getAsBoolean()) {
            couleur = null;
            echantillons.clear();
            dessiner(vue.seconde());
        }
    }

    private Releve dessiner(Vue vue) {
        Pave pave = Pave.autour(x, y, camera.getLargeur(), camera.getHauteur());
        return lancer.getEchantillonnage().tracer(pave, new Pave(x, y, x + 1, y + 1), vue,
                (coul, i, j) -> couleur = i == x && j == y ? coul : couleur);
    }

    /** La couleur d'un point de l'écran, noté si ce pixel peut l'utiliser. */
    private Couleur voir(double xe, double ye) {
        equipe.obeir();
        Couleur vue = lancer.getCouleurPixel(xe, ye, profondeur);
        // au plus un demi-pixel au-delà, le point d'un pixel voisin peut être partagé
        if (couleur == null && xe >= x && xe < x + 1.5 && ye >= y && ye < y + 1.5) {
            echantillons.put(new Point(xe, ye, 0), vue);
        }
        return vue;
    }

    private void expliquer() {
        if (!echantillons.isEmpty()) {
            Point centre = new Point(x + 0.5, y + 0.5, 0);
            choisi = Collections.min(echantillons.keySet(), Comparator.comparingDouble(p -> p.sub(centre).norme()));
            suivre(choisi.x, choisi.y);
            if (echec == null) {
                autre = Segment.retrancher(echantillons.get(choisi), segments.get(0).vue);
            }
        }
    }

    /** Dit si cet échantillon est dans un pixel voisin, qui le partage. */
    boolean estPartage(Point echantillon) {
        return echantillon.x >= x + 1 || echantillon.y >= y + 1;
    }

    /** Suit le rayon de ce point de réflexion en réflexion, puis calcule les couleurs, de la dernière à la première. */
    private void suivre(double xe, double ye) {
        Scene preparee = lancer.getScene();
        essayer(() -> {
            for (Segment segment = new Segment(1, camera.getRayon(xe, ye), null, profondeur, preparee); segment != null;
                    segment = segment.reflechir(preparee)) {
                segments.add(segment);
                segment.eclairer(preparee);
            }
        });
        for (int k = segments.size() - 1; k >= 0; k--) {
            Segment segment = segments.get(k);
            essayer(() -> segment.sommer(preparee));
        }
    }

    /** Exécute ce calcul ; s'il échoue, note son échec, et le récit dit ce qui le précède. */
    private void essayer(Runnable calcul) {
        try {
            calcul.run();
        } catch (CancellationException | OutOfMemoryError e) {
            throw e;
        } catch (RuntimeException | Error e) {
            echec = echec == null ? e : echec;
        }
    }

    /** Échec du calcul de ce pixel ; {@code null} s'il a une couleur. */
    public PixelFautif getFaute() {
        return faute;
    }

    public Couleur getCouleur() {
        return couleur;
    }

    /** Le rayon initial, puis les rayons réfléchis, jusqu'au dernier ou jusqu'à l'échec. */
    public List<Segment> getSegments() {
        return segments;
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
}
