package lancer.mesures.vitesse;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.antialias.Antialias;
import lancer.auto.Auto;
import lancer.dessin.Dessin;
import lancer.mesures.FichierCsv;
import lancer.mesures.Gabarit;
import lancer.mesures.ImageLineaire;
import lancer.mesures.Intervalle;
import lancer.mesures.scenes.SceneAuHasard;
import lancer.mesures.scenes.Scenes;
import lancer.scene.SectionLue;

/**
 * Mesure de {@code --auto erreur=E} : l'erreur voulue est-elle tenue, et à quel prix ? Les scènes sont les scènes livrées, et d'autres qui
 * rendent le choix difficile. L'erreur de l'image choisie est comparée à la référence et au verdict du programme. Les rayons du dessin sont
 * comparés à ceux du réglage le moins cher qui tient l'erreur ({@link Oracle}).
 */
public final class MesureAuto {

    static final String COLONNES = "scene,taille,erreur_voulue,reglage,erreur,verdict,rayons,oracle,rayons_oracle,"
            + "rayons_des_essais,secondes,secondes_oracle";

    private static final Taille TAILLE = new Taille(200, 150);

    /** Une taille ordinaire, pour quelques scènes seulement : la recherche de l'oracle y est longue. */
    private static final Taille GRANDE = new Taille(Constantes.LARGEUR_IMAGE, Constantes.HAUTEUR_IMAGE);
    private static final List<String> SCENES_EN_GRAND = Arrays.asList("scene1", "bowling", "diffus", "ombres", "sort-1");
    private static final int PAS_EN_GRAND = 4;

    private static final double[] ERREURS = {0.5, 1, 2, 4};

    /** Nombre de rayons permis aux essais : un minimum, un nombre par pixel, ou une part du dessin. */
    private static final double ESSAIS = 200_000;
    private static final double ESSAIS_PAR_PIXEL = 4;
    private static final double PART_DES_ESSAIS = 0.5;

    private MesureAuto() {
    }

    /** @param args le fichier, écrit à la fin ; une graine et un nombre de scènes aléatoires, au lieu de toutes les autres */
    public static void main(String[] args) throws IOException {
        if (args.length != 1 && (args.length != 3 || !(args[1] + args[2]).matches("[0-9]{1,9}"))) {
            System.err.println("MesureAuto : usage : MesureAuto FICHIER.csv [GRAINE COMBIEN]");
            System.exit(2);
        }
        Map<String, Scene> scenes = args.length > 1 ? auSort(Integer.parseInt(args[1]), Integer.parseInt(args[2])) : toutes();
        List<String> lignes = new ArrayList<>(Collections.singletonList(COLONNES));
        for (Map.Entry<String, Scene> scene : scenes.entrySet()) {
            // une colonne de trois cents pixels, plus larges que les sphères
            Taille taille = scene.getKey().equals("colonne") ? new Taille(1, 300) : TAILLE;
            for (Taille celle : SCENES_EN_GRAND.contains(scene.getKey()) ? new Taille[] {taille, GRANDE} : new Taille[] {taille}) {
                lignes.addAll(lignes(scene.getKey(), scene.getValue(), celle, ERREURS));
                System.out.println(String.join("\n", lignes.subList(lignes.size() - ERREURS.length, lignes.size())));
            }
        }
        Path csv = Paths.get(args[0]);
        Files.write(csv, lignes);
        System.out.println(tableau(FichierCsv.lire(csv)).trim());
        System.out.println("noté dans " + csv);
    }

    private static Map<String, Scene> auSort(int graine, int combien) {
        Map<String, Scene> scenes = new LinkedHashMap<>();
        for (int k = graine; k < graine + combien; k++) {
            scenes.put("sort-" + k, SceneAuHasard.de(k));
        }
        return scenes;
    }

