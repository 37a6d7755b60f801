package lancer.fils;

import java.util.function.IntConsumer;

/** Le travail d'un fil, et où l'on voit, d'un autre, s'il avance. */
public interface Ouvrier extends IntConsumer {

    Calcul getCalcul();
}
