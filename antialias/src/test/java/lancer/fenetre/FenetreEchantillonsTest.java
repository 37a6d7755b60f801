package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.faire;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Point;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import javax.swing.JComboBox;
import javax.swing.JTextArea;
import javax.swing.JTree;
import javax.swing.SwingUtilities;
import lancer.commande.Option;
import lancer.contrat.Section;
import lancer.commande.Reglages;
import lancer.contrat.Variante;
import lancer.fenetre.vue.figures.GraphiqueVitesse;
import org.junit.jupiter.api.Test;

/** L'inspecteur, avec l'anticrénelage : les échantillons du pixel se voient, et celui du centre est expliqué. */
class FenetreEchantillonsTest extends EssaiInspecteur {

    @Test
    void lesEchantillonsSontDitsEtCeluiDuCentreEstExplique() throws Exception {
        ecrire(ROUGE + "[Antialias]\nn=3\nseuil=0\n");
        ouvrir();
        cliquer(150, 100);
        JTree recit = composant("recit", JTree.class);
        attendre("l'échantillon du centre", () -> lu(recit).contains("\nchaîne de l'échantillon 150.50 100.50\n"));
        assertTrue(surFilEvenements(() -> lu(recit).contains("9 échantillons") && lu(recit).contains("150.17 100.17 : ")));
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
        // petite : chaque image y est assez dessinée en un instant
        banc = new BancFenetre("--taille=100x75", scene.toString());
        banc.imageAchevee();
        banc.frapper(KeyEvent.VK_F3);
        GraphiqueVitesse graphique = composant("vitesse.graphique", GraphiqueVitesse.class);
        JTextArea etat = composant("vitesse.etat", JTextArea.class);
        String debut = "[Antialias] n=2 methode=partage seuil=0.15, 1000 réflexions, seuil 1/128 : ";
        // les points bougent tant que les mesures durent : rien ne se passe entre la visée et le clic
        attendre("la deuxième", () -> {
            Point ou = viser(graphique, etat, debut);
            if (ou != null) {
                graphique.dispatchEvent(new MouseEvent(graphique, MouseEvent.MOUSE_PRESSED, 0, 0, ou.x, ou.y, 1, false,
                        MouseEvent.BUTTON1));
            }
            return ou != null;
        });
        attendre("son image", () -> banc.resume().contains(", 1000 réflexions, seuil 1/128, [Antialias] n=2 "));
        ecrire(ROUGE + "[Antialias]\nn=2\nmethode=partage\nseuil=0.15\n");
        assertArrayEquals(BancFenetre.pixelsSansFenetre(dossier, scene, 100, 75, "--reflets=1000", "--seuil=0.0078125"),
                banc.imageAchevee().codes);
    }

    /** L'endroit du graphique où la souris dit ce réglage, ou {@code null}. */
    private static Point viser(GraphiqueVitesse graphique, JTextArea etat, String debut) {
        for (int x = 0; x < graphique.getWidth(); x += 4) {
            for (int y = 0; y < graphique.getHeight(); y += 4) {
                if (graphique.sous(new Point(x, y)) != null) {
                    graphique.dispatchEvent(new MouseEvent(graphique, MouseEvent.MOUSE_MOVED, 0, 0, x, y, 0, false));
                    if (BancFenetre.delier(etat.getText()).contains("\n" + debut)) {
                        return new Point(x, y);
                    }
                }
            }
        }
        return null;
    }

    @Test
    void leResumeDUnReglageDeF3NeReduitPasLImage() throws Exception {
        banc = new BancFenetre("--taille=800x600", scene.toString());
        banc.imageAchevee();
        Reglages presents = banc.etat().demande.reglages;
        Variante antialias = presents.getEssayee();
        Section section = presents.getSectionEntiere(antialias).avec("n", "8", "").avec("methode", "partage", "").avec("seuil", "0.1", "");
        faire(() -> banc.regler(presents.avec(Option.REFLETS, 1000).avec(Option.SEUIL, 1.0 / 256).avecSection(antialias,
                section)));
        attendre("l'image", () -> banc.resume().contains(", 1000 réflexions, seuil 1/256, [Antialias] n=8 "));
        attendre("à sa taille", () -> banc.reduction() == 1);
    }

    @Test
    void unEchecDUneClasseDuCoursEstSitueDansLeCoursEtNonDansLAnticrenelage() throws Exception {
        banc = new BancFenetre(lente().apresLecture(lue -> lue.objets.get(0).setKd(null)));
        attendre("l'échec se dit", () -> banc.bandeau.getText().contains(" pixels n'ont pu être calculés"));
        assertTrue(banc.message().contains(" (lancer.Objet3D.getColor, Objet3D.java:"), banc.message());
    }
}
