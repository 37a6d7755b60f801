package lancer.antialias;

import java.util.List;
import lancer.Camera;
import lancer.Objet3D;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/**
 * Méthode adaptative sur les mêmes n × n sous-pixels que {@link Coins}, avec moins de rayons. Chaque pixel calcule
 * d'abord un seul sous-pixel, partagé avec ses voisins. Une case, entre quatre sous-pixels calculés, est interpolée si
 * leurs couleurs se ressemblent. Sinon, elle est divisée en quatre, tant que contraste × côté dépasse le seuil et qu'il
 * reste des sous-pixels. Une case qui peut contenir une petite sphère est aussi divisée. Un bord ne coûte que les cases
 * qu'il traverse : de l'ordre de n rayons par pixel, au lieu de n². Immuable.
 */
final class Partage implements Echantillonnage {

    private final int n;
    private final double seuil;
    /** Les petites sphères ; {@code null} avant {@link #pour}. */
    private final Petites petites;

    /** @param n au moins 2 @param seuil contraste, pour une case d'un pixel de côté ; plus grand que 0 */
    Partage(int n, double seuil) {
        this(n, seuil, null);
    }

    private Partage(int n, double seuil, Petites petites) {
        this.n = n;
        this.seuil = seuil;
        this.petites = petites;
    }

    @Override
    public Echantillonnage pour(List<Objet3D> objets, Camera camera) {
        return new Partage(n, seuil, new Petites(objets, camera));
    }

    /** @return le nombre de pixels dont une case a été divisée */
    @Override
    public int tracer(Pave pave, Pave voulus, Vue vue, Toile toile) {
        return new Cases(n, seuil, petites, pave, vue).tracer(voulus, toile);
    }
}
