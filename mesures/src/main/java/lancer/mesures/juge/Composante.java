package lancer.mesures.juge;

import lancer.Couleur;

/** Une composante des couleurs, dans l'ordre des images. */
enum Composante {

    ROUGE, VERTE, BLEUE;

    double de(Couleur c) {
        return this == ROUGE ? c.r : this == VERTE ? c.v : c.b;
    }
}
