package lancer.mesures.vitesse;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import lancer.Constantes;
import lancer.mesures.Circonstances;
import lancer.mesures.Gabarit;
import lancer.mesures.ImageLineaire;
import lancer.mesures.Intervalle;
import lancer.mesures.Lancement;
import lancer.mesures.juge.PovRay;
import lancer.mesures.juge.SceneJugee;
import lancer.mesures.scenes.Scenes;

/** Mesure les groupes du {@link Catalogue}, par les commandes mêmes d'un utilisateur. */
final class Mesureur {

    /** Programme que construit le Makefile, si Embree est installé. */
    static final Path EMBREE = Paths.get("mesures", "target", "embree");

    /** Nombre de manches : chacune lance une fois l'unité, puis chaque réglage du groupe. */
    private static final int MANCHES = 7;

    /** Nombre maximal de rayons d'une référence. */
    private static final double VERITE = 1.5e8;

    /** Une ligne de {@code --statistiques}, et celles dont la somme est le nombre de rayons, puis d'examens. */
    private static final Pattern STATISTIQUE = Pattern.compile("(?m)^([a-z.]+): ([0-9.]+)$");
    private static final List<String> RAYONS = Arrays.asList("rayons.primaires", "rayons.ombre", "rayons.reflechis",
            "auto.rayons.essais");
    private static final List<String> EXAMENS = Arrays.asList("tests.spheres", "noeuds.visites");

    private final Path dossier;
    private final PrintStream sortie;
    private final PovRay povray;
    private final int manches;

    /** Taille des images de l'unité. */
    private final Taille taille;

    /** Arguments de {@code java} qui lancent le programme d'un réglage. */
    private final Function<Reglage, List<String>> programme;
    private final Circonstances circonstances = new Circonstances();

    /** Une commande que l'on peut répéter. */
    private interface Commande {

        /** Temps réel et temps des processeurs, en nanosecondes, puis mémoire, en octets, NaN si elle n'est pas connue. */
        double[] prendre() throws IOException;
    }

    /**
     * @param dossier celui des fichiers provisoires
     * @param povray {@code null} s'il n'est pas installé
     * @param taille celle des images de l'unité
     * @param court vrai pour une seule manche, dont aucun intervalle ne se déduit
     */
    Mesureur(Path dossier, PovRay povray, PrintStream sortie, Taille taille, boolean court,
            Function<Reglage, List<String>> programme) {
        this.dossier = dossier;
        this.povray = povray;
        this.sortie = sortie;
        this.programme = programme;
        this.taille = taille;
        manches = court ? 1 : MANCHES;
    }

    // ---- ce qui se compte

    /** Note les rayons, les examens et l'erreur de chaque réglage. */
    void compter(Groupe groupe, Resultats resultats) throws IOException {
        sortie.println("rayons et erreurs de " + groupe.scene + ", " + groupe.volet);
        Path fichier = Scenes.fichier(groupe.scene, dossier);
        Path pfm = dossier.resolve("image.pfm");
        double rayons = rayons(Reglage.UN_RAYON.par("", "", "--reflets", String.valueOf(Gabarit.PROFONDEUR), "--seuil", "0"), fichier);
        int pas = (int) Math.ceil(Math.sqrt(Gabarit.RAYONS * rayons / VERITE));
        Gabarit gabarit = new Gabarit(Scenes.lire(fichier), taille.largeur, taille.hauteur, pas);
        for (Groupe.Essai essai : groupe.essais) {
            Mesure m = resultats.noter(groupe, essai);
            String dit = lancer(essai.reglage, fichier, taille, "--lineaire", pfm, "--statistiques").dit;
            ImageLineaire image = ImageLineaire.lire(pfm);
            m.rayons = somme(dit, RAYONS);
            m.examens = somme(dit, EXAMENS);
            m.erreur = Intervalle.deLaRacine(gabarit.carres(image));
            m.visibles = gabarit.visibles(image);
            m.compte = circonstances.commit + " " + circonstances.date.replaceFirst("T.*", "");
        }
    }

    /** Les rayons de toutes sortes d'une image de ce réglage. */
    double rayons(Reglage reglage, Path fichier) throws IOException {
        return somme(lancer(reglage, fichier, taille, "--lineaire", dossier.resolve("image.pfm"), "--statistiques").dit, RAYONS);
    }

    /** La somme des statistiques de ces noms. */
    private static double somme(String dit, List<String> noms) {
        double somme = 0;
        for (Matcher m = STATISTIQUE.matcher(dit); m.find();) {
            somme += noms.contains(m.group(1)) ? Double.parseDouble(m.group(2)) : 0;
        }
        return somme;
    }

