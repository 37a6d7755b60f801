package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.stream.Collectors;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.SwingWorker;
import lancer.Lancer;
import lancer.auto.Echantillon;
import lancer.auto.Echelle;
import lancer.auto.Mesure;
import lancer.commande.Messages;
import lancer.commande.Reglages;
import lancer.contrat.Section;
import lancer.dessin.Demande;
import lancer.dessin.Dessin;
import lancer.fenetre.figures.GraphiqueVitesse;

/** Le temps et l'erreur de chaque réglage de l'échelle, mesurés si cet onglet est visible et que rien ne se dessine. */
@SuppressWarnings("serial")
final class PanneauVitesse extends JPanel {

    /** Nombre de pixels au-delà duquel l'échelle est dessinée en plus petit. */
    private static final double PIXELS = 2_000_000;
    /** Temps de dessin qui suffit à un réglage, en nanosecondes ; nombres minimal et maximal de ses dessins. */
    private static final long DUREE_NS = 1_500_000_000;
    private static final int MOINS = 4;
    private static final int PLUS = 40;
    /** Racine du nombre de rayons d'une référence. */
    private static final int COTE = 6;
    private static final int MARGE = 8;
    private static final int LIGNES = 6;

    private final Controleur controleur;
    final GraphiqueVitesse graphique = new GraphiqueVitesse();
    private final JTextArea texte = Bandeau.etiquette("vitesse.etat");
    /** Ce qui est mesuré, {@code null} avant la première image, et ce qui le mesure. */
    private Demande mesuree;
    private Essais essais;
    private Mesureur mesureur;

    PanneauVitesse(Controleur controleur) {
        super(new BorderLayout());
        setName("vitesse");
        this.controleur = controleur;
        texte.setBorder(BorderFactory.createEmptyBorder(0, MARGE, MARGE, MARGE));
        // la place du texte est fixe : le graphique ne bouge pas sous la souris
        texte.setRows(LIGNES);
        add(graphique, BorderLayout.CENTER);
        add(texte, BorderLayout.PAGE_END);
        MouseAdapter souris = new MouseAdapter() {
            @Override
            public void mouseMoved(MouseEvent e) {
                graphique.viser(e.getPoint());
                dire();
            }

            @Override
            public void mousePressed(MouseEvent e) {
                graphique.requestFocusInWindow();
                if (graphique.viser(e.getPoint())) {
                    choisir();
                }
            }
        };
        graphique.addMouseListener(souris);
        graphique.addMouseMotionListener(souris);
        lier("LEFT", () -> graphique.aller(-1));
        lier("RIGHT", () -> graphique.aller(1));
        lier("ENTER", this::choisir);
        controleur.prevenir(this::suivre);
        addHierarchyListener(e -> suivre());
    }

    private void lier(String touche, Runnable effet) {
        Commande commande = new Commande(null, touche, () -> true, () -> {
            effet.run();
            dire();
        });
        graphique.getInputMap().put(commande.getTouche(), commande);
        graphique.getActionMap().put(commande, commande);
    }

    /** Un réglage, et les temps de ses dessins. */
    private static final class Essai {

        final Reglages reglages;
        final List<Long> durees = new ArrayList<>();
        Mesure mesure;

        Essai(Reglages reglages) {
            this.reglages = reglages;
        }

        boolean suffit() {
            return durees.size() >= PLUS || durees.size() >= MOINS
                    && durees.stream().mapToLong(d -> d).sum() >= DUREE_NS;
        }
    }

    /** Dessine l'échelle et le réglage présent, à tour de rôle, tous dans les mêmes conditions. */
    private final class Mesureur extends SwingWorker<Void, List<Essai>> {
    }
}
