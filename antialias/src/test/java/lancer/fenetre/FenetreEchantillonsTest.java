package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.faire;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.event.KeyEvent;
import javax.swing.JComboBox;
import javax.swing.JTextArea;
import javax.swing.JTree;
import javax.swing.SwingUtilities;
import lancer.contrat.Section;
import lancer.commande.Reglages;
import lancer.contrat.Variante;
import org.junit.jupiter.api.Test;

/** L'inspecteur, avec l'anticrénelage : les échantillons du pixel se voient, et chacun peut être choisi. */
class FenetreEchantillonsTest extends EssaiInspecteur {

    @Test
    void chaqueEchantillonSeChoisitDUnClicOuDUneToucheEtLePixelResteLeMeme() throws Exception {
        ecrire(ROUGE + "[Antialias]\nn=3\nseuil=0\n");
        ouvrir();
        cliquer(150, 100);
        JTree recit = composant("recit", JTree.class);
        attendre("l'échantillon du centre", () -> lu(recit).contains("\nchaîne de l'échantillon 150.50 100.50\n"));
        String somme = surFilEvenements(() -> lu(recit).replaceAll("(?s).*\n", ""));
        cliquerSur(recit, "150.17 100.17 : ");
        attendre("le premier", () -> lu(recit).contains("\nchaîne de l'échantillon 150.17 100.17\n"));
        presser(KeyEvent.VK_CONTROL, KeyEvent.VK_PAGE_DOWN);
        attendre("le deuxième", () -> lu(recit).contains("\nchaîne de l'échantillon 150.50 100.17\n"));
        attendre("la même somme", () -> lu(recit).endsWith(somme));
        assertFalse(surFilEvenements(() -> lu(recit)).contains("←"), "d'un échantillon à l'autre, rien n'a changé");
        JTextArea verdict = composant("verdict", JTextArea.class);
        attendre("la comparaison", () -> verdict.getText().startsWith("Au bit près"));
    }

    @Test
    void laMethodeSeChoisitParSonMotDansUneListe() throws Exception {
        ecrire(ROUGE + "[Antialias]\nn=3\n");
        ouvrir();
        banc.frapper(KeyEvent.VK_F2);
        JComboBox<?> methode = composant("Antialias.methode", JComboBox.class);
        faire(methode::requestFocusInWindow);
        attendre("le clavier est à la liste", methode::hasFocus);
        banc.frapper(SwingUtilities.getWindowAncestor(methode), KeyEvent.VK_P);
        attendre("le mot", () -> "partage".equals(methode.getSelectedItem()));
        ecrire(ROUGE + "[Antialias]\nn=3\nmethode=partage\n");
        int[] attendue = attendue(L, H);
        banc.attendreImage("l'image suit", attendue);
    }

    @Test
    void f3NommeLaMethodeDeChaqueImageEtMontreCelleQueLOnChoisit() throws Exception {
        ouvrir();
        banc.frapper(KeyEvent.VK_F3);
        JTextArea etat = composant("vitesse.etat", JTextArea.class);
        JTextArea point = composant("vitesse.point", JTextArea.class);
        attendre("deux images", () -> etat.getText().matches("dessin de l'échelon [3-9].*|Un clic.*"));
        for (int k = 0; k < 2; k++) {
            banc.frapper(SwingUtilities.getWindowAncestor(point), KeyEvent.VK_RIGHT);
        }
        attendre("la deuxième", () -> point.getText().startsWith(
                "[Antialias] n=2 methode=partage seuil=0.4, --reflets 1000 --seuil 0.015625 : "));
        banc.frapper(SwingUtilities.getWindowAncestor(point), KeyEvent.VK_ENTER);
        attendre("son image", () -> banc.resume.getText().contains(", 1000 réflexions, seuil 0.015625, [Antialias] n=2 "));
        ecrire(ROUGE + "[Antialias]\nn=2\nmethode=partage\nseuil=0.4\n");
        assertArrayEquals(attendue("--reflets=1000", "--seuil=0.015625"), banc.imageAchevee().codes);
    }

    @Test
    void leResumeDUnReglageDeF3NeReduitPasLImage() throws Exception {
        banc = new BancFenetre("--taille=800x600", scene.toString());
        banc.imageAchevee();
        Reglages presents = banc.controleur.etat.getReglages();
        Variante antialias = presents.getEssayee();
        Section section = presents.getSectionEntiere(antialias).avec("n", "8", "").avec("methode", "partage", "").avec("seuil", "0.1", "");
        faire(() -> banc.controleur.dessiner(presents.avecReflets(1000).avecSeuil(1.0 / 256).avecSection(antialias, section)));
        attendre("l'image", () -> banc.resume.getText().contains(", 1000 réflexions, seuil 0.00390625, [Antialias] n=8 "));
        attendre("à sa taille", () -> banc.panneau.getReduction(banc.panneau.montree) == 1);
    }

    @Test
    void unEchecDUneClasseDuCoursEstSitueDansLeCoursEtNonDansLAnticrenelage() throws Exception {
        banc = new BancFenetre(lente().apresLecture(lue -> lue.objets.get(0).setKd(null)));
        attendre("l'échec se dit", () -> banc.panneau.bandeau.getText().contains(" pixels n'ont pu être calculés"));
        assertTrue(banc.message().contains(" (lancer.Lumiere.apport, Lumiere.java:"), banc.message());
    }
}
