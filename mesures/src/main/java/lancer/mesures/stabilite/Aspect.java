package lancer.mesures.stabilite;

import java.awt.Color;
import java.util.Locale;
import lancer.essai.Formule;
import lancer.mesures.trace.FormeDePoint;
import lancer.mesures.trace.Style;

/** Comment une courbe nomme et dessine chaque façon de calculer une distance. */
enum Aspect {

    GEOMETRIQUE(Formule.GEOMETRIQUE, "géométrique : |f|² − b²", Style.ORANGE, FormeDePoint.TRIANGLE),
    RACINES(Formule.RACINES, "b² − 4ac, racines stables", Style.CIEL, FormeDePoint.LOSANGE),
    MANUEL(Formule.MANUEL, "manuel : b² − 4ac", Style.BLEU, FormeDePoint.CARRE),
    PERPENDICULAIRE(Formule.PERPENDICULAIRE, "perpendiculaire : |f − bV|²", Style.VERT, FormeDePoint.POINTE),
    FLOAT(Formule.FLOAT, "perpendiculaire en float", Style.GRIS, FormeDePoint.POINTE),
    COMPENSEE(Formule.COMPENSEE, "toujours compensée", Style.POURPRE, FormeDePoint.CROIX),
    DEUX_DOUBLES(Formule.DEUX_DOUBLES, "deux doubles par nombre", Style.NOIR, FormeDePoint.ETOILE),
    PROGRAMME(Formule.PROGRAMME, "le programme", Style.VERMILLON, FormeDePoint.ROND),
    RECHERCHE(Formule.RECHERCHE, "le programme, dans une recherche", Style.VERMILLON, FormeDePoint.CARRE);

    final Formule formule;

    /** Dans la légende. */
    final String nom;
    final Color couleur;
    final FormeDePoint forme;

    Aspect(Formule formule, String nom, Color couleur, FormeDePoint forme) {
        this.formule = formule;
        this.nom = nom;
        this.couleur = couleur;
        this.forme = forme;
    }

    /** Dans un CSV. */
    String cle() {
        return formule.name().toLowerCase(Locale.ROOT);
    }
}
