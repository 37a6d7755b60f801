package lancer.fenetre;

import java.awt.EventQueue;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.awt.image.BufferedImage;
import java.io.File;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.stream.Collectors;
import lancer.SceneFautive;
import lancer.fenetre.Bandeau.Sujet;
import lancer.image.Ecriture;
import lancer.image.FichierPng;
import lancer.image.ImageMemoire;
import lancer.scene.FichierScene;
import lancer.texte.Texte;

/** Copie l'image achevée dans le presse-papiers, ou l'enregistre en PNG comme {@code --image}. */
final class Enregistrement {

    private final Controleur controleur;
    private final Bandeau bandeau;
    /** Fil qui empêche la fin du programme : une écriture commencée s'achève après la fermeture de la fenêtre. */
    private final ExecutorService disque =
            Executors.newSingleThreadExecutor(tache -> new Thread(tache, "lancer-disque"));
    /** Valeurs proposées par le prochain dialogue : dernier dossier, ou fichier dont l'écriture a échoué. */
    private File dossier = new File("").getAbsoluteFile();
    private File echoue;

    Enregistrement(Controleur controleur, Bandeau bandeau) {
        this.controleur = controleur;
        this.bandeau = bandeau;
    }

    void copier() {
        ImageMemoire image = imageOuAvis("copiée");
        if (image != null) {
            // l'image partage le tableau des codes, qui ne change plus : copier une grande image serait long
            BufferedImage copie = Pixels.de(image.codes, image.largeur, false);
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

    /** Copie les sections à mettre dans le fichier de scène, et la commande, qui donnent cette image. */
    void copierReglages() {
        String sections = controleur.etat.getReglages().getSectionsChangees().stream()
                .map(section -> section.ecrire("\n") + "\n\n").collect(Collectors.joining())
                + controleur.etat.choix.scene.getChanges(controleur.etat.lecture.getLue());
        bandeau.getToolkit().getSystemClipboard().setContents(
                new StringSelection(sections + "; " + controleur.getCommande() + "\n"), null);
        bandeau.dire(Sujet.AVIS, "réglages copiés : "
                + (sections.isEmpty() ? "la commande" : "les sections changées et la commande"));
    }

    /** L'image achevée ; à défaut, un avis dit pourquoi elle n'est pas enregistrée ou copiée. */
    private ImageMemoire imageOuAvis(String geste) {
        ImageMemoire image = controleur.etat.getImageEntiere();
        String faute = controleur.direFautes();
        if (faute != null || image == null) {
            bandeau.dire(Sujet.AVIS, faute != null ? "Image non " + geste + " : " + faute + "."
                    : controleur.etat.enCours ? "L'image se dessine encore : elle servira une fois achevée."
                    : "Pas d'image achevée ; F5 pour la dessiner.");
        }
        return faute == null ? image : null;
    }

    void enregistrer() {
        ImageMemoire image = imageOuAvis("enregistrée");
        if (image == null) {
            return;
        }
        String scene = controleur.etat.montre.demande.lecture.fichier;
        String nom = new File(scene).getName().replaceFirst("\\.[^.]*$", "") + ".png";
        File cible = Dialogues.choisirImage(controleur.panneau,
                echoue != null ? echoue : new File(dossier, nom));
        if (cible == null) {
            return;
        }
        dossier = cible.getParentFile();
        Controleur.confier(disque, () -> ecrire(image, cible, scene), echec -> {
            echoue = cible;
            bandeau.dire(Sujet.AVIS, "");
            bandeau.dire(Sujet.DISQUE, echec);
        });
    }

    private void ecrire(ImageMemoire image, File cible, String scene) {
        Ecriture ecriture = new Ecriture(cible.getPath());
        try {
            ecriture.epargner(FichierScene.trouver(scene), "la scène elle-même");
        } catch (SceneFautive e) {
            // le fichier de la scène a été effacé depuis sa lecture
        }
        ecriture.ecrire(image, new FichierPng());
        EventQueue.invokeLater(() -> {
            echoue = null;
            bandeau.dire(Sujet.DISQUE, "");
            bandeau.dire(Sujet.AVIS, "enregistrée : " + Texte.echappe(cible.getName()));
        });
    }

    void terminer(Runnable fin) {
        disque.execute(fin);
        disque.shutdown();
    }
}
