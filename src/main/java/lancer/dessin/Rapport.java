package lancer.dessin;

import java.io.PrintStream;
import java.util.Locale;
import lancer.auto.Echelle;
import lancer.auto.Mesure;
import lancer.commande.Messages;
import lancer.commande.Option;
import lancer.contrat.Compteurs;

/** Ce qui est dit d'un dessin achevé : statistiques demandées, réglages que {@code --auto} a choisis, écart. */
public final class Rapport {

    private static final double NS_PAR_MS = 1e6;
    private static final double NS_PAR_S = 1e9;

    private Rapport() {
    }

    public static void dire(Dessin dessin, PrintStream sortie, PrintStream erreur) {
        if (dessin.demande.reglages.get(Option.STATISTIQUES)) {
            Messages.repondre(getStatistiques(dessin), sortie);
        }
        if (dessin.auto != null) {
            Mesure mesure = dessin.auto.getMesure();
            Messages.avertir("auto, choisi : " + Echelle.dire(dessin.auto.getChoisi()), erreur);
            Messages.avertir("auto, mesuré : " + mesure.enMots() + (!mesure.aUnIntervalle ? ""
                    : " ; " + dessin.auto.getVerdict()), erreur);
        }
        if (dessin.ecart != null) {
            Messages.avertir(dessin.ecart, erreur);
        }
    }

    /**
     * Texte de {@code --statistiques} : compteurs d'un dessin, temps, choix de {@code --auto}. Les nombres ont un point
     * décimal, sans séparateur de milliers ni exposant, quelle que soit la langue de la machine.
     */
    private static String getStatistiques(Dessin dessin) {
        Compteurs c = dessin.dernier.getAtelier().getCompteurs();
        double traceNs = new Durees(dessin.tracesNs).getMediane();
        String texte = String.format(Locale.ROOT, "rayons.primaires: %d\nrayons.ombre: %d\nrayons.reflechis: %d\n"
                + "tests.spheres: %d\nnoeuds.visites: %d\npixels.raffines: %d\n"
                + "lecture.ms: %.3f\npreparation.ms: %.3f\ntrace.ms: %.3f\nrayons.par.seconde: %d",
                c.primaires, c.ombre, c.reflechis, c.testsSpheres, c.noeudsVisites,
                c.pixelsRaffines, dessin.demande.lue.getDureeNs() / NS_PAR_MS, dessin.preparationNs / NS_PAR_MS,
                traceNs / NS_PAR_MS, Math.round(c.rayons() / (Math.max(traceNs, 1) / NS_PAR_S)));
        if (dessin.auto == null) {
            return texte;
        }
        Mesure mesure = dessin.auto.getMesure();
        String incertitude = !mesure.aUnIntervalle ? ""
                : String.format(Locale.ROOT, "auto.erreur.incertitude: %.2f%n", mesure.incertitude);
        return texte + String.format(Locale.ROOT, "%nauto.erreur.mesuree: %.2f%n%sauto.rayons.essais: %d",
                mesure.erreur, incertitude, dessin.auto.getRayonsDesEssais());
    }
}