    private static Map<String, Scene> toutes() throws IOException {
        Map<String, Scene> scenes = new LinkedHashMap<>();
        for (Path fichier : Scenes.livrees()) {
            scenes.put(fichier.getFileName().toString().replace(".ini", ""), Scenes.lire(fichier));
        }
        scenes.putAll(auSort(1, 3));
        Path dossier = Files.createTempDirectory("mesure-auto");
        for (String nom : new String[] {"foule-300", "foule-10000"}) {
            scenes.put(nom, Scenes.lire(Scenes.fichier(nom, dossier)));
        }
        scenes.put("poussiere", boules(600, 0.2, 0, 2, 1));
        scenes.put("etoiles-d-un-pixel", boules(20, 0.5, 0, 3, 1));
        scenes.put("petites-brillantes", boules(40, 3, 0.8, 4, 1));
        scenes.put("soixante-lampes", boules(9, 12, 0.4, 5, 60));
        scenes.put("colonne", SceneAuHasard.de(12));
        return scenes;
    }

    /** Des sphères au hasard dans l'image. @param rayon en pixels, pour une image de 200 pixels de large */
    private static Scene boules(int combien, double rayon, double reflet, long graine, int lampes) {
        SplittableRandom hasard = new SplittableRandom(graine);
        List<Sphere> boules = new ArrayList<>();
        for (int k = 0; k < combien; k++) {
            double z = 6 + hasard.nextDouble(2);
            double champ = (z + Camera.FOCALE) / Camera.FOCALE;
            Sphere boule = new Sphere(new Point(hasard.nextDouble(-1, 1) * champ, hasard.nextDouble(-0.75, 0.75) * champ, z),
                    rayon * Constantes.ECHELLE / TAILLE.largeur * champ);
            boule.setKd(new Couleur(0.9));
            boule.setKs(new Couleur(reflet));
            boule.setNs(40);
            boules.add(boule);
        }
        List<Lampe> toutes = new ArrayList<>();
        for (int k = 0; k < lampes; k++) {
            toutes.add(new Lampe(new Point(hasard.nextDouble(-8, 8), hasard.nextDouble(2, 10), hasard.nextDouble(-8, 4)),
                    new Couleur(1.0 / lampes)));
        }
        return new Scene(boules, toutes);
    }

    /** Choix et verdict du programme pour chaque erreur voulue, croissante, avec l'erreur mesurée. */
    static List<String> lignes(String nom, Scene scene, Taille taille, double... voulues) {
        Gabarit gabarit = new Gabarit(scene, taille.largeur, taille.hauteur, taille.pixels() > TAILLE.pixels() ? PAS_EN_GRAND : 1);
        Oracle oracle = new Oracle(scene, taille, voulues[0], image -> Intervalle.deLaRacine(gabarit.carres(image)).valeur);
        List<String> lignes = new ArrayList<>();
        for (double voulue : voulues) {
            ImageLineaire image = new ImageLineaire(taille.largeur, taille.hauteur);
            double debut = secondes();
            Auto auto = dessiner(scene, taille, voulue, image);
            double secondes = secondes() - debut;
            Oracle.Essai mieux = oracle.leMoinsCher(voulue);
            double sienne = mieux == null ? 0 : oracle.secondes(mieux);
            lignes.add(FichierCsv.ligne(nom, taille, voulue, auto.choisi, nombre(Intervalle.deLaRacine(gabarit.carres(image)).valeur),
                    auto.getVerdict().replaceAll("erreur voulue | : .*", ""),
                    nombre((double) auto.lancer.getCompteurs().rayons() / taille.pixels()),
                    mieux == null ? "" : mieux, mieux == null ? "" : nombre(mieux.prix),
                    nombre((double) auto.getRayonsDesEssais() / taille.pixels()), nombre(secondes), mieux == null ? "" : nombre(sienne)));
        }
        return lignes;
    }

