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
import lancer.mesures.Gabarit;
import lancer.mesures.ImageLineaire;
import lancer.mesures.Nombres;
import lancer.mesures.scenes.Scenes;
import lancer.mesures.trace.Planche;

/** La même foule de miroirs parfaits par deux programmes justes, celui-ci et POV-Ray, et où leurs images diffèrent. */
public final class DeuxProgrammes {

    /** Nom de la figure. */
    public static final String PNG = "stabilite-programmes.png";

    private static final int LARGEUR = 200;
    private static final int HAUTEUR = 150;

    /** Nombre de reflets pour lequel la précision d'un double ne suffit plus. */
    private static final int REFLETS = 15;

    private DeuxProgrammes() {
    }

    public static void dessiner(PovRay povray, Path dossier) throws IOException {
        List<Sphere> miroirs = new ArrayList<>();
        for (Objet3D objet : Scenes.lire(Scenes.fichier(Scenes.FOULE + "-10000", dossier)).getObjets()) {
            Sphere miroir = new Sphere(((Sphere) objet).getCentre(), ((Sphere) objet).getRayon());
            miroir.setKs(new Couleur(1));
            miroirs.add(miroir);
        }
        Planche planche = new Planche(3, 500);
        for (int reflets : new int[] {Constantes.MAX_REFLETS, REFLETS}) {
            SceneJugee jugee = new SceneJugee(povray, "miroirs-parfaits", new Scene(miroirs, Collections.emptyList()), reflets, LARGEUR,
                    HAUTEUR);
            ImageLineaire notre = ImageLineaire.de(jugee.lancer, reflets, Runtime.getRuntime().availableProcessors());
            ImageLineaire sienne = jugee.image();
            BufferedImage ecarts = notre.ecarts(sienne, 1);
            double part = 0;
            for (int k = 0; k < LARGEUR * HAUTEUR; k++) {
                boolean autre = (ecarts.getRGB(k % LARGEUR, k / LARGEUR) & 0xFF) > Gabarit.VISIBLE;
                part += autre ? 100.0 / LARGEUR / HAUTEUR : 0;
                ecarts.setRGB(k % LARGEUR, k / LARGEUR, autre ? 0xD55E00 : 0xF3F3F3);
            }
            planche.vignette(notre.image(), "lancer, " + reflets + " reflets", "")
                    .vignette(sienne.image(), "POV-Ray, " + reflets + " reflets", "")
                    .vignette(ecarts, "différents de plus de " + Gabarit.VISIBLE + " niveaux", Nombres.arrondi(part) + " % des pixels");
        }
        planche.ecrire(dossier.resolve(PNG));
    }
}
