package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutorService;
import java.util.stream.IntStream;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.JTextPane;
import javax.swing.KeyStroke;
import javax.swing.text.BadLocationException;
import javax.swing.text.DefaultCaret;
import javax.swing.text.DefaultStyledDocument;
import javax.swing.text.SimpleAttributeSet;
import javax.swing.text.StyleConstants;
import lancer.Camera;
import lancer.Couleur;
import lancer.dessin.Dessin;
import lancer.fenetre.figures.Figure;
import lancer.fenetre.figures.GrilleEchantillons;
import lancer.fenetre.figures.VueDeCote;
import lancer.image.ImageMemoire;
import lancer.inspection.Depliage;
import lancer.inspection.Inspection;
import lancer.inspection.Recit;
import lancer.texte.Nombre;

/** Explication d'un pixel, dans une fenêtre à côté, qui le suit d'un dessin à l'autre ; un fil à part la calcule. */
@SuppressWarnings("serial")
final class Inspecteur extends JPanel {

    private static final int MARGE = 6;
    private static final int LARGEUR = 520;
    private static final int LARGEUR_MIN = 350;
    private static final int HAUTEUR_MIN = 500;
    private static final int COTE_FIGURES = 180;
    private static final int SAUT = 10;
    private static final Color CHANGE = new Color(0xFFE9A8);
    private static final Color VOILE = new Color(0x90FFFFFF, true);
    private static final Color LIEN = new Color(0x0050A0);
    private static final String ARRONDI = "(nombres arrondis à cinq chiffres ; --pixel les écrit en entier)";

    private final Atelier atelier;
    private final PanneauImage panneau;
    private final JTextPane texte = new JTextPane() {
        @Override
        protected void paintComponent(Graphics g) {
            super.paintComponent(g);
            if (enCours != null) {
                // en gris : changer la couleur d'un long texte prendrait plus de temps que de le remplacer
                g.setColor(VOILE);
                g.fillRect(0, 0, getWidth(), getHeight());
            }
        }
    };
    private final JScrollPane ascenseur = new JScrollPane(texte);
    private final JTextArea verdict = Bandeau.etiquette("verdict");
    private final GrilleEchantillons grille = new GrilleEchantillons(this::choisir);
    private final VueDeCote vue = new VueDeCote(this::isoler);
    private final ExecutorService fil = Atelier.unFil("lancer-inspection");
    private final Depliage depliage = new Depliage();
    private List<Recit.Ligne> vues = Collections.emptyList();
    private Inspection enCours;
    private Point pixel;
    /** Caméra de l'image dont c'est un pixel ; {@code null} : celle qui est montrée. */
    private Camera camera;
    private int rang = Inspection.AU_CENTRE;
    /** Le numéro du seul rebond que montrent les figures ; 0 : tous. */
    int rebond;

