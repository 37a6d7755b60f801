package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.chercher;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.pngSansFenetre;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static lancer.fenetre.BancFenetre.texte;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.awt.event.KeyEvent;
import java.io.File;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import javax.swing.AbstractButton;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import javax.swing.JProgressBar;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
import javax.swing.TransferHandler;
import javax.swing.UIManager;
import lancer.Lancer;
import lancer.Scene;
import lancer.SceneFautive;
import lancer.essai.Essai;
import org.junit.jupiter.api.Test;

/** La fenêtre et les fichiers : la scène ouverte, modifiée, fautive ; l'image enregistrée. */
class FenetreFichiersTest extends EssaiFenetre {

    @Test
    void enregistrerLaSceneDansUnEditeurLaRedessine() throws Exception {
        banc = new BancFenetre(lente());
        banc.imageAchevee();
        ecrire(BLEUE);
        banc.attendreImage("la boule est bleue", attendue(L, H));
        // à la manière des éditeurs qui renomment, et à taille égale
        Path nouveau = dossier.resolve("boule.ini.tmp");
        Files.write(nouveau, BLEUE.replace("0.1 0.2 0.9", "0.9 0.9 0.1").getBytes(StandardCharsets.UTF_8));
        Files.move(nouveau, scene, StandardCopyOption.REPLACE_EXISTING);
        banc.attendreImage("la boule est jaune", attendue(L, H));
    }

    @Test
    void uneFauteSeLitDansLaFenetreEtLaisseLImage() throws Exception {
        banc = new BancFenetre(lente());
        banc.imageAchevee();
        int[] avant = attendue(L, H);
        ecrire(FAUTIVE);
        banc.attendreMessage(assertThrows(SceneFautive.class, () -> new Scene(scene.toString())).getMessage());
        assertArrayEquals(avant, banc.imageAchevee().getCodes());
        ecrire(BLEUE);
        banc.attendreMessage("");
        banc.attendreImage("la faute corrigée, l'image suit", attendue(L, H));
    }

    @Test
    void ctrlSEcritLeMemePngEtDemandeAvantDeRemplacer() throws Exception {
        banc = new BancFenetre(lente());
        banc.imageAchevee();
        byte[] attendu = Files.readAllBytes(pngSansFenetre(dossier, scene, L, H));
        Path png = dossier.resolve("image.png");
        assertEquals("boule.png", enregistrerSous(png));
        attendre("l'image est écrite", () -> Files.exists(png));
        assertArrayEquals(attendu, Files.readAllBytes(png));

        Files.write(png, new byte[] {42});
        enregistrerSous(png);
        repondre("Annuler");
        assertArrayEquals(new byte[] {42}, Files.readAllBytes(png));
        enregistrerSous(png);
        repondre("Remplacer");
        attendre("l'image est remplacée", () -> Arrays.equals(attendu, Files.readAllBytes(png)));
    }

    @Test
    void laSceneElleMemeNEstJamaisEcrasee() throws Exception {
        // un nom de scène finit comme on veut, celui d'une image par .png
        scene = dossier.resolve("scene.png");
        ecrire(ROUGE);
        banc = new BancFenetre(lente());
        banc.imageAchevee();
        enregistrerSous(scene);
        banc.attendreMessage("la sortie est la scène elle-même");
        assertArrayEquals(ROUGE.getBytes(StandardCharsets.UTF_8), Files.readAllBytes(scene));
    }

    @Test
    void unEnregistrementReussiEffaceLEchecDAvant() throws Exception {
        banc = new BancFenetre(lente());
        banc.imageAchevee();
        enregistrerSous(dossier.resolve("absent").resolve("image.png"));
        banc.attendreMessage(dossier.resolve("absent").resolve("image.png") + " : écriture impossible");
        enregistrerSous(dossier.resolve("image.png"));
        banc.attendreMessage("enregistrée : image.png");
    }

    @Test
    void uneImageInacheveeNeSEnregistrePas() throws Exception {
        banc = new BancFenetre(lente().lent());
        banc.frapperCtrl('S');
        banc.attendreMessage("L'image se dessine encore");
        assertNull(chercher(null, JFileChooser.class));
    }

