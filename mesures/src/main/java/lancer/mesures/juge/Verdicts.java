package lancer.mesures.juge;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.StringJoiner;

/** Les verdicts, montrés dès qu'ils sont rendus, puis notés : le fichier ne dépend ni du jour ni de la vitesse de la machine. */
final class Verdicts {

    private static final String LIGNE = "%-12s %8s %8s %8s %8s %8s %9s %9s  %s";
    private static final String COLONNES = "juge,largeur,hauteur,scene,spheres,reflets,seuil,dessins,au_dela_pas_8,au_dela_pas_16,"
            + "pire_pas_8,moyen_pas_8";

    private final PrintStream sortie;
    private final String juge;
    private final int largeur;
    private final int hauteur;
    private final List<String> csv = new ArrayList<>();
    private int inexpliques;

    Verdicts(PrintStream sortie, String juge, int largeur, int hauteur) {
        this.sortie = sortie;
        this.juge = juge;
        this.largeur = largeur;
        this.hauteur = hauteur;
        StringBuilder colonnes = new StringBuilder(COLONNES);
        for (Cause cause : Cause.values()) {
            colonnes.append(',').append(cause.name().toLowerCase(Locale.ROOT));
        }
        csv.add(colonnes.append(",rayon_voisin_px").toString());
        sortie.println("Le juge est " + juge + " ; " + largeur + " × " + hauteur + " ; écarts en pas de 8 bits (1/255)");
        sortie.println();
        sortie.println(String.format(LIGNE, "scène", "sphères", "reflets", "dessins", "> 1 pas", "> 1/257", "pire", "moyen",
                "explication"));
    }

    void ajouter(Affaire affaire, Jugement j) {
        sortie.println(String.format(Locale.ROOT, LIGNE, affaire.nom, j.spheres, affaire.reflets, j.dessins, j.accord.auDela8,
                j.accord.auDela16.size(), ecart(j.accord.pire), ecart(j.accord.moyen), explication(j)));
        if (j.inexplique != null) {
            sortie.println("    " + j.inexplique);
        }
        inexpliques += j.nombre(Cause.INEXPLIQUE);
        StringJoiner ligne = new StringJoiner(",");
        ligne.add(juge).add("" + largeur).add("" + hauteur).add(affaire.nom).add("" + j.spheres).add("" + affaire.reflets)
                .add("" + j.seuil).add("" + j.dessins).add("" + j.accord.auDela8).add("" + j.accord.auDela16.size())
                .add(ecart(j.accord.pire)).add(ecart(j.accord.moyen));
        for (Cause cause : Cause.values()) {
            ligne.add("" + j.nombre(cause));
        }
        csv.add(ligne.add(distance(j.voisin)).toString());
    }

    void sauter(Affaire affaire, String raison) {
        sortie.println(String.format("%-12s %8s", affaire.nom, "") + " non jugée : " + raison);
    }

    void conclure() {
        sortie.println();
        sortie.println("dessins : 3 si un Ks est coloré, un par composante, car l'éclat d'une lampe est pour POV-Ray d'une seule");
        sortie.println("couleur ; le seuil est alors 0 des deux côtés. > 1 pas, > 1/257 : pixels qui s'écartent de plus d'un pas de");
        sortie.println("8 bits, de 16 bits ; chacun est expliqué si un rayon voisin du nôtre, à la distance dite, en pixels, voit la");
        sortie.println("couleur du juge.");
        if (inexpliques > 0) {
            sortie.println("PIXELS INEXPLIQUÉS : " + inexpliques);
        }
    }

    private static String explication(Jugement j) {
        if (j.causes.isEmpty()) {
            return "rien à expliquer";
        }
        StringJoiner texte = new StringJoiner(", ");
        j.causes.forEach((cause, n) -> texte.add(cause.nom + " " + n));
        return j.voisin > 0 ? texte + " ; rayon voisin à " + distance(j.voisin) + " au plus" : texte.toString();
    }

    private static String ecart(double pas) {
        return String.format(Locale.ROOT, "%.4f", pas);
    }

    private static String distance(double pixels) {
        return pixels == 0 ? "0" : String.format(Locale.ROOT, "%.0e", pixels);
    }

    boolean toutEstExplique() {
        return inexpliques == 0;
    }

    void noter(Path fichier) throws IOException {
        Path dossier = fichier.toAbsolutePath().getParent();
        Files.createDirectories(dossier);
        Files.write(fichier, csv, StandardCharsets.UTF_8);
    }
}
