package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.chercher;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.faire;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Graphics;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import javax.imageio.ImageIO;
import javax.swing.JCheckBox;
import javax.swing.JSlider;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import lancer.commande.Option;
import lancer.commande.Reglages;
import lancer.essai.Essai;
import org.junit.jupiter.api.Test;

/** Une variante dans la fenêtre : sa boîte, les glissières de ses paramètres, et l'image d'avant. */
class FenetreVariantesTest extends EssaiFenetre {

    private int[] sansFenetre(String texte, String... options) throws Exception {
        Path autre = Files.createTempFile(dossier, "autre", ".ini");
        Files.write(autre, texte.getBytes(StandardCharsets.UTF_8));
        return BancFenetre.pixelsSansFenetre(dossier, autre, L, H, options);
    }

    private JSlider glissiere(String nom) throws Exception {
        if (chercher(nom, JSlider.class) == null) {
            banc.frapper(KeyEvent.VK_F2);
            BancFenetre.mettreDevant(SwingUtilities.getWindowAncestor(composant(nom, JSlider.class)));
        }
        return composant(nom, JSlider.class);
    }

    private static void placer(JSlider glissiere, int cran) throws Exception {
        faire(() -> glissiere.setValue(cran));
    }

    @Test
    void saBoiteLaDebrancheEtLaRebranche() throws Exception {
        int[] avec = sansFenetre(ROUGE);
        int[] sans = sansFenetre(ROUGE, "--sans=brume");
        ouvrir();
        banc.attendreImage("avec la brume", avec);
        attendre("elle se dit", () -> banc.resume().endsWith(", 5 réflexions, [Brume] debut=0 fin=30"));
        JSlider densite = glissiere("Brume.densite");
        JCheckBox boite = composant("Brume", JCheckBox.class);
        faire(boite::doClick);
        banc.attendreImage("sans elle", sans);
        attendre("elle ne se dit plus", () -> !banc.resume().contains("Brume"));
        assertFalse(surFilEvenements(() -> boite.isSelected() || densite.isEnabled()));
        faire(boite::doClick);
        banc.attendreImage("de nouveau avec", avec);
        assertTrue(surFilEvenements(() -> boite.isSelected() && densite.isEnabled()));
    }

    @Test
    void uneGlissiereDonneLImageDeLaSectionQuElleEcriraitEtLaCopieLeDit() throws Exception {
        String avant = ROUGE + "[Brume du matin]\ncouleur=0.9 0.8 0.7\ndebut=2\nfin=9.75\n";
        String section = "[Brume du matin]\ncouleur=0.9 0.8 0.7\ndebut=2\ndensite=0.095\n";
        int[] attendue = sansFenetre(ROUGE + section, "--reflets=10");
        ecrire(avant);
        ouvrir();
        JSlider densite = glissiere("Brume.densite");
        JSlider debut = composant("Brume.debut", JSlider.class);
        assertEquals(4, surFilEvenements(debut::getValue));
        placer(densite, 19);
        banc.frapper(KeyEvent.VK_ADD);
        banc.attendreImage("l'image suit", attendue);
        assertArrayEquals(avant.getBytes("UTF-8"), Files.readAllBytes(scene));
        attendre("le résumé aussi", () -> banc.resume().contains("[Brume du matin] couleur=0.9 0.8 0.7 debut=2 densite=0.095"));
        banc.frapper(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_C);
        attendre("la copie donne la section et la commande", () -> {
            String copie = BancFenetre.copie();
            return copie.startsWith(section + "\n; java ") && copie.endsWith(" --taille 320x240 --reflets 10 " + scene + "\n");
        });
    }

    @Test
    void laSectionEtLaCommandeCopieesDonnentLaMemeImageAuBitPresSansFenetreEtAvec() throws Exception {
        ecrire(ROUGE + "[Brume du matin]\ncouleur=0.9 0.8 0.7\ndebut=2\nfin=9.75\n");
        ouvrir();
        placer(glissiere("Brume.densite"), 19);
        reglerEtRecopier("3 réflexions, seuil 0.01, [Brume du matin] ", true, "[Brume du matin]\n");
    }

    @Test
    void sansLaVarianteLaCommandeCopieeSuffit() throws Exception {
        ouvrir();
        reglerEtRecopier("3 réflexions, seuil 0.01", false, "; java ");
    }

    /** Règle la fenêtre, copie, met les lignes dans la scène, et essaie la commande. */
    private void reglerEtRecopier(String dit, boolean brume, String debut) throws Exception {
        faire(() -> {
            Reglages reglages = banc.etat().demande.reglages.avec(Option.REFLETS, 3).avec(Option.SEUIL, 0.01);
            banc.regler(reglages.avecVariante(reglages.getVariantes().iterator().next(), brume));
        });
        attendre("les réglages se disent", () -> banc.resume().contains(dit));
        int[] vue = banc.imageAchevee().codes.clone();
        banc.frapper(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_C);
        attendre("la copie", () -> BancFenetre.copie().startsWith(debut));
        String[] copie = ("\n" + BancFenetre.copie()).split("\n; java ");
        banc.fermer();
        ecrire(ROUGE + copie[0]);
        List<String> mots = mots(copie[1].trim());
        String[] commande = mots.subList(mots.get(0).equals("-cp") ? 3 : 2, mots.size()).toArray(new String[0]);
        Path png = dossier.resolve("copie.png");
        String[] versFichier = Arrays.copyOf(commande, commande.length + 1);
        versFichier[commande.length] = "--image=" + png;
        assertEquals("", Essai.executer(versFichier).erreur);
        assertArrayEquals(vue, BancFenetre.codes(ImageIO.read(png.toFile())));
        banc = new BancFenetre(commande);
        assertArrayEquals(vue, banc.imageAchevee().codes);
    }