    @Test
    void ctrlOOuvreUneAutreScene() throws Exception {
        banc = new BancFenetre(lente());
        banc.imageAchevee();
        scene = dossier.resolve("autre.ini");
        ecrire(BLEUE);
        banc.frapperCtrl('O');
        choisir(scene);
        banc.attendreImage("l'autre scène", attendue(L, H));
        assertEquals("lancer — autre.ini", banc.cadre.getTitle());
        // c'est elle, maintenant, qui est surveillée
        ecrire(ROUGE);
        banc.attendreImage("l'autre scène, modifiée", attendue(L, H));
    }

    @Test
    void uneSceneQuiNePeutEtreLueLaisseLeTitreF5EtLaSurveillanceACelleQuiEstMontree() throws Exception {
        banc = new BancFenetre(lente());
        banc.imageAchevee();
        Path fautive = dossier.resolve("fautive.ini");
        Files.write(fautive, FAUTIVE.getBytes(StandardCharsets.UTF_8));
        banc.frapperCtrl('O');
        choisir(fautive);
        banc.attendreMessage(fautive.toString());
        assertEquals("lancer — boule.ini", banc.cadre.getTitle());
        banc.frapper(KeyEvent.VK_F5);
        banc.attendreMessage("");
        ecrire(BLEUE);
        banc.attendreImage("la scène montrée est toujours surveillée", attendue(L, H));
    }

    @Test
    void echapPendantUneLectureLaisseLaSceneMontree() throws Exception {
        CountDownLatch lecture = new CountDownLatch(1);
        Path longue = dossier.resolve("longue.ini");
        Files.write(longue, BLEUE.getBytes(StandardCharsets.UTF_8));
        String[] args = {TAILLE, scene.toString()};
        banc = new BancFenetre(new BancFenetre.MainLent(args) {
            @Override
            public List<String> lireScene(String fichier) {
                if (fichier.equals(longue.toString())) {
                    FenetreTest.attendreSansEtreInterrompu(lecture);
                }
                return super.lireScene(fichier);
            }
        });
        banc.imageAchevee();
        banc.frapperCtrl('O');
        choisir(longue);
        JProgressBar avancement = chercher("avancement", JProgressBar.class);
        attendre("elle se lit", () -> avancement.getString().startsWith("lecture "));
        assertEquals("lancer — boule.ini", banc.cadre.getTitle());
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("la lecture est arrêtée", () -> avancement.getString().startsWith("lecture arrêtée — "));
        lecture.countDown();
        banc.frapper(KeyEvent.VK_F5);
        banc.attendreImage("F5 est à la scène montrée", attendue(L, H));
        assertEquals("lancer — boule.ini", banc.cadre.getTitle());
    }

    @Test
    void ouEnSontLaLectureEtLaPreparationSeDit() throws Exception {
        CountDownLatch lecture = new CountDownLatch(1);
        String[] args = {TAILLE, scene.toString()};
        double[] part = {0.42};
        banc = new BancFenetre(new BancFenetre.MainLent(args) {
            @Override
            public List<String> lireScene(String fichier) {
                if (getImage() != null) {
                    FenetreTest.attendreSansEtreInterrompu(lecture);
                }
                return super.lireScene(fichier);
            }

            @Override
            public double getAvancement() {
                return part[0];
            }
        });
        banc.imageAchevee();
        banc.frapper(KeyEvent.VK_F5);
        JProgressBar avancement = chercher("avancement", JProgressBar.class);
        attendre("la part lue", () -> avancement.getString().startsWith("lecture 42 % — ") && avancement.getValue() == 420);
        part[0] = 0.73;
        attendre("elle avance", () -> avancement.getString().startsWith("lecture 73 % — "));
        lecture.countDown();
        banc.imageAchevee();
    }

