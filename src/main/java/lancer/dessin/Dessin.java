package lancer.dessin;

import java.io.PrintStream;
import java.util.Arrays;
import java.util.Collections;
import java.util.Locale;
import java.util.concurrent.CancellationException;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.Camera;
import lancer.Constantes;
import lancer.Lancer;
import lancer.Scene;
import lancer.SceneFautive;
import lancer.commande.Echec;
import lancer.commande.Messages;
import lancer.commande.Options;
import lancer.contrat.Compteurs;
import lancer.contrat.Modele;
import lancer.contrat.PixelFautif;
import lancer.contrat.Toile;
import lancer.fils.Equipe;
import lancer.fils.Fil;
import lancer.image.ImageMemoire;
import lancer.inspection.FaussesCouleurs;
import lancer.rapide.Preparation;
import lancer.rapide.Regard;
import lancer.scene.SceneLue;
import lancer.texte.Pile;
import lancer.texte.Texte;

/**
 * Un dessin : une scène, ses réglages, une taille, puis l'image et le lancer qui la dessine. Un fil lit, prépare et
 * dessine, dans cet ordre ; les autres fils lisent l'avancement. Chaque dessin a sa propre image.
 */
public final class Dessin implements DoubleConsumer, Consumer<Fil> {

    /** Nombre de pixels au-delà duquel la fenêtre ne garde pas les couleurs non limitées (48 Mo). */
    private static final int PIXELS_AVEC_LINEAIRE = 4_000_000;

    private static final double NS_PAR_MS = 1e6;

    private final Options options;
    private final BiFunction<String, DoubleConsumer, SceneLue> lecture;
    private final PrintStream erreur;
    public final String fichier;
    public final int largeur;
    public final int hauteur;
    private volatile SceneLue lue;
    private volatile ReglagesDessin reglages;
    private volatile Scene scene;
    private volatile ImageMemoire image;
    private volatile ImageMemoire apercu;
    private String vue;
    private ImageMemoire reference;
    private volatile Lancer lancer;
    private volatile Regard regard;
    private volatile String lenteur;
    private volatile double avancement;
    private volatile boolean brouillonFait;
    private Runnable entracte;
    private long lectureNs;
    private long preparationNs;

    /** Un dessin de cette scène, qui n'est pas encore lue. @param erreur sortie des avertissements */
    public Dessin(Options options, BiFunction<String, DoubleConsumer, SceneLue> lecture, PrintStream erreur,
            String fichier, int largeur, int hauteur) {
        this.options = options;
        this.lecture = lecture;
        this.erreur = erreur;
        this.fichier = fichier;
        this.largeur = largeur;
        this.hauteur = hauteur;
    }

    /** Un dessin d'une autre scène, qui n'est pas encore lue. */
    public Dessin pour(String autreFichier, int autreLargeur, int autreHauteur) {
        return new Dessin(options, lecture, erreur, autreFichier, autreLargeur, autreHauteur);
    }

    /** Un dessin de la même scène à cette taille. La scène n'est pas relue. */
    public Dessin avec(int autreLargeur, int autreHauteur) {
        Dessin autre = pour(fichier, autreLargeur, autreHauteur);
        autre.lue = lue;
        autre.reglages = reglages;
        autre.scene = scene;
        return autre;
    }

    /** Dessine cette version de la scène lue, ainsi réglée. @throws SceneFautive si un réglage est refusé */
    public void changer(SceneLue version, ReglagesDessin voulus) {
        if (version != lue) {
            lue = version;
            scene = new Scene(version.objets, version.lampes);
        }
        regler(voulus);
    }

    /** Un dessin achevé de la scène préparée ici : l'image que ce lancer a dessinée avec ces réglages. */
    public Dessin dessine(ReglagesDessin siens, ImageMemoire sienne, Lancer sien) {
        Dessin autre = avec(largeur, hauteur);
        autre.reglages = siens;
        autre.scene = sien.getScene();
        autre.image = sienne;
        autre.lancer = sien;
        autre.brouillonFait = true;
        return autre;
    }

    /** Remplace l'image par cette vue. @param avant référence de la vue « difference », si elle a cette taille */
    public void setVue(String vue, ImageMemoire avant) {
        this.vue = vue;
        reference = avant != null && avant.largeur == largeur && avant.hauteur == hauteur ? avant : null;
    }

    /** Nom de la vue en fausses couleurs ; {@code null} pour l'image. */
    public String getVue() {
        return vue;
    }

    /**
     * Lit la scène.
     *
     * @throws SceneFautive si le fichier ne peut être utilisé
     * @throws CancellationException si ce fil a été interrompu
     */
    public void lire() {
        Fil.commencer("lecture");
        long debut = System.nanoTime();
        SceneLue nouvelle = lecture.apply(fichier, this);
        scene = new Scene(nouvelle.objets, nouvelle.lampes);
        ReglagesDessin initiaux = new ReglagesDessin(nouvelle.variantes, options);
        regler(initiaux);
        initiaux.verifier(options);
        lectureNs = System.nanoTime() - debut;
        lue = nouvelle;
    }

