package lancer.correction.isolement;

/** Ressources qu'une machine virtuelle peut utiliser pour chaque demande. */
public final class Limites {

    public static final Limites ORDINAIRES = new Limites(5, 5, 256);
    /** Limites pour compiler le code d'un étudiant, qui n'est pas exécuté. */
    public static final Limites DE_COMPILATION = new Limites(30, 30, 512);
    /** Nombre maximal de fils. */
    static final int FILS = 2000;
    /** Sans confinement, la seule limite est une durée, en fois celle du calcul permis. */
    static final double SANS_CONFINEMENT = 4;

    /** Temps de processeur, en secondes. */
    public final double calcul;
    /** Temps sans calcul ni réponse, en secondes, au-delà duquel le programme est bloqué. */
    public final double attente;
    /** Mémoire de Java, en mégaoctets. */
    public final int memoire;

    public Limites(double calcul, double attente, int memoire) {
        this.calcul = calcul;
        this.attente = attente;
        this.memoire = memoire;
    }
}