    /** Les mots de cette commande, comme les lit le terminal où on la colle. */
    private static List<String> mots(String commande) throws Exception {
        Process shell = new ProcessBuilder("sh", "-c", "printf '%s\\n' " + commande).start();
        try (BufferedReader lignes = new BufferedReader(new InputStreamReader(shell.getInputStream(), StandardCharsets.UTF_8))) {
            return lignes.lines().collect(Collectors.toList());
        }
    }

    @Test
    void uneSectionChangeeDansLeFichierReprendLaMain() throws Exception {
        ouvrir();
        placer(glissiere("Brume.fin"), 11);
        banc.attendreImage("la glissière d'abord", sansFenetre(ROUGE + "[Brume]\nfin=12\n"));
        ecrire(BLEUE);
        banc.attendreImage("elle reste quand le reste de la scène change", sansFenetre(BLEUE + "[Brume]\nfin=12\n"));
        String neuve = BLEUE + "[Brume]\nfin=20\n";
        int[] attendue = sansFenetre(neuve);
        ecrire(neuve);
        banc.attendreImage("la section du fichier ensuite", attendue);
    }

    @Test
    void unReglageImpossibleSeLitEtLImageReste() throws Exception {
        ouvrir();
        int[] avant = banc.imageAchevee().codes;
        placer(glissiere("Brume.fin"), 4);
        attendre("fin est réglée", () -> !banc.etat().enCours());
        int[] cinq = sansFenetre(ROUGE + "[Brume]\nfin=5\n");
        banc.attendreImage("fin est réglée", cinq);
        JSlider debut = composant("Brume.debut", JSlider.class);
        placer(debut, 10);
        banc.attendreMessage("réglage, [Brume], debut : la brume commencerait à « 5 » et finirait à « 5 »");
        assertArrayEquals(cinq, BancFenetre.codes(surFilEvenements(this::sansMessage)));
        attendre("la glissière revient", () -> debut.getValue() == 0);
        placer(debut, 2);
        banc.attendreCodes("une valeur possible", sansFenetre(ROUGE + "[Brume]\ndebut=1\nfin=5\n"));
        assertFalse(Arrays.equals(avant, cinq));
    }

    private BufferedImage sansMessage() {
        BufferedImage image = new BufferedImage(L, H, BufferedImage.TYPE_INT_RGB);
        Graphics g = image.createGraphics();
        // le message couvre le bas ; seule l'image nous importe
        banc.bandeau.setVisible(false);
        g.translate(-(banc.panneau.getWidth() - L) / 2, -(banc.panneau.getHeight() - H) / 2);
        banc.panneau.paint(g);
        banc.bandeau.setVisible(true);
        return image;
    }

    @Test
    void tenirEspaceMontreLImageDAvantAvecSesReglages() throws Exception {
        int[] avec = sansFenetre(ROUGE);
        int[] sans = sansFenetre(ROUGE, "--sans=brume");
        ouvrir();
        glissiere("Brume.densite");
        faire(composant("Brume", JCheckBox.class)::doClick);
        banc.attendreImage("sans la brume", sans);
        faire(banc.panneau::requestFocusInWindow);
        attendre("le clavier est à l'image", banc.panneau::isFocusOwner);
        banc.frapper();
        banc.robot.keyPress(KeyEvent.VK_SPACE);
        attendre("celle d'avant, et ses réglages", () -> Arrays.equals(avec, banc.etat().getVisible().image.codes)
                && banc.resume().matches("avant : .*\\[Brume].*"));
        attendre("ses réglages et son coût", () -> banc.resume().matches(".* rayons en .* s, .*, \\[Brume] .*"));
        banc.robot.keyRelease(KeyEvent.VK_SPACE);
        attendre("puis celle de maintenant", () -> Ecran.trouver(sans, L) != null);
        attendre("et les siens", () -> !banc.resume().contains("Brume"));
    }

    @Test
    void laCouleurSeTapeCommeDansLesScenes() throws Exception {
        ecrire(ROUGE + "[Brume]\nfin=12\n");
        ouvrir();
        glissiere("Brume.fin");
        JTextField couleur = composant("Brume.couleur", JTextField.class);
        assertEquals("0.8 0.8 0.8", surFilEvenements(couleur::getText));
        for (String impossible : new String[] {"1 0.2", "1 0.2 2", "rouge"}) {
            taper(couleur, impossible);
            banc.attendreMessage("couleur : valeur impossible, « " + impossible + " » ; attendu : trois nombres de 0 à 1");
        }
        taper(couleur, "1 0.2 0");
        attendre("elle s'écrit", () -> {
            Reglages reglages = banc.etat().demande.reglages;
            return reglages.getSection(reglages.getVariantes().iterator().next()).ecrire(" ").endsWith("couleur=1 0.2 0");
        });
        banc.attendreImage("l'image suit", sansFenetre(ROUGE + "[Brume]\nfin=12\ncouleur=1 0.2 0\n"));
    }

    private void taper(JTextField champ, String texte) throws Exception {
        faire(() -> {
            champ.setText(texte);
            champ.requestFocusInWindow();
        });
        attendre("le clavier y est", champ::isFocusOwner);
        banc.frapper(KeyEvent.VK_ENTER);
    }
}
