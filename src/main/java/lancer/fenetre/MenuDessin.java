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
import lancer.scene.Deplacement;

/** Le menu des réglages du dessin : réflexions et variantes, sans jamais toucher au fichier de la scène. */
final class MenuDessin {

    static final Integer[] REFLEXIONS = {0, 1, 2, 5, 10};
    private static final String[] NOMS_DES_ETAPES = {"Lambert", "+ Phong", "+ ombres", "+ reflets"};

    final JMenu menu = Menus.menu("Dessin");
    private final JMenu reflexions = Menus.menu("Réflexions");
    private final ButtonGroup nombres = new ButtonGroup();
    private final JMenu etapes = Menus.menu("Étapes du cours");
    private final ButtonGroup lesEtapes = new ButtonGroup();
    private final Atelier atelier;
    private final JMenuItem arreter;

    /** @param variantes les noms de celles qui sont présentes */
    MenuDessin(Atelier atelier, List<String> variantes) {
        this.atelier = atelier;
        JMenuItem relire = Menus.article(menu, "Relire la scène et redessiner", Menus.touche(KeyEvent.VK_F5),
                atelier::relire);
        atelier.prevenir(() -> relire.setEnabled(atelier.fichier != null));
        // la touche est liée ailleurs : Java l'afficherait « Escape »
        arreter = Menus.article(menu, "Arrêter (Échap)", null, atelier::arreter);
        menu.addSeparator();
        for (int n : REFLEXIONS) {
            Menus.choix(reflexions, nombres, String.valueOf(n), null, () -> reflechir(n));
        }
        menu.add(Menus.siScene(atelier, reflexions));
        for (Etape etape : Etape.values()) {
            Menus.choix(etapes, lesEtapes, NOMS_DES_ETAPES[etape.ordinal()],
                    KeyStroke.getKeyStroke(KeyEvent.VK_1 + etape.ordinal(),
                            InputEvent.CTRL_DOWN_MASK | InputEvent.ALT_DOWN_MASK),
                    () -> atelier.dessiner(atelier.reglages.avec(etape), false));
        }
        menu.add(Menus.siScene(atelier, etapes));
        reflexions.setMnemonic('x');
        reflexions.setToolTipText("touches + et −");
        for (String nom : variantes) {
            JCheckBoxMenuItem coche = new JCheckBoxMenuItem(nom);
            Menus.siScene(atelier, Menus.article(menu, coche, null, () -> {
                ReglagesDessin reglages = atelier.reglages;
                Variante variante = reglages.getVariante(nom);
                atelier.dessiner(reglages.avec(variante, !reglages.estBranchee(variante)), false);
            }));
            atelier.prevenir(() -> coche.setSelected(atelier.reglages != null
                    && atelier.reglages.estBranchee(atelier.reglages.getVariante(nom))));
        }
        menu.addSeparator();
        Menus.siScene(atelier, menu, "Revenir aux réglages de la scène", null,
                () -> atelier.dessiner(atelier.reglages.initiaux(), false));
        JMenuItem defaire = Menus.article(menu, "Défaire le déplacement", Menus.ctrl(KeyEvent.VK_Z), atelier::defaire);
        atelier.prevenir(() -> defaire.setEnabled(atelier.estDeplacee()));
        Menus.siScene(atelier, menu, "Copier ces réglages",
                KeyStroke.getKeyStroke(KeyEvent.VK_C, Menus.ctrl(0).getModifiers() | InputEvent.SHIFT_DOWN_MASK),
                this::copier);
        atelier.prevenir(this::montrer);
        montrer();
    }

    void changer(boolean plus) {
        if (atelier.reglages != null) {
            int actuel = atelier.reglages.getReflets();
            IntStream autres = Arrays.stream(REFLEXIONS).mapToInt(n -> n).filter(n -> plus ? n > actuel : n < actuel);
            (plus ? autres.min() : autres.max()).ifPresent(this::reflechir);
        }
    }

    private void reflechir(int n) {
        ReglagesDessin reglages = atelier.reglages;
        if (n != reglages.getReflets()) {
            atelier.dessiner(reglages.avec(n, reglages.getSeuil()), false);
        }
    }

    /** Les sections à mettre dans le fichier de scène, et la commande, qui dessinent la même image. */
    private void copier() {
        String sections = atelier.reglages.getSectionsChangees().stream()
                .map(section -> section.ecrire("\n") + "\n\n").collect(Collectors.joining())
                + Deplacement.sections(atelier.adopte.dessin.getLue(), atelier.source.getLue());
        menu.getToolkit().getSystemClipboard().setContents(
                new StringSelection(sections + "; " + atelier.getCommande() + "\n"), null);
        atelier.panneau.bandeau.dire(Sujet.AVIS, "réglages copiés : "
                + (sections.isEmpty() ? "la commande" : "les sections changées et la commande"));
    }

    private void montrer() {
        ReglagesDessin reglages = atelier.reglages;
        arreter.setEnabled(atelier.enCours);
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
