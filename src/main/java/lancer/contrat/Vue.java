package lancer.contrat;

import lancer.Couleur;

/** La fonction qui donne la couleur d'un point de l'écran à un échantillonnage. Une vue appartient à un seul fil. */
public interface Vue {

    /** La couleur, non limitée, du point (xe, ye), en pixels depuis la gauche et le haut ({@link lancer.Camera}). */
    Couleur couleur(double xe, double ye);

    /** Les compteurs de ce fil, où ajouter les rayons qu'il lance sans passer par cette vue. */
    default Compteurs compteurs() {
        return new Compteurs();
    }

    /** Vrai au second regard sur une image, dont le premier a laissé craindre des détails que personne n'a vus. */
    default boolean estSeconde() {
        return false;
    }

    /** Cette vue, au second regard. */
    default Vue seconde() {
        Vue premiere = this;
        return new Vue() {
            @Override
            public Couleur couleur(double xe, double ye) {
                return premiere.couleur(xe, ye);
            }

            @Override
            public Compteurs compteurs() {
                return premiere.compteurs();
            }

            @Override
            public boolean estSeconde() {
                return true;
            }
        };
    }
}
