package lancer;

/** Une couleur qui remplace peu à peu celle des objets, selon la distance que parcourt le rayon (cours, « Brume »). */
public class Brume {

    Couleur couleur = new Couleur(0.8, 0.8, 0.8);

    /** La distance où elle commence, et celle où l'on ne voit plus qu'elle, en unités de la scène. */
    double debut;
    double fin = 30;

    /** Ce qui remplace {@code fin} : la part de lumière perdue par unité de la scène ; -1 si c'est {@code fin} qui sert. */
    double densite = -1;

    /** @param debut 0 : partout ; {@link Constantes#INFINI} : pas de brume */
    public Brume(double debut) {
        this.debut = debut;
    }

    /** La couleur que l'on voit de loin : k fois celle de la brume, 1 - k fois celle qui est derrière. */
    public Couleur devant(Couleur derriere, double distance) {
        if (debut == Constantes.INFINI || distance == Constantes.INFINI) {
            return debut == Constantes.INFINI ? derriere : couleur;
        }
        double k = densite < 0 ? (distance - debut) / (fin - debut) : 1 - Math.exp(-densite * (distance - debut));
        k = Math.max(0, Math.min(1, k));
        return couleur.mul(k).add(derriere.mul(1 - k));
    }
}
