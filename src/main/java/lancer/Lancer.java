package lancer;

import java.util.concurrent.CancellationException;
import java.util.function.Supplier;
import lancer.contrat.Compteurs;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Modele;
import lancer.contrat.Pave;
import lancer.contrat.PixelFautif;
import lancer.contrat.Releve;
import lancer.contrat.Toile;
import lancer.contrat.Vue;
import lancer.fils.Atelier;
import lancer.fils.Fautes;

/**
 * L'algorithme qui dessine l'image d'une scène (cours, « Algorithme général »). Un {@link Atelier} découpe l'image en
 * pavés que se partagent des fils d'exécution ; elle ne dépend pas de leur nombre. Un lancer dessine une image à la
 * fois.
 */
public final class Lancer {

    private final Scene scene;
    private final Camera camera;
    private final Atelier atelier;

    public Lancer(Scene scene, Camera camera) {
        this(scene, camera, new Atelier(camera.getLargeur(), camera.getHauteur()));
    }

    private Lancer(Scene scene, Camera camera, Atelier atelier) {
        this.scene = scene;
        this.camera = camera;
        this.atelier = atelier;
    }

    /** Un lancer de la même scène, déjà préparée, dessinée selon ce modèle. */
    public Lancer avec(Modele modele) {
        return new Lancer(scene.avec(modele), camera);
    }

    /**
     * La couleur, dont les composantes peuvent dépasser 1, du point (xe, ye) de l'écran ({@link Camera#getRayon}).
     *
     * @param profondeur nombre de réflexions permises
     * @throws PixelFautif si le calcul échoue, sauf si {@link Fautes} le tolère
     * @throws CancellationException si le dessin est arrêté
     */
    public Couleur getCouleurPixel(double xe, double ye, int profondeur) {
        try {
            Rayon initial = camera.getRayon(xe, ye);
            Couleur couleur = scene.getCouleurVue(initial, null, profondeur);
            return atelier.verifier(couleur, xe, ye);
        } catch (RuntimeException | Error e) {
            return atelier.relever(e, xe, ye);
        }
    }

    /**
     * Dessine un brouillon si la toile en montre un, puis tous les pixels, selon l'échantillonnage de la scène.
     *
     * @param profondeur nombre de réflexions permises
     * @param fils nombre de fils d'exécution, au moins 1
     * @throws CancellationException si le fil appelant est interrompu
     * @throws PixelFautif si un pixel ne peut être calculé
     */
    public void TracerImage(Toile toile, int profondeur, int fils) {
        if (toile.montreUnBrouillon()) {
            TracerBrouillon(toile, profondeur, fils);
            toile.finirBrouillon();
        }
        atelier.dessiner(getEchantillonnage(), getVues(profondeur), toile, fils);
    }

    /** Dessine toute l'image en carrés de 4 × 4 pixels, chacun de la couleur de son centre, une réflexion au plus. */
    public void TracerBrouillon(Toile toile, int profondeur, int fils) {
        atelier.dessiner(Lancer::TracerCarres, getVues(Math.min(profondeur, Constantes.REFLETS_BROUILLON)), toile,
                fils);
    }

    /** L'échantillonnage de la scène : celui qu'une variante a choisi ou, à défaut, la double boucle du cours. */
    public Echantillonnage getEchantillonnage() {
        return scene.getModele().getEchantillonnage().orElse(Lancer::TracerPave);
    }

    /**
     * Dessine chaque pixel de la couleur de son centre : c'est la double boucle du cours, sur la partie voulue d'un
     * pavé, et l'échantillonnage d'une scène sans anticrénelage.
     *
     * @return {@link Releve#RIEN} : aucun pixel n'a plusieurs rayons
     */
    public static Releve TracerPave(Pave pave, Pave partie, Vue vue, Toile toile) {
        for (int ye = partie.j0; ye < partie.j1; ye++) {
            for (int xe = partie.i0; xe < partie.i1; xe++) {
                toile.drawPixel(vue.couleur(xe + 0.5, ye + 0.5), xe, ye);
            }
        }
        return Releve.RIEN;
    }

    private static Releve TracerCarres(Pave pave, Pave partie, Vue vue, Toile toile) {
        for (int ye = pave.j0; ye < pave.j1; ye += Constantes.PAS_BROUILLON) {
            for (int xe = pave.i0; xe < pave.i1; xe += Constantes.PAS_BROUILLON) {
                int yFin = Math.min(ye + Constantes.PAS_BROUILLON, pave.j1);
                int xFin = Math.min(xe + Constantes.PAS_BROUILLON, pave.i1);
                Couleur couleur = vue.couleur((xe + xFin) / 2.0, (ye + yFin) / 2.0);
                for (int y = ye; y < yFin; y++) {
                    for (int x = xe; x < xFin; x++) {
                        toile.drawPixel(couleur, x, y);
                    }
                }
            }
        }
        return Releve.RIEN;
    }

    /** Les vues des fils qui dessinent cette scène : chaque appel en rend une. */
    public Supplier<Vue> getVues(int profondeur) {
        return () -> getVueDUnFil(profondeur);
    }

    /** La vue d'un fil, par son propre lancer. */
    private Vue getVueDUnFil(int profondeur) {
        Lancer lancer = new Lancer(scene.pourUnFil(), camera, atelier);
        return new Vue() {
            @Override
            public Couleur couleur(double xe, double ye) {
                return lancer.getCouleurPixel(xe, ye, profondeur);
            }

            @Override
            public Compteurs compteurs() {
                return lancer.scene.getCompteurs();
            }
        };
    }

    /** Le dessin par plusieurs fils : avancement, fautes, compteurs, durée. */
    public Atelier getAtelier() {
        return atelier;
    }

    public Scene getScene() {
        return scene;
    }

    public Camera getCamera() {
        return camera;
    }
}
