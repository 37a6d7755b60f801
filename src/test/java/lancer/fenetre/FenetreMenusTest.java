package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.faire;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.awt.event.ActionListener;
import java.awt.event.KeyEvent;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JPanel;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.MenuElement;
import javax.swing.MenuSelectionManager;
import javax.swing.plaf.basic.BasicHTML;
import lancer.Main;
import org.junit.jupiter.api.Test;

/** La fenêtre sans souris : les menus, le bouton et l'image, touche après touche. */
class FenetreMenusTest extends EssaiFenetre {

    private final List<String> faits = new ArrayList<>();

    /** Ce que le clavier désigne dans les menus ouverts ; {@code null} si aucun ne l'est. */
    private static MenuElement designe() throws Exception {
        return surFilEvenements(FenetreMenusTest::auBout);
    }

    private static MenuElement auBout() {
        MenuElement[] chemin = MenuSelectionManager.defaultManager().getSelectedPath();
        return chemin.length == 0 ? null : chemin[chemin.length - 1];
    }

    private void presser(int touche) throws Exception {
        MenuElement avant = designe();
        banc.frapper(touche);
        attendre("la touche " + KeyEvent.getKeyText(touche) + " a mené ailleurs que sur " + avant, () -> auBout() != avant);
    }

    private void menerA(MenuElement voulu) throws Exception {
        for (int k = 0; designe() != voulu; k++) {
            if (k > 60) {
                fail("les flèches ne mènent pas à " + voulu);
            }
            presser(KeyEvent.VK_DOWN);
        }
    }

    private void ouvrirLeMenu(int rang) throws Exception {
        presser(KeyEvent.VK_F10);
        for (int k = 0; k < rang; k++) {
            presser(KeyEvent.VK_RIGHT);
        }
    }

    /** Choisit un article par les flèches et Entrée, et rend le clavier. */
    private void choisir(int menu, JMenu sousMenu, JMenuItem article) throws Exception {
        String nom = surFilEvenements(article::getText);
        faire(() -> {
            // ce qu'il ferait n'importe pas ici : fermer la fenêtre, ouvrir un dialogue
            for (ActionListener action : article.getActionListeners()) {
                article.removeActionListener(action);
            }
            article.addActionListener(e -> faits.add(nom));
        });
        ouvrirLeMenu(menu);
        if (sousMenu != null) {
            menerA(sousMenu);
            presser(KeyEvent.VK_RIGHT);
        }
        menerA(article);
        presser(KeyEvent.VK_ENTER);
        attendre(nom, () -> faits.contains(nom));
        attendre("les menus sont fermés", () -> auBout() == null);
    }

    @Test
    void chaqueArticleDeMenuSeChoisitParLesFlechesEtEntreeSansRienOuvrirDerriere() throws Exception {
        ouvrir();
        JMenuBar menus = banc.cadre.getJMenuBar();
        int nombre = 0;
        for (int k = 0; k < menus.getMenuCount(); k++) {
            JMenu menu = menus.getMenu(k);
            for (int a = 0; a < menu.getItemCount(); a++) {
                JMenuItem article = menu.getItem(a);
                if (article instanceof JMenu) {
                    for (int s = 0; s < ((JMenu) article).getItemCount(); s++) {
                        choisir(k, (JMenu) article, ((JMenu) article).getItem(s));
                        nombre++;
                    }
                } else if (article != null && article.isEnabled()) {
                    choisir(k, null, article);
                    nombre++;
                }
            }
        }
        assertEquals(nombre, faits.size(), faits.toString());
        assertTrue(nombre > 15, faits.toString());
        assertNull(BancFenetre.chercher("pixel", JPanel.class), "l'inspecteur ne s'est pas ouvert derrière");
    }

    /** Le programme, ouvert, puis une touche telle que Java l'écrit. */
    static final class Ailleurs {

        public static void main(String[] args) {
            Main.main(args);
            System.out.println(KeyEvent.getKeyText(KeyEvent.VK_PAGE_DOWN));
            System.exit(0);
        }
    }

    @Test
    void lesTouchesDesMenusSeLisentEnFrancaisQuelleQueSoitLaLangueDeLaMachine() throws Exception {
        BancFenetre.exigerEcran();
        Path dit = dossier.resolve("dit.txt");
        assertEquals(0, BancFenetre.processus(dit, "-Duser.language=en", "-cp", System.getProperty("java.class.path"),
                Ailleurs.class.getName(), scene.toString()).start().waitFor());
        assertEquals("Page suivante", new String(Files.readAllBytes(dit), StandardCharsets.UTF_8).trim());
    }

    @Test
    void leMenuDesScenesListeSonDossierQuandIlSOuvre() throws Exception {
        Files.write(dossier.resolve("chat.ini"), BLEUE.getBytes(StandardCharsets.UTF_8));
        Files.write(dossier.resolve("<html>rien.INI"), BLEUE.getBytes(StandardCharsets.UTF_8));
        ouvrir();
        JMenu scenes = banc.cadre.getJMenuBar().getMenu(3);
        ouvrirLeMenu(3);
        attendre("les trois scènes", () -> scenes.getItemCount() == 3);
        assertEquals("<html>rien.INI", scenes.getItem(0).getText());
        assertNull(scenes.getItem(0).getClientProperty(BasicHTML.propertyKey), "ce qui le dessinerait en HTML");
        assertTrue(scenes.getItem(1).isSelected(), "celle qui est ouverte");
        faire(scenes.getItem(2)::doClick);
        scene = dossier.resolve("chat.ini");
        banc.attendreCodes("l'autre scène", attendue(L, H));
    }
}
