package lancer;

import java.io.PrintStream;
import java.util.function.BiFunction;
import java.util.function.DoubleConsumer;
import lancer.commande.Messages;
import lancer.commande.Options;
import lancer.contrat.PixelFautif;
import lancer.contrat.Toile;
import lancer.dessin.Dessin;
import lancer.dessin.SansFenetre;
import lancer.fenetre.Ouverture;
import lancer.scene.LecteurScene;
import lancer.scene.SceneLue;

/** Le programme (cours, « Bilan intermédiaire ») : dessine une scène dans une fenêtre, ou dans un fichier. */
public class Main implements Toile {

    private final Options options;
    private final PrintStream sortie;
    private final PrintStream erreur;
    private final Dessin dessin;

    public Main(Options options, PrintStream sortie, PrintStream erreur) {
        this.options = options;
        this.sortie = sortie;
        this.erreur = erreur;
        // une lambda retarderait la première image : voir docs/etendre.md
        dessin = new Dessin(options, new BiFunction<String, DoubleConsumer, SceneLue>() {
            @Override
            public SceneLue apply(String nomFichier, DoubleConsumer suivi) {
                return lireScene(nomFichier, suivi);
            }
        }, erreur, options.scene, options.largeur, options.hauteur);
    }

    /** Le même programme pour cet autre dessin : un dessin abandonné ne touche pas au suivant. */
    protected Main(Main autre, Dessin dessin) {
        options = autre.options;
        sortie = autre.sortie;
        erreur = autre.erreur;
        this.dessin = dessin;
    }

    /** @param args voir {@code --aide} */
    public static void main(String[] args) {
        int statut = executer(args, System.out, System.err);
        if (statut != 0) {
            System.exit(statut);
        }
    }

    /**
     * Exécute le programme sans arrêter la machine virtuelle.
     *
     * @return le statut de sortie ; pour 1 et 2, une ligne a été écrite sur {@code erreur}
     */
    static int executer(String[] args, PrintStream sortie, PrintStream erreur) {
        try {
            return new Main(Options.lire(args), sortie, erreur).executer();
        } catch (RuntimeException | Error e) {
            return Messages.dire(e, erreur);
        }
    }

    private int executer() {
        if (options.aide || options.version) {
            Messages.repondre(options.aide ? Options.getAide() : Options.getVersion(), sortie);
        } else if (options.sansFenetre()) {
            return SansFenetre.faire(options, dessin, this, sortie, erreur);
        } else {
            Ouverture.ouvrir(options, dessin, voulu -> new Main(this, voulu).dessiner(), erreur, () -> System.exit(0));
        }
        return 0;
    }

    /** Lit une scène. @param suivi reçoit la part lue du fichier, de 0 à 1 */
    protected SceneLue lireScene(String nomFichier, DoubleConsumer suivi) {
        return LecteurScene.lire(nomFichier, !options.sansFenetre(), suivi);
    }

    /** Exécute le dessin, dont la scène est déjà lue : c'est le travail du SwingWorker de la fenêtre. */
    protected void dessiner() {
        if (dessin.getVue() == null) {
            doTracerImage(dessin.largeur, dessin.hauteur);
        } else {
            dessin.dessinerLaVue(options.fils);
        }
    }

    /** Dessine la scène lue : le brouillon, puis l'image. @param largeur celle de l'image, en pixels */
    public void doTracerImage(int largeur, int hauteur) {
        Lancer lancer = dessin.preparer(largeur, hauteur);
        lancer.getFautes().tolerer();
        try {
            int profondeur = dessin.getReglages().getProfondeur();
            lancer.TracerImage(dessin.getRegard().sur(this), profondeur, options.fils);
            if (dessin.getRegard().cachait(lancer, profondeur)) {
                lancer.TracerPixels(this, profondeur, options.fils);
            }
        } catch (PixelFautif e) {
            throw dessin.nommer(e);
        }
        dessin.direEcart();
        if (options.statistiques) {
            sortie.println(dessin.statistiques(lancer, lancer.getDureeNs()));
            sortie.flush();
        }
    }

    @Override
    public void drawPixel(Couleur coul, int xe, int ye) {
        dessin.getImage().drawPixel(coul, xe, ye);
    }

    @Override
    public void finirBrouillon() {
        dessin.finirBrouillon();
    }
}
