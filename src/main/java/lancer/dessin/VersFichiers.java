package lancer.dessin;

import java.io.PrintStream;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.DoubleSupplier;
import lancer.auto.Auto;
import lancer.auto.Souhait;
import lancer.commande.BarreProgression;
import lancer.commande.Echec;
import lancer.commande.Options;
import lancer.commande.Pannes;
import lancer.contrat.Toile;
import lancer.fils.Traceur;
import lancer.image.Comparaison;
import lancer.image.Ecriture;
import lancer.image.FichierPfm;
import lancer.image.FichierPng;
import lancer.image.ImageMemoire;
import lancer.scene.FichierScene;
import lancer.texte.Texte;

/** Le travail sans fenêtre : les fichiers demandés, vérifiés avant de dessiner, et ce qu'il y a à dire du dessin. */
public final class VersFichiers {

    private final Options options;
    private final PrintStream sortie;
    private final PrintStream erreur;
    private final Ecriture png;
    private final Ecriture pfm;

    /** @throws Echec si un fichier ne pourra être écrit, ou écraserait un de ceux qui sont lus, ou l'autre sortie */
    public VersFichiers(Options options, PrintStream sortie, PrintStream erreur) {
        this.options = options;
        this.sortie = sortie;
        this.erreur = erreur;
        boolean deuxImages = options.comparer != null && Options.estImage(options.scene);
        Path scene = deuxImages ? Paths.get(options.scene) : FichierScene.trouver(options.scene);
        png = options.image == null ? null : new Ecriture(options.image);
        pfm = options.lineaire == null ? null : new Ecriture(options.lineaire);
        epargner(scene, deuxImages ? "une des images comparées" : "la scène elle-même");
        if (options.comparer != null) {
            epargner(Paths.get(options.comparer), "une des images comparées");
        }
        if (png != null && pfm != null) {
            png.epargner(pfm.getCible(), "--image et --lineaire écrivent le même fichier : "
                    + Texte.echappe(options.image) + " ; attendu : deux fichiers");
        }
    }

    private void epargner(Path fichier, String quoi) {
        for (Ecriture ecriture : new Ecriture[] {png, pfm}) {
            if (ecriture != null) {
                ecriture.epargner(fichier, "la sortie est " + quoi + " : " + Texte.echappe(fichier.toString())
                        + " ; attendu : un autre fichier");
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
     * @return ce qui a dessiné : {@code prepare}, ou ce qu'a choisi {@code --auto}
     */
    public Traceur dessiner(Dessinateur dessinateur, Traceur prepare) {
        Auto auto = options.auto ? Auto.choisir(prepare, souhait(), options.fils,
                dessinateur.getReglages().getVariantesLibres(), enCours -> { }) : null;
        Traceur lancer = auto == null ? prepare : auto.getTraceur();
        long[] traces = auto == null ? tracer(lancer, dessinateur.programme, options.reflets)
                : tracer(lancer, auto.surveiller(dessinateur.programme, auto.getChoisi()), auto.getChoisi().reflets);
        if (auto != null) {
            auto.controler();
        }
        Map<Ecriture, Ecriture.Format> fichiers = new LinkedHashMap<>();
        if (png != null) {
            fichiers.put(png, new FichierPng());
        }
        if (pfm != null) {
            fichiers.put(pfm, new FichierPfm());
        }
        Ecriture.ecrire(dessinateur.getImage(), fichiers);
        if (options.statistiques) {
            String nombres = dessinateur.statistiques(lancer, traces);
            Pannes.repondre(auto == null ? nombres
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
    private long[] tracer(Traceur lancer, Toile toile, int reflets) {
        long[] traces = new long[options.repeter];
        // une classe : la première lambda d'un programme coûte cher à son démarrage
        BarreProgression barre = BarreProgression.commencer(new DoubleSupplier() {
            @Override
            public double getAsDouble() {
                return lancer.getAvancement();
            }
        }, erreur);
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
        Comparaison comparaison = Comparaison.de(image, attendue, options.tolerance, options.part);
        if (png != null) {
            png.ecrire(comparaison.getDifferences(), new FichierPng());
        }
        Pannes.repondre(comparaison.toString(), sortie);
        return comparaison.sontPareilles() ? 0 : 1;
    }
}
