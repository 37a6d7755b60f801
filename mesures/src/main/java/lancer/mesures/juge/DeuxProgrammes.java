package lancer.mesures.juge;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Objet3D;
import lancer.Scene;
import lancer.Sphere;
import lancer.image.ImageMemoire;
import lancer.inspection.FaussesCouleurs;
import lancer.mesures.Gabarit;
import lancer.mesures.ImageLineaire;
import lancer.mesures.scenes.Scenes;
import lancer.mesures.trace.Planche;

/**
 * La même foule de miroirs parfaits par deux programmes justes, celui-ci et POV-Ray : où leurs images diffèrent, et où c'était à prévoir.
 */
public final class DeuxProgrammes {

    /** Nom de la figure. */
    public static final String PNG = "stabilite-programmes.png";

    private static final int LARGEUR = 200;
    private static final int HAUTEUR = 150;

    /** Nombre de reflets pour lequel la précision d'un double ne suffit plus. */
    private static final int REFLETS = 15;

    /** Marge, en décimales, jusqu'à laquelle un pixel est dit peu sûr : il change si son rayon tourne de 10⁻¹². */
    private static final int PEU_SUR = 4;

    private static final int FILS = Runtime.getRuntime().availableProcessors();

    private DeuxProgrammes() {
    }

    public static void dessiner(PovRay povray, Path dossier) throws IOException {
        List<Sphere> miroirs = new ArrayList<>();
        for (Objet3D objet : Scenes.lire(Scenes.fichier(Scenes.FOULE + "-10000", dossier)).getObjets()) {
            Sphere miroir = new Sphere(((Sphere) objet).getCentre(), ((Sphere) objet).getRayon());
            miroir.setKs(new Couleur(1));
            miroirs.add(miroir);
        }
        Planche planche = new Planche(4, 400);
        for (int reflets : new int[] {Constantes.MAX_REFLETS, REFLETS}) {
            SceneJugee jugee = new SceneJugee(povray, "miroirs-parfaits", new Scene(miroirs, Collections.emptyList()), reflets, LARGEUR,
                    HAUTEUR);
            ImageLineaire notre = ImageLineaire.de(jugee.lancer, reflets, FILS);
            ImageLineaire sienne = jugee.image();
            ImageMemoire marge = new ImageMemoire(LARGEUR, HAUTEUR, true);
            new FaussesCouleurs(jugee.lancer, marge, reflets, FILS).dessiner("marge");
            planche.vignette(notre.image(), "lancer, " + reflets + " reflets", "")
                    .vignette(sienne.image(), "POV-Ray, " + reflets + " reflets", "");
            differences(planche, notre.ecarts(sienne), marge);
        }
        planche.ecrire(dossier.resolve(PNG));
    }

    /** Ajoute la vue « marge », puis les pixels différents, avec le nombre de ceux que cette vue dit peu sûrs. */
    private static void differences(Planche planche, BufferedImage ecarts, ImageMemoire marge) {
        BufferedImage vue = new BufferedImage(LARGEUR, HAUTEUR, BufferedImage.TYPE_INT_RGB);
        vue.setRGB(0, 0, LARGEUR, HAUTEUR, marge.codes, 0, LARGEUR);
        int autres = 0;
        int prevus = 0;
        int peuSurs = 0;
        for (int k = 0; k < LARGEUR * HAUTEUR; k++) {
            boolean autre = (ecarts.getRGB(k % LARGEUR, k / LARGEUR) & 0xFF) > Gabarit.VISIBLE;
            boolean peuSur = marge.lineaire[3 * k] <= PEU_SUR;
            autres += autre ? 1 : 0;
            prevus += autre && peuSur ? 1 : 0;
            peuSurs += peuSur ? 1 : 0;
            ecarts.setRGB(k % LARGEUR, k / LARGEUR, autre ? 0xD55E00 : 0xF3F3F3);
        }
        planche.vignette(vue, "--vue marge", peuSurs + " changent à 10⁻¹²")
                .vignette(ecarts, "lancer et POV-Ray", autres + " diffèrent, " + prevus + " prévus");
    }
}
