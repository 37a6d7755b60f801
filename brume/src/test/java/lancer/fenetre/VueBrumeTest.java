package lancer.fenetre;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.text.ParseException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import javax.swing.JCheckBox;
import javax.swing.JFormattedTextField;
import javax.swing.JSlider;
import lancer.commande.Option;
import lancer.commande.Options;
import lancer.commande.Reglages;
import lancer.dessin.Demande;
import lancer.essai.Essai;
import lancer.scene.LecteurScene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Une variante dans la fenêtre : sa boîte, les glissières de ses paramètres, et l'image d'avant. */
class VueBrumeTest extends EssaiVue {

    private static final String MATIN = "[Brume du matin]\ncouleur=0.9 0.8 0.7\ndebut=2\nfin=9.75\n";

    private void ouvrirLesReglages(String scene) {
        ouvrir(scene, "--taille=160x120");
        faire("F2");
    }

    private void placer(String nom, int cran) {
        composant(nom, JSlider.class).setValue(cran);
    }

    private void verifierLImage(String scene, String... autres) {
        executer();
        assertArrayEquals(sansFenetre(scene, autres), etat.getImageEntiere().codes);
    }

    @Test
    void saBoiteLaDebrancheEtLaRebranche() {
        ouvrirLesReglages(ROUGE);
        JCheckBox boite = composant("Brume", JCheckBox.class);
        verifierLImage(ROUGE);
        assertTrue(dit("resume").endsWith(", 5 réflexions, [Brume] debut=0 fin=30"), dit("resume"));
        boite.doClick();
        verifierLImage(ROUGE, "--sans=brume");
        assertFalse(dit("resume").contains("Brume") || boite.isSelected() || composant("Brume.densite", JSlider.class).isEnabled());
        faire("Espace");
        assertTrue(dit("resume").matches("avant : .* rayons en .* s, .*, \\[Brume] .*"), "Espace montre l'image d'avant, et ses réglages");
        faire("lâche Espace");
        boite.doClick();
        verifierLImage(ROUGE);
        assertTrue(boite.isSelected() && composant("Brume.densite", JSlider.class).isEnabled());
    }

    @Test
    void uneGlissiereDonneLImageDeLaSectionQueDitLaCopie() {
        ouvrirLesReglages(ROUGE + MATIN);
        assertEquals(4, composant("Brume.debut", JSlider.class).getValue());
        placer("Brume.densite", 19);
        String section = MATIN.replace("fin=9.75", "densite=0.095");
        verifierLImage(ROUGE + section);
        assertTrue(dit("resume").contains("[Brume du matin] couleur=0.9 0.8 0.7 debut=2 densite=0.095"), dit("resume"));
        assertEquals(ROUGE + MATIN, lu(boule));
        faire("Ctrl+Maj+C");
        assertTrue(copie.toString().startsWith(section + "\n; java "), copie.toString());
    }

    /** Ce qui se copie, la section dans la scène et la commande dans un terminal, donne l'image qui se voit. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void laSectionEtLaCommandeCopieesDonnentLaMemeImage(boolean brume) throws Exception {
        ouvrirLesReglages(ROUGE + MATIN);
        placer("Brume.densite", 19);
        Reglages reglages = etat.demande.reglages.avec(Option.REFLETS, 3).avec(Option.SEUIL, 0.01);
        arrive(suite -> suite.regler(reglages.avecVariante(reglages.getVariantes().iterator().next(), brume)));
        faire("achève, Ctrl+Maj+C");
        assertEquals(brume, dit("resume").contains("[Brume du matin]"), dit("resume"));
        int[] vue = etat.getImageEntiere().codes;
        String[] copiees = ("\n" + copie).split("\n; java ");
        fichier("boule.ini", brume ? ROUGE + copiees[0] : ROUGE + MATIN);
        List<String> mots = mots(copiees[1].trim());
        List<String> commande = new ArrayList<>(mots.subList(mots.get(0).equals("-cp") ? 3 : 2, mots.size()));
        Reglages relus = Options.lire(commande.toArray(new String[0]));
        arrive(suite -> suite.montrerLaPremiere(new Demande(LecteurScene.lireEtGarder(relus.scene, part -> { }), relus)));
        faire("achève");
        assertArrayEquals(vue, etat.getImageEntiere().codes, "dans une fenêtre");
        commande.add("--image=" + dossier.resolve("copie.png"));
        assertEquals("", Essai.executer(commande.toArray(new String[0])).erreur);
        assertArrayEquals(vue, codes(dossier.resolve("copie.png")), "et sans fenêtre");
    }

    /** Les mots de cette commande, comme les lit le terminal où on la colle. */
    private static List<String> mots(String commande) throws Exception {
        Process shell = new ProcessBuilder("sh", "-c", "printf '%s\\n' " + commande).start();
        try (BufferedReader lignes = new BufferedReader(new InputStreamReader(shell.getInputStream(), StandardCharsets.UTF_8))) {
            return lignes.lines().collect(Collectors.toList());
        }
    }

    @Test
    void uneSectionChangeeDansLeFichierReprendLaMain() {
        ouvrirLesReglages(ROUGE);
        placer("Brume.fin", 11);
        verifierLImage(ROUGE + "[Brume]\nfin=12\n");
        faire("fichier ns=41");
        verifierLImage(ROUGE.replace("ns=40", "ns=41") + "[Brume]\nfin=12\n");
        fichier("boule.ini", ROUGE + "[Brume]\nfin=20\n");
        faire("observe");
        verifierLImage(ROUGE + "[Brume]\nfin=20\n");
    }

    @Test
    void unReglageImpossibleSeLitEtLImageReste() {
        ouvrirLesReglages(ROUGE);
        placer("Brume.fin", 4);
        placer("Brume.debut", 10);
        assertTrue(message().startsWith("réglage, [Brume], debut : la brume commencerait à « 5 » et finirait à « 5 »"), message());
        assertEquals(0, composant("Brume.debut", JSlider.class).getValue(), "la glissière revient");
        verifierLImage(ROUGE + "[Brume]\nfin=5\n");
        placer("Brume.debut", 2);
        assertEquals("", message());
        verifierLImage(ROUGE + "[Brume]\ndebut=1\nfin=5\n");
    }

    @Test
    void laCouleurSeTapeCommeDansLesScenes() throws Exception {
        ouvrirLesReglages(ROUGE + "[Brume]\nfin=12\n");
        JFormattedTextField couleur = composant("Brume.couleur", JFormattedTextField.class);
        assertEquals("0.8 0.8 0.8", couleur.getText());
        for (String impossible : new String[] {"1 0.2", "1 0.2 2", "rouge"}) {
            couleur.setText(impossible);
            assertThrows(ParseException.class, couleur::commitEdit);
            assertTrue(message().startsWith("couleur : valeur impossible, « " + impossible + " » ; attendu : trois nombres de 0 à 1"),
                    message());
        }
        couleur.setText("1 0.2 0");
        couleur.commitEdit();
        verifierLImage(ROUGE + "[Brume]\nfin=12\ncouleur=1 0.2 0\n");
    }
}
