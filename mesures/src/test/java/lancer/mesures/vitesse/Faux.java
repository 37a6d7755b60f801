package lancer.mesures.vitesse;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Des mesures inventées, pour essayer ce qui les lit. */
final class Faux {

    private Faux() {
    }

    /** Un fichier du projet, que les tests soient lancés à la racine ou dans le module. */
    static Path projet(String chemin) {
        return Paths.get(Files.exists(Paths.get("ensemble.xml")) ? "" : "..").resolve(chemin);
    }

    /** Un relevé d'une image de cent pixels : {@code rayons} par pixel, {@code pas} d'erreur. */
    static Releve releve(Famille famille, String methode, String parametres, double rayons, double pas) {
        Map<String, String> champs = new HashMap<>();
        champs.put("scene", "scene1");
        champs.put("famille", famille.nom());
        champs.put("methode", methode);
        champs.put("parametres", parametres);
        champs.put("largeur", "10");
        champs.put("hauteur", "10");
        champs.put("fils", "2");
        champs.put("primaires", String.valueOf(100 * rayons));
        champs.put("ombre", "0");
        champs.put("reflechis", "0");
        champs.put("tests", String.valueOf(300 * rayons));
        champs.put("mediane_ms", String.valueOf(rayons / 2));
        champs.put("q1_ms", String.valueOf(rayons / 2.2));
        champs.put("q3_ms", String.valueOf(rayons / 1.8));
        champs.put("rmse", String.valueOf(pas / 255));
        champs.put("ssim", "0.99");
        return new Releve(champs);
    }

    /** Une scène où « partage » bat le défaut deux fois, et la grille 3 × 3 trois fois. */
    static List<Releve> releves() {
        List<Releve> tous = new ArrayList<>();
        tous.add(releve(Famille.VERITE, "moyenne", "n=64", 4000, 0.05));
        tous.add(releve(Famille.ECHANTILLONNAGE, Catalogue.BROUILLON, "4 × 4", 0.2, 20));
        tous.add(releve(Famille.ECHANTILLONNAGE, Catalogue.UN_RAYON, "", 4, 6));
        tous.add(releve(Famille.ECHANTILLONNAGE, Catalogue.GRILLE, "3 × 3", 36, 1.5));
        tous.add(releve(Famille.ECHANTILLONNAGE, Catalogue.COINS, "n=3 seuil=0.05", 24, 1.5));
        tous.add(releve(Famille.ECHANTILLONNAGE, Catalogue.PARTAGE, "n=4 seuil=0.1", 12, 1.2));
        tous.add(releve(Famille.REFLETS, Catalogue.PROFONDEUR, "p=0 seuil=1/1024", 2, 40));
        tous.add(releve(Famille.REFLETS, Catalogue.PROFONDEUR, "p=5 seuil=1/1024", 4, 0.02));
        tous.add(releve(Famille.REFLETS, Catalogue.SEUIL, "p=1000 seuil=0", 5, 0));
        return tous;
    }
}
