package lancer;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.IntConsumer;
import lancer.contrat.Compteurs;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Modele;
import lancer.contrat.Pave;
import lancer.contrat.PixelFautif;
import lancer.contrat.Toile;
import lancer.contrat.Vue;
import lancer.fils.Equipe;
import lancer.fils.Fautes;

/**
 * L'algorithme qui dessine l'image d'une scène (cours, « Algorithme général »). L'image est découpée en pavés que
 * plusieurs fils se partagent ; elle ne dépend pas de leur nombre. Un lancer dessine une image à la fois.
 */
public final class Lancer {

    private final Scene scene;
    private final Camera camera;
    private final Equipe equipe;
    private final Fautes fautes;
    private Compteurs compteurs = new Compteurs();
    private long dureeNs;

    public Lancer(Scene scene, Camera camera) {
        this.scene = scene;
        this.camera = camera;
        equipe = new Equipe("lancer");
        fautes = new Fautes(camera.getLargeur());
    }

    /** Un lancer de la même scène, déjà préparée, dessinée selon ce modèle. */
    public Lancer avec(Modele modele) {
        modele.setRecherche(scene.getModele().getRecherche());
        return new Lancer(scene.avec(modele), camera);
    }

    /** Le lancer d'un fil, avec sa propre scène. */
    private Lancer(Lancer autre) {
        scene = autre.scene.avec(autre.scene.getModele());
        camera = autre.camera;
        equipe = autre.equipe;
        fautes = autre.fautes;
    }

    /**
     * Dessine un brouillon, un rayon pour 4 × 4 pixels et une réflexion au plus, puis tous les pixels.
     *
     * @param profondeur nombre de réflexions permises
     * @param fils nombre de fils d'exécution, au moins 1
     * @throws CancellationException si le fil appelant est interrompu
     * @throws PixelFautif si un pixel ne peut être calculé
     */
    public void TracerImage(Toile toile, int profondeur, int fils) {
        TracerBrouillon(toile, profondeur, fils);
        toile.finirBrouillon();
        TracerPixels(toile, profondeur, fils);
    }

    /** Dessine toute l'image en carrés de 4 × 4 pixels, chacun de la couleur de son centre, une réflexion au plus. */
    public void TracerBrouillon(Toile toile, int profondeur, int fils) {
        TracerPixels(Lancer::brouillon, toile, Math.min(profondeur, Constantes.REFLETS_BROUILLON), fils);
    }

    /** Dessine tous les pixels, selon l'échantillonnage de la scène. */
    public void TracerPixels(Toile toile, int profondeur, int fils) {
        TracerPixels(scene.getModele().getEchantillonnage(), toile, profondeur, fils);
    }

    /** Dessine tous les pixels selon cet échantillonnage, par des fils qui ont chacun leur lancer. */
    public void TracerPixels(Echantillonnage choisi, Toile toile, int profondeur, int fils) {
        Echantillonnage prepare = choisi == null ? null : choisi.pour(scene.getObjets(), camera);
        long debut = System.nanoTime();
        List<Pave> paves = Pave.battus(camera.getLargeur(), camera.getHauteur());
        List<Lancer> siens = new ArrayList<>();
        List<IntConsumer> travaux = new ArrayList<>();
        for (int fil = 0; fil < Math.min(fils, paves.size()); fil++) {
            Lancer sien = new Lancer(this);
            siens.add(sien);
            travaux.add(rang -> sien.tracer(paves.get(rang), prepare, toile, profondeur));
        }
        equipe.faire(paves.size(), travaux);
        Compteurs total = new Compteurs();
        for (Lancer sien : siens) {
            total.ajouter(sien.scene.getCompteurs());
        }
        compteurs = total;
        dureeNs = System.nanoTime() - debut;
    }

    /** Dessine un pavé dans un fil, dont ce lancer est à lui seul. */
    private void tracer(Pave pave, Echantillonnage prepare, Toile toile, int profondeur) {
        TracerPixels(pave, pave, prepare, toile, profondeur);
        fautes.peindre(pave, toile);
    }

    private static int brouillon(Pave pave, Pave voulus, Vue vue, Toile toile) {
        for (int j = pave.j0; j < pave.j1; j += Constantes.PAS_BROUILLON) {
            int jFin = Math.min(j + Constantes.PAS_BROUILLON, pave.j1);
            for (int i = pave.i0; i < pave.i1; i += Constantes.PAS_BROUILLON) {
                int iFin = Math.min(i + Constantes.PAS_BROUILLON, pave.i1);
                Couleur couleur = vue.couleur((i + iFin) / 2.0, (j + jFin) / 2.0);
                for (int y = j; y < jFin; y++) {
                    for (int x = i; x < iFin; x++) {
                        toile.drawPixel(couleur, x, y);
                    }
                }
            }
        }
        return 0;
    }

    /** Dessine ces pixels d'un pavé. @param prepare échantillonnage, {@code null} pour un rayon au centre de chacun */
    public void TracerPixels(Pave pave, Pave voulus, Echantillonnage prepare, Toile toile, int profondeur) {
        if (prepare != null) {
            scene.getCompteurs().pixelsRaffines += prepare.tracer(pave, voulus, vue(profondeur), toile);
            return;
        }
        for (int j = voulus.j0; j < voulus.j1; j++) {
            for (int i = voulus.i0; i < voulus.i1; i++) {
                toile.drawPixel(getCouleurPixel(i + 0.5, j + 0.5, profondeur), i, j);
            }
        }
    }

    /**
     * La couleur, non limitée, du point (xe, ye) de l'écran ({@link Camera#getRayon}).
     *
     * @param profondeur nombre de réflexions permises
     * @throws PixelFautif si le calcul échoue ou rend une couleur qui n'est pas finie, sauf si {@link Fautes} le
     *     tolère
     * @throws CancellationException si le dessin est arrêté
     */
    public Couleur getCouleurPixel(double xe, double ye, int profondeur) {
        scene.getCompteurs().primaires++;
        try {
            Rayon initial = camera.getRayon(xe, ye);
            Couleur vue = scene.getCouleurVue(initial, null, profondeur);
            equipe.obeir();
            return PixelFautif.exigerFinie(vue, xe, ye);
        } catch (CancellationException | OutOfMemoryError e) {
            // ni un arrêt ni le manque de mémoire n'est un échec du pixel
            throw e;
        } catch (RuntimeException | Error e) {
            return fautes.noter(e, xe, ye);
        }
    }

    private Vue vue(int profondeur) {
        return new Vue() {
            @Override
            public Couleur couleur(double xe, double ye) {
                return getCouleurPixel(xe, ye, profondeur);
            }

            @Override
            public Compteurs compteurs() {
                return scene.getCompteurs();
            }
        };
    }

    /** La part dessinée de l'image (ou du brouillon) en cours, de 0 à 1. */
    public double getAvancement() {
        return equipe.getAvancement();
    }

    /** Les pixels dont le calcul a échoué, s'ils sont tolérés. */
    public Fautes getFautes() {
        return fautes;
    }

    /** Compteurs du dernier dessin achevé, sommés sur tous les fils. */
    public Compteurs getCompteurs() {
        return compteurs;
    }

    /** Le temps du dernier dessin achevé, en nanosecondes. */
    public long getDureeNs() {
        return dureeNs;
    }

    public Scene getScene() {
        return scene;
    }

    public Camera getCamera() {
        return camera;
    }
}
