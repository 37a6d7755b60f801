package lancer.fenetre;

import java.awt.Dimension;
import java.awt.EventQueue;
import java.io.File;
import java.io.PrintStream;
import java.lang.reflect.InvocationTargetException;
import java.util.List;
import javax.swing.JFrame;
import javax.swing.Timer;
import lancer.Lancer;
import lancer.Main;
import lancer.SceneFautive;
import lancer.commande.CodeSortie;
import lancer.commande.Echec;
import lancer.commande.Options;
import lancer.lecture.Services;
import lancer.sortie.ImageMemoire;
import lancer.texte.Texte;

/**
 * La fenêtre : elle montre l'image pendant que {@link Tracage} la dessine. Le fil des événements ne calcule pas, ne lit
 * pas, n'écrit pas et n'attend pas ; une horloge lui fait regarder trente fois par seconde où en est le dessin.
 */
public final class Fenetre {

    /** Temps entre deux regards sur le dessin en cours, en millisecondes. */
    private static final int PERIODE_MS = 33;

    /** Temps laissé à un brouillon avant de montrer ses morceaux, ou de le refaire à une autre taille, en ns. */
    private static final long PATIENCE_NS = 300_000_000;

    private final Main main;
    private final Atelier atelier;
    private final List<String> variantes;
    private final Runnable fin;
    private final PanneauImage panneau = new PanneauImage();
    private final BarreEtat barre = new BarreEtat(this);
    private final JFrame cadre;
    private final Enregistrement enregistrement = new Enregistrement(this);
    private final Timer horloge = new Timer(PERIODE_MS, e -> observer());

    private String fichier;
    private String fichierMontre;
    private boolean fichierFautif;
    private Tracage courant;
    /** Faux seulement quand {@link #finir} est passé : le dessin peut être fini un instant avant qu'on le sache ici. */
    private boolean enCours;
    private Dimension taille = new Dimension();
    private ImageMemoire complete;
    private boolean fermee;

    private Fenetre(Main main, Atelier atelier, Tracage premier, List<String> variantes, Runnable fin) {
        this.main = main;
        this.atelier = atelier;
        this.variantes = variantes;
        this.fin = fin;
        fichier = main.getOptions().scene;
        fichierMontre = fichier;
        cadre = new Cadre(this, panneau, barre, taille(main.getOptions()));
        titrer();
        atelier.surveiller(() -> EventQueue.invokeLater(() -> dessiner(true)));
        if (premier == null) {
            panneau.setInvite("Ctrl+O pour ouvrir une scène, ou déposer ici un fichier .ini");
            EventQueue.invokeLater(this::choisirScene);
        } else {
            avertir();
            suivre(premier);
        }
        cadre.setVisible(true);
    }

    /**
     * Ouvre la fenêtre sur la scène demandée, et revient ; fermer la fenêtre termine le programme, avec le statut 0.
     *
     * @throws SceneFautive si la scène ne peut être utilisée ; rien ne s'est ouvert
     * @throws Echec s'il n'y a pas d'écran
     */
    public static Fenetre ouvrir(Main main, PrintStream sortie, PrintStream erreur) {
        return ouvrir(main, sortie, erreur, () -> System.exit(CodeSortie.FAIT));
    }

    /** {@link #ouvrir(Main, PrintStream, PrintStream)}, et fermer la fenêtre appelle {@code fin}, dans un autre fil. */
    public static Fenetre ouvrir(Main main, PrintStream sortie, PrintStream erreur, Runnable fin) {
        Atelier atelier = new Atelier(main, sortie, erreur);
        String fichier = main.getOptions().scene;
        if (fichier != null) {
            atelier.lire(fichier);
            main.avertir(erreur);
        }
        Ecran.exiger();
        // sans attendre la fenêtre, plus longue à ouvrir que le brouillon à dessiner
        Tracage premier = fichier == null ? null : atelier.dessiner(null, taille(main.getOptions()));
        List<String> variantes = Services.nomsDesVariantes();
        Fenetre[] ouverte = new Fenetre[1];
        try {
            EventQueue.invokeAndWait(() -> {
                Dialogues.preparer();
                ouverte[0] = new Fenetre(main, atelier, premier, variantes, fin);
            });
        } catch (InvocationTargetException e) {
            throw new Echec(CodeSortie.PANNE, Main.message(e.getCause()));
        } catch (InterruptedException e) {
            throw new Echec(CodeSortie.PANNE, "interrompu");
        }
        return ouverte[0];
    }

    private static Dimension taille(Options options) {
        return new Dimension(options.largeur, options.hauteur);
    }

    /** Le cadre, qui contient tout ce qui se voit. */
    public JFrame getCadre() {
        return cadre;
    }

    /** L'image montrée si elle est achevée ; {@code null} tant qu'un dessin est en cours, ou s'il a été arrêté. */
    public ImageMemoire getImageComplete() {
        return !enCours && complete == panneau.getImage() ? complete : null;
    }

    /** Vrai tant qu'un dessin est en cours, lecture et préparation comprises. */
    public boolean enCours() {
        return enCours;
    }

    /** Le fichier de la scène montrée, {@code null} s'il n'y en a pas encore. */
    String getFichierMontre() {
        return fichierMontre;
    }

