package lancer.dessin;

import java.io.PrintStream;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import lancer.Lancer;
import lancer.Scene;
import lancer.auto.Auto;
import lancer.auto.Echelle;
import lancer.auto.Mesure;
import lancer.commande.BarreProgression;
import lancer.commande.Echec;
import lancer.commande.Messages;
import lancer.commande.Options;
import lancer.contrat.PixelFautif;
import lancer.contrat.Toile;
import lancer.image.Comparaison;
import lancer.image.Ecriture;
import lancer.image.FichierPfm;
import lancer.image.FichierPng;
import lancer.image.ImageMemoire;
import lancer.image.LectureImage;
import lancer.inspection.FaussesCouleurs;
import lancer.inspection.Inspection;
import lancer.inspection.Recit;
import lancer.scene.LecteurScene;

/** Écrit une image, explique un pixel ou compare deux images. Les fichiers sont vérifiés avant le dessin. */
public final class SansFenetre {

    private static final double NS_PAR_S = 1e9;

    private final Options options;
    private final Function<ImageMemoire, Toile> surface;
    private final PrintStream sortie;
    private final PrintStream erreur;
    /** Ce qui est demandé ; {@code null} avant la lecture de la scène. */
    private Demande demande;

    /** @param surface la toile qui dessine dans une image */
    public SansFenetre(Options options, Function<ImageMemoire, Toile> surface, PrintStream sortie,
            PrintStream erreur) {
        this.options = options;
        this.surface = surface;
        this.sortie = sortie;
        this.erreur = erreur;
    }

    /** Exécute la demande de ces options. @return le statut de sortie : 1 si les images comparées diffèrent */
    public int faire() {
        try {
            if (options.comparer != null) {
                return comparer();
            }
            if (options.unPixel()) {
                expliquerUnPixel();
            } else {
                dessinerDansDesFichiers();
            }
            return 0;
        } catch (PixelFautif e) {
            throw demande.nommer(e);
        }
    }

    private void lire() {
        demande = new Demande(Lecture.lire(options.scene, part -> { }), options);
    }

    private void dessinerDansDesFichiers() {
        List<Ecriture<ImageMemoire>> fichiers = fichiers();
        lire();
        Dessin dessin = new Dessin(demande, new ImageMemoire(options.largeur, options.hauteur, options.image != null,
                options.lineaire != null || options.auto()));
        if (options.auto()) {
            choisirEtDessiner(dessin, fichiers);
        } else {
            long[] traces = options.vue != null ? tracerLaVue(dessin)
                    : tracer(dessin, dessin.lancer, surface.apply(dessin.image), demande.reglages.getProfondeur());
            Ecriture.ecrire(dessin.image, fichiers);
            if (options.statistiques) {
                Messages.repondre(dessin.statistiques(dessin.lancer, traces), sortie);
            }
        }
        // les avertissements n'ont de sens que si le reste a réussi
        Messages.avertir(demande.lecture.lue.avertissements, erreur);
        dessin.direEcart(erreur);
    }

    /**
     * Les fichiers demandés.
     *
     * @throws Echec si l'un ne peut être écrit, ou écraserait un fichier lu ou l'autre
     */
    private List<Ecriture<ImageMemoire>> fichiers() {
        List<Ecriture<ImageMemoire>> fichiers = new ArrayList<>();
        boolean deuxImages = options.comparer != null && Options.estImage(options.scene);
        Path scene = deuxImages ? Paths.get(options.scene) : LecteurScene.trouver(options.scene);
        if (options.image != null) {
            fichiers.add(new Ecriture<>(options.image, new FichierPng()));
        }
        if (options.lineaire != null) {
            fichiers.add(new Ecriture<>(options.lineaire, new FichierPfm()));
        }
        for (Ecriture<ImageMemoire> fichier : fichiers) {
            fichier.distinguer(scene, deuxImages ? "une des images comparées" : "la scène elle-même");
            if (options.comparer != null) {
                fichier.distinguer(Paths.get(options.comparer), "une des images comparées");
            }
            if (fichier != fichiers.get(0)) {
                fichier.distinguer(fichiers.get(0).cible, "celle de --image et de --lineaire");
            }
        }
        return fichiers;
    }

