package lancer.mesures.stabilite;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import lancer.atelier.FichierCsv;
import lancer.mesures.Intervalle;

/** Ce que valent les réponses d'une méthode, sur tant d'essais : une ligne de stabilite.csv, ou de methodes.csv. */
final class Exactitude {

    private static final String FIN = ",essais,faux,erreur_relative,erreur_unites";
    static final String STABILITE = "figure,methode,x,y" + FIN;

    /** x : nanosecondes par intersection ; y : ce qu'il y a de part et d'autre dans son intervalle. */
    static final String METHODES = "regime,methode,ns,plus_ou_moins" + FIN;

    /** Quelle courbe : voir {@link Mesures}. */
    final String figure;
    final String formule;
    final double x;
    final double y;

    /** Rayons jugés, ou pixels. */
    final int essais;

    /** Ceux dont la réponse n'est pas du bon genre, ou la couleur pas la bonne. */
    final int faux;

    /** La pire des autres, |Δt|/t, puis en unités de κ u t. */
    final double erreurRelative;
    final double erreurEnUnites;

    Exactitude(String figure, String formule, double x, double y, int essais, int faux, double erreurRelative, double erreurEnUnites) {
        this.figure = figure;
        this.formule = formule;
        this.x = x;
        this.y = y;
        this.essais = essais;
        this.faux = faux;
        this.erreurRelative = erreurRelative;
        this.erreurEnUnites = erreurEnUnites;
    }

    /** La part des essais qui sont faux, de 0 à 1. */
    double part() {
        return essais == 0 ? 0 : (double) faux / essais;
    }

    /** En nanosecondes, dans methodes.csv. */
    Intervalle temps() {
        return new Intervalle(x, x - y, x + y);
    }

    /** @param note ce qu'il faut savoir pour comparer, en dernière ligne ; vide s'il n'y en a pas */
    static void ecrire(Path fichier, String enTete, List<Exactitude> exactitudes, String note) throws IOException {
        List<String> lignes = new ArrayList<>();
        lignes.add(enTete);
        exactitudes.forEach(r -> lignes.add(FichierCsv.ligne(r.figure, r.formule, r.x, r.y, r.essais, r.faux, r.erreurRelative,
                r.erreurEnUnites)));
        if (!note.isEmpty()) {
            lignes.add(FichierCsv.NOTE + note);
        }
        Files.write(fichier, lignes);
    }

    /** @throws IOException si le fichier n'est pas de ceux qu'écrit {@link #ecrire} */
    static List<Exactitude> lire(Path fichier, String enTete) throws IOException {
        List<Exactitude> exactitudes = new ArrayList<>();
        for (Map<String, String> champs : FichierCsv.lire(fichier)) {
            if (!String.join(",", champs.keySet()).equals(enTete)) {
                throw new IOException(fichier + " : pas une mesure de stabilité");
            }
            String[] c = champs.values().toArray(new String[0]);
            exactitudes.add(new Exactitude(c[0], c[1], Double.parseDouble(c[2]), Double.parseDouble(c[3]), Integer.parseInt(c[4]),
                    Integer.parseInt(c[5]), Double.parseDouble(c[6]), Double.parseDouble(c[7])));
        }
        return exactitudes;
    }
}