    /** Temps des processeurs de ce processus, dans tous ses fils, en secondes. */
    static double secondes() {
        return ((OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean()).getProcessCpuTime() / 1e9;
    }

    static Auto dessiner(Scene scene, Taille taille, double voulue, ImageLineaire image) {
        Auto auto = new Auto(Dessin.lancer(scene, taille.largeur, taille.hauteur, false), voulue, null, null,
                taille.fils, Collections.singletonMap(new Antialias(), new SectionLue("Antialias")), enCours -> { });
        auto.lancer.TracerPixels(auto.surveiller(image, auto.choisi), auto.choisi.reflets, taille.fils);
        return auto;
    }

    /** Tableau de la page : une ligne par taille, sauf pour les images très petites, dont le prix ne compte pas. */
    static String tableau(List<Map<String, String>> lignes) {
        StringBuilder tableau = new StringBuilder("\n\n| image | demandes tenables tenues | dites « tenue » | à tort "
                + "| dites « dépassée » | dites « incertaine » | prix, médiane | prix, neuf fois sur dix | temps, en tout |\n"
                + "|---|---|---|---|---|---|---|---|---|\n");
        for (String taille : lignes.stream().filter(l -> pixels(l) >= TAILLE.pixels()).map(l -> l.get("taille")).distinct()
                .toArray(String[]::new)) {
            Map<String, String> b = bilan(lignes.stream().filter(l -> l.get("taille").equals(taille)).collect(Collectors.toList()));
            tableau.append("| ").append(taille.replace("x", " × "));
            for (String nom : new String[] {"tenues", "dites_tenues", "a_tort", "dites_depassees", "dites_incertaines"}) {
                tableau.append(" | ").append(b.get(nom));
            }
            for (String nom : new String[] {"total", "total90", "secondes"}) {
                tableau.append(" | ").append(b.get(nom).replace('.', ','));
            }
            tableau.append(" |\n");
        }
        return tableau.append('\n').toString();
    }

    static Map<String, String> bilan(List<Map<String, String>> lignes) {
        Map<String, String> bilan = new TreeMap<>();
        List<Map<String, String>> tenables = lignes.stream().filter(l -> !l.get("oracle").isEmpty()).collect(Collectors.toList());
        bilan.put("tenues", compte(tenables, l -> x(l, "erreur") <= x(l, "erreur_voulue")));
        bilan.put("dites_tenues", dites(lignes, "tenue"));
        bilan.put("dites_depassees", dites(lignes, "dépassée"));
        bilan.put("dites_incertaines", dites(lignes, "incertaine"));
        bilan.put("a_tort", compte(lignes, l -> l.get("verdict").equals("tenue") && x(l, "erreur") > x(l, "erreur_voulue")));
        bilan.put("essais", compte(lignes, l -> x(l, "rayons_des_essais") <= Math.max(ESSAIS / pixels(l),
                Math.max(ESSAIS_PAR_PIXEL, PART_DES_ESSAIS * x(l, "rayons")))));
        double[] prix = tenables.stream().mapToDouble(l -> (x(l, "rayons") + x(l, "rayons_des_essais")) / x(l, "rayons_oracle"))
                .sorted().toArray();
        bilan.put("total", nombre(quantile(prix, 0.5)));
        bilan.put("total90", nombre(quantile(prix, 0.9)));
        // l'horloge des processeurs avance par centièmes de seconde : seule la somme peut être comparée
        bilan.put("secondes", nombre(tenables.stream().mapToDouble(l -> x(l, "secondes")).sum()
                / tenables.stream().mapToDouble(l -> x(l, "secondes_oracle")).sum()));
        return bilan;
    }

    private static String dites(List<Map<String, String>> lignes, String verdict) {
        return compte(lignes, l -> l.get("verdict").equals(verdict));
    }

    private static double pixels(Map<String, String> ligne) {
        return Arrays.stream(ligne.get("taille").split("x")).mapToDouble(Double::parseDouble).reduce(1, (a, b) -> a * b);
    }

    private static double quantile(double[] tries, double part) {
        return tries.length == 0 ? Double.NaN : tries[Math.min(tries.length - 1, (int) (part * tries.length))];
    }

    private static String compte(List<Map<String, String>> lignes, Predicate<Map<String, String>> condition) {
        return lignes.stream().filter(condition).count() + " fois sur " + lignes.size();
    }

    private static double x(Map<String, String> ligne, String colonne) {
        return Double.parseDouble(ligne.get(colonne));
    }

    private static String nombre(double x) {
        return String.format(Locale.ROOT, "%.3f", x);
    }
}
