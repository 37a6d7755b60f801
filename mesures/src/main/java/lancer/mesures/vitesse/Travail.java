package lancer.mesures.vitesse;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lancer.Scene;
import lancer.lecture.LecteurScene;
import lancer.mesures.Generateur;
import lancer.mesures.Scenes;

/** Des méthodes à mesurer sur une scène, dans une même machine virtuelle. */
final class Travail {

    private static final String FOULE = "foule-";

    /** La scène, et ce qui s'y mesure : deux travaux d'une même scène ont deux familles. */
    final String scene;
    final Famille famille;

    /** Ce qui se mesure ensemble, un dessin de chacune à chaque tour. */
    final List<List<Methode>> groupes = new ArrayList<>();

    private Travail(String scene, Famille famille) {
        this.scene = scene;
        this.famille = famille;
    }

    private static Travail separement(String scene, Famille famille, List<Methode> methodes) {
        Travail travail = new Travail(scene, famille);
        methodes.forEach(m -> travail.groupes.add(Arrays.asList(m)));
        return travail;
    }

    private static Travail ensemble(String scene, Famille famille, List<Methode> methodes, int taille) {
        Travail travail = new Travail(scene, famille);
        for (int k = 0; k < methodes.size(); k += taille) {
            travail.groupes.add(methodes.subList(k, Math.min(k + taille, methodes.size())));
        }
        return travail;
    }

    /** Tous, dans l'ordre où les faire. */
    static List<Travail> tous(boolean court) {
        Catalogue catalogue = new Catalogue(court);
        List<Travail> tous = new ArrayList<>();
        for (String scene : catalogue.scenes()) {
            tous.add(separement(scene, Famille.ECHANTILLONNAGE, catalogue.echantillonnages()));
            tous.add(separement(scene, Famille.REFLETS, catalogue.reflets()));
            tous.add(ensemble(scene, Famille.MODELE, catalogue.modeles(), 2));
        }
        List<Methode> demandes = catalogue.demandes();
        tous.add(ensemble(Catalogue.SCENE_DEMANDES, Famille.DEMANDES, demandes, demandes.size()));
        for (int n : catalogue.nombres()) {
            tous.add(separement(FOULE + n, Famille.SPHERES, catalogue.spheres(n)));
        }
        return tous;
    }

    String nom() {
        return scene + " " + famille.nom();
    }

    /** La scène de ce travail, lue où elle est ou engendrée le temps de la lire. */
    Scene lire() throws IOException {
        if (!scene.startsWith(FOULE)) {
            return Scenes.lire(LecteurScene.trouver("scenes/" + scene + ".ini"));
        }
        Path fichier = Files.createTempFile("foule", ".ini");
        fichier.toFile().deleteOnExit();
        try {
            try (BufferedWriter sortie = Files.newBufferedWriter(fichier, StandardCharsets.UTF_8)) {
                Generateur.foule(sortie, Integer.parseInt(scene.substring(FOULE.length())), Generateur.GRAINE);
            }
            return Scenes.lire(fichier);
        } finally {
            Files.delete(fichier);
        }
    }

    List<Methode> methodes() {
        List<Methode> methodes = new ArrayList<>();
        groupes.forEach(methodes::addAll);
        return methodes;
    }
}
