package lancer.dessin;

import java.io.PrintStream;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.DoubleSupplier;
import lancer.auto.Auto;
import lancer.auto.Candidat;
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

    private static final double NS_PAR_S = 1e9;

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
        long debut = System.nanoTime();
        Auto auto = options.auto ? Auto.choisir(prepare, options.erreurVoulue,
                options.refletsDonnes ? options.reflets : null, options.seuilDonne ? options.seuil : null,
                options.fils, dessinateur.getReglages().getVariantesLibres(), enCours -> { }) : null;
        Traceur lancer = auto == null ? prepare : auto.getTraceur();
        Toile toile = auto == null ? dessinateur.programme : auto.surveiller(dessinateur.programme);
        double essais = (System.nanoTime() - debut) / NS_PAR_S;
        long[] traces = tracer(lancer, toile, auto == null ? options.reflets : auto.getChoisi().reflets);
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
            Pannes.repondre(auto == null ? nombres : nombres + System.lineSeparator() + texte("auto.erreur.attendue: "
                    + "%.2f%nauto.erreur.mesuree: %.2f%nauto.essais.rayons: %d%nauto.essais.ms: %.3f",
                    auto.getChoisi().erreur, auto.getErreurMesuree(), auto.getRayonsDesEssais(), 1e3 * essais), sortie);
        }
        if (auto != null) {
            Pannes.avertir(rapport(auto, essais), erreur);
        }
        return lancer;
    }

    /** Trois lignes : ce que {@code --auto} a choisi, ce qui en était attendu, et ce qu'il en est. */
    private List<String> rapport(Auto auto, double essais) {
        Candidat choisi = auto.getChoisi();
        int nombre = auto.getEssayes().size();
        return Arrays.asList("auto, choisi : " + choisi,
                texte("auto, attendu : erreur de %.2f, au plus %.2f ; %.2f rayons de toutes sortes par pixel ; "
                        + "%d réglage%s, %s une erreur de %.2f", choisi.erreur, choisi.auPlus, choisi.prix, nombre,
                        nombre > 1 ? "s essayés" : " essayé", choisi.auPlus <= options.erreurVoulue
                        ? "le moins cher qui promette" : "aucun ne promet", options.erreurVoulue),
                texte("auto, mesuré : erreur de %.2f ± %.2f ; dessin en %.3f s, essais en %.3f s ; %s",
                        auto.getErreurMesuree(), auto.getIncertitude(), auto.getTraceur().getDureeNs() / NS_PAR_S,
                        essais, auto.getVerdict()));
    }

    /** Toujours avec un point, quelle que soit la langue. */
    private static String texte(String format, Object... valeurs) {
        return String.format(Locale.ROOT, format, valeurs);
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
