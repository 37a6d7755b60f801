package lancer.mesures.vitesse;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import lancer.contrat.Compteurs;
import lancer.mesures.Circonstances;
import lancer.mesures.Erreur;
import lancer.mesures.FichierCsv;
import lancer.mesures.Repartition;

/** Ce qu'a donné une méthode sur une scène : une ligne du CSV. Un nombre qui manque y est vide, et ici NaN. */
final class Releve {

    static final List<String> COLONNES = Arrays.asList("machine", "coeurs", "jvm", "date", "commit", "largeur", "hauteur", "fils",
            "scene", "spheres", "famille", "methode", "parametres", "primaires", "ombre", "reflechis", "tests", "noeuds", "raffines",
            "pixels_verifies", "repetitions", "mediane_ms", "q1_ms", "q3_ms", "min_ms", "max_ms", "rmse", "max", "ssim", "pas",
            "pixels_differents");

    private static final double NS_PAR_MS = 1e6;

    final String scene;
    final String famille;
    final String methode;
    final String parametres;
    private final Map<String, String> champs;

    /** @param champs par nom de colonne */
    Releve(Map<String, String> champs) {
        this.champs = champs;
        scene = texte("scene");
        famille = texte("famille");
        methode = texte("methode");
        parametres = texte("parametres");
    }

    /** @param erreur {@code null} si rien n'est à comparer */
    static String ligne(Circonstances c, Taille t, String scene, int spheres, Methode m, Compteurs n, int verifies,
            Repartition temps, Erreur erreur) {
        return FichierCsv.ligne(c.machine, c.coeurs, c.jvm, c.date, c.commit, t.largeur, t.hauteur, t.fils, scene, spheres,
                m.famille.nom(), m.nom, m.parametres, n.primaires, n.ombre, n.reflechis, n.testsSpheres, n.noeudsVisites,
                n.pixelsRaffines, verifies, temps.nombre(), ms(temps.mediane()), ms(temps.premierQuartile()),
                ms(temps.troisiemeQuartile()), ms(temps.min()), ms(temps.max()), erreur == null ? "" : reel(erreur.rmse),
                erreur == null ? "" : reel(erreur.max), erreur == null ? "" : reel(erreur.ssim), erreur == null ? "" : erreur.pas,
                erreur == null ? "" : erreur.pixels);
    }

    /** La ligne d'une vérité : ni temps, ni erreur que son reste. */
    static String ligneDeVerite(Circonstances c, Taille t, String scene, int spheres, String nom, String parametres, Compteurs n,
            double reste) {
        return FichierCsv.ligne(c.machine, c.coeurs, c.jvm, c.date, c.commit, t.largeur, t.hauteur, c.coeurs, scene, spheres,
                Famille.VERITE.nom(), nom, parametres, n.primaires, n.ombre, n.reflechis, n.testsSpheres, n.noeudsVisites,
                n.pixelsRaffines, 0, 0, "", "", "", "", "", reel(reste), "", "", "", "");
    }

    private static String ms(double ns) {
        return String.format(Locale.ROOT, "%.4f", ns / NS_PAR_MS);
    }

    private static String reel(double valeur) {
        return valeur == 0 ? "0" : String.format(Locale.ROOT, "%.6g", valeur);
    }

    /** Ce qui distingue cette ligne de toutes les autres. */
    String cle() {
        return scene + "/" + famille + "/" + methode + "/" + parametres;
    }

    String texte(String colonne) {
        return champs.getOrDefault(colonne, "");
    }

    /** NaN si le champ est vide. */
    double nombre(String colonne) {
        String texte = texte(colonne);
        return texte.isEmpty() ? Double.NaN : Double.parseDouble(texte);
    }

    double pixels() {
        return nombre("largeur") * nombre("hauteur");
    }

    /** De toutes sortes, par pixel de l'image. */
    double rayonsParPixel() {
        return (nombre("primaires") + nombre("ombre") + nombre("reflechis")) / pixels();
    }

    double testsParRayon() {
        return nombre("tests") / (rayonsParPixel() * pixels());
    }

    double medianeMs() {
        return nombre("mediane_ms");
    }

    /** L'écart quadratique moyen, en pas de l'écran. */
    double erreurEnPas() {
        return 255 * nombre("rmse");
    }
}
