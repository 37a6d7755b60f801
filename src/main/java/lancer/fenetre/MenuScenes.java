package lancer.fenetre;

import java.awt.EventQueue;
import java.awt.event.KeyEvent;
import java.io.File;
import java.io.FileNotFoundException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Scanner;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.prefs.Preferences;
import java.util.stream.Collectors;
import javax.swing.ButtonGroup;
import javax.swing.JMenu;
import lancer.SceneFautive;
import lancer.scene.FichierScene;
import lancer.texte.Texte;

/** Le menu des scènes : celles du dossier de la scène montrée, et les dernières ouvertes, d'une fois à l'autre. */
final class MenuScenes {

    private static final int SCENES_MAX = 40;
    private static final int RECENTES_MAX = 8;
    private static final int OCTETS_LUS = 2048;
    private static final int COMMENTAIRE_MAX = 100;
    private static final String CLE = "scenes";

    final JMenu menu = Menus.menu("Scènes");
    private final Atelier atelier;
    /** L'un après l'autre : la dernière ouverte est la plus récente. */
    private final ExecutorService fil = Atelier.unFil("lancer-scenes");
    /** Le dessin qui a lu la scène montrée, {@code null} s'il n'y en a pas encore. */
    private volatile Tracage montree;
    /** Retenu pour le rester : muet, car qu'un dossier personnel se refuse n'est pas l'affaire de qui dessine. */
    private Logger journal;
    private List<File> voisines = new ArrayList<>();
    private int rang;

    MenuScenes(Atelier atelier) {
        this.atelier = atelier;
        atelier.prevenir(() -> {
            if (montree != atelier.getAdopte()) {
                montrer(atelier.getAdopte());
            }
        });
    }

    /** Lit le dossier de la scène montrée, {@code null} s'il n'y en a pas ; jamais avant la première image. */
    void montrer(Tracage tracage) {
        montree = tracage;
        String fichier = tracage == null ? null : tracage.fichier;
        Atelier.confier(fil, () -> {
            if (tracage != null) {
                tracage.attendreDEtreVu();
            }
            Map<File, String> scenes = fichier == null ? new LinkedHashMap<>() : voisines(fichier);
            List<String> recentes = recentes(fichier);
            EventQueue.invokeLater(() -> {
                if (montree == tracage) {
                    remplir(scenes, recentes);
                }
            });
        }, menu::setToolTipText);
    }

    /** Les scènes du même dossier, et ce qui se lit de chacune. */
    private static Map<File, String> voisines(String fichier) {
        Map<File, String> voisines = new LinkedHashMap<>();
        try {
            Path scene = FichierScene.trouver(fichier);
            String[] noms = scene.toAbsolutePath().getParent().toFile().list();
            Arrays.stream(noms == null ? new String[0] : noms).sorted().map(nom -> scene.resolveSibling(nom).toFile())
                    .filter(f -> f.getName().toLowerCase(Locale.ROOT).endsWith(".ini") && f.isFile())
                    .forEach(f -> voisines.put(f, Texte.echappe(f.getName()) + commentaire(f)));
        } catch (SceneFautive e) {
            // effacée depuis qu'elle a été lue
        }
        return voisines;
    }

    /** Le commentaire par lequel commence ce fichier, vide s'il commence autrement ou ne peut être lu. */
    private static String commentaire(File scene) {
        try (Scanner texte = new Scanner(scene, "UTF-8")) {
            String debut = texte.findWithinHorizon("\\A\uFEFF?\\s*[;#].*", OCTETS_LUS);
            String dit = debut == null ? "" : debut.replaceFirst("^\uFEFF?\\s*[;#]+\\s*", "").trim();
            return dit.isEmpty() ? "" : " — " + Texte.echappe(dit.length() <= COMMENTAIRE_MAX ? dit
                    : dit.substring(0, COMMENTAIRE_MAX) + "…");
        } catch (FileNotFoundException e) {
            // elle se dira illisible quand on l'ouvrira
            return "";
        }
    }

    /** Les dernières ouvertes, la scène montrée d'abord. */
    private List<String> recentes(String fichier) {
        journal = Logger.getLogger("java.util.prefs");
        journal.setLevel(Level.OFF);
        Preferences preferences = Preferences.userRoot().node("lancer");
        Set<String> recentes = new LinkedHashSet<>();
        if (fichier != null && fichier.indexOf('\n') < 0) {
            recentes.add(new File(fichier).getAbsolutePath());
        }
        recentes.addAll(Arrays.asList(preferences.get(CLE, "").split("\n")));
        recentes.remove("");
        List<String> gardees = recentes.stream().limit(RECENTES_MAX).collect(Collectors.toList());
        while (String.join("\n", gardees).length() > Preferences.MAX_VALUE_LENGTH) {
            gardees.remove(gardees.size() - 1);
        }
        preferences.put(CLE, String.join("\n", gardees));
        return gardees;
    }

    private void remplir(Map<File, String> scenes, List<String> recentes) {
        voisines = new ArrayList<>(scenes.keySet());
        rang = montree == null ? -1 : voisines.stream().map(File::getName).collect(Collectors.toList())
                .indexOf(new File(montree.fichier).getName());
        menu.removeAll();
        ButtonGroup groupe = new ButtonGroup();
        for (File scene : voisines.subList(0, Math.min(SCENES_MAX, voisines.size()))) {
            Menus.choix(menu, groupe, scenes.get(scene), null, () -> atelier.ouvrir(scene))
                    .setSelected(voisines.indexOf(scene) == rang);
        }
        menu.addSeparator();
        Menus.article(menu, "Scène suivante", Menus.touche(KeyEvent.VK_PAGE_DOWN), () -> voisine(1))
                .setEnabled(rang >= 0 && rang + 1 < voisines.size());
        Menus.article(menu, "Scène précédente", Menus.touche(KeyEvent.VK_PAGE_UP), () -> voisine(-1))
                .setEnabled(rang > 0);
        menu.addSeparator();
        for (String recente : recentes) {
            Menus.article(menu, Texte.echappe(recente), null, () -> atelier.ouvrir(new File(recente)));
        }
    }

    private void voisine(int pas) {
        if (rang + pas >= 0 && rang + pas < voisines.size()) {
            rang += pas;
            atelier.ouvrir(voisines.get(rang));
        }
    }
}
