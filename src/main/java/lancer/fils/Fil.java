package lancer.fils;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import lancer.contrat.Recherche;

/**
 * Un fil d'une équipe. Son repère dit ce qu'il a commencé en dernier : un pixel, ou une étape de la lecture ou de la
 * préparation. Les méthodes statiques changent le repère du fil courant ; ailleurs que dans un tel fil, elles n'ont pas
 * d'effet.
 */
public class Fil extends Thread {

    /** Taille de la pile, en octets : mille réflexions sont permises, et chacune demande deux appels. */
    private static final long PILE = 16 << 20;

    /** Nombre d'observations du même repère après lequel il est dit. */
    private static final int PATIENCE = 10;

    /** Repère d'un point (xe, ye) : xe dans les 26 bits de poids faible, puis ye, en 4096es de pixel. */
    private static final int FINESSE = 1 << 12;
    private static final int BITS = 26;
    private static final long LIGNE = (1L << BITS) - 1;
    private static final long AVANCEE = 1L << 2 * BITS;

    /** Les fils vivants qu'une équipe observe, dont celui-ci. */
    final List<Fil> observes;
    private final AtomicLong repere = new AtomicLong();
    /** L'étape commencée en dernier ; {@code null} si c'est un pixel, vide si ce n'est rien. */
    private volatile String etape;
    private long vu;
    private int regards;

    /** @param observes où le noter ; {@code null} : avec le fil qui le crée, dont il continue l'étape */
    Fil(String nom, List<Fil> observes) {
        super(null, null, nom, PILE);
        Fil createur = courant();
        this.observes = observes != null ? observes
                : createur != null ? createur.observes : new CopyOnWriteArrayList<>();
        etape = createur == null ? "" : createur.etape;
        setDaemon(true);
    }

    private static Fil courant() {
        return Thread.currentThread() instanceof Fil ? (Fil) Thread.currentThread() : null;
    }

    /** Note que le fil courant commence cette étape. @param nom vide si ce qu'il commence peut durer */
    public static void commencer(String nom) {
        Fil fil = courant();
        if (fil != null) {
            fil.etape = nom;
            signaler();
        }
    }

    /** Note que le fil courant commence le point (xe, ye) de l'écran. */
    public static void commencer(double xe, double ye) {
        Fil fil = courant();
        if (fil != null) {
            fil.repere.lazySet((long) (ye * FINESSE) << BITS | (long) (xe * FINESSE));
            if (fil.etape != null) {
                fil.etape = null;
            }
        }
    }

    /** Note que l'étape du fil courant avance, après {@link Recherche#obeir()}. */
    public static void avancer() {
        Recherche.obeir();
        signaler();
    }

    static void signaler() {
        Fil fil = courant();
        if (fil != null) {
            fil.repere.lazySet(fil.repere.get() + AVANCEE);
        }
    }

    /** Dit, une fois par repère, s'il a dix secondes ; à appeler une fois par seconde. */
    boolean dure() {
        long ici = repere.get();
        regards = ici == vu ? regards + 1 : 0;
        vu = ici;
        return regards == PATIENCE && !"".equals(etape);
    }

    /** L'étape commencée en dernier ; {@code null} si c'est un pixel. */
    public String getEtape() {
        return etape;
    }

    /** La colonne du pixel commencé en dernier. */
    public int getX() {
        return (int) (repere.get() & LIGNE) / FINESSE;
    }

    /** La ligne du pixel commencé en dernier. */
    public int getY() {
        return (int) (repere.get() >> BITS & LIGNE) / FINESSE;
    }
}
