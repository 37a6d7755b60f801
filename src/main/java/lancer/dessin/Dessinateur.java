package lancer.dessin;

import java.io.PrintStream;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CancellationException;
import java.util.function.DoubleConsumer;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.Camera;
import lancer.Scene;
import lancer.SceneFautive;
import lancer.commande.Echec;
import lancer.commande.Options;
import lancer.commande.Pannes;
import lancer.contrat.Compteurs;
import lancer.contrat.Modele;
import lancer.contrat.PixelFautif;
import lancer.contrat.Recherche;
import lancer.contrat.RechercheSimple;
import lancer.fils.Traceur;
import lancer.image.ImageMemoire;
import lancer.rapide.Preparation;
import lancer.scene.Origines;
import lancer.scene.SceneLue;
import lancer.texte.Texte;

/**
 * Réglages de la scène du programme, sa préparation, et l'image qu'on en dessine. Un fil lit et dessine ; d'autres
 * regardent.
 */
public final class Dessinateur implements DoubleConsumer {

    /** Taille d'image au-delà de laquelle la fenêtre ne garde pas les couleurs non limitées : 48 Mo. */
    private static final int PIXELS_AVEC_LINEAIRE = 4_000_000;

    private static final double NS_PAR_MS = 1e6;

    public final Programme programme;
    final Options options;
    final PrintStream sortie;
    final PrintStream erreur;
    /** La scène lue et ses réglages ; puis, une fois préparée, son image et ce qui la dessine. */
    volatile Dessin dessin = new Dessin(null, null, null, null, null);
    /** La scène lue, {@code null} tant qu'aucune ne l'est, et le modèle selon lequel elle se dessine. */
    private volatile Scene scene;
    private volatile Modele modele;
    private volatile double avancement;
    private Runnable entracte;
    private long lectureNs;
    private long preparationNs;

    /** @param programme ce qui lit la scène et reçoit les pixels */
    public Dessinateur(Programme programme, Options options, PrintStream sortie, PrintStream erreur) {
        this.programme = programme;
        this.options = options;
        this.sortie = sortie;
        this.erreur = erreur;
    }

    /**
     * Prépare une scène pour une image de cette taille : tout dessin du programme passe par ici, et ceux qu'on mesure
     * aussi.
     *
     * @param simple vrai pour les boucles du cours
     * @throws CancellationException si le fil appelant est interrompu
     */
    public static Traceur traceur(Scene scene, int largeur, int hauteur, boolean simple) {
        return traceur(scene, largeur, hauteur, simple, part -> { });
    }

    /** Prépare une scène pour une image de cette taille, en disant la part faite, de 0 à 1, après chaque étape. */
    public static Traceur traceur(Scene scene, int largeur, int hauteur, boolean simple, DoubleConsumer suivi) {
        Camera camera = new Camera(largeur, hauteur);
        scene.getModele().setRecherche(simple ? new RechercheSimple(scene.getObjets(), scene.getCompteurs())
                : Preparation.pour(scene, camera, suivi));
        return new Traceur(scene, camera);
    }

    /**
     * Lit une scène, qui devient celle à dessiner.
     *
     * @param nomFichier voir {@link Scene#Scene(String)}
     * @return ce que la lecture a laissé de côté, une ligne chacun
     * @throws SceneFautive si elle ne peut être utilisée ; la précédente reste alors en place
     * @throws CancellationException si ce fil a été interrompu ; la précédente reste aussi
     */
    public List<String> lireScene(String nomFichier) {
        avancement = 0;
        long debut = System.nanoTime();
        SceneLue lue = programme.lireScene(nomFichier, this);
        ReglagesDessin lus = new ReglagesDessin(lue.variantes, options);
        Modele installe = lus.getModele();
        lus.verifier(options);
        Scene neuve = new Scene(lue.objets, lue.lampes);
        // la scène d'avant reste, si cette lecture est abandonnée
        Recherche.obeir();
        lectureNs = System.nanoTime() - debut;
        scene = neuve;
        modele = installe;
        remplacer(nomFichier, lue.origines, lus);
        return lue.avertissements;
    }

    /** Note la part faite de la lecture, ou de la préparation, de 0 à 1. */
    @Override
    public void accept(double part) {
        avancement = part;
    }

    /** Oublie le dessin d'avant : il n'est pas celui de cette scène ainsi réglée, même tant qu'elle n'est que lue. */
    private void remplacer(String fichier, Origines origines, ReglagesDessin reglages) {
        avancement = 0;
        dessin = new Dessin(fichier, origines, reglages, null, null);
    }

    /**
     * Règle la scène lue, jusqu'à la suivante.
     *
     * @throws SceneFautive si ces réglages ne vont pas ; rien n'est alors changé
     */
    public void regler(ReglagesDessin voulus) {
        modele = voulus.getModele();
        remplacer(dessin.fichier, dessin.origines, voulus);
    }

    /** Réglages de la scène lue, tant que {@link #regler} n'en dit pas plus. */
    public ReglagesDessin getReglages() {
        return dessin.reglages;
    }

    /** La part faite de la lecture, ou de la préparation, de 0 à 1. */
    public double getAvancement() {
        return avancement;
    }

