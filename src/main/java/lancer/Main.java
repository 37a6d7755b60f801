package lancer;

import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CancellationException;
import lancer.auto.Auto;
import lancer.commande.Aide;
import lancer.commande.CodeSortie;
import lancer.commande.Echec;
import lancer.commande.Options;
import lancer.commande.Pannes;
import lancer.contrat.PixelFautif;
import lancer.contrat.RechercheSimple;
import lancer.contrat.Toile;
import lancer.contrat.Variante;
import lancer.fenetre.Fenetre;
import lancer.lecture.LecteurScene;
import lancer.rapide.LancerSurveille;
import lancer.rapide.Preparation;
import lancer.sortie.BarreProgression;
import lancer.sortie.Comparaison;
import lancer.sortie.Ecriture;
import lancer.sortie.FichierPfm;
import lancer.sortie.FichierPng;
import lancer.sortie.ImageLue;
import lancer.sortie.ImageMemoire;
import lancer.sortie.Statistiques;
import lancer.sortie.UnPixel;
import lancer.texte.Texte;

/**
 * Le programme (cours, « Bilan intermédiaire ») : de la ligne de commande à l'image, dans une fenêtre ou dans un
 * fichier. AWT n'est touché que par {@link Fenetre}.
 */
public class Main implements Toile {

    /** Taille d'image au-delà de laquelle la fenêtre ne garde pas les couleurs non limitées : 48 Mo. */
    private static final int PIXELS_AVEC_LINEAIRE = 4_000_000;

    private final Options options;
    private volatile Scene scene;
    private volatile String fichier;
    private volatile List<String> avertissements = Collections.emptyList();
    private List<Variante> variantesLibres;
    private long lectureNs;
    private long preparationNs;
    private volatile ImageMemoire image;
    private volatile Lancer lancer;

    public Main(Options options) {
        this.options = options;
    }

    /** @param args voir {@code --aide} */
    public static void main(String[] args) {
        int code = executer(args, System.out, System.err);
        if (code != CodeSortie.FAIT) {
            System.exit(code);
        }
    }

    /**
     * Le programme entier, sans quitter la machine virtuelle.
     *
     * @return le statut de sortie ; pour 1 et 2, une ligne a été écrite sur {@code erreur}
     */
    static int executer(String[] args, PrintStream sortie, PrintStream erreur) {
        try {
            Options options = Options.lire(args);
            if (options.aide || options.version) {
                dire(sortie, options.aide ? Aide.texte() : Aide.version());
                return CodeSortie.FAIT;
            }
            Main main = new Main(options);
            if (options.comparer != null) {
                return main.comparer(sortie);
            }
            if (options.pixel) {
                main.versLaSortie(sortie, erreur);
            } else if (options.versFichier()) {
                main.versFichiers(sortie, erreur);
            } else {
                Fenetre.ouvrir(main, sortie, erreur);
            }
            return CodeSortie.FAIT;
        } catch (RuntimeException | Error e) {
            direErreur(erreur, message(e));
            return e instanceof Echec ? ((Echec) e).getCode()
                    : e instanceof SceneFautive ? CodeSortie.DEMANDE : CodeSortie.PANNE;
        }
    }

    /** Ce qu'il faut dire d'une panne. */
    public static String message(Throwable panne) {
        if (panne instanceof Echec || panne instanceof SceneFautive) {
            return panne.getMessage();
        }
        if (panne instanceof OutOfMemoryError) {
            // la même erreur de Java dit deux manques ; celui-ci ne vient pas de la mémoire
            if (String.valueOf(panne.getMessage()).contains("native thread")) {
                return "trop de fils d'exécution pour cette machine ; en demander moins, par exemple --fils 2";
            }
            return "mémoire épuisée ; donner plus à Java, par exemple java -Xmx2g -jar …";
        }
        return "échec du programme : " + Texte.echappe(panne.toString());
    }

    /** Une ligne, quoi que contienne le message. */
    private static void direErreur(PrintStream erreur, String message) {
        erreur.println("lancer : " + Texte.echappe(message));
    }

    private static void dire(PrintStream sortie, String texte) {
        sortie.println(texte);
        verifierSortie(sortie);
    }

    /** @throws Echec si la sortie standard n'a pu être écrite : un {@code PrintStream} ne le dit pas de lui-même */
    private static void verifierSortie(PrintStream sortie) {
        if (sortie.checkError()) {
            throw new Echec(CodeSortie.PANNE, "sortie standard : écriture impossible");
        }
    }

