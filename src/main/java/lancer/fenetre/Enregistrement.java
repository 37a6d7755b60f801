package lancer.fenetre;

import java.awt.EventQueue;
import java.io.File;
import java.nio.file.Files;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import lancer.Main;
import lancer.SceneFautive;
import lancer.commande.CodeSortie;
import lancer.commande.Echec;
import lancer.lecture.LecteurScene;
import lancer.sortie.Ecriture;
import lancer.sortie.FichierPng;
import lancer.sortie.ImageMemoire;
import lancer.texte.Texte;

/** L'image de la fenêtre vers un fichier PNG, le même qu'avec {@code --image} ; le disque a un fil à part. */
final class Enregistrement {

    private final Fenetre fenetre;
    /** Un fil qui retient le programme : fermer la fenêtre laisse finir d'écrire. */
    private final ExecutorService disque =
            Executors.newSingleThreadExecutor(tache -> new Thread(tache, "lancer-disque"));
    private File dossier;

    Enregistrement(Fenetre fenetre) {
        this.fenetre = fenetre;
    }

    /** Demande où l'enregistrer. @param image l'image achevée, ou {@code null} si elle ne l'est pas */
    void commencer(ImageMemoire image) {
        if (image == null) {
            fenetre.dire(fenetre.enCours()
                    ? "L'image se dessine encore : elle pourra être enregistrée une fois achevée."
                    : "Pas d'image achevée à enregistrer ; F5 pour la dessiner.");
            return;
        }
        String scene = fenetre.getFichierMontre();
        String nom = new File(scene).getName().replaceFirst("\\.[^.]*$", "") + ".png";
        File choisi = Dialogues.choisirImage(fenetre.getCadre(), dossier, nom);
        if (choisi == null) {
            return;
        }
        dossier = choisi.getParentFile();
        File cible = choisi.getName().indexOf('.') < 0 ? new File(choisi.getPath() + ".png") : choisi;
        disque.execute(() -> verifier(image, cible, scene));
    }

    private void verifier(ImageMemoire image, File cible, String scene) {
        try {
            Ecriture ecriture = new Ecriture(cible.getPath());
            if (vise(ecriture, scene)) {
                throw new Echec(CodeSortie.DEMANDE, "la sortie est la scène elle-même : "
                        + Texte.echappe(cible.getPath())
                        + " ; attendu : un autre fichier");
            }
            if (Files.exists(ecriture.getCible())) {
                EventQueue.invokeLater(() -> confirmer(image, ecriture, cible));
            } else {
                ecrire(image, ecriture, cible);
            }
        } catch (RuntimeException | Error e) {
            EventQueue.invokeLater(() -> fenetre.direErreur(Main.message(e)));
        }
    }

    private void confirmer(ImageMemoire image, Ecriture ecriture, File cible) {
        if (!disque.isShutdown() && Dialogues.confirmerRemplacement(fenetre.getCadre(), cible)) {
            disque.execute(() -> ecrire(image, ecriture, cible));
        }
    }

    private static boolean vise(Ecriture ecriture, String scene) {
        try {
            return ecriture.vise(LecteurScene.trouver(scene));
        } catch (SceneFautive e) {
            // effacée depuis qu'elle a été lue
            return false;
        }
    }

    private void ecrire(ImageMemoire image, Ecriture ecriture, File cible) {
        try {
            ecriture.ecrire(image, FichierPng::ecrire);
            EventQueue.invokeLater(() -> fenetre.direEnregistree(Texte.echappe(cible.getName())));
        } catch (RuntimeException | Error e) {
            EventQueue.invokeLater(() -> fenetre.direErreur(Main.message(e)));
        }
    }

    /** Appelle {@code fin} quand tout est écrit. */
    void terminer(Runnable fin) {
        disque.execute(fin);
        disque.shutdown();
    }
}
