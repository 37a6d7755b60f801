package lancer.dessin;

import java.util.Locale;
import java.util.concurrent.CancellationException;
import lancer.Camera;
import lancer.Lancer;
import lancer.Scene;
import lancer.auto.Auto;
import lancer.auto.Echelle;
import lancer.commande.Option;
import lancer.commande.Reglages;
import lancer.contrat.PixelFautif;
import lancer.contrat.Toile;
import lancer.fils.Atelier;
import lancer.image.ImageMemoire;
import lancer.inspection.FaussesCouleurs;
import lancer.rapide.Preparation;
import lancer.rapide.Regard;
import lancer.systeme.Echec;

/** Ce qui est dessiné d'une demande : l'image, et le lancer qui la dessine, avec compteurs, temps et fautes. */
public final class Dessin {

    /** Nombre de pixels au-delà duquel la fenêtre ne garde pas les couleurs non limitées (48 Mo). */
    private static final int PIXELS_AVEC_LINEAIRE = 4_000_000;

    /** Environ : images qu'une fenêtre dessinera d'une scène, et rayons par pixel d'un échantillonnage. */
    private static final int IMAGES_D_UNE_FENETRE = 10;
    private static final int RAYONS_ECHANTILLONNES = 4;

    private static final double NS_PAR_S = 1e9;

    public final Demande demande;
    public final ImageMemoire image;
    /** Le lancer de cette demande, préparé. */
    public final Lancer lancer;
    /** Une phrase, si ce sont les boucles qui dessinent malgré la recherche ; {@code null} sinon. */
    public final String ecart;
    /** Celui qui a dessiné l'image en dernier : le même, ou celui d'autres réglages. */
    volatile Lancer dernier;
    /** Ce que {@code --auto} choisit ; {@code null} sans lui. */
    Auto auto;
    /** Le temps de la préparation, puis celui de chaque dessin, en nanosecondes. */
    final long preparationNs;
    long[] tracesNs;

    private Dessin(Demande demande, Lancer lancer, String ecart, long preparationNs) {
        this.demande = demande;
        this.lancer = lancer;
        this.ecart = ecart;
        this.preparationNs = preparationNs;
        image = image(demande);
        dernier = lancer;
    }

    /**
     * Prépare le dessin de cette demande : ce qui cherche les objets est construit, puis comparé à tous les objets.
     *
     * @throws CancellationException si ce fil est interrompu
     */
    public static Dessin preparer(Demande demande) {
        Scene scene = demande.getScene();
        Camera camera = scene.getCamera(demande.largeur, demande.hauteur);
        long debut = System.nanoTime();
        Scene preparee = demande.reglages.get(Option.SIMPLE) ? scene
                : Preparation.preparer(scene, camera, rayons(demande));
        long preparationNs = System.nanoTime() - debut;
        String ecart = preparee == scene ? null : Regard.regarder(preparee, camera);
        return new Dessin(demande, new Lancer(ecart == null ? preparee : scene, camera), ecart, preparationNs);
    }

    /** Nombre de rayons de l'écran à venir, à peu près. */
    private static long rayons(Demande demande) {
        Reglages options = demande.reglages;
        boolean plusieurs = options.estDonnee(Option.AUTO) || options.getModele().getEchantillonnage().isPresent();
        int images = options.sansFenetre() ? options.get(Option.REPETER) : IMAGES_D_UNE_FENETRE;
        return (long) demande.largeur * demande.hauteur * images * (plusieurs ? RAYONS_ECHANTILLONNES : 1);
    }

    /** L'image à dessiner, sans ce qu'un fichier ne demande pas. */
    private static ImageMemoire image(Demande demande) {
        Reglages options = demande.reglages;
        boolean avecCodes = options.estDonnee(Option.IMAGE) || !options.estDonnee(Option.LINEAIRE);
        boolean avecLineaire = options.sansFenetre()
                ? options.estDonnee(Option.LINEAIRE) || options.estDonnee(Option.AUTO)
                        || options.estDonnee(Option.COMPARER)
                : (long) demande.largeur * demande.hauteur <= PIXELS_AVEC_LINEAIRE;
        return new ImageMemoire(demande.largeur, demande.hauteur, avecCodes, avecLineaire);
    }

