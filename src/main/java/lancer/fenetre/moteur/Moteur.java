package lancer.fenetre.moteur;

import java.awt.EventQueue;
import java.io.File;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.prefs.Preferences;
import lancer.SceneFautive;
import lancer.commande.Messages;
import lancer.commande.Reglages;
import lancer.dessin.Demande;
import lancer.dessin.Dessin;
import lancer.dessin.Programme;
import lancer.fenetre.etat.Avancement;
import lancer.fenetre.etat.Essai;
import lancer.fenetre.etat.Executant;
import lancer.fenetre.etat.Explication.Faite;
import lancer.fenetre.etat.Suite;
import lancer.fenetre.etat.Suite.Evenement;
import lancer.image.FichierPng;
import lancer.image.ImageMemoire;
import lancer.inspection.Inspection;
import lancer.inspection.Recit;
import lancer.scene.EcritureScene;
import lancer.scene.LecteurScene;
import lancer.scene.SceneLue;
import lancer.scene.Surveillance;
import lancer.scene.TexteScene;
import lancer.systeme.Ecriture;
import lancer.texte.Nombre;
import lancer.texte.Texte;

/** Exécute les ordres dans d'autres fils, et répond par des événements, dans celui des événements. */
public final class Moteur implements Executant {

    private static final String POLICE = "police";
    /** Le journal des préférences, qui dirait où elles ne se gardent pas. */
    private static final Logger JOURNAL = Logger.getLogger("java.util.prefs");

    private final Consumer<Evenement> recevoir;
    private final Programme programme;
    private final Reglages options;
    private final Runnable fin;
    private final Surveillance surveillance;
    /** Ce qui peut être arrêté, par numéro. */
    private final Map<Integer, Tache> taches = new HashMap<>();
    /** Fil qui empêche la fin du programme : une écriture commencée s'achève après la fermeture de la fenêtre. */
    private final ExecutorService disque =
            Executors.newSingleThreadExecutor(tache -> new Thread(tache, "lancer-disque"));

    /** @param fin appelé quand tout est fini, dans un autre fil */
    public Moteur(Programme programme, Reglages options, Runnable fin, Consumer<Evenement> recevoir) {
        this.programme = programme;
        this.options = options;
        this.fin = fin;
        this.recevoir = recevoir;
        surveillance = new Surveillance((fichier, version) ->
                EventQueue.invokeLater(() -> recevoir.accept(suite -> suite.voirLeFichier(fichier, version))));
    }

    private void commencer(int numero, Tache tache) {
        if (disque.isShutdown()) {
            // ce qui arrive pendant que la fenêtre se ferme ne fait plus rien
            return;
        }
        taches.put(numero, tache);
        tache.addPropertyChangeListener(e -> {
            if (tache.isDone()) {
                taches.remove(numero);
            }
        });
        tache.execute();
    }

    @Override
    public void lire(int numero, String fichier, Demande avant, Avancement avancement) {
        commencer(numero, new Dessinateur(numero, recevoir, programme, options, fichier, avant, avancement));
    }

    @Override
    public void dessiner(int numero, Demande demande, Avancement avancement) {
        commencer(numero, new Dessinateur(numero, recevoir, programme, options, null, demande, avancement));
    }

    @Override
    public void mesurer(int numero, Dessin dessin, Map<Reglages, Essai> essais) {
        commencer(numero, new Mesureur(numero, recevoir, dessin, essais));
    }

    @Override
    public void expliquer(int numero, Inspection inspection, Dessin dessin) {
        commencer(numero, new Tache(numero, recevoir) {
            @Override
            protected Evenement doInBackground() {
                inspection.faire(dessin::seRegardeDeuxFois);
                Recit recit = new Recit(inspection, Nombre::arrondir, Nombre::arrondirComposante);
                Faite faite = new Faite(dessin, inspection, recit.raconter(), null);
                return suite -> suite.raconter(faite);
            }

            @Override
            Evenement echouer(Throwable echec) {
                return suite -> suite.raconter(new Faite(dessin, null, null, Messages.message(echec)));
            }
        });
    }

    @Override
    public void arreter(int numero) {
        Tache tache = taches.get(numero);
        if (tache != null) {
            tache.cancel(true);
        }
    }

    @Override
    public void ecrire(int numero, SceneLue voulue, SceneLue avant, TexteScene connu) {
        confier(numero, () -> {
            TexteScene ecrit = EcritureScene.remplacer(voulue, avant, connu);
            return suite -> suite.ecrit(ecrit, voulue.nom, false);
        });
    }

    @Override
    public void ecrireSous(int numero, TexteScene texte, String fichier) {
        confier(numero, () -> {
            EcritureScene.ecrire(texte, fichier);
            return suite -> suite.ecrit(texte, fichier, true);
        });
    }

    /** Confie une écriture de scène au disque. */
    private void confier(int numero, Supplier<Evenement> ecriture) {
        disque.execute(() -> {
            Evenement reponse;
            try {
                reponse = ecriture.get();
            } catch (RuntimeException | Error e) {
                String faute = Messages.message(e);
                reponse = suite -> suite.refuserDEcrire(faute);
            }
            Evenement dite = Suite.reponse(numero, reponse);
            EventQueue.invokeLater(() -> recevoir.accept(dite));
        });
    }

    @Override
    public void enregistrer(ImageMemoire image, File cible, String scene) {
        disque.execute(() -> {
            String faute = null;
            try {
                ecrire(image, cible, scene);
            } catch (RuntimeException | Error e) {
                faute = Messages.message(e);
            }
            String dit = faute == null ? "enregistrée : " + Texte.echappe(cible.getName()) : faute;
            boolean echec = faute != null;
            EventQueue.invokeLater(() -> recevoir.accept(suite -> suite.annoncer(dit, echec)));
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

    @Override
    public void surveiller(String fichier) {
        surveillance.suivre(fichier);
    }

    private static Preferences preferences() {
        JOURNAL.setLevel(Level.OFF);
        return Preferences.userNodeForPackage(Moteur.class);
    }

    @Override
    public void garderLaPolice(int taille) {
        disque.execute(() -> {
            try {
                preferences().putInt(POLICE, taille);
            } catch (SecurityException | IllegalStateException e) {
                // où rien ne se garde, la prochaine fenêtre aura les textes de la première
            }
        });
    }

    /** La taille des textes de la fenêtre d'avant, ou 0. */
    public static int getPolice() {
        try {
            return preferences().getInt(POLICE, 0);
        } catch (SecurityException | IllegalStateException e) {
            return 0;
        }
    }

    @Override
    public void terminer() {
        new ArrayList<>(taches.values()).forEach(tache -> tache.cancel(true));
        surveillance.terminer();
        disque.execute(fin);
        disque.shutdown();
    }
}
