package lancer.mesures.vitesse;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import lancer.Constantes;
import lancer.Scene;
import lancer.dessin.Dessin;
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

    /** Les réglages de chaque méthode dont le temps est le plus proche de celui de l'anticrénelage du cours. */
    private static List<Mesure> montres(Resultats siens) {
        double temps = siens.de(Reglage.coins(3, 0.05)).map(m -> m.processeurs).orElse(1.0);
        List<Mesure> montres = new ArrayList<>();
        for (String methode : new String[] {Reglage.GRILLE, Reglage.COINS, Reglage.PARTAGE}) {
            siens.methode(methode).toutes.stream().filter(m -> m.processeurs > 0)
                    .min(Comparator.comparingDouble(m -> Math.abs(Math.log(m.processeurs / temps)))).ifPresent(montres::add);
        }
        return montres;
    }

    static void dessiner(Resultats tous, Path dossier) throws IOException {
        Resultats siens = tous.volet(Catalogue.CHOIX).scene(Catalogue.COURS);
        Path fichier = Scenes.fichier(Catalogue.COURS, dossier);
        int largeur = Constantes.LARGEUR_IMAGE;
        Scene scene = Scenes.lire(fichier);
        ImageLineaire verite = Gabarit.image(scene, largeur, Constantes.HAUTEUR_IMAGE,
                k -> k % largeur >= X && k % largeur < X + LARGEUR && k / largeur >= Y && k / largeur < Y + HAUTEUR, COTE, 1);
        Planche planche = new Planche(4, 420);
        List<ImageLineaire> images = new ArrayList<>();
        for (Mesure m : montres(siens)) {
            Reglage reglage = Catalogue.reglage(m);
            ImageLineaire image = ImageLineaire.de(reglage.lancer(Dessin.lancer(scene, largeur, Constantes.HAUTEUR_IMAGE, false)),
                    reglage.profondeur(), Runtime.getRuntime().availableProcessors());
            images.add(image);
            planche.vignette(couper(image.image()), m.nom(), Nombres.arrondi(m.processeurs) + " s de processeur, "
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
