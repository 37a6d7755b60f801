package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.Insets;
import java.awt.event.MouseEvent;
import java.text.ParseException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JFormattedTextField;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSlider;
import javax.swing.JSpinner;
import javax.swing.SpinnerNumberModel;
import lancer.commande.Etape;
import lancer.commande.Options;
import lancer.commande.Reglages;
import lancer.contrat.Parametre;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.fenetre.Bandeau.Sujet;
import lancer.texte.Nombre;
import lancer.texte.Texte;

/** L'étape du cours, les réflexions, les variantes présentes et leurs paramètres. Un changement redessine l'image. */
@SuppressWarnings("serial")
final class PanneauReglages extends JScrollPane {

    private static final int MARGE = 8;
    /** Largeur d'une glissière là où la place manque. */
    private static final int LARGEUR = 60;
    private static final int COLONNES = 6;
    private static final String[] COULEURS = {"rouge", "vert", "bleu"};

    private final Controleur controleur;
    private final JPanel grille = new JPanel(new GridBagLayout());
    private final List<Runnable> ajustements = new ArrayList<>();
    /** Vrai pendant que le panneau lui-même change ses composants : l'utilisateur n'a rien changé. */
    private boolean miseAJour;

    /** À créer quand une scène est lue. */
    PanneauReglages(Controleur controleur) {
        this.controleur = controleur;
        grille.setBorder(BorderFactory.createEmptyBorder(MARGE, MARGE, MARGE, MARGE));
        JComboBox<Etape> etapes = choix(Etape.values(), etape -> changer(reglages().avecEtape(etape), null, false));
        poser("étape du cours", etapes, null, () -> etapes.setSelectedItem(reglages().getEtape()));
        JSpinner reflexions = new JSpinner(new SpinnerNumberModel(0, 0, Options.REFLETS_MAX, 1));
        reflexions.addChangeListener(e -> changer(reglages().avecReflets((Integer) reflexions.getValue()), reflexions,
                false));
        poser("réflexions", reflexions, null, () -> reflexions.setValue(reglages().getReflets()));
        JFormattedTextField seuil = new JFormattedTextField(new Seuil());
        seuil.setColumns(COLONNES);
        seuil.setFocusLostBehavior(JFormattedTextField.COMMIT_OR_REVERT);
        seuil.addPropertyChangeListener("value", e -> changer(
                reglages().avecSeuil((Double) seuil.getValue()), null, false));
        poser("seuil", seuil, null, () -> {
            // un texte que l'on écrit reste, tant que le seuil est le même
            if (!Double.valueOf(reglages().getSeuil()).equals(seuil.getValue())) {
                seuil.setValue(reglages().getSeuil());
            }
        });
        for (Variante presente : reglages().getVariantes()) {
            // chaque lecture de la scène crée de nouvelles variantes
            Supplier<Variante> variante = () -> reglages().getVariante(presente.getSection());
            JCheckBox boite = new JCheckBox(presente.getSection());
            boite.setName(presente.getSection());
            boite.addActionListener(
                    e -> changer(reglages().avecVariante(variante.get(), boite.isSelected()), null, false));
            ajustements.add(() -> boite.setSelected(reglages().estBranchee(variante.get())));
            poser(boite, 0, GridBagConstraints.REMAINDER);
            for (Parametre parametre : presente.getParametres()) {
                ajouter(variante, parametre);
            }
        }
        // la grille est placée en haut de l'onglet
        JPanel haut = new JPanel(new BorderLayout());
        haut.add(grille, BorderLayout.PAGE_START);
        setViewportView(haut);
        setBorder(null);
        montrer();
        controleur.prevenir(this::montrer);
    }

    private Reglages reglages() {
        return controleur.etat.getReglages();
    }

    /** Lecture et écriture du seuil. Un seuil impossible est dit, et laissé à corriger. */
    private final class Seuil extends JFormattedTextField.AbstractFormatter {

        @Override
        public Object stringToValue(String texte) throws ParseException {
            double lu = Nombre.lire(texte.trim());
            if (lu >= 0 && lu < Double.POSITIVE_INFINITY) {
                return lu;
            }
            controleur.panneau.bandeau.dire(Sujet.AVIS, "seuil impossible : " + Texte.cite(texte)
                    + " ; attendu : un nombre positif ou nul, par exemple 0.001");
            throw new ParseException(texte, 0);
        }

        @Override
        public String valueToString(Object seuil) {
            return seuil == null ? "" : Nombre.ecrire((Double) seuil);
        }
    }

    private <T> JComboBox<T> choix(T[] valeurs, Consumer<T> siChoisie) {
        JComboBox<T> choix = new JComboBox<>(valeurs);
        choix.addActionListener(e -> siChoisie.accept(choix.getItemAt(choix.getSelectedIndex())));
        return choix;
    }

