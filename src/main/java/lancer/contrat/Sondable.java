package lancer.contrat;

import lancer.Camera;
import lancer.Scene;

/** Une recherche dont les réponses se comparent à celles des boucles du cours. */
public interface Sondable {

    /** Dit si une réponse diffère de celles des boucles de cette scène, déjà dessinée ; elles la redessinent alors. */
    boolean differe(Scene dessinee, Camera camera);
}
