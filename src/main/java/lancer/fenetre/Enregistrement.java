package lancer.fenetre;

import java.awt.EventQueue;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.awt.image.BufferedImage;
import java.io.File;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import lancer.SceneFautive;
import lancer.commande.Messages;
import lancer.fenetre.Bandeau.Sujet;
import lancer.image.Ecriture;
import lancer.image.FichierPng;
import lancer.image.ImageMemoire;
import lancer.scene.LecteurScene;
import lancer.texte.Texte;

/** Ce qui sort de la fenêtre : l'image copiée, ou enregistrée comme par {@code --image} ; la scène écrite. */
final class Enregistrement {

    private final Controleur controleur;
    private final Bandeau bandeau;
    /** Fil qui empêche la fin du programme : une écriture commencée s'achève après la fermeture de la fenêtre. */
    private final ExecutorService disque =
            Executors.newSingleThreadExecutor(tache -> new Thread(tache, "lancer-disque"));
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
            bandeau.dire(Sujet.AVIS, "image copiée, " + image.largeur + " × " + image.hauteur + " pixels");
        }
    }

    /** Copie les sections de variantes à mettre dans le fichier de scène, et la commande, qui donnent cette image. */
    void copierReglages() {
        String sections = controleur.demande.reglages.getSectionsChangees().stream()
                .map(section -> section.ecrire("\n") + "\n\n").collect(Collectors.joining());
        bandeau.getToolkit().getSystemClipboard().setContents(
                new StringSelection(sections + "; " + controleur.demande.getCommande("") + "\n"), null);
        bandeau.dire(Sujet.AVIS, "réglages copiés : "
                + (sections.isEmpty() ? "la commande" : "les sections changées et la commande"));
    }

    /** L'image achevée ; à défaut, un avis dit pourquoi elle n'est pas enregistrée ou copiée. */
    private ImageMemoire imageOuAvis(String geste) {
        ImageMemoire image = controleur.getImageEntiere();
        String faute = controleur.direFautes();
        if (faute != null) {
            bandeau.dire(Sujet.AVIS, "Image non " + geste + " : " + faute + ".");
            return null;
        }
        if (image == null) {
            bandeau.dire(Sujet.AVIS, controleur.enCours ? "L'image se dessine encore : elle n'est pas " + geste + "."
                    : "Pas d'image achevée ; F5 pour la dessiner.");
        }
        return image;
    }

    void enregistrer() {
        ImageMemoire image = imageOuAvis("enregistrée");
        if (image == null) {
            return;
        }
        String scene = controleur.montre.demande.lue.nom;
        String nom = new File(scene).getName().replaceFirst("\\.[^.]*$", "") + ".png";
        File cible = Dialogues.choisirImage(controleur.panneau, new File(dossier, nom));
        if (cible == null) {
            return;
        }
        dossier = cible.getParentFile();
        confier(() -> ecrire(image, cible, scene), () -> "enregistrée : " + Texte.echappe(cible.getName()));
    }

    private static void ecrire(ImageMemoire image, File cible, String scene) {
        Ecriture<ImageMemoire> ecriture = new Ecriture<>(cible.getPath(), new FichierPng());
        try {
            ecriture.distinguer(LecteurScene.trouver(scene), "la scène elle-même");
        } catch (SceneFautive e) {
            // le fichier de la scène a été effacé depuis sa lecture
        }
        ecriture.ecrire(image);
    }

    /** Confie une écriture au disque. @param reussite appelée dans le fil des événements, donne l'avis à montrer */
    void confier(Runnable ecriture, Supplier<String> reussite) {
        disque.execute(() -> {
            String faute = null;
            try {
                ecriture.run();
            } catch (RuntimeException | Error e) {
                faute = Messages.message(e);
            }
            String dite = faute;
            EventQueue.invokeLater(() -> {
                bandeau.dire(Sujet.DISQUE, dite == null ? "" : dite);
                bandeau.dire(Sujet.AVIS, dite == null ? reussite.get() : "");
            });
        });
    }

    void terminer(Runnable fin) {
        disque.execute(fin);
        disque.shutdown();
    }
}
