package lancer.dessin;

import java.io.PrintStream;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import lancer.Camera;
import lancer.Lancer;
import lancer.auto.Auto;
import lancer.auto.Echelon;
import lancer.auto.Mesure;
import lancer.commande.BarreProgression;
import lancer.commande.Echec;
import lancer.commande.Etape;
import lancer.commande.Messages;
import lancer.commande.Options;
import lancer.contrat.PixelFautif;
import lancer.contrat.Toile;
import lancer.fils.Fil;
import lancer.image.Comparaison;
import lancer.image.Ecriture;
import lancer.image.FichierPfm;
import lancer.image.FichierPng;
import lancer.image.ImageMemoire;
import lancer.image.LectureImage;
import lancer.inspection.FaussesCouleurs;
import lancer.inspection.Inspection;
import lancer.inspection.Recit;
import lancer.scene.FichierScene;
import lancer.texte.Texte;

/** Écrit une image, explique un pixel ou compare deux images. Les fichiers sont vérifiés avant le dessin. */
public final class SansFenetre implements Runnable {

    private static final double NS_PAR_S = 1e9;

    private final Options options;
    private final Dessin dessin;
    private final Toile toile;
    private final PrintStream sortie;
    private final PrintStream erreur;
    private int statut;

    private SansFenetre(Options options, Dessin dessin, Toile toile, PrintStream sortie, PrintStream erreur) {
        this.options = options;
        this.dessin = dessin;
        this.toile = toile;
        this.sortie = sortie;
        this.erreur = erreur;
    }

    /**
     * Exécute la demande de ces options.
     *
     * @param dessin le dessin demandé, dont la scène n'est pas encore lue
     * @param toile surface dont les pixels sont ceux de l'image du dessin
     * @return le statut de sortie : 1 si les images comparées diffèrent
     */
    public static int faire(Options options, Dessin dessin, Toile toile, PrintStream sortie, PrintStream erreur) {
        SansFenetre travail = new SansFenetre(options, dessin, toile, sortie, erreur);
        try {
            dessin.observer(travail);
            return travail.statut;
        } catch (PixelFautif e) {
            throw dessin.nommer(e);
        }
    }

    @Override
    public void run() {
        if (options.comparer != null) {
            comparer();
        } else if (options.pixel) {
            dessinerUnPixel();
        } else if (options.vue != null) {
            dessinerUneVue();
        } else {
            versFichiers();
        }
    }

    private void versFichiers() {
        Map<Ecriture, Ecriture.Format> fichiers = fichiers();
        dessin.lire();
        int profondeur = dessin.getReglages().getProfondeur();
        Lancer prepare = dessin.preparer(new ImageMemoire(options.largeur, options.hauteur,
                options.image != null, options.lineaire != null));
        if (options.auto) {
            choisirEtDessiner(prepare, fichiers);
        } else {
            long[] traces = tracer(prepare, toile, profondeur);
            Ecriture.ecrire(dessin.getImage(), fichiers);
            if (options.statistiques) {
                Messages.repondre(dessin.statistiques(prepare, traces), sortie);
            }
        }
        // les avertissements n'ont de sens que si le reste a réussi
        dessin.avertir();
    }

    /** Les fichiers demandés. @throws Echec si l'un ne peut être écrit, ou écraserait un fichier lu ou l'autre */
    private Map<Ecriture, Ecriture.Format> fichiers() {
        Map<Ecriture, Ecriture.Format> fichiers = new LinkedHashMap<>();
        boolean deuxImages = options.comparer != null && Options.estImage(options.scene);
        Path scene = deuxImages ? Paths.get(options.scene) : FichierScene.trouver(options.scene);
        Ecriture png = options.image == null ? null : new Ecriture(options.image);
        if (png != null) {
            fichiers.put(png, new FichierPng());
        }
        if (options.lineaire != null) {
            fichiers.put(new Ecriture(options.lineaire), new FichierPfm());
        }
        for (Ecriture fichier : fichiers.keySet()) {
            fichier.epargner(scene, deuxImages ? "une des images comparées" : "la scène elle-même");
            if (options.comparer != null) {
                fichier.epargner(Paths.get(options.comparer), "une des images comparées");
            }
            if (png != null && fichier != png) {
                png.distinguer(fichier.getCible(), "--image et --lineaire écrivent le même fichier : "
                        + Texte.echappe(options.image) + " ; attendu : deux fichiers");
            }
        }
        return fichiers;
    }

