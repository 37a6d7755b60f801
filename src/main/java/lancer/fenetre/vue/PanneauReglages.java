package lancer.fenetre.vue;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Predicate;
import javax.swing.BorderFactory;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSlider;
import lancer.commande.Option;
import lancer.commande.Reglages;
import lancer.contrat.Parametre;
import lancer.contrat.Variante;
import lancer.fenetre.etat.Etat;
import lancer.fenetre.etat.Suite;

/** L'étape du cours, les réflexions, les variantes présentes et leurs paramètres. Un changement redessine l'image. */
@SuppressWarnings("serial")
final class PanneauReglages extends JPanel implements Vue {

    private static final int MARGE = 8;
    /** Largeur d'une glissière là où la place manque. */
    private static final int LARGEUR = 60;
    private static final int COLONNES = 6;
    private static final int LIGNES = 3;

    private final Consumer<Suite.Evenement> recevoir;
    private final Runnable rendreLeClavier;
    private final Grille grille = new Grille();
    /** Ce qui montre dans chaque composant les réglages présents. */
    private final List<Consumer<Reglages>> ajustements = new ArrayList<>();
    /** La commande et les sections qui donnent la même image. */
    private final Etiquette commande = new Etiquette("commande");

    /** @param rendreLeClavier donne le clavier à l'image */
    PanneauReglages(Reglages premiers, Consumer<Suite.Evenement> recevoir, Runnable rendreLeClavier) {
        super(new BorderLayout(0, MARGE));
        this.recevoir = recevoir;
        this.rendreLeClavier = rendreLeClavier;
        Option.enFenetre().forEach(this::ajouter);
        premiers.getVariantes().forEach(this::ajouter);
        setBorder(BorderFactory.createEmptyBorder(MARGE, MARGE, MARGE, MARGE));
        JPanel haut = new JPanel(new BorderLayout()) {
            @Override
            public Dimension getPreferredSize() {
                // jamais plus large que sa place : un écran est parfois étroit
                return new Dimension(0, super.getPreferredSize().height);
            }
        };
        haut.add(grille, BorderLayout.PAGE_START);
        JScrollPane deroulant = new JScrollPane(haut);
        deroulant.setBorder(BorderFactory.createEmptyBorder());
        add(deroulant, BorderLayout.CENTER);
        add(commande.enPlace(LIGNES), BorderLayout.PAGE_END);
    }

    @Override
    public void montrer(Etat etat) {
        // un réglage refusé revient, même si rien n'a changé
        ajustements.forEach(ajustement -> ajustement.accept(etat.demande.reglages));
        commande.setText(Etat.ctrl("Maj+C") + " copie :\n" + etat.direLesReglages());
    }

    private <T> void ajouter(Option<T> option) {
        ajouter("", option.getParametre(), presents -> option.ecrire(presents.get(option)),
                (presents, voulue) -> presents.avec(option, option.lire(voulue)), presents -> true);
    }

    private void ajouter(Variante variante) {
        JCheckBox boite = new JCheckBox(variante.getSection());
        boite.setName(variante.getSection());
        boite.addActionListener(e -> changer(suite -> suite.regler(presents -> presents.avecVariante(variante,
                boite.isSelected()))));
        ajustements.add(presents -> boite.setSelected(presents.estBranchee(variante)));
        grille.poser(boite, 0, true);
        for (Parametre parametre : variante.getParametres()) {
            ajouter(variante.getSection() + ".", parametre, presents -> presents.getValeur(variante, parametre),
                    (presents, voulue) -> presents.avecSection(variante, presents.getSection(variante)
                            .avec(parametre.cle, voulue, parametre.cleIncompatible)),
                    presents -> presents.estBranchee(variante));
        }
    }

    /**
     * Ajoute un réglage.
     *
     * @param prefixe précède le titre dans le nom du composant
     * @param presente sa valeur, ou {@code null} si une autre la remplace
     * @param avec donne les réglages où il a cette valeur
     * @param possible dit s'il a un effet
     */
    private void ajouter(String prefixe, Parametre reglage, Function<Reglages, String> presente,
            BiFunction<Reglages, String, Reglages> avec, Predicate<Reglages> possible) {
        Function<String, Suite.Evenement> changement =
                voulue -> suite -> suite.regler(reglage, voulue, presents -> avec.apply(presents, voulue));
        JLabel valeur = new JLabel();
        JComponent composant;
        if (reglage.estUnNombre()) {
            JSlider glissiere = new JSlider(0, reglage.valeurs.size() - 1, 0);
            glissiere.setPreferredSize(new Dimension(LARGEUR, glissiere.getPreferredSize().height));
            // sans cet écart, les flèches du clavier n'auraient pas d'effet
            glissiere.setMinorTickSpacing(1);
            glissiere.setSnapToTicks(true);
            glissiere.addChangeListener(e -> {
                // elle bouge aussi pour montrer une valeur, parfois d'entre deux crans
                if (glissiere.getValue() != reglage.getRang(valeur.getText())) {
                    changer(changement.apply(reglage.valeurs.get(glissiere.getValue())));
                }
            });
            ajustements.add(presents -> {
                String dite = presente.apply(presents);
                valeur.setText(dite == null ? "—" : dite);
                if (!glissiere.getValueIsAdjusting()) {
                    glissiere.setValue(reglage.getRang(valeur.getText()));
                }
            });
            composant = glissiere;
        } else if (reglage.estUnTexte()) {
            Champ champ = new Champ(COLONNES, recevoir, changement);
            ajustements.add(presents -> champ.montrer(presente.apply(presents)));
            composant = champ;
        } else {
            JComboBox<String> mots = new JComboBox<>(reglage.valeurs.toArray(new String[0]));
            mots.addActionListener(e -> changer(changement.apply(mots.getItemAt(mots.getSelectedIndex()))));
            // le modèle, lui, ne dit rien quand rien ne change
            ajustements.add(presents -> mots.getModel().setSelectedItem(presente.apply(presents)));
            composant = mots;
        }
        composant.setToolTipText(reglage.attendu);
        composant.setName(prefixe + reglage.getTitre());
        ajustements.add(presents -> composant.setEnabled(possible.test(presents)));
        String nom = reglage.getTitre().replace("methode", "méthode").replace("debut", "début")
                .replace("densite", "densité");
        // ceux d'une variante sont en retrait
        grille.nommer(prefixe.isEmpty() ? nom : "     " + nom, composant, !reglage.estUnNombre());
        if (reglage.estUnNombre()) {
            grille.poser(valeur, 0, true);
        }
    }

    private void changer(Suite.Evenement changement) {
        // après un clic, Espace compare les images ; un réglage atteint par Tab garde ses touches
        if (EventQueue.getCurrentEvent() instanceof MouseEvent) {
            rendreLeClavier.run();
        }
        recevoir.accept(changement);
    }
}
