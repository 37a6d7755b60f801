package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.KeyboardFocusManager;
import java.awt.Point;
import java.awt.datatransfer.StringSelection;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Future;
import java.util.stream.IntStream;
import javax.swing.BorderFactory;
import javax.swing.Icon;
import javax.swing.ImageIcon;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import javax.swing.JTextArea;
import javax.swing.JTree;
import javax.swing.SwingUtilities;
import javax.swing.ToolTipManager;
import javax.swing.tree.DefaultMutableTreeNode;
import javax.swing.tree.DefaultTreeCellRenderer;
import javax.swing.tree.DefaultTreeModel;
import javax.swing.tree.TreePath;
import lancer.Camera;
import lancer.Couleur;
import lancer.dessin.Dessin;
import lancer.fenetre.Bandeau.Sujet;
import lancer.fenetre.figures.Figure;
import lancer.fenetre.figures.VueDeCote;
import lancer.image.ImageMemoire;
import lancer.inspection.Inspection;
import lancer.inspection.Noeud;
import lancer.inspection.Recit;
import lancer.texte.Nombre;

/** Explication d'un pixel, calculée dans un autre fil. Tant qu'elle est visible, chaque dessin la met à jour. */
@SuppressWarnings("serial")
final class Inspecteur extends JPanel {

    private static final int MARGE = 6;
    private static final int HAUTEUR_VUE = 100;

    private final Controleur controleur;
    private final PanneauImage panneau;
    private final JTree arbre = new JTree(new DefaultTreeModel(null)) {
        @Override
        public void updateUI() {
            super.updateUI();
            setRowHeight(getFontMetrics(getFont()).getHeight() + MARGE / 2);
            setCellRenderer(new Rendu());
        }

        /** L'image reçoit les touches de l'arbre : les flèches déplacent le pixel. */
        @Override
        protected void processKeyEvent(KeyEvent e) {
            KeyboardFocusManager.getCurrentKeyboardFocusManager().redispatchEvent(panneau, e);
        }
    };
    private final JScrollPane ascenseur = new JScrollPane(arbre);
    private final JTextArea verdict = Bandeau.etiquette("verdict");
    private final VueDeCote vue = new VueDeCote(this::isoler);
    private final ExecutorService fil = Controleur.unFil("lancer-inspection");
    /** Vrai si le panneau n'a pas encore montré de récit depuis qu'il est ouvert. */
    private boolean neuf = true;
    private Inspection enCours;
    private Future<?> calcul;
    private Inspection montree;
    private Point pixel;
    /** Caméra de l'image où le pixel a été choisi ; {@code null} : celle de l'image montrée. */
    private Camera camera;
    private int rang = Inspection.AU_CENTRE;
    /** Numéro du seul rebond que montrent les figures ; 0 pour tous. */
    int rebond;
    private String fichier;
    private Noeud recit;
    /** État ouvert ou fermé de chaque nœud vu, par sujet ; vrai si les autres sont tous ouverts. */
    private final Map<String, Boolean> ouverts = new HashMap<>();
    private boolean tout;

