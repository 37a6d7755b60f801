package lancer.dessin;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lancer.Scene;
import lancer.commande.BarreProgression;
import lancer.commande.Couple;
import lancer.commande.Messages;
import lancer.commande.Option;
import lancer.commande.Reglages;
import lancer.image.Comparaison;
import lancer.image.FichierPfm;
import lancer.image.FichierPng;
import lancer.image.ImageMemoire;
import lancer.image.LectureImage;
import lancer.inspection.Inspection;
import lancer.inspection.Recit;
import lancer.scene.LecteurScene;
import lancer.systeme.Console;
import lancer.systeme.Ecriture;

/** Écrit une image, explique un pixel ou compare deux images. Les fichiers sont vérifiés avant le dessin. */
public final class SansFenetre {

    private static final String UNE_IMAGE = "une des images comparées";

    private final Reglages options;
    private final Programme programme;
    private final PrintStream sortie;
    private final PrintStream erreur;

    public SansFenetre(Reglages options, Programme programme, PrintStream sortie, PrintStream erreur) {
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
        dessin.demande.lue.avertissements.forEach(ligne -> Messages.avertir(ligne, erreur));
    }

    private Dessin dessiner(Demande demande) {
        try (BarreProgression barre = new BarreProgression(erreur)) {
            return programme.dessiner(demande, dessin -> barre.suivre(dessin::getAvancement));
        }
    }

    /** Les fichiers demandés. @throws lancer.systeme.Echec si l'un d'eux ne peut être écrit */
    private List<Ecriture<ImageMemoire>> fichiers() {
        List<Ecriture<ImageMemoire>> fichiers = new ArrayList<>();
        Map<String, String> pris = new LinkedHashMap<>();
        if (options.estDonnee(Option.COMPARER)) {
            pris.put(options.get(Option.COMPARER), UNE_IMAGE);
        }
        if (compareDeuxFichiers()) {
            pris.put(options.scene, UNE_IMAGE);
        } else {
            pris.put(LecteurScene.trouver(options.scene).toString(), "la scène elle-même");
        }
        ajouter(fichiers, Option.IMAGE, new FichierPng(), pris);
        ajouter(fichiers, Option.LINEAIRE, new FichierPfm(), pris);
        return fichiers;
    }

    /** @throws lancer.systeme.Echec si ce fichier ne peut être écrit, ou écraserait un de ceux qui sont pris */
    private void ajouter(List<Ecriture<ImageMemoire>> fichiers, Option<String> option,
            Ecriture.Format<ImageMemoire> format, Map<String, String> pris) {
        if (options.estDonnee(option)) {
            Ecriture<ImageMemoire> fichier = new Ecriture<>(options.get(option), format);
            for (Map.Entry<String, String> autre : pris.entrySet()) {
                fichier.distinguer(autre.getKey(), autre.getValue());
            }
            pris.put(fichier.cible.toString(), "celle de --image et de --lineaire");
            fichiers.add(fichier);
        }
    }

    private void expliquerUnPixel() {
        Demande demande = lire();
        Scene scene = demande.getScene();
        Couple ou = options.get(Option.PIXEL);
        Inspection pixel = new Inspection(scene, demande.lue::getOrigine,
                scene.getCamera(demande.largeur, demande.hauteur), demande.reglages.getProfondeur(), ou.x, ou.y);
        pixel.faire(() -> new Dessin(demande).seRegardeDeuxFois());
        if (pixel.getFaute() != null) {
            throw demande.nommer(pixel.getFaute());
        }
        List<String> lignes = new Recit(pixel, Double::toString, Double::toString).raconter().lignes();
        Messages.repondre(Console.recit(String.join(System.lineSeparator(), lignes)), Console.pourUnRecit(sortie));
        demande.lue.avertissements.forEach(ligne -> Messages.avertir(ligne, erreur));
    }

    /** Compare deux images, et écrit celle des différences si elle est demandée. */
    private int comparer() {
        List<Ecriture<ImageMemoire>> fichiers = fichiers();
        ImageMemoire attendue = LectureImage.lire(options.get(Option.COMPARER));
        ImageMemoire autre = compareDeuxFichiers() ? LectureImage.lire(options.scene)
                : dessiner(lire().avecTaille(attendue.largeur, attendue.hauteur)).rapporter(sortie, erreur).image;
        Comparaison comparaison = new Comparaison(autre, attendue, options.get(Option.TOLERANCE),
                options.get(Option.PART));
        if (!fichiers.isEmpty()) {
            Ecriture.ecrire(comparaison.peindreLesEcarts(), fichiers);
        }
        Messages.repondre(comparaison.toString(), sortie);
        return comparaison.sontPareilles() ? 0 : 1;
    }

    /** Dit si la seconde image comparée est un fichier, et non une scène à dessiner. */
    private boolean compareDeuxFichiers() {
        return options.estDonnee(Option.COMPARER) && Option.COMPARER.accepte(options.scene);
    }
}
