package lancer.fenetre.moteur;

import java.util.function.Consumer;
import lancer.commande.Reglages;
import lancer.dessin.Demande;
import lancer.dessin.Dessin;
import lancer.dessin.Programme;
import lancer.fenetre.etat.Avancement;
import lancer.fenetre.etat.Suite.Evenement;
import lancer.scene.SceneLue;
import lancer.scene.Surveillance;

/** Lit la scène si elle ne l'est pas, puis dessine le brouillon et l'image. */
final class Dessinateur extends Tache {

    private final Programme programme;
    private final Reglages options;
    /** Le fichier à lire, ou {@code null} ; ce qui est demandé, ou dont les réglages restent. */
    private final String aLire;
    private final Demande demande;
    private final Avancement avancement;
    /** La version du fichier avant sa lecture. */
    private volatile String version;

    Dessinateur(int numero, Consumer<Evenement> recevoir, Programme programme, Reglages options, String aLire,
            Demande demande, Avancement avancement) {
        super(numero, recevoir);
        this.programme = programme;
        this.options = options;
        this.aLire = aLire;
        this.demande = demande;
        this.avancement = avancement;
    }

    @Override
    protected Evenement doInBackground() {
        Demande voulue = aLire == null ? demande : lire();
        Dessin[] commence = new Dessin[1];
        Dessin fini = programme.dessiner(voulue, dessin -> {
            if (commence[0] == null) {
                commence[0] = dessin;
                dessin.lancer.getAtelier().getFautes().tolerer();
                avancement.passer("brouillon");
                direAvantLaFin(suite -> suite.preparer(dessin));
            } else {
                avancement.passer("dessin");
                direAvantLaFin(suite -> suite.ebaucher(dessin));
            }
        });
        avancement.finir();
        return suite -> suite.achever(fini);
    }

    private Demande lire() {
        String celle = Surveillance.version(aLire);
        version = celle;
        SceneLue scene = programme.lire(aLire, avancement::lire);
        Demande lue = demande == null ? new Demande(scene, options) : demande.avecLecture(scene);
        avancement.passer("préparation");
        dire(suite -> suite.lue(celle, lue));
        return lue;
    }

    @Override
    Evenement echouer(Throwable echec) {
        avancement.finir();
        return suite -> suite.echouer(version, echec);
    }
}
