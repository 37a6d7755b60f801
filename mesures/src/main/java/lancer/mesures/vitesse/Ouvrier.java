package lancer.mesures.vitesse;

import com.sun.management.OperatingSystemMXBean;
import java.awt.image.BufferedImage;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import lancer.Scene;
import lancer.contrat.Compteurs;
import lancer.contrat.Pave;
import lancer.mesures.ImageLineaire;
import lancer.mesures.scenes.Scenes;
import lancer.mesures.stabilite.Formule;
import lancer.mesures.stabilite.Noyau;
import lancer.mesures.stabilite.Regime;

/**
 * Une machine virtuelle qui n'exécute qu'une méthode. Elle lit sur son entrée le nombre de répétitions à chronométrer, plusieurs fois, puis
 * « finir ». L'image n'est vérifiée qu'à la fin : avant, la machine virtuelle ne compile que le code de cette méthode.
 */
final class Ouvrier {

    /** Quantité de travail refaite par les boucles du cours, en nombre approché de sphères essayées. */
    private static final double BUDGET = 1e8;

    /** Coût fixe d'un rayon dans les boucles du cours, en sphères. */
    private static final int SOCLE = 20;

    private static final long GRAINE = 800600;

    private Ouvrier() {
    }

    /** @param args famille, scène, méthode, fichier, largeur, hauteur */
    public static void main(String[] args) throws IOException {
        PrintStream sortie = new PrintStream(System.out, true, "UTF-8");
        BufferedReader entree = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        try {
            if (args[0].equals(Catalogue.INTERSECTIONS)) {
                Noyau noyau = new Noyau(Formule.valueOf(args[2].replace("/", "")), Regime.valueOf(args[1]));
                repondre(noyau::faire, () -> "", entree, sortie);
            } else {
                dessiner(Catalogue.methode(args[0], args[1], args[2]), Scenes.lire(Paths.get(args[3])),
                        new Taille(Integer.parseInt(args[4]), Integer.parseInt(args[5])), entree, sortie);
            }
        } catch (RuntimeException | OutOfMemoryError e) {
            sortie.println("faute " + e);
        }
    }

    static void dessiner(Methode methode, Scene scene, Taille taille, BufferedReader entree, PrintStream sortie) throws IOException {
        Methode.ScenePrete dessin = methode.new ScenePrete(scene, taille.largeur, taille.hauteur);
        ImageLineaire image = new ImageLineaire(taille.largeur, taille.hauteur);
        repondre(() -> dessin.faire(image, taille.fils), () -> {
            int verifies = verifier(dessin, scene, image, taille);
            return comptes(dessin.lancer.getCompteurs()) + " " + verifies;
        }, entree, sortie);
    }

    private static String comptes(Compteurs c) {
        return c.primaires + " " + c.ombre + " " + c.reflechis + " " + c.testsSpheres + " " + c.noeudsVisites + " " + c.pixelsRaffines;
    }

    /** Ces compteurs, puis le nombre de pixels vérifiés, par noms de colonnes. */
    static Map<String, String> champs(String comptes) {
        String[] noms = {"primaires", "ombre", "reflechis", "tests", "noeuds", "raffines", "pixels_verifies"};
        String[] valeurs = comptes.split(" ");
        return IntStream.range(0, comptes.isEmpty() ? 0 : noms.length).boxed().collect(Collectors.toMap(k -> noms[k], k -> valeurs[k]));
    }

    /** @param fin donne les compteurs et la vérification, après les temps */
    private static void repondre(Runnable travail, Supplier<String> fin, BufferedReader entree, PrintStream sortie) throws IOException {
        for (String demande = entree.readLine(); demande != null; demande = entree.readLine()) {
            if (demande.equals("finir")) {
                sortie.println(fin.get());
                return;
            }
            double[] temps = repeter(travail, Integer.parseInt(demande));
            sortie.println(temps[0] + " " + temps[1]);
        }
    }

    /** Le temps réel et le temps des processeurs d'une répétition, en nanosecondes. */
    private static double[] repeter(Runnable travail, int fois) {
        OperatingSystemMXBean systeme = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
        long processeur = systeme.getProcessCpuTime();
        long debut = System.nanoTime();
        for (int k = 0; k < fois; k++) {
            travail.run();
        }
        double duree = System.nanoTime() - debut;
        return new double[] {duree / fois, (double) (systeme.getProcessCpuTime() - processeur) / fois};
    }

