package lancer.mesures;

import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Locale;

/** Ce que le banc montre : une ligne par scène, dès qu'elle est mesurée. */
final class Tableau {

    private static final String NOM = "%-14s";
    private static final String LIGNE = NOM + " %8s %8s %9s %9s %9s %9s %9s %9s %5s %8s %8s %7s%n";

    private final PrintStream sortie;

    Tableau(PrintStream sortie) {
        this.sortie = sortie;
    }

    void entete(Circonstances c, Reglages r) {
        sortie.println("Le banc d'essai : " + r.largeur + " × " + r.hauteur + ", " + r.fils + (r.fils > 1 ? " fils" : " fil")
                + ", " + Garde.duree(r.dureeNs) + " par scène ; temps en millisecondes, rayons en millions");
        sortie.println(c.machine + ", " + c.coeurs + (c.coeurs > 1 ? " cœurs" : " cœur") + " ; " + c.jvm + " ; " + c.date
                + " ; commit " + c.commit);
        sortie.println();
        ligne("scène", "sphères", "vérifiés", "lecture", "prépar.", "première", "médiane", "1er qu.", "3e qu.", "fois", "rayons",
                "par sec.", "crois.");
    }

    /** @param precedente la mesure de la même famille qui a moins de sphères, {@code null} s'il n'y en a pas */
    void mesure(String nom, Mesure m, Mesure precedente) {
        ligne(nom, m.spheres, m.pixelsVerifies, ms(m.lectureNs), ms(m.preparationNs), ms(m.premiereNs), ms(m.temps.mediane()),
                ms(m.temps.premierQuartile()), ms(m.temps.troisiemeQuartile()), m.temps.nombre(), deuxDecimales(m.rayons() / 1e6),
                deuxDecimales(m.rayonsParSeconde() / 1e6), precedente == null ? "" : deuxDecimales(m.croissance(precedente)));
    }

    void pied(Path csv) {
        sortie.println();
        sortie.println("vérifiés : pixels refaits par les boucles du cours, et identiques au bit près. crois. : le temps a grandi comme");
        sortie.println("(nombre de sphères)^crois. depuis la scène précédente de la famille. Temps notés dans " + csv);
    }

    void sansTemps(String nom, String raison) {
        sortie.println(String.format(NOM, nom) + " " + raison);
        sortie.flush();
    }

    private void ligne(Object... colonnes) {
        sortie.print(String.format(LIGNE, colonnes));
        sortie.flush();
    }

    private static String ms(double ns) {
        return String.format(Locale.ROOT, "%.1f", ns / 1e6);
    }

    private static String deuxDecimales(double valeur) {
        return String.format(Locale.ROOT, "%.2f", valeur);
    }
}