    @Test
    void echapPendantUnePreparationLaisseAussiLeCoutDeLImageMontree() throws Exception {
        CountDownLatch preparation = new CountDownLatch(1);
        Path longue = dossier.resolve("longue.ini");
        Files.write(longue, BLEUE.getBytes(StandardCharsets.UTF_8));
        String[] args = {TAILLE, scene.toString()};
        banc = new BancFenetre(new BancFenetre.MainLent(args) {
            private volatile boolean seconde;

            @Override
            public void doTracerImage(int largeur, int hauteur) {
                if (seconde) {
                    FenetreTest.attendreSansEtreInterrompu(preparation);
                    return;
                }
                super.doTracerImage(largeur, hauteur);
            }

            @Override
            public List<String> lireScene(String fichier) {
                seconde = fichier.equals(longue.toString());
                return super.lireScene(fichier);
            }

            @Override
            public Lancer getLancer() {
                return seconde ? null : super.getLancer();
            }
        });
        banc.imageAchevee();
        JTextArea resume = chercher("resume", JTextArea.class);
        String avant = surFilEvenements(resume::getText);
        banc.frapperCtrl('O');
        choisir(longue);
        JProgressBar avancement = chercher("avancement", JProgressBar.class);
        attendre("elle se prépare", () -> avancement.getString().startsWith("préparation "));
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("la préparation est arrêtée", () -> avancement.getString().startsWith("préparation arrêtée — "));
        preparation.countDown();
        assertEquals("lancer — boule.ini", banc.cadre.getTitle());
        assertEquals(avant, surFilEvenements(resume::getText));
    }

    @Test
    void leTexteDUneFauteSeCopie() throws Exception {
        banc = new BancFenetre(lente());
        banc.imageAchevee();
        AbstractButton article = banc.cadre.getJMenuBar().getMenu(0).getItem(3);
        assertFalse(article.isEnabled(), "rien à copier");
        ecrire(FAUTIVE);
        banc.attendreMessage(scene.toString());
        JTextArea bandeau = chercher("message", JTextArea.class);
        AbstractButton duBandeau = (AbstractButton) bandeau.getComponentPopupMenu().getComponent(0);
        for (AbstractButton bouton : new AbstractButton[] {article, duBandeau}) {
            String copie = surFilEvenements(() -> {
                bandeau.getToolkit().getSystemClipboard().setContents(new StringSelection(""), null);
                bouton.doClick();
                return BancFenetre.copie();
            });
            assertEquals(assertThrows(SceneFautive.class, () -> new Scene(scene.toString())).getMessage(), copie);
        }
    }

    @Test
    void unNomDeSceneSansIniEstComplete() throws Exception {
        banc = new BancFenetre(lente());
        banc.imageAchevee();
        scene = dossier.resolve("autre.ini");
        ecrire(BLEUE);
        banc.frapperCtrl('O');
        choisir(dossier.resolve("autre"));
        banc.attendreImage("l'autre scène", attendue(L, H));
        assertEquals("lancer — autre.ini", banc.cadre.getTitle());
    }

    @Test
    void leNomDUneImageFinitToujoursParPng() throws Exception {
        banc = new BancFenetre(lente());
        banc.imageAchevee();
        byte[] attendu = Files.readAllBytes(pngSansFenetre(dossier, scene, L, H));
        for (String[] noms : new String[][] {{"tp1.exo2", "tp1.exo2.png"}, {"photo.jpg", "photo.jpg.png"}, {"vue.PNG", "vue.PNG"}}) {
            enregistrerSous(dossier.resolve(noms[0]));
            banc.attendreMessage("enregistrée : " + noms[1]);
            assertArrayEquals(attendu, Files.readAllBytes(dossier.resolve(noms[1])));
        }
    }

    @Test
    void apresUnEchecLeDossierEtLeNomSontProposesDeNouveau() throws Exception {
        banc = new BancFenetre(lente());
        banc.imageAchevee();
        Path dossierOccupe = Files.createDirectories(dossier.resolve("sous/vue.png"));
        assertEquals("boule.png", enregistrerSous(dossierOccupe));
        banc.attendreMessage(dossierOccupe + " : écriture impossible, c'est un dossier");
        banc.frapperCtrl('S');
        JFileChooser choix = composant(null, JFileChooser.class);
        assertEquals(dossierOccupe.toFile(), surFilEvenements(choix::getSelectedFile));
        choisir(dossier.resolve("sous/autre.png"));
        banc.attendreMessage("enregistrée : autre.png");
        assertEquals("boule.png", enregistrerSous(dossier.resolve("fin.png")));
    }