    /** Applique ces réglages à la scène lue. @throws SceneFautive si un réglage est refusé */
    public void regler(ReglagesDessin voulus) {
        Fil.commencer("réglage");
        scene = scene.avec(voulus.getModele());
        reglages = voulus;
    }

    @Override
    public void accept(double part) {
        avancement = part;
        Fil.avancer();
    }

    /** Prépare la scène lue pour une image de cette taille. @throws CancellationException si ce fil est interrompu */
    public Lancer preparer(int colonnes, int lignes) {
        return preparer(new ImageMemoire(colonnes, lignes, (long) colonnes * lignes <= PIXELS_AVEC_LINEAIRE));
    }

    /** Prépare la scène lue pour cette image. @throws CancellationException si ce fil est interrompu */
    Lancer preparer(ImageMemoire vierge) {
        Fil.commencer("préparation");
        avancement = 0;
        long debut = System.nanoTime();
        Camera camera = new Camera(vierge.largeur, vierge.hauteur);
        regard = Preparation.choisir(scene, camera, options.simple, this);
        preparationNs = System.nanoTime() - debut;
        image = vierge;
        lancer = new Lancer(scene, camera);
        return lancer;
    }

    /** Dessine tous les pixels avec ce lancer, une deuxième fois si la recherche cachait un objet. */
    public void tracer(Lancer sien, Toile toile, int profondeur, int fils) {
        sien.TracerPixels(regard.sur(toile), profondeur, fils);
        if (regard.cachait(sien, profondeur)) {
            sien.TracerPixels(toile, profondeur, fils);
        }
    }

    /** Exécute ce travail dans un autre fil. Ce qui y dure dix secondes est nommé une fois, et continue. */
    public void observer(Runnable travail) {
        new Equipe("dessin", this).faire(travail);
    }

    /** Dessine une petite image, un rayon par pixel, que la fenêtre montre pendant le brouillon. */
    public void apercevoir(int colonnes, int lignes, int fils) {
        Dessin petit = avec(colonnes, lignes);
        Modele modele = scene.getModele();
        petit.scene = scene.avec(modele.avec(null, modele.getSeuil()));
        Lancer sien = petit.preparer(colonnes, lignes);
        sien.getFautes().tolerer();
        sien.TracerPixels(petit.image, Math.min(reglages.getProfondeur(), Constantes.REFLETS_BROUILLON), fils);
        apercu = petit.image;
    }

    /** La petite image qui précède le brouillon ; {@code null} si elle n'existe pas ou si le brouillon est fini. */
    public ImageMemoire getApercu() {
        return brouillonFait ? null : apercu;
    }

    /** Dessine le brouillon, puis la vue demandée. */
    public void dessinerLaVue(int fils) {
        Lancer brouillon = preparer(largeur, hauteur);
        brouillon.getFautes().tolerer();
        try {
            brouillon.TracerBrouillon(image, Math.min(reglages.getProfondeur(), Constantes.REFLETS_BROUILLON), fils);
            finirBrouillon();
            new FaussesCouleurs(brouillon, reglages.getProfondeur(), fils, sien -> lancer = sien)
                    .dessiner(vue, image, reference);
        } catch (PixelFautif e) {
            throw nommer(e);
        }
    }

    @Override
    public void accept(Fil lent) {
        if (lenteur == null) {
            String cause = "ce calcul dure depuis dix secondes" + Pile.ligne(lent.getStackTrace(), Pile.HORS_DU_MOTEUR);
            lenteur = lent.getEtape() == null ? dire(lent.getX(), lent.getY(), cause)
                    : lent.getEtape() + " de " + Texte.echappe(fichier) + " : " + cause;
            Messages.avertir(Collections.singletonList(lenteur), erreur);
        }
    }

    /** Phrase qui nomme le premier calcul qui dure dix secondes ; {@code null} s'il n'y en a pas. */
    public String getLenteur() {
        return lenteur;
    }

    /** Le lancer d'une scène préparée pour une image de cette taille. @param simple vrai pour les boucles du cours */
    public static Lancer lancer(Scene scene, int largeur, int hauteur, boolean simple) {
        Camera camera = new Camera(largeur, hauteur);
        Preparation.choisir(scene, camera, simple, part -> { });
        return new Lancer(scene, camera);
    }

    public void finirBrouillon() {
        brouillonFait = true;
        if (entracte != null) {
            entracte.run();
        }
    }

    /** Appelle {@code entracte} entre le brouillon et l'image ; à demander avant de dessiner. */
    public void setEntracte(Runnable entracte) {
        this.entracte = entracte;
    }

    public boolean isBrouillonFait() {
        return brouillonFait;
    }

