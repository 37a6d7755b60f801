package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.faire;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.event.KeyEvent;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import javax.swing.JTextField;
import lancer.commande.Option;
import lancer.commande.Reglages;
import org.junit.jupiter.api.Test;

/** Les réglages du menu Dessin : l'image qu'ils donnent, et le fichier de la scène, qu'ils ne changent pas. */
class FenetreReglagesTest extends EssaiFenetre {

    @Test
    void lesTouchesPlusEtMoinsChangentLesReflexionsEtRienDAutre() throws Exception {
        byte[] avant = Files.readAllBytes(scene);
        ouvrir();
        banc.frapper(KeyEvent.VK_SUBTRACT);
        banc.attendreImage("deux réflexions", attendue("--reflets=2"));
        attendre("elles se disent", () -> banc.resume().contains("2 réflexions"));
        for (int k = 0; k < 5; k++) {
            banc.frapper(KeyEvent.VK_SUBTRACT);
        }
        banc.attendreImage("aucune", attendue("--reflets=0"));
        banc.frapper(KeyEvent.VK_ADD);
        banc.attendreImage("une", attendue("--reflets=1"));
        banc.frapper(KeyEvent.VK_F5);
        attendre("la relecture s'achève", () -> !banc.etat().enCours());
        banc.attendreImage("relire la scène les garde", attendue("--reflets=1"));
        assertArrayEquals(avant, Files.readAllBytes(scene));
    }

    @Test
    void lesReflexionsEtLeSeuilDeLOngletSontCeuxDeLImageEtSeTapent() throws Exception {
        ouvrir("--reflets=40", "--seuil=0.01");
        banc.frapper(KeyEvent.VK_F2);
        JTextField reflexions = composant("réflexions", JTextField.class);
        JTextField seuil = composant("seuil des reflets", JTextField.class);
        assertEquals("40", surFilEvenements(reflexions::getText));
        assertEquals("0.01", surFilEvenements(seuil::getText));
        Reglages presents = banc.etat().demande.reglages;
        faire(() -> banc.regler(presents.avec(Option.REFLETS, 1000).avec(Option.SEUIL, 0.25)));
        banc.attendreImage("un réglage venu d'ailleurs", attendue("--reflets=1000", "--seuil=0.25"));
        attendre("se voit", () -> reflexions.getText().equals("1000") && seuil.getText().equals("0.25"));
        faire(() -> {
            reflexions.setText("2000");
            reflexions.requestFocusInWindow();
        });
        attendre("le clavier est aux réflexions", reflexions::isFocusOwner);
        banc.frapper(KeyEvent.VK_ENTER);
        banc.attendreMessage("réflexions : valeur impossible, « 2000 » ; attendu : un entier de 0 à 1000");
        assertEquals("2000", surFilEvenements(reflexions::getText), "il reste à corriger");
        fermerLeMessage();
        banc.cliquer(seuil, 5, 5);
        attendre("le clavier est au seuil", seuil::isFocusOwner);
        faire(seuil::selectAll);
        for (int touche : new int[] {KeyEvent.VK_0, KeyEvent.VK_PERIOD, KeyEvent.VK_5, KeyEvent.VK_ENTER}) {
            banc.frapper(touche);
        }
        banc.attendreImage("celui qui est tapé", attendue("--reflets=1000", "--seuil=0.5"));
        faire(seuil::selectAll);
        banc.frapper(KeyEvent.VK_MINUS);
        banc.frapper(KeyEvent.VK_1);
        banc.frapper(KeyEvent.VK_ENTER);
        banc.attendreMessage("seuil des reflets : valeur impossible, « -1 » ; attendu : un nombre positif ou nul");
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("Échap rend celui de l'image", () -> seuil.getText().equals("0.5"));
        assertEquals(1000, surFilEvenements(() -> banc.etat().demande.reglages.get(Option.REFLETS)), "− était un signe");
    }

    @Test
    void copierDonneLaCommandeQuiDessineLaMemeImage() throws Exception {
        ouvrir();
        banc.frapper(KeyEvent.VK_ADD);
        attendre("dix réflexions", () -> banc.etat().demande.reglages.get(Option.REFLETS) == 10
                && !banc.etat().enCours());
        banc.frapper(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_C);
        String[] copie = {""};
        attendre("la copie", () -> {
            copie[0] = BancFenetre.copie();
            return copie[0].startsWith("; java -");
        });
        banc.attendreMessage("réglages copiés : la commande");
        assertEquals("--taille 320x240 --reflets 10 " + scene + "\n", copie[0].substring(copie[0].indexOf("--taille")));
        assertEquals(ROUGE, new String(Files.readAllBytes(scene), StandardCharsets.UTF_8));
    }
}
