package lancer.correction.isolement;

/** Ce qu'un programme d'étudiant peut prendre, pour chaque chose qu'on lui demande. */
public final class Limites {

    /** Temps de processeur, en secondes, de la machine virtuelle et de tout ce qu'elle a lancé. */
    public final double calcul;

    /** Temps sans rien calculer ni répondre, en secondes : au-delà, il est bloqué. */
    public final double attente;

    /** Mémoire de Java, en mégaoctets. */
    public final int memoire;

    /** Nombre de processus. */
    public final int processus;

    /** Temps de processeur, en secondes, que le correcteur lui-même passe sur un rendu. */
    public final double propre;

    public Limites(double calcul, double attente, int memoire, int processus) {
        this(calcul, attente, memoire, processus, 60);
    }

    public Limites(double calcul, double attente, int memoire, int processus, double propre) {
        this.propre = propre;
        this.calcul = calcul;
        this.attente = attente;
        this.memoire = memoire;
        this.processus = processus;
    }

    /** Les limites ordinaires. */
    public static Limites ordinaires() {
        return new Limites(5, 5, 256, 40);
    }

    /** La même chose, pour compiler : du code d'un étudiant, mais qui ne s'exécute pas. */
    public static Limites deCompilation() {
        return new Limites(30, 30, 512, 40);
    }

    @Override
    public String toString() {
        return calcul + " " + attente + " " + memoire + " " + processus;
    }
}
