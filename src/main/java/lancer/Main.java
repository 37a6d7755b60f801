package lancer;

import java.io.PrintStream;
import java.util.function.Consumer;
import lancer.commande.Messages;
import lancer.commande.Option;
import lancer.commande.Options;
import lancer.commande.Reglages;
import lancer.contrat.Toile;
import lancer.dessin.Demande;
import lancer.dessin.Dessin;
import lancer.dessin.Programme;
import lancer.dessin.Rapport;
import lancer.dessin.SansFenetre;
import lancer.fenetre.Ouverture;
import lancer.systeme.Console;

/** Le programme (cours, « Bilan intermédiaire ») : dessine une scène dans une fenêtre, ou dans un fichier. */
public class Main implements Toile {

    private final Demande demande;
    private final Consumer<Dessin> suivi;
    private Dessin dessin;

    /**
     * Le programme qui dessine cette demande. Chaque dessin a le sien : abandonné, il ne touche pas à l'image suivante.
     *
     * @param suivi reçoit le dessin quand il commence, puis quand son brouillon est fini
     */
    public Main(Demande demande, Consumer<Dessin> suivi) {
        this.demande = demande;
        this.suivi = suivi;
    }

    /** @param args voir {@code --aide} */
    public static void main(String[] args) {
        int statut = executer(args, Console.avecAccents(System.out, "stdout.encoding"),
                Console.avecAccents(System.err, "stderr.encoding"));
        if (statut != 0) {
            System.exit(statut);
        }
    }

    /**
     * Exécute le programme. Seule la fermeture de la fenêtre arrête la machine virtuelle.
     *
     * @return le statut de sortie : 1 si la machine a échoué, 2 si la demande est fausse, dit sur {@code erreur}
     */
    static int executer(String[] args, PrintStream sortie, PrintStream erreur) {
        try {
            Reglages options = Options.lire(args);
            if (options.get(Option.AIDE)) {
                Messages.repondre(Options.getAide(), sortie);
            } else if (options.get(Option.VERSION)) {
                Messages.repondre(Options.getVersion(), sortie);
            } else if (options.sansFenetre()) {
                return new SansFenetre(options, Main::dessiner, sortie, erreur).faire();
            } else {
                Programme programme = (demande, suivi) -> {
                    Dessin dessin = dessiner(demande, suivi);
                    Rapport.dire(dessin, sortie, erreur);
                    return dessin;
                };
                Ouverture.ouvrir(options, programme, erreur, () -> System.exit(0));
            }
            return 0;
        } catch (RuntimeException | Error e) {
            return Messages.dire(e, erreur);
        }
    }

    private static Dessin dessiner(Demande demande, Consumer<Dessin> suivi) {
        Main main = new Main(demande, suivi);
        main.doTracerImage(demande.largeur, demande.hauteur);
        return main.dessin;
    }

    /** Prépare la scène, puis appelle {@link Lancer#TracerImage} : c'est le travail du SwingWorker de la fenêtre. */
    public void doTracerImage(int largeur, int hauteur) {
        dessin = Dessin.preparer(demande.avecTaille(largeur, hauteur));
        suivi.accept(dessin);
        dessin.tracer(this);
    }

    @Override
    public void drawPixel(Couleur coul, int xe, int ye) {
        dessin.image.drawPixel(coul, xe, ye);
    }

    @Override
    public boolean montreUnBrouillon() {
        return !demande.reglages.sansFenetre();
    }

    @Override
    public void finirBrouillon() {
        suivi.accept(dessin);
    }
}
