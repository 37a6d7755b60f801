package lancer.mesures.vitesse;

import java.awt.Color;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import lancer.Constantes;
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

    /** Lignes d'une courbe : nom dans la légende, méthodes, couleur et forme des points, vrai pour des noms de points à gauche. */
    private static final Object[][] LIGNES = {
        {"reflets : 0, 1, 2… à un rayon par pixel", Arrays.asList(Catalogue.REFLETS, Catalogue.UN_RAYON), Style.VERMILLON,
            FormeDePoint.ROND, true},
        {Catalogue.GRILLE, Arrays.asList(Catalogue.GRILLE), Style.BLEU, FormeDePoint.CARRE, false},
        {Catalogue.COINS, Arrays.asList(Catalogue.COINS), Style.ORANGE, FormeDePoint.TRIANGLE, false},
        {Catalogue.SANS_SECTION, Arrays.asList(Catalogue.SANS_SECTION), Style.ENCRE, FormeDePoint.TRIANGLE, false},
        {Catalogue.PARTAGE, Arrays.asList(Catalogue.PARTAGE), Style.VERT, FormeDePoint.LOSANGE, true},
        {Catalogue.BOUCLES, Arrays.asList(Catalogue.BOUCLES), Style.GRIS, FormeDePoint.ROND, false},
        {Catalogue.POVRAY + ", grille adaptative", Arrays.asList(Catalogue.POVRAY), Style.CIEL, FormeDePoint.POINTE, false},
        {Catalogue.AUTO + " erreur=1", Arrays.asList(Catalogue.AUTO), Style.POURPRE, FormeDePoint.CROIX, false}};

    /** Ordre des points d'une ligne : par nombre de réflexions, sinon celui des mesures ; « un rayon » a le nombre ordinaire. */
    private static final Comparator<Releve> PAR_REGLAGE = Comparator.comparingInt(r -> r.methode.equals(Catalogue.UN_RAYON)
            ? Constantes.MAX_REFLETS : r.methode.equals(Catalogue.REFLETS) ? Integer.parseInt(r.parametres) : 0);

    /** Méthodes dont chaque point porte son réglage ; programmes à qui rien n'est demandé, entourés. */
    private static final List<String> A_NOMMER = Arrays.asList(Catalogue.REFLETS, Catalogue.GRILLE, Catalogue.COINS, Catalogue.PARTAGE);
    private static final List<String> SANS_DEMANDE = Arrays.asList(Catalogue.UN_RAYON, Catalogue.SANS_SECTION);

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
        Planche planche = new Planche(seule ? "Scène du cours : l'erreur de chaque réglage, et son temps"
                : "La même chose sur quatre scènes", "Près d'un point de coins ou de partage : n, puis le seuil. Autour des réglages sans "
                + "section ni option, un cercle. Plus bas et plus à gauche, c'est mieux. make mesures").colonnes(2)
                .taille(Style.LARGEUR, seule ? 1150 : 1600);
        volets.forEach(planche::volet);
        return planche;
    }

    private Volet volet(String scene, boolean seule) {
        Releves siens = releves.scene(scene);
        double secondes = siens.secondes();
        Volet volet = new Volet(seule ? "" : scene, "secondes de la commande entière", "erreur, en niveaux")
                .enHaut(secondes, "un rayon par pixel = 1").repere(1, "1 niveau").repere(ARRONDI, "0,29 : l'arrondi de l'écran");
        List<Marque> sansDemande = new ArrayList<>();
        for (Object[] ligne : LIGNES) {
            List<Marque> marques = new ArrayList<>();
            siens.tels(r -> ((List<?>) ligne[1]).contains(r.methode)).get().stream().sorted(PAR_REGLAGE).forEach(r -> {
                marques.add(marque(r, secondes).nommee(seule && A_NOMMER.contains(r.methode) ? nom(r) : ""));
                if (SANS_DEMANDE.contains(r.methode)) {
                    sansDemande.add(marque(r, secondes).nommee(seule && r.methode.equals(Catalogue.UN_RAYON) ? r.methode : ""));
                }
            });
            Serie serie = new Serie((String) ligne[0], (Color) ligne[2], (FormeDePoint) ligne[3], true, marques);
            volet.serie((boolean) ligne[4] ? serie.nommeeAGauche() : serie);
        }
        return volet.serie(new Serie("", Style.NOIR, FormeDePoint.ANNEAU, false, sansDemande));
    }

    private static Marque marque(Releve r, double secondes) {
        return new Marque(r.rapport().fois(secondes), r.erreur());
    }

    /** Ce qui distingue ce réglage de ceux de la même ligne : « 8/0.06 ». */
    private static String nom(Releve r) {
        return r.parametres.replaceFirst("n=(.*) seuil=", "$1/");
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
                        return new Marque(Intervalle.exact(r.nombre("spheres")), t);
                    }).collect(Collectors.toList())));
        }
        return new Planche("De une à un million de sphères, le programme entier et d'autres", "Démarrage de Java, lecture, préparation, "
                + "dessin, écriture, à froid. Les boucles sont mesurées jusqu'à 1 000 sphères, et POV-Ray jusqu'à 100 000. make mesures").volet(volet);
    }
}
