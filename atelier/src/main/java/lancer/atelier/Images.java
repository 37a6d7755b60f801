package lancer.atelier;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.commande.Echec;
import lancer.sortie.Comparaison;
import lancer.sortie.ImageMemoire;
import lancer.sortie.LectureImage;

/**
 * Met à jour un dossier d'images PNG : n'y remplace que celles dont un pixel a changé. Les octets d'un PNG, eux, dépendent de
 * la bibliothèque de compression de la machine.
 *
 * <pre>
 * java -cp mesures/target/mesures.jar lancer.atelier.Images target/images images
 * </pre>
 */
public final class Images {

    private Images() {
    }

    /** @param args le dossier des images neuves, et celui à mettre à jour */
    public static void main(String[] args) {
        if (args.length != 2) {
            System.err.println("Images : usage : Images DOSSIER_NEUF DOSSIER");
            System.exit(2);
        }
        try {
            for (String nom : actualiser(Paths.get(args[0]), Paths.get(args[1]))) {
                System.out.println("changée : " + nom);
            }
        } catch (IOException | Echec e) {
            System.err.println("Images : " + e.getMessage());
            System.exit(1);
        }
    }

    /** @return les noms des images remplacées ou ajoutées */
    static List<String> actualiser(Path neuves, Path dossier) throws IOException {
        Files.createDirectories(dossier);
        List<Path> changees;
        try (Stream<Path> fichiers = Files.list(neuves)) {
            changees = fichiers.filter(f -> f.toString().endsWith(".png"))
                    .filter(f -> !memesPixels(f, dossier.resolve(f.getFileName()))).sorted().collect(Collectors.toList());
        }
        for (Path changee : changees) {
            Files.copy(changee, dossier.resolve(changee.getFileName()), StandardCopyOption.REPLACE_EXISTING);
        }
        return changees.stream().map(f -> f.getFileName().toString()).collect(Collectors.toList());
    }

    private static boolean memesPixels(Path neuve, Path ancienne) {
        ImageMemoire image = LectureImage.lire(neuve.toString());
        try {
            return Comparaison.de(image, LectureImage.lire(ancienne.toString()), 0).sontPareilles();
        } catch (Echec e) {
            // pas d'ancienne, ou ce n'en est pas une, ou elle n'a pas cette taille
            return false;
        }
    }
}
