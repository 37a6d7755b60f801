package lancer.correction.isolement;

/** Ressources qu'un programme d'étudiant peut utiliser pour chaque demande. */
public final class Limites {

    public static final Limites ORDINAIRES = new Limites(5, 5, 256, 60);
    /** Limites pour compiler le code d'un étudiant, qui n'est pas exécuté. */
    public static final Limites DE_COMPILATION = new Limites(30, 30, 512, 60);
    /** Nombre maximal de processus. */
    static final int PROCESSUS = 40;
    /** Nombre maximal de fils, tous processus ensemble. */
    static final int FILS = 2000;

    /** Temps de processeur, en secondes, de la machine virtuelle et de ses descendants. */
    public final double calcul;
    /** Temps sans calcul ni réponse, en secondes, au-delà duquel le programme est bloqué. */
    public final double attente;
    /** Mémoire de Java, en mégaoctets. */
    public final int memoire;
    /** Temps de processeur, en secondes, du correcteur lui-même pour un rendu. */
    public final double propre;

    public Limites(double calcul, double attente, int memoire, double propre) {
        this.calcul = calcul;
        this.attente = attente;
        this.memoire = memoire;
        this.propre = propre;
    }
}
