package lancer.mesures.vitesse;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import lancer.Scene;
import lancer.contrat.Echantillonnage;
import lancer.dessin.Dessin;
import lancer.mesures.Gabarit;
import lancer.mesures.ImageLineaire;
import lancer.mesures.scenes.Scenes;
import lancer.mesures.trace.Planche;
import lancer.mesures.trace.Style;

/** Une partie de la scène du cours, par trois réglages de durées voisines et en référence, avec l'erreur de chacun. */
final class Decoupe {

    static final String PNG = "temps-egal.png";

    private static final Taille DECOUPE = new Taille(48, 36);

    /** Coin de la découpe, en parts de l'image : le haut de la boule blanche et les bords de deux ombres. */
    private static final double COIN_X = 0.45;
    private static final double COIN_Y = 0.855;

    /** Nombre de sous-pixels par côté d'un pixel de la référence. */
    private static final int COTE = 32;

    /** Facteur d'agrandissement de l'erreur montrée en gris. */
    private static final int GROSSIE = 8;

    private final Scene scene;
    private final Taille taille;

    /** Colonne et ligne du coin de la découpe. */
    private final int[] coin;

    private Decoupe(Path fichier, Taille taille) {
        scene = Scenes.lire(fichier);
        this.taille = taille;
        coin = new int[] {(int) (COIN_X * taille.largeur), (int) Math.min(COIN_Y * taille.hauteur, taille.hauteur - DECOUPE.hauteur)};
    }

    /** Dessine la planche des réglages dont la durée est la plus proche de celle du réglage par défaut de l'anticrénelage. */
    static void ecrire(Releves tous, Path dossier) throws IOException {
        Releves siens = tous.de(Catalogue.METHODES).scene(Catalogue.COURS);
        Releve defaut = siens.le(Catalogue.SANS_SECTION, "");
        Decoupe decoupe = new Decoupe(Scenes.fichier(Catalogue.COURS, dossier), new Taille((int) defaut.nombre("largeur"),
                (int) defaut.nombre("hauteur")));
        List<Releve> montres = new ArrayList<>();
        List<ImageLineaire> images = new ArrayList<>();
        for (String methode : new String[] {Catalogue.GRILLE, Catalogue.SANS_SECTION, Catalogue.PARTAGE}) {
            Releve r = siens.methode(methode).get().stream().min(Comparator.comparingDouble(
                    a -> Math.abs(Math.log(a.rapport().valeur / defaut.rapport().valeur)))).get();
            montres.add(r);
            images.add(decoupe.image(Catalogue.methode(r.famille, r.scene, r.methode + "/" + r.parametres)));
        }
        ImageLineaire verite = decoupe.verite();
        Planche planche = new Planche("En des temps voisins : l'image, la vérité, et l'erreur × " + GROSSIE, "").colonnes(4)
                .taille(Style.LARGEUR, 800);
        for (int k = 0; k < montres.size(); k++) {
            Releve r = montres.get(k);
            planche.vignette(decoupe.couper(images.get(k)), r.nom(), Style.arrondi(siens.secondes() * r.rapport().valeur) + " s, "
                    + Style.niveaux(r.erreur().valeur));
        }
        planche.vignette(decoupe.couper(verite), "la vérité", Style.nombre(COTE * COTE) + " rayons par pixel");
        images.forEach(image -> planche.vignette(decoupe.ecarts(image, verite), "", "son erreur × " + GROSSIE));
        planche.ecrire(dossier.resolve(PNG));
    }

    private ImageLineaire image(Methode methode) {
        ImageLineaire image = new ImageLineaire(taille.largeur, taille.hauteur);
        methode.new ScenePrete(scene, taille.largeur, taille.hauteur).faire(image, taille.fils);
        return image;
    }

    /** La référence de la découpe : la moyenne de chaque pixel, sans limite de réflexions. */
    private ImageLineaire verite() {
        Echantillonnage fin = (pave, voulus, vue, toile) -> {
            for (int j = Math.max(pave.j0, coin[1]); j < Math.min(pave.j1, coin[1] + DECOUPE.hauteur); j++) {
                for (int i = Math.max(pave.i0, coin[0]); i < Math.min(pave.i1, coin[0] + DECOUPE.largeur); i++) {
                    toile.drawPixel(Gabarit.moyenne(vue, i, j, COTE, () -> 0.5), i, j);
                }
            }
            return 0;
        };
        return ImageLineaire.de(Dessin.lancer(scene.avec(scene.getModele().avec(fin, 0)), taille.largeur, taille.hauteur, false),
                Gabarit.PROFONDEUR, taille.fils);
    }

    private BufferedImage couper(ImageLineaire image) {
        return Comptes.image(image, taille).getSubimage(coin[0], coin[1], DECOUPE.largeur, DECOUPE.hauteur);
    }

    /** Un gris par pixel : la plus grande erreur de ses composantes, agrandie. */
    private BufferedImage ecarts(ImageLineaire image, ImageLineaire verite) {
        BufferedImage gris = new BufferedImage(DECOUPE.largeur, DECOUPE.hauteur, BufferedImage.TYPE_INT_RGB);
        for (int k = 0; k < DECOUPE.pixels(); k++) {
            int i = k % DECOUPE.largeur;
            int j = k / DECOUPE.largeur;
            int rang = 3 * ((coin[1] + j) * taille.largeur + coin[0] + i);
            double ecart = IntStream.range(rang, rang + 3).mapToDouble(c -> Math.abs(Math.min(1, image.getComposantes()[c])
                    - Math.min(1, verite.getComposantes()[c]))).max().getAsDouble();
            gris.setRGB(i, j, 0x010101 * (int) Math.min(255, Math.round(255 * GROSSIE * ecart)));
        }
        return gris;
    }
}
