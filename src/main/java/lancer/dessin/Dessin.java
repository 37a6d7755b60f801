package lancer.dessin;

import java.io.PrintStream;
import java.util.Locale;
import java.util.concurrent.CancellationException;
import lancer.Camera;
import lancer.Lancer;
import lancer.Scene;
import lancer.auto.Auto;
import lancer.auto.Echelle;
import lancer.auto.Mesure;
import lancer.commande.Messages;
import lancer.commande.Option;
import lancer.commande.Reglages;
import lancer.contrat.Compteurs;
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

    private static final double NS_PAR_MS = 1e6;
    private static final double NS_PAR_S = 1e9;

    public final Demande demande;
    public final ImageMemoire image;
    /** Le lancer de cette demande, préparé. */
    public final Lancer lancer;
    /** Une phrase, si la recherche cachait une réponse : tous les objets sont alors demandés ; {@code null} sinon. */
    public final String ecart;
    /** Celui qui a dessiné l'image en dernier : le même, ou celui d'autres réglages. */
    private volatile Lancer dernier;
    private Auto auto;
    /** Le temps de la préparation, puis celui de chaque dessin, en nanosecondes. */
    private final long preparationNs;
    private long[] tracesNs;

    /**
     * Prépare le dessin de cette demande.
     *
     * @throws CancellationException si ce fil est interrompu
     */
    public Dessin(Demande demande) {
        this.demande = demande;
        image = image(demande);
        Scene scene = demande.getScene();
        Camera camera = scene.getCamera(image.largeur, image.hauteur);
        long debut = System.nanoTime();
        Scene preparee = demande.reglages.get(Option.SIMPLE) ? scene : Preparation.preparer(scene, camera);
        preparationNs = System.nanoTime() - debut;
        boolean cachait = preparee != scene && Regard.trouveUneReponseCachee(preparee, camera);
        lancer = new Lancer(cachait ? scene : preparee, camera);
        ecart = !cachait ? null : "un objet bouge, ou répond hors de son enveloppe ou selon l'ordre des questions : "
                + "ce sont les boucles sur tous les objets qui dessinent";
        dernier = lancer;
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
        return new Lancer(simple ? scene : Preparation.preparer(scene, camera), camera);
    }

    /**
     * Dessine ce qui est demandé sur cette toile, {@code --repeter} fois.
     *
     * @throws Echec si un pixel ne peut être calculé, et si ce n'est pas toléré
     */
    public void tracer(Toile toile) {
        try {
            if (demande.vue != null) {
                tracerLaVue(toile);
            } else if (demande.reglages.estDonnee(Option.AUTO)) {
                choisirEtTracer(toile);
            } else {
                tracer(demande.reglages, lancer, toile);
            }
        } catch (PixelFautif e) {
            throw demande.nommer(e);
        }
    }

    /** Dessine l'image de la scène préparée, selon ces autres réglages. @return le temps du dernier dessin */
    public long tracer(Reglages autres, Toile toile) {
        tracer(autres, lancer.avec(autres.getModele()), toile);
        return dernier.getAtelier().getDureeNs();
    }

    private void tracer(Reglages reglages, Lancer celui, Toile toile) {
        dernier = celui;
        // une fenêtre montre un seul dessin
        tracesNs = new long[demande.reglages.sansFenetre() ? reglages.get(Option.REPETER) : 1];
        for (int k = 0; k < tracesNs.length; k++) {
            celui.TracerImage(toile, reglages.getProfondeur(), reglages.get(Option.FILS));
            tracesNs[k] = celui.getAtelier().getDureeNs();
        }
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

    /** Dessine avec les réglages que {@code --auto} choisit, puis mesure l'erreur de l'image. */
    private void choisirEtTracer(Toile toile) {
        Reglages options = demande.reglages;
        auto = new Auto(lancer, Echelle.de(demande.reglages, options.estDonnee(Option.REFLETS),
                options.estDonnee(Option.SEUIL)), options.get(Option.AUTO), options.get(Option.FILS));
        do {
            tracer(auto.getChoisi(), auto.getLancer(), toile);
        } while (!auto.controler(image::getCouleur));
    }

    /** Voir {@link Atelier#seRegardeDeuxFois}. Une image qui n'est pas celle dessinée est regardée une première fois. */
    public boolean seRegardeDeuxFois() {
        if (tracesNs != null && demande.vue == null) {
            return dernier.getAtelier().seRegardeDeuxFois();
        }
        Lancer autre = lancer.avec(demande.reglages.getModele());
        autre.getAtelier().getFautes().tolerer();
        return autre.regarder(demande.reglages.getProfondeur(), demande.reglages.get(Option.FILS));
    }

    /** La part dessinée de l'image en cours, de 0 à 1. */
    public double getAvancement() {
        return dernier.getAtelier().getAvancement();
    }

    /** Dit ce qu'il faut de ce dessin achevé : statistiques demandées, réglages choisis, {@link #ecart}. */
    public Dessin rapporter(PrintStream sortie, PrintStream erreur) {
        if (demande.reglages.get(Option.STATISTIQUES)) {
            Messages.repondre(getStatistiques(), sortie);
        }
        if (auto != null) {
            String mesure = auto.getMesure().enMots() + (auto.getMesure().rienVu ? "" : " ; " + auto.getVerdict());
            Messages.avertir("auto, choisi : " + Echelle.dire(auto.getChoisi()), erreur);
            Messages.avertir("auto, mesuré : " + mesure, erreur);
        }
        if (ecart != null) {
            Messages.avertir(ecart, erreur);
        }
        return this;
    }

    /** Le nombre de rayons et le temps de ce dessin achevé. */
    public String getCout() {
        // l'espace fine insécable manque à beaucoup de polices
        return String.format(Locale.FRANCE, "%,d rayons en %.2f s", dernier.getAtelier().getCompteurs().rayons(),
                dernier.getAtelier().getDureeNs() / NS_PAR_S).replace('\u202F', '\u00A0');
    }

    /**
     * Texte de {@code --statistiques} : compteurs d'un dessin, temps, choix de {@code --auto}. Les nombres ont un point
     * décimal, sans séparateur de milliers ni exposant, quelle que soit la langue de la machine.
     */
    private String getStatistiques() {
        Compteurs c = dernier.getAtelier().getCompteurs();
        double traceNs = new Durees(tracesNs).getMediane();
        String texte = String.format(Locale.ROOT, "rayons.primaires: %d\nrayons.ombre: %d\nrayons.reflechis: %d\n"
                + "tests.spheres: %d\nnoeuds.visites: %d\npixels.raffines: %d\n"
                + "lecture.ms: %.3f\npreparation.ms: %.3f\ntrace.ms: %.3f\nrayons.par.seconde: %d",
                c.primaires, c.ombre, c.reflechis, c.testsSpheres, c.noeudsVisites,
                c.pixelsRaffines, demande.lue.getDureeNs() / NS_PAR_MS, preparationNs / NS_PAR_MS,
                traceNs / NS_PAR_MS, Math.round(c.rayons() / (Math.max(traceNs, 1) / NS_PAR_S)));
        if (auto == null) {
            return texte;
        }
        Mesure mesure = auto.getMesure();
        String incertitude = mesure.rienVu ? ""
                : String.format(Locale.ROOT, "auto.erreur.incertitude: %.2f%n", mesure.incertitude);
        return texte + String.format(Locale.ROOT, "%nauto.erreur.mesuree: %.2f%n%sauto.rayons.essais: %d",
                mesure.erreur, incertitude, auto.getRayonsDesEssais());
    }
}
