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
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.antialias.Antialias;
import lancer.auto.Auto;
import lancer.auto.Echelon;
import lancer.dessin.Dessin;
import lancer.mesures.FichierCsv;
import lancer.mesures.Gabarit;
import lancer.mesures.ImageLineaire;
import lancer.mesures.Intervalle;
import lancer.mesures.scenes.SceneAuHasard;
import lancer.mesures.scenes.Scenes;
import lancer.scene.SectionLue;

/**
 * Mesure de {@code --auto erreur=E} : l'erreur annoncée est-elle juste, l'erreur voulue est-elle tenue, et à quel prix ? Les scènes sont
 * les scènes livrées, et d'autres qui rendent le choix difficile. Chaque échelon est dessiné en entier : le prix de la commande est comparé
 * à celui du moins cher des échelons qui tiennent l'erreur.
 */
public final class MesureAuto {

    static final String COLONNES = "scene,taille,erreur_voulue,reglage,erreur,mesuree,incertitude,verdict,rayons,rayons_des_essais,"
            + "moins_cher,rayons_moins_cher,secondes,secondes_moins_cher,commit,date";

    private static final Taille TAILLE = new Taille(200, 150);

    /** Une taille ordinaire, pour quelques scènes seulement. */
    private static final Taille GRANDE = new Taille(Constantes.LARGEUR_IMAGE, Constantes.HAUTEUR_IMAGE);
    private static final List<String> SCENES_EN_GRAND = Arrays.asList("scene1", "bowling", "diffus", "ombres", "sort-1");
    private static final int PAS_EN_GRAND = 4;

    private static final double[] ERREURS = {0.5, 1, 2, 4};

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

    /** Choix, mesure et verdict du programme pour chaque erreur voulue ; l'erreur vraie ; le moins cher des échelons qui la tiennent. */
    static List<String> lignes(String nom, Scene scene, Taille taille, double... voulues) {
        Gabarit gabarit = new Gabarit(scene, taille.largeur, taille.hauteur, taille.pixels() > TAILLE.pixels() ? PAS_EN_GRAND : 1);
        Lancer prepare = Dessin.lancer(scene, taille.largeur, taille.hauteur, false);
        List<Echelon> echelle = echelle(prepare);
        double[][] dessines = echelle.stream().map(e -> dessiner(e, prepare, gabarit, taille)).toArray(double[][]::new);
        Circonstances c = new Circonstances();
        List<String> lignes = new ArrayList<>();
        for (double voulue : voulues) {
            ImageLineaire image = new ImageLineaire(taille.largeur, taille.hauteur);
            double debut = secondes();
            Auto auto = dessiner(scene, taille, voulue, image);
            double secondes = secondes() - debut;
            int mieux = IntStream.range(0, dessines.length).filter(k -> dessines[k][0] <= voulue).boxed()
                    .min(Comparator.comparingDouble(k -> dessines[k][1])).orElse(-1);
            lignes.add(FichierCsv.ligne(nom, taille, voulue, auto.getChoisi(), nombre(erreur(image, gabarit)),
                    nombre(auto.getMesure().erreur), nombre(auto.getMesure().incertitude),
                    auto.getVerdict().replaceAll("erreur voulue | : .*", ""),
                    nombre((double) auto.getLancer().getCompteurs().rayons() / taille.pixels()),
                    nombre((double) auto.getRayonsDesEssais() / taille.pixels()), mieux < 0 ? "" : echelle.get(mieux),
                    mieux < 0 ? "" : nombre(dessines[mieux][1]), nombre(secondes), mieux < 0 ? "" : nombre(dessines[mieux][2]),
                    c.commit, c.date));
        }
        return lignes;
    }

    private static double erreur(ImageLineaire image, Gabarit gabarit) {
        return Intervalle.deLaRacine(gabarit.carres(image)).valeur;
    }

    private static List<Echelon> echelle(Lancer prepare) {
        return Echelon.echelle(prepare.getScene().getModele(), Collections.singletonMap(new Antialias(), new SectionLue("Antialias")),
                null, null);
    }

