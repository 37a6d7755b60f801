package lancer.fenetre;

import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.Insets;
import java.util.ArrayList;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import lancer.contrat.Parametre;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.dessin.ReglagesDessin;

/** Les variantes présentes et leurs paramètres, dans une petite fenêtre à côté : l'image suit ce qu'on y déplace. */
final class PanneauVariantes extends JDialog {

    private static final long serialVersionUID = 1;

    private static final int MARGE = 8;

    /** Deux pas d'une glissière plus rapprochés que cela, au clavier, sont d'un même geste. */
    private static final long GESTE_NS = 1_000_000_000;

    private final transient Atelier atelier;
    private final JPanel grille = new JPanel(new GridBagLayout());
    private final transient List<Runnable> ajustements = new ArrayList<>();
    /** Vrai pendant que les glissières se mettent où sont les réglages : ce n'est pas l'utilisateur. */
    private boolean miseAJour;
    private transient Parametre dernier;
    private long dernierNs;

    /** À créer quand une scène est lue. */
    PanneauVariantes(JFrame cadre, Atelier atelier) {
        super(cadre, "Variantes");
        setName("variantes");
        this.atelier = atelier;
        grille.setBorder(BorderFactory.createEmptyBorder(MARGE, MARGE, MARGE, MARGE));
        int ligne = 0;
        for (Variante variante : atelier.getReglages().getVariantes()) {
            poser(boite(variante), 0, ligne++, 3);
            for (Parametre parametre : variante.getParametres()) {
                JLabel valeur = new JLabel(" ");
                JLabel nom = new JLabel(parametre.getCle());
                JSlider glissiere = glissiere(variante, parametre, valeur);
                nom.setLabelFor(glissiere);
                poser(nom, 0, ligne, 1);
                poser(glissiere, 1, ligne, 1);
                poser(valeur, 2, ligne++, 1);
            }
        }
        add(grille);
        montrer();
        pack();
        // la place de la plus longue valeur, qui viendra peut-être
        setSize(getWidth() + 6 * MARGE, getHeight());
        atelier.prevenir(this::montrer);
    }

    private void poser(JComponent composant, int x, int y, int colonnes) {
        grille.add(composant, new GridBagConstraints(x, y, colonnes, 1, x == 1 ? 1 : 0, 0,
                GridBagConstraints.LINE_START, GridBagConstraints.HORIZONTAL,
                new Insets(0, colonnes == 1 && x == 0 ? 3 * MARGE : 0, 0, MARGE), 0, 0));
    }

    /** La variante de ce type dans les derniers réglages : chaque lecture en fait une neuve. */
    private Variante actuelle(Variante variante) {
        return atelier.getReglages().getVariante(variante.getSection());
    }

    private JCheckBox boite(Variante variante) {
        JCheckBox boite = new JCheckBox(variante.getSection());
        boite.setName(variante.getSection());
        boite.addActionListener(e ->
                changer(atelier.getReglages().avec(actuelle(variante), boite.isSelected()), null, false));
        ajustements.add(() -> boite.setSelected(atelier.getReglages().estBranchee(actuelle(variante))));
        return boite;
    }

    private JSlider glissiere(Variante variante, Parametre parametre, JLabel valeur) {
        JSlider glissiere = new JSlider(0, parametre.getCrans(), 0);
        glissiere.setName(variante.getSection() + "." + parametre.getCle());
        // sans écart, les flèches du clavier n'y feraient rien
        glissiere.setMinorTickSpacing(1);
        glissiere.setSnapToTicks(true);
        glissiere.addChangeListener(e -> {
            ReglagesDessin reglages = atelier.getReglages();
            Section section = reglages.getSection(actuelle(variante));
            String voulue = parametre.getValeur(glissiere.getValue());
            if (miseAJour) {
                return;
            }
            if (!voulue.equals(section.valeur(parametre.getCle()))) {
                Section autre = section.avec(parametre.getCle(), voulue, parametre.getAutre());
                changer(reglages.avec(actuelle(variante), autre), parametre, glissiere.getValueIsAdjusting());
            } else if (!glissiere.getValueIsAdjusting()) {
                // lâchée : le geste est fini
                dernier = null;
            }
        });
        ajustements.add(() -> {
            ReglagesDessin reglages = atelier.getReglages();
            String actuelle = reglages.getValeur(actuelle(variante), parametre);
            valeur.setText(actuelle == null ? "—" : actuelle);
            glissiere.setEnabled(reglages.estBranchee(actuelle(variante)));
            if (!glissiere.getValueIsAdjusting()) {
                glissiere.setValue(actuelle == null ? 0 : parametre.getCran(actuelle));
            }
        });
        return glissiere;
    }

    private void changer(ReglagesDessin reglages, Parametre parametre, boolean glisse) {
        long maintenant = System.nanoTime();
        boolean suite = parametre != null && parametre == dernier && (glisse || maintenant - dernierNs < GESTE_NS);
        dernier = parametre;
        dernierNs = maintenant;
        atelier.dessiner(reglages, suite);
    }

    private void montrer() {
        miseAJour = true;
        ajustements.forEach(Runnable::run);
        miseAJour = false;
    }
}
