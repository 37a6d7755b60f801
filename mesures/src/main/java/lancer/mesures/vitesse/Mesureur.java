package lancer.mesures.vitesse;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import lancer.Constantes;
import lancer.Scene;
import lancer.mesures.Circonstances;
import lancer.mesures.Intervalle;
import lancer.mesures.Lancement;
import lancer.mesures.juge.PovRay;
import lancer.mesures.juge.SceneJugee;
import lancer.mesures.scenes.Scenes;
import lancer.mesures.stabilite.Noyau;

/** Mesure un groupe après l'autre, et écrit chaque résultat dès qu'il est connu. */
final class Mesureur {

    /** Programme que construit le Makefile, si Embree est installé. */
    static final Path EMBREE = Paths.get("mesures", "target", "embree");

    /** Nombre de manches d'un programme entier, et d'un calcul de distance. */
    private static final int PROGRAMMES = 6;
    private static final int NOYAUX = 9;

    private final boolean court;
    private final Path csv;
    private final Path dossier;

    private final PrintStream sortie;
    private final Manches manches;
    private final PovRay povray;
    private final Circonstances circonstances = new Circonstances();

    /** Arguments de {@code java} pour lancer le programme d'une méthode. */
    private final Function<Methode, String[]> lancer;

    private Taille taille;

    /**
     * @param povray {@code null} s'il n'est pas installé
     * @param csv fichier des résultats ; les fichiers provisoires sont à côté
     * @param lancer arguments de {@code java} pour lancer le programme d'une méthode
     */
    Mesureur(boolean court, PovRay povray, Path csv, PrintStream sortie, Function<Methode, String[]> lancer) throws IOException {
        this.court = court;
        this.csv = csv;
        this.sortie = sortie;
        this.lancer = lancer;
        this.povray = povray;
        dossier = Files.createDirectories(csv.resolveSibling("provisoire"));
        manches = new Manches(new Etalon()::estCalme, court);
        sortie.println(circonstances.machine + ", " + circonstances.jvm + ", commit " + circonstances.commit);
        Files.write(csv, Collections.singletonList(String.join(",", Releve.COLONNES)));
    }

    /** @throws IOException si la machine n'est pas assez souvent disponible */
    void mesurer(Taille images, List<Catalogue.Groupe> groupes) throws IOException {
        taille = images;
        long debut = System.nanoTime();
        for (Catalogue.Groupe groupe : groupes) {
            long secondes = (System.nanoTime() - debut) / 1_000_000_000;
            sortie.println(groupe.famille + ", " + groupe.scene + ", " + taille + ", à " + secondes + " s");
            groupe.methodes.removeIf(m -> m.povray && povray == null || m.nom.equals(Catalogue.EMBREE) && !Files.isExecutable(EMBREE));
            if (groupe.famille.equals(Catalogue.INTERSECTIONS)) {
                enNoyaux(groupe);
            } else {
                enProcessus(groupe, Scenes.fichier(groupe.scene, dossier));
            }
        }
    }

    private void enNoyaux(Catalogue.Groupe groupe) throws IOException {
        for (Methode methode : groupe.methodes) {
            noter(groupe, methode, 1, new HashMap<>(), manches.mesurer(noyau(groupe.scene, groupe.methodes.get(0).nom),
                    noyau(groupe.scene, methode.nom), court ? 1 : NOYAUX));
        }
    }

    private Manches.Echantillon noyau(String regime, String formule) {
        return () -> Arrays.stream(new Lancement(dossier.resolve("pris"), Lancement.JAVA, "-cp", System.getProperty("java.class.path"),
                Noyau.class.getName(), regime, formule).reussi().derniereLigne().split(" ")).mapToDouble(Double::parseDouble).toArray();
    }