    Inspecteur(Controleur controleur, PanneauImage panneau) {
        super(new BorderLayout(MARGE, MARGE));
        this.controleur = controleur;
        this.panneau = panneau;
        setName("pixel");
        setBorder(BorderFactory.createEmptyBorder(MARGE, MARGE, MARGE, MARGE));
        verdict.setText("Un clic sur l'image dit pourquoi un pixel a sa couleur.");
        arbre.setName("recit");
        arbre.getAccessibleContext().setAccessibleName("chaîne du pixel");
        arbre.setLargeModel(true);
        arbre.setToggleClickCount(0);
        ToolTipManager.sharedInstance().registerComponent(arbre);
        vue.setPreferredSize(new Dimension(0, HAUTEUR_VUE));
        JSplitPane partage = new JSplitPane(JSplitPane.VERTICAL_SPLIT, ascenseur, vue);
        // l'arbre garde la plus grande place : un écran dense n'a parfois que quatre cents points de haut
        partage.setResizeWeight(0.8);
        partage.setBorder(null);
        add(verdict, BorderLayout.PAGE_START);
        add(partage, BorderLayout.CENTER);
        arbre.addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                TreePath chemin = arbre.getPathForLocation(e.getX(), e.getY());
                if (chemin != null && enCours == null && SwingUtilities.isLeftMouseButton(e)) {
                    suivre(chemin);
                }
            }
        });
        controleur.prevenir(this::calculer);
        addHierarchyListener(e -> paraitreOuNon());
    }

    boolean aLeClavier() {
        return arbre.isFocusOwner() && montree != null;
    }

    /** Va au pixel situé à cette distance. */
    void aller(int dx, int dy) {
        if (pixel != null) {
            montrer(new Point(pixel.x + dx, pixel.y + dy));
        }
    }

    void echantillonner(int pas) {
        if (montree != null) {
            choisir(Math.max(0, montree.getEchantillons().indexOf(montree.getChoisi()) + pas));
        }
    }

    void defiler(int rang) {
        Actions.defiler(ascenseur, rang);
    }

    /** Explique ce pixel, tout de suite ou dès que le panneau est visible. */
    void montrer(Point voulu) {
        rebond = voulu.equals(pixel) ? rebond : 0;
        pixel = voulu;
        camera = null;
        rang = Inspection.AU_CENTRE;
        paraitreOuNon();
    }

    private void paraitreOuNon() {
        neuf |= !isShowing();
        panneau.suivre(isShowing() ? pixel : null);
        if (!isShowing()) {
            panneau.superposer(null, null);
        }
        calculer();
    }

    private void choisir(int voulu) {
        rang = voulu;
        calculer();
    }

    /** Ne montre que ce rebond dans les figures ; les montre tous si c'est déjà lui ou s'il n'existe pas. */
    void isoler(int numero) {
        rebond = numero == rebond ? 0 : numero;
        calculer();
    }

    private void suivre(TreePath chemin) {
        Noeud noeud = noeud(chemin.getLastPathComponent());
        if (noeud.rebond > 0) {
            isoler(noeud.rebond);
        } else if (noeud.echantillon >= 0) {
            choisir(noeud.echantillon);
        } else if (arbre.isExpanded(chemin)) {
            arbre.collapsePath(chemin);
        } else {
            arbre.expandPath(chemin);
        }
    }

    void copier() {
        List<String> lignes = new Recit(montree, Double::toString, Double::toString).raconter().lignes();
        getToolkit().getSystemClipboard().setContents(new StringSelection(String.join("\n", lignes)), null);
        panneau.bandeau.dire(Sujet.AVIS, "récit du pixel copié, " + lignes.size() + " lignes");
    }

    /** Explique le pixel de l'image montrée. L'explication d'avant est grisée pendant le calcul. */
    private void calculer() {
        Dessin montre = controleur.etat.montre;
        if (enCours != null) {
            calcul.cancel(true);
            enCours = null;
        }
        if (!isShowing() || montre == null || pixel == null) {
            return;
        }
        if (!montre.demande.lecture.fichier.equals(fichier)) {
            fichier = montre.demande.lecture.fichier;
            recit = null;
            rebond = 0;
        }
        // même endroit dans une image d'une autre taille
        double fois = camera == null ? 1 : (double) montre.image.largeur / camera.getLargeur();
        camera = montre.lancer.getCamera();
        pixel = new Point(Math.max(0, Math.min(camera.getLargeur() - 1, (int) (fois * (pixel.x + 0.5)))),
                Math.max(0, Math.min(camera.getHauteur() - 1, (int) (fois * (pixel.y + 0.5)))));
        Inspection nouvelle = new Inspection(montre.lancer.getScene(), montre.demande.lecture.lue.origines, camera,
                montre.demande.reglages.getProfondeur(), pixel.x, pixel.y);
        int voulu = rang;
        int seul = rebond;
        enCours = nouvelle;
        verdict.setText("calcul…");
        arbre.repaint();
        calcul = Controleur.confier(fil, () -> {
            nouvelle.faireOuEchouer(voulu);
            Noeud racine = new Recit(nouvelle, Nombre::arrondir, Nombre::arrondirComposante).raconter();
            int garde = seul > nouvelle.getSegments().size() ? 0 : seul;
            Figure figure = new Figure(nouvelle, garde);
            EventQueue.invokeLater(() -> recevoir(nouvelle, racine, figure, garde));
        }, verdict::setText);
    }

    private void recevoir(Inspection nouvelle, Noeud racine, Figure figure, int seul) {
        if (nouvelle != enCours) {
            return;
        }
        enCours = null;
        montree = nouvelle;
        rebond = seul;
        recit = racine.depuis(recit);
        rangs().filter(r -> !noeud(r).enfants.isEmpty()).forEach(r -> ouverts.put(noeud(r).sujet, arbre.isExpanded(r)));
        arbre.setModel(new DefaultTreeModel(branche(recit)));
        ouvrir();
        boolean connue = nouvelle.getSegments().stream().allMatch(segment -> segment.inconnue().estNoire());
        verdict.setText((nouvelle.getFaute() != null ? "Ce pixel n'a pu être calculé."
                : comparer(nouvelle.getCouleur()))
                + (connue ? "" : "\nLe récit ne connaît pas tous les termes de cette couleur.")
                + (rebond == 0 ? "" : "\nLes figures ne montrent que le rebond " + rebond + " ; 0 pour tous."));
        vue.montrer(nouvelle, rebond);
        panneau.superposer(figure, this::isoler);
        if (neuf) {
            neuf = false;
            ((Onglets) SwingUtilities.getAncestorOfClass(Onglets.class, this)).ajuster();
        }
    }

    private static DefaultMutableTreeNode branche(Noeud noeud) {
        DefaultMutableTreeNode branche = new DefaultMutableTreeNode(noeud);
        noeud.enfants.forEach(enfant -> branche.add(branche(enfant)));
        return branche;
    }

    private static Noeud noeud(Object branche) {
        return (Noeud) ((DefaultMutableTreeNode) branche).getUserObject();
    }

    private Noeud noeud(int ligne) {
        return noeud(arbre.getPathForRow(ligne).getLastPathComponent());
    }

    private IntStream rangs() {
        return IntStream.range(0, arbre.getRowCount());
    }

    /** Ouvre ou ferme chaque nœud selon son état, et sélectionne le rebond choisi. */
    private void ouvrir() {
        // ouvrir un nœud ajoute des lignes après la sienne
        for (int r = 0; r < arbre.getRowCount(); r++) {
            if (ouverts.getOrDefault(noeud(r).sujet, tout || !noeud(r).replie)) {
                arbre.expandRow(r);
            } else {
                arbre.collapseRow(r);
            }
        }
        arbre.clearSelection();
        rangs().filter(r -> rebond > 0 && noeud(r).rebond == rebond).forEach(arbre::setSelectionRow);
    }

    /** Ouvre tous les nœuds ou, s'ils sont ouverts, les remet dans leur état initial. */
    void deplier() {
        tout = rangs().noneMatch(r -> noeud(r).replie && arbre.isExpanded(r));
        ouverts.clear();
        ouvrir();
    }

    /** Une ligne de l'arbre : une pastille de sa couleur, son texte, et sa valeur d'avant si elle a changé. */
    private final class Rendu extends DefaultTreeCellRenderer {

        @Override
        public Component getTreeCellRendererComponent(JTree tree, Object branche, boolean choisi, boolean ouvert,
                boolean feuille, int ligne, boolean clavier) {
            Noeud noeud = noeud(branche);
            setBackgroundNonSelectionColor(noeud.avant == null && (ouvert || !noeud.aChange()) ? null
                    : Apparence.couleur("Tree.selectionInactiveBackground", "Panel.background"));
            String texte = noeud.avant == null ? noeud.texte : noeud.texte + "   ← " + noeud.avant;
            super.getTreeCellRendererComponent(tree, texte, choisi, ouvert, feuille, ligne, clavier);
            Icon pastille = noeud.couleur == null ? null : pastille(noeud.couleur);
            setIcon(pastille);
            setDisabledIcon(pastille);
            setToolTipText(texte);
            setEnabled(enCours == null);
            return this;
        }
    }

    private static Icon pastille(Couleur couleur) {
        BufferedImage carre = new BufferedImage(2 * MARGE, 2 * MARGE, BufferedImage.TYPE_INT_RGB);
        Graphics g = carre.createGraphics();
        g.setColor(new Color(couleur.getCode()));
        g.fillRect(1, 1, 2 * MARGE - 2, 2 * MARGE - 2);
        return new ImageIcon(carre);
    }

    private String comparer(Couleur couleur) {
        ImageMemoire image = controleur.etat.getImageEntiere();
        if (image == null) {
            return "L'image n'est pas achevée : rien encore à quoi comparer.";
        }
        if (!image.sens.equals(ImageMemoire.COULEUR)) {
            return "La couleur de ce pixel, que la vue remplace : #"
                    + String.format("%06X", couleur.getCode() & 0xFFFFFF);
        }
        int k = pixel.y * image.largeur + pixel.x;
        float[] vu = image.lineaire;
        boolean pareil = image.codes[k] == couleur.getCode() && (vu == null || vu[3 * k] == (float) couleur.r
                && vu[3 * k + 1] == (float) couleur.v && vu[3 * k + 2] == (float) couleur.b);
        String dessine = String.format("#%06X", image.codes[k] & 0xFFFFFF);
        return pareil ? "Au bit près, la couleur du pixel dessiné : " + dessine
                : "Différent du pixel dessiné, qui est " + dessine
                        + (vu == null ? "" : " = " + vu[3 * k] + " " + vu[3 * k + 1] + " " + vu[3 * k + 2]);
    }
}
