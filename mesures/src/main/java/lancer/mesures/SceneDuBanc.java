package lancer.mesures;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import lancer.lecture.LecteurScene;

/** Une scène du banc : celle du cours, lue où elle est, ou une scène engendrée le temps de la mesurer. */
final class SceneDuBanc {

    /** La scène du cours. */
    private static final String COURS = "scenes/scene1.ini";

    /** Ce qui écrit une scène. */
    private interface Texte {
        void ecrire(Appendable sortie) throws IOException;
    }

    /** Ce qu'elle a en commun avec celles dont seul le nombre de sphères diffère. */
    final String famille;
    final String nom;
    final int spheres;
    private final Texte texte;

    private SceneDuBanc(String famille, String nom, int spheres, Texte texte) {
        this.famille = famille;
        this.nom = nom;
        this.spheres = spheres;
        this.texte = texte;
    }

    /**
     * Toutes, chaque famille de la plus petite à la plus grande.
     *
     * @param petit vrai pour les petites seulement
     */
    static List<SceneDuBanc> toutes(boolean petit) {
        List<SceneDuBanc> scenes = new ArrayList<>();
        scenes.add(new SceneDuBanc("scene1", "scene1", 0, null));
        int spheres = 10;
        for (int p = 2; p <= (petit ? 2 : 6); p++) {
            int profondeur = p;
            spheres = 9 * spheres + 1;
            scenes.add(new SceneDuBanc("flocon", "flocon-" + spheres, spheres, s -> Generateur.flocon(s, profondeur)));
        }
        for (int n = 10; n <= (petit ? 100 : 1000000); n *= 10) {
            int nombre = n;
            scenes.add(new SceneDuBanc("foule", "foule-" + n, n, s -> Generateur.foule(s, nombre, Generateur.GRAINE)));
        }
        return scenes;
    }

    /**
     * Le fichier de la scène, écrit s'il le faut.
     *
     * @param dossier où l'écrire
     */
    Path fichier(Path dossier) throws IOException {
        if (texte == null) {
            return LecteurScene.trouver(COURS);
        }
        Path fichier = dossier.resolve(nom + ".ini");
        // cent millions d'octets peut-être, et Ctrl+C n'attend pas oublier()
        fichier.toFile().deleteOnExit();
        try (BufferedWriter sortie = Files.newBufferedWriter(fichier, StandardCharsets.UTF_8)) {
            texte.ecrire(sortie);
        }
        return fichier;
    }

    /** Ôte le fichier, s'il a été écrit. */
    void oublier(Path dossier) throws IOException {
        Files.deleteIfExists(dossier.resolve(nom + ".ini"));
    }

    /** Vrai si cette demande, un nom ou celui d'une famille, désigne cette scène. */
    boolean est(String demande) {
        return demande.equals(nom) || demande.equals(famille);
    }
}
