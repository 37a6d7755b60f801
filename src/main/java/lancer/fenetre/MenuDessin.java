package lancer.fenetre;

import java.awt.datatransfer.StringSelection;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.swing.ButtonGroup;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.KeyStroke;
import lancer.commande.Etape;
import lancer.contrat.Variante;
import lancer.dessin.ReglagesDessin;
import lancer.fenetre.Bandeau.Sujet;

/** Le menu des réglages du dessin : réflexions, étapes, variantes. Il ne modifie jamais le fichier de la scène. */
final class MenuDessin {

    static final Integer[] REFLEXIONS = {0, 1, 2, 5, 10};
    private static final String[] NOMS_DES_ETAPES = {"Lambert", "+ Phong", "+ ombres", "+ reflets"};

    final JMenu menu = Menus.menu("Dessin");
    private final JMenu reflexions = Menus.menu("Réflexions");
    private final ButtonGroup nombres = new ButtonGroup();
    private final JMenu etapes = Menus.menu("Étapes du cours");
    private final ButtonGroup lesEtapes = new ButtonGroup();
    private final Controleur controleur;
    private final JMenuItem arreter;

    MenuDessin(Controleur controleur, List<String> variantes) {
        this.controleur = controleur;
        JMenuItem relire = Menus.article(menu, "Relire la scène et redessiner", Menus.touche(KeyEvent.VK_F5),
                controleur::relire);
        controleur.prevenir(() -> relire.setEnabled(controleur.fichier != null));
        // la touche Échap est liée ailleurs : Java l'afficherait en anglais
        arreter = Menus.article(menu, "Arrêter (Échap)", null, controleur::arreter);
        menu.addSeparator();
        for (int n : REFLEXIONS) {
            Menus.choix(reflexions, nombres, String.valueOf(n), null, () -> reflechir(n));
        }
        menu.add(Menus.siScene(controleur, reflexions));
        for (Etape etape : Etape.values()) {
            Menus.choix(etapes, lesEtapes, NOMS_DES_ETAPES[etape.ordinal()],
                    KeyStroke.getKeyStroke(KeyEvent.VK_1 + etape.ordinal(),
                            InputEvent.CTRL_DOWN_MASK | InputEvent.ALT_DOWN_MASK),
                    () -> controleur.dessiner(controleur.reglages.avec(etape), false));
        }
        menu.add(Menus.siScene(controleur, etapes));
        reflexions.setMnemonic('x');
        reflexions.setToolTipText("touches + et −");
        for (String nom : variantes) {
            JCheckBoxMenuItem coche = new JCheckBoxMenuItem(nom);
            Menus.siScene(controleur, Menus.article(menu, coche, null, () -> {
                ReglagesDessin reglages = controleur.reglages;
                Variante variante = reglages.getVariante(nom);
                controleur.dessiner(reglages.avec(variante, !reglages.estBranchee(variante)), false);
            }));
            controleur.prevenir(() -> coche.setSelected(controleur.reglages != null
                    && controleur.reglages.estBranchee(controleur.reglages.getVariante(nom))));
        }
        menu.addSeparator();
        Menus.siScene(controleur, menu, "Revenir aux réglages de la scène", null,
                () -> controleur.dessiner(controleur.reglages.initiaux(), false));
        JMenuItem defaire = Menus.article(menu, "Défaire le déplacement", Menus.ctrl(KeyEvent.VK_Z),
                controleur::defaire);
        controleur.prevenir(() -> defaire.setEnabled(controleur.estDeplacee()));
        Menus.siScene(controleur, menu, "Copier ces réglages",
                KeyStroke.getKeyStroke(KeyEvent.VK_C, Menus.ctrl(0).getModifiers() | InputEvent.SHIFT_DOWN_MASK),
                this::copier);
        controleur.prevenir(this::montrer);
        montrer();
    }

    void changer(boolean plus) {
        if (controleur.reglages != null) {
            int actuel = controleur.reglages.getReflets();
            IntStream autres = Arrays.stream(REFLEXIONS).mapToInt(n -> n).filter(n -> plus ? n > actuel : n < actuel);
            (plus ? autres.min() : autres.max()).ifPresent(this::reflechir);
        }
    }

    private void reflechir(int n) {
        ReglagesDessin reglages = controleur.reglages;
        if (n != reglages.getReflets()) {
            controleur.dessiner(reglages.avec(n, reglages.getSeuil()), false);
        }
    }

    /** Copie les sections à mettre dans le fichier de scène, et la commande, qui donnent cette image. */
    private void copier() {
        String sections = controleur.reglages.getSectionsChangees().stream()
                .map(section -> section.ecrire("\n") + "\n\n").collect(Collectors.joining())
                + controleur.source.getLue().origines.changees(controleur.adopte.dessin.getLue().origines);
        menu.getToolkit().getSystemClipboard().setContents(
                new StringSelection(sections + "; " + controleur.getCommande() + "\n"), null);
        controleur.panneau.bandeau.dire(Sujet.AVIS, "réglages copiés : "
                + (sections.isEmpty() ? "la commande" : "les sections changées et la commande"));
    }

    private void montrer() {
        ReglagesDessin reglages = controleur.reglages;
        arreter.setEnabled(controleur.enCours);
        nombres.clearSelection();
        for (int k = 0; k < REFLEXIONS.length && reglages != null; k++) {
            reflexions.getItem(k).setSelected(REFLEXIONS[k] == reglages.getReflets());
        }
        lesEtapes.clearSelection();
        if (reglages != null) {
            etapes.getItem(reglages.getEtape().ordinal()).setSelected(true);
        }
    }
}