    /** L'image qui se dessine, ou s'est dessinée ; {@code null} tant que la scène ne se dessine pas. */
    public ImageMemoire getImage() {
        return dessin.image;
    }

    /** L'image de la scène lue, ainsi réglée, avec ce qui la dessine ; {@code null} tant qu'elle ne se dessine pas. */
    public Dessin getDessin() {
        Dessin present = dessin;
        return present.image == null ? null : present;
    }

    /** Prépare la scène lue pour une image de cette taille, que garde la fenêtre. */
    public Traceur preparer(int largeur, int hauteur) {
        Traceur nouveau = preparer(
                new ImageMemoire(largeur, hauteur, (long) largeur * hauteur <= PIXELS_AVEC_LINEAIRE));
        nouveau.setEntracte(entracte);
        entracte = null;
        return nouveau;
    }

    /** Fait faire ceci, une fois, entre le brouillon du prochain dessin et son image ; à demander avant lui. */
    public void setEntracte(Runnable entracte) {
        this.entracte = entracte;
    }

    /** Une vue de la scène lue, ainsi réglée. */
    Scene getScene() {
        return scene.avec(modele);
    }

    /** Prépare la scène lue pour une image, qui devient celle que l'on dessine. */
    Traceur preparer(ImageMemoire vierge) {
        remplacer(dessin.fichier, dessin.origines, dessin.reglages);
        long debut = System.nanoTime();
        Traceur traceur = traceur(getScene(), vierge.largeur, vierge.hauteur, options.simple, this);
        preparationNs = System.nanoTime() - debut;
        dessin = new Dessin(dessin.fichier, dessin.origines, dessin.reglages, vierge, traceur);
        return traceur;
    }

    /** Rapporte un dessin achevé : l'écart qu'a vu la préparation, ses nombres s'ils sont demandés. */
    public void rapporter(Traceur acheve) {
        direEcart(acheve);
        if (options.statistiques) {
            sortie.println(statistiques(acheve, acheve.getDureeNs()));
            sortie.flush();
        }
    }

    /** Dit, si c'est le cas, que la recherche rapide ne répondait pas comme les classes du cours. */
    void direEcart(Traceur acheve) {
        if (acheve.getEcart() != null) {
            Pannes.avertir(Collections.singletonList(acheve.getEcart()), erreur);
        }
    }

    /**
     * Texte de {@code --statistiques} : comptes d'un dessin, et temps. Toujours avec un point décimal, sans
     * séparateur de milliers ni exposant, quelle que soit la langue de la machine.
     *
     * @param tracesNs le temps de chaque dessin, dans l'ordre, en nanosecondes
     */
    String statistiques(Traceur acheve, long... tracesNs) {
        Compteurs c = acheve.getCompteurs();
        // au début, la machine virtuelle compile encore : la médiane de la seconde moitié
        double[] tries = Arrays.stream(tracesNs).skip(tracesNs.length / 2).sorted().asDoubleStream().toArray();
        double traceNs = (tries[(tries.length - 1) / 2] + tries[tries.length / 2]) / 2;
        return String.format(Locale.ROOT, "rayons.primaires: %d\nrayons.ombre: %d\nrayons.reflechis: %d\n"
                + "tests.spheres: %d\ntests.precis: %d\nnoeuds.visites: %d\npixels.raffines: %d\n"
                + "lecture.ms: %.3f\npreparation.ms: %.3f\ntrace.ms: %.3f\nrayons.par.seconde: %d",
                c.primaires, c.ombre, c.reflechis, c.testsSpheres, c.testsPrecis, c.noeudsVisites,
                c.pixelsRaffines, lectureNs / NS_PAR_MS,
                (preparationNs + acheve.getConstructionNs()) / NS_PAR_MS,
                traceNs / NS_PAR_MS, Math.round(c.rayons() / (Math.max(traceNs, 1) / 1e9)));
    }

    /** Échec à dire d'un pixel de la scène lue qui n'a pu être calculé. */
    public Echec nommer(PixelFautif panne) {
        Dessin present = dessin;
        boolean dessinee = present.image != null;
        return Echec.panne(Pannes.duPixel(panne, classes(getScene()), present.reglages.getOptions(),
                present.fichier, dessinee ? present.image.largeur : options.largeur,
                dessinee ? present.image.hauteur : options.hauteur));
    }

    /**
     * Classes où situer un échec, par ordre de préférence : objets, air et reflet ; le cours ; l'échantillonnage, qui
     * demande chaque couleur, et se trouve donc dans toutes les piles ; ce qui n'est pas de Java.
     */
    static String[] classes(Scene scene) {
        Modele modele = scene.getModele();
        // ce que la base met à la place d'une variante n'est pas en cause
        String siennes = Stream.concat(Stream.of(modele.getAtmosphere(), modele.getSpecularite()),
                scene.getObjets().stream()).map(Modele::nom).distinct()
                .filter(nom -> !nom.startsWith("lancer.contrat.")).map(Pattern::quote).collect(Collectors.joining("|"));
        return new String[] {siennes, "lancer\\.(?!Main)[A-Z]\\w*",
            "(?!lancer\\.contrat\\.)" + Pattern.quote(Modele.nom(modele.getEchantillonnage())), Texte.HORS_DE_JAVA};
    }
}
