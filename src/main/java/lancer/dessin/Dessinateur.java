package lancer.dessin;

import java.io.PrintStream;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.function.DoubleConsumer;
import lancer.SceneFautive;
import lancer.commande.Echec;
import lancer.commande.Options;
import lancer.commande.Pannes;
import lancer.contrat.Compteurs;
import lancer.contrat.Modele;
import lancer.contrat.PixelFautif;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.fils.Traceur;
import lancer.image.ImageMemoire;
import lancer.scene.LecteurScene;
import lancer.scene.Origines;

/**
 * Réglages de la scène du programme, sa préparation, et l'image qu'on en dessine. Un fil lit et dessine ; d'autres
 * regardent.
 */
public final class Dessinateur {

    /** Taille d'image au-delà de laquelle la fenêtre ne garde pas les couleurs non limitées : 48 Mo. */
    private static final int PIXELS_AVEC_LINEAIRE = 4_000_000;

    private static final double NS_PAR_MS = 1e6;

    final Programme programme;
    final Options options;
    final PrintStream sortie;
    final PrintStream erreur;
    private volatile Origines origines;
    private volatile String fichier;
    private volatile ReglagesDessin reglages;
    /** L'image en cours et ce qui la dessine ; {@code null} tant que la scène ne se dessine pas. */
    private volatile Dessin dessin;
    private volatile double avancement;
    // une classe, car la première lambda d'un programme coûte cher à son démarrage
    private final DoubleConsumer suivi = new DoubleConsumer() {
        @Override
        public void accept(double part) {
            avancement = part;
        }
    };
    private long lectureNs;
    private long preparationNs;

    /** @param programme ce qui lit la scène et reçoit les pixels */
    public Dessinateur(Programme programme, Options options, PrintStream sortie, PrintStream erreur) {
        this.programme = programme;
        this.options = options;
        this.sortie = sortie;
        this.erreur = erreur;
    }

    /** Dit, si c'est le cas, que la recherche rapide ne répondait pas comme les classes du cours. */
    void direEcart(Traceur dessine) {
        if (dessine.getEcart() != null) {
            Pannes.avertir(Collections.singletonList(dessine.getEcart()), erreur);
        }
    }

    /**
     * Lit une scène, qui devient celle à dessiner.
     *
     * @param nomFichier voir {@link lancer.Scene#Scene(String)}
     * @return ce que la lecture a laissé de côté, une ligne chacun
     * @throws SceneFautive si elle ne peut être utilisée ; la précédente reste alors en place
     * @throws CancellationException si ce fil a été interrompu ; la précédente reste aussi
     */
    public List<String> lireScene(String nomFichier) {
        avancement = 0;
        long debut = System.nanoTime();
        Lecture lecture = new Lecture();
        programme.lireScene(nomFichier, lecture);
        lectureNs = System.nanoTime() - debut;
        fichier = nomFichier;
        origines = lecture.origines;
        remplacer(lecture.reglages);
        return lecture.avertissements;
    }

    /** Une lecture, qui dit où elle en est et installe les variantes selon la ligne de commande. */
    private final class Lecture extends LecteurScene {

        private ReglagesDessin reglages;

        @Override
        public void avancer(double part) {
            avancement = part;
        }

        @Override
        protected Modele installer(Map<Variante, Section> variantes) {
            reglages = ReglagesDessin.de(variantes, options);
            Modele modele = reglages.getModele();
            reglages.verifier(options);
            if (Thread.currentThread().isInterrupted()) {
                throw new CancellationException("lecture abandonnée : la scène d'avant reste");
            }
            return modele;
        }
    }

    /** De quelles sections viennent les objets et les lampes de la scène lue. */
    public Origines getOrigines() {
        return origines;
    }

    /** La part faite de la lecture, ou de la préparation, de 0 à 1. */
    public double getAvancement() {
        return avancement;
    }

    /** Réglages de la scène lue, tant que {@link #regler} n'en dit pas plus. */
    public ReglagesDessin getReglages() {
        return reglages;
    }

    /**
     * Règle la scène lue, jusqu'à la suivante.
     *
     * @throws SceneFautive si ces réglages ne vont pas ; rien n'est alors changé
     */
    public void regler(ReglagesDessin voulus) {
        programme.regler(voulus.getModele());
        remplacer(voulus);
    }

