package lancer.antialias;

import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Releve;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/**
 * Méthode adaptative sur les mêmes n × n sous-pixels que {@link Coins}, avec moins de rayons. Chaque pixel calcule
 * d'abord un seul sous-pixel, partagé avec ses voisins. Une case, entre quatre sous-pixels calculés, est interpolée si
 * leurs couleurs se ressemblent. Sinon, elle est divisée en quatre, tant que contraste × côté dépasse le seuil et qu'il
 * reste des sous-pixels. Là où trop de points surprennent, toutes les cases du pavé sont divisées. Un bord ne coûte que
 * les cases qu'il traverse : de l'ordre de n rayons par pixel, au lieu de n². Immuable.
 */
final class Partage implements Echantillonnage {

    private final int n;
    private final double seuil;

    /** @param n au moins 2 @param seuil contraste, pour une case d'un pixel de côté ; plus grand que 0 */
    Partage(int n, double seuil) {
        this.n = n;
        this.seuil = seuil;
    }

    /** @return avec le nombre de pixels dont une case a été divisée */
    @Override
    public Releve tracer(Pave pave, Pave voulus, Vue vue, Toile toile) {
        return new Cases(n, seuil, pave, vue).tracer(voulus, toile);
    }
}
