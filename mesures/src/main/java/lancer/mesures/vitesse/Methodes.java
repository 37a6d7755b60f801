package lancer.mesures.vitesse;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.mesures.Intervalle;
import lancer.mesures.stabilite.Bilan;
import lancer.mesures.stabilite.Exactitude;
import lancer.mesures.stabilite.Formule;
import lancer.mesures.stabilite.Noyau;
import lancer.mesures.stabilite.Regime;
import lancer.mesures.trace.Marque;
import lancer.mesures.trace.Planche;
import lancer.mesures.trace.Serie;
import lancer.mesures.trace.Style;
import lancer.mesures.trace.Volet;

/** Temps et erreur de chaque calcul de distance, dans chaque {@link Regime}. */
final class Methodes {

    static final String CSV = "methodes.csv";

    private final Releves temps;
    private final Bilan bilan;

    Methodes(Releves temps, Bilan bilan) {
        this.temps = temps;
        this.bilan = bilan;
    }

    private Releve le(Regime regime, Formule methode) {
        return temps.scene(regime.name()).le(methode.name(), "");
    }

    /** Le temps d'une distance, en nanosecondes. */
    private Intervalle ns(Regime regime, Formule methode) {
        Releve r = le(regime, methode);
        return r.rapport().fois(1e6 * r.nombre("reference_ms") / Noyau.DISTANCES);
    }

    Planche planche() {
        Planche planche = new Planche("Le temps d'une intersection, et son erreur", "Pire erreur de " + Style.nombre(Regime.RAYONS)
                + " rayons, jugés sans arrondi ; 1 est l'effet d'un arrondi de la direction, κ u t = u (1 + r/h) t. En creux : plus d'un "
                + "rayon sur dix est mal classé, et l'erreur ne dit que celle des autres. make noyaux").colonnes(2)
                .taille(Style.LARGEUR, 1500);
        List<Volet> volets = new ArrayList<>();
        for (Regime regime : Regime.values()) {
            Volet volet = new Volet(regime.nom, "temps d'une intersection, en ns", "pire erreur de t, en unités de κ u t")
                    .repere(Bilan.PROMESSE, "8, la borne promise");
            for (Formule methode : Formule.values()) {
                Exactitude r = bilan.en(regime, methode);
                Marque m = new Marque(ns(regime, methode), Intervalle.exact(Math.max(0.05, r.erreurEnUnites)));
                m = r.faux > 0 ? m.nommee("faux : " + Style.arrondi(100 * r.part()) + " %") : m;
                volet.serie(new Serie(methode.nom, methode.couleur, methode.forme, false,
                        Collections.singletonList(Bilan.estClasse(r) ? m : m.creuse())).nommeeAGauche());
            }
            volets.add(volet);
        }
        Volet.memesAxes(volets);
        volets.forEach(planche::volet);
        return planche;
    }

    /** Temps de chaque méthode, rapporté à celui de la méthode des manuels, dans chaque régime. */
    String tableau() {
        return Tableaux.table(Stream.concat(Stream.of("temps, à celui du manuel"), Arrays.stream(Regime.values())
                .map(r -> r.nom.replaceFirst(" ?[:,].*| de rayon.*", ""))).collect(Collectors.toList()), Arrays.stream(Formule.values())
                .filter(f -> f != Formule.MANUEL).map(f -> Stream.concat(Stream.of(f.nom), Arrays.stream(Regime.values())
                .map(r -> Tableaux.rapport(le(r, f).rapport()))).collect(Collectors.toList())).collect(Collectors.toList()))
                + Tableaux.source(temps.get());
    }
}
