package lancer.mesures.vitesse;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import lancer.mesures.trace.FormeDePoint;
import lancer.mesures.trace.Marque;
import lancer.mesures.trace.Planche;
import lancer.mesures.trace.Serie;
import lancer.mesures.trace.Style;
import lancer.mesures.trace.Volet;

/**
 * La courbe principale d'une scène : ce que coûte chaque méthode et de combien elle se trompe. Deux volets, car il y a deux
 * vérités : à gauche l'anticrénelage contre la moyenne sur le pixel ; à droite les limites de réflexion contre les mêmes rayons
 * sans limite.
 */
final class FigureScene {

    /** Une erreur plus petite, en pas de l'écran, est dessinée avec zéro. */
    private static final double PLANCHER = 1e-4;
    private static final String ERREUR = "erreur, en pas d'écran";

    private final Constats constats;
    private final Cout cout;
    private final String note;

    /** @param note machine, date et taille */
    FigureScene(String scene, Releves releves, Cout cout, String note) {
        this.constats = new Constats(scene, releves, cout);
        this.cout = cout;
        this.note = note(scene, releves) + note;
    }

    Planche planche() {
        Volet gauche = new Volet(constats.anticrenelage(), "Anticrénelage, jugé sur la moyenne de chaque pixel", cout.axe, ERREUR)
                .plancher(PLANCHER).front(marques(constats.front.get(), constats.front));
        ajouter(gauche, constats.echantillonnages, constats.front, Catalogue.BROUILLON, Style.GRIS, FormeDePoint.POINTE, false);
        ajouter(gauche, constats.echantillonnages, constats.front, Catalogue.UN_RAYON, Style.NOIR, FormeDePoint.ROND, false);
        ajouter(gauche, constats.echantillonnages, constats.front, Catalogue.GRILLE, Style.BLEU, FormeDePoint.CARRE, true);
        ajouter(gauche, constats.echantillonnages, constats.front, Catalogue.COINS, Style.ORANGE, FormeDePoint.TRIANGLE, false);
        ajouter(gauche, constats.echantillonnages, constats.front, Catalogue.PARTAGE, Style.VERT, FormeDePoint.LOSANGE, false);
        Volet droite = new Volet(constats.limites(), "Reflets, jugés sur les mêmes rayons sans limite", cout.axe, ERREUR).plancher(PLANCHER)
                .front(marques(constats.frontReflets.get(), constats.frontReflets));
        ajouter(droite, constats.reflets, constats.frontReflets, Catalogue.PROFONDEUR, Style.VERMILLON, FormeDePoint.ROND, true);
        ajouter(droite, constats.reflets, constats.frontReflets, Catalogue.SEUIL, Style.POURPRE, FormeDePoint.ETOILE, true);
        return new Planche(constats.titre(), note).volet(gauche, 1.25).volet(droite, 1);
    }

    /** Ce que mesure l'erreur, et jusqu'où elle veut dire quelque chose. */
    private static String note(String scene, Releves releves) {
        Releve verite = releves.de(scene, Famille.VERITE).de("moyenne").get().get(0);
        return "Erreur : racine du carré moyen des écarts, en couleurs linéaires ; 1 pas = 1/255. La moyenne sur le pixel, de "
                + Noms.valeur(verite, "n") + " × " + Noms.valeur(verite, "n") + " rayons au plus, est connue à "
                + Style.arrondi(verite.erreurEnPas()) + " pas près. ";
    }

    private void ajouter(Volet volet, Releves releves, Front front, String methode, Color couleur, FormeDePoint forme, boolean reliee) {
        List<Releve> siens = releves.de(methode).get();
        volet.serie(new Serie(Noms.serie(methode), couleur, forme, reliee, marques(siens, front)));
    }

    private List<Marque> marques(List<Releve> releves, Front front) {
        List<Marque> marques = new ArrayList<>();
        for (Releve r : releves) {
            Marque m = Marque.en(cout.de(r), r.erreurEnPas()).nommee(Noms.etiquette(r));
            m = cout == Cout.TEMPS ? m.entreX(r.nombre("q1_ms"), r.nombre("q3_ms")) : m;
            m = front.contient(r) ? m : m.creuse();
            marques.add(Catalogue.estParDefaut(r) ? m.cerclee() : m);
        }
        return marques;
    }
}
