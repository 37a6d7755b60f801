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
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lancer.Constantes;
import lancer.Lancer;
import lancer.Scene;
import lancer.antialias.Antialias;
import lancer.auto.Auto;
import lancer.auto.Echelon;
import lancer.dessin.Dessin;
import lancer.mesures.Circonstances;
import lancer.mesures.FichierCsv;
import lancer.mesures.Gabarit;
import lancer.mesures.ImageLineaire;
import lancer.mesures.Intervalle;
import lancer.mesures.scenes.Scenes;
import lancer.mesures.Nombres;
import lancer.scene.SectionLue;

/**
 * Mesure de {@code --auto erreur=E} : l'erreur annoncée est-elle juste, l'erreur voulue est-elle tenue, et à quel prix ? Les scènes sont
 * les scènes livrées, deux foules, et les scènes difficiles. Chaque échelon est dessiné en entier : le prix de la commande est comparé
 * à celui du moins cher des échelons qui tiennent l'erreur.
 */
public final class MesureAuto {

    static final String COLONNES = "scene,taille,erreur_voulue,reglage,erreur,mesuree,incertitude,verdict,rayons,rayons_des_essais,"
            + "moins_cher,rayons_moins_cher,secondes,secondes_moins_cher,commit,date";

    private static final Taille TAILLE = new Taille(200, 150);

    /** Une taille ordinaire, pour quelques scènes seulement. */
    private static final Taille GRANDE = new Taille(Constantes.LARGEUR_IMAGE, Constantes.HAUTEUR_IMAGE);
    private static final List<String> SCENES_EN_GRAND = Arrays.asList("scene1", "bowling", "diffus", "ombres", "ombres-fines");
    private static final int PAS_EN_GRAND = 4;

    private static final double[] ERREURS = {0.5, 1, 2, 4};

    private MesureAuto() {
    }

    /** @param args le fichier, écrit à la fin */
    public static void main(String[] args) throws IOException {
        Path csv = Paths.get(args[0]);
        List<String> lignes = new ArrayList<>(Collections.singletonList(COLONNES));
        Path dossier = Files.createTempDirectory("mesure-auto");
        List<String> noms = new ArrayList<>();
        for (Path fichier : Scenes.livrees()) {
            noms.add(fichier.getFileName().toString().replace(".ini", ""));
        }
        noms.addAll(Arrays.asList("foule-300", "foule-10000"));
        noms.addAll(Scenes.DIFFICILES);
        for (String nom : noms) {
            Scene scene = Scenes.lire(Scenes.fichier(nom, dossier));
            for (Taille taille : SCENES_EN_GRAND.contains(nom) ? new Taille[] {TAILLE, GRANDE} : new Taille[] {TAILLE}) {
                lignes.addAll(lignes(nom, scene, taille, ERREURS));
                System.out.println(String.join("\n", lignes.subList(lignes.size() - ERREURS.length, lignes.size())));
            }
        }
        Files.write(csv, lignes);
        System.out.println(tableau(FichierCsv.lire(csv)).trim());
        System.out.println("noté dans " + csv);
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
            lignes.add(FichierCsv.ligne(nom, taille, voulue, texte(auto.getChoisi()), Nombres.champ(erreur(image, gabarit)),
                    Nombres.champ(auto.getMesure().erreur), Nombres.champ(auto.getMesure().incertitude),
                    auto.getVerdict().replaceAll("erreur voulue | : .*", ""),
                    Nombres.champ((double) auto.getLancer().getCompteurs().rayons() / taille.pixels()),
                    Nombres.champ((double) auto.getRayonsDesEssais() / taille.pixels()), mieux < 0 ? "" : texte(echelle.get(mieux)),
                    mieux < 0 ? "" : Nombres.champ(dessines[mieux][1]), Nombres.champ(secondes),
                    mieux < 0 ? "" : Nombres.champ(dessines[mieux][2]), c.commit, c.date));
        }
        return lignes;
    }

    private static String texte(Echelon echelon) {
        return echelon.toString().replace(',', ' ');
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

    /** Tableau de la page : une ligne par taille. */
    static String tableau(List<String[]> lues) {
        List<Map<String, String>> lignes = lues.stream().map(MesureAuto::parNoms).collect(Collectors.toList());
        List<String> titres = Arrays.asList("image", "l'intervalle contient l'erreur vraie", "demandes tenables tenues", "dites « tenue »",
                "à tort", "dites « dépassée »", "dites « incertaine »", "rayons, médiane", "temps, en tout");
        return Tableaux.table(titres, lignes.stream().map(l -> l.get("taille")).distinct().map(taille -> bilan(taille,
                lignes.stream().filter(l -> l.get("taille").equals(taille)).collect(Collectors.toList()))).collect(Collectors.toList()));
    }

    private static Map<String, String> parNoms(String... champs) {
        String[] noms = COLONNES.split(",");
        return IntStream.range(0, noms.length).boxed().collect(Collectors.toMap(k -> noms[k], k -> champs[k]));
    }

    private static List<String> bilan(String taille, List<Map<String, String>> lignes) {
        List<Map<String, String>> tenables = lignes.stream().filter(l -> !l.get("moins_cher").isEmpty()).collect(Collectors.toList());
        double[] prix = tenables.stream().mapToDouble(l -> (x(l, "rayons") + x(l, "rayons_des_essais")) / x(l, "rayons_moins_cher"))
                .toArray();
        // l'horloge des processeurs avance par centièmes de seconde : seule la somme peut être comparée
        double temps = tenables.stream().mapToDouble(l -> x(l, "secondes")).sum()
                / tenables.stream().mapToDouble(l -> x(l, "secondes_moins_cher")).sum();
        return Arrays.asList(taille.replace("x", " × "),
                compte(lignes, l -> Math.abs(x(l, "mesuree") - x(l, "erreur")) <= x(l, "incertitude")),
                compte(tenables, l -> x(l, "erreur") <= x(l, "erreur_voulue")), dites(lignes, "tenue"),
                compte(lignes, l -> l.get("verdict").equals("tenue") && x(l, "erreur") > x(l, "erreur_voulue")),
                dites(lignes, "dépassée"), dites(lignes, "incertaine"), Nombres.nombre(Intervalle.mediane(prix)), Nombres.nombre(temps));
    }

    private static String dites(List<Map<String, String>> lignes, String verdict) {
        return compte(lignes, l -> l.get("verdict").equals(verdict));
    }

    private static String compte(List<Map<String, String>> lignes, Predicate<Map<String, String>> condition) {
        return lignes.stream().filter(condition).count() + " fois sur " + lignes.size();
    }

    private static double x(Map<String, String> ligne, String colonne) {
        return Double.parseDouble(ligne.get(colonne));
    }
}
