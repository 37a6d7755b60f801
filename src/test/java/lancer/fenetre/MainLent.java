package lancer.fenetre;

import java.io.ByteArrayOutputStream;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import lancer.Couleur;
import lancer.Main;
import lancer.commande.Options;
import lancer.dessin.Dessin;
import lancer.scene.SceneLue;

/** Le programme, avec un dessin qu'on peut ralentir après le brouillon. */
class MainLent extends Main {

    private static final long PAUSE_NS = 1_000_000;
    final Options options;
    final ByteArrayOutputStream sortie;
    final ByteArrayOutputStream erreur;
    volatile boolean lent;
    private volatile Dessin dernier;
    private BiConsumer<String, DoubleConsumer> avantLecture = (fichier, suivi) -> { };
    private Consumer<SceneLue> apresLecture = lue -> { };

    MainLent(String... args) {
        this(Options.lire(args), new ByteArrayOutputStream(), new ByteArrayOutputStream());
    }

    private MainLent(Options options, ByteArrayOutputStream sortie, ByteArrayOutputStream erreur) {
        super(options, BancFenetre.flux(sortie), BancFenetre.flux(erreur));
        this.options = options;
        this.sortie = sortie;
        this.erreur = erreur;
        dernier = new Dessin(options, this::lireScene, BancFenetre.flux(erreur), options.scene, options.largeur, options.hauteur);
    }

    MainLent lent() {
        lent = true;
        return this;
    }

    /** Vrai si le brouillon du dessin en cours est fait. */
    boolean brouillonFait() {
        return dernier.isBrouillonFait();
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
    protected SceneLue lireScene(String fichier, DoubleConsumer suivi) {
        avantLecture.accept(fichier, suivi);
        SceneLue lue = super.lireScene(fichier, suivi);
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

    private void dessiner(Dessin voulu) {
        dernier = voulu;
        new Main(this, voulu) {
            @Override
            public void doTracerImage(int largeur, int hauteur) {
                tracer(() -> super.doTracerImage(largeur, hauteur));
            }

            @Override
            public void drawPixel(Couleur coul, int xe, int ye) {
                peindre(ye, () -> super.drawPixel(coul, xe, ye));
            }

            @Override
            protected void dessiner() {
                super.dessiner();
            }
        }.dessiner();
    }

    Dessin getDessin() {
        return dernier;
    }

    /** Ouvre la fenêtre de ce programme. */
    Fenetre ouvrir(Runnable fin) {
        return Ouverture.ouvrir(options, dernier, this::dessiner, BancFenetre.flux(erreur), fin);
    }
}
