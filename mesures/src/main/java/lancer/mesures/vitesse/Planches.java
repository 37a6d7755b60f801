package lancer.mesures.vitesse;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import lancer.mesures.Intervalle;
import lancer.mesures.Nombres;
import lancer.mesures.trace.Planche;
import lancer.mesures.trace.Volet;

/** Les courbes de vitesse et de précision. */
final class Planches {

    /** Erreur quadratique moyenne de l'arrondi de l'écran, en niveaux. */
    static final double ARRONDI = 1 / Math.sqrt(12);

    private static final String[] METHODES = {Reglage.GRILLE, Reglage.COINS, Reglage.PARTAGE, Reglage.AUTO};

    private final Resultats tous;

    Planches(Resultats tous) {
        this.tous = tous;
    }

    boolean aDesTemps(String volet) {
        return tous.volet(volet).toutes.stream().anyMatch(m -> m.rapport.valeur > 0);
    }

    /** L'erreur selon le temps de chaque réglage que l'on choisit, sur une scène. */
    private Volet choix(String scene, boolean nommer) {
        Resultats siens = tous.volet(Catalogue.CHOIX).scene(scene).tels(m -> m.rapport.valeur > 0);
        Volet volet = new Volet(nommer ? "Choisir : l'erreur de chaque réglage, et son temps" : scene, "secondes de la commande entière",
                "erreur, en niveaux").repere(1, "1 niveau").repere(ARRONDI, "l'arrondi de l'écran");
        volet.serie("sans option", false, points(siens.methode(Reglage.UN_RAYON.methode), siens.unite(), false));
        for (String methode : METHODES) {
            volet.serie(methode, true, points(siens.methode(methode), siens.unite(), nommer));
        }
        return volet;
    }

    private static List<Volet.Point> points(Resultats mesures, double unite, boolean nommer) {
        return mesures.toutes.stream().map(m -> new Volet.Point(m.rapport.fois(unite), m.erreur,
                nommer && !m.methode.equals(Reglage.AUTO)
                ? m.parametres.replaceFirst("n=(.*) seuil=", "$1/") : "")).collect(Collectors.toList());
    }

    Planche cours() {
        return new Planche(1, 1000).volet(choix(Catalogue.COURS, true));
    }

    /** La même courbe pour chaque scène chronométrée, sur les mêmes axes. */
    Planche scenes() {
        List<Volet> volets = tous.volet(Catalogue.CHOIX).tels(m -> m.rapport.valeur > 0).scenes().stream()
                .map(scene -> choix(scene, false)).collect(Collectors.toList());
        Volet.memesAxes(volets);
        Planche planche = new Planche(2, 700);
        volets.forEach(planche::volet);
        return planche;
    }

    /** L'erreur selon le nombre de réflexions, avec anticrénelage : une ligne par scène. */
    Planche reflets() {
        Resultats siens = tous.volet(Catalogue.REFLETS);
        Volet volet = new Volet("Combien de réflexions ? L'erreur, avec anticrénelage", "--reflets", "erreur, en niveaux").xOrdinaire()
                .repere(1, "1 niveau").repere(ARRONDI, "l'arrondi de l'écran");
        for (String scene : siens.scenes()) {
            volet.serie(scene, true, siens.scene(scene).toutes.stream().sorted(Comparator.comparingDouble(m -> m.x))
                    .map(m -> new Volet.Point(Intervalle.exact(m.x), m.erreur, "")).collect(Collectors.toList()));
        }
        return new Planche(1, 1000).volet(volet);
    }

    /** Le temps selon le nombre de lampes, de pixels, de fils : des droites, et leurs pentes. */
    Planche couts() {
        return new Planche(3, 620).volet(droite(Catalogue.LAMPES, "lampes", "Une lampe"))
                .volet(droite(Catalogue.PIXELS, "millions de pixels", "Un million de pixels")).volet(fils());
    }

    private Volet droite(String nom, String axe, String unite) {
        Resultats siens = tous.volet(nom).tels(m -> m.rapport.valeur > 0);
        double[] droite = droite(siens);
        double max = siens.toutes.stream().mapToDouble(m -> m.x).max().orElse(1);
        return volet(siens, axe, unite + " : " + Nombres.arrondi(droite[1]) + " s").serie("droite", true,
                Arrays.asList(new Volet.Point(0, droite[0]), new Volet.Point(max, droite[0] + max * droite[1])));
    }

    private static Volet volet(Resultats siens, String axe, String titre) {
        return new Volet(titre, axe, "secondes").xOrdinaire().yOrdinaire().serie("mesures", false, siens.toutes.stream()
                .map(m -> new Volet.Point(Intervalle.exact(m.x), m.rapport.fois(siens.unite()), "")).collect(Collectors.toList()));
    }

    private Volet fils() {
        Resultats siens = tous.volet(Catalogue.FILS).tels(m -> m.rapport.valeur > 0);
        double un = siens.toutes.get(0).rapport.valeur;
        double mieux = siens.toutes.stream().mapToDouble(m -> m.rapport.valeur).min().getAsDouble();
        return volet(siens, "fils", "Fils : au mieux ÷ " + Nombres.arrondi(un / mieux));
    }

    /** L'ordonnée à l'origine et la pente de la droite des moindres carrés des temps, en secondes. */
    static double[] droite(Resultats mesures) {
        double unite = mesures.unite();
        double n = mesures.toutes.size();
        double x = mesures.toutes.stream().mapToDouble(m -> m.x).sum() / n;
        double t = mesures.toutes.stream().mapToDouble(m -> m.rapport.valeur * unite).sum() / n;
        double xx = mesures.toutes.stream().mapToDouble(m -> (m.x - x) * (m.x - x)).sum();
        double xt = mesures.toutes.stream().mapToDouble(m -> (m.x - x) * (m.rapport.valeur * unite - t)).sum();
        return new double[] {t - x * xt / xx, xt / xx};
    }

    /** Le temps du programme entier, des boucles du cours et de deux autres programmes, selon le nombre de sphères. */
    Planche spheres() {
        Resultats siens = tous.volet(Catalogue.SPHERES).tels(m -> m.rapport.valeur > 0);
        Volet volet = new Volet("Le temps selon le nombre de sphères", "nombre de sphères", "secondes de la commande entière");
        for (String methode : new String[] {Catalogue.PROGRAMME, Reglage.BOUCLES.methode, Reglage.POVRAY, Reglage.EMBREE}) {
            volet.serie(methode, true, siens.methode(methode).toutes.stream()
                    .map(m -> new Volet.Point(Intervalle.exact(m.x), m.rapport.fois(siens.unite()), "")).collect(Collectors.toList()));
        }
        return new Planche(1, 900).volet(volet);
    }
}
