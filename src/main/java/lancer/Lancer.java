package lancer;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.IntConsumer;
import lancer.contrat.Compteurs;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.PixelFautif;
import lancer.contrat.Toile;
import lancer.contrat.Vue;
import lancer.fils.Equipe;

/**
 * L'algorithme : de la scène à l'image (cours, « Algorithme général »). Un {@code Lancer} dessine une image à la fois.
 */
public class Lancer {

    private final Scene scene;
    private final Camera camera;
    private final Equipe equipe = new Equipe("lancer");
    private volatile boolean brouillonFait;
    private Compteurs compteurs = new Compteurs();
    private long dureeNs;

    public Lancer(Scene scene, Camera camera) {
        this.scene = scene;
        this.camera = camera;
    }

    public Scene getScene() {
        return scene;
    }

    public Camera getCamera() {
        return camera;
    }

    /** De quoi dessiner la même scène autrement : voir {@link Scene#avec}. */
    public Lancer avec(Echantillonnage echantillonnage, double seuil) {
        return new Lancer(scene.avec(echantillonnage, seuil), camera);
    }

    /**
     * La couleur vue à travers un point de l'écran ({@link Camera#getRayon}), non limitée.
     *
     * @param profondeur nombre de réflexions permises
     */
    public Couleur getCouleurPixel(double xe, double ye, int profondeur) {
        scene.getCompteurs().primaires++;
        Rayon initial = camera.getRayon(xe, ye);
        return scene.getCouleurVue(initial, null, profondeur);
    }

    /**
     * {@link #getCouleurPixel}, ou un échec qui dit où.
     *
     * @throws PixelFautif si ce calcul échoue, ou si une composante n'est pas un nombre fini
     */
    public Couleur voir(double xe, double ye, int profondeur) {
        try {
            return PixelFautif.verifier(getCouleurPixel(xe, ye, profondeur), xe, ye);
        } catch (OutOfMemoryError | PixelFautif e) {
            // le premier n'est pas la faute de ce pixel
            throw e;
        } catch (RuntimeException | Error e) {
            throw new PixelFautif(xe, ye, e);
        }
    }

    /**
     * Dessine un brouillon, puis tous les pixels.
     *
     * @param profondeur nombre de réflexions permises
     * @param fils nombre de fils d'exécution, au moins 1 ; l'image n'en dépend pas
     * @throws CancellationException si {@link #arreter()} a été appelé
     * @throws PixelFautif si un pixel ne peut être calculé
     */
    public void TracerImage(Toile toile, int profondeur, int fils) {
        TracerBrouillon(toile, profondeur, fils);
        brouillonFait = true;
        TracerPixels(toile, profondeur, fils);
    }

    /** Dessine des carrés de 4 × 4 pixels, chacun de la couleur de son centre, avec une réflexion au plus. */
    public void TracerBrouillon(Toile toile, int profondeur, int fils) {
        parcourir(Echantillonnage.BROUILLON, toile, Math.min(profondeur, Constantes.REFLETS_BROUILLON), fils);
    }

    /** Dessine tous les pixels, sans brouillon. */
    public void TracerPixels(Toile toile, int profondeur, int fils) {
        parcourir(scene.getEchantillonnage(), toile, profondeur, fils);
    }

    /** Abandonne le dessin en cours, au prochain rayon de chaque fil, et tous les suivants. */
    public void arreter() {
        equipe.arreter();
    }

    /** La part faite de l'image (ou du brouillon) en cours, de 0 à 1. */
    public double getAvancement() {
        return (double) equipe.getFaites() / Pave.nombre(camera.getLargeur(), camera.getHauteur());
    }

    /** Vrai dès que {@link #TracerImage} a fini le brouillon : chaque pixel de l'image a une couleur. */
    public boolean isBrouillonFait() {
        return brouillonFait;
    }

    /** Le premier écart que des pixels témoins ont vu, en une phrase qui nomme le pixel ; {@code null} si aucun. */
    public String getEcart() {
        return null;
    }

    /** Ce que le dernier dessin achevé a compté, tous fils ensemble. */
    public Compteurs getCompteurs() {
        return compteurs;
    }

    /** Le temps du dernier dessin achevé, en nanosecondes. */
    public long getDureeNs() {
        return dureeNs;
    }

    /** La boucle sur l'image, dont chaque pavé est dessiné par cet échantillonnage. */
    public void parcourir(Echantillonnage echantillonnage, Toile toile, int profondeur, int fils) {
        long debut = System.nanoTime();
        int nombre = Pave.nombre(camera.getLargeur(), camera.getHauteur());
        List<Fil> ouvriers = new ArrayList<>();
        for (int k = 0; k < Math.min(fils, nombre); k++) {
            ouvriers.add(new Fil(echantillonnage, toile, profondeur));
        }
        equipe.faire(nombre, ouvriers);
        Compteurs total = new Compteurs();
        for (Fil fil : ouvriers) {
            total.ajouter(fil.sien.scene.getCompteurs());
        }
        compteurs = total;
        dureeNs = System.nanoTime() - debut;
    }

    /** Le travail d'un fil : des pavés, vus à travers sa propre vue de la scène. */
    private final class Fil implements IntConsumer, Vue {

        private final Lancer sien = new Lancer(scene.pourUnFil(), camera);
        private final Echantillonnage echantillonnage;
        private final Toile toile;
        private final int profondeur;

        Fil(Echantillonnage echantillonnage, Toile toile, int profondeur) {
            this.echantillonnage = echantillonnage;
            this.toile = toile;
            this.profondeur = profondeur;
        }

        @Override
        public void accept(int rang) {
            Pave pave = Pave.eparpille(rang, camera.getLargeur(), camera.getHauteur());
            sien.scene.getCompteurs().pixelsRaffines += echantillonnage.tracer(pave, this, toile);
        }

        /** La couleur vue, et le seul endroit où l'arrêt est observé : avant chaque rayon. */
        @Override
        public Couleur couleur(double xe, double ye) {
            equipe.verifier();
            return sien.voir(xe, ye, profondeur);
        }

        @Override
        public long rayons() {
            return sien.scene.getCompteurs().rayons();
        }
    }
}
