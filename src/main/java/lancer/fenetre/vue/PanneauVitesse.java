package lancer.fenetre.vue;

import java.awt.BorderLayout;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.function.Consumer;
import javax.swing.JPanel;
import lancer.commande.Reglages;
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
    private Etat etat;
    /** Le réglage que désignent la souris ou les flèches, ou {@code null}. */
    private Reglages vise;

    PanneauVitesse(Consumer<Suite.Evenement> recevoir) {
        super(new BorderLayout());
        this.recevoir = recevoir;
        setName("vitesse");
        // la place du texte est fixe : le graphique ne bouge pas sous la souris
        texte.setRows(LIGNES);
        texte.setColumns(1);
        add(graphique, BorderLayout.CENTER);
        JPanel bas = new JPanel(new BorderLayout()) {
            @Override
            public java.awt.Dimension getPreferredSize() {
                return new java.awt.Dimension(0, LIGNES * getFontMetrics(texte.getFont()).getHeight());
            }
        };
        bas.add(texte);
        add(bas, BorderLayout.PAGE_END);
        MouseAdapter souris = new MouseAdapter() {
            @Override
            public void mouseMoved(MouseEvent e) {
                viser(graphique.sous(e.getPoint()));
            }

            @Override
            public void mousePressed(MouseEvent e) {
                viser(graphique.sous(e.getPoint()));
                prendre();
            }
        };
        graphique.addMouseListener(souris);
        graphique.addMouseMotionListener(souris);
        lier("LEFT", () -> viser(graphique.voisin(vise, -1)));
        lier("RIGHT", () -> viser(graphique.voisin(vise, 1)));
        lier("ENTER", this::prendre);
    }

    private void lier(String touche, Runnable effet) {
        new Commande(null, touche, etat -> true, null, effet).lier(graphique, WHEN_FOCUSED);
    }

    private void viser(Essai celui) {
        vise = celui == null ? null : celui.reglages;
        ecrire();
    }

    /** Prend le réglage désigné : son image se dessine, et F2 le montre. */
    private void prendre() {
        if (vise != null) {
            Reglages voulus = vise;
            recevoir.accept(suite -> suite.prendre(voulus));
        }
    }

    @Override
    public void montrer(Etat nouveau) {
        etat = nouveau;
        ecrire();
    }

    /** Montre les essais, et dit où en est leur mesure, puis celui qui est désigné. */
    private void ecrire() {
        graphique.montrer(etat.mesures.essais.values(), etat.demande.reglages, vise);
        String dit = etat.direLesMesures();
        Essai designe = etat.mesures.essais.get(vise);
        if (designe != null && designe.estFait()) {
            dit += "\n" + designe.direLeReglage() + " : " + designe.dire();
        }
        texte.setText(dit);
        graphique.getAccessibleContext().setAccessibleDescription(dit);
    }
}