    /** La scène lue et réglée ; {@code null} avant la lecture. */
    public Scene getScene() {
        return scene;
    }

    /** Le contenu du fichier ; {@code null} avant la lecture. */
    public SceneLue getLue() {
        return lue;
    }

    public ReglagesDessin getReglages() {
        return reglages;
    }

    /** L'image ; {@code null} avant la préparation. */
    public ImageMemoire getImage() {
        return image;
    }

    /** Le lancer qui dessine l'image ; {@code null} avant la préparation. */
    public Lancer getLancer() {
        return lancer;
    }

    /** Phrase qui dit pourquoi les boucles du cours remplacent la recherche rapide ; {@code null} sinon. */
    public String getEcart() {
        return regard == null ? null : regard.getEcart();
    }

    /** Le regard sur ce que la recherche pourrait cacher ; {@code null} avant la préparation. */
    public Regard getRegard() {
        return regard;
    }

    /** La part faite, de 0 à 1, de l'étape en cours : lecture, préparation, brouillon ou image. */
    public double getAvancement() {
        return lancer == null ? avancement : lancer.getAvancement();
    }

    /** Écrit les avertissements de la lecture, puis {@link #direEcart}. */
    void avertir() {
        Messages.avertir(lue.avertissements, erreur);
        direEcart();
    }

    /** Avertit si une réponse de la recherche rapide diffère de celle des classes du cours. */
    public void direEcart() {
        if (getEcart() != null) {
            Messages.avertir(Collections.singletonList(getEcart()), erreur);
        }
    }

    /** Le nombre de rayons et le temps de ce dessin achevé. */
    public String getCout() {
        // l'espace fine insécable manque à beaucoup de polices
        return String.format(Locale.FRANCE, "%,d rayons en %.2f s", lancer.getCompteurs().rayons(),
                lancer.getDureeNs() / 1e9).replace('\u202F', '\u00A0');
    }

    /**
     * Texte de {@code --statistiques} : compteurs d'un dessin, et temps. Les nombres ont un point décimal, sans
     * séparateur de milliers ni exposant, quelle que soit la langue de la machine.
     *
     * @param acheve le lancer qui a dessiné l'image
     * @param tracesNs le temps de chaque dessin, dans l'ordre, en nanosecondes
     */
    public String statistiques(Lancer acheve, long... tracesNs) {
        Compteurs c = acheve.getCompteurs();
        // la première moitié des dessins s'exécute avant la fin de la compilation : voir docs/etendre.md
        double[] tries = Arrays.stream(tracesNs).skip(tracesNs.length / 2).sorted().asDoubleStream().toArray();
        double traceNs = (tries[(tries.length - 1) / 2] + tries[tries.length / 2]) / 2;
        return String.format(Locale.ROOT, "rayons.primaires: %d\nrayons.ombre: %d\nrayons.reflechis: %d\n"
                + "tests.spheres: %d\nnoeuds.visites: %d\npixels.raffines: %d\n"
                + "lecture.ms: %.3f\npreparation.ms: %.3f\ntrace.ms: %.3f\nrayons.par.seconde: %d",
                c.primaires, c.ombre, c.reflechis, c.testsSpheres, c.noeudsVisites,
                c.pixelsRaffines, lectureNs / NS_PAR_MS,
                preparationNs / NS_PAR_MS,
                traceNs / NS_PAR_MS, Math.round(c.rayons() / (Math.max(traceNs, 1) / 1e9)));
    }

    /** L'échec qui nomme un pixel de la scène lue dont le calcul a échoué. */
    public Echec nommer(PixelFautif faute) {
        return Echec.machine(dire(faute.x, faute.y, Pile.cause(faute, classes(scene))));
    }

    private String dire(int x, int y, String cause) {
        return Messages.duPixel(x, y, cause, reglages.getOptions(), fichier,
                image == null ? largeur : image.largeur, image == null ? hauteur : image.hauteur);
    }

    /**
     * Classes où situer un échec, par ordre de préférence. Celles des objets, de l'air et du reflet viennent d'abord,
     * puis celles du cours, puis l'échantillonnage, présent dans toutes les piles, puis toute classe hors de Java.
     */
    static String[] classes(Scene scene) {
        Modele modele = scene.getModele();
        // les contrats par défaut de la base ne peuvent être la cause de l'échec
        String siennes = Stream.concat(Stream.of(modele.getAtmosphere(), modele.getSpecularite()),
                scene.getObjets().stream()).map(Modele::nom).distinct()
                .filter(nom -> !nom.startsWith("lancer.contrat.")).map(Pattern::quote).collect(Collectors.joining("|"));
        return new String[] {siennes, "lancer\\.(?!Main)[A-Z]\\w*", modele.getEchantillonnage() == null ? ""
                : Pattern.quote(Modele.nom(modele.getEchantillonnage())), Pile.HORS_DE_JAVA};
    }
}