    /** Ajoute une ligne. @param valeur composant de droite, ou {@code null} */
    private void poser(String nom, JComponent composant, JLabel valeur, Runnable ajustement) {
        JLabel etiquette = new JLabel(nom);
        etiquette.setLabelFor(composant);
        composant.setName(composant.getName() == null ? nom : composant.getName());
        ajustements.add(ajustement);
        poser(etiquette, 0, 1);
        poser(composant, 1, valeur == null ? GridBagConstraints.REMAINDER : 1);
        if (valeur != null) {
            poser(valeur, 0, GridBagConstraints.REMAINDER);
        }
    }

    private void poser(JComponent composant, int part, int colonnes) {
        grille.add(composant, new GridBagConstraints(GridBagConstraints.RELATIVE, GridBagConstraints.RELATIVE, colonnes,
                1, part, 0, GridBagConstraints.LINE_START, GridBagConstraints.HORIZONTAL,
                new Insets(0, colonnes == 1 && part == 0 ? 3 * MARGE : 0, 0, MARGE), 0, 0));
    }

    private void ajouter(Supplier<Variante> variante, Parametre parametre) {
        String section = variante.get().getSection() + ".";
        if (parametre.estUneCouleur()) {
            Parametre composante = Parametre.nombre(parametre.cle, null, 0, 1, 0.01);
            for (int k = 0; k < COULEURS.length; k++) {
                String nom = parametre.cle + ", " + COULEURS[k];
                glisser(nom, section + nom, variante, parametre, composante, k);
            }
        } else if (parametre.mots.isEmpty()) {
            glisser(parametre.cle, section + parametre.cle, variante, parametre, parametre, 0);
        } else {
            JComboBox<String> mots = choix(parametre.mots.toArray(new String[0]),
                    mot -> regler(variante, parametre, mot, false));
            mots.setName(section + parametre.cle);
            poser(parametre.cle, mots, null, () -> {
                mots.setSelectedItem(reglages().getValeur(variante.get(), parametre));
                mots.setEnabled(reglages().estBranchee(variante.get()));
            });
        }
    }

    /** Ajoute une glissière pour le nombre de ce rang d'une valeur. */
    private void glisser(String nom, String nomComplet, Supplier<Variante> variante, Parametre parametre,
            Parametre echelle, int rang) {
        Supplier<String[]> nombres = () -> {
            String valeur = reglages().getValeur(variante.get(), parametre);
            return valeur == null ? new String[] {"—"} : valeur.trim().split("[ \t]+");
        };
        JLabel nombre = new JLabel();
        JSlider glissiere = new Glissiere(echelle);
        glissiere.setName(nomComplet);
        glissiere.setPreferredSize(new Dimension(LARGEUR, glissiere.getPreferredSize().height));
        // sans cet écart, les flèches du clavier n'auraient pas d'effet
        glissiere.setMinorTickSpacing(1);
        glissiere.setSnapToTicks(true);
        glissiere.addChangeListener(e -> {
            String[] voulus = nombres.get();
            voulus[rang] = echelle.getValeur(glissiere.getValue());
            regler(variante, parametre, String.join(" ", voulus), glissiere.getValueIsAdjusting());
        });
        poser(nom, glissiere, nombre, () -> {
            nombre.setText(nombres.get()[rang]);
            glissiere.setEnabled(reglages().estBranchee(variante.get()));
            if (!glissiere.getValueIsAdjusting()) {
                glissiere.setValue(echelle.getCran(nombres.get()[rang]));
            }
        });
    }

    /** Une glissière qui donne à un lecteur d'écran la valeur du paramètre, et non le numéro du cran. */
    private static final class Glissiere extends JSlider {

        Glissiere(Parametre parametre) {
            super(0, parametre.crans, 0);
            accessibleContext = new AccessibleJSlider() {
                @Override
                public Number getCurrentAccessibleValue() {
                    return Double.valueOf(parametre.getValeur(getValue()));
                }

                @Override
                public Number getMaximumAccessibleValue() {
                    return Double.valueOf(parametre.getValeur(getMaximum()));
                }
            };
        }
    }

    private void regler(Supplier<Variante> variante, Parametre parametre, String voulue, boolean glisse) {
        Section section = reglages().getSection(variante.get());
        if (!voulue.equals(section.valeur(parametre.cle))) {
            Section changee = section.avec(parametre.cle, voulue, parametre.autre);
            changer(reglages().avecSection(variante.get(), changee), parametre, glisse);
        }
    }

    /** @param cause ce qui change, ou {@code null} @param glisse vrai pendant un glissement */
    private void changer(Reglages voulus, Object cause, boolean glisse) {
        // après un clic, Espace compare les images ; un réglage atteint par Tab garde ses touches
        if (!miseAJour && EventQueue.getCurrentEvent() instanceof MouseEvent) {
            controleur.panneau.requestFocusInWindow();
        }
        if (miseAJour || voulus.equals(reglages())) {
            return;
        }
        controleur.choisir(controleur.etat.choix.avec(voulus), cause, glisse);
    }

    private void montrer() {
        miseAJour = true;
        ajustements.forEach(Runnable::run);
        miseAJour = false;
    }
}
