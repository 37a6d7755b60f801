package lancer.mesures.stabilite;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import lancer.Constantes;

/**
 * Chronométrage d'une méthode, seule dans sa machine virtuelle, sur les rayons d'un régime. Comme dans une recherche, la plus petite de
 * huit distances est gardée.
 */
public final class Noyau {

    /** Nombre de distances que calcule un passage. */
    public static final int DISTANCES = 5_120_000;

    /** Nombre de rayons d'un tour ; leurs nombres tiennent dans le premier niveau de cache. */
    static final int RAYONS = 256;

    /** Nombre de distances dont la plus petite est gardée. */
    static final int ENSEMBLE = 8;

    /** Nombre de passages qui ne sont pas mesurés, puis de ceux qui le sont. */
    private static final int ECHAUFFEMENT = 10;
    private static final int PASSAGES = 20;

    private static final int VERIFIES = 128;

    /** Erreur relative qu'aucune méthode n'atteint en général loin de la tangente. */
    private static final double PERMISE = 1e-3;

    private final Formule formule;
    private final double[] cas = new double[Formule.NOMBRES * RAYONS];

    /** Somme des distances gardées. Sans elle, la machine virtuelle pourrait supprimer le calcul. */
    private double somme;

    Noyau(Formule formule, Regime regime) {
        this.formule = formule;
        verifier(formule, Regime.ORDINAIRE);
        List<Cas> tires = regime.tirer(RAYONS + RAYONS / 2);
        for (int k = 0; k < RAYONS; k++) {
            System.arraycopy(tires.get(k).nombres, 0, cas, Formule.NOMBRES * k, Formule.NOMBRES);
        }
    }

    /** @throws IllegalStateException si la méthode donne des réponses fausses : son temps n'aurait pas de sens */
    static void verifier(Formule formule, Regime regime) {
        long faux = regime.tirer(VERIFIES).stream().filter(c -> c.malClasse(formule) || c.erreurRelative(formule) > PERMISE).count();
        if (faux > VERIFIES / 100) {
            throw new IllegalStateException(formule + " se trompe sur " + faux + " rayons sur " + VERIFIES + " : aucun temps");
        }
    }

    /** Écrit la durée d'un passage et son temps de processeur, en nanosecondes. @param args le régime des rayons, puis la méthode */
    public static void main(String[] args) {
        Noyau noyau = new Noyau(Formule.valueOf(args[1]), Regime.valueOf(args[0]));
        for (int k = 0; k < ECHAUFFEMENT; k++) {
            noyau.faire();
        }
        OperatingSystemMXBean systeme = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
        long processeur = systeme.getProcessCpuTime();
        long debut = System.nanoTime();
        for (int k = 0; k < PASSAGES; k++) {
            noyau.faire();
        }
        long duree = System.nanoTime() - debut;
        System.out.println(duree / PASSAGES + " " + (systeme.getProcessCpuTime() - processeur) / PASSAGES);
    }

    private void faire() {
        for (int k = 0; k < DISTANCES / RAYONS; k++) {
            somme += tour();
        }
    }

    /** La somme des plus petites distances, {@value #ENSEMBLE} par {@value #ENSEMBLE}. */
    double tour() {
        double plusPetites = 0;
        for (int ensemble = 0; ensemble < cas.length; ensemble += Formule.NOMBRES * ENSEMBLE) {
            double distance = Constantes.INFINI;
            for (int k = ensemble; k < ensemble + Formule.NOMBRES * ENSEMBLE; k += Formule.NOMBRES) {
                double d = formule.distance(cas, k);
                distance = d < distance ? d : distance;
            }
            plusPetites += distance;
        }
        return plusPetites;
    }
}
