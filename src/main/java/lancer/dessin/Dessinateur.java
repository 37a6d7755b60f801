package lancer.dessin;

import java.io.PrintStream;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.function.DoubleConsumer;
import lancer.Scene;
import lancer.SceneFautive;
import lancer.commande.Echec;
import lancer.commande.Options;
import lancer.commande.Pannes;
import lancer.contrat.Compteurs;
import lancer.contrat.Modele;
import lancer.contrat.PixelFautif;
import lancer.contrat.Section;
import lancer.contrat.Toile;
import lancer.contrat.Variante;
import lancer.fils.Traceur;
import lancer.image.ImageMemoire;
import lancer.scene.LecteurScene;
import lancer.scene.Origines;
import lancer.temoins.LancerSurveille;

/** Une scène lue, comment la dessiner, et l'image qu'on en dessine. Un fil lit et dessine ; d'autres regardent. */
public abstract class Dessinateur implements Toile {

    private static final double NS_PAR_MS = 1e6;

    protected final Options options;
    protected final PrintStream sortie;
    protected final PrintStream erreur;
    private volatile Scene scene;
    private volatile Origines origines;
    private volatile String fichier;
    private volatile ReglagesDessin reglages;
    private volatile ImageMemoire image;
    private volatile Traceur lancer;
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

    protected Dessinateur(Options options, PrintStream sortie, PrintStream erreur) {
        this.options = options;
        this.sortie = sortie;
        this.erreur = erreur;
    }

    /** Dit, si c'est le cas, que la recherche rapide ne répondait pas comme les classes du cours. */
    protected void direEcart(Traceur dessine) {
        if (dessine.getEcart() != null) {
            Pannes.avertir(Collections.singletonList(dessine.getEcart()), erreur);
        }
    }

    /**
     * Lit une scène, qui devient celle à dessiner.
     *
     * @param nomFichier voir {@link Scene#Scene(String)}
     * @return ce qu'elle a de laissé de côté, une ligne chacun
     * @throws SceneFautive si elle ne peut être utilisée ; la précédente reste alors en place
     * @throws CancellationException de même, si ce fil a été interrompu
     */
    public List<String> lireScene(String nomFichier) {
        avancement = 0;
        long debut = System.nanoTime();
        Lecture lecture = new Lecture();
        Scene nouvelle = new Scene(nomFichier, lecture);
        lecture.reglages.verifier(options);
        if (Thread.currentThread().isInterrupted()) {
            throw new CancellationException("lecture abandonnée : la scène d'avant reste");
        }
        lectureNs = System.nanoTime() - debut;
        fichier = nomFichier;
        origines = lecture.getOrigines();
        remplacer(nouvelle, lecture.reglages);
        return lecture.getAvertissements();
    }

    /** Une lecture, qui dit où elle en est et installe les variantes selon la ligne de commande. */
    private final class Lecture extends LecteurScene {

        private ReglagesDessin reglages;

        @Override
        protected void avancer(double part) {
            avancement = part;
        }

        @Override
        protected Modele installer(Map<Variante, Section> variantes) {
            reglages = ReglagesDessin.de(variantes, options);
            return reglages.getModele();
        }
    }

    public Scene getScene() {
        return scene;
    }

    /** De quelles sections viennent les objets et les lampes de la scène lue. */
    public Origines getOrigines() {
        return origines;
    }

    /** La part faite de la lecture, ou de la préparation, de 0 à 1. */
    public double getAvancement() {
        return avancement;
    }

    /** Comment dessiner la scène lue, tant que {@link #regler} n'en dit pas plus. */
    public ReglagesDessin getReglages() {
        return reglages;
    }

    /**
     * Dit comment dessiner la scène lue, jusqu'à la suivante.
     *
     * @throws SceneFautive si ces réglages ne vont pas ; rien n'est alors changé
     */
    public void regler(ReglagesDessin voulus) {
        remplacer(scene.avec(voulus.getModele()), voulus);
    }

    /** Le dessin d'avant n'est pas celui de cette scène, même avant qu'elle ne se prépare. */
    private void remplacer(Scene nouvelle, ReglagesDessin siens) {
        lancer = null;
        avancement = 0;
        scene = nouvelle;
        reglages = siens;
    }

    /**
     * Dessine la scène lue, brouillon puis image.
     *
     * @throws CancellationException si le dessin a été arrêté
     * @throws Echec si un pixel ne peut être calculé
     */
    public abstract void doTracerImage(int largeur, int hauteur);

    /** Prépare la scène lue pour une image, qui devient celle que l'on dessine. */
    protected Traceur preparer(ImageMemoire vierge) {
        // dans cet ordre : qui voit la nouvelle image ne voit plus l'ancien lancer
        lancer = null;
        image = vierge;
        avancement = 0;
        long debut = System.nanoTime();
        Traceur nouveau = LancerSurveille.preparer(scene, vierge.getLargeur(), vierge.getHauteur(), options.simple,
                suivi);
        preparationNs = System.nanoTime() - debut;
        lancer = nouveau;
        return nouveau;
    }

    /** L'image qui se dessine, ou s'est dessinée ; {@code null} avant la première. */
    public ImageMemoire getImage() {
        return image;
    }

    /** Ce qui dessine la scène lue, ainsi réglée ; {@code null} tant qu'elle ne se dessine pas. */
    public Traceur getTraceur() {
        return lancer;
    }

    /**
     * Ce que dit {@code --statistiques} : comptes d'un dessin, et temps. Toujours avec un point décimal, sans
     * séparateur de milliers ni exposant, quelle que soit la langue de la machine.
     *
     * @param tracesNs le temps de chaque dessin, dans l'ordre, en nanosecondes
     */
    protected String statistiques(Traceur dessine, long... tracesNs) {
        Compteurs c = dessine.getCompteurs();
        double traceNs = mediane(tracesNs);
        return String.format(Locale.ROOT, "rayons.primaires: %d\nrayons.ombre: %d\nrayons.reflechis: %d\n"
                + "tests.spheres: %d\ntests.precis: %d\nnoeuds.visites: %d\nexamens.essais: %d\npixels.raffines: %d\n"
                + "pixels.temoins: %d\n"
                + "lecture.ms: %.3f\npreparation.ms: %.3f\ntrace.ms: %.3f\nrayons.par.seconde: %d",
                c.primaires, c.ombre, c.reflechis, c.testsSpheres, c.testsPrecis, c.noeudsVisites, c.examensEssais,
                c.pixelsRaffines, c.pixelsTemoins, lectureNs / NS_PAR_MS, preparationNs / NS_PAR_MS,
                traceNs / NS_PAR_MS, Math.round(c.rayons() / (Math.max(traceNs, 1) / 1e9)));
    }

    /** La médiane de la seconde moitié : au début, la machine virtuelle compile encore. */
    private static double mediane(long[] temps) {
        long[] tries = Arrays.copyOfRange(temps, temps.length / 2, temps.length);
        Arrays.sort(tries);
        return (tries[(tries.length - 1) / 2] + tries[tries.length / 2]) / 2.0;
    }

    /** Ce qu'il faut dire d'un pixel de la scène lue qui n'a pu être calculé. */
    protected Echec nommer(PixelFautif panne) {
        int largeur = image == null ? options.largeur : image.getLargeur();
        int hauteur = image == null ? options.hauteur : image.getHauteur();
        return Echec.panne(Pannes.duPixel(Diagnostic.situer(panne, scene), reglages.getOptions(), fichier, largeur, hauteur));
    }
}