    @Test
    void leChoixDUnFichierTientDansLEcranQuelleQueSoitSaPropreTaille() throws Exception {
        banc = new BancFenetre(lente());
        banc.imageAchevee();
        Rectangle ecran = new Rectangle(Toolkit.getDefaultToolkit().getScreenSize());
        String cle = "FileChooser.filesOfTypeLabelText";
        Object avant = UIManager.put(cle, String.join(" ", Collections.nCopies(ecran.width / 4, "type")));
        try {
            for (char touche : new char[] {'o', 's'}) {
                banc.frapperCtrl(touche);
                JFileChooser choix = composant(null, JFileChooser.class);
                Rectangle place = surFilEvenements(() -> SwingUtilities.getWindowAncestor(choix).getBounds());
                assertTrue(ecran.contains(place), place.toString());
                surFilEvenements(() -> {
                    choix.cancelSelection();
                    return null;
                });
                attendre("le dialogue est fermé", () -> !choix.isShowing());
            }
        } finally {
            UIManager.put(cle, avant);
        }
    }

    @Test
    void uneToucheQuiSeRepeteNOuvreQuUnDialogue() throws Exception {
        banc = new BancFenetre(lente());
        banc.imageAchevee();
        scene = dossier.resolve("autre.ini");
        ecrire(BLEUE);
        banc.frapper(KeyEvent.VK_CONTROL);
        banc.robot.keyPress(KeyEvent.VK_CONTROL);
        for (int k = 0; k < 3; k++) {
            banc.robot.keyPress(KeyEvent.VK_O);
            banc.robot.keyRelease(KeyEvent.VK_O);
        }
        banc.robot.keyRelease(KeyEvent.VK_CONTROL);
        choisir(scene);
        banc.attendreImage("rien ne la recouvre", attendue(L, H));
    }

    @Test
    void deposerUnFichierOuvreLaScene() throws Exception {
        banc = new BancFenetre(lente());
        banc.imageAchevee();
        scene = dossier.resolve("autre.ini");
        ecrire(BLEUE);
        assertTrue(surFilEvenements(() -> banc.cadre.getRootPane().getTransferHandler().importData(
                new TransferHandler.TransferSupport(banc.cadre.getRootPane(), fichierDepose(scene.toFile())))));
        banc.attendreImage("la scène déposée", attendue(L, H));
    }

    @Test
    void sansSceneLaFenetreSOuvreSurLeChoixDUnFichier() throws Exception {
        banc = new BancFenetre(TAILLE);
        assertEquals("lancer", banc.cadre.getTitle());
        choisir(scene);
        banc.attendreImage("la scène choisie", attendue(L, H));
    }

    @Test
    void uneSceneFautiveAuDepartNOuvrePasDeFenetre() throws Exception {
        ecrire(FAUTIVE);
        Essai essai = Essai.executer(scene.toString());
        assertEquals(2, essai.code);
        assertTrue(essai.erreur.matches("lancer : .*boule.ini.*rayon.*\\R"), essai.erreur);
    }

    /** Frappe Ctrl+S et choisit ce fichier ; rend le nom qui était proposé. */
    private String enregistrerSous(Path fichier) throws Exception {
        banc.frapperCtrl('S');
        return choisir(fichier);
    }

    private String choisir(Path fichier) throws Exception {
        JFileChooser choix = composant(null, JFileChooser.class);
        // comme quelqu'un : d'abord le clavier est au dialogue, et ce qui fut frappé avant ne va plus à la fenêtre
        attendre("le clavier est au dialogue", () -> SwingUtilities.getWindowAncestor(choix).isFocused());
        String propose = surFilEvenements(() -> {
            File selection = choix.getSelectedFile();
            choix.setSelectedFile(fichier.toFile());
            choix.approveSelection();
            return selection == null ? null : selection.getName();
        });
        attendre("le dialogue est fermé", () -> !choix.isShowing());
        return propose;
    }

    private void repondre(String texte) throws Exception {
        JOptionPane question = composant(null, JOptionPane.class);
        surFilEvenements(() -> {
            question.setValue(texte);
            return null;
        });
        attendre("la question est fermée", () -> !question.isShowing());
    }

    private static Transferable fichierDepose(File fichier) {
        return new Transferable() {
            @Override
            public DataFlavor[] getTransferDataFlavors() {
                return new DataFlavor[] {DataFlavor.javaFileListFlavor};
            }

            @Override
            public boolean isDataFlavorSupported(DataFlavor forme) {
                return DataFlavor.javaFileListFlavor.equals(forme);
            }

            @Override
            public Object getTransferData(DataFlavor forme) {
                return Collections.singletonList(fichier);
            }
        };
    }
}
