package lancer.fenetre.vue;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.Insets;
import java.awt.event.MouseEvent;
import java.text.ParseException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.BooleanSupplier;
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
import javax.swing.text.InternationalFormatter;
import lancer.commande.Option;
import lancer.commande.Reglages;
import lancer.contrat.Parametre;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.fenetre.etat.Etat;
import lancer.fenetre.etat.Suite;
import lancer.texte.Texte;

/** L'étape du cours, les réflexions, les variantes présentes et leurs paramètres. Un changement redessine l'image. */
@SuppressWarnings("serial")
final class PanneauReglages extends JScrollPane implements Vue {

    private static final int MARGE = 8;
    /** Largeur d'une glissière là où la place manque. */
    private static final int LARGEUR = 60;
    private static final int COLONNES = 6;

    private static final Map<String, String> ACCENTS = new HashMap<>();

    static {
        ACCENTS.put("methode", "méthode");
        ACCENTS.put("debut", "début");
        ACCENTS.put("densite", "densité");
    }

    private final Consumer<Suite.Evenement> recevoir;
    private final Runnable rendreLeClavier;
    private final JPanel grille = new JPanel(new GridBagLayout());
    private final List<Runnable> ajustements = new ArrayList<>();
    /** Vrai pendant que le panneau lui-même change ses composants : l'utilisateur n'a rien changé. */
    private boolean miseAJour;

    private Reglages presents;

    /** @param rendreLeClavier donne le clavier à l'image */
    PanneauReglages(Reglages presents, Consumer<Suite.Evenement> recevoir, Runnable rendreLeClavier) {
        this.presents = presents;
        this.recevoir = recevoir;
        this.rendreLeClavier = rendreLeClavier;
        grille.setBorder(BorderFactory.createEmptyBorder(MARGE, MARGE, MARGE, 0));
        Option.enFenetre().forEach(this::ajouter);
        for (Variante presente : reglages().getVariantes()) {
            JCheckBox boite = new JCheckBox(presente.getSection());
            boite.setName(presente.getSection());
            boite.addActionListener(e -> changer(reglages().avecVariante(presente, boite.isSelected())));
            ajustements.add(() -> boite.setSelected(reglages().estBranchee(presente)));
            poser(boite, 0, GridBagConstraints.REMAINDER);
            for (Parametre parametre : presente.getParametres()) {
                ajouter(presente.getSection() + ".", parametre, () -> reglages().getValeur(presente, parametre),
                        voulue -> regler(presente, parametre, voulue),
                        () -> reglages().estBranchee(presente));
            }
        }
        // la grille est placée en haut de l'onglet
        JPanel haut = new JPanel(new BorderLayout());
        haut.add(grille, BorderLayout.PAGE_START);
        setViewportView(haut);
        setBorder(null);
        ajuster();
    }

    @Override
    public void montrer(Etat etat) {
        // un réglage refusé revient, même si rien n'a changé
        presents = etat.demande.reglages;
        ajuster();
    }

    private Reglages reglages() {
        return presents;
    }

    private <T> void ajouter(Option<T> option) {
        ajouter("", option.getParametre(), () -> option.ecrire(reglages().get(option)),
                voulue -> changer(reglages().avec(option, option.lire(voulue))), () -> true);
    }

