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
import java.util.function.DoublePredicate;
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
import lancer.commande.Etape;
import lancer.commande.Aide;
import lancer.commande.Reglages;
import lancer.contrat.Parametre;
import lancer.contrat.Section;
import lancer.contrat.Variante;
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
        JComboBox<Etape> etapes = choix(Etape.values(), etape -> changer(reglages().avecEtape(etape)));
        etapes.setToolTipText("F6 à F9");
        poser("étape du cours", etapes, null, () -> etapes.setSelectedItem(reglages().getEtape()));
        saisir("réflexions", "un entier de 0 à " + Aide.REFLETS_MAX + ", ou les touches + et −",
                n -> n >= 0 && n <= Aide.REFLETS_MAX && n == Math.rint(n),
                n -> changer(reglages().avecReflets(n.intValue())), () -> (double) reglages().getReflets());
        saisir("seuil des reflets", "un nombre positif ou nul, par exemple 0.001",
                n -> n >= 0 && n < Double.POSITIVE_INFINITY,
                n -> changer(reglages().avecSeuil(n)), () -> reglages().getSeuil());
        for (Variante presente : reglages().getVariantes()) {
            // chaque lecture de la scène crée de nouvelles variantes
            Supplier<Variante> variante = () -> reglages().getVariante(presente.getSection());
            JCheckBox boite = new JCheckBox(presente.getSection());
            boite.setName(presente.getSection());
            boite.addActionListener(e -> changer(reglages().avecVariante(variante.get(), boite.isSelected())));
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
        controleur.prevenir(etat -> montrer());
    }

    private Reglages reglages() {
        return controleur.getEtat().demande.reglages;
    }

    /** Ajoute un nombre à taper. Une valeur impossible est dite, et laissée à corriger. */
    private void saisir(String nom, String attendu, DoublePredicate possible, Consumer<Double> siChange,
            Supplier<Double> present) {
        JFormattedTextField champ = new JFormattedTextField(new JFormattedTextField.AbstractFormatter() {
            @Override
            public Object stringToValue(String texte) throws ParseException {
                double lu = Nombre.lire(texte.trim());
                if (!possible.test(lu)) {
                    controleur.panneau.bandeau.dire(nom + " : valeur impossible, " + Texte.cite(texte)
                            + " ; attendu : " + attendu);
                    throw new ParseException(texte, 0);
                }
                return lu;
            }

            @Override
            public String valueToString(Object valeur) {
                return valeur == null ? "" : Nombre.ecrire((Double) valeur);
            }
        });
        champ.setColumns(COLONNES);
        champ.setToolTipText(attendu);
        champ.addPropertyChangeListener("value", e -> siChange.accept((Double) champ.getValue()));
        poser(nom, champ, null, () -> {
            // un texte que l'on écrit reste, tant que la valeur est la même
            if (!present.get().equals(champ.getValue())) {
                champ.setValue(present.get());
            }
        });
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
                glisser(section, parametre.cle + ", " + COULEURS[k], variante, parametre, composante, k);
            }
        } else if (parametre.estUnNombre()) {
            glisser(section, parametre.cle, variante, parametre, parametre, 0);
        } else {
            JComboBox<String> mots = choix(parametre.valeurs.toArray(new String[0]),
                    mot -> regler(variante.get(), parametre, mot));
            mots.setName(section + parametre.cle);
            poser(parametre.cle, mots, null, () -> {
                mots.setSelectedItem(reglages().getValeur(variante.get(), parametre));
                mots.setEnabled(reglages().estBranchee(variante.get()));
            });
        }
    }

    /** Ajoute une glissière pour le nombre de ce rang d'une valeur. */
    private void glisser(String section, String nom, Supplier<Variante> variante, Parametre parametre,
            Parametre echelle, int rang) {
        Supplier<String[]> nombres = () -> {
            String valeur = reglages().getValeur(variante.get(), parametre);
            return valeur == null ? new String[] {"—"} : valeur.trim().split("[ \t]+");
        };
        JLabel nombre = new JLabel();
        JSlider glissiere = new JSlider(0, echelle.valeurs.size() - 1, 0);
        glissiere.setName(section + nom);
        glissiere.setPreferredSize(new Dimension(LARGEUR, glissiere.getPreferredSize().height));
        // sans cet écart, les flèches du clavier n'auraient pas d'effet
        glissiere.setMinorTickSpacing(1);
        glissiere.setSnapToTicks(true);
        glissiere.addChangeListener(e -> {
            String[] voulus = nombres.get();
            voulus[rang] = echelle.valeurs.get(glissiere.getValue());
            regler(variante.get(), parametre, String.join(" ", voulus));
        });
        poser(nom, glissiere, nombre, () -> {
            nombre.setText(nombres.get()[rang]);
            glissiere.setEnabled(reglages().estBranchee(variante.get()));
            if (!glissiere.getValueIsAdjusting()) {
                glissiere.setValue(echelle.getRang(nombres.get()[rang]));
            }
        });
    }

    private void regler(Variante variante, Parametre parametre, String voulue) {
        Section section = reglages().getSection(variante);
        if (!miseAJour && !voulue.equals(section.mot(parametre.cle, null))) {
            changer(reglages().avecSection(variante, section.avec(parametre.cle, voulue, parametre.autre)));
        }
    }

    private void changer(Reglages voulus) {
        if (!miseAJour) {
            // après un clic, Espace compare les images ; un réglage atteint par Tab garde ses touches
            if (EventQueue.getCurrentEvent() instanceof MouseEvent) {
                controleur.panneau.requestFocusInWindow();
            }
            controleur.regler(voulus);
        }
    }

    private void montrer() {
        miseAJour = true;
        ajustements.forEach(Runnable::run);
        miseAJour = false;
    }
}
