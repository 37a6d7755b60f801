package lancer.mesures;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.Scene;
import lancer.atelier.Scenes;

/**
 * {@code --auto erreur=E} tient-il parole ? Sur les scènes livrées et sur cent scènes tirées au sort, l'erreur de l'image choisie,
 * contre la vérité ; et, quand elle est tenue, si un réglage moins cher l'aurait tenue aussi : le prix de la prudence.
 *
 * <pre>
 * java -cp mesures/target/mesures.jar:mesures/target/test-classes lancer.mesures.MesureAuto FICHIER.csv [GRAINE COMBIEN]
 * </pre>
 */
final class MesureAuto {

    private static final int LARGEUR = 200;
    private static final int HAUTEUR = 150;
    private static final double[] ERREURS = {0.5, 1, 2, 4};

    /** Des graines sur lesquelles rien n'a été réglé : les prudences de {@code lancer.auto} l'ont été sur 1000 à 1019. */
    private static final int GRAINE = 1;
    private static final int SCENES = 100;

    private final Map<String, List<PromesseAuto>> promesses = new LinkedHashMap<>();
    private final Path csv;

    private MesureAuto(Path csv) {
        this.csv = csv;
    }

    /** @param args le fichier à écrire ; la première graine et le nombre de scènes tirées au sort, si l'on en veut d'autres */
    public static void main(String[] args) throws IOException {
        long debut = System.nanoTime();
        MesureAuto mesure = new MesureAuto(Paths.get(args[0]));
        Files.write(mesure.csv, Collections.singletonList(PromesseAuto.COLONNES));
        for (Path fichier : livrees()) {
            mesure.mesurer("livrées", fichier.getFileName().toString().replace(".ini", ""), Scenes.lire(fichier));
        }
        int graine = args.length > 1 ? Integer.parseInt(args[1]) : GRAINE;
        int combien = args.length > 2 ? Integer.parseInt(args[2]) : SCENES;
        for (int k = graine; k < graine + combien; k++) {
            mesure.mesurer("tirées au sort", "sort-" + k, SceneAuHasard.de(k));
        }
        mesure.promesses.forEach((sorte, liste) -> System.out.println(sorte + " : " + PromesseAuto.bilan(liste)));
        System.out.println("noté dans " + args[0] + ", en " + Math.round((System.nanoTime() - debut) / 1e9) + " s");
    }

    private static List<Path> livrees() throws IOException {
        try (Stream<Path> fichiers = Files.list(Paths.get("scenes"))) {
            return fichiers.filter(f -> f.toString().endsWith(".ini")).sorted().collect(Collectors.toList());
        }
    }

    private void mesurer(String sorte, String nom, Scene scene) throws IOException {
        Gabarit gabarit = new Gabarit(scene, LARGEUR, HAUTEUR, 1);
        for (double voulue : ERREURS) {
            PromesseAuto promesse = new PromesseAuto(nom, scene, LARGEUR, HAUTEUR, gabarit, voulue);
            Files.write(csv, Collections.singletonList(promesse.csv()), StandardOpenOption.APPEND);
            for (String groupe : new String[] {sorte, sorte + ", erreur de " + voulue}) {
                promesses.computeIfAbsent(groupe, g -> new ArrayList<>()).add(promesse);
            }
        }
    }
}
