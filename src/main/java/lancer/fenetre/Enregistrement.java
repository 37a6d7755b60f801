package lancer.fenetre;

import java.awt.Component;
import java.awt.EventQueue;
import java.io.File;
import java.nio.file.Files;
import java.util.Locale;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import lancer.SceneFautive;
import lancer.commande.Pannes;
import lancer.lecture.LecteurScene;
import lancer.sortie.Ecriture;
import lancer.sortie.FichierPng;
import lancer.sortie.ImageMemoire;
import lancer.texte.Texte;

/** L'image de la fenêtre vers un fichier PNG, le même qu'avec {@code --image} ; le disque a un fil à part. */
final class Enregistrement {

    private final Component parent;
    private final Bandeau bandeau;
    /** Un fil qui retient le programme : fermer la fenêtre laisse finir d'écrire. */
    private final ExecutorService disque =
            Executors.newSingleThreadExecutor(tache -> new Thread(tache, "lancer-disque"));
    /** Ce que le prochain dialogue propose : le dossier du dernier enregistrement, ou le fichier qui a échoué. */
    private File dossier = new File("").getAbsoluteFile();
    private File echoue;

    /** @param bandeau où dire ce qu'il en est */
    Enregistrement(Component parent, Bandeau bandeau) {
        this.parent = parent;
        this.bandeau = bandeau;
    }

    /** Demande où enregistrer cette image. @param scene le fichier de la scène, qui ne sera pas écrasé */
    void commencer(ImageMemoire image, String scene) {
        String nom = new File(scene).getName().replaceFirst("\\.[^.]*$", "") + ".png";
        File choisi = Dialogues.choisirImage(parent, echoue != null ? echoue : new File(dossier, nom));
        if (choisi == null) {
            return;
        }
        dossier = choisi.getParentFile();
        boolean png = choisi.getName().toLowerCase(Locale.ROOT).endsWith(".png");
        File cible = png ? choisi : new File(choisi.getPath() + ".png");
        disque.execute(() -> essayer(cible, () -> verifier(image, cible, scene)));
    }

    private void essayer(File cible, Runnable etape) {
        try {
            etape.run();
        } catch (RuntimeException | Error e) {
            EventQueue.invokeLater(() -> {
                echoue = cible;
                bandeau.erreur(Pannes.message(e));
            });
        }
    }

    private void verifier(ImageMemoire image, File cible, String scene) {
        Ecriture ecriture = new Ecriture(cible.getPath());
        try {
            ecriture.epargner(LecteurScene.trouver(scene),
                    "la sortie est la scène elle-même : " + Texte.echappe(cible.getPath())
                            + " ; attendu : un autre fichier");
        } catch (SceneFautive e) {
            // effacée depuis qu'elle a été lue
        }
        if (Files.exists(ecriture.getCible())) {
            EventQueue.invokeLater(() -> confirmer(image, ecriture, cible));
        } else {
            ecrire(image, ecriture, cible);
        }
    }

    private void confirmer(ImageMemoire image, Ecriture ecriture, File cible) {
        if (!disque.isShutdown() && Dialogues.confirmerRemplacement(parent, cible)) {
            disque.execute(() -> essayer(cible, () -> ecrire(image, ecriture, cible)));
        }
    }

    private void ecrire(ImageMemoire image, Ecriture ecriture, File cible) {
        ecriture.ecrire(image, new FichierPng());
        EventQueue.invokeLater(() -> {
            echoue = null;
            bandeau.avis("enregistrée : " + Texte.echappe(cible.getName()));
        });
    }

    /** Appelle {@code fin} quand tout est écrit. */
    void terminer(Runnable fin) {
        disque.execute(fin);
        disque.shutdown();
    }
}
