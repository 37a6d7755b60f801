package lancer.correction.isolement;

/** Ressources qu'un programme d'étudiant peut prendre, pour chaque chose qu'on lui demande. */
public final class Limites {

    /** Les limites ordinaires. */
    public static final Limites ORDINAIRES = new Limites(5, 5, 256, 60);
    /** La même chose, pour compiler : du code d'un étudiant, mais qui ne s'exécute pas. */
    public static final Limites DE_COMPILATION = new Limites(30, 30, 512, 60);
    /** Nombre de processus. */
    static final int PROCESSUS = 40;
    /** Nombre de fils, tous processus ensemble. */
    static final int FILS = 2000;

    /** Temps de processeur, en secondes, de la machine virtuelle et de tout ce qu'elle a lancé. */
    public final double calcul;
    /** Temps sans rien calculer ni répondre, en secondes : au-delà, il est bloqué. */
    public final double attente;
    /** Mémoire de Java, en mégaoctets. */
    public final int memoire;
    /** Temps de processeur, en secondes, que le correcteur lui-même passe sur un rendu. */
    public final double propre;

    public Limites(double calcul, double attente, int memoire, double propre) {
        this.calcul = calcul;
        this.attente = attente;
        this.memoire = memoire;
        this.propre = propre;
    }
}
