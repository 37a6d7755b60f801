package lancer.fenetre.etat;

/** Ce qu'un état fait faire. Le numéro qu'il porte est rendu avec chaque réponse. */
public interface Ordre {

    /** @param moteur celui qui lit, dessine et écrit @param vue celle qui demande, ou qui copie */
    void executer(Executant moteur, Dialogue vue);
}
