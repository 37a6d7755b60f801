package lancer.mesures.vitesse;

import java.io.IOException;

/** De quoi prendre un temps, autant de fois qu'on veut. */
interface Echantillon {

    /** D'un dessin, en nanosecondes : réel, et des processeurs (NaN si l'on n'en sait rien). */
    double[] prendre() throws IOException;
}
