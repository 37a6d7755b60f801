package lancer.fenetre;

import java.awt.EventQueue;
import java.awt.event.KeyEvent;
import java.io.File;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.stream.Collectors;
import javax.swing.ButtonGroup;
import javax.swing.JMenu;
import lancer.scene.FichierScene;
import lancer.texte.Texte;

/** Le menu des scènes du dossier de la scène montrée. */
final class MenuScenes {

    private static final int SCENES_MAX = 40;

    final JMenu menu = Menus.menu("Scènes");
    private final Controleur controleur;
    private final ExecutorService fil = Controleur.unFil("lancer-scenes");
    /** Le dessin qui a lu la scène montrée, ou {@code null}. */
    private Tracage montree;
    private List<File> voisines;
    private int rang;

    MenuScenes(Controleur controleur) {
        this.controleur = controleur;
        remplir(Collections.emptyList());
        controleur.prevenir(() -> {
            if (montree != controleur.adopte) {
                lister(controleur.adopte);
            }
        });
    }

    /** Lit le dossier de la scène de ce dessin, après l'affichage de la première image. */
    private void lister(Tracage tracage) {
        montree = tracage;
        Controleur.confier(fil, () -> {
            tracage.attendreDEtreVu();
            List<File> trouvees = voisines(tracage.dessin.fichier);
            EventQueue.invokeLater(() -> {
                if (montree == tracage) {
                    remplir(trouvees);
                }
            });
        }, menu::setToolTipText);
    }

    private static List<File> voisines(String fichier) {
        Path scene = FichierScene.trouver(fichier);
        String[] noms = scene.toAbsolutePath().getParent().toFile().list();
        return Arrays.stream(noms == null ? new String[0] : noms).sorted()
                .map(nom -> scene.resolveSibling(nom).toFile())
                .filter(f -> Texte.minuscules(f.getName()).endsWith(".ini") && f.isFile())
                .collect(Collectors.toList());
    }

    private void remplir(List<File> scenes) {
        voisines = scenes;
        menu.setToolTipText(null);
        rang = montree == null ? -1 : scenes.stream().map(File::getName).collect(Collectors.toList())
                .indexOf(new File(montree.dessin.fichier).getName());
        menu.removeAll();
        ButtonGroup groupe = new ButtonGroup();
        for (File scene : scenes.subList(0, Math.min(SCENES_MAX, scenes.size()))) {
            Menus.choix(menu, groupe, Texte.echappe(scene.getName()), null, () -> controleur.ouvrir(scene.getPath()))
                    .setSelected(scenes.indexOf(scene) == rang);
        }
        menu.addSeparator();
        Menus.article(menu, "Scène suivante", Menus.touche(KeyEvent.VK_PAGE_DOWN), () -> voisine(1))
                .setEnabled(rang >= 0 && rang + 1 < scenes.size());
        Menus.article(menu, "Scène précédente", Menus.touche(KeyEvent.VK_PAGE_UP), () -> voisine(-1))
                .setEnabled(rang > 0);
    }

    private void voisine(int pas) {
        if (rang + pas >= 0 && rang + pas < voisines.size()) {
            rang += pas;
            controleur.ouvrir(voisines.get(rang).getPath());
        }
    }
}
