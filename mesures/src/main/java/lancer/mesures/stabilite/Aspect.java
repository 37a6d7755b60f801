package lancer.mesures.stabilite;

import java.awt.Color;
import java.util.Locale;
import lancer.essai.Formule;
import lancer.mesures.trace.FormeDePoint;
import lancer.mesures.trace.Style;

/** Comment une courbe nomme et dessine chaque {@link Formule}, sous son nom. */
enum Aspect {

    GEOMETRIQUE("géométrique : |f|² − b²", Style.ORANGE, FormeDePoint.TRIANGLE),
    RACINES("b² − 4ac, racines stables", Style.CIEL, FormeDePoint.LOSANGE),
    MANUEL("manuel : b² − 4ac", Style.BLEU, FormeDePoint.CARRE),
    PERPENDICULAIRE("perpendiculaire : |f − bV|²", Style.VERT, FormeDePoint.POINTE),
    FLOAT("perpendiculaire en float", Style.GRIS, FormeDePoint.POINTE),
    COMPENSEE("toujours compensée", Style.POURPRE, FormeDePoint.CROIX),
    DEUX_DOUBLES("deux doubles par nombre", Style.NOIR, FormeDePoint.ETOILE),
    PROGRAMME("le programme", Style.VERMILLON, FormeDePoint.ROND),
    RECHERCHE("le programme, dans une recherche", Style.VERMILLON, FormeDePoint.CARRE);

    final Formule formule = Formule.valueOf(name());

    /** Dans la légende. */
    final String nom;
    final Color couleur;
    final FormeDePoint forme;

    Aspect(String nom, Color couleur, FormeDePoint forme) {
        this.nom = nom;
        this.couleur = couleur;
        this.forme = forme;
    }

    /** Dans un CSV. */
    String cle() {
        return name().toLowerCase(Locale.ROOT);
    }
}