    /** L'erreur de l'image de cet échelon, ses rayons de toutes sortes par pixel, son temps de processeur en secondes. */
    private static double[] dessiner(Echelon echelon, Lancer prepare, Gabarit gabarit, Taille taille) {
        double debut = secondes();
        Lancer lancer = echelon.lancer(prepare);
        ImageLineaire image = ImageLineaire.de(lancer, echelon.reflets, taille.fils);
        double secondes = secondes() - debut;
        return new double[] {erreur(image, gabarit), (double) lancer.getCompteurs().rayons() / taille.pixels(), secondes};
    }

    /** Temps des processeurs de ce processus, dans tous ses fils, en secondes. */
    static double secondes() {
        return ((OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean()).getProcessCpuTime() / 1e9;
    }

    static Auto dessiner(Scene scene, Taille taille, double voulue, ImageLineaire image) {
        Lancer prepare = Dessin.lancer(scene, taille.largeur, taille.hauteur, false);
        Auto auto = new Auto(prepare, echelle(prepare), voulue, taille.fils);
        do {
            auto.getLancer().TracerPixels(auto.surveiller(image), auto.getChoisi().reflets, taille.fils);
        } while (!auto.controler());
        return auto;
    }

    /** Tableau de la page : une ligne par taille, sauf pour les images très petites, dont le prix ne compte pas. */
    static String tableau(List<Map<String, String>> lignes) {
        StringBuilder tableau = new StringBuilder("\n\n| image | l'intervalle contient l'erreur vraie | demandes tenables tenues "
                + "| dites « tenue » | à tort | dites « dépassée » | dites « incertaine » | rayons, médiane | temps, en tout |\n"
                + "|---|---|---|---|---|---|---|---|---|\n");
        for (String taille : lignes.stream().filter(l -> pixels(l) >= TAILLE.pixels()).map(l -> l.get("taille")).distinct()
                .toArray(String[]::new)) {
            Map<String, String> b = bilan(lignes.stream().filter(l -> l.get("taille").equals(taille)).collect(Collectors.toList()));
            tableau.append("| ").append(taille.replace("x", " × "));
            for (String nom : new String[] {"justes", "tenues", "dites_tenues", "a_tort", "dites_depassees", "dites_incertaines", "prix",
                "secondes"}) {
                tableau.append(" | ").append(b.get(nom).replace('.', ','));
            }
            tableau.append(" |\n");
        }
        return tableau.append('\n').toString();
    }

    static Map<String, String> bilan(List<Map<String, String>> lignes) {
        Map<String, String> bilan = new TreeMap<>();
        List<Map<String, String>> tenables = lignes.stream().filter(l -> !l.get("moins_cher").isEmpty()).collect(Collectors.toList());
        bilan.put("justes", compte(lignes, l -> Math.abs(x(l, "mesuree") - x(l, "erreur")) <= x(l, "incertitude")));
        bilan.put("tenues", compte(tenables, l -> x(l, "erreur") <= x(l, "erreur_voulue")));
        bilan.put("dites_tenues", dites(lignes, "tenue"));
        bilan.put("dites_depassees", dites(lignes, "dépassée"));
        bilan.put("dites_incertaines", dites(lignes, "incertaine"));
        bilan.put("a_tort", compte(lignes, l -> l.get("verdict").equals("tenue") && x(l, "erreur") > x(l, "erreur_voulue")));
        bilan.put("prix", nombre(Intervalle.mediane(tenables.stream()
                .mapToDouble(l -> (x(l, "rayons") + x(l, "rayons_des_essais")) / x(l, "rayons_moins_cher")).toArray())));
        // l'horloge des processeurs avance par centièmes de seconde : seule la somme peut être comparée
        bilan.put("secondes", nombre(tenables.stream().mapToDouble(l -> x(l, "secondes")).sum()
                / tenables.stream().mapToDouble(l -> x(l, "secondes_moins_cher")).sum()));
        return bilan;
    }

    private static String dites(List<Map<String, String>> lignes, String verdict) {
        return compte(lignes, l -> l.get("verdict").equals(verdict));
    }

    private static double pixels(Map<String, String> ligne) {
        return Arrays.stream(ligne.get("taille").split("x")).mapToDouble(Double::parseDouble).reduce(1, (a, b) -> a * b);
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
