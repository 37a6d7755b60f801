package lancer.fenetre.vue;

import java.awt.BorderLayout;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.Insets;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import lancer.Objet3D;
import lancer.fenetre.etat.Etat;
import lancer.fenetre.etat.Pas;
import lancer.fenetre.etat.Suite;
import lancer.scene.SceneLue;
import lancer.scene.SectionLue;

/** Les nombres d'un objet ou d'une lampe, comme dans le fichier : chacun se change, et se dessine aussitôt. */
@SuppressWarnings("serial")
final class ChampsDeSection extends JPanel implements Vue {

    private static final int MARGE = 4;
    private static final int PAS_DE_MAJ = 10;

    private final Consumer<Suite.Evenement> recevoir;
    private final JLabel titre = new JLabel();
    private final JPanel grille = new JPanel(new GridBagLayout());
    private final Map<String, Champ> champs = new LinkedHashMap<>();
    private String section;

    ChampsDeSection(Consumer<Suite.Evenement> recevoir) {
        super(new BorderLayout());
        this.recevoir = recevoir;
        titre.setName("section");
        titre.putClientProperty("html.disable", true);
        add(titre, BorderLayout.PAGE_START);
        add(grille, BorderLayout.CENTER);
    }

    /** Une valeur. Ce qui s'y écrit reste, tant que la valeur est la même. */
    private final class Champ extends JTextField {

        private final String sienne;
        private final String cle;
        private String valeur = "";

        /** @param sienne sa section, même quand une autre se montre avant qu'il n'ait perdu le clavier */
        Champ(String sienne, String cle) {
            this.sienne = sienne;
            this.cle = cle;
            setName(cle);
            setColumns(cle.equals("rayon") || cle.equals("ns") ? 4 : 9);
            getAccessibleContext().setAccessibleName(cle);
            addActionListener(e -> changer(false));
            addFocusListener(new FocusAdapter() {
                @Override
                public void focusLost(FocusEvent e) {
                    changer(false);
                }
            });
            lier("UP", () -> avancer(1));
            lier("DOWN", () -> avancer(-1));
            lier("shift UP", () -> avancer(PAS_DE_MAJ));
            lier("shift DOWN", () -> avancer(-PAS_DE_MAJ));
        }

        private void lier(String touche, Runnable effet) {
            new Commande(null, touche, etat -> true, null, effet).lier(this, WHEN_FOCUSED);
        }

        private void avancer(int pas) {
            int place = getCaretPosition();
            String voisin = Pas.changer(getText(), place, pas);
            if (voisin != null) {
                setText(voisin);
                changer(true);
                setCaretPosition(Math.min(place, getText().length()));
            }
        }

        private void changer(boolean parFleche) {
            String voulue = getText().trim();
            if (!voulue.equals(valeur)) {
                recevoir.accept(suite -> suite.changer(sienne, cle, voulue, parFleche));
            } else if (isFocusOwner()) {
                recevoir.accept(Suite::oublierLeRefus);
            }
        }

        void montrer(String presente) {
            if (!presente.equals(valeur)) {
                valeur = presente;
                setText(presente);
                setCaretPosition(0);
            }
        }
    }

    @Override
    public void montrer(Etat etat) {
        String nom = etat.getSectionChoisie();
        SectionLue lue = nom == null ? null : etat.demande.lue.getSection(nom);
        if (lue == null) {
            vider(null);
            return;
        }
        List<String> cles = lue.getCles();
        if (!nom.equals(section) || !cles.equals(new ArrayList<>(champs.keySet()))) {
            vider(nom);
            cles.forEach(cle -> champs.put(cle, poser(cle)));
            revalidate();
        }
        titre.setText(etat.demande.lue.getOrigine(etat.demande.lue.getChose(nom)));
        champs.forEach((cle, champ) -> champ.montrer(valeur(lue, cle, etat.demande.lue)));
    }

    private void vider(String nom) {
        if (!champs.isEmpty() || nom != null) {
            section = nom;
            titre.setText(null);
            champs.clear();
            grille.removeAll();
            revalidate();
            repaint();
        }
    }

    /** La valeur écrite ou, à défaut, celle qui sert. */
    private static String valeur(SectionLue lue, String cle, SceneLue scene) {
        String ecrite = lue.mot(cle, null);
        Object chose = scene.getChose(lue.nom);
        if (ecrite != null || !(chose instanceof Objet3D)) {
            return ecrite == null ? "" : ecrite;
        }
        return SceneLue.valeurDeMatiere((Objet3D) chose, cle);
    }

    private Champ poser(String cle) {
        Champ champ = new Champ(section, cle);
        JLabel nom = new JLabel(cle);
        nom.setLabelFor(champ);
        boolean second = champs.size() % 2 == 1;
        grille.add(nom, place(0, 1));
        grille.add(champ, place(1, second ? GridBagConstraints.REMAINDER : 1));
        return champ;
    }

    private static GridBagConstraints place(int part, int colonnes) {
        return new GridBagConstraints(GridBagConstraints.RELATIVE, GridBagConstraints.RELATIVE, colonnes, 1, part, 0,
                GridBagConstraints.LINE_START, GridBagConstraints.HORIZONTAL,
                new Insets(MARGE / 2, 0, 0, MARGE), 0, 0);
    }
}
