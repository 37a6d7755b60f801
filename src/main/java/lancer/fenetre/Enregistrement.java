package lancer.fenetre;

import java.awt.EventQueue;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.awt.image.BufferedImage;
import java.io.File;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import lancer.SceneFautive;
import lancer.commande.Messages;
import lancer.image.FichierPng;
import lancer.image.ImageMemoire;
import lancer.scene.LecteurScene;
import lancer.scene.SceneLue;
import lancer.systeme.Ecriture;
import lancer.texte.Texte;

/** Ce qui sort de la fenêtre : l'image copiée, ou enregistrée comme par {@code --image} ; la scène écrite. */
final class Enregistrement {

    private final Controleur controleur;
    private final Bandeau bandeau;
    /** Fil qui empêche la fin du programme : une écriture commencée s'achève après la fermeture de la fenêtre. */
    private final ExecutorService disque =
            Executors.newSingleThreadExecutor(tache -> new Thread(tache, "lancer-disque"));
    /** Vrai pendant l'écriture des déplacements. */
    private boolean enEcriture;
    /** Le dossier que propose le prochain dialogue. */
    private File dossier = new File("").getAbsoluteFile();

    Enregistrement(Controleur controleur) {
        this.controleur = controleur;
        bandeau = controleur.panneau.bandeau;
    }

    void copier() {
        ImageMemoire image = imageOuAvis("copiée");
        if (image != null) {
            // l'image partage le tableau des codes, qui ne change plus : copier une grande image serait long
            BufferedImage copie = PanneauImage.deJava(image, false);
            bandeau.getToolkit().getSystemClipboard().setContents(new Transferable() {
                @Override
                public DataFlavor[] getTransferDataFlavors() {
                    return new DataFlavor[] {DataFlavor.imageFlavor};
                }

                @Override
                public boolean isDataFlavorSupported(DataFlavor sorte) {
                    return sorte.equals(DataFlavor.imageFlavor);
                }

                @Override
                public Object getTransferData(DataFlavor sorte) {
                    return copie;
                }
            }, null);
            bandeau.dire("image copiée, " + image.largeur + " × " + image.hauteur + " pixels");
        }
    }

    /** Copie les sections de variantes à mettre dans le fichier de scène, et la commande, qui donnent cette image. */
    void copierReglages() {
        String sections = controleur.getEtat().demande.reglages.getSectionsChangees().stream()
                .map(section -> section.ecrire("\n") + "\n\n").collect(Collectors.joining());
        bandeau.getToolkit().getSystemClipboard().setContents(
                new StringSelection(sections + "; " + controleur.getEtat().demande.getCommande("") + "\n"), null);
        bandeau.dire("réglages copiés : "
                + (sections.isEmpty() ? "la commande" : "les sections changées et la commande"));
    }

    /** L'image achevée ; à défaut, un avis dit pourquoi elle n'est pas enregistrée ou copiée. */
    private ImageMemoire imageOuAvis(String geste) {
        Etat etat = controleur.getEtat();
        String faute = etat.montre.direFautes();
        if (faute != null) {
            bandeau.dire("Image non " + geste + " : " + faute + ".");
            return null;
        }
        if (etat.getImageEntiere() == null) {
            bandeau.dire(etat.enCours ? "L'image se dessine encore : elle n'est pas " + geste + "."
                    : "Pas d'image achevée ; F5 pour la dessiner.");
        }
        return etat.getImageEntiere();
    }

    void enregistrer() {
        ImageMemoire image = imageOuAvis("enregistrée");
        if (image == null) {
            return;
        }
        String scene = controleur.getEtat().montre.dessin.demande.lue.nom;
        String nom = new File(scene).getName().replaceFirst("\\.[^.]*$", "") + ".png";
        File cible = Dialogues.choisirImage(controleur.panneau, new File(dossier, nom));
        if (cible == null) {
            return;
        }
        dossier = cible.getParentFile();
        confier(() -> ecrire(image, cible, scene), faute -> {
            if (faute == null) {
                bandeau.dire("enregistrée : " + Texte.echappe(cible.getName()));
            } else {
                bandeau.retenir(faute);
            }
        });
    }

    private static void ecrire(ImageMemoire image, File cible, String scene) {
        Ecriture<ImageMemoire> ecriture = new Ecriture<>(cible.getPath(), new FichierPng());
        try {
            ecriture.distinguer(LecteurScene.trouver(scene).toString(), "la scène elle-même");
        } catch (SceneFautive e) {
            // le fichier de la scène a été effacé depuis sa lecture
        }
        ecriture.ecrire(image);
    }

    /** Écrit les déplacements dans le fichier de leur scène. @param ensuite fait quand ils y sont tous */
    void ecrireLaScene(Runnable ensuite) {
        // ce qui a été déplacé pendant une écriture s'écrit après elle
        apres(() -> {
            SceneLue avant = controleur.getEtat().ecrite;
            SceneLue voulue = controleur.getEtat().demande.lue;
            if (avant == voulue) {
                ensuite.run();
                return;
            }
            enEcriture = true;
            confier(() -> avant.remplacer(voulue), faute -> {
                enEcriture = false;
                controleur.finirLEcriture(avant, voulue, faute);
                if (faute == null && !controleur.getEtat().estDeplace()) {
                    bandeau.dire("écrit dans " + controleur.getEtat().getNom());
                }
                if (faute == null) {
                    ensuite.run();
                }
            });
        });
    }

    /** Fait ceci quand l'écriture des déplacements est finie, s'il y en a une. */
    void apres(Runnable suite) {
        if (enEcriture) {
            confier(() -> { }, rien -> apres(suite));
        } else {
            suite.run();
        }
    }

    /** Confie une écriture au disque. @param fin reçoit son échec, ou {@code null}, dans le fil des événements */
    private void confier(Runnable ecriture, Consumer<String> fin) {
        disque.execute(() -> {
            String faute = null;
            try {
                ecriture.run();
            } catch (RuntimeException | Error e) {
                faute = Messages.message(e);
            }
            String dite = faute;
            EventQueue.invokeLater(() -> fin.accept(dite));
        });
    }

    void terminer(Runnable fin) {
        disque.execute(fin);
        disque.shutdown();
    }
}
