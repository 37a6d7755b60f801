package lancer.mesures.vitesse;

import java.io.IOException;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
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
import java.util.stream.IntStream;
import lancer.Constantes;
import lancer.Lancer;
import lancer.Scene;
import lancer.contrat.Compteurs;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Releve;
import lancer.dessin.Dessin;
import lancer.mesures.Circonstances;
import lancer.mesures.Gabarit;
import lancer.mesures.ImageLineaire;
import lancer.mesures.Intervalle;
import lancer.mesures.Lancement;
import lancer.mesures.juge.PovRay;
import lancer.mesures.juge.SceneJugee;
import lancer.mesures.scenes.Scenes;

/** Mesure les groupes du {@link Catalogue} : ce qui se compte, dans ce processus ; les temps, par les commandes mêmes d'un utilisateur. */
final class Mesureur {

    /** Programme que construit le Makefile, si Embree est installé. */
    static final Path EMBREE = Paths.get("mesures", "target", "embree");

    /**
     * Nombre de manches, dont le moindre temps est gardé : chacune lance une fois l'unité, puis chaque réglage du groupe. Après tant de
     * nanosecondes, celles qui sont au-delà de la troisième ne sont pas faites.
     */
    private static final int MANCHES = 5;
    private static final int MANCHES_LONGUES = 3;
    private static final double LONG = 20e9;

    /** Nombre maximal de rayons d'une référence. */
    private static final double VERITE = 6e7;

    /** Charge de la machine, et étendue relative des temps de l'unité, au-dessus desquelles elle est occupée. */
    private static final double CHARGE = 0.5;
    private static final double ETENDUE = 0.15;

    /** Ce que dit la machine d'un temps écoulé qu'elle a mesuré en faisant autre chose. */
    static final String OCCUPEE = " ; machine occupée";

    private final Path dossier;
    private final PrintStream sortie;
    private final PovRay povray;
    private final int manches;

    /** Taille des images. */
    private final Taille taille;

    /** Arguments de {@code java} qui lancent le programme d'un réglage. */
    private final Function<Reglage, List<String>> programme;
    private final Circonstances circonstances = new Circonstances();

    /** La vérité de la dernière scène comptée : deux groupes qui se suivent ont souvent la même. */
    private Gabarit gabarit;
    private String sceneDuGabarit;

    /** Une commande que l'on peut répéter. */
    private interface Commande {

        /** Temps réel et temps des processeurs, en nanosecondes, puis mémoire, en octets, NaN si elle n'est pas connue. */
        double[] prendre() throws IOException;
    }

    /**
     * @param dossier celui des fichiers provisoires
     * @param povray {@code null} s'il n'est pas installé
     * @param taille celle des images
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

    /** Note les rayons, les examens et l'erreur de chaque réglage, dans ce processus, sur un pavé de l'image sur quatre. */
    void compter(Groupe groupe, Resultats resultats) throws IOException {
        sortie.println("rayons et erreurs de " + groupe.scene + ", " + groupe.volet);
        Scene scene = Scenes.lire(Scenes.fichier(groupe.scene, dossier));
        Lancer prepare = Dessin.lancer(scene, taille.largeur, taille.hauteur, false);
        if (!groupe.scene.equals(sceneDuGabarit)) {
            Lancer sansLimite = Reglage.UN_RAYON.par("", "", "--reflets", String.valueOf(Gabarit.PROFONDEUR), "--seuil", "0")
                    .lancer(prepare);
            dessiner(sansLimite, Gabarit.PROFONDEUR);
            int pas = (int) Math.ceil(Math.sqrt(Gabarit.RAYONS * sansLimite.getAtelier().getCompteurs().rayons() / VERITE));
            gabarit = new Gabarit(scene, taille.largeur, taille.hauteur, pas, Gabarit.COTE, Gabarit::dunPaveSurQuatre);
            sceneDuGabarit = groupe.scene;
        }
        for (Groupe.Essai essai : groupe.essais) {
            Mesure m = resultats.noter(groupe, essai);
            ImageLineaire image = compter(essai.reglage, prepare, m);
            m.erreur = Intervalle.deLaRacine(gabarit.carres(image));
            m.visibles = gabarit.visibles(image);
            m.compte = circonstances.commit + " " + jour();
        }
    }

    /** Note les rayons et les examens d'un réglage. @return l'image, dont seul un pavé sur quatre est dessiné */
    ImageLineaire compter(Reglage reglage, Lancer prepare, Mesure m) {
        Lancer lancer = reglage.lancer(prepare);
        ImageLineaire image = dessiner(lancer, reglage.profondeur());
        Compteurs comptes = lancer.getAtelier().getCompteurs();
        double part = IntStream.range(0, taille.pixels()).filter(k -> Gabarit.dunPaveSurQuatre(k % taille.largeur, k / taille.largeur))
                .count() / (double) taille.pixels();
        m.rayons = comptes.rayons() / part;
        m.examens = (comptes.testsSpheres + comptes.noeudsVisites) / part;
        return image;
    }

