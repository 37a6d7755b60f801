package lancer.dessin;

import java.io.PrintStream;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import lancer.Scene;
import lancer.commande.BarreProgression;
import lancer.commande.Messages;
import lancer.commande.Option;
import lancer.commande.Options;
import lancer.contrat.PixelFautif;
import lancer.image.Comparaison;
import lancer.image.Ecriture;
import lancer.image.FichierPfm;
import lancer.image.FichierPng;
import lancer.image.ImageMemoire;
import lancer.image.LectureImage;
import lancer.inspection.Inspection;
import lancer.inspection.Recit;
import lancer.scene.LecteurScene;

/** Écrit une image, explique un pixel ou compare deux images. Les fichiers sont vérifiés avant le dessin. */
public final class SansFenetre {

    private final Options options;
    private final Programme programme;
    private final PrintStream sortie;
    private final PrintStream erreur;
    private BarreProgression barre;

    public SansFenetre(Options options, Programme programme, PrintStream sortie, PrintStream erreur) {
        this.options = options;
        this.programme = programme;
        this.sortie = sortie;
        this.erreur = erreur;
    }

    /** Exécute la demande de ces options. @return le statut de sortie : 1 si les images comparées diffèrent */
    public int faire() {
        if (options.estDonnee(Option.COMPARER)) {
            return comparer();
        }
        if (options.estDonnee(Option.PIXEL)) {
            expliquerUnPixel();
        } else {
            dessinerDansDesFichiers();
        }
        return 0;
    }

    private Demande lire() {
        return new Demande(programme.lire(options.scene, part -> { }), options);
    }

    private void dessinerDansDesFichiers() {
        List<Ecriture<ImageMemoire>> fichiers = fichiers();
        Dessin dessin = dessiner(lire());
        Ecriture.ecrire(dessin.image, fichiers);
        dessin.rapporter(sortie, erreur);
        // les avertissements n'ont de sens que si le reste a réussi
        Messages.avertir(dessin.demande.lue.avertissements, erreur);
    }

    private Dessin dessiner(Demande demande) {
        try {
            return programme.dessiner(demande, this::montrerLAvancement);
        } finally {
            if (barre != null) {
                barre.finir();
            }
        }
    }

    private void montrerLAvancement(Dessin dessin) {
        if (BarreProgression.surUnTerminal()) {
            barre = new BarreProgression(dessin::getAvancement, erreur);
        }
    }

    /**
     * Les fichiers demandés.
     *
     * @throws lancer.commande.Echec si l'un ne peut être écrit, ou écraserait un fichier lu ou l'autre
     */
    private List<Ecriture<ImageMemoire>> fichiers() {
        List<Ecriture<ImageMemoire>> fichiers = new ArrayList<>();
        boolean deuxImages = options.estDonnee(Option.COMPARER) && estImage(options.scene);
        Path scene = deuxImages ? Paths.get(options.scene) : LecteurScene.trouver(options.scene);
        if (options.estDonnee(Option.IMAGE)) {
            fichiers.add(new Ecriture<>(options.get(Option.IMAGE), new FichierPng()));
        }
        if (options.estDonnee(Option.LINEAIRE)) {
            fichiers.add(new Ecriture<>(options.get(Option.LINEAIRE), new FichierPfm()));
        }
        for (Ecriture<ImageMemoire> fichier : fichiers) {
            fichier.distinguer(scene, deuxImages ? "une des images comparées" : "la scène elle-même");
            if (options.estDonnee(Option.COMPARER)) {
                fichier.distinguer(Paths.get(options.get(Option.COMPARER)), "une des images comparées");
            }
            if (fichier != fichiers.get(0)) {
                fichier.distinguer(fichiers.get(0).cible, "celle de --image et de --lineaire");
            }
        }
        return fichiers;
    }

    private void expliquerUnPixel() {
        Demande demande = lire();
        Scene scene = demande.getScene();
        Option.Couple ou = options.get(Option.PIXEL);
        Inspection pixel = new Inspection(scene, demande.lue::getOrigine,
                scene.getCamera(demande.largeur, demande.hauteur), demande.reglages.getProfondeur(), ou.x, ou.y);
        try {
            pixel.faire();
        } catch (PixelFautif e) {
            throw demande.nommer(e);
        }
        Messages.repondreEnUtf8(new Recit(pixel, Double::toString, Double::toString).raconter().lignes(), sortie);
        Messages.avertir(demande.lue.avertissements, erreur);
    }

    /** Compare deux images, et écrit celle des différences si elle est demandée. */
    private int comparer() {
        ImageMemoire attendue = LectureImage.lire(options.get(Option.COMPARER));
        ImageMemoire autre = estImage(options.scene) ? LectureImage.lire(options.scene) : null;
        List<Ecriture<ImageMemoire>> fichiers = fichiers();
        if (autre == null) {
            autre = dessiner(lire().avecTaille(attendue.largeur, attendue.hauteur)).rapporter(sortie, erreur).image;
        }
        Comparaison comparaison = new Comparaison(autre, attendue, options.get(Option.TOLERANCE),
                options.get(Option.PART));
        if (!fichiers.isEmpty()) {
            Ecriture.ecrire(comparaison.peindreLesEcarts(new ImageMemoire(attendue.largeur, attendue.hauteur, false)),
                    fichiers);
        }
        Messages.repondre(comparaison.toString(), sortie);
        return comparaison.sontPareilles() ? 0 : 1;
    }

    /** Dit si ce nom est celui d'une image à comparer, et non d'une scène. */
    private static boolean estImage(String nom) {
        return Option.COMPARER.accepte(nom);
    }
}