    private void versFichiers(PrintStream sortie, PrintStream erreur) {
        Path chemin = LecteurScene.trouver(options.scene);
        Ecriture png = options.image == null ? null : new Ecriture(options.image);
        Ecriture pfm = options.lineaire == null ? null : new Ecriture(options.lineaire);
        refuserMemeFichier(chemin, png, pfm);
        lireScene(options.scene);
        Lancer lancer = preparer(options.largeur, options.hauteur);
        Toile toile = this;
        int reflets = options.reflets;
        Auto auto = options.auto ? new Auto(lancer, options, variantesLibres) : null;
        if (auto != null) {
            lancer = auto.getLancer();
            toile = auto.surveiller(this);
            reflets = auto.getChoisi().getReflets();
        }
        image = new ImageMemoire(options.largeur, options.hauteur, png != null, pfm != null);
        long[] traces = new long[options.repeter];
        BarreProgression barre = BarreProgression.possible() ? new BarreProgression(lancer, erreur) : null;
        if (barre != null) {
            barre.commencer();
        }
        try {
            for (int k = 0; k < traces.length; k++) {
                long debut = System.nanoTime();
                lancer.TracerPixels(toile, reflets, options.fils);
                traces[k] = System.nanoTime() - debut;
            }
        } catch (PixelFautif e) {
            throw nommer(e, options.largeur, options.hauteur);
        } finally {
            if (barre != null) {
                barre.finir();
            }
        }
        if (auto != null) {
            auto.controler();
        }
        if (png != null) {
            png.ecrire(image, new FichierPng.Format());
        }
        if (pfm != null) {
            pfm.ecrire(image, new FichierPfm.Format());
        }
        if (options.statistiques) {
            dire(sortie, new Statistiques(lancer.getCompteurs(), lectureNs, preparationNs, traces).toString());
            if (auto != null) {
                dire(sortie, auto.getRapport().getStatistiques());
            }
        }
        if (auto != null) {
            for (String ligne : auto.getRapport().getLignes()) {
                direErreur(erreur, ligne);
            }
        }
        // en dernier : si quelque chose a échoué, c'est la seule ligne à lire
        avertir(erreur);
        direEcart(lancer, erreur);
    }

    /** Dit, si c'est le cas, que la recherche rapide ne répondait pas comme les classes du cours. */
    public static void direEcart(Lancer lancer, PrintStream erreur) {
        if (lancer.getTemoignage().ecart != null) {
            direErreur(erreur, lancer.getTemoignage().ecart);
        }
    }

    private Echec nommer(PixelFautif panne, int largeur, int hauteur) {
        return new Echec(CodeSortie.PANNE, Pannes.duPixel(panne, options, fichier, largeur, hauteur));
    }

    /** Dessine le seul pixel demandé, et le dit en UTF-8, que la console en soit ou non. */
    private void versLaSortie(PrintStream sortie, PrintStream erreur) {
        lireScene(options.scene);
        Camera camera = new Camera(options.largeur, options.hauteur);
        UnPixel pixel;
        try {
            pixel = UnPixel.dessiner(scene, camera, options.reflets, options.pixelX, options.pixelY);
        } catch (PixelFautif e) {
            throw nommer(e, options.largeur, options.hauteur);
        }
        byte[] octets = (pixel + System.lineSeparator()).getBytes(StandardCharsets.UTF_8);
        sortie.write(octets, 0, octets.length);
        verifierSortie(sortie);
        avertir(erreur);
    }

    /**
     * @return {@link CodeSortie#FAIT} si les images sont pareilles, {@link CodeSortie#PANNE} sinon : c'est une réponse,
     * pas une panne
     */
    private int comparer(PrintStream sortie) {
        Path reference = Paths.get(options.comparer);
        Ecriture png = options.image == null ? null : new Ecriture(options.image);
        if (png != null && (png.vise(reference) || png.vise(Paths.get(options.scene)))) {
            throw new Echec(CodeSortie.DEMANDE, "la sortie est une des images comparées : "
                    + Texte.echappe(options.image) + " ; attendu : un autre fichier");
        }
        ImageLue attendue = ImageLue.lire(options.comparer);
        Comparaison comparaison = new Comparaison(ImageLue.estImage(options.scene) ? ImageLue.lire(options.scene)
                : dessinee(attendue.getLargeur(), attendue.getHauteur()), attendue, options.tolerance);
        if (png != null) {
            png.ecrire(comparaison.getDifferences(), new FichierPng.Format());
        }
        dire(sortie, comparaison.toString());
        return comparaison.pareilles() ? CodeSortie.FAIT : CodeSortie.PANNE;
    }

