package lancer.fenetre;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import lancer.Couleur;
import lancer.Main;
import lancer.commande.Options;
import lancer.commande.Reglages;
import lancer.dessin.Demande;
import lancer.dessin.Dessin;
import lancer.dessin.Programme;
import lancer.dessin.Rapport;
import lancer.essai.Essai;
import lancer.scene.LecteurScene;
import lancer.scene.SceneLue;

/** Le programme, dont la lecture se retient, et dont le dessin se ralentit après le brouillon. */
class MainLent implements Programme {

    private static final long PAUSE_NS = 1_000_000;
    /** Ce que le programme écrit, et dit. */
    final ByteArrayOutputStream sortie = new ByteArrayOutputStream();
    volatile boolean lent;
    /** Vrai si le brouillon du dessin en cours est fait. */
    volatile boolean brouillonFait;
    /** Ce qui se fait avant chaque lecture, puis à ce qui est lu, et avant chaque dessin. */
    volatile Runnable avantLecture = () -> { };
    volatile Consumer<SceneLue> apresLecture = lue -> { };
    volatile Runnable avantDessin = () -> { };
    private final Reglages options;

    MainLent(String... args) {
        options = Options.lire(args);
    }

    @Override
    public SceneLue lire(String fichier, DoubleConsumer suivi) {
        avantLecture.run();
        SceneLue lue = LecteurScene.lireEtGarder(fichier, suivi);
        apresLecture.accept(lue);
        return lue;
    }

    @Override
    public Dessin dessiner(Demande demande, Consumer<Dessin> suivi) {
        Dessin[] dernier = new Dessin[1];
        brouillonFait = false;
        avantDessin.run();
        new Main(demande, dessin -> {
            brouillonFait = dernier[0] != null;
            dernier[0] = dessin;
            suivi.accept(dessin);
        }) {
            @Override
            public void drawPixel(Couleur coul, int xe, int ye) {
                super.drawPixel(coul, xe, ye);
                if (lent && brouillonFait) {
                    LockSupport.parkNanos(PAUSE_NS);
                }
            }
        }.doTracerImage(demande.largeur, demande.hauteur);
        Essai.exigerLaRecherche(dernier[0].ecart);
        Rapport.dire(dernier[0], new PrintStream(sortie, true), new PrintStream(sortie, true));
        return dernier[0];
    }

    /** Ouvre la fenêtre de ce programme. */
    Fenetre ouvrir(Runnable fin) {
        return Ouverture.ouvrir(options, this, new PrintStream(sortie, true), fin);
    }
}
