package lancer.inspection;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.stream.Collectors;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Scene;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/**
 * Un pixel de l'image, dessiné comme le veut l'échantillonnage de la scène, sans les autres ou avec ceux de son pavé
 * s'il leur doit des points ; puis l'un de ses échantillons, de nouveau, en écoutant.
 */
public final class Inspection implements Echantillonnage, Toile {

    /** Le rang que personne n'a choisi. */
    public static final int AU_CENTRE = -1;

    public final Scene scene;
    public final Camera camera;
    public final int profondeur;
    public final int x;
    public final int y;
    private final Echantillonnage entier;
    private final Chaine chaine;
    private final Lancer lancer;
    private Couleur couleur;
    private List<Echantillon> echantillons;
    private Echantillon choisi;
    private int voulu;
    /** Ce que comptent les échantillons, dans l'ordre ; vide si le pixel en est la moyenne. */
    List<Compte> comptes;

    /**
     * @param profondeur nombre de réflexions permises
     * @param x colonne, de 0 à largeur − 1
     * @param y ligne, de 0 (en haut) à hauteur − 1
     */
    public Inspection(Scene scene, Camera camera, int profondeur, int x, int y) {
        this.scene = scene;
        this.camera = camera;
        this.profondeur = profondeur;
        this.x = x;
        this.y = y;
        entier = scene.getEchantillonnage();
        chaine = new Chaine(x, y);
        lancer = new Lancer(scene.avec(this, scene.getSeuil()).ecoutee(chaine), camera);
    }

    /** Explique l'échantillon le plus proche du centre. @throws CancellationException si {@link #arreter} est appelé */
    public void faire() {
        faire(AU_CENTRE);
    }

    /** De même, l'échantillon de ce rang ; {@link #AU_CENTRE} : le plus proche du centre. */
    public void faire(int rang) {
        voulu = rang;
        lancer.TracerPixels(this, profondeur, 1);
    }

    public void arreter() {
        lancer.arreter();
    }

    /** La couleur du pixel. */
    public Couleur getCouleur() {
        return couleur;
    }

    /** Ceux du pixel et ceux qu'il partage, ligne par ligne : dans l'ordre où ils s'ajoutent. */
    public List<Echantillon> getEchantillons() {
        return echantillons;
    }

    /** Celui dont voici la chaîne. */
    public Echantillon getChoisi() {
        return choisi;
    }

    /** Le premier contact, puis ses reflets. */
    public List<Etape> getEtapes() {
        return chaine.etapes;
    }

    /** Par exemple {@code [Sphere ambre] ligne 52}, ou le rang dans la scène s'il n'y a pas de fichier. */
    public String nom(Object chose) {
        String origine = scene.getOrigines().de(chose);
        return origine != null ? origine : chose instanceof Lampe ? "lampe " + (1 + scene.getLampes().indexOf(chose))
                : "objet " + (1 + scene.getObjets().indexOf(chose));
    }

    @Override
    public int tracer(Pave pave, Vue vue, Toile toile) {
        if (!pave.contient(x, y)) {
            return 0;
        }
        chaine.echantillons.clear();
        entier.tracer(pave, new Pave(x, y, x + 1, y + 1), vue, toile);
        echantillons = garder(chaine.echantillons.values());
        if (!echantillons.isEmpty()) {
            choisi = voulu == AU_CENTRE ? Collections.min(echantillons, Comparator.comparingDouble(this::ecart))
                    : echantillons.get(Math.min(voulu, echantillons.size() - 1));
            vue.couleur(choisi.xe, choisi.ye);
            chaine.nommerCaches(scene);
        }
        return 0;
    }

    /** Sans ceux des voisins que ce pixel ne partage pas : seule leur première ligne, ou colonne, le touche. */
    private List<Echantillon> garder(Collection<Echantillon> vus) {
        double droite = vus.stream().mapToDouble(e -> e.xe).filter(xe -> xe >= x + 1).min().orElse(x + 1);
        double bas = vus.stream().mapToDouble(e -> e.ye).filter(ye -> ye >= y + 1).min().orElse(y + 1);
        return vus.stream().filter(e -> e.xe <= droite && e.ye <= bas)
                .sorted(Comparator.<Echantillon>comparingDouble(e -> e.ye).thenComparingDouble(e -> e.xe))
                .collect(Collectors.toList());
    }

    private double ecart(Echantillon e) {
        return Math.hypot(e.xe - x - 0.5, e.ye - y - 0.5);
    }

    @Override
    public void drawPixel(Couleur coul, int i, int j) {
        if (i == x && j == y) {
            couleur = coul;
            comptes = new ArrayList<>(chaine.comptes);
        }
        chaine.comptes.clear();
    }
}
