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

/** Les scènes du dossier de la scène montrée, en tête de leur menu. */
final class MenuScenes {

    private static final int SCENES_MAX = 40;

    private final Controleur controleur;
    private final ExecutorService fil = Controleur.unFil("lancer-scenes");
    private JMenu menu;
    /** Le nombre d'articles du menu qui ne changent pas : les derniers. */
    private int fixes;
    /** La scène demandée, dont le dossier est lu. */
    private String demandee;
    private List<File> voisines = Collections.emptyList();
    private int rang = -1;

    MenuScenes(Controleur controleur) {
        this.controleur = controleur;
    }

    /** Tient à jour le haut de ce menu. */
    JMenu remplir(JMenu vide) {
        menu = vide;
        fixes = vide.getItemCount();
        controleur.prevenir(() -> {
            if (controleur.etat.enCours && !controleur.etat.demande.equals(demandee)) {
                lister(controleur.etat.courant);
            }
        });
        return vide;
    }

    /** Lit le dossier de la scène de ce dessin, après l'affichage de la première image. */
    private void lister(Tracage tracage) {
        demandee = tracage.dessin.fichier;
        Controleur.confier(fil, () -> {
            tracage.attendreDEtreVu();
            List<File> trouvees = voisines(tracage.dessin.fichier);
            EventQueue.invokeLater(() -> {
                if (demandee.equals(tracage.dessin.fichier)) {
                    montrer(trouvees);
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

    private void montrer(List<File> scenes) {
        voisines = scenes;
        menu.setToolTipText(null);
        rang = scenes.stream().map(File::getName).collect(Collectors.toList())
                .indexOf(new File(demandee).getName());
        while (menu.getItemCount() > fixes) {
            menu.remove(0);
        }
        ButtonGroup groupe = new ButtonGroup();
        JMenu articles = new JMenu();
        for (File scene : scenes.subList(0, Math.min(SCENES_MAX, scenes.size()))) {
            groupe.add(Actions.article(articles, new JRadioButtonMenuItem(Texte.echappe(scene.getName()),
                    scenes.indexOf(scene) == rang), null, () -> controleur.ouvrir(scene.getPath())));
        }
        articles.addSeparator();
        for (int k = 0; articles.getItemCount() > 0; k++) {
            menu.add(articles.getMenuComponent(0), k);
        }
        controleur.avertir();
    }

    boolean existe(int pas) {
        return rang >= 0 && rang + pas >= 0 && rang + pas < voisines.size();
    }

    void ouvrir(int pas) {
        rang += pas;
        controleur.ouvrir(voisines.get(rang).getPath());
    }
}
