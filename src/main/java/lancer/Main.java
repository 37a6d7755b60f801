package lancer;

import java.io.PrintStream;
import lancer.commande.Aide;
import lancer.commande.Options;
import lancer.commande.Pannes;
import lancer.contrat.PixelFautif;
import lancer.dessin.Dessinateur;
import lancer.dessin.SansFenetre;
import lancer.fenetre.Ouverture;
import lancer.fils.Traceur;
import lancer.image.ImageMemoire;

/**
 * Le programme (cours, « Bilan intermédiaire ») : de la ligne de commande à l'image, dans une fenêtre ou dans un
 * fichier. AWT n'est touché que par {@link Ouverture}.
 */
public class Main extends Dessinateur {

    /** Taille d'image au-delà de laquelle la fenêtre ne garde pas les couleurs non limitées : 48 Mo. */
    private static final int PIXELS_AVEC_LINEAIRE = 4_000_000;

    public Main(Options options, PrintStream sortie, PrintStream erreur) {
        super(options, sortie, erreur);
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
            } else if (options.sansFenetre()) {
                return SansFenetre.faire(this);
            } else {
                Ouverture.ouvrir(this, options, erreur, () -> System.exit(0));
            }
            return 0;
        } catch (PixelFautif e) {
            throw nommer(e);
        }
    }

    /** Dessine la scène, brouillon puis image, par {@link #drawPixel} : le travail du SwingWorker de la fenêtre. */
    @Override
    public void doTracerImage(int largeur, int hauteur) {
        boolean avecLineaire = (long) largeur * hauteur <= PIXELS_AVEC_LINEAIRE;
        Traceur traceur = preparer(new ImageMemoire(largeur, hauteur, avecLineaire));
        try {
            traceur.TracerImage(this, getReglages().getReflets(), options.fils);
        } catch (PixelFautif e) {
            throw nommer(e);
        }
        direEcart(traceur);
        if (options.statistiques) {
            sortie.println(statistiques(traceur, traceur.getDureeNs()));
            sortie.flush();
        }
    }

    /** Dessine un pixel de l'image en cours. */
    @Override
    public void drawPixel(Couleur coul, int xe, int ye) {
        getImage().drawPixel(PixelFautif.verifier(coul, xe + 0.5, ye + 0.5), xe, ye);
    }
}
