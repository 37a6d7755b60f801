package lancer.fils;

import java.util.concurrent.CancellationException;
import lancer.Couleur;
import lancer.Lancer;
import lancer.contrat.PixelFautif;
import lancer.contrat.Vue;

/** Vue d'un fil d'une équipe à travers l'écran : la couleur, ou un échec qui dit de quel pixel. */
public class Regard implements Vue {

    private final Equipe equipe;
    private final Lancer lancer;
    private final int profondeur;
    /** Registre des pixels qui échouent ; {@code null} s'ils sont refusés. */
    private final Fautes fautes;

    /**
     * @param equipe celle dont l'arrêt est observé avant chaque rayon de l'écran
     * @param lancer celui de ce fil seul, qui suit {@code profondeur} réflexions au plus
     * @param fautes où noter les pixels qui échouent ; {@code null} s'ils sont refusés
     */
    public Regard(Equipe equipe, Lancer lancer, int profondeur, Fautes fautes) {
        this.fautes = fautes;
        this.equipe = equipe;
        this.lancer = lancer;
        this.profondeur = profondeur;
    }

    /**
     * {@inheritDoc}
     *
     * @throws PixelFautif si ce calcul échoue, ou si une composante n'est pas un nombre fini, et que c'est refusé
     * @throws CancellationException si l'équipe est arrêtée
     */
    @Override
    public Couleur couleur(double xe, double ye) {
        equipe.verifier();
        try {
            Couleur vue = PixelFautif.verifier(lancer.getCouleurPixel(xe, ye, profondeur), xe, ye);
            if (fautes != null) {
                fautes.reussir();
            }
            return vue;
        } catch (OutOfMemoryError | CancellationException e) {
            // ce n'est pas la faute de ce pixel
            throw e;
        } catch (RuntimeException | Error e) {
            PixelFautif faute = e instanceof PixelFautif ? (PixelFautif) e : new PixelFautif(xe, ye, e);
            if (fautes == null) {
                throw faute;
            }
            return fautes.noter(faute);
        }
    }

    @Override
    public long rayons() {
        return lancer.getScene().getCompteurs().rayons();
    }
}
