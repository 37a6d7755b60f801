package lancer.fils;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.IntConsumer;
import java.util.function.Supplier;
import lancer.Couleur;
import lancer.contrat.Compteurs;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.PixelFautif;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/**
 * Les fils qui se partagent les pavés d'une image, avec leurs compteurs, leurs fautes et leur durée. Un atelier dessine
 * une image à la fois.
 */
public final class Atelier {

    private final int largeur;
    private final int hauteur;
    private final Equipe equipe = new Equipe();
    private final Fautes fautes;
    private Compteurs compteurs = new Compteurs();
    private long dureeNs;

    /** @param largeur celle de l'image, en pixels ; de même sa hauteur */
    public Atelier(int largeur, int hauteur) {
        this.largeur = largeur;
        this.hauteur = hauteur;
        fautes = new Fautes(largeur);
    }

    /**
     * Dessine tous les pixels de l'image.
     *
     * @param vues rend la vue de chaque fil
     * @param fils nombre de fils d'exécution, au moins 1
     * @throws CancellationException si le fil appelant est interrompu
     * @throws PixelFautif si un pixel ne peut être calculé
     */
    public void dessiner(Echantillonnage echantillonnage, Supplier<Vue> vues, Toile toile, int fils) {
        long debut = System.nanoTime();
        List<Pave> paves = Pave.battus(largeur, hauteur);
        List<Compteurs> comptes = new ArrayList<>();
        List<IntConsumer> travaux = new ArrayList<>();
        for (int fil = 0; fil < Math.min(fils, paves.size()); fil++) {
            Vue vue = vues.get();
            comptes.add(vue.compteurs());
            travaux.add(rang -> {
                Pave pave = paves.get(rang);
                vue.compteurs().pixelsRaffines += echantillonnage.tracer(pave, pave, vue, toile);
                fautes.peindre(pave, toile);
            });
        }
        equipe.faire(paves.size(), travaux);
        compteurs = new Compteurs();
        comptes.forEach(compteurs::ajouter);
        dureeNs = System.nanoTime() - debut;
    }

    /**
     * Rend la couleur calculée d'un point de l'écran.
     *
     * @throws PixelFautif si elle n'est pas finie
     * @throws CancellationException si le dessin est arrêté
     */
    public Couleur verifier(Couleur couleur, double xe, double ye) {
        equipe.obeir();
        return PixelFautif.exigerFinie(couleur, xe, ye);
    }

    /** Lève de nouveau cet échec d'un point de l'écran ou, s'il est toléré, rend une couleur à sa place. */
    public Couleur relever(Throwable echec, double xe, double ye) {
        // ni un arrêt ni le manque de mémoire n'est un échec du pixel
        if (echec instanceof CancellationException) {
            throw (CancellationException) echec;
        }
        if (echec instanceof OutOfMemoryError) {
            throw (OutOfMemoryError) echec;
        }
        return fautes.noter(echec, xe, ye);
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
}
