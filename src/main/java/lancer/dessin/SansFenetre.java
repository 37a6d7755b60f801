package lancer.dessin;

import java.util.List;
import lancer.Camera;
import lancer.commande.Options;
import lancer.commande.Pannes;
import lancer.fils.Traceur;
import lancer.image.ImageMemoire;
import lancer.image.LectureImage;
import lancer.inspection.Inspection;
import lancer.inspection.Recit;

/** Travail sans fenêtre : une image dans un fichier, un pixel expliqué, une comparaison. */
public final class SansFenetre {

    private final Dessinateur dessinateur;
    private final Options options;

    private SansFenetre(Dessinateur dessinateur) {
        this.dessinateur = dessinateur;
        options = dessinateur.options;
    }

    /** Fait ce que demandent ses options. @return le statut de sortie ; que des images diffèrent n'est pas une panne */
    public static int faire(Dessinateur dessinateur) {
        SansFenetre travail = new SansFenetre(dessinateur);
        if (travail.options.comparer != null) {
            return travail.comparer();
        }
        if (travail.options.pixel) {
            travail.dessinerUnPixel();
        } else {
            travail.versFichiers();
        }
        return 0;
    }

    private void versFichiers() {
        VersFichiers fichiers = new VersFichiers(options, dessinateur.sortie, dessinateur.erreur);
        List<String> avertissements = dessinateur.lireScene(options.scene);
        Traceur dessine = fichiers.dessiner(dessinateur, dessinateur.preparer(fichiers.creerImage()));
        // en dernier : si quelque chose a échoué, c'est la seule ligne à lire
        Pannes.avertir(avertissements, dessinateur.erreur);
        dessinateur.direEcart(dessine);
    }

    private void dessinerUnPixel() {
        List<String> avertissements = dessinateur.lireScene(options.scene);
        Camera camera = new Camera(options.largeur, options.hauteur);
        Inspection pixel = new Inspection(dessinateur.programme.getScene(), dessinateur.getOrigines(), camera,
                options.reflets, options.pixelX, options.pixelY);
        pixel.faire();
        Pannes.repondreEnUtf8(new Recit(pixel, Double::toString).lignes(), dessinateur.sortie);
        Pannes.avertir(avertissements, dessinateur.erreur);
    }

    private int comparer() {
        ImageMemoire attendue = LectureImage.lire(options.comparer);
        ImageMemoire autre = Options.estImage(options.scene) ? LectureImage.lire(options.scene) : null;
        VersFichiers fichiers = new VersFichiers(options, dessinateur.sortie, dessinateur.erreur);
        if (autre == null) {
            dessinateur.lireScene(options.scene);
            autre = new ImageMemoire(attendue.getLargeur(), attendue.getHauteur(), true);
            dessinateur.preparer(autre).TracerPixels(dessinateur.programme, options.reflets, options.fils);
        }
        return fichiers.comparer(autre, attendue);
    }
}
