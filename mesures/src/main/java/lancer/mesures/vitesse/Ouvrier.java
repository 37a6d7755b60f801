package lancer.mesures.vitesse;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import lancer.Constantes;
import lancer.Scene;
import lancer.commande.Pannes;
import lancer.mesures.Circonstances;
import lancer.mesures.Erreur;
import lancer.mesures.ImageFausse;
import lancer.mesures.Verite;

/** Fait un {@link Travail} dans cette machine virtuelle, et note chaque mesure dès qu'elle est finie. */
final class Ouvrier {

    static final String CSV = "vitesse.csv";
    static final String DIFFERENCES = "differences";

    /** Changement d'une composante au-dessous duquel un pixel de la vérité ne double plus : un dixième de pas d'écran. */
    private static final double TOLERANCE = 0.1 / 255;
    private static final int N_RAPIDE = 16;

    private final Travail travail;
    private final boolean court;
    private final Path atelier;
    private final PrintStream sortie;
    private final Journal journal;
    private final Taille taille = Taille.COURBES;
    private final Circonstances circonstances = new Circonstances();

    Ouvrier(Travail travail, boolean court, Path atelier, PrintStream sortie) {
        this.travail = travail;
        this.court = court;
        this.atelier = atelier;
        this.sortie = sortie;
        journal = new Journal(atelier.resolve(CSV));
    }

    /** @param args le rang du travail, « true » si la mesure est rapide, et l'atelier */
    public static void main(String[] args) throws IOException {
        System.setProperty("java.awt.headless", "true");
        PrintStream sortie = new PrintStream(System.out, true, "UTF-8");
        boolean court = Boolean.parseBoolean(args[1]);
        Travail travail = Travail.tous(court).get(Integer.parseInt(args[0]));
        try {
            new Ouvrier(travail, court, Paths.get(args[2]), sortie).faire();
        } catch (ImageFausse e) {
            sortie.println("  " + travail.nom() + " : PAS DE TEMPS, image fausse : " + e.getMessage());
            System.exit(1);
        } catch (RuntimeException | OutOfMemoryError e) {
            sortie.println("  " + travail.nom() + " : " + Pannes.message(e));
            System.exit(1);
        }
    }

    /** Mesure ce qui ne l'est pas encore. */
    void faire() throws IOException {
        Set<String> faites = journal.clesFaites();
        Scene scene = travail.lire();
        Verite verite = verite(scene, faites);
        Mesureur mesureur = new Mesureur(taille, court);
        for (List<Methode> groupe : travail.groupes) {
            List<Methode> reste = groupe.stream().filter(m -> !faites.contains(travail.scene + "/" + m.cle()))
                    .collect(Collectors.toList());
            for (Mesureur.Mesure mesure : mesureur.mesurer(scene, reste)) {
                noter(mesure, verite, scene.getObjets().size());
            }
        }
    }

    private void noter(Mesureur.Mesure mesure, Verite verite, int spheres) throws IOException {
        Erreur erreur = verite == null ? null : Erreur.entre(mesure.image, verite.image);
        if (verite != null) {
            FigureDifferences.noter(atelier.resolve(DIFFERENCES), travail.scene, mesure.methode, mesure.image, verite.image);
        }
        journal.ajouter(Releve.ligne(circonstances, taille, travail.scene, spheres, mesure.methode, mesure.compteurs,
                mesure.verifies, mesure.temps(), erreur));
        sortie.println(String.format(Locale.ROOT, "  %-12s %-18s %-18s %8.2f rayons/pixel %10.3f ms%s", travail.scene,
                mesure.methode.nom, mesure.methode.parametres, (double) mesure.compteurs.rayons() / taille.pixels(),
                mesure.temps().mediane() / 1e6, erreur == null ? "" : String.format(Locale.ROOT, "   erreur %.4f pas", 255 * erreur.rmse)));
    }

    /** Ce à quoi se comparent les méthodes de ce travail, notée elle aussi ; {@code null} si elles n'ont pas d'erreur. */
    private Verite verite(Scene scene, Set<String> faites) throws IOException {
        boolean reflets = travail.famille == Famille.REFLETS;
        if (!reflets && travail.famille != Famille.ECHANTILLONNAGE) {
            return null;
        }
        Verite verite = reflets ? Verite.sansLimite(scene, taille.largeur, taille.hauteur)
                : Verite.desPixels(scene, taille.largeur, taille.hauteur, Constantes.MAX_REFLETS, Constantes.SEUIL, TOLERANCE,
                        court ? N_RAPIDE : Verite.N_MAX);
        String nom = reflets ? "sans limite" : "moyenne";
        String parametres = reflets ? "p=" + verite.effort + " seuil=0" : "n=" + verite.effort;
        if (!reflets) {
            FigureDifferences.noterLaVerite(atelier.resolve(DIFFERENCES), travail.scene, verite.image);
        }
        if (!faites.contains(travail.scene + "/" + Famille.VERITE.nom() + "/" + nom + "/" + parametres)) {
            journal.ajouter(Releve.ligneDeVerite(circonstances, taille, travail.scene, scene.getObjets().size(), nom, parametres,
                    verite.compteurs, verite.reste));
        }
        sortie.println(String.format(Locale.ROOT, "  %-12s vérité, %s, %s : à %.3g pas près, %.0f rayons de l'écran par pixel",
                travail.scene, nom, parametres, 255 * verite.reste, (double) verite.compteurs.primaires / taille.pixels()));
        return verite;
    }
}
