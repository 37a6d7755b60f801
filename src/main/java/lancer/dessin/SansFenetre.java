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
        if (options.estDonnee(Option.PIXEL)) {
            expliquerUnPixel();
            return 0;
        }
        List<Ecriture<ImageMemoire>> fichiers = fichiers();
        ImageMemoire reference =
                options.estDonnee(Option.COMPARER) ? LectureImage.lire(options.get(Option.COMPARER)) : null;
        if (compareDeuxFichiers()) {
            return comparer(LectureImage.lire(options.scene), reference, fichiers);
        }
        Demande demande = reference == null ? lire() : lire().avecTaille(reference.largeur, reference.hauteur);
        Dessin dessin;
        try (BarreProgression barre = new BarreProgression(erreur)) {
            dessin = programme.dessiner(demande, commence -> barre.suivre(commence::getAvancement));
        }
        if (reference != null) {
            Rapport.dire(dessin, sortie, erreur);
            return comparer(dessin.image, reference, fichiers);
        }
        Ecriture.ecrire(dessin.image, fichiers);
        Rapport.dire(dessin, sortie, erreur);
        avertir(demande);
        return 0;
    }

    private Demande lire() {
        return new Demande(LecteurScene.lire(options.scene, part -> { }), options);
    }

    /** Dit ce que la lecture de la scène a ignoré, ce qui n'a de sens que si le reste a réussi. */
    private void avertir(Demande demande) {
        demande.lue.avertissements.forEach(ligne -> Messages.avertir(ligne, erreur));
    }

    /** Les fichiers demandés. @throws lancer.systeme.Echec si l'un d'eux ne peut être écrit */
    private List<Ecriture<ImageMemoire>> fichiers() {
        List<Ecriture<ImageMemoire>> fichiers = new ArrayList<>();
        Map<String, String> proteges = new LinkedHashMap<>();
        if (options.estDonnee(Option.COMPARER)) {
            proteges.put(options.get(Option.COMPARER), UNE_IMAGE);
        }
        if (compareDeuxFichiers()) {
            proteges.put(options.scene, UNE_IMAGE);
        } else {
            proteges.put(LecteurScene.trouver(options.scene).toString(), "la scène elle-même");
        }
        ajouter(fichiers, Option.IMAGE, new FichierPng(), proteges);
        ajouter(fichiers, Option.LINEAIRE, new FichierPfm(), proteges);
        return fichiers;
    }

    /** @throws lancer.systeme.Echec si ce fichier ne peut être écrit, ou écraserait un de ceux qui sont protégés */
    private void ajouter(List<Ecriture<ImageMemoire>> fichiers, Option<String> option,
            Ecriture.Format<ImageMemoire> format, Map<String, String> proteges) {
        if (options.estDonnee(option)) {
            Ecriture<ImageMemoire> fichier = new Ecriture<>(options.get(option), format);
            for (Map.Entry<String, String> protege : proteges.entrySet()) {
                fichier.distinguer(protege.getKey(), protege.getValue());
            }
            proteges.put(fichier.cible.toString(), "celle de --image et de --lineaire");
            fichiers.add(fichier);
        }
    }

    private void expliquerUnPixel() {
        Demande demande = lire();
        Scene scene = demande.getScene();
        Couple place = options.get(Option.PIXEL);
        Inspection pixel = new Inspection(scene, demande.lue::getOrigine,
                scene.getCamera(demande.largeur, demande.hauteur), demande.reglages.getProfondeur(), place.x,
                place.y);
        pixel.faire(() -> Dessin.preparer(demande).seRegardeDeuxFois());
        if (pixel.getFaute() != null) {
            throw demande.nommer(pixel.getFaute());
        }
        List<String> lignes = new Recit(pixel, Double::toString, Double::toString).raconter().lignes();
        Messages.repondre(Console.recit(String.join(System.lineSeparator(), lignes)), Console.pourUnRecit(sortie));
        avertir(demande);
    }

    /** Compare ces images, et écrit celle de leurs différences si elle est demandée. @return 1 si elles diffèrent */
    private int comparer(ImageMemoire image, ImageMemoire reference, List<Ecriture<ImageMemoire>> fichiers) {
        Comparaison comparaison = new Comparaison(image, reference, options.get(Option.TOLERANCE),
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
