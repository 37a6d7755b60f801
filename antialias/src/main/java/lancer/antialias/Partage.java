package lancer.antialias;

import java.util.List;
import lancer.Camera;
import lancer.Objet3D;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/**
 * Une méthode plus sobre que celle du cours, sur les mêmes n × n sous-pixels : un seul par pixel d'abord, que ses
 * voisins partagent. Entre quatre sous-pixels vus, une case où tout se ressemble est interpolée ; sinon elle est coupée
 * en quatre, et ainsi de suite, jusqu'à ce que contraste × côté ne dépasse plus le seuil ou qu'il n'y ait plus rien
 * entre les coins. Une case où est une boule assez petite pour passer entre les coins est coupée aussi. Un bord ne
 * coûte ainsi que les cases qu'il traverse, de l'ordre de n rayons par pixel au lieu de n². Immuable.
 */
final class Partage implements Echantillonnage {

    private final int n;
    private final double seuil;
    /** Les boules à ne pas manquer ; {@code null} tant qu'on ne sait pas où elles sont. */
    private final Petites petites;

    /**
     * @param n nombre de sous-pixels sur un côté
     * @param seuil de contraste, pour une case d'un pixel de côté ; 0 : tous les sous-pixels, toujours
     */
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
        return n == 1 || seuil == 0 ? this : new Partage(n, seuil, new Petites(objets, camera));
    }

    /** @return le nombre de pixels où une case a été coupée */
    @Override
    public int tracer(Pave pave, Pave voulus, Vue vue, Toile toile) {
        // un sous-pixel, ou tous : il n'y a rien à partager
        return n == 1 || seuil == 0 ? new Coins(n, 0).tracer(pave, voulus, vue, toile)
                : new Cases(n, seuil, petites, pave, vue).tracer(voulus, toile);
    }
}
