package lancer.contrat;

import lancer.Couleur;

/** Ce que voit un fil à travers l'écran : d'un point de l'écran à sa couleur. Une vue appartient à un seul fil. */
public interface Vue {

    /** La couleur, non limitée, de ce point, en pixels depuis la gauche et le haut ; le centre du pixel i : i + 0,5. */
    Couleur couleur(double xe, double ye);

    /** Note ces rayons, lancés par ce fil sans passer par cette vue. */
    default void noter(Compteurs compteurs) {
    }

    /** Les rayons de toutes sortes lancés jusqu'ici par ce fil ; 0 s'ils ne sont pas comptés. */
    default long rayons() {
        return 0;
    }

    /** Dit, à qui écoute, un terme du pixel en cours : tant de fois cette couleur, objet même que rend la vue. */
    default void compter(Couleur couleur, double poids, Couleur terme) {
    }

    /** Dit, à qui écoute, que le pixel en cours est cette somme, divisée par ce nombre. */
    default void diviser(Couleur somme, double nombre) {
    }
}
