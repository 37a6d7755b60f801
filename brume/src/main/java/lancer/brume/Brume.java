package lancer.brume;

import java.util.Arrays;
import java.util.List;
import lancer.Constantes;
import lancer.Couleur;
import lancer.contrat.Atmosphere;
import lancer.contrat.Modele;
import lancer.contrat.Parametre;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.texte.Texte;

/**
 * Brume de distance (cours, « Extensions ») : couleur finale = k·brume + (1 − k)·couleur de l'objet. Elle s'applique au
 * rayon initial et à chaque rayon réfléchi ; k dépend de la longueur du rayon. Immuable.
 */
public final class Brume implements Variante, Atmosphere {

    private static final Couleur COULEUR = new Couleur(0.8);
    private static final double COULEUR_MAX = 1e6;
    private static final double DEBUT = 0;
    private static final double FIN = 30;

    private final Couleur couleur;
    private final double debut;
    /** Distance au-delà de laquelle seule la brume est visible ; NaN si la brume a une densité. */
    private final double fin;
    private final double densite;

    /** La brume d'une scène sans section {@code [Brume]}. */
    public Brume() {
        this(COULEUR, DEBUT, FIN, 0);
    }

    /**
     * @param debut positif ou nul, plus petit que {@code fin}
     * @param fin NaN pour une brume de densité constante
     * @param densite par unité de la scène, positive ou nulle, finie
     */
    Brume(Couleur couleur, double debut, double fin, double densite) {
        this.couleur = couleur;
        this.debut = debut;
        this.fin = fin;
        this.densite = densite;
    }

    @Override
    public String getSection() {
        return "Brume";
    }

    @Override
    public void installer(Section valeurs, Modele.Construction modele) {
        Couleur sienne = valeurs.couleur("couleur", COULEUR, COULEUR_MAX);
        double de = valeurs.reel("debut", DEBUT, 0, Double.MAX_VALUE);
        boolean repartie = valeurs.contient("densite");
        double dense = valeurs.reel("densite", 0, 0, Double.MAX_VALUE);
        if (repartie && valeurs.contient("fin")) {
            throw valeurs.fautive("densite", "donnée en même temps que fin", "fin ou densite, pas les deux");
        }
        double a = repartie ? Double.NaN : valeurs.reel("fin", FIN, 0, Double.MAX_VALUE);
        if (de >= a) {
            throw valeurs.fautive(valeurs.contient("debut") ? "debut" : "fin", "la brume commencerait à "
                    + Texte.cite(valeurs.mot("debut", "0")) + " et finirait à " + Texte.cite(valeurs.mot("fin", "30")),
                    "debut plus petit que fin (à défaut, 0 et 30)");
        }
        modele.setAtmosphere(new Brume(sienne, de, a, dense));
    }

    @Override
    public List<Parametre> getParametres() {
        return Arrays.asList(Parametre.couleur("couleur", "0.8 0.8 0.8"), Parametre.nombre("debut", DEBUT, 0, 30, 0.5),
                Parametre.nombre("fin", FIN, 1, 100, 1).sans("densite"),
                Parametre.nombre("densite", null, 0, 0.5, 0.005).sans("fin"));
    }

    @Override
    public Couleur traverser(Couleur vue, double distance) {
        double k = k(distance);
        return couleur.mul(k).add(vue.mul(1 - k));
    }

    /**
     * Part de la brume : k = (d − debut) / (fin − debut) ou, pour une densité constante, k = 1 − exp(−densite·(d −
     * debut)) (loi de Beer et Lambert). Un rayon qui ne rencontre rien ne voit que la brume.
     *
     * @param distance longueur du rayon, en unités de la scène
     * @return de 0 (l'objet seul) à 1 (la brume seule), jamais NaN
     */
    @Override
    public double k(double distance) {
        if (distance == Constantes.INFINI) {
            return 1;
        }
        double d = distance - debut;
        // 1 − exp(x) ne dépasse pas 1 si x est négatif ; expm1 reste juste pour une brume très légère
        return Math.max(0, Double.isNaN(fin) ? -Math.expm1(-densite * d) : Math.min(1, d / (fin - debut)));
    }
}
