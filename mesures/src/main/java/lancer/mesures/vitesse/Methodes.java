package lancer.mesures.vitesse;

import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;
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

/** Prix de chaque façon de calculer une distance, et de combien elle se trompe, dans chaque {@link Regime}. */
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

    /** Le temps d'une méthode, celui du manuel valant 1 : un rapport seulement si l'intervalle dit lequel est le plus long. */
    private String cout(Regime regime, Formule methode) {
        Intervalle i = le(regime, methode).rapport();
        return i.nettementSous(Intervalle.exact(1)) || Intervalle.exact(1).nettementSous(i) ? "× " + Style.arrondi(i.valeur)
                : "autant, à l'intervalle près";
    }

    Planche planche() {
        Planche planche = new Planche("Le temps, comparé au manuel : perpendiculaire " + cout(Regime.ORDINAIRE, Formule.PERPENDICULAIRE)
                + " ; programme " + cout(Regime.ORDINAIRE, Formule.PROGRAMME) + ", au-dessus d'un sol "
                + cout(Regime.SOL, Formule.PROGRAMME) + ", dans une recherche " + cout(Regime.SOL, Formule.RECHERCHE),
                "Temps d'une intersection, dans une recherche de la plus petite de huit, tour à tour avec le manuel ; barres : 19 fois sur "
                + "20 ; erreur : la pire de " + Style.nombre(Regime.RAYONS) + " rayons, jugés sans arrondi ; 1 est l'effet d'un "
                + "arrondi de la direction, κ u t = u (1 + r/h) t. En creux : plus d'un rayon sur dix est mal classé, et l'erreur ne dit "
                + "que celle des autres. " + temps.get().get(0).circonstances() + ". make noyaux")
                .colonnes(2).taille(Style.LARGEUR, 1500);
        for (Regime regime : Regime.values()) {
            double programme = bilan.en(regime, Formule.PROGRAMME).erreurEnUnites;
            Volet volet = new Volet(regime.nom, "Le programme : " + Style.nombre(ns(regime, Formule.PROGRAMME).valeur) + " ns, "
                    + Style.arrondi(programme) + (programme < 2 ? " unité" : " unités"),
                    "temps d'une intersection, en ns", "pire erreur de t, en unités de κ u t")
                    .repere(Bilan.PROMESSE, "8, la borne promise");
            for (Formule methode : Formule.values()) {
                Exactitude r = bilan.en(regime, methode);
                Marque m = new Marque(ns(regime, methode), Intervalle.exact(Math.max(0.05, r.erreurEnUnites)));
                m = r.faux > 0 ? m.nommee("faux : " + Style.arrondi(100 * r.part()) + " %") : m;
                volet.serie(new Serie(methode.nom, methode.couleur, methode.forme, false,
                        Collections.singletonList(Bilan.estClasse(r) ? m : m.creuse())));
            }
            planche.volet(volet);
        }
        return planche;
    }

    /** Les nombres que cite la page. */
    Map<String, String> pages() {
        Map<String, String> valeurs = new TreeMap<>();
        for (Formule methode : Formule.values()) {
            for (Regime regime : Regime.values()) {
                valeurs.put("methodes." + methode.cle() + "." + regime.cle(), cout(regime, methode));
            }
        }
        valeurs.put("methodes.rayons", Style.nombre(bilan.en(Regime.ORDINAIRE, Formule.PROGRAMME).essais));
        return valeurs;
    }
}
