package lancer;

import java.io.PrintStream;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CancellationException;
import lancer.commande.Aide;
import lancer.commande.CodeSortie;
import lancer.commande.Echec;
import lancer.commande.Options;
import lancer.commande.Pannes;
import lancer.contrat.Diagnostic;
import lancer.contrat.PixelFautif;
import lancer.contrat.Suivi;
import lancer.contrat.Toile;
import lancer.fenetre.Ouverture;
import lancer.inspection.Inspection;
import lancer.inspection.Recit;
import lancer.lecture.LecteurScene;
import lancer.sortie.Dessinateur;
import lancer.sortie.ImageMemoire;
import lancer.sortie.LectureImage;
import lancer.sortie.ReglagesDessin;
import lancer.sortie.Statistiques;
import lancer.sortie.VersFichiers;
import lancer.temoins.LancerSurveille;

/**
 * Le programme (cours, « Bilan intermédiaire ») : de la ligne de commande à l'image, dans une fenêtre ou dans un
 * fichier. AWT n'est touché que par {@link Ouverture}.
 */
public class Main implements Toile, Dessinateur {

    /** Taille d'image au-delà de laquelle la fenêtre ne garde pas les couleurs non limitées : 48 Mo. */
    private static final int PIXELS_AVEC_LINEAIRE = 4_000_000;

    private final Options options;
    private final PrintStream sortie;
    private final PrintStream erreur;
    private volatile Scene scene;
    private volatile String fichier;
    private volatile ReglagesDessin reglages;
    private volatile double avancement;
    private final Suivi suivi = new Suivi() {
        @Override
        public void fait(double part) {
            avancement = part;
        }
    };
    private long lectureNs;
    private long preparationNs;
    private volatile ImageMemoire image;
    private volatile Lancer lancer;

    public Main(Options options, PrintStream sortie, PrintStream erreur) {
        this.options = options;
        this.sortie = sortie;
        this.erreur = erreur;
    }

    /** @param args voir {@code --aide} */
    public static void main(String[] args) {
        int statut = executer(args, System.out, System.err);
        if (statut != CodeSortie.FAIT) {
            System.exit(statut);
        }
    }

    /**
     * Le programme entier, sans quitter la machine virtuelle.
     *
     * @return le statut de sortie ; pour 1 et 2, une ligne a été écrite sur {@code erreur}
     */
    static int executer(String[] args, PrintStream sortie, PrintStream erreur) {
        try {
            return new Main(Options.lire(args), sortie, erreur).executer();
        } catch (RuntimeException | Error e) {
            return Pannes.dire(e, erreur);
        }
    }

    private int executer() {
        try {
            if (options.aide || options.version) {
                Pannes.repondre(options.aide ? Aide.texte() : Aide.version(), sortie);
            } else if (options.comparer != null) {
                return comparer();
            } else if (options.pixel) {
                dessinerUnPixel();
            } else if (options.versFichier()) {
                versFichiers();
            } else {
                Ouverture.ouvrir(this, options, erreur, () -> System.exit(CodeSortie.FAIT));
            }
            return CodeSortie.FAIT;
        } catch (PixelFautif e) {
            throw nommer(e);
        }
    }

    private void versFichiers() {
        VersFichiers fichiers = VersFichiers.pourDessiner(options, sortie, erreur);
        List<String> avertissements = lireScene(options.scene);
        image = fichiers.creerImage();
        Lancer dessine = fichiers.dessiner(preparer(), reglages.getVariantesLibres(), this, image, lectureNs,
                preparationNs);
        // en dernier : si quelque chose a échoué, c'est la seule ligne à lire
        Pannes.avertir(avertissements, erreur);
        direEcart(dessine);
    }

    private void dessinerUnPixel() {
        List<String> avertissements = lireScene(options.scene);
        Camera camera = new Camera(options.largeur, options.hauteur);
        Inspection pixel = new Inspection(scene, camera, reglages.getReflets(), options.pixelX, options.pixelY);
        pixel.faire();
        Pannes.repondreEnUtf8(new Recit(pixel, Double::toString).lignes(), sortie);
        Pannes.avertir(avertissements, erreur);
    }

