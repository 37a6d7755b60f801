package lancer.contrat;

import lancer.Couleur;

/** Ce qu'un fil voit à travers l'écran : d'un point de l'écran à sa couleur. Une vue appartient à un seul fil. */
public interface Vue {

    /**
     * @param xe en pixels depuis la gauche ; le centre du pixel i est i + 0,5
     * @param ye en pixels depuis le haut
     * @return la couleur, non limitée
     */
    Couleur couleur(double xe, double ye);

    /** Les rayons de toutes sortes lancés jusqu'ici par ce fil ; 0 s'ils ne sont pas comptés. */
    default long rayons() {
        return 0;
    }

    /** Dit, à qui écoute, que cette couleur, qu'a rendue {@link #couleur}, compte tant dans le pixel en cours. */
    default void compter(Couleur couleur, double poids) {
    }
}
