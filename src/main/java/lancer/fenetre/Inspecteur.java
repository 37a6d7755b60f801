package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.EventQueue;
import java.awt.Font;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.ExecutorService;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import javax.swing.text.BadLocationException;
import javax.swing.text.DefaultHighlighter;
import lancer.Camera;
import lancer.Couleur;
import lancer.fenetre.figures.Figure;
import lancer.fenetre.figures.GrilleEchantillons;
import lancer.fenetre.figures.VueDeCote;
import lancer.fils.Traceur;
import lancer.image.ImageMemoire;
import lancer.inspection.Inspection;
import lancer.inspection.Recit;

/**
 * Pourquoi un pixel a sa couleur, dans une fenêtre à côté de l'image, qui suit ce pixel d'un dessin à l'autre. Tout se
 * calcule dans un fil à part.
 */
final class Inspecteur extends JDialog {

    private static final long serialVersionUID = 1;

    private static final int MARGE = 6;
    private static final int LARGEUR = 520;
    private static final int LARGEUR_MIN = 350;
    private static final int HAUTEUR_MIN = 500;
    private static final int SAUT = 10;
    private static final Color CHANGE = new Color(0xFFE9A8);
    private static final String INACHEVEE = "L'image n'est pas achevée : rien encore à quoi comparer.";
    private static final String ARRONDI = "(nombres arrondis à cinq chiffres ; --pixel les écrit en entier)";

    private final transient Atelier atelier;
    private final PanneauImage panneau;
    private final JTextArea texte = new JTextArea(30, 60);
    private final JLabel verdict = new JLabel(" ");
    private final GrilleEchantillons grille = new GrilleEchantillons(this::choisir);
    private final VueDeCote cote = new VueDeCote();
    private final transient ExecutorService fil = Atelier.unFil("lancer-inspection");
    private Point pixel;
    private int rang = Inspection.AU_CENTRE;
    private transient Inspection enCours;
    private transient List<String> dites = Collections.singletonList("");

    Inspecteur(JFrame cadre, Atelier atelier, PanneauImage panneau) {
        super(cadre);
        this.atelier = atelier;
        this.panneau = panneau;
        setName("inspecteur");
        texte.setName("recit");
        texte.getAccessibleContext().setAccessibleName("chaîne du pixel");
        verdict.setName("verdict");
        texte.setEditable(false);
        texte.setLineWrap(true);
        texte.setWrapStyleWord(true);
        texte.setFont(new Font(Font.MONOSPACED, Font.PLAIN, texte.getFont().getSize()));
        texte.setBorder(BorderFactory.createEmptyBorder(MARGE, MARGE, MARGE, MARGE));
        verdict.setBorder(BorderFactory.createEmptyBorder(MARGE, MARGE, MARGE, MARGE));
        JPanel bas = new JPanel(new BorderLayout(MARGE, MARGE));
        bas.add(cote, BorderLayout.CENTER);
        bas.add(grille, BorderLayout.LINE_END);
        add(verdict, BorderLayout.PAGE_START);
        add(new JScrollPane(texte), BorderLayout.CENTER);
        add(bas, BorderLayout.PAGE_END);
        // il n'y a rien à y écrire : + et − sont pour le cadre
        texte.setKeymap(null);
        lierFleches(texte, JComponent.WHEN_FOCUSED);
        lierFleches((JComponent) cadre.getContentPane(), JComponent.WHEN_IN_FOCUSED_WINDOW);
        for (int sens : new int[] {-1, 1}) {
            KeyStroke touche = Menus.ctrl(sens < 0 ? KeyEvent.VK_PAGE_UP : KeyEvent.VK_PAGE_DOWN);
            texte.registerKeyboardAction(e -> choisir(grille.voisin(sens)), touche, JComponent.WHEN_FOCUSED);
        }
        atelier.prevenir(this::calculer);
    }

    private void lierFleches(JComponent ou, int quand) {
        int[] touches = {KeyEvent.VK_LEFT, KeyEvent.VK_RIGHT, KeyEvent.VK_UP, KeyEvent.VK_DOWN};
        for (int pas : new int[] {1, SAUT}) {
            for (int k = 0; k < touches.length; k++) {
                int d = k % 2 == 0 ? -pas : pas;
                int dx = k < 2 ? d : 0;
                int dy = k < 2 ? 0 : d;
                ou.registerKeyboardAction(e -> deplacer(dx, dy),
                        KeyStroke.getKeyStroke(touches[k], pas == 1 ? 0 : InputEvent.SHIFT_DOWN_MASK), quand);
            }
        }
    }

    private void deplacer(int dx, int dy) {
        if (isVisible()) {
            montrer(new Point(pixel.x + dx, pixel.y + dy));
        }
    }

