package lancer.mesures.stabilite;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import lancer.mesures.Circonstances;
import lancer.mesures.FichierCsv;

/** Exactitude d'une méthode sur un nombre d'essais : une ligne de stabilite.csv. */
public final class Exactitude {

    private static final String COLONNES = "figure,methode,x,essais,faux,erreur_relative,erreur_unites,commit,date";

    /** Nom de la courbe : voir {@link Mesures}. */
    final String figure;
    final String formule;
    final double x;

    /** Nombre de rayons jugés. */
    public final int essais;

    /** Nombre d'essais mal classés ({@link Cas#malClasse}). */
    public final int faux;

    /** La plus grande erreur des autres essais : |Δt|/t, puis en unités de κ u t. */
    final double erreurRelative;
    public final double erreurEnUnites;

    Exactitude(String figure, String formule, double x, int essais, int faux, double erreurRelative, double erreurEnUnites) {
        this.figure = figure;
        this.formule = formule;
        this.x = x;
        this.essais = essais;
        this.faux = faux;
        this.erreurRelative = erreurRelative;
        this.erreurEnUnites = erreurEnUnites;
    }

    /** La part des essais mal classés, de 0 à 1. */
    public double part() {
        return essais == 0 ? 0 : (double) faux / essais;
    }

    static void ecrire(Path fichier, List<Exactitude> exactitudes) throws IOException {
        List<String> lignes = new ArrayList<>();
        lignes.add(COLONNES);
        Circonstances c = new Circonstances();
        exactitudes.forEach(r -> lignes.add(FichierCsv.ligne(r.figure, r.formule, r.x, r.essais, r.faux, r.erreurRelative,
                r.erreurEnUnites, c.commit, c.date)));
        Files.write(fichier, lignes);
    }

    /** @param fichier écrit par {@link #ecrire} */
    static List<Exactitude> lire(Path fichier) throws IOException {
        List<Exactitude> exactitudes = new ArrayList<>();
        for (String[] c : FichierCsv.lire(fichier)) {
            exactitudes.add(new Exactitude(c[0], c[1], Double.parseDouble(c[2]), Integer.parseInt(c[3]), Integer.parseInt(c[4]),
                    Double.parseDouble(c[5]), Double.parseDouble(c[6])));
        }
        return exactitudes;
    }
}
