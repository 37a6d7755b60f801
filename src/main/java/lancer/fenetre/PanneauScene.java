package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.BorderFactory;
import javax.swing.DefaultCellEditor;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.table.AbstractTableModel;
import javax.swing.table.TableColumn;
import lancer.SceneFautive;
import lancer.scene.Deplacement;
import lancer.scene.Origines;
import lancer.scene.SectionLue;

/** Les objets et les lampes, dans l'ordre du fichier. Une valeur changée est lue comme le fichier le serait. */
@SuppressWarnings("serial")
final class PanneauScene extends JPanel {

    private static final int MARGE = 6;
    private static final int HAUTEUR = 400;
    /** Nombre de sections qui décident de la largeur des colonnes. */
    private static final int REGARDEES = 50;

    /** Les clés de chaque colonne ; une section a au plus une clé d'une colonne. */
    private final List<List<String>> colonnes = new ArrayList<>();
    private final Controleur controleur;
    private final Prise prise;
    private final Valeurs valeurs = new Valeurs();
    private final JTable table = new JTable(valeurs);
    private final JTextField saisie = new JTextField();
    private final JTextArea refus = Bandeau.etiquette("refus");
    /** Le dessin qui a lu la scène montrée. */
    private Tracage lue;

    PanneauScene(Controleur controleur, Prise prise, PanneauImage image) {
        super(new BorderLayout(MARGE, MARGE));
        this.controleur = controleur;
        this.prise = prise;
        setName("scene");
        setBorder(BorderFactory.createEmptyBorder(MARGE, MARGE, MARGE, MARGE));
        table.setName("table");
        table.getAccessibleContext().setAccessibleName("objets et lampes");
        table.setAutoResizeMode(JTable.AUTO_RESIZE_OFF);
        table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        table.getTableHeader().setReorderingAllowed(false);
        // F2 ouvre les réglages, ici comme ailleurs
        table.getInputMap(WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke("F2"), "none");
        table.putClientProperty("terminateEditOnFocusLost", true);
        table.setDefaultEditor(Object.class, new Saisie());
        table.addPropertyChangeListener("tableCellEditor", e -> dire(" "));
        table.getSelectionModel().addListSelectionListener(e -> {
            if (!e.getValueIsAdjusting()) {
                prise.prendre(table.getSelectedRow());
            }
        });
        table.addMouseListener(new MouseAdapter() {
            /** Un clic sur un nom rend le clavier à l'image : les flèches y poussent ce qui est pris. */
            @Override
            public void mouseReleased(MouseEvent e) {
                if (table.columnAtPoint(e.getPoint()) == 0) {
                    image.requestFocusInWindow();
                }
            }
        });
        add(new JScrollPane(table), BorderLayout.CENTER);
        add(refus, BorderLayout.PAGE_END);
        prise.siAutre = this::choisir;
        controleur.prevenir(this::montrer);
        montrer();
    }

    private Origines origines() {
        return controleur.etat.choix.scene.origines;
    }

    private void montrer() {
        if (lue != controleur.etat.lecture) {
            lue = controleur.etat.lecture;
            table.removeEditor();
            colonnes.clear();
            colonnes.addAll(Arrays.asList(Deplacement.CLES, Arrays.asList("rayon"),
                    Arrays.asList("Kd", "couleur"), Arrays.asList("Ks", "Kr")));
            Deplacement.cles(origines()).filter(cle -> colonnes.stream().noneMatch(groupe -> groupe.contains(cle)))
                    .forEach(cle -> colonnes.add(Arrays.asList(cle)));
            valeurs.fireTableStructureChanged();
            IntStream.range(0, valeurs.getColumnCount()).forEach(this::elargir);
            table.setPreferredScrollableViewportSize(new Dimension(table.getPreferredSize().width, HAUTEUR));
            choisir();
        }
        table.repaint();
    }

    /** Donne à cette colonne la largeur de son titre et de quelques valeurs, prises dans toute la scène. */
    private void elargir(int c) {
        TableColumn colonne = table.getColumnModel().getColumn(c);
        Component titre = table.getTableHeader().getDefaultRenderer().getTableCellRendererComponent(table,
                valeurs.getColumnName(c), false, false, -1, c);
        int n = valeurs.getRowCount();
        colonne.setPreferredWidth(2 * MARGE + IntStream.range(0, Math.min(REGARDEES, n))
                .map(k -> n - 1 - k * Math.max(1, n / REGARDEES))
                .map(r -> table.prepareRenderer(table.getCellRenderer(r, c), r, c).getPreferredSize().width)
                .reduce(titre.getPreferredSize().width, Math::max));
    }

    private void choisir() {
        if (!prise.estPris()) {
            table.clearSelection();
        } else if (prise.getRang() != table.getSelectedRow()) {
            table.changeSelection(prise.getRang(), Math.max(0, table.getSelectedColumn()), false, false);
        }
    }

    private void dire(String phrase) {
        refus.setText(phrase);
        saisie.setBorder(BorderFactory.createLineBorder(phrase.equals(" ") ? table.getSelectionBackground()
                : Apparence.couleur("Component.error.focusedBorderColor", "Table.foreground")));
    }

    private final class Valeurs extends AbstractTableModel {

        @Override
        public int getRowCount() {
            return controleur.etat.choix == null ? 0 : origines().getNombre();
        }

        @Override
        public int getColumnCount() {
            return colonnes.size() + 1;
        }

        @Override
        public String getColumnName(int c) {
            return c == 0 ? "section" : String.join(", ", colonnes.get(c - 1));
        }

        /** La clé de cette case : celle que la section donne ou, à défaut, la première qu'elle permet. */
        String cle(SectionLue section, int c) {
            return c == 0 ? null : colonnes.get(c - 1).stream().filter(cle -> section.valeur(cle) != null).findFirst()
                    .orElse(colonnes.get(c - 1).stream().filter(section::estConnue).findFirst().orElse(null));
        }

        @Override
        public Object getValueAt(int r, int c) {
            SectionLue section = Deplacement.section(origines(), r);
            String cle = cle(section, c);
            return c == 0 ? origines().getNom(r) : cle == null ? "—" : section.valeur(cle);
        }

        @Override
        public boolean isCellEditable(int r, int c) {
            return cle(Deplacement.section(origines(), r), c) != null;
        }
    }

    /** La saisie d'une valeur. Une valeur refusée reste dans sa case, et la phrase de la lecture est écrite dessous. */
    private final class Saisie extends DefaultCellEditor {

        Saisie() {
            super(saisie);
            saisie.setName("valeur");
        }

        @Override
        public boolean stopCellEditing() {
            int r = table.getEditingRow();
            String cle = valeurs.cle(Deplacement.section(origines(), r), table.getEditingColumn());
            String actuelle = Deplacement.section(origines(), r).valeur(cle);
            String voulue = saisie.getText().trim();
            try {
                if (!voulue.equals(actuelle == null ? "" : actuelle)) {
                    Choix choix = controleur.etat.choix;
                    controleur.choisir(choix.avec(Deplacement.avec(choix.scene, r, cle, voulue)));
                }
                return super.stopCellEditing();
            } catch (SceneFautive e) {
                dire(e.getMessage());
                return false;
            }
        }
    }
}
