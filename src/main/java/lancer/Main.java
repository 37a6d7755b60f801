package lancer;

import java.io.PrintStream;
import java.util.function.DoubleConsumer;
import lancer.commande.Options;
import lancer.commande.Pannes;
import lancer.contrat.PixelFautif;
import lancer.dessin.Dessinateur;
import lancer.dessin.Programme;
import lancer.dessin.SansFenetre;
import lancer.fenetre.Ouverture;
import lancer.fils.Traceur;
import lancer.scene.LecteurScene;
import lancer.scene.SceneLue;

/** Le programme (cours, « Bilan intermédiaire ») : dessine une scène dans une fenêtre, ou dans un fichier. */
public class Main implements Programme {

    private final Options options;
    private final PrintStream sortie;
    private final PrintStream erreur;
    protected final Dessinateur dessinateur;

    public Main(Options options, PrintStream sortie, PrintStream erreur) {
        this.options = options;
        this.sortie = sortie;
        this.erreur = erreur;
        dessinateur = new Dessinateur(this, options, sortie, erreur);
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
                Pannes.repondre(options.aide ? Options.getAide() : Options.getVersion(), sortie);
            } else if (options.sansFenetre()) {
                return SansFenetre.faire(dessinateur);
            } else {
                Ouverture.ouvrir(dessinateur, options, erreur, () -> System.exit(0));
            }
            return 0;
        } catch (PixelFautif e) {
            throw dessinateur.nommer(e);
        }
    }

    @Override
    public SceneLue lireScene(String nomFichier, DoubleConsumer suivi) {
        return LecteurScene.lire(nomFichier, suivi);
    }

    @Override
    public void doTracerImage(int largeur, int hauteur) {
        Traceur traceur = dessinateur.preparer(largeur, hauteur);
        traceur.tolerer();
        try {
            traceur.TracerImage(this, dessinateur.getReglages().getReflets(), options.fils);
        } catch (PixelFautif e) {
            throw dessinateur.nommer(e);
        }
        dessinateur.rapporter(traceur);
    }

    /** Dessine un pixel de l'image en cours. */
    @Override
    public void drawPixel(Couleur coul, int xe, int ye) {
        dessinateur.getImage().drawPixel(PixelFautif.verifier(coul, xe + 0.5, ye + 0.5), xe, ye);
    }
}
