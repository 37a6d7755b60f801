package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.GridLayout;
import java.awt.Insets;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSlider;
import javax.swing.JSpinner;
import javax.swing.JTextField;
import javax.swing.SpinnerNumberModel;
import lancer.commande.Etape;
import lancer.commande.Options;
import lancer.contrat.Parametre;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.dessin.ReglagesDessin;
import lancer.fenetre.Bandeau.Sujet;
import lancer.texte.Nombre;
import lancer.texte.Texte;

/** L'étape du cours, les réflexions, les variantes présentes et leurs paramètres. Un changement redessine l'image. */
@SuppressWarnings("serial")
final class PanneauReglages extends JScrollPane {

    private static final int MARGE = 8;
    private static final int CENT = 100;
    /** Largeur d'une glissière là où la place manque. */
    private static final int LARGEUR = 80;
    private static final int COLONNES = 9;
    private static final String[] COULEURS = {"rouge", "vert", "bleu"};

    /** Temps maximal entre deux changements au clavier d'un même geste. */
    private static final long GESTE_NS = 1_000_000_000;

    private final Controleur controleur;
    private final JPanel grille = new JPanel(new GridBagLayout());
    private final JTextField seuil = new JTextField(COLONNES);
    private double seuilMontre = Double.NaN;
    private final List<Runnable> ajustements = new ArrayList<>();
    /** Vrai pendant que le panneau lui-même change ses composants : l'utilisateur n'a rien changé. */
    private boolean miseAJour;
    private Object dernier;
    private long dernierNs;

