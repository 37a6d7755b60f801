package lancer.dessin;

import java.io.PrintStream;
import java.util.Collections;
import java.util.Locale;
import java.util.concurrent.CancellationException;
import lancer.Camera;
import lancer.Lancer;
import lancer.Scene;
import lancer.commande.Messages;
import lancer.commande.Reglages;
import lancer.contrat.Compteurs;
import lancer.contrat.PixelFautif;
import lancer.image.ImageMemoire;
import lancer.inspection.FaussesCouleurs;
import lancer.rapide.Preparation;
import lancer.rapide.Regard;

/** Ce qui est dessiné d'une demande : l'image, et le lancer qui la dessine, avec compteurs, temps et fautes. */
public final class Dessin {

    /** Nombre de pixels au-delà duquel la fenêtre ne garde pas les couleurs non limitées (48 Mo). */
    private static final int PIXELS_AVEC_LINEAIRE = 4_000_000;

    private static final double NS_PAR_MS = 1e6;

    private static final String CACHE = "un objet bouge, ou répond hors de son enveloppe ou selon l'ordre des "
            + "questions : ce sont les boucles sur tous les objets qui dessinent";

    public final Demande demande;
    public final ImageMemoire image;
    public final Lancer lancer;
    /** Le temps de la préparation, en nanosecondes. */
    private final long preparationNs;
    private final boolean cachait;
    private volatile boolean brouillonFait;

    /**
     * Prépare le dessin de cette demande.
     *
     * @throws CancellationException si ce fil est interrompu
     */
    public Dessin(Demande demande) {
        this(demande, new ImageMemoire(demande.largeur, demande.hauteur,
                (long) demande.largeur * demande.hauteur <= PIXELS_AVEC_LINEAIRE));
    }

    /** Prépare le dessin de cette demande dans cette image, de même taille. */
    public Dessin(Demande demande, ImageMemoire image) {
        this.demande = demande;
        this.image = image;
        Scene scene = demande.getScene();
        Camera camera = scene.getCamera(image.largeur, image.hauteur);
        long debut = System.nanoTime();
        Scene preparee = demande.reglages.isSimple() ? scene : Preparation.preparer(scene, camera);
        preparationNs = System.nanoTime() - debut;
        cachait = Regard.trouveUneReponseCachee(preparee, camera);
        lancer = new Lancer(cachait ? scene : preparee, camera);
    }

    private Dessin(Dessin prepare, Demande demande, ImageMemoire image) {
        this.demande = demande;
        this.image = image;
        lancer = prepare.lancer.avec(demande.reglages.getModele());
        preparationNs = 0;
        cachait = prepare.cachait;
    }

    /** Le dessin de la même scène, déjà préparée, avec ces autres réglages, dans une nouvelle image. */
    public Dessin avecReglages(Reglages reglages) {
        return new Dessin(this, demande.avecReglages(reglages), new ImageMemoire(image.largeur, image.hauteur, true));
    }

    /** Le lancer d'une scène, préparée pour une image de cette taille. @param simple voir {@link Reglages#isSimple} */
    public static Lancer lancer(Scene scene, int largeur, int hauteur, boolean simple) {
        Camera camera = scene.getCamera(largeur, hauteur);
        return new Lancer(simple ? scene : Preparation.preparer(scene, camera), camera);
    }

    /** Dessine le brouillon, puis la vue demandée. @param reference celle de la vue « difference », ou {@code null} */
    public void dessinerLaVue(ImageMemoire reference, int fils, Runnable siBrouillonFait) {
        lancer.getAtelier().getFautes().tolerer();
        try {
            lancer.TracerBrouillon(image, demande.reglages.getProfondeur(), fils);
            finirBrouillon();
            siBrouillonFait.run();
            new FaussesCouleurs(lancer, demande.reglages.getProfondeur(), fils).dessiner(demande.vue, image);
        } catch (PixelFautif e) {
            throw demande.nommer(e);
        }
    }

    public void finirBrouillon() {
        brouillonFait = true;
    }

    /** Dit si chaque pixel a une couleur : le brouillon est fini. */
    public boolean isBrouillonFait() {
        return brouillonFait;
    }

    /** Une phrase, si la recherche cachait une réponse : tous les objets sont alors demandés ; {@code null} sinon. */
    public String getEcart() {
        return cachait ? CACHE : null;
    }

    /** Avertit de {@link #getEcart}. */
    public void direEcart(PrintStream erreur) {
        if (getEcart() != null) {
            Messages.avertir(Collections.singletonList(getEcart()), erreur);
        }
    }

    /** Le nombre de rayons et le temps de ce dessin achevé. */
    public String getCout() {
        // l'espace fine insécable manque à beaucoup de polices
        return String.format(Locale.FRANCE, "%,d rayons en %.2f s", lancer.getAtelier().getCompteurs().rayons(),
                lancer.getAtelier().getDureeNs() / 1e9).replace('\u202F', '\u00A0');
    }

    /**
     * Texte de {@code --statistiques} : compteurs d'un dessin, et temps. Les nombres ont un point décimal, sans
     * séparateur de milliers ni exposant, quelle que soit la langue de la machine.
     *
     * @param acheve le lancer qui a dessiné l'image
     * @param tracesNs le temps de chaque dessin, dans l'ordre, en nanosecondes
     */
    public String statistiques(Lancer acheve, long... tracesNs) {
        Compteurs c = acheve.getAtelier().getCompteurs();
        double traceNs = new Durees(tracesNs).getMediane();
        return String.format(Locale.ROOT, "rayons.primaires: %d\nrayons.ombre: %d\nrayons.reflechis: %d\n"
                + "tests.spheres: %d\nnoeuds.visites: %d\npixels.raffines: %d\n"
                + "lecture.ms: %.3f\npreparation.ms: %.3f\ntrace.ms: %.3f\nrayons.par.seconde: %d",
                c.primaires, c.ombre, c.reflechis, c.testsSpheres, c.noeudsVisites,
                c.pixelsRaffines, demande.lecture.dureeNs / NS_PAR_MS,
                preparationNs / NS_PAR_MS,
                traceNs / NS_PAR_MS, Math.round(c.rayons() / (Math.max(traceNs, 1) / 1e9)));
    }
}
