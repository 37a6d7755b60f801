package lancer.mesures.vitesse;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import lancer.Constantes;
import lancer.mesures.Gabarit;
import lancer.mesures.ImageLineaire;
import lancer.mesures.Nombres;
import lancer.mesures.scenes.Scenes;
import lancer.mesures.trace.Planche;

/** Une partie de la scène du cours, par trois réglages de temps voisins et en vérité, avec l'erreur de chacun. */
final class Decoupe {

    static final String PNG = "temps-egal.png";

    /** La découpe : le haut de la boule blanche et les bords de deux ombres. */
    private static final int X = 360;
    private static final int Y = 513;
    private static final int LARGEUR = 48;
    private static final int HAUTEUR = 36;

    /** Nombre de sous-pixels par côté d'un pixel de la vérité. */
    private static final int COTE = 32;

    /** Facteur d'agrandissement de l'erreur montrée en gris. */
    private static final int GROSSIE = 8;

    private Decoupe() {
    }

    /** Les réglages de chaque méthode dont le temps est le plus proche de celui de l'anticrénelage sans réglage. */
    private static List<Mesure> montres(Resultats siens) {
        double temps = siens.de(Reglage.COINS_PAR_DEFAUT).map(m -> m.rapport.valeur).orElse(1.0);
        List<Mesure> montres = new ArrayList<>();
        for (String methode : new String[] {Reglage.GRILLE, Reglage.COINS, Reglage.PARTAGE}) {
            siens.methode(methode).toutes.stream().filter(m -> m.rapport.valeur > 0)
                    .min(Comparator.comparingDouble(m -> Math.abs(Math.log(m.rapport.valeur / temps)))).ifPresent(montres::add);
        }
        return montres;
    }

    /** @param mesureur dessine les réglages montrés */
    static void dessiner(Resultats tous, Mesureur mesureur, Path dossier) throws IOException {
        Resultats siens = tous.volet(Catalogue.CHOIX).scene(Catalogue.COURS);
        Path fichier = Scenes.fichier(Catalogue.COURS, dossier);
        int largeur = Constantes.LARGEUR_IMAGE;
        ImageLineaire verite = Gabarit.image(Scenes.lire(fichier), largeur, Constantes.HAUTEUR_IMAGE,
                k -> k % largeur >= X && k % largeur < X + LARGEUR && k / largeur >= Y && k / largeur < Y + HAUTEUR, COTE, 1);
        Planche planche = new Planche(4, 420);
        List<ImageLineaire> images = new ArrayList<>();
        for (Mesure m : montres(siens)) {
            ImageLineaire image = mesureur.image(Catalogue.reglage(m), fichier);
            images.add(image);
            planche.vignette(couper(image.image()), m.nom(), Nombres.arrondi(siens.unite() * m.rapport.valeur) + " s, "
                    + Nombres.niveaux(m.erreur.valeur));
        }
        planche.vignette(couper(verite.image()), "la vérité", Nombres.nombre(COTE * COTE) + " rayons par pixel");
        images.forEach(image -> planche.vignette(couper(image.ecarts(verite, GROSSIE)), "", "son erreur × " + GROSSIE));
        planche.ecrire(dossier.resolve(PNG));
    }

    private static BufferedImage couper(BufferedImage image) {
        return image.getSubimage(X, Y, LARGEUR, HAUTEUR);
    }
}
