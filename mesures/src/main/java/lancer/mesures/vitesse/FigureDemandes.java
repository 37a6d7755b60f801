package lancer.mesures.vitesse;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import lancer.mesures.trace.FormeDePoint;
import lancer.mesures.trace.Marque;
import lancer.mesures.trace.Planche;
import lancer.mesures.trace.Serie;
import lancer.mesures.trace.Style;
import lancer.mesures.trace.Volet;

/** Ce que coûte chaque chose qu'une scène peut demander, comparée à la même scène qui ne la demande pas. */
final class FigureDemandes {

    private final List<Releve> demandes;
    private final Releve base;
    private final String note;

    FigureDemandes(Releves releves, String note) {
        Releves siens = releves.de(Famille.DEMANDES);
        base = siens.le(Catalogue.TELLE_QUELLE, "");
        demandes = siens.get().stream().filter(r -> r != base).sorted(Comparator.comparingDouble(Releve::rayonsParPixel)
                .thenComparingDouble(Releve::medianeMs)).collect(Collectors.toList());
        this.note = note;
    }

    /** Combien de fois le temps de la scène telle quelle. */
    static double facteur(Releves releves, String methode, String parametres) {
        Releves siens = releves.de(Famille.DEMANDES);
        return siens.le(methode, parametres).medianeMs() / siens.le(Catalogue.TELLE_QUELLE, "").medianeMs();
    }

    Planche planche() {
        List<String> noms = demandes.stream().map(FigureDemandes::nom).collect(Collectors.toList());
        Volet rangees = Volet.rangees("1 : " + Noms.scene(base.scene).toLowerCase(Locale.FRENCH) + ", telle quelle : "
                + Style.nombre(base.rayonsParPixel()) + " rayons par pixel, " + Style.nombre(base.medianeMs()) + " ms",
                "fois autant que la scène telle quelle", noms, 1);
        List<Marque> rayons = new ArrayList<>();
        List<Marque> tests = new ArrayList<>();
        List<Marque> temps = new ArrayList<>();
        for (int k = 0; k < demandes.size(); k++) {
            Releve r = demandes.get(k);
            rayons.add(Marque.en(r.rayonsParPixel() / base.rayonsParPixel(), k));
            tests.add(Marque.en(r.nombre("tests") / base.nombre("tests"), k));
            temps.add(Marque.en(r.medianeMs() / base.medianeMs(), k)
                    .entreX(r.nombre("q1_ms") / base.medianeMs(), r.nombre("q3_ms") / base.medianeMs())
                    .nommee("× " + Style.nombre(r.medianeMs() / base.medianeMs())));
        }
        rangees.serie(new Serie("rayons, comptés", Style.BLEU, FormeDePoint.CARRE, false, rayons));
        rangees.serie(new Serie("sphères essayées, comptées", Style.ORANGE, FormeDePoint.TRIANGLE, false, tests));
        rangees.serie(new Serie("temps (barre : la moitié centrale des dessins)", Style.VERMILLON, FormeDePoint.ROND, false, temps));
        return new Planche(titre(), note).volet(rangees, 1);
    }

    private String titre() {
        Releve cher = demandes.stream().max(Comparator.comparingDouble(Releve::medianeMs)).orElse(base);
        Releve lampe = demandes.stream().filter(r -> r.methode.equals("lampe") && r.parametres.contains("plus")).findFirst().orElse(base);
        return "Une lampe de plus : " + pourCent(lampe.medianeMs() / base.medianeMs()) + " de temps ; " + nom(cher) + " : "
                + Style.arrondi(cher.medianeMs() / base.medianeMs()) + " fois le temps";
    }

    /** « + 12 % ». */
    static String pourCent(double facteur) {
        return (facteur < 1 ? "\u2212" : "+") + "\u00A0" + Style.arrondi(Math.abs(100 * (facteur - 1))) + " %";
    }

    private static String nom(Releve r) {
        for (String[] nom : NOMS) {
            if (nom[0].equals(r.methode + " " + r.parametres)) {
                return nom[1];
            }
        }
        throw new IllegalArgumentException(r.cle());
    }

    private static final List<String[]> NOMS = Arrays.asList(
            new String[] {"lampe une de moins", "une lampe de moins"},
            new String[] {"lampe une de plus", "une lampe de plus"},
            new String[] {"reflets aucun", "aucun reflet"},
            new String[] {"reflets un seul", "un seul reflet"},
            new String[] {"brume ", "la brume"},
            new String[] {"blinn ", "Blinn pour Phong"},
            new String[] {"antialias partage n=4 seuil=0.1", "anticrénelage « partage » (4 ; 0,1)"},
            new String[] {"antialias coins n=3 seuil=0.05", "anticrénelage « coins » (3 ; 0,05)"},
            new String[] {"grille complète 3 × 3", "anticrénelage complet 3 × 3"});
}