    /** À créer quand une scène est lue. */
    PanneauReglages(Controleur controleur) {
        this.controleur = controleur;
        grille.setBorder(BorderFactory.createEmptyBorder(MARGE, MARGE, MARGE, MARGE));
        JComboBox<Etape> etapes = choix(Etape.values(), etape -> changer(reglages().avec(etape), null, false));
        poser("étape du cours", etapes, 0, () -> etapes.setSelectedItem(reglages().getEtape()));
        JSpinner reflexions = new JSpinner(new SpinnerNumberModel(0, 0, Options.REFLETS_MAX, 1));
        reflexions.addChangeListener(e -> changer(reglages().avec((Integer) reflexions.getValue(),
                reglages().getSeuil()), reflexions, false));
        poser("réflexions", reflexions, 1, () -> reflexions.setValue(reglages().getReflets()));
        poser("seuil", seuil, 2, () -> {
            // un texte que l'on écrit reste, tant que le seuil est le même
            if (reglages().getSeuil() != seuilMontre) {
                montrerSeuil();
            }
        });
        seuil.addActionListener(e -> lireSeuil());
        seuil.addFocusListener(new FocusAdapter() {
            @Override
            public void focusLost(FocusEvent e) {
                lireSeuil();
            }
        });
        int ligne = 3;
        for (Variante presente : reglages().getVariantes()) {
            // chaque lecture de la scène crée de nouvelles variantes
            Supplier<Variante> variante = () -> reglages().getVariante(presente.getSection());
            JCheckBox boite = new JCheckBox(presente.getSection());
            boite.setName(presente.getSection());
            boite.addActionListener(e -> changer(reglages().avec(variante.get(), boite.isSelected()), null, false));
            ajustements.add(() -> boite.setSelected(reglages().estBranchee(variante.get())));
            poser(boite, 0, ligne++, 3);
            for (Parametre parametre : presente.getParametres()) {
                ajouter(variante, parametre, ligne++);
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

    private void montrerSeuil() {
        seuilMontre = reglages().getSeuil();
        seuil.setText(Nombre.ecrire(seuilMontre));
    }

    private void lireSeuil() {
        double lu = Nombre.lire(seuil.getText().trim());
        if (lu >= 0 && lu < Double.POSITIVE_INFINITY) {
            changer(reglages().avec(reglages().getReflets(), lu), null, false);
        } else {
            controleur.panneau.bandeau.dire(Sujet.AVIS, "seuil impossible : " + Texte.cite(seuil.getText())
                    + " ; attendu : un nombre positif ou nul, par exemple 0.001");
        }
        montrerSeuil();
    }

    private ReglagesDessin reglages() {
        return controleur.etat.getReglages();
    }

    private <T> JComboBox<T> choix(T[] valeurs, Consumer<T> siChoisie) {
        JComboBox<T> choix = new JComboBox<>(valeurs);
        choix.addActionListener(e -> siChoisie.accept(choix.getItemAt(choix.getSelectedIndex())));
        return choix;
    }

    private void poser(String nom, JComponent composant, int ligne, Runnable ajustement) {
        composant.setName(nom);
        ajustements.add(ajustement);
        JLabel etiquette = new JLabel(nom);
        etiquette.setLabelFor(composant);
        poser(etiquette, 0, ligne, 1);
        poser(composant, 1, ligne, 1);
    }

    private void ajouter(Supplier<Variante> variante, Parametre parametre, int ligne) {
        JLabel nom = new JLabel(parametre.cle);
        JLabel valeur = new JLabel(" ");
        JComponent choix = parametre.estUneCouleur() ? couleur(variante, parametre)
                : parametre.mots.isEmpty() ? glissiere(variante, parametre) : mot(variante, parametre);
        choix.setName(variante.get().getSection() + "." + parametre.cle);
        ajustements.add(() -> {
            String actuelle = valeur(variante, parametre);
            valeur.setText(!parametre.mots.isEmpty() ? " " : actuelle == null ? "—" : actuelle);
            choix.setEnabled(reglages().estBranchee(variante.get()));
        });
        nom.setLabelFor(choix);
        poser(nom, 0, ligne, 1);
        poser(choix, 1, ligne, 1);
        poser(valeur, 2, ligne, 1);
    }

    private void poser(JComponent composant, int x, int y, int colonnes) {
        grille.add(composant, new GridBagConstraints(x, y, colonnes, 1, x == 1 ? 1 : 0, 0,
                GridBagConstraints.LINE_START, GridBagConstraints.HORIZONTAL,
                new Insets(0, colonnes == 1 && x == 0 ? 3 * MARGE : 0, 0, MARGE), 0, 0));
    }

    private String valeur(Supplier<Variante> variante, Parametre parametre) {
        return reglages().getValeur(variante.get(), parametre);
    }

    private JComboBox<String> mot(Supplier<Variante> variante, Parametre parametre) {
        JComboBox<String> choix = choix(parametre.mots.toArray(new String[0]),
                mot -> regler(variante, parametre, mot, false));
        ajustements.add(() -> choix.setSelectedItem(valeur(variante, parametre)));
        return choix;
    }

    /** Trois glissières, une par composante, de 0 à 1 comme dans les fichiers de scène. */
    private JComponent couleur(Supplier<Variante> variante, Parametre parametre) {
        List<JSlider> glissieres = new ArrayList<>();
        JPanel trois = new JPanel(new GridLayout(COULEURS.length, 1)) {
            @Override
            public void setEnabled(boolean possible) {
                super.setEnabled(possible);
                glissieres.forEach(glissiere -> glissiere.setEnabled(possible));
            }
        };
        for (int k = 0; k < COULEURS.length; k++) {
            int composante = k;
            JSlider glissiere = new JSlider(0, CENT, 0);
            glissiere.setPreferredSize(new Dimension(LARGEUR, glissiere.getPreferredSize().height));
            glissiere.setName(parametre.cle + " " + "rvb".charAt(k));
            glissiere.getAccessibleContext().setAccessibleName(parametre.cle + ", " + COULEURS[k]);
            glissiere.addChangeListener(e -> {
                String[] nombres = valeur(variante, parametre).trim().split("[ \t]+");
                nombres[composante] = Nombre.ecrire(glissiere.getValue() / (double) CENT);
                regler(variante, parametre, String.join(" ", nombres), glissiere.getValueIsAdjusting());
            });
            ajustements.add(() -> {
                if (!glissiere.getValueIsAdjusting()) {
                    glissiere.setValue((int) Math.round(CENT * Double.parseDouble(
                            valeur(variante, parametre).trim().split("[ \t]+")[composante])));
                }
            });
            JPanel ligne = new JPanel(new BorderLayout(MARGE, 0));
            ligne.add(new JLabel(COULEURS[k]), BorderLayout.LINE_START);
            ligne.add(glissiere, BorderLayout.CENTER);
            glissieres.add(glissiere);
            trois.add(ligne);
        }
        return trois;
    }

    private JSlider glissiere(Supplier<Variante> variante, Parametre parametre) {
        JSlider glissiere = new Glissiere(parametre);
        glissiere.setPreferredSize(new Dimension(LARGEUR, glissiere.getPreferredSize().height));
        // sans cet écart, les flèches du clavier n'auraient pas d'effet
        glissiere.setMinorTickSpacing(1);
        glissiere.setSnapToTicks(true);
        glissiere.addChangeListener(e -> regler(variante, parametre, parametre.getValeur(glissiere.getValue()),
                glissiere.getValueIsAdjusting()));
        ajustements.add(() -> {
            String actuelle = valeur(variante, parametre);
            if (!glissiere.getValueIsAdjusting()) {
                glissiere.setValue(actuelle == null ? 0 : parametre.getCran(actuelle));
            }
        });
        return glissiere;
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
            changer(reglages().avec(variante.get(), section.avec(parametre.cle, voulue, parametre.autre)), parametre,
                    glisse);
        } else if (!miseAJour && !glisse) {
            // la glissière est lâchée : le geste est fini
            dernier = null;
        }
    }

    /** @param cause ce qui change : le geste continue si c'était déjà cela @param glisse vrai pendant un glissement */
    private void changer(ReglagesDessin voulus, Object cause, boolean glisse) {
        // après un clic, Espace compare les images ; un réglage atteint par Tab garde ses touches
        if (!miseAJour && EventQueue.getCurrentEvent() instanceof MouseEvent) {
            controleur.panneau.requestFocusInWindow();
        }
        if (miseAJour || (voulus + voulus.getOptions()).equals(reglages() + reglages().getOptions())) {
            return;
        }
        long maintenant = System.nanoTime();
        boolean suite = cause != null && cause == dernier && (glisse || maintenant - dernierNs < GESTE_NS);
        dernier = cause;
        dernierNs = maintenant;
        controleur.dessiner(voulus, suite);
    }

    private void montrer() {
        miseAJour = true;
        ajustements.forEach(Runnable::run);
        miseAJour = false;
    }
}