    /** Ouvre la fenêtre sur ce pixel, ou l'y mène. */
    void montrer(Point voulu) {
        pixel = voulu;
        panneau.suivre(pixel);
        rang = Inspection.AU_CENTRE;
        if (!isVisible()) {
            placer();
        }
        calculer();
    }

    private void placer() {
        Window cadre = getOwner();
        Rectangle ecran = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        setSize(Math.max(LARGEUR_MIN, Math.min(LARGEUR, ecran.width - cadre.getWidth())),
                Math.max(HAUTEUR_MIN, cadre.getHeight()));
        Menus.aCote(this);
    }

    private void choisir(int voulu) {
        rang = voulu;
        calculer();
    }

    /** Caché, il n'explique plus rien. */
    @Override
    public void setVisible(boolean visible) {
        super.setVisible(visible);
        if (!visible) {
            abandonner();
            panneau.suivre(null);
            panneau.superposer(null);
        }
    }

    /** La fenêtre du programme se ferme. */
    void terminer() {
        abandonner();
        fil.shutdown();
        dispose();
    }

    private void abandonner() {
        if (enCours != null) {
            enCours.arreter();
            enCours = null;
        }
    }

    /** Explique le pixel, tel que le dessine ce qui dessine maintenant. */
    private void calculer() {
        Traceur lancer = atelier.getTraceur();
        abandonner();
        if (!isVisible() || lancer == null) {
            verdict.setText(INACHEVEE);
            return;
        }
        Camera camera = lancer.getCamera();
        pixel = new Point(Math.max(0, Math.min(camera.getLargeur() - 1, pixel.x)),
                Math.max(0, Math.min(camera.getHauteur() - 1, pixel.y)));
        setTitle("Rayons du pixel " + pixel.x + ", " + pixel.y);
        Inspection nouvelle = new Inspection(lancer.getScene(), atelier.getOrigines(), camera,
                atelier.getReglages().getReflets(), pixel.x, pixel.y);
        int voulu = rang;
        enCours = nouvelle;
        Atelier.confier(fil, () -> {
            nouvelle.faire(voulu);
            List<String> lignes = new Recit(nouvelle, Inspecteur::arrondi).lignes();
            Figure figure = new Figure(nouvelle);
            EventQueue.invokeLater(() -> recevoir(nouvelle, lignes, figure));
        }, verdict::setText);
    }

    private void recevoir(Inspection nouvelle, List<String> lignes, Figure figure) {
        if (nouvelle != enCours) {
            return;
        }
        enCours = null;
        lignes.add(1, ARRONDI);
        if (!lignes.equals(dites)) {
            texte.setText(String.join("\n", lignes));
            texte.setCaretPosition(0);
            if (dites.get(0).equals(lignes.get(0))) {
                surligner();
            }
            dites = lignes;
        }
        verdict.setText(comparer(nouvelle.getCouleur()));
        grille.montrer(nouvelle);
        cote.montrer(nouvelle);
        panneau.superposer(figure);
    }

    /** Marque les lignes que ce dessin a changées. */
    private void surligner() {
        texte.getHighlighter().removeAllHighlights();
        try {
            for (int k = 0; k < texte.getLineCount(); k++) {
                int debut = texte.getLineStartOffset(k);
                int fin = texte.getLineEndOffset(k);
                if (!dites.contains(texte.getText(debut, fin - debut).replace("\n", ""))) {
                    texte.getHighlighter().addHighlight(debut, fin,
                            new DefaultHighlighter.DefaultHighlightPainter(CHANGE));
                }
            }
        } catch (BadLocationException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Compare cette couleur à celle qui est dessinée, au bit près. */
    private String comparer(Couleur couleur) {
        ImageMemoire image = atelier.getImageComplete();
        if (image == null) {
            return INACHEVEE;
        }
        int k = pixel.y * image.getLargeur() + pixel.x;
        float[] vu = image.getLineaire();
        boolean pareil = image.getCodes()[k] == couleur.getCode() && (vu == null || vu[3 * k] == (float) couleur.r
                && vu[3 * k + 1] == (float) couleur.v && vu[3 * k + 2] == (float) couleur.b);
        String dessine = String.format("#%06X", image.getCodes()[k] & 0xFFFFFF);
        return pareil ? "Au bit près, la couleur du pixel dessiné : " + dessine
                : "Différent du pixel dessiné, qui est " + dessine
                        + (vu == null ? "" : " = " + vu[3 * k] + " " + vu[3 * k + 1] + " " + vu[3 * k + 2]);
    }

    static String arrondi(double x) {
        return String.format(Locale.ROOT, "%.5g", x);
    }
}
