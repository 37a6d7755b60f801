package lancer.mesures;

import java.util.Arrays;

/**
 * Ce qu'a donné la mesure d'une scène : des temps si l'image est juste, sinon la raison de leur absence. Tient en une ligne de
 * texte, pour passer d'une machine virtuelle à une autre.
 */
final class Mesure {

    /** Pourquoi il y a des temps, ou pas. */
    enum Issue { MESUREE, SAUTEE, FAUTIVE }

    private static final int ENTETE = 8;

    final Issue issue;

    /** Une phrase, vide si la scène est mesurée. */
    final String raison;

    final long spheres;

    /** Rayons d'une image. */
    final long primaires;
    final long ombre;
    final long reflechis;

    /** Pixels que le chemin lisible a refaits. */
    final long pixelsVerifies;

    /** En nanosecondes, dans une machine virtuelle qui vient de démarrer. */
    final long lectureNs;
    final long preparationNs;
    final long premiereNs;

    /** Un dessin après l'autre, une fois le code compilé. */
    final Repartition temps;

    private final long[] nombres;

    private Mesure(Issue issue, String raison, long[] nombres) {
        this.issue = issue;
        this.raison = raison;
        this.nombres = nombres;
        boolean la = issue == Issue.MESUREE;
        spheres = la ? nombres[0] : 0;
        primaires = la ? nombres[1] : 0;
        ombre = la ? nombres[2] : 0;
        reflechis = la ? nombres[3] : 0;
        pixelsVerifies = la ? nombres[4] : 0;
        lectureNs = la ? nombres[5] : 0;
        preparationNs = la ? nombres[6] : 0;
        premiereNs = la ? nombres[7] : 0;
        temps = la ? new Repartition(Arrays.copyOfRange(nombres, ENTETE, nombres.length)) : null;
    }

    /**
     * @param entete sphères, rayons primaires, d'ombre et réfléchis, pixels vérifiés, temps de lecture, de préparation et du
     *     premier dessin
     * @param temps des dessins suivants, au moins un
     */
    static Mesure faite(long[] entete, long... temps) {
        if (entete.length != ENTETE) {
            throw new IllegalArgumentException(entete.length + " nombres, au lieu de " + ENTETE);
        }
        long[] nombres = Arrays.copyOf(entete, ENTETE + temps.length);
        System.arraycopy(temps, 0, nombres, ENTETE, temps.length);
        return new Mesure(Issue.MESUREE, "", nombres);
    }

    /** La scène est trop chère pour le temps donné. */
    static Mesure sautee(String raison) {
        return new Mesure(Issue.SAUTEE, raison, new long[0]);
    }

    /** L'image est fausse, ou n'a pu être dessinée : il n'y a pas de temps. */
    static Mesure fautive(String raison) {
        return new Mesure(Issue.FAUTIVE, raison, new long[0]);
    }

    /** L'inverse de {@link #toString()} ; une ligne qui n'en vient pas est une faute de plus. */
    static Mesure lire(String ligne) {
        String[] mots = ligne.split(" ");
        if (mots[0].equals(Issue.MESUREE.name()) && mots.length > 1 + ENTETE) {
            try {
                long[] nombres = Arrays.stream(mots).skip(1).mapToLong(Long::parseLong).toArray();
                return new Mesure(Issue.MESUREE, "", nombres);
            } catch (NumberFormatException e) {
                return fautive("mesure illisible : " + ligne);
            }
        }
        String reste = ligne.substring(Math.min(ligne.length(), mots[0].length() + 1));
        return mots[0].equals(Issue.SAUTEE.name()) ? sautee(reste)
                : fautive(mots[0].equals(Issue.FAUTIVE.name()) ? reste : "mesure illisible : " + ligne);
    }

    @Override
    public String toString() {
        StringBuilder s = new StringBuilder(issue.name());
        for (long nombre : nombres) {
            s.append(' ').append(nombre);
        }
        return raison.isEmpty() ? s.toString() : s.append(' ').append(raison).toString();
    }

    long rayons() {
        return primaires + ombre + reflechis;
    }

    double rayonsParSeconde() {
        return rayons() / (temps.mediane() / 1e9);
    }

    /**
     * L'exposant e tel que le temps a grandi comme (nombre de sphères)^e depuis cette autre mesure : 1 pour les boucles du
     * cours, près de 0 pour une bonne recherche.
     */
    double croissance(Mesure precedente) {
        return Math.log(temps.mediane() / precedente.temps.mediane()) / Math.log((double) spheres / precedente.spheres);
    }
}