    private Lancement lancer(Reglage reglage, Path fichier, Taille sienne, Object... sorties) throws IOException {
        Path scene = fichier;
        if (!reglage.section.isEmpty()) {
            scene = dossier.resolve("changee.ini");
            Files.write(scene, (new String(Files.readAllBytes(fichier), StandardCharsets.UTF_8) + "\n" + reglage.section)
                    .getBytes(StandardCharsets.UTF_8));
        }
        List<Object> commande = new ArrayList<>(Collections.singletonList(Lancement.JAVA));
        commande.addAll(reglage.machine());
        commande.addAll(programme.apply(reglage));
        commande.addAll(Arrays.asList("--taille", sienne, scene));
        commande.addAll(Arrays.asList(sorties));
        commande.addAll(reglage.options);
        return new Lancement(dossier.resolve("pris"), commande.toArray()).reussi();
    }

    // ---- ce qui se chronomètre

    /** Note le temps de chaque réglage, divisé dans chaque manche par celui de l'unité. */
    void chronometrer(Groupe groupe, Resultats resultats) throws IOException {
        Path fichier = Scenes.fichier(groupe.scene, dossier);
        Path unite = Scenes.fichier(groupe.sceneUnite, dossier);
        groupe.essais.removeIf(e -> e.reglage.methode.equals(Reglage.POVRAY) && povray == null
                || e.reglage.methode.equals(Reglage.EMBREE) && !Files.isExecutable(EMBREE));
        List<Commande> commandes = new ArrayList<>(Collections.singletonList(() -> image(Reglage.UN_RAYON, unite, taille)));
        for (Groupe.Essai essai : groupe.essais) {
            commandes.add(commande(essai, fichier));
        }
        sortie.println(groupe.volet + ", " + groupe.scene + " : " + commandes.size() + " commandes, " + manches + " manches");
        if (manches > 1) {
            // un premier passage charge le cache du disque
            for (Commande c : commandes) {
                c.prendre();
            }
        }
        double[][][] pris = new double[commandes.size()][manches][];
        for (int manche = 0; manche < manches; manche++) {
            for (int k = 0; k < commandes.size(); k++) {
                pris[k][manche] = commandes.get(k).prendre();
            }
        }
        for (int k = 1; k < commandes.size(); k++) {
            noter(resultats.noter(groupe, groupe.essais.get(k - 1)), pris[0], pris[k]);
        }
    }

    private void noter(Mesure m, double[][] unite, double[][] pris) {
        m.unite = mediane(unite, 0) / 1e9;
        m.rapport = Intervalle.desRapports(IntStream.range(0, pris.length).mapToDouble(k -> pris[k][0] / unite[k][0]).toArray());
        m.processeurs = mediane(pris, 1) / 1e9;
        m.memoire = mediane(pris, 2) / (1 << 20);
        m.chronometre = circonstances.commit + " " + circonstances.date.replaceFirst("T.*", "");
        m.machine = (circonstances.machine + " ; " + circonstances.coeurs + " cœurs ; " + circonstances.jvm).replace(',', ' ');
        sortie.println(String.format(Locale.ROOT, "  %-45s %8.4g × %8.4g – %-8.4g %8.4g s", m.nom(), m.rapport.valeur, m.rapport.min,
                m.rapport.max, m.rapport.valeur * m.unite));
    }

    private static double mediane(double[][] pris, int rang) {
        return Intervalle.mediane(Arrays.stream(pris).mapToDouble(p -> p[rang]).toArray());
    }

    private Commande commande(Groupe.Essai essai, Path fichier) throws IOException {
        Taille sienne = essai.taille;
        if (essai.reglage.methode.equals(Reglage.POVRAY)) {
            SceneJugee jugee = new SceneJugee(povray, "povray", Scenes.lire(fichier), Constantes.MAX_REFLETS, sienne.largeur,
                    sienne.hauteur);
            return () -> {
                jugee.dessiner();
                return povray.pris();
            };
        }
        if (essai.reglage.methode.equals(Reglage.EMBREE)) {
            return () -> new Lancement(dossier.resolve("pris"), EMBREE, fichier, sienne.largeur, sienne.hauteur, sienne.fils,
                    dossier.resolve("embree.ppm")).reussi().pris;
        }
        return () -> image(essai.reglage, fichier, sienne);
    }

    private double[] image(Reglage reglage, Path fichier, Taille sienne) throws IOException {
        return lancer(reglage, fichier, sienne, "--image", dossier.resolve("image.png")).pris;
    }

    /** L'image que dessine ce réglage. */
    ImageLineaire image(Reglage reglage, Path fichier) throws IOException {
        Path pfm = dossier.resolve("image.pfm");
        lancer(reglage, fichier, taille, "--lineaire", pfm);
        return ImageLineaire.lire(pfm);
    }
}