    private void enProcessus(Catalogue.Groupe groupe, Path fichier) throws IOException {
        for (Methode methode : groupe.methodes) {
            Map<String, String> champs = new HashMap<>();
            // le programme est comparé à lui-même sur une seule sphère ; les autres, à lui sur la même scène
            boolean leNotre = methode.nom.equals(Catalogue.PROGRAMME);
            Programme repere = new Programme("repere.png", leNotre ? Scenes.fichier("foule-1", dossier) : fichier,
                    new Methode(Catalogue.UN_RAYON, ""));
            Path sien = avec(methode, fichier);
            Scene scene = Scenes.lire(sien);
            Programme programme = new Programme("image.png", sien, methode);
            Manches.Echantillon echantillon = programme;
            if (methode.povray) {
                SceneJugee jugee = new SceneJugee(povray, groupe.scene, Scenes.lire(fichier), Constantes.MAX_REFLETS, taille.largeur,
                        taille.hauteur);
                echantillon = () -> {
                    jugee.dessiner(methode.options);
                    return povray.pris();
                };
            } else if (methode.nom.equals(Catalogue.EMBREE)) {
                echantillon = () -> new Lancement(dossier.resolve("pris"), EMBREE, fichier, taille.largeur, taille.hauteur, taille.fils,
                        dossier.resolve("embree.ppm")).reussi().pris;
            }
            // un premier passage charge le cache du disque
            repere.prendre();
            echantillon.prendre();
            Manches.Temps temps = manches.mesurer(repere, echantillon, court ? 2 : PROGRAMMES);
            if (methode.nom.equals(Catalogue.EMBREE)) {
                Controle.comparer(dossier.resolve("embree.ppm"), repere.png, taille);
            } else if (methode.boucles) {
                if (!Arrays.equals(Files.readAllBytes(programme.png), Files.readAllBytes(repere.png))) {
                    throw new IllegalStateException("image fausse : " + groupe.scene + ", " + taille + ", " + methode.nom + " "
                            + methode.parametres);
                }
                champs.put("pixels_verifies", String.valueOf(taille.pixels()));
            } else if (!methode.povray) {
                champs.putAll(Controle.controler(methode, scene, taille, programme.png));
            }
            noter(groupe, methode, scene.getObjets().size(), champs, temps);
        }
        Files.deleteIfExists(dossier.resolve(groupe.scene + ".pov"));
    }

    /** La scène, avec la section de cette méthode. */
    private Path avec(Methode methode, Path fichier) throws IOException {
        return methode.section.isEmpty() ? fichier : Files.write(dossier.resolve("changee.ini"), (new String(Files.readAllBytes(fichier),
                StandardCharsets.UTF_8) + "\n" + methode.section).getBytes(StandardCharsets.UTF_8));
    }

    /** Un programme entier, de la commande au PNG écrit. */
    private final class Programme implements Manches.Echantillon {

        private final Path png;
        private final List<Object> commande;

        Programme(String image, Path fichier, Methode methode) {
            png = dossier.resolve(image);
            commande = new ArrayList<>(Collections.singletonList(Lancement.JAVA));
            commande.addAll(methode.machine);
            commande.addAll(Arrays.asList(lancer.apply(methode)));
            commande.addAll(Arrays.asList("--image", png, "--taille", taille, fichier));
            commande.addAll(Arrays.asList(methode.options));
        }

        @Override
        public double[] prendre() throws IOException {
            return new Lancement(dossier.resolve("pris"), commande.toArray()).reussi().pris;
        }
    }

    private void noter(Catalogue.Groupe groupe, Methode methode, int spheres, Map<String, String> champs, Manches.Temps temps)
            throws IOException {
        Circonstances c = circonstances;
        double reference = temps.reference() / 1e6;
        Intervalle rapport = temps.rapport();
        champs.putAll(Releve.champs("machine", c.machine, "coeurs", c.coeurs, "jvm", c.jvm, "date", c.date, "commit", c.commit, "famille",
                groupe.famille, "scene", groupe.scene, "spheres", spheres, "methode", methode.nom, "parametres", methode.parametres,
                "largeur", taille.largeur, "hauteur", taille.hauteur, "fils", taille.fils, "manches", temps.manches, "jetees",
                temps.jetees(), "reference_ms", Releve.reel(reference), "processeur_ms",
                Releve.reel(temps.cout(Manches.PROCESSEURS) / 1e6), "memoire_mo",
                Releve.reel(temps.cout(Manches.MEMOIRE) / (1 << 20)), "rapport", Releve.reel(rapport.valeur),
                "rapport_min", Releve.reel(rapport.min), "rapport_max", Releve.reel(rapport.max)));
        String ligne = new Releve(champs).ligne(Releve.COLONNES);
        Files.write(csv, Collections.singletonList(ligne), StandardCharsets.UTF_8, StandardOpenOption.APPEND);
        sortie.println(String.format(Locale.ROOT, "  %-17s %-40s %10.4g × %8.4g – %-8.4g %10.4g ms %2d/%d", methode.nom,
                methode.parametres, rapport.valeur, rapport.min, rapport.max, rapport.valeur * reference, temps.couts.size(),
                temps.manches));
    }
}