    /** Dessine {@code --repeter} fois. @return le temps de chaque dessin, en nanosecondes */
    private long[] tracer(Dessin dessin, Lancer lancer, Toile toile, int profondeur) {
        long[] traces = new long[options.repeter];
        BarreProgression barre = !BarreProgression.surUnTerminal() ? null
                : new BarreProgression(lancer.getAtelier()::getAvancement, erreur);
        try {
            for (int k = 0; k < traces.length; k++) {
                lancer.TracerPixels(toile, profondeur, options.fils);
                traces[k] = lancer.getAtelier().getDureeNs();
            }
        } finally {
            if (barre != null) {
                barre.finir();
            }
        }
        return traces;
    }

    private long[] tracerLaVue(Dessin dessin) {
        new FaussesCouleurs(dessin.lancer, demande.reglages.getProfondeur(), options.fils)
                .dessiner(options.vue, dessin.image);
        return new long[] {dessin.lancer.getAtelier().getDureeNs()};
    }

    /** Dessine avec les réglages que {@code --auto} choisit, et dit en deux lignes lesquels, et l'erreur de l'image. */
    private void choisirEtDessiner(Dessin dessin, List<Ecriture<ImageMemoire>> fichiers) {
        long debut = System.nanoTime();
        Auto auto = new Auto(dessin.lancer, Echelle.de(demande.reglages, options.estDonnee("--reflets"),
                options.estDonnee("--seuil")), options.erreurVoulue, options.fils);
        long[] traces;
        do {
            traces = tracer(dessin, auto.getLancer(), surface.apply(dessin.image), auto.getChoisi().getProfondeur());
        } while (!auto.controler(dessin.image::getCouleur));
        double essais = (System.nanoTime() - debut - Arrays.stream(traces).sum()) / NS_PAR_S;
        Ecriture.ecrire(dessin.image, fichiers);
        Mesure mesure = auto.getMesure();
        if (options.statistiques) {
            String incertitude = mesure.rienVu ? ""
                    : String.format(Locale.ROOT, "auto.erreur.incertitude: %.2f%n", mesure.incertitude);
            Messages.repondre(dessin.statistiques(auto.getLancer(), traces) + System.lineSeparator()
                    + String.format(Locale.ROOT, "auto.erreur.mesuree: %.2f%n%s"
                    + "auto.rayons.essais: %d%nauto.essais.ms: %.3f", mesure.erreur, incertitude,
                    auto.getRayonsDesEssais(), 1e3 * essais), sortie);
        }
        Messages.avertir(Arrays.asList("auto, choisi : " + Echelle.dire(auto.getChoisi()),
                String.format(Locale.ROOT, "auto, mesuré : %s ; dessin en %.3f s, essais en %.3f s%s", mesure.enMots(),
                        auto.getLancer().getAtelier().getDureeNs() / NS_PAR_S, essais,
                        mesure.rienVu ? "" : " ; " + auto.getVerdict())), erreur);
    }

    private void expliquerUnPixel() {
        lire();
        Scene scene = demande.getScene();
        Inspection pixel = new Inspection(scene, demande.lecture.lue::getOrigine,
                scene.getCamera(options.largeur, options.hauteur), demande.reglages.getProfondeur(),
                options.pixelX, options.pixelY);
        pixel.faire();
        Messages.repondreEnUtf8(new Recit(pixel, Double::toString, Double::toString).raconter().lignes(), sortie);
        Messages.avertir(demande.lecture.lue.avertissements, erreur);
    }

    /** Compare deux images, et écrit celle des différences si elle est demandée. */
    private int comparer() {
        ImageMemoire attendue = LectureImage.lire(options.comparer);
        ImageMemoire autre = Options.estImage(options.scene) ? LectureImage.lire(options.scene) : null;
        List<Ecriture<ImageMemoire>> fichiers = fichiers();
        if (autre == null) {
            lire();
            demande = demande.avecTaille(attendue.largeur, attendue.hauteur);
            autre = new ImageMemoire(attendue.largeur, attendue.hauteur, true);
            Dessin dessin = new Dessin(demande, autre);
            tracer(dessin, dessin.lancer, surface.apply(autre), demande.reglages.getProfondeur());
            dessin.direEcart(erreur);
        }
        Comparaison comparaison = new Comparaison(autre, attendue, options.tolerance, options.part);
        if (!fichiers.isEmpty()) {
            Ecriture.ecrire(comparaison.peindreLesEcarts(new ImageMemoire(attendue.largeur, attendue.hauteur, false)),
                    fichiers);
        }
        Messages.repondre(comparaison.toString(), sortie);
        return comparaison.sontPareilles() ? 0 : 1;
    }
}
