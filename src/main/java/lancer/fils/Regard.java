package lancer.fils;

import java.util.concurrent.CancellationException;
import lancer.Couleur;
import lancer.Lancer;
import lancer.contrat.PixelFautif;
import lancer.contrat.Vue;

/** Vue d'un fil d'une équipe à travers l'écran : la couleur, ou un échec qui dit de quel pixel. */
public final class Regard implements Vue {

    private final Equipe equipe;
    private final Lancer lancer;
    private final int profondeur;

    /**
     * @param equipe celle dont l'arrêt est observé avant chaque rayon de l'écran
     * @param lancer celui de ce fil seul
     * @param profondeur nombre de réflexions permises
     */
    public Regard(Equipe equipe, Lancer lancer, int profondeur) {
        this.equipe = equipe;
        this.lancer = lancer;
        this.profondeur = profondeur;
    }

    /**
     * {@inheritDoc}
     *
     * @throws PixelFautif si ce calcul échoue, ou si une composante n'est pas un nombre fini
     * @throws CancellationException si l'équipe est arrêtée
     */
    @Override
    public Couleur couleur(double xe, double ye) {
        equipe.verifier();
        try {
            return PixelFautif.verifier(lancer.getCouleurPixel(xe, ye, profondeur), xe, ye);
        } catch (OutOfMemoryError | CancellationException | PixelFautif e) {
            // les deux premiers ne sont pas la faute de ce pixel
            throw e;
        } catch (RuntimeException | Error e) {
            throw new PixelFautif(xe, ye, e);
        }
    }

    @Override
    public long rayons() {
        return lancer.getScene().getCompteurs().rayons();
    }
}
