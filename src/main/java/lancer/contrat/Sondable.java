package lancer.contrat;

import lancer.Camera;
import lancer.Scene;

/** Une recherche dont les réponses se comparent à celles des boucles du cours. */
public interface Sondable {

    /**
     * Compare ses réponses à celles des boucles de cette scène, qu'elle vient de dessiner. Dès qu'une réponse diffère,
     * ce sont les boucles qui dessinent.
     */
    boolean differe(Scene dessinee, Camera camera);
}