    /**
     * Refait, par les boucles du cours, des pavés au hasard, toujours les mêmes, et les compare au bit près.
     *
     * @return le nombre de pixels refaits
     * @throws IllegalStateException si un pixel diffère
     */
    static int verifier(Methode.ScenePrete dessin, Scene scene, ImageLineaire image, Taille taille) {
        double cout = (double) dessin.lancer.getCompteurs().rayons() * (scene.getObjets().size() + SOCLE);
        int nombre = Pave.nombre(taille.largeur, taille.hauteur, Pave.COTE);
        int combien = Math.max(1, (int) (nombre * Math.min(1, BUDGET / cout)));
        List<Pave> choisis = new Random(GRAINE).ints(0, nombre).distinct().limit(combien)
                .mapToObj(k -> Pave.deRang(k, taille.largeur, taille.hauteur, Pave.COTE)).collect(Collectors.toList());
        ImageLineaire juste = new ImageLineaire(taille.largeur, taille.hauteur);
        Arrays.fill(juste.getComposantes(), Double.NaN);
        dessin.refaire(entier -> (pave, voulus, vue, toile)
                -> choisis.stream().anyMatch(p -> p.i0 == pave.i0 && p.j0 == pave.j0)
                ? entier.tracer(pave, voulus, vue, toile) : 0, juste, taille.fils);
        int refaits = 0;
        for (int k = 0; k < taille.pixels(); k++) {
            if (!Double.isNaN(juste.getComposantes()[3 * k])) {
                refaits++;
                if (!juste.getCouleur(k).equals(image.getCouleur(k))) {
                    throw new IllegalStateException("image fausse : le pixel (" + k % taille.largeur + ", " + k / taille.largeur
                            + ") est " + image.getCouleur(k) + " au lieu de " + juste.getCouleur(k));
                }
            }
        }
        return refaits;
    }

    /**
     * Compare l'image d'un programme qui calcule en {@code float}, et n'a donc pas les mêmes bits.
     *
     * @throws IllegalStateException si plus d'un pixel sur cent s'écarte de plus d'un niveau
     */
    static void comparer(Path ppm, Path png, Taille taille) throws IOException {
        byte[] octets = Files.readAllBytes(ppm);
        BufferedImage image = ImageIO.read(png.toFile());
        int entete = octets.length - 3 * taille.pixels();
        long faux = IntStream.range(0, taille.pixels()).filter(k -> IntStream.range(0, 3).anyMatch(c -> Math.abs((octets[entete + 3 * k + c]
                & 0xFF) - (image.getRGB(k % taille.largeur, k / taille.largeur) >> 16 - 8 * c & 0xFF)) > 1)).count();
        if (100 * faux > taille.pixels()) {
            throw new IllegalStateException("image fausse : " + ppm + ", " + faux + " pixels");
        }
    }

    /**
     * Refait l'image d'un programme, puis une partie par les boucles du cours.
     *
     * @return les compteurs, par noms de colonnes
     * @throws IllegalStateException si un pixel diffère
     */
    static Map<String, String> controler(Methode methode, Scene scene, Taille taille, Path png) throws IOException {
        ImageLineaire image = new ImageLineaire(taille.largeur, taille.hauteur);
        boolean auto = methode.nom.equals(Catalogue.AUTO);
        Methode.ScenePrete dessin = auto ? null : methode.new ScenePrete(scene, taille.largeur, taille.hauteur);
        Compteurs comptes = auto ? MesureAuto.dessiner(scene, taille, 1, image).getLancer().getCompteurs()
                : dessin.faire(image, taille.fils);
        BufferedImage lue = ImageIO.read(png.toFile());
        for (int k = 0; k < taille.pixels(); k++) {
            if (lue.getRGB(k % taille.largeur, k / taille.largeur) != image.getCouleur(k).getCode()) {
                throw new IllegalStateException("image fausse : " + methode.cle() + ", pixel (" + k % taille.largeur + ", "
                        + k / taille.largeur + ")");
            }
        }
        return champs(comptes(comptes) + " " + (auto ? taille.pixels() : verifier(dessin, scene, image, taille)));
    }
}
