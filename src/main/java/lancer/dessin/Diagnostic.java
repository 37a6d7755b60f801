package lancer.dessin;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import lancer.Objet3D;
import lancer.Scene;
import lancer.contrat.Modele;
import lancer.contrat.PixelFautif;

/** Un pixel qui a échoué, situé : à la première ligne d'une classe de la scène ou d'une variante. */
final class Diagnostic {

    private Diagnostic() {
    }

    /** Échec du même pixel, et sa première cause, dont la pile commence, si elle y passe, par une de ces classes. */
    static PixelFautif situer(PixelFautif panne, Scene scene) {
        Modele modele = scene.getModele();
        Set<String> classes = new HashSet<>(Arrays.asList(Modele.nom(modele.getAtmosphere()),
                Modele.nom(modele.getSpecularite()), Modele.nom(modele.getEchantillonnage())));
        // ce que la base met à la place d'une variante n'est pas en cause
        classes.removeIf(nom -> nom.startsWith("lancer.contrat."));
        for (Objet3D objet : scene.getObjets()) {
            classes.add(Modele.nom(objet));
        }
        Throwable cause = panne;
        while (cause.getCause() != null) {
            cause = cause.getCause();
        }
        StackTraceElement[] pile = cause.getStackTrace();
        for (int k = 0; k < pile.length; k++) {
            if (classes.contains(pile[k].getClassName())) {
                cause.setStackTrace(Arrays.copyOfRange(pile, k, pile.length));
                break;
            }
        }
        return new PixelFautif(panne.xe, panne.ye, cause);
    }
}