    /** Le dessin d'avant n'est pas celui de la nouvelle scène, même avant qu'elle ne se prépare. */
    private void remplacer(ReglagesDessin siens) {
        dessin = null;
        avancement = 0;
        reglages = siens;
    }

    /** Fait dessiner la scène au programme. */
    public void doTracerImage(int largeur, int hauteur) {
        programme.doTracerImage(largeur, hauteur);
    }

    /** Prépare la scène pour une image de cette taille, que garde la fenêtre. */
    public Traceur preparer(int largeur, int hauteur) {
        return preparer(new ImageMemoire(largeur, hauteur, (long) largeur * hauteur <= PIXELS_AVEC_LINEAIRE));
    }

    /** Rapporte un dessin achevé : l'écart qu'ont vu ses témoins, ses nombres s'ils sont demandés. */
    public void rapporter(Traceur acheve) {
        direEcart(acheve);
        if (options.statistiques) {
            sortie.println(statistiques(acheve, acheve.getDureeNs()));
            sortie.flush();
        }
    }

    /** Prépare la scène lue pour une image, qui devient celle que l'on dessine. */
    Traceur preparer(ImageMemoire vierge) {
        dessin = null;
        avancement = 0;
        long debut = System.nanoTime();
        Traceur nouveau = LancerSurveille.preparer(programme.getScene(), vierge.getLargeur(), vierge.getHauteur(),
                options.simple, suivi);
        preparationNs = System.nanoTime() - debut;
        dessin = new Dessin(fichier, origines, reglages, vierge, nouveau);
        return nouveau;
    }

    /** L'image qui se dessine, ou s'est dessinée ; {@code null} tant que la scène ne se dessine pas. */
    public ImageMemoire getImage() {
        return dessin == null ? null : dessin.image;
    }

    /** L'image de la scène lue, ainsi réglée, avec ce qui la dessine ; {@code null} tant qu'elle ne se dessine pas. */
    public Dessin getDessin() {
        return dessin;
    }

    /** Traceur de la scène lue, ainsi réglée ; {@code null} tant qu'elle ne se dessine pas. */
    public Traceur getTraceur() {
        return dessin == null ? null : dessin.traceur;
    }

    /**
     * Texte de {@code --statistiques} : comptes d'un dessin, et temps. Toujours avec un point décimal, sans
     * séparateur de milliers ni exposant, quelle que soit la langue de la machine.
     *
     * @param tracesNs le temps de chaque dessin, dans l'ordre, en nanosecondes
     */
    String statistiques(Traceur dessine, long... tracesNs) {
        Compteurs c = dessine.getCompteurs();
        double traceNs = mediane(tracesNs);
        return String.format(Locale.ROOT, "rayons.primaires: %d\nrayons.ombre: %d\nrayons.reflechis: %d\n"
                + "tests.spheres: %d\ntests.precis: %d\nnoeuds.visites: %d\npixels.raffines: %d\n"
                + "pixels.temoins: %d\n"
                + "lecture.ms: %.3f\npreparation.ms: %.3f\ntrace.ms: %.3f\nrayons.par.seconde: %d",
                c.primaires, c.ombre, c.reflechis, c.testsSpheres, c.testsPrecis, c.noeudsVisites,
                c.pixelsRaffines, c.pixelsTemoins, lectureNs / NS_PAR_MS,
                (preparationNs + dessine.getConstructionNs()) / NS_PAR_MS,
                traceNs / NS_PAR_MS, Math.round(c.rayons() / (Math.max(traceNs, 1) / 1e9)));
    }

    /** La médiane de la seconde moitié : au début, la machine virtuelle compile encore. */
    private static double mediane(long[] temps) {
        long[] tries = Arrays.copyOfRange(temps, temps.length / 2, temps.length);
        Arrays.sort(tries);
        return (tries[(tries.length - 1) / 2] + tries[tries.length / 2]) / 2.0;
    }

    /** Échec à dire d'un pixel de la scène lue qui n'a pu être calculé. */
    public Echec nommer(PixelFautif panne) {
        ImageMemoire image = getImage();
        int largeur = image == null ? options.largeur : image.getLargeur();
        int hauteur = image == null ? options.hauteur : image.getHauteur();
        PixelFautif situee = Diagnostic.situer(panne, programme.getScene());
        return Echec.panne(Pannes.duPixel(situee, reglages.getOptions(), fichier, largeur, hauteur));
    }
}