    /** Dessine {@code --repeter} fois. @return le temps de chaque dessin, en nanosecondes */
    private long[] tracer(Lancer lancer, Toile surveillee, int reflets) {
        long[] traces = new long[options.repeter];
        BarreProgression barre = !BarreProgression.surUnTerminal() ? null
                : new BarreProgression(lancer::getAvancement, erreur);
        try {
            for (int k = 0; k < traces.length; k++) {
                if (k + 1 < traces.length) {
                    lancer.TracerPixels(surveillee, reflets, options.fils);
                } else {
                    dessin.tracer(lancer, surveillee, reflets, options.fils);
                }
                traces[k] = lancer.getDureeNs();
            }
        } finally {
            if (barre != null) {
                barre.finir();
            }
        }
        return traces;
    }

    /** Dessine avec le réglage que {@code --auto} choisit, et dit en deux lignes lequel, et l'erreur de l'image. */
    private void choisirEtDessiner(Lancer prepare, Map<Ecriture, Ecriture.Format> fichiers) {
        long debut = System.nanoTime();
        ReglagesDessin reglages = dessin.getReglages();
        Auto auto = new Auto(prepare, Echelon.echelle(prepare.getScene().getModele(), reglages.getEssayees(),
                options.estDonnee("--reflets") || options.etape != Etape.REFLETS ? reglages.getProfondeur() : null,
                options.estDonnee("--seuil") ? options.seuil : null), options.erreurVoulue, options.fils);
        long[] traces;
        do {
            traces = tracer(auto.getLancer(), auto.surveiller(toile), auto.getChoisi().reflets);
        } while (!auto.controler());
        double essais = (System.nanoTime() - debut - Arrays.stream(traces).sum()) / NS_PAR_S;
        Ecriture.ecrire(dessin.getImage(), fichiers);
        Mesure mesure = auto.getMesure();
        if (options.statistiques) {
            Messages.repondre(dessin.statistiques(auto.getLancer(), traces) + System.lineSeparator()
                    + String.format(Locale.ROOT, "auto.erreur.mesuree: %.2f%nauto.erreur.incertitude: %.2f%n"
                    + "auto.rayons.essais: %d%nauto.essais.ms: %.3f", mesure.erreur, mesure.incertitude,
                    auto.getRayonsDesEssais(), 1e3 * essais), sortie);
        }
        Messages.avertir(Arrays.asList("auto, choisi : " + auto.getChoisi(),
                String.format(Locale.ROOT,
                        "auto, mesuré : erreur de %.2f ± %.2f ; dessin en %.3f s, essais en %.3f s ; %s", mesure.erreur,
                        mesure.incertitude, auto.getLancer().getDureeNs() / NS_PAR_S, essais, auto.getVerdict())),
                erreur);
    }

    private void dessinerUneVue() {
        Map<Ecriture, Ecriture.Format> fichiers = fichiers();
        dessin.lire();
        ImageMemoire image = new ImageMemoire(options.largeur, options.hauteur, false);
        Lancer prepare = dessin.preparer(image);
        Lancer lancer = new FaussesCouleurs(prepare, dessin.getReglages().getProfondeur(), options.fils, sien -> { })
                .dessiner(options.vue, image, null);
        Ecriture.ecrire(image, fichiers);
        if (options.statistiques) {
            Messages.repondre(dessin.statistiques(lancer, lancer.getDureeNs()), sortie);
        }
        dessin.avertir();
    }

    private void dessinerUnPixel() {
        dessin.lire();
        Inspection pixel = new Inspection(dessin.getScene(), dessin.getLue().origines,
                new Camera(options.largeur, options.hauteur), dessin.getReglages().getProfondeur(),
                options.pixelX, options.pixelY);
        pixel.faire();
        Fil.commencer("récit");
        Messages.repondreEnUtf8(new Recit(pixel, Double::toString, Double::toString).raconter().lignes(), sortie);
        Messages.avertir(dessin.getLue().avertissements, erreur);
    }

    /** Compare deux images, et écrit celle des différences si elle est demandée. */
    private void comparer() {
        ImageMemoire attendue = LectureImage.lire(options.comparer);
        ImageMemoire autre = Options.estImage(options.scene) ? LectureImage.lire(options.scene) : null;
        Map<Ecriture, Ecriture.Format> fichiers = fichiers();
        if (autre == null) {
            dessin.lire();
            autre = new ImageMemoire(attendue.largeur, attendue.hauteur, true);
            dessin.tracer(dessin.preparer(autre), toile, dessin.getReglages().getProfondeur(), options.fils);
            dessin.direEcart();
        }
        Comparaison comparaison = new Comparaison(autre, attendue, options.tolerance, options.part);
        if (!fichiers.isEmpty()) {
            Ecriture.ecrire(options.vue == null ? comparaison.getDifferences() : comparaison.peindreLesEcarts(
                    new ImageMemoire(attendue.largeur, attendue.hauteur, false)),
                    fichiers);
        }
        Messages.repondre(comparaison.toString(), sortie);
        statut = comparaison.sontPareilles() ? 0 : 1;
    }
}