    /** @return le statut de sortie ; que des images diffèrent est une réponse, pas une panne */
    private int comparer() {
        VersFichiers fichiers = VersFichiers.pourComparer(options, sortie, erreur);
        ImageMemoire attendue = LectureImage.lire(options.comparer);
        if (LectureImage.estImage(options.scene)) {
            image = LectureImage.lire(options.scene);
        } else {
            lireScene(options.scene);
            image = new ImageMemoire(attendue.getLargeur(), attendue.getHauteur(), true);
            preparer().TracerPixels(this, reglages.getReflets(), options.fils);
        }
        return fichiers.comparer(image, attendue);
    }

    @Override
    public List<String> lireScene(String nomFichier) {
        avancement = 0;
        long debut = System.nanoTime();
        LecteurScene lu = LecteurScene.lire(nomFichier, suivi);
        ReglagesDessin demandes = ReglagesDessin.de(lu, options);
        Scene nouvelle = demandes.regler(new Scene(lu));
        if (Thread.currentThread().isInterrupted()) {
            throw new CancellationException("lecture abandonnée : la scène d'avant reste");
        }
        lectureNs = System.nanoTime() - debut;
        scene = nouvelle;
        fichier = nomFichier;
        reglages = demandes;
        return lu.getAvertissements();
    }

    @Override
    public double getAvancement() {
        return avancement;
    }

    @Override
    public ReglagesDessin getReglages() {
        return reglages;
    }

    @Override
    public void regler(ReglagesDessin voulus) {
        scene = voulus.regler(scene);
        reglages = voulus;
    }

    /** Dit, si c'est le cas, que la recherche rapide ne répondait pas comme les classes du cours. */
    private void direEcart(Lancer dessine) {
        if (dessine.getTemoignage().ecart != null) {
            Pannes.avertir(Collections.singletonList(dessine.getTemoignage().ecart), erreur);
        }
    }

    private Echec nommer(PixelFautif panne) {
        int largeur = image == null ? options.largeur : image.getLargeur();
        int hauteur = image == null ? options.hauteur : image.getHauteur();
        PixelFautif precise = Diagnostic.preciser(panne, scene, new Camera(largeur, hauteur), reglages.getReflets());
        return new Echec(CodeSortie.PANNE, Pannes.duPixel(precise, reglages.getOptions(), fichier, largeur, hauteur));
    }

    /** Prépare la scène lue pour l'image à dessiner. */
    private Lancer preparer() {
        avancement = 0;
        long debut = System.nanoTime();
        Lancer nouveau = LancerSurveille.preparer(scene, image.getLargeur(), image.getHauteur(), options.simple,
                suivi);
        preparationNs = System.nanoTime() - debut;
        return nouveau;
    }

    /** Dessine la scène, brouillon puis image, par {@link #drawPixel} : le travail du SwingWorker de la fenêtre. */
    @Override
    public void doTracerImage(int largeur, int hauteur) {
        // dans cet ordre : qui voit la nouvelle image ne voit plus l'ancien lancer
        lancer = null;
        image = new ImageMemoire(largeur, hauteur, (long) largeur * hauteur <= PIXELS_AVEC_LINEAIRE);
        Lancer nouveau = preparer();
        lancer = nouveau;
        try {
            nouveau.TracerImage(this, reglages.getReflets(), options.fils);
        } catch (PixelFautif e) {
            throw nommer(e);
        }
        direEcart(nouveau);
        if (options.statistiques) {
            sortie.println(new Statistiques(nouveau.getCompteurs(), lectureNs, preparationNs, nouveau.getDureeNs()));
            sortie.flush();
        }
    }

    @Override
    public ImageMemoire getImage() {
        return image;
    }

    @Override
    public Lancer getLancer() {
        return lancer;
    }

    /** Dessine un pixel de l'image en cours. */
    @Override
    public void drawPixel(Couleur coul, int xe, int ye) {
        image.drawPixel(PixelFautif.verifier(coul, xe + 0.5, ye + 0.5), xe, ye);
    }
}