    private ImageLue dessinee(int largeur, int hauteur) {
        lireScene(options.scene);
        image = new ImageMemoire(largeur, hauteur, true);
        try {
            preparer(largeur, hauteur).TracerPixels(this, options.reflets, options.fils);
        } catch (PixelFautif e) {
            throw nommer(e, largeur, hauteur);
        }
        return new ImageLue(image);
    }

    /** Une sortie ne doit écraser ni la scène, ni l'autre sortie. */
    private void refuserMemeFichier(Path scene, Ecriture png, Ecriture pfm) {
        if (png != null && png.vise(scene) || pfm != null && pfm.vise(scene)) {
            throw new Echec(CodeSortie.DEMANDE, "la sortie est la scène elle-même : " + Texte.echappe(scene.toString())
                    + " ; attendu : un autre fichier");
        }
        if (png != null && pfm != null && png.vise(pfm.getCible())) {
            throw new Echec(CodeSortie.DEMANDE, "--image et --lineaire écrivent le même fichier : "
                    + Texte.echappe(options.image) + " ; attendu : deux fichiers");
        }
    }

    /**
     * Lit une scène, qui devient celle à dessiner.
     *
     * @throws SceneFautive si elle ne peut être utilisée ; la précédente reste alors en place
     */
    public void lireScene(String fichier) {
        long debut = System.nanoTime();
        LecteurScene lu = LecteurScene.lire(fichier);
        Scene nouvelle = new Scene(lu);
        lectureNs = System.nanoTime() - debut;
        nouvelle.setSeuil(options.seuil);
        scene = nouvelle;
        avertissements = lu.getAvertissements();
        variantesLibres = lu.getVariantesLibres();
        this.fichier = fichier;
    }

    /** Ce que la lecture de la scène a laissé de côté, une ligne chacun. */
    public List<String> getAvertissements() {
        return avertissements;
    }

    /** Dit ce que la scène lue a de laissé de côté. */
    public void avertir(PrintStream erreur) {
        for (String avertissement : avertissements) {
            direErreur(erreur, avertissement);
        }
    }

    /** Prépare la scène lue pour une image de cette taille. */
    private Lancer preparer(int largeur, int hauteur) {
        long debut = System.nanoTime();
        Lancer nouveau = preparer(scene, largeur, hauteur, options.simple);
        preparationNs = System.nanoTime() - debut;
        return nouveau;
    }

    /**
     * Prépare une scène pour une image de cette taille : tout dessin du programme passe par ici, et ceux qu'on mesure
     * aussi.
     *
     * @param simple vrai pour les boucles du cours
     */
    public static Lancer preparer(Scene scene, int largeur, int hauteur, boolean simple) {
        Camera camera = new Camera(largeur, hauteur);
        scene.setRecherche(simple
                ? new RechercheSimple(scene.getObjets(), scene.getCompteurs()) : Preparation.pour(scene, camera));
        return new LancerSurveille(scene, camera);
    }

    /**
     * Dessine la scène, brouillon puis image, par {@link #drawPixel} : le travail du SwingWorker de la fenêtre.
     *
     * @throws CancellationException si le dessin a été arrêté
     * @throws Echec si un pixel ne peut être calculé
     */
    public void doTracerImage(int largeur, int hauteur) {
        // dans cet ordre : qui voit la nouvelle image ne voit plus l'ancien lancer
        lancer = null;
        image = new ImageMemoire(largeur, hauteur, (long) largeur * hauteur <= PIXELS_AVEC_LINEAIRE);
        Lancer nouveau = preparer(largeur, hauteur);
        lancer = nouveau;
        try {
            nouveau.TracerImage(this, options.reflets, options.fils);
        } catch (PixelFautif e) {
            throw nommer(e, largeur, hauteur);
        }
    }

    public Options getOptions() {
        return options;
    }

    /** La scène à dessiner, {@code null} si aucune n'a encore été lue. */
    public Scene getScene() {
        return scene;
    }

    /** L'image que dessine, ou qu'a dessinée, {@link #doTracerImage} ; {@code null} avant la première. */
    public ImageMemoire getImage() {
        return image;
    }

    /** Ce qui dessine cette image ; {@code null} tant que la scène se prépare. */
    public Lancer getLancer() {
        return lancer;
    }

    /** Les comptes et les temps du dernier {@link #doTracerImage} allé au bout, sans le temps du brouillon. */
    public Statistiques getStatistiques() {
        return new Statistiques(lancer.getCompteurs(), lectureNs, preparationNs, lancer.getDureeNs());
    }

    /** Dessine un pixel de l'image en cours. */
    @Override
    public void drawPixel(Couleur coul, int xe, int ye) {
        image.drawPixel(coul, xe, ye);
    }
}