    /**
     * Ajoute un réglage.
     *
     * @param prefixe précède le titre dans le nom du composant
     * @param present sa valeur, ou {@code null} si une autre la remplace
     * @param possible dit s'il a un effet
     */
    private void ajouter(String prefixe, Parametre reglage, Supplier<String> present, Consumer<String> siChange,
            BooleanSupplier possible) {
        JLabel valeur = new JLabel();
        JComponent composant;
        Consumer<String> montre;
        if (reglage.estUnNombre()) {
            JSlider glissiere = glissiere(reglage, siChange);
            composant = glissiere;
            montre = dite -> {
                valeur.setText(dite == null ? "—" : dite);
                if (!glissiere.getValueIsAdjusting()) {
                    glissiere.setValue(reglage.getRang(valeur.getText()));
                }
            };
        } else if (reglage.valeurs.isEmpty()) {
            JFormattedTextField champ = champ(reglage, siChange);
            composant = champ;
            montre = dite -> {
                // un texte que l'on écrit reste, tant que la valeur est la même
                if (!Objects.equals(dite, champ.getValue())) {
                    champ.setValue(dite);
                }
            };
        } else {
            JComboBox<String> mots = new JComboBox<>(reglage.valeurs.toArray(new String[0]));
            mots.addActionListener(e -> siChange.accept(mots.getItemAt(mots.getSelectedIndex())));
            composant = mots;
            montre = mots::setSelectedItem;
        }
        composant.setToolTipText(reglage.attendu);
        composant.setName(prefixe + reglage.getTitre());
        composant.getAccessibleContext().setAccessibleName(composant.getName());
        JLabel titre = new JLabel(ACCENTS.getOrDefault(reglage.getTitre(), reglage.getTitre()));
        titre.setLabelFor(composant);
        poser(titre, 0, 1);
        // à côté de ce qui se lit en toutes lettres, pas de place perdue : un écran est parfois étroit
        poser(composant, 1, reglage.estUnNombre() ? 1 : GridBagConstraints.REMAINDER);
        if (reglage.estUnNombre()) {
            poser(valeur, 0, GridBagConstraints.REMAINDER);
        }
        ajustements.add(() -> {
            montre.accept(present.get());
            composant.setEnabled(possible.getAsBoolean());
        });
    }

    /** Un texte à taper. Une valeur impossible est dite, et laissée à corriger. */
    private JFormattedTextField champ(Parametre reglage, Consumer<String> siChange) {
        JFormattedTextField champ = new JFormattedTextField(new InternationalFormatter() {
            @Override
            public Object stringToValue(String texte) throws ParseException {
                if (!reglage.accepte(texte.trim())) {
                    String faute = texte.trim().isEmpty() ? "aucune valeur" : "valeur impossible, " + Texte.cite(texte);
                    recevoir.accept(suite -> suite.refuser(reglage.getTitre() + " : " + faute + " ; attendu : "
                            + reglage.attendu));
                    throw new ParseException(texte, 0);
                }
                recevoir.accept(Suite::oublierLeRefus);
                return texte.trim();
            }
        });
        champ.setColumns(COLONNES);
        champ.addPropertyChangeListener("value", e -> siChange.accept((String) champ.getValue()));
        return champ;
    }

    private static JSlider glissiere(Parametre reglage, Consumer<String> siChange) {
        JSlider glissiere = new JSlider(0, reglage.valeurs.size() - 1, 0);
        glissiere.setPreferredSize(new Dimension(LARGEUR, glissiere.getPreferredSize().height));
        // sans cet écart, les flèches du clavier n'auraient pas d'effet
        glissiere.setMinorTickSpacing(1);
        glissiere.setSnapToTicks(true);
        glissiere.addChangeListener(e -> siChange.accept(reglage.valeurs.get(glissiere.getValue())));
        return glissiere;
    }

    private void poser(JComponent composant, int part, int colonnes) {
        grille.add(composant, new GridBagConstraints(GridBagConstraints.RELATIVE, GridBagConstraints.RELATIVE, colonnes,
                1, part, 0, GridBagConstraints.LINE_START, GridBagConstraints.HORIZONTAL,
                new Insets(0, colonnes == 1 && part == 0 ? 3 * MARGE : 0, 0, MARGE), 0, 0));
    }

    private void regler(Variante variante, Parametre parametre, String voulue) {
        Section section = reglages().getSection(variante);
        if (!miseAJour && !voulue.equals(section.mot(parametre.cle, null))) {
            changer(reglages().avecSection(variante, section.avec(parametre.cle, voulue, parametre.cleIncompatible)));
        }
    }

    private void changer(Reglages voulus) {
        if (!miseAJour) {
            // après un clic, Espace compare les images ; un réglage atteint par Tab garde ses touches
            if (EventQueue.getCurrentEvent() instanceof MouseEvent) {
                rendreLeClavier.run();
            }
            recevoir.accept(suite -> suite.regler(voulus));
        }
    }

    private void ajuster() {
        miseAJour = true;
        ajustements.forEach(Runnable::run);
        miseAJour = false;
    }
}
