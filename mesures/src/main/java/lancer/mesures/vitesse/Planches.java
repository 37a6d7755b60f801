package lancer.mesures.vitesse;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.mesures.Nombres;
import lancer.mesures.scenes.Scenes;
import lancer.mesures.trace.Planche;
import lancer.mesures.trace.Volet;

/** Les courbes de vitesse et de précision. */
final class Planches {

    /** Erreur quadratique moyenne de l'arrondi de l'écran, en niveaux. */
    static final double ARRONDI = 1 / Math.sqrt(12);

    private static final String[] METHODES = {Reglage.GRILLE, Reglage.PARTAGE, Reglage.COINS};

    /** Rapport de deux temps, ou de deux erreurs, au-delà duquel les noms de leurs points ne se touchent pas. */
    private static final double LOIN = 1.28;

    private final Resultats tous;

    Planches(Resultats tous) {
        this.tous = tous;
    }

    boolean aDesTemps(String volet) {
        return tous.volet(volet).toutes.stream().anyMatch(m -> m.rapport() > 0);
    }

    /** L'erreur de chaque réglage que l'on choisit, sur une scène, selon les secondes de tous les cœurs. */
    private Volet choix(String scene, boolean grande) {
        Resultats siens = tous.volet(Catalogue.CHOIX).scene(scene).tels(m -> m.rapport() > 0);
        siens.toutes.sort(Comparator.comparingDouble(m -> m.rayons));
        Volet volet = new Volet(scene, grande ? dater("secondes de processeur de la commande entière", siens)
                : "secondes de processeur de la commande entière", "erreur, en niveaux").repere(1, "1 niveau")
                .repereNommeDessous(ARRONDI, grande ? "l'arrondi de l'écran" : "");
        for (String methode : METHODES) {
            volet.serie(methode, true, points(siens.methode(methode), grande));
        }
        return volet.serie("un rayon", false, points(siens.methode(Reglage.UN_RAYON.methode), grande));
    }

    /** Un point par réglage, nommé ; en petit, seulement s'il n'est pas tout près du dernier nommé, dont il cacherait le nom. */
    private static List<Volet.Point> points(Resultats mesures, boolean grande) {
        List<Volet.Point> points = new ArrayList<>();
        Mesure nommee = null;
        for (Mesure m : mesures.toutes) {
            boolean seul = grande || nommee == null || m.processeurs / nommee.processeurs > LOIN
                    || nommee.erreur.valeur / m.erreur.valeur > LOIN;
            nommee = seul ? m : nommee;
            String nom = seul && (grande || !m.methode.equals(Reglage.COINS)) ? m.parametres.replaceFirst("n=(.*) seuil=", "$1/") : "";
            points.add(new Volet.Point(m.processeurs, m.erreur, nom));
        }
        return points;
    }

    Planche cours() {
        return new Planche(1, 1000).volet(choix(Catalogue.COURS, true));
    }

    /** La même courbe pour chaque scène chronométrée, sur les mêmes axes. */
    Planche scenes() {
        Resultats chronometrees = tous.volet(Catalogue.CHOIX).tels(m -> m.rapport() > 0);
        return memesAxes(2, 800, Stream.concat(Stream.of(Catalogue.COURS), Scenes.DIFFICILES.stream())
                .filter(chronometrees.scenes()::contains).map(scene -> choix(scene, false)).collect(Collectors.toList()));
    }

    private static Planche memesAxes(int colonnes, int hauteur, List<Volet> volets) {
        Volet.memesAxes(volets);
        Planche planche = new Planche(colonnes, hauteur);
        volets.forEach(planche::volet);
        return planche;
    }

    /** L'erreur selon le nombre de réflexions, avec anticrénelage, de chaque scène livrée. */
    Planche reflets() {
        Resultats siens = tous.volet(Catalogue.REFLETS);
        return memesAxes(4, 440, siens.scenes().stream().map(scene -> new Volet(scene, "--reflets", "niveaux").xOrdinaire()
                .repere(1, "1 niveau").serie("", true, siens.scene(scene).toutes.stream().sorted(Comparator.comparingDouble(m -> m.x))
                .map(m -> new Volet.Point(m.x, m.erreur, "")).collect(Collectors.toList())))
                .collect(Collectors.toList()));
    }

    /** Le temps écoulé selon le nombre de fils. */
    Planche fils() {
        Resultats mesures = tous.volet(Catalogue.FILS).tels(m -> m.mur > 0);
        List<Mesure> siens = mesures.toutes;
        double mieux = siens.stream().mapToDouble(m -> m.mur).min().getAsDouble();
        return new Planche(1, 620).volet(new Volet("Le temps écoulé selon le nombre de fils : au mieux ÷ "
                + Nombres.arrondi(siens.get(0).mur / mieux), dater("fils", mesures), "secondes écoulées").xOrdinaire().yOrdinaire()
                .serie("mesures", false, siens.stream().map(m -> new Volet.Point(m.x, m.mur)).collect(Collectors.toList())));
    }

    /** Ce nom d'axe, le commit et le jour de la plus ancienne de ces mesures, et si la machine était occupée. */
    private static String dater(String axe, Resultats mesures) {
        return axe + " ; commit " + mesures.plusAncienne(m -> m.chronometre).replace(" ", ", le ")
                + (mesures.toutes.stream().anyMatch(m -> m.machine.endsWith(Mesureur.OCCUPEE)) ? Mesureur.OCCUPEE : "");
    }

    /** La pente de la droite des moindres carrés. */
    static double pente(List<Mesure> mesures, ToDoubleFunction<Mesure> x, ToDoubleFunction<Mesure> y) {
        double n = mesures.size();
        double mx = mesures.stream().mapToDouble(x).sum() / n;
        double my = mesures.stream().mapToDouble(y).sum() / n;
        double xx = mesures.stream().mapToDouble(m -> Math.pow(x.applyAsDouble(m) - mx, 2)).sum();
        double xy = mesures.stream().mapToDouble(m -> (x.applyAsDouble(m) - mx) * (y.applyAsDouble(m) - my)).sum();
        return xy / xx;
    }

    /** Le temps du programme entier, des boucles du cours et de deux autres programmes, selon le nombre de sphères. */
    Planche spheres() {
        Resultats siens = tous.volet(Catalogue.SPHERES).tels(m -> m.rapport() > 0);
        Volet volet = new Volet("Le temps selon le nombre de sphères", dater("nombre de sphères", siens),
                "secondes de processeur de la commande entière");
        for (String methode : new String[] {Catalogue.PROGRAMME, Reglage.BOUCLES.methode, Reglage.POVRAY, Reglage.EMBREE}) {
            volet.serie(methode, true, siens.methode(methode).toutes.stream()
                    .map(m -> new Volet.Point(m.x, m.processeurs)).collect(Collectors.toList()));
        }
        return new Planche(1, 900).volet(volet);
    }
}
