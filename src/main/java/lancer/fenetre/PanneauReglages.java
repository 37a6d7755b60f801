package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.GridLayout;
import java.awt.Insets;
import java.util.ArrayList;
import java.util.Arrays;
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
import lancer.commande.Etape;
import lancer.contrat.Parametre;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.dessin.ReglagesDessin;
import lancer.texte.Nombre;

/** L'étape du cours, les réflexions, les variantes présentes et leurs paramètres. Un changement redessine l'image. */
@SuppressWarnings("serial")
final class PanneauReglages extends JScrollPane {

    private static final int MARGE = 8;
    private static final int CENT = 100;

    /** Temps maximal entre deux changements au clavier d'un même geste. */
    private static final long GESTE_NS = 1_000_000_000;

    private final Controleur controleur;
    private final JPanel grille = new JPanel(new GridBagLayout());
    private final List<Runnable> ajustements = new ArrayList<>();
    /** Vrai pendant que le panneau lui-même change ses composants : l'utilisateur n'a rien changé. */
    private boolean miseAJour;
    private Parametre dernier;
    private long dernierNs;

    /** À créer quand une scène est lue. */
    PanneauReglages(Controleur controleur) {
        this.controleur = controleur;
        grille.setBorder(BorderFactory.createEmptyBorder(MARGE, MARGE, MARGE, MARGE));
        choisir("étape du cours", 0, Etape.values(), () -> controleur.etat.getReglages().getEtape(),
                etape -> controleur.dessiner(controleur.etat.getReglages().avec(etape), false));
        choisir("réflexions", 1, new Integer[] {0, 1, 2, 5, 10}, () -> controleur.etat.getReglages().getReflets(),
                n -> controleur.dessiner(controleur.etat.getReglages().avec(n, controleur.etat.getReglages().getSeuil()), false));
        int ligne = 2;
        for (Variante presente : controleur.etat.getReglages().getVariantes()) {
            // chaque lecture de la scène crée de nouvelles variantes
            Supplier<Variante> variante = () -> controleur.etat.getReglages().getVariante(presente.getSection());
            JCheckBox boite = new JCheckBox(presente.getSection());
            boite.setName(presente.getSection());
            boite.addActionListener(e -> {
                dernier = null;
                controleur.dessiner(controleur.etat.getReglages().avec(variante.get(), boite.isSelected()), false);
            });
            ajustements.add(() -> boite.setSelected(controleur.etat.getReglages().estBranchee(variante.get())));
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

    private <T> void choisir(String nom, int ligne, T[] valeurs, Supplier<T> actuelle, Consumer<T> siChoisie) {
        JComboBox<T> choix = new JComboBox<>(valeurs);
        choix.setName(nom);
        choix.addActionListener(e -> {
            if (!miseAJour && choix.getSelectedItem() != null) {
                dernier = null;
                siChoisie.accept(choix.getItemAt(choix.getSelectedIndex()));
            }
        });
        ajustements.add(() -> choix.setSelectedItem(actuelle.get()));
        JLabel etiquette = new JLabel(nom);
        etiquette.setLabelFor(choix);
        poser(etiquette, 0, ligne, 1);
        poser(choix, 1, ligne, 1);
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
            choix.setEnabled(controleur.etat.getReglages().estBranchee(variante.get()));
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
        return controleur.etat.getReglages().getValeur(variante.get(), parametre);
    }

    private JComboBox<String> mot(Supplier<Variante> variante, Parametre parametre) {
        JComboBox<String> choix = new JComboBox<>(parametre.mots.toArray(new String[0]));
        choix.addActionListener(e -> regler(variante, parametre, (String) choix.getSelectedItem(), false));
        ajustements.add(() -> choix.setSelectedItem(valeur(variante, parametre)));
        return choix;
    }

    /** Trois glissières, une par composante, de 0 à 1 comme dans les fichiers de scène. */
    private JComponent couleur(Supplier<Variante> variante, Parametre parametre) {
        JPanel trois = new JPanel(new GridLayout(3, 1)) {
            @Override
            public void setEnabled(boolean possible) {
                super.setEnabled(possible);
                Arrays.stream(getComponents()).forEach(glissiere -> glissiere.setEnabled(possible));
            }
        };
        for (int k = 0; k < 3; k++) {
            int composante = k;
            JSlider glissiere = new JSlider(0, CENT, 0);
            glissiere.setName(parametre.cle + " " + "rvb".charAt(k));
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
            trois.add(glissiere);
        }
        return trois;
    }

    private JSlider glissiere(Supplier<Variante> variante, Parametre parametre) {
        JSlider glissiere = new Glissiere(parametre);
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
        ReglagesDessin reglages = controleur.etat.getReglages();
        Section section = reglages.getSection(variante.get());
        if (!miseAJour && !voulue.equals(section.valeur(parametre.cle))) {
            long maintenant = System.nanoTime();
            boolean suite = parametre == dernier && (glisse || maintenant - dernierNs < GESTE_NS);
            dernier = parametre;
            dernierNs = maintenant;
            controleur.dessiner(reglages.avec(variante.get(),
                    section.avec(parametre.cle, voulue, parametre.autre)), suite);
        } else if (!miseAJour && !glisse) {
            // la glissière est lâchée : le geste est fini
            dernier = null;
        }
    }

    private void montrer() {
        miseAJour = true;
        ajustements.forEach(Runnable::run);
        miseAJour = false;
    }
}
