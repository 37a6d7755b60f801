package lancer.contrat;

/** À qui un long travail dit où il en est. */
public interface Suivi {

    /** Personne ne regarde ; une classe, car la première lambda d'un programme coûte cher à son démarrage. */
    Suivi AUCUN = new Suivi() {
        @Override
        public void fait(double part) {
            // rien à dire
        }
    };

    /** @param part ce qui est fait, de 0 à 1 */
    void fait(double part);
}
