package lancer.fenetre.vue;

import java.awt.BorderLayout;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.function.Consumer;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import lancer.fenetre.etat.Etat;
import lancer.fenetre.etat.Pas;
import lancer.fenetre.etat.Suite;

/** Les nombres d'un objet ou d'une lampe, comme dans le fichier : chacun se change, et se dessine aussitôt. */
@SuppressWarnings("serial")
final class ChampsDeSection extends JPanel implements Vue {

    private static final int PAS_DE_MAJ = 10;

    private final Consumer<Suite.Evenement> recevoir;
    private final JLabel titre = new JLabel();
    private final Grille grille = new Grille();
    private final Map<String, Champ> champs = new LinkedHashMap<>();
    private String section;

    ChampsDeSection(Consumer<Suite.Evenement> recevoir) {
        super(new BorderLayout());
        this.recevoir = recevoir;
        titre.setName("section");
        add(titre, BorderLayout.PAGE_START);
        add(grille, BorderLayout.CENTER);
    }

    @Override
    public void montrer(Etat etat) {
        String nom = etat.getSectionChoisie();
        Map<String, String> valeurs = nom == null ? Collections.emptyMap() : etat.demande.lue.getValeurs(nom);
        if (!Objects.equals(nom, section) || !valeurs.keySet().equals(champs.keySet())) {
            section = nom;
            champs.clear();
            grille.removeAll();
            valeurs.keySet().forEach(cle -> ajouter(nom, cle));
            revalidate();
            repaint();
        }
        titre.setText(valeurs.isEmpty() ? null : etat.demande.lue.getOrigine(etat.demande.lue.getChose(nom)));
        champs.forEach((cle, champ) -> champ.montrer(valeurs.get(cle)));
    }

    private void ajouter(String celle, String cle) {
        boolean court = cle.equals("rayon") || cle.equals("ns");
        Champ champ = new Champ(court ? 4 : 9, recevoir, voulue -> suite -> suite.changer(celle, cle, voulue, false));
        champ.setName(cle);
        for (int pas : new int[] {1, -1, PAS_DE_MAJ, -PAS_DE_MAJ}) {
            String touche = (Math.abs(pas) == 1 ? "" : "shift ") + (pas > 0 ? "UP" : "DOWN");
            champ.registerKeyboardAction(e -> avancer(celle, cle, pas), KeyStroke.getKeyStroke(touche), WHEN_FOCUSED);
        }
        grille.nommer(cle, champ, champs.size() % 2 == 1);
        champs.put(cle, champ);
    }

    /** Change d'autant de pas le nombre où est le curseur. */
    private void avancer(String celle, String cle, int pas) {
        Champ champ = champs.get(cle);
        int place = champ.getCaretPosition();
        String voisin = Pas.changer(champ.getText(), place, pas);
        if (voisin != null) {
            champ.setText(voisin);
            recevoir.accept(suite -> suite.changer(celle, cle, voisin, true));
            champ.setCaretPosition(Math.min(place, champ.getText().length()));
        }
    }
}
