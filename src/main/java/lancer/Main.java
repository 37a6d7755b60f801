package lancer;

import java.io.PrintStream;
import java.util.function.Consumer;
import lancer.commande.Aide;
import lancer.commande.Messages;
import lancer.commande.Options;
import lancer.contrat.PixelFautif;
import lancer.contrat.Toile;
import lancer.dessin.Demande;
import lancer.dessin.Dessin;
import lancer.dessin.Lecture;
import lancer.dessin.SansFenetre;
import lancer.fenetre.Ouverture;
import lancer.image.ImageMemoire;
import lancer.texte.Flux;

/** Le programme (cours, « Bilan intermédiaire ») : dessine une scène dans une fenêtre, ou dans un fichier. */
public class Main implements Toile {

    private final Options options;
    private final PrintStream sortie;
    private final PrintStream erreur;
    private final Demande demande;
    private final Consumer<Dessin> suivi;
    private Dessin dessin;
    private ImageMemoire image;

    /**
     * Le programme qui dessine cette demande : un dessin abandonné ne touche pas au suivant.
     *
     * @param suivi reçoit le dessin quand il commence, puis quand son brouillon est fini
     */
    public Main(Options options, PrintStream sortie, PrintStream erreur, Demande demande, Consumer<Dessin> suivi) {
        this.options = options;
        this.sortie = sortie;
        this.erreur = erreur;
        this.demande = demande;
        this.suivi = suivi;
    }

    /** @param args voir {@code --aide} */
    public static void main(String[] args) {
        int statut = executer(args, Flux.avecAccents(System.out, "stdout.encoding"),
                Flux.avecAccents(System.err, "stderr.encoding"));
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
            Options options = Options.lire(args);
            if (options.aide || options.version) {
                Messages.repondre(options.aide ? Aide.getTexte() : Options.getVersion(), sortie);
            } else if (options.sansFenetre()) {
                Main main = new Main(options, sortie, erreur, null, null);
                return new SansFenetre(options, main::dans, sortie, erreur).faire();
            } else {
                Ouverture.ouvrir(options, Lecture::lire,
                        (demande, suivi) -> new Main(options, sortie, erreur, demande, suivi)
                                .doTracerImage(demande.largeur, demande.hauteur), erreur, () -> System.exit(0));
            }
            return 0;
        } catch (RuntimeException | Error e) {
            return Messages.dire(e, erreur);
        }
    }

    /** La surface de ce programme, qui dessine désormais dans cette image. */
    private Toile dans(ImageMemoire autre) {
        image = autre;
        return this;
    }

    /** Prépare la scène, puis dessine le brouillon et l'image : c'est le travail du SwingWorker de la fenêtre. */
    public void doTracerImage(int largeur, int hauteur) {
        dessin = new Dessin(demande.avecTaille(largeur, hauteur));
        suivi.accept(dessin);
        dessin.lancer.getAtelier().getFautes().tolerer();
        try {
            int profondeur = demande.reglages.getProfondeur();
            dessin.lancer.TracerImage(dans(dessin.image), profondeur, options.fils);
        } catch (PixelFautif e) {
            throw demande.nommer(e);
        }
        dessin.direEcart(erreur);
        if (options.statistiques) {
            sortie.println(dessin.statistiques(dessin.lancer, dessin.lancer.getAtelier().getDureeNs()));
            sortie.flush();
        }
    }

    @Override
    public void drawPixel(Couleur coul, int xe, int ye) {
        image.drawPixel(coul, xe, ye);
    }

    @Override
    public void finirBrouillon() {
        dessin.finirBrouillon();
        suivi.accept(dessin);
    }
}
