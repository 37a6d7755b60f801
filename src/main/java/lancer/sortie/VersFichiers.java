package lancer.sortie;

import java.io.PrintStream;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import java.util.function.DoubleSupplier;
import lancer.Lancer;
import lancer.auto.Auto;
import lancer.auto.Souhait;
import lancer.commande.CodeSortie;
import lancer.commande.Echec;
import lancer.commande.Options;
import lancer.commande.Pannes;
import lancer.contrat.Toile;
import lancer.contrat.Variante;
import lancer.lecture.LecteurScene;
import lancer.texte.Texte;

/** Le travail sans fenêtre : les fichiers demandés, vérifiés avant de dessiner, et ce qu'il y a à dire du dessin. */
public final class VersFichiers {

    private final Options options;
    private final PrintStream sortie;
    private final PrintStream erreur;
    private final Ecriture png;
    private final Ecriture pfm;

    private VersFichiers(Options options, PrintStream sortie, PrintStream erreur) {
        this.options = options;
        this.sortie = sortie;
        this.erreur = erreur;
        png = options.image == null ? null : new Ecriture(options.image);
        pfm = options.lineaire == null ? null : new Ecriture(options.lineaire);
    }

    /** @throws Echec si une sortie ne pourra être écrite, ou si elle écraserait la scène ou l'autre sortie */
    public static VersFichiers pourDessiner(Options options, PrintStream sortie, PrintStream erreur) {
        Path scene = LecteurScene.trouver(options.scene);
        VersFichiers fichiers = new VersFichiers(options, sortie, erreur);
        fichiers.epargner(scene, "la sortie est la scène elle-même : " + Texte.echappe(scene.toString()));
        if (fichiers.png != null && fichiers.pfm != null && fichiers.png.vise(fichiers.pfm.getCible())) {
            throw new Echec(CodeSortie.DEMANDE, "--image et --lineaire écrivent le même fichier : "
                    + Texte.echappe(options.image) + " ; attendu : deux fichiers");
        }
        return fichiers;
    }

    /** @throws Echec si l'image des différences ne pourra être écrite, ou écraserait une des images comparées */
    public static VersFichiers pourComparer(Options options, PrintStream sortie, PrintStream erreur) {
        VersFichiers fichiers = new VersFichiers(options, sortie, erreur);
        String faute = "la sortie est une des images comparées : " + Texte.echappe(String.valueOf(options.image));
        fichiers.epargner(Paths.get(options.comparer), faute);
        fichiers.epargner(Paths.get(options.scene), faute);
        return fichiers;
    }

    private void epargner(Path fichier, String faute) {
        for (Ecriture ecriture : new Ecriture[] {png, pfm}) {
            if (ecriture != null) {
                ecriture.epargner(fichier, faute);
            }
        }
    }

    /** Une image qui garde ce que les fichiers demandent, et rien de plus. */
    public ImageMemoire creerImage() {
        return new ImageMemoire(options.largeur, options.hauteur, png != null, pfm != null);
    }

    /**
     * Dessine autant de fois que demandé, écrit les fichiers, et répond aux demandes de nombres.
     *
     * @param prepare la scène, prête à être dessinée
     * @param libres les variantes que {@code --auto} peut régler
     * @param toile ce qui dessine dans {@code image}
     * @return ce qui a dessiné : {@code prepare}, ou ce qu'a choisi {@code --auto}
     */
    public Lancer dessiner(Lancer prepare, List<Variante> libres, Toile toile, ImageMemoire image, long lectureNs,
            long preparationNs) {
        Auto auto = options.auto ? Auto.choisir(prepare, souhait(), options.fils, libres, enCours -> { }) : null;
        Lancer lancer = auto == null ? prepare : auto.getLancer();
        long[] traces = auto == null ? tracer(lancer, toile, options.reflets)
                : tracer(lancer, auto.surveiller(toile, auto.getChoisi()), auto.getChoisi().reflets);
        if (auto != null) {
            auto.controler();
        }
        if (png != null) {
            png.ecrire(image, new FichierPng());
        }
        if (pfm != null) {
            pfm.ecrire(image, new FichierPfm());
        }
        if (options.statistiques) {
            Object nombres = new Statistiques(lancer.getCompteurs(), lectureNs, preparationNs, traces);
            Pannes.repondre(auto == null ? nombres.toString()
                    : nombres + System.lineSeparator() + auto.getStatistiques(), sortie);
        }
        if (auto != null) {
            Pannes.avertir(auto.getLignes(), erreur);
        }
        return lancer;
    }

    private Souhait souhait() {
        Souhait voulu = options.erreurVoulue > 0 ? Souhait.erreur(options.erreurVoulue)
                : Souhait.temps(options.tempsVoulu);
        return voulu.fixer(options.refletsDonnes ? options.reflets : null, options.seuilDonne ? options.seuil : null);
    }

    /** @return le temps de chaque dessin, en nanosecondes */
    private long[] tracer(Lancer lancer, Toile toile, int reflets) {
        long[] traces = new long[options.repeter];
        // une classe : la première lambda d'un programme coûte cher à son démarrage
        DoubleSupplier avancement = new DoubleSupplier() {
            @Override
            public double getAsDouble() {
                return lancer.getAvancement();
            }
        };
        BarreProgression barre = new BarreProgression(avancement, erreur);
        barre.commencer();
        try {
            for (int k = 0; k < traces.length; k++) {
                long debut = System.nanoTime();
                lancer.TracerPixels(toile, reflets, options.fils);
                traces[k] = System.nanoTime() - debut;
            }
        } finally {
            barre.finir();
        }
        return traces;
    }

    /** Compare, et écrit l'image des différences si elle est demandée. @return le statut de sortie */
    public int comparer(ImageMemoire image, ImageMemoire attendue) {
        Comparaison comparaison = Comparaison.de(image, attendue, options.tolerance);
        if (png != null) {
            png.ecrire(comparaison.getDifferences(), new FichierPng());
        }
        Pannes.repondre(comparaison.toString(), sortie);
        return comparaison.sontPareilles() ? CodeSortie.FAIT : CodeSortie.PANNE;
    }
}