    /** @param caracteres où mettre ce qu'il fait d'un caractère */
    Inspecteur(JFrame cadre, Atelier atelier, PanneauImage panneau, Map<Character, Runnable> caracteres) {
        super(new BorderLayout());
        this.atelier = atelier;
        this.panneau = panneau;
        setName("inspecteur");
        verdict.setBorder(BorderFactory.createEmptyBorder(MARGE, MARGE, MARGE, MARGE));
        texte.setName("recit");
        texte.getAccessibleContext().setAccessibleName("chaîne du pixel");
        texte.setEditable(false);
        ((DefaultCaret) texte.getCaret()).setUpdatePolicy(DefaultCaret.NEVER_UPDATE);
        texte.setFont(new Font(Font.MONOSPACED, Font.PLAIN, verdict.getFont().getSize()));
        texte.setBorder(verdict.getBorder());
        grille.setPreferredSize(new Dimension(COTE_FIGURES, COTE_FIGURES));
        JPanel bas = new JPanel(new BorderLayout(MARGE, MARGE)) {
            @Override
            public Dimension getPreferredSize() {
                // le texte d'abord : un écran dense n'est parfois haut que de quatre cents points
                return new Dimension(0, Math.min(COTE_FIGURES, Inspecteur.this.getHeight() / 4));
            }
        };
        bas.add(vue, BorderLayout.CENTER);
        bas.add(grille, BorderLayout.LINE_END);
        add(verdict, BorderLayout.PAGE_START);
        add(ascenseur, BorderLayout.CENTER);
        add(bas, BorderLayout.PAGE_END);
        // il n'y a rien à y écrire : + et − sont pour le cadre
        texte.setKeymap(null);
        texte.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent e) {
                int ou = texte.viewToModel(e.getPoint());
                int ligne = texte.getDocument().getDefaultRootElement().getElementIndex(ou);
                Recit.Ligne vue = vues.isEmpty() ? null : vues.get(ligne);
                if (vue != null && vue.repli != null) {
                    deplier(vue.repli);
                } else if (vue != null && vue.rebond() > 0) {
                    isoler(vue.rebond());
                }
            }
        });
        lierTouches(texte, JComponent.WHEN_FOCUSED);
        lierTouches((JComponent) cadre.getContentPane(), JComponent.WHEN_IN_FOCUSED_WINDOW);
        for (int sens : new int[] {-1, 1}) {
            KeyStroke touche = Menus.ctrl(sens < 0 ? KeyEvent.VK_PAGE_UP : KeyEvent.VK_PAGE_DOWN);
            texte.registerKeyboardAction(e -> choisir(grille.voisin(sens)), touche, JComponent.WHEN_FOCUSED);
        }
        texte.registerKeyboardAction(e -> {
            if (texte.getSelectedText() == null) {
                texte.selectAll();
            }
            texte.copy();
            texte.select(0, 0);
        }, Menus.ctrl(KeyEvent.VK_C), JComponent.WHEN_FOCUSED);
        IntStream.range(0, 10).forEach(n -> caracteres.put((char) ('0' + n), () -> isoler(n)));
        caracteres.put('d', () -> deplier(null));
        atelier.prevenir(this::calculer);
        addHierarchyListener(e -> {
            if (!isShowing()) {
                abandonner();
                panneau.suivre(null);
                panneau.superposer(null, null);
            }
        });
    }

    private void lierTouches(JComponent ou, int quand) {
        int[][] sens = {{KeyEvent.VK_LEFT, -1, 0}, {KeyEvent.VK_RIGHT, 1, 0}, {KeyEvent.VK_UP, 0, -1},
            {KeyEvent.VK_DOWN, 0, 1}};
        for (int[] s : sens) {
            for (int pas : new int[] {1, SAUT}) {
                ou.registerKeyboardAction(e -> {
                    if (isShowing()) {
                        montrer(new Point(pixel.x + pas * s[1], pixel.y + pas * s[2]));
                    }
                }, KeyStroke.getKeyStroke(s[0], pas == 1 ? 0 : InputEvent.SHIFT_DOWN_MASK), quand);
            }
        }
    }

    void montrer(Point voulu) {
        pixel = voulu;
        camera = null;
        panneau.suivre(pixel);
        rang = Inspection.AU_CENTRE;
        calculer();
    }

    private void choisir(int voulu) {
        rang = voulu;
        calculer();
    }

    /** Ne montre plus dans les figures que ce rebond ; tous, si c'est déjà lui ou s'il n'existe pas. */
    private void isoler(int numero) {
        if (isShowing()) {
            rebond = numero == rebond ? 0 : numero;
            calculer();
        }
    }

    /** @param repli {@code null} pour tout déplier, ou tout replier */
    private void deplier(String repli) {
        if (isShowing()) {
            depliage.basculer(repli);
            ecrire();
        }
    }

    private void abandonner() {
        if (enCours != null) {
            enCours.arreter();
            enCours = null;
        }
    }

    /** Explique le pixel de l'image montrée, par ce qui l'a dessinée ; ce qui se lit est gris en attendant. */
    private void calculer() {
        Dessin montre = atelier.montre;
        abandonner();
        if (!isShowing() || montre == null) {
            return;
        }
        // d'une image d'une autre taille, le même endroit
        double fois = camera == null ? 1 : (double) montre.getImage().largeur / camera.getLargeur();
        camera = montre.getLancer().getCamera();
        pixel = new Point(Math.max(0, Math.min(camera.getLargeur() - 1, (int) (fois * (pixel.x + 0.5)))),
                Math.max(0, Math.min(camera.getHauteur() - 1, (int) (fois * (pixel.y + 0.5)))));
        Inspection nouvelle = new Inspection(montre.getScene(), montre.getLue().origines, camera,
                montre.getReglages().getProfondeur(), pixel.x, pixel.y);
        int voulu = rang;
        int seul = rebond;
        enCours = nouvelle;
        verdict.setText("calcul…");
        texte.repaint();
        Atelier.confier(fil, () -> {
            nouvelle.faireOuEchouer(voulu);
            List<Recit.Ligne> lignes = new Recit(nouvelle, Nombre::arrondir).raconter();
            lignes.add(1, new Recit.Ligne(ARRONDI, 0, ARRONDI, null, false));
            int garde = seul > nouvelle.getEtapes().size() ? 0 : seul;
            Figure figure = new Figure(nouvelle, garde);
            EventQueue.invokeLater(() -> recevoir(nouvelle, lignes, figure, garde));
        }, verdict::setText);
    }

    private void recevoir(Inspection nouvelle, List<Recit.Ligne> lignes, Figure figure, int seul) {
        if (nouvelle != enCours) {
            return;
        }
        enCours = null;
        rebond = seul;
        depliage.remplacer(atelier.montre.fichier, lignes);
        ecrire();
        boolean connue = nouvelle.getEtapes().stream().allMatch(etape -> etape.inconnue().estNoire());
        verdict.setText(nouvelle.getFaute() != null ? "Ce pixel n'a pu être calculé." : comparer(nouvelle.getCouleur())
                + (connue ? "" : "\nLe récit ne connaît pas tous les termes de cette couleur."));
        grille.montrer(nouvelle);
        vue.montrer(nouvelle, rebond);
        panneau.superposer(figure, this::isoler);
    }

    /** Met à l'écran les lignes qui ne sont pas repliées, à l'endroit du texte où l'on était. */
    private void ecrire() {
        Point place = ascenseur.getViewport().getViewPosition();
        DefaultStyledDocument document = new DefaultStyledDocument();
        vues = depliage.getVues();
        vues.forEach(vue -> ajouter(document, vue));
        // coupées aux blancs seuls : ce que Swing fait d'un texte latin, et non d'un qui a des signes comme ⊗
        document.putProperty("multiByte", false);
        texte.setDocument(document);
        EventQueue.invokeLater(() -> ascenseur.getViewport().setViewPosition(place));
    }

    /** Ajoute une ligne ; sa suite, si elle est trop longue, garde son retrait. */
    private void ajouter(DefaultStyledDocument document, Recit.Ligne ligne) {
        SimpleAttributeSet style = new SimpleAttributeSet();
        if (ligne.changee) {
            StyleConstants.setBackground(style, CHANGE);
        }
        if (ligne.repli != null || ligne.rebond() > 0) {
            StyleConstants.setForeground(style, LIEN);
        }
        float retrait = (ligne.texte.length() - ligne.texte.replaceFirst("^ +", "").length() + 2)
                * texte.getFontMetrics(texte.getFont()).charWidth(' ');
        SimpleAttributeSet paragraphe = new SimpleAttributeSet();
        StyleConstants.setLeftIndent(paragraphe, retrait);
        StyleConstants.setFirstLineIndent(paragraphe, -retrait);
        try {
            int debut = document.getLength();
            document.insertString(debut, debut == 0 ? ligne.texte : "\n" + ligne.texte, style);
            document.setParagraphAttributes(document.getLength(), 0, paragraphe, false);
        } catch (BadLocationException e) {
            throw new IllegalStateException(e);
        }
    }

    private String comparer(Couleur couleur) {
        ImageMemoire image = atelier.getImageComplete();
        if (image == null) {
            return "L'image n'est pas achevée : rien encore à quoi comparer.";
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