    /** Le lancer d'une scène, préparée pour une image de cette taille. @param simple voir {@link Option#SIMPLE} */
    public static Lancer lancer(Scene scene, int largeur, int hauteur, boolean simple) {
        Camera camera = scene.getCamera(largeur, hauteur);
        return new Lancer(simple ? scene : Preparation.preparer(scene, camera, (long) largeur * hauteur), camera);
    }

    /**
     * Dessine ce qui est demandé sur cette toile, {@code --repeter} fois : l'image, ou une vue en fausses couleurs.
     * Avec {@code --auto}, dessine avec les réglages qu'il choisit, puis mesure l'erreur de l'image.
     *
     * @throws Echec si un pixel ne peut être calculé, et si ce n'est pas toléré
     */
    public void tracer(Toile toile) {
        try {
            if (demande.vue != null) {
                tracerLaVue(toile);
                return;
            }
            auto = demande.reglages.estDonnee(Option.AUTO) ? choisir() : null;
            do {
                Reglages reglages = auto == null ? demande.reglages : auto.getChoisi();
                dernier = auto == null ? lancer : auto.getLancer();
                // une fenêtre montre un seul dessin
                tracesNs = new long[reglages.sansFenetre() ? reglages.get(Option.REPETER) : 1];
                for (int k = 0; k < tracesNs.length; k++) {
                    dernier.TracerImage(toile, reglages.getProfondeur(), reglages.get(Option.FILS));
                    tracesNs[k] = dernier.getAtelier().getDureeNs();
                }
            } while (auto != null && !auto.controler(image::getCouleur));
        } catch (PixelFautif e) {
            throw demande.nommer(e);
        }
    }

    /** Dessine l'image de la scène préparée, selon ces autres réglages. @return le temps du dessin, en nanosecondes */
    public long tracer(Reglages reglages, Toile toile) {
        dernier = lancer.avec(reglages.getModele());
        dernier.TracerImage(toile, reglages.getProfondeur(), reglages.get(Option.FILS));
        tracesNs = new long[] {dernier.getAtelier().getDureeNs()};
        return tracesNs[0];
    }

    private void tracerLaVue(Toile toile) {
        int profondeur = demande.reglages.getProfondeur();
        int fils = demande.reglages.get(Option.FILS);
        if (toile.montreUnBrouillon()) {
            lancer.TracerBrouillon(toile, profondeur, fils);
            toile.finirBrouillon();
        }
        new FaussesCouleurs(lancer, image, profondeur, fils).dessiner(demande.vue);
        tracesNs = new long[] {lancer.getAtelier().getDureeNs()};
    }

    private Auto choisir() {
        Reglages options = demande.reglages;
        return new Auto(lancer, Echelle.de(options, options.estDonnee(Option.REFLETS), options.estDonnee(Option.SEUIL)),
                options.get(Option.AUTO), options.get(Option.FILS));
    }

    /** Voir {@link Atelier#seRegardeDeuxFois}. L'image qui n'est pas encore dessinée est regardée une première fois. */
    public boolean seRegardeDeuxFois() {
        if (tracesNs != null && demande.vue == null) {
            return dernier.getAtelier().seRegardeDeuxFois();
        }
        Lancer premier = lancer.avec(demande.reglages.getModele());
        premier.getAtelier().getFautes().tolerer();
        return premier.getAtelier().regarder(premier.getEchantillonnage(),
                premier.getVues(demande.reglages.getProfondeur()), demande.reglages.get(Option.FILS));
    }

    /** La part dessinée de l'image en cours, de 0 à 1. */
    public double getAvancement() {
        return dernier.getAtelier().getAvancement();
    }

    /** Le nombre de rayons et le temps de ce dessin achevé. */
    public String getCout() {
        // l'espace fine insécable manque à beaucoup de polices
        return String.format(Locale.FRANCE, "%,d rayons en %.2f s", dernier.getAtelier().getCompteurs().rayons(),
                dernier.getAtelier().getDureeNs() / NS_PAR_S).replace('\u202F', '\u00A0');
    }
}
