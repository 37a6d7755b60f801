package lancer.auto;

import java.util.HashMap;
import java.util.Map;
import lancer.Couleur;
import lancer.Point;
import lancer.contrat.Pave;
import lancer.contrat.Vue;

/** Une vue qui se souvient : les échantillonnages essayés sur un bloc demandent souvent les mêmes points. */
final class Souvenir implements Vue {

    private final Vue vue;
    private final Pave bloc;
    private final Map<Point, Couleur> couleurs = new HashMap<>();
    private int vus;

    Souvenir(Pave bloc, Vue vue) {
        this.bloc = bloc;
        this.vue = vue;
    }

    /** Le nombre de points demandés dans le bloc, depuis la dernière fois qu'on l'a demandé. */
    int vus() {
        int n = vus;
        vus = 0;
        return n;
    }

    @Override
    public Couleur couleur(double xe, double ye) {
        vus += bloc.contient((int) Math.floor(xe), (int) Math.floor(ye)) ? 1 : 0;
        return couleurs.computeIfAbsent(new Point(xe, ye, 0), point -> vue.couleur(point.x, point.y));
    }
}
