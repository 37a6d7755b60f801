package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Point;
import java.awt.datatransfer.StringSelection;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import javax.swing.JTextArea;
import javax.swing.JTree;
import javax.swing.SwingWorker;
import javax.swing.UIManager;
import javax.swing.tree.DefaultMutableTreeNode;
import javax.swing.tree.DefaultTreeModel;
import javax.swing.tree.TreeCellRenderer;
import lancer.Couleur;
import lancer.commande.Messages;
import lancer.dessin.Dessin;
import lancer.fenetre.figures.Figure;
import lancer.fenetre.figures.VueDeCote;
import lancer.image.ImageMemoire;
import lancer.inspection.Inspection;
import lancer.inspection.Recit;
import lancer.inspection.Recit.Noeud;
import lancer.texte.Nombre;

/** Explication d'un pixel, calculée dans un autre fil. Tant qu'elle est visible, chaque dessin la met à jour. */
@SuppressWarnings("serial")
final class Inspecteur extends JPanel {

    private static final int MARGE = 6;
    private static final int PASTILLE = 10;
    private static final int HAUTEUR_VUE = 190;

    private final Controleur controleur;
    private final JTree arbre = new JTree(new DefaultTreeModel(null));
    private final JTextArea verdict = Bandeau.etiquette("verdict");
    private final VueDeCote vue = new VueDeCote();
    private Explication enCours;
    private Inspection montree;
    /** Le dessin dont le pixel est expliqué. */
    private Dessin dessin;
    private Point pixel;
    /** Vrai si ce panneau se voit : la figure et le pixel sont alors suivis sur l'image. */
    private boolean visible;
    /** Vrai si le détail est déplié. */
    private boolean tout;

