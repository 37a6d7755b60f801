package lancer.fenetre;

import java.awt.EventQueue;
import java.io.File;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.stream.Collectors;
import javax.swing.ButtonGroup;
import javax.swing.JMenu;
import javax.swing.JRadioButtonMenuItem;
import lancer.scene.FichierScene;
import lancer.texte.Texte;

/** Le menu des scènes du dossier de la scène demandée. */
final class MenuScenes {

    private static final int SCENES_MAX = 40;

    final JMenu menu;
    private final Controleur controleur;
    private final ExecutorService fil = Controleur.unFil("lancer-scenes");
    /** La scène dont le dossier est lu, et les scènes de ce dossier. */
    private String lue;
    private List<File> voisines = Collections.emptyList();

    MenuScenes(Controleur controleur, Actions actions) {
        this.controleur = controleur;
        menu = actions.menu("Scènes",
                actions.ligne("Scène suivante : dans le même dossier", () -> voisine(1) != null,
                        () -> controleur.ouvrir(voisine(1).getPath()), "PAGE_DOWN"),
                actions.ligne("Scène précédente", () -> voisine(-1) != null,
                        () -> controleur.ouvrir(voisine(-1).getPath()), "PAGE_UP"),
                null);
        controleur.prevenir(() -> {
            if (controleur.etat.enCours && !controleur.etat.demande.equals(lue)) {
                lister(controleur.etat.courant);
            }
        });
    }

    private File voisine(int pas) {
        int rang = controleur.etat.demande == null ? -1 : getRang();
        return rang < 0 || rang + pas < 0 || rang + pas >= voisines.size() ? null : voisines.get(rang + pas);
    }

    /** Le rang de la scène demandée dans son dossier, ou −1. */
    private int getRang() {
        return voisines.stream().map(File::getName).collect(Collectors.toList())
                .indexOf(new File(controleur.etat.demande).getName());
    }

    /** Lit le dossier de la scène de ce dessin, après l'affichage de la première image. */
    private void lister(Tracage tracage) {
        lue = tracage.fichier;
        Controleur.confier(fil, () -> {
            tracage.attendreDEtreVu();
            Path scene = FichierScene.trouver(tracage.fichier);
            String[] noms = scene.toAbsolutePath().getParent().toFile().list();
            List<File> trouvees = Arrays.stream(noms == null ? new String[0] : noms).sorted()
                    .map(nom -> scene.resolveSibling(nom).toFile())
                    .filter(f -> Texte.minuscules(f.getName()).endsWith(".ini") && f.isFile())
                    .collect(Collectors.toList());
            EventQueue.invokeLater(() -> montrer(tracage.fichier, trouvees));
        }, menu::setToolTipText);
    }

    private void montrer(String de, List<File> trouvees) {
        if (!de.equals(lue)) {
            return;
        }
        voisines = trouvees;
        menu.setToolTipText(null);
        while (menu.getItemCount() > 3) {
            menu.remove(3);
        }
        ButtonGroup groupe = new ButtonGroup();
        for (File scene : voisines.subList(0, Math.min(SCENES_MAX, voisines.size()))) {
            groupe.add(Actions.article(menu, new JRadioButtonMenuItem(Texte.echappe(scene.getName()),
                    voisines.indexOf(scene) == getRang()), () -> controleur.ouvrir(scene.getPath())));
        }
        controleur.avertir();
    }
}
