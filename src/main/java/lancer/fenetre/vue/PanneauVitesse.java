package lancer.fenetre.vue;

import java.awt.BorderLayout;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.function.Consumer;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import lancer.fenetre.etat.Essai;
import lancer.fenetre.etat.Etat;
import lancer.fenetre.etat.Suite;
import lancer.fenetre.vue.figures.GraphiqueVitesse;

/** Le temps et l'erreur de chaque réglage de l'échelle, en points ; celui que l'on désigne se dit, et se prend. */
@SuppressWarnings("serial")
final class PanneauVitesse extends JPanel implements Vue {

    private static final int LIGNES = 5;

    private final Consumer<Suite.Evenement> recevoir;
    private final GraphiqueVitesse graphique = new GraphiqueVitesse();
    private final Etiquette texte = new Etiquette("vitesse.etat");

    PanneauVitesse(Consumer<Suite.Evenement> recevoir) {
        super(new BorderLayout());
        this.recevoir = recevoir;
        setName("vitesse");
        add(graphique, BorderLayout.CENTER);
        // le graphique ne bouge pas sous la souris quand le texte change
        add(texte.enPlace(LIGNES), BorderLayout.PAGE_END);
        MouseAdapter souris = new MouseAdapter() {
            @Override
            public void mouseMoved(MouseEvent e) {
                viser(graphique.sous(e.getPoint()));
            }

            @Override
            public void mousePressed(MouseEvent e) {
                viser(graphique.sous(e.getPoint()));
                recevoir.accept(Suite::prendre);
            }
        };
        graphique.addMouseListener(souris);
        graphique.addMouseMotionListener(souris);
        graphique.registerKeyboardAction(e -> viser(graphique.voisin(-1)), KeyStroke.getKeyStroke("LEFT"),
                WHEN_FOCUSED);
        graphique.registerKeyboardAction(e -> viser(graphique.voisin(1)), KeyStroke.getKeyStroke("RIGHT"),
                WHEN_FOCUSED);
        graphique.registerKeyboardAction(e -> recevoir.accept(Suite::prendre), KeyStroke.getKeyStroke("ENTER"),
                WHEN_FOCUSED);
    }

    private void viser(Essai celui) {
        recevoir.accept(suite -> suite.viser(celui == null ? null : celui.reglages));
    }

    @Override
    public void montrer(Etat etat) {
        graphique.montrer(etat.mesures.essais.values(), etat.demande.reglages, etat.mesures.vise);
        texte.setText(etat.direLesMesures());
        graphique.getAccessibleContext().setAccessibleDescription(texte.getText());
    }
}