    private ImageLineaire dessiner(Lancer lancer, int profondeur) {
        ImageLineaire image = new ImageLineaire(taille.largeur, taille.hauteur);
        Echantillonnage entier = lancer.getEchantillonnage();
        lancer.getAtelier().dessiner((pave, voulus, vue, toile) -> Gabarit.dunPaveSurQuatre(pave.i0, pave.j0)
                ? entier.tracer(pave, voulus, vue, toile) : Releve.RIEN, lancer.getVues(profondeur), image, taille.fils);
        return image;
    }

    Lancement lancer(Reglage reglage, Path fichier, Object... sorties) throws IOException {
        Path scene = fichier;
        if (!reglage.section.isEmpty()) {
            scene = dossier.resolve("changee.ini");
            Files.write(scene, (new String(Files.readAllBytes(fichier), StandardCharsets.UTF_8) + "\n" + reglage.section)
                    .getBytes(StandardCharsets.UTF_8));
        }
        List<Object> commande = new ArrayList<>(Collections.singletonList(Lancement.JAVA));
        commande.addAll(reglage.machine());
        commande.addAll(programme.apply(reglage));
        commande.addAll(Arrays.asList("--taille", taille, scene));
        commande.addAll(Arrays.asList(sorties));
        commande.addAll(reglage.options);
        return new Lancement(dossier.resolve("pris"), commande.toArray()).reussi();
    }

    // ---- ce qui se chronomètre

    /**
     * Note le moindre temps de chaque réglage, et celui de l'unité ; et si la machine faisait autre chose, ce qui ôte son sens à un temps
     * écoulé.
     */
    void chronometrer(Groupe groupe, Resultats resultats) throws IOException {
        Path fichier = Scenes.fichier(groupe.scene, dossier);
        Path unite = Scenes.fichier(groupe.sceneUnite, dossier);
        groupe.essais.removeIf(e -> e.reglage.methode.equals(Reglage.POVRAY) && povray == null
                || e.reglage.methode.equals(Reglage.EMBREE) && !Files.isExecutable(EMBREE));
        List<Commande> commandes = new ArrayList<>(Collections.singletonList(() -> image(Reglage.UN_RAYON, unite)));
        for (Groupe.Essai essai : groupe.essais) {
            commandes.add(commande(essai.reglage, fichier));
        }
        double charge = ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
        sortie.println(groupe.volet + ", " + groupe.scene + " : " + commandes.size() + " commandes, " + manches + " manches");
        List<double[][]> pris = new ArrayList<>();
        long debut = System.nanoTime();
        while (pris.size() < Math.min(manches, System.nanoTime() - debut < LONG ? MANCHES : MANCHES_LONGUES)) {
            double[][] manche = new double[commandes.size()][];
            for (int k = 0; k < manche.length; k++) {
                manche[k] = commandes.get(k).prendre();
            }
            pris.add(manche);
        }
        double etendue = pris.stream().mapToDouble(p -> p[0][0]).max().getAsDouble() / moindre(pris, 0, 0) - 1;
        boolean occupee = groupe.volet.equals(Catalogue.FILS) && manches > 1 && (charge > CHARGE || etendue > ETENDUE);
        // un réglage que ce groupe n'a plus a été chronométré dans d'autres conditions
        resultats.volet(groupe.volet).scene(groupe.scene).toutes.forEach(Mesure::oublierLesTemps);
        for (int k = 1; k < commandes.size(); k++) {
            Mesure m = resultats.noter(groupe, groupe.essais.get(k - 1));
            noter(m, pris, k);
            m.machine += occupee ? OCCUPEE : "";
        }
    }

    private String jour() {
        return circonstances.date.replaceFirst("T.*", "");
    }

    private void noter(Mesure m, List<double[][]> pris, int commande) {
        m.unite = moindre(pris, 0, 1) / 1e9;
        m.processeurs = moindre(pris, commande, 1) / 1e9;
        m.mur = moindre(pris, commande, 0) / 1e9;
        m.memoire = moindre(pris, commande, 2) / (1 << 20);
        m.chronometre = circonstances.commit + " " + jour();
        m.machine = (circonstances.machine + " ; " + circonstances.coeurs + " cœurs ; " + circonstances.jvm).replace(',', ' ');
        sortie.println(String.format(Locale.ROOT, "  %-45s %8.4g s de processeur, × %.4g", m.nom(), m.processeurs, m.rapport()));
    }

    private static double moindre(List<double[][]> pris, int commande, int rang) {
        return pris.stream().mapToDouble(p -> p[commande][rang]).min().getAsDouble();
    }

    private Commande commande(Reglage reglage, Path fichier) throws IOException {
        if (reglage.methode.equals(Reglage.POVRAY)) {
            SceneJugee jugee = new SceneJugee(povray, "povray", Scenes.lire(fichier), Constantes.MAX_REFLETS, taille.largeur,
                    taille.hauteur);
            return () -> {
                jugee.dessiner();
                return povray.pris();
            };
        }
        if (reglage.methode.equals(Reglage.EMBREE)) {
            return () -> new Lancement(dossier.resolve("pris"), EMBREE, fichier, taille.largeur, taille.hauteur, taille.fils,
                    dossier.resolve("embree.ppm")).reussi().pris;
        }
        return () -> image(reglage, fichier);
    }

    private double[] image(Reglage reglage, Path fichier) throws IOException {
        return lancer(reglage, fichier, "--image", dossier.resolve("image.png")).pris;
    }
}