    void choisirScene() {
        File choisi = Dialogues.choisirScene(cadre, fichier);
        if (choisi != null) {
            ouvrirScene(choisi);
        }
    }

    void ouvrirScene(File scene) {
        fichier = scene.getPath();
        titrer();
        panneau.setInvite(null);
        dessiner(true);
    }

    void recharger() {
        if (fichier == null) {
            choisirScene();
        } else {
            dessiner(true);
        }
    }

    void enregistrer() {
        enregistrement.commencer(getImageComplete());
    }

    void arreter() {
        if (enCours) {
            courant.cancel(true);
            // sans attendre que le dessin s'en aperçoive, comme le fait un SwingWorker des Java récents
            finir(courant);
        }
    }

    /** Termine : plus aucun dessin, plus de fenêtre, et les images en train de s'écrire le seront jusqu'au bout. */
    void fermer() {
        if (fermee) {
            return;
        }
        fermee = true;
        horloge.stop();
        annuler();
        atelier.terminer();
        cadre.dispose();
        enregistrement.terminer(fin);
    }

    /** Dit quelque chose, sans recouvrir ce qui ne va pas dans la scène. */
    void dire(String avis) {
        if (fichierFautif) {
            direEtat(avis);
        } else {
            panneau.getBandeau().avis(avis);
        }
    }

    void direErreur(String erreur) {
        panneau.getBandeau().erreur(Texte.echappe(erreur));
    }

    /** Une image est enregistrée : un échec d'avant n'a plus à se lire. */
    void direEnregistree(String nom) {
        if (!fichierFautif) {
            panneau.getBandeau().effacerErreur();
        }
        direEtat("enregistrée : " + nom);
    }

    void direEtat(String etat) {
        barre.resumer(etat);
    }

    /** Recommence le dessin à la taille du panneau ; l'ancienne image reste jusqu'au brouillon de la nouvelle. */
    private void dessiner(boolean relire) {
        boolean lire = relire || courant != null && courant.resteALire();
        Dimension voulue = panneau.getTaillePixels();
        if (fermee || !lire && main.getScene() == null || voulue.width < 1 || voulue.height < 1) {
            return;
        }
        annuler();
        suivre(atelier.dessiner(lire ? fichier : null, voulue));
    }

    private void suivre(Tracage tracage) {
        courant = tracage;
        taille = tracage.getTaille();
        enCours = true;
        horloge.start();
        tracage.ensuite(this::finir);
        observer();
    }

    private void annuler() {
        Tracage ancien = courant;
        courant = null;
        if (ancien != null) {
            ancien.cancel(true);
        }
    }

    /** Refait l'image si le panneau n'a plus sa taille, en laissant au brouillon le temps de se montrer. */
    void suivreTaille() {
        if (courant == null || panneau.getTaillePixels().equals(taille)) {
            return;
        }
        if (enCours) {
            Lancer lancer = courant.getLancer();
            if (lancer == null || !lancer.isBrouillonFait() && courant.getDureeNs() < PATIENCE_NS) {
                return;
            }
        }
        dessiner(false);
    }

    /** Montre où en est le dessin en cours. */
    private void observer() {
        suivreTaille();
        if (courant == null) {
            return;
        }
        if (courant.vientDeLire()) {
            fichierFautif = false;
            fichierMontre = fichier;
            avertir();
        }
        // l'image d'abord : vue avec le lancer d'après, elle a au moins son brouillon
        ImageMemoire image = main.getImage();
        Lancer lancer = courant.getLancer();
        if (lancer != null) {
            panneau.montrer(image, lancer.isBrouillonFait(), courant.getDureeNs() > PATIENCE_NS);
        }
        barre.avancer(courant);
        montrerPixel();
    }

    /** Le dessin est achevé, arrêté, ou n'a pas pu se faire. */
    private void finir(Tracage tracage) {
        if (tracage != courant || fermee || !enCours) {
            return;
        }
        enCours = false;
        horloge.stop();
        Throwable panne = tracage.getPanne();
        if (tracage.isAcheve()) {
            complete = main.getImage();
            barre.resumer(tracage);
            if (!fichierFautif) {
                panneau.getBandeau().effacerErreur();
            }
            String ecart = main.getLancer().getTemoignage().ecart;
            if (ecart != null) {
                panneau.getBandeau().avis(ecart);
            }
        }
        observer();
        if (panne != null) {
            fichierFautif = panne instanceof SceneFautive;
            direErreur(Main.message(panne));
        }
        // une faute dans la scène a interrompu un dessin de la précédente : c'est lui, la dernière bonne image
        if (fichierFautif && panne != null && complete != panneau.getImage()) {
            dessiner(false);
        }
    }

    /** Montre ce que la scène a de laissé de côté, ou efface le message qui était là. */
    private void avertir() {
        panneau.getBandeau().avis(String.join("\n", main.getAvertissements()));
    }

    void montrerPixel() {
        barre.montrerPixel(panneau.getPixelSouris(), panneau.getImage());
    }

    private void titrer() {
        String titre = variantes.isEmpty() ? "lancer" : "lancer (" + String.join(", ", variantes) + ")";
        cadre.setTitle(fichier == null ? titre : titre + " — " + new File(fichier).getName());
    }
}