    Inspecteur(Controleur controleur) {
        super(new BorderLayout(MARGE, MARGE));
        this.controleur = controleur;
        setName("pixel");
        setBorder(BorderFactory.createEmptyBorder(MARGE, MARGE, MARGE, MARGE));
        verdict.setText("Un clic sur l'image dit pourquoi un pixel a sa couleur.");
        arbre.setName("recit");
        arbre.getAccessibleContext().setAccessibleName("chaîne du pixel");
        arbre.setToggleClickCount(1);
        // un clic laisse le clavier à l'image : les flèches y déplacent le pixel
        arbre.setRequestFocusEnabled(false);
        arbre.setRowHeight(0);
        arbre.setCellRenderer(new Ligne());
        JScrollPane deroulant = new JScrollPane(arbre, JScrollPane.VERTICAL_SCROLLBAR_AS_NEEDED,
                JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
        deroulant.getViewport().addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                // un autre peintre : la hauteur de chaque ligne est calculée de nouveau
                arbre.setCellRenderer(new Ligne());
            }
        });
        vue.setPreferredSize(new Dimension(0, HAUTEUR_VUE));
        JSplitPane partage = new JSplitPane(JSplitPane.VERTICAL_SPLIT, deroulant, vue);
        // un écran dense n'a parfois que quatre cents points de haut
        vue.setMinimumSize(new Dimension(0, HAUTEUR_VUE / 2));
        partage.setResizeWeight(0.6);
        partage.setBorder(null);
        partage.setFocusable(false);
        add(verdict, BorderLayout.PAGE_START);
        add(partage, BorderLayout.CENTER);
        controleur.prevenir(this::suivre);
    }

    /** Explique le pixel d'une autre image, ou compare à la même, si elle est achevée, ce qui est expliqué. */
    private void suivre(Etat etat) {
        if (isShowing() != visible) {
            montrer(pixel);
        } else if (etat.montre.dessin != dessin) {
            calculer();
        } else if (visible && enCours == null && montree != null) {
            verdict.setText(comparer(montree));
        }
    }

    /** Va au pixel situé à cette distance. */
    void aller(int dx, int dy) {
        if (pixel != null) {
            montrer(new Point(pixel.x + dx, pixel.y + dy));
        }
    }

    /** Explique ce pixel, tout de suite ou dès que le panneau est visible. */
    void montrer(Point voulu) {
        pixel = voulu;
        visible = isShowing();
        controleur.panneau.suivre(visible ? pixel : null);
        if (!visible) {
            controleur.panneau.superposer(null);
        }
        calculer();
    }

    /** Copie le récit, tous les chiffres écrits. */
    void copier() {
        if (montree != null) {
            List<String> lignes = new Recit(montree, Double::toString, Double::toString).raconter().lignes();
            getToolkit().getSystemClipboard().setContents(new StringSelection(String.join("\n", lignes)), null);
            controleur.panneau.bandeau.dire("récit du pixel copié, " + lignes.size() + " lignes");
        }
    }

    /** Le calcul de l'explication d'un pixel. L'explication d'avant est grisée pendant ce temps. */
    private final class Explication extends SwingWorker<Noeud, Void> {

        private final Inspection nouvelle;
        private final Dessin expliquee = dessin;

        Explication(Inspection nouvelle) {
            this.nouvelle = nouvelle;
        }

        @Override
        protected Noeud doInBackground() {
            nouvelle.faire(expliquee::seRegardeDeuxFois);
            return new Recit(nouvelle, Nombre::arrondir, Nombre::arrondirComposante).raconter();
        }

        @Override
        protected void done() {
            if (enCours != this) {
                return;
            }
            enCours = null;
            try {
                arbre.setModel(new DefaultTreeModel(branche(get())));
                montree = nouvelle;
                ouvrir();
                verdict.setText(comparer(nouvelle));
                vue.montrer(nouvelle);
                controleur.panneau.superposer(new Figure(nouvelle));
            } catch (ExecutionException e) {
                verdict.setText(Messages.message(e.getCause()));
            } catch (InterruptedException | CancellationException e) {
                // un autre calcul a remplacé celui-ci
            }
        }
    }

    /** Explique le pixel de l'image montrée. */
    private void calculer() {
        if (enCours != null) {
            enCours.cancel(true);
            enCours = null;
        }
        dessin = controleur.getEtat().montre.dessin;
        if (!visible || dessin == null || pixel == null) {
            return;
        }
        pixel = new Point(Math.max(0, Math.min(dessin.image.largeur - 1, pixel.x)),
                Math.max(0, Math.min(dessin.image.hauteur - 1, pixel.y)));
        enCours = new Explication(new Inspection(dessin.lancer.getScene(), dessin.demande.lue::getOrigine,
                dessin.lancer.getCamera(), dessin.demande.reglages.getProfondeur(), pixel.x, pixel.y));
        verdict.setText("calcul…");
        arbre.repaint();
        enCours.execute();
    }

    private static DefaultMutableTreeNode branche(Noeud noeud) {
        DefaultMutableTreeNode branche = new DefaultMutableTreeNode(noeud);
        noeud.enfants.forEach(enfant -> branche.add(branche(enfant)));
        return branche;
    }

    private static Noeud noeud(Object branche) {
        return (Noeud) ((DefaultMutableTreeNode) branche).getUserObject();
    }

    private void ouvrir() {
        // ouvrir un nœud ajoute des lignes après la sienne
        for (int r = 0; r < arbre.getRowCount(); r++) {
            if (tout || !noeud(arbre.getPathForRow(r).getLastPathComponent()).replie) {
                arbre.expandRow(r);
            } else {
                arbre.collapseRow(r);
            }
        }
    }

    /** Montre tout le détail ou, s'il l'est, l'essentiel. */
    void deplier() {
        tout = !tout;
        ouvrir();
    }

    /** Une ligne de l'arbre : une pastille de sa couleur, et son texte, continué au-dessous s'il est long. */
    private final class Ligne extends JTextArea implements TreeCellRenderer {

        private final int retrait = UIManager.getInt("Tree.leftChildIndent")
                + UIManager.getInt("Tree.rightChildIndent");

        Ligne() {
            setLineWrap(true);
            setWrapStyleWord(true);
            setFont(arbre.getFont());
        }

        @Override
        public Component getTreeCellRendererComponent(JTree tree, Object branche, boolean choisi, boolean ouvert,
                boolean feuille, int ligne, boolean clavier) {
            Noeud noeud = noeud(branche);
            setText(noeud.texte);
            getAccessibleContext().setAccessibleName(noeud.texte);
            setEnabled(enCours == null);
            setBackground(UIManager.getColor(clavier ? "Tree.selectionInactiveBackground" : "Tree.background"));
            setBorder(BorderFactory.createCompoundBorder(BorderFactory.createMatteBorder(2, 0, 1, 0, getBackground()),
                    noeud.couleur == null ? null : BorderFactory.createCompoundBorder(
                            BorderFactory.createMatteBorder(0, PASTILLE, 0, 0, new Color(noeud.couleur.getCode())),
                            BorderFactory.createEmptyBorder(0, MARGE, 0, 0))));
            int niveau = ((DefaultMutableTreeNode) branche).getLevel() + 1;
            // à cette largeur, la hauteur est celle de toutes les lignes de l'écran qu'il faut
            setSize(Math.max(20 * PASTILLE, arbre.getParent().getWidth() - niveau * retrait), Short.MAX_VALUE);
            return this;
        }
    }

    /** Compare la couleur expliquée à celle du pixel dessiné. */
    private String comparer(Inspection expliquee) {
        if (expliquee.getFaute() != null) {
            return "Ce pixel n'a pu être calculé.";
        }
        Couleur couleur = expliquee.getCouleur();
        ImageMemoire image = controleur.getEtat().getImageEntiere();
        if (image == null) {
            return "L'image n'est pas achevée : rien encore à quoi comparer.";
        }
        if (!image.echelle.isEmpty()) {
            return "La couleur de ce pixel, que la vue remplace : #"
                    + String.format("%06X", couleur.getCode() & 0xFFFFFF);
        }
        int k = pixel.y * image.largeur + pixel.x;
        float[] vu = image.lineaire;
        boolean pareil = image.codes[k] == couleur.getCode() && (vu == null || vu[3 * k] == (float) couleur.r
                && vu[3 * k + 1] == (float) couleur.v && vu[3 * k + 2] == (float) couleur.b);
        String dessine = String.format("#%06X", image.codes[k] & 0xFFFFFF);
        if (pareil) {
            return "Au bit près, la couleur du pixel dessiné : " + dessine;
        }
        return "Différent du pixel dessiné, qui est " + dessine
                + (vu == null ? "" : " = " + vu[3 * k] + " " + vu[3 * k + 1] + " " + vu[3 * k + 2]);
    }
}
