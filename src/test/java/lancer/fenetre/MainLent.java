package lancer.fenetre;

import java.io.ByteArrayOutputStream;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BiConsumer;
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

/** Le programme, avec un dessin qu'on peut ralentir après le brouillon. */
class MainLent implements Programme {

    private static final long PAUSE_NS = 1_000_000;
    final Reglages options;
    final ByteArrayOutputStream sortie = new ByteArrayOutputStream();
    final ByteArrayOutputStream erreur = new ByteArrayOutputStream();
    volatile boolean lent;
    private volatile Dessin dernier;
    private volatile boolean brouillonFait;
    private BiConsumer<String, DoubleConsumer> avantLecture = (fichier, suivi) -> { };
    private Consumer<SceneLue> apresLecture = lue -> { };

    MainLent(String... args) {
        options = Options.lire(args);
    }

    MainLent lent() {
        lent = true;
        return this;
    }

    /** Vrai si le brouillon du dessin en cours est fait. */
    boolean brouillonFait() {
        return brouillonFait;
    }

    /** Fait d'abord ceci, à chaque lecture. */
    MainLent avantLecture(BiConsumer<String, DoubleConsumer> geste) {
        avantLecture = geste;
        return this;
    }

    /** Change ce qui est lu, à chaque lecture. */
    MainLent apresLecture(Consumer<SceneLue> geste) {
        apresLecture = geste;
        return this;
    }

    @Override
    public SceneLue lire(String fichier, DoubleConsumer suivi) {
        avantLecture.accept(fichier, suivi);
        SceneLue lue = LecteurScene.lireEtGarder(fichier, suivi);
        apresLecture.accept(lue);
        return lue;
    }

    /** Fait le dessin en cours. */
    void tracer(Runnable dessiner) {
        dessiner.run();
    }

    /** Peint un pixel de la ligne {@code ye} du dessin en cours. */
    void peindre(int ye, Runnable peindre) {
        peindre.run();
        if (lent && brouillonFait()) {
            LockSupport.parkNanos(PAUSE_NS);
        }
    }

    @Override
    public Dessin dessiner(Demande demande, Consumer<Dessin> suivi) {
        dernier = null;
        brouillonFait = false;
        new Main(demande, dessin -> {
            brouillonFait = dernier != null;
            dernier = dessin;
            suivi.accept(dessin);
        }) {
            @Override
            public void doTracerImage(int largeur, int hauteur) {
                tracer(() -> super.doTracerImage(largeur, hauteur));
            }

            @Override
            public void drawPixel(Couleur coul, int xe, int ye) {
                peindre(ye, () -> super.drawPixel(coul, xe, ye));
            }
        }.doTracerImage(demande.largeur, demande.hauteur);
        Essai.exigerLaRecherche(dernier.ecart);
        Rapport.dire(dernier, BancFenetre.flux(sortie), BancFenetre.flux(erreur));
        return dernier;
    }

    /** Le dernier dessin commencé, {@code null} s'il se prépare. */
    Dessin getDessin() {
        return dernier;
    }

    /** Ouvre la fenêtre de ce programme. */
    Fenetre ouvrir(Runnable fin) {
        return Ouverture.ouvrir(options, this, BancFenetre.flux(erreur), fin);
    }
}
