package lancer;

import java.io.PrintStream;
import java.util.Collections;
import java.util.List;
import lancer.commande.Aide;
import lancer.commande.Options;
import lancer.commande.Pannes;
import lancer.contrat.PixelFautif;
import lancer.dessin.Dessinateur;
import lancer.dessin.VersFichiers;
import lancer.fenetre.Ouverture;
import lancer.inspection.Inspection;
import lancer.inspection.Recit;
import lancer.sortie.ImageMemoire;
import lancer.sortie.LectureImage;

/**
 * Le programme (cours, « Bilan intermédiaire ») : de la ligne de commande à l'image, dans une fenêtre ou dans un
 * fichier. AWT n'est touché que par {@link Ouverture}.
 */
public class Main extends Dessinateur {

    /** Taille d'image au-delà de laquelle la fenêtre ne garde pas les couleurs non limitées : 48 Mo. */
    private static final int PIXELS_AVEC_LINEAIRE = 4_000_000;

    private final PrintStream sortie;
    private final PrintStream erreur;

    public Main(Options options, PrintStream sortie, PrintStream erreur) {
        super(options);
        this.sortie = sortie;
        this.erreur = erreur;
    }

    /** @param args voir {@code --aide} */
    public static void main(String[] args) {
        int statut = executer(args, System.out, System.err);
        if (statut != 0) {
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
                Ouverture.ouvrir(this, options, erreur, () -> System.exit(0));
            }
            return 0;
        } catch (PixelFautif e) {
            throw nommer(e);
        }
    }

    private void versFichiers() {
        VersFichiers fichiers = new VersFichiers(options, sortie, erreur);
        List<String> avertissements = lireScene(options.scene);
        Lancer dessine = fichiers.dessiner(this, preparer(fichiers.creerImage()));
        // en dernier : si quelque chose a échoué, c'est la seule ligne à lire
        Pannes.avertir(avertissements, erreur);
        direEcart(dessine);
    }

    private void dessinerUnPixel() {
        List<String> avertissements = lireScene(options.scene);
        Camera camera = new Camera(options.largeur, options.hauteur);
        Inspection pixel = new Inspection(getScene(), camera, options.reflets, options.pixelX, options.pixelY);
        pixel.faire();
        Pannes.repondreEnUtf8(new Recit(pixel, Double::toString).lignes(), sortie);
        Pannes.avertir(avertissements, erreur);
    }

    /** @return le statut de sortie ; que des images diffèrent est une réponse, pas une panne */
    private int comparer() {
        ImageMemoire attendue = LectureImage.lire(options.comparer);
        ImageMemoire autre = Options.estImage(options.scene) ? LectureImage.lire(options.scene) : null;
        VersFichiers fichiers = new VersFichiers(options, sortie, erreur);
        if (autre == null) {
            lireScene(options.scene);
            autre = new ImageMemoire(attendue.getLargeur(), attendue.getHauteur(), true);
            preparer(autre).TracerPixels(this, options.reflets, options.fils);
        }
        return fichiers.comparer(autre, attendue);
    }

    /** Dit, si c'est le cas, que la recherche rapide ne répondait pas comme les classes du cours. */
    private void direEcart(Lancer dessine) {
        if (dessine.getEcart() != null) {
            Pannes.avertir(Collections.singletonList(dessine.getEcart()), erreur);
        }
    }

    /** Dessine la scène, brouillon puis image, par {@link #drawPixel} : le travail du SwingWorker de la fenêtre. */
    @Override
    public void doTracerImage(int largeur, int hauteur) {
        boolean avecLineaire = (long) largeur * hauteur <= PIXELS_AVEC_LINEAIRE;
        Lancer lancer = preparer(new ImageMemoire(largeur, hauteur, avecLineaire));
        try {
            lancer.TracerImage(this, getReglages().getReflets(), options.fils);
        } catch (PixelFautif e) {
            throw nommer(e);
        }
        direEcart(lancer);
        if (options.statistiques) {
            sortie.println(statistiques(lancer, lancer.getDureeNs()));
            sortie.flush();
        }
    }

    /** Dessine un pixel de l'image en cours. */
    @Override
    public void drawPixel(Couleur coul, int xe, int ye) {
        getImage().drawPixel(PixelFautif.verifier(coul, xe + 0.5, ye + 0.5), xe, ye);
    }
}
