package lancer.mesures.vitesse;

import java.awt.Color;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import lancer.mesures.Intervalle;
import lancer.mesures.trace.FormeDePoint;
import lancer.mesures.trace.Marque;
import lancer.mesures.trace.Planche;
import lancer.mesures.trace.Serie;
import lancer.mesures.trace.Style;
import lancer.mesures.trace.Volet;

/** Courbes de vitesse et de précision. */
final class Planches {

    /** Erreur quadratique moyenne de l'arrondi de l'écran, en niveaux. */
    static final double ARRONDI = 1 / Math.sqrt(12);

    /** Lignes d'une courbe : nom écrit au bout, méthodes, couleur et forme des points. */
    private static final Object[][] LIGNES = {
        {"reflets", Arrays.asList(Catalogue.REFLETS, Catalogue.UN_RAYON), Style.VERMILLON, FormeDePoint.ROND},
        {"grille", Arrays.asList(Catalogue.GRILLE), Style.BLEU, FormeDePoint.CARRE},
        {"coins", Arrays.asList(Catalogue.COINS), Style.ORANGE, FormeDePoint.TRIANGLE},
        {"partage", Arrays.asList(Catalogue.PARTAGE, Catalogue.ENSEMBLE), Style.VERT, FormeDePoint.LOSANGE},
        {"", Arrays.asList(Catalogue.BOUCLES), Style.GRIS, FormeDePoint.ROND},
        {"", Arrays.asList(Catalogue.POVRAY), Style.CIEL, FormeDePoint.POINTE},
        {"", Arrays.asList(Catalogue.AUTO), Style.POURPRE, FormeDePoint.CROIX}};

    private final Releves releves;

    Planches(Releves releves) {
        this.releves = releves.de(Catalogue.METHODES).tels(r -> r.nombre("rapport") > 0);
    }

    /** Les scènes qui ont une courbe. */
    List<String> scenes() {
        return releves.scenes();
    }

    /** L'erreur selon le temps, pour une scène ou pour plusieurs sur des axes communs. */
    Planche scenes(List<String> scenes) {
        boolean seule = scenes.size() == 1;
        List<Volet> volets = scenes.stream().map(scene -> volet(scene, seule)).collect(Collectors.toList());
        Volet.memesAxes(volets);
        Planche planche = new Planche(seule ? "Scène du cours : ce qu'une erreur plus petite coûte en temps"
                : "La même chose sur quatre scènes", "").colonnes(2).taille(Style.LARGEUR, seule ? 1060 : 1500);
        volets.forEach(planche::volet);
        return planche;
    }

    private Volet volet(String scene, boolean seule) {
        Releves siens = releves.scene(scene);
        double secondes = siens.secondes();
        Volet volet = new Volet(seule ? "" : scene, "secondes de la commande entière", "erreur, en niveaux")
                .enHaut(secondes, "un rayon par pixel = 1").repere(1, "1 niveau").repere(ARRONDI, "0,29 : l'arrondi de l'écran").mieux();
        Optional<Releve> choisi = seule ? siens.lePlusRapide(1) : Optional.empty();
        for (Object[] ligne : LIGNES) {
            List<Marque> marques = new ArrayList<>();
            siens.tels(r -> ((List<?>) ligne[1]).contains(r.methode)).get().stream().sorted(Releves.PAR_TEMPS).forEach(r -> {
                Marque m = new Marque(r.rapport().fois(secondes), r.erreur());
                boolean defaut = estParDefaut(r);
                boolean nommee = ligne[0].equals("") || seule && defaut || choisi.filter(r::equals).isPresent();
                m = nommee ? m.nommee(r.nom() + (defaut ? " (défaut)" : "")) : m;
                marques.add(defaut ? m.cerclee() : m);
            });
            volet.serie(new Serie("", (Color) ligne[2], (FormeDePoint) ligne[3], true, marques).auBout((String) ligne[0]));
        }
        return volet;
    }

    /** Dit si ce réglage est celui du programme, ou du module antialias, sans demande particulière. */
    private static boolean estParDefaut(Releve r) {
        return r.methode.equals(Catalogue.UN_RAYON) || r.methode.equals(Catalogue.COINS) && r.parametres.equals(Catalogue.COINS_DEFAUT);
    }

    /** Le temps du programme entier et d'autres programmes, selon le nombre de sphères. */
    static Planche spheres(Releves spheres) {
        Volet volet = new Volet("", "nombre de sphères", "de la commande au PNG écrit, en secondes");
        Object[][] series = {{Catalogue.BOUCLES, "les boucles du cours", Style.BLEU, FormeDePoint.CARRE},
            {Catalogue.POVRAY, "POV-Ray", Style.CIEL, FormeDePoint.TRIANGLE},
            {Catalogue.EMBREE, "Embree, en C++", Style.VERT, FormeDePoint.POINTE},
            {Catalogue.PROGRAMME, "le programme", Style.VERMILLON, FormeDePoint.ROND}};
        for (Object[] s : series) {
            volet.serie(new Serie((String) s[1], (Color) s[2], (FormeDePoint) s[3], true,
                    spheres.methode((String) s[0]).get().stream().map(r -> {
                        Intervalle t = r.rapport().fois(r.nombre("reference_ms") / 1000);
                        return new Marque(Intervalle.exact(r.nombre("spheres")), t).nommee(Style.nombre(t.valeur));
                    }).collect(Collectors.toList())));
        }
        return new Planche("De une à un million de sphères, le programme entier et d'autres", "Démarrage de Java, lecture, préparation, "
                + "dessin, écriture, à froid. Au-delà de 1 000 sphères, les boucles ne sont plus mesurées. make mesures").volet(volet);
    }
}
