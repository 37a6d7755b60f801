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
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import lancer.Constantes;
import lancer.Main;
import lancer.atelier.Circonstances;
import lancer.atelier.Scenes;
import lancer.mesures.juge.PovRay;
import lancer.mesures.juge.SceneJugee;

/** Mesure un groupe après l'autre, et note chaque méthode dès qu'elle est finie. */
final class Mesureur {

    /** Programme que construit le Makefile, là où Embree est installé. */
    static final Path EMBREE = Paths.get("mesures", "target", "embree");

    /** Durée : d'ici à cinq fois plus, une manche est longue ; celles de POV-Ray le sont toutes. */
    private static final double LONGUE_NS = 1e9;

    /** Nombre de manches au-delà duquel elles n'apprendraient rien que la machine suivante ne démente. */
    private static final int MANCHES_MAX = 21;

    /** L'échauffement : tant de dessins, ou moins s'ils durent plus que cela. */
    private static final int ECHAUFFEMENT = 10;
    private static final long ECHAUFFEMENT_NS = TimeUnit.MILLISECONDS.toNanos(1500);

    /** Durée d'un échantillon, au moins : un dessin plus court y est répété. */
    private final double echantillonNs;

    private final boolean court;
    private final boolean agitee;
    private final Taille taille;
    private final Path csv;
    private final Path dossier;

    private final PrintStream sortie;
    private final Manches manches;
    private final PovRay povray;
    private final Circonstances circonstances = new Circonstances();

    /**
     * @param povray {@code null} s'il n'est pas installé
     * @param csv où noter ; ses temporaires sont à côté
     */
    Mesureur(boolean court, boolean agitee, Taille taille, PovRay povray, Path csv, PrintStream sortie) throws IOException {
        this.court = court;
        this.agitee = agitee;
        this.csv = csv;
        this.sortie = sortie;
        echantillonNs = TimeUnit.MILLISECONDS.toNanos(court || agitee ? 20 : 50);
        this.taille = taille;
        this.povray = povray;
        dossier = Files.createDirectories(csv.resolveSibling("provisoire"));
        manches = new Manches(new Etalon()::estCalme, agitee);
        sortie.println(circonstances.machine + ", " + circonstances.jvm + ", commit " + circonstances.commit);
        Files.write(csv, Collections.singletonList(String.join(",", Releve.COLONNES)));
    }

    /** @throws IOException si la machine ne nous est pas assez laissée */
    void mesurer(List<Catalogue.Groupe> groupes) throws IOException {
        long debut = System.nanoTime();
        for (Catalogue.Groupe groupe : groupes) {
            sortie.println(groupe.famille + ", " + groupe.scene + ", à " + (System.nanoTime() - debut) / 1_000_000_000 + " s");
            groupe.methodes.removeIf(m -> m.povray && (povray == null || !groupe.famille.equals(Catalogue.SPHERES))
                    || m.nom.equals(Catalogue.EMBREE) && !Files.isExecutable(EMBREE));
            Path fichier = groupe.famille.equals(Catalogue.INTERSECTIONS) ? null : Scenes.fichier(groupe.scene, dossier);
            if (groupe.famille.equals(Catalogue.SPHERES)) {
                enProcessus(groupe, fichier);
            } else {
                enDessins(groupe, fichier);
            }
        }
    }

    /**
     * Nombre de manches, autant qu'il en tient en quelques secondes : une seule est à la merci d'un accident, leur médiane non. De longues,
     * il y en a moins, mais chacune est déjà une moyenne. C'est décidé avant la première.
     */
    private int voulues(Catalogue.Groupe groupe, double mancheNs) {
        double tiennent = LONGUE_NS * (court ? 0.2 : groupe.lancements > 1 ? 2 : 2.5) / mancheNs;
        int moins = groupe.lancements > 1 || mancheNs > 5 * LONGUE_NS ? 3 : mancheNs > LONGUE_NS ? 4 : 5;
        return agitee ? 2 : (int) Math.max(moins, Math.min(MANCHES_MAX, tiennent));
    }

    /** Les mêmes, de programmes entiers. */
    private int voulues(Methode methode, int spheres) {
        boolean longue = spheres >= (methode.boucles ? 1000 : methode.povray ? 100_000 : 1_000_000);
        return methode.boucles && spheres >= Catalogue.BOUCLES_MAX ? 1 : court || agitee ? 2 : longue ? 3 : spheres > 10_000 ? 5 : 9;
    }

    // ---- des machines virtuelles qui durent

    private void enDessins(Catalogue.Groupe groupe, Path fichier) throws IOException {
        int spheres = fichier == null ? 1 : Scenes.lire(fichier).getObjets().size();
        int lancements = groupe.lancements;
        Map<Methode, Manches.Temps> temps = new HashMap<>();
        for (int lancement = 1; lancement <= lancements; lancement++) {
            try (Machine reperes = new Machine(groupe, groupe.methodes.get(0), fichier)) {
                for (Methode methode : groupe.methodes) {
                    Map<String, String> champs = new HashMap<>();
                    Manches.Temps pris = chronometrer(groupe, methode, fichier, reperes, champs);
                    temps.merge(methode, lancements > 1 ? pris.enUnRapport() : pris, Manches.Temps::plus);
                    if (lancement == lancements) {
                        champs.put("lancements", String.valueOf(lancements));
                        noter(groupe, methode, spheres, champs, temps.get(methode));
                    }
                }
            }
        }
    }

    /** @param champs où noter ce qui se compte et se vérifie, une fois les temps pris */
    private Manches.Temps chronometrer(Catalogue.Groupe groupe, Methode methode, Path fichier, Machine reperes,
            Map<String, String> champs) throws IOException {
        try (Machine machine = new Machine(groupe, methode, fichier)) {
            Manches.Temps temps = manches.mesurer(reperes, machine, voulues(groupe, reperes.dureeNs + machine.dureeNs));
            // d'une intersection, il n'y en a qu'un, vide
            String[] comptes = machine.demander("finir").split(" ");
            String[] noms = {"primaires", "ombre", "reflechis", "tests", "noeuds", "raffines", "pixels_verifies"};
            for (int k = 0; k < comptes.length; k++) {
                champs.put(noms[k], comptes[k]);
            }
            return temps;
        }
    }

    /** Un {@link Ouvrier}, échauffé. */
    private final class Machine extends Processus implements Manches.Echantillon {

        private final int fois;

        /** Durée d'un échantillon, à peu près. */
        private final double dureeNs;

        Machine(Catalogue.Groupe groupe, Methode methode, Path fichier) throws IOException {
            super(Ouvrier.class, groupe.famille, groupe.scene, methode.cle(), fichier, taille.largeur, taille.hauteur);
            long debut = System.nanoTime();
            double dessinNs = chronometrer(1)[0];
            for (int k = 1; k < (agitee ? 1 : ECHAUFFEMENT) && System.nanoTime() - debut < ECHAUFFEMENT_NS; k++) {
                dessinNs = chronometrer(1)[0];
            }
            fois = Math.max(1, (int) Math.ceil(echantillonNs / dessinNs));
            dureeNs = fois * dessinNs;
        }

        @Override
        public double[] prendre() throws IOException {
            return chronometrer(fois);
        }

        private double[] chronometrer(int combien) throws IOException {
            return Arrays.stream(demander(String.valueOf(combien)).split(" ")).mapToDouble(Double::parseDouble).toArray();
        }
    }

    // ---- le programme entier, lancé chaque fois

    private void enProcessus(Catalogue.Groupe groupe, Path fichier) throws IOException {
        int spheres = Scenes.lire(fichier).getObjets().size();
        for (Methode methode : groupe.methodes) {
            Map<String, String> champs = new HashMap<>();
            Programme programme = new Programme(fichier, methode.options);
            Manches.Echantillon echantillon = programme;
            if (methode.povray) {
                SceneJugee jugee = new SceneJugee(povray, groupe.scene, Scenes.lire(fichier), Constantes.MAX_REFLETS, taille.largeur,
                        taille.hauteur);
                echantillon = () -> {
                    jugee.dessiner(methode.options);
                    return new double[] {povray.dureeNs(), Double.NaN};
                };
            } else if (methode.nom.equals(Catalogue.EMBREE)) {
                echantillon = () -> parEmbree(fichier);
            }
            // le programme, face à lui-même sur une seule boule ; les autres, face à lui sur leur scène
            Programme repere = new Programme(methode.nom.equals(Catalogue.PROGRAMME) ? Scenes.fichier(Scenes.FOULE + "-1", dossier)
                    : fichier);
            Manches.Temps temps = manches.mesurer(repere, echantillon, voulues(methode, spheres));
            champs.put("lancements", String.valueOf(temps.rapports.length));
            if (methode.nom.equals(Catalogue.EMBREE)) {
                Ouvrier.comparer(dossier.resolve("embree.ppm"), repere.png, taille);
            } else if (echantillon == programme) {
                champs.putAll(programme.statistiques);
                // le moins qui en dise quelque chose quand chacun essaie un million de sphères par rayon
                int pixels = methode.boucles ? 0 : Math.max(64, Math.min(2000, 100_000_000 / spheres));
                Ouvrier.pixels(fichier, taille, pixels, programme.png);
                champs.put("pixels_verifies", String.valueOf(pixels));
            }
            noter(groupe, methode, spheres, champs, temps);
        }
        Files.deleteIfExists(dossier.resolve(groupe.scene + ".pov"));
    }

    /** Un programme en C++, de la scène à l'image ; il s'arrête avec le statut 1 s'il ne peut la lire ou l'écrire. */
    private double[] parEmbree(Path fichier) throws IOException {
        long debut = System.nanoTime();
        try (Processus pair = new Processus(EMBREE.toString(), fichier, taille.largeur, taille.hauteur, taille.fils,
                dossier.resolve("embree.ppm"))) {
            pair.lignes();
        }
        return new double[] {System.nanoTime() - debut, Double.NaN};
    }

    /** Temps du démarrage de Java au PNG écrit. */
    private final class Programme implements Manches.Echantillon {

        private final Path fichier;
        private final String[] options;
        private final Path png = dossier.resolve("image.png");

        /** Statistiques du dernier dessin, par nos noms de colonnes. */
        private Map<String, String> statistiques;

        Programme(Path fichier, String... options) {
            this.fichier = fichier;
            this.options = options;
        }

        @Override
        public double[] prendre() throws IOException {
            List<Object> args = new ArrayList<>(Arrays.asList("--image", png, "--taille", taille, "--statistiques", fichier));
            args.addAll(Arrays.asList(options));
            long debut = System.nanoTime();
            try (Processus processus = new Processus(Main.class, args.toArray())) {
                List<String> lignes = processus.lignes();
                long duree = System.nanoTime() - debut;
                statistiques = lignes.stream().map(l -> l.split(": ")).filter(l -> l.length == 2)
                        // « rayons.ombre » se note dans ombre, « tests.spheres » dans tests
                        .collect(Collectors.toMap(l -> l[0].replaceAll("^(rayons|pixels)\\.|\\.(spheres|visites)$", ""), l -> l[1],
                                (a, b) -> b));
                return new double[] {duree, Double.NaN};
            }
        }
    }

    private void noter(Catalogue.Groupe groupe, Methode methode, int spheres, Map<String, String> champs, Manches.Temps temps)
            throws IOException {
        Circonstances c = circonstances;
        champs.putAll(Releve.champs("machine", c.machine, "coeurs", c.coeurs, "jvm", c.jvm, "date", c.date, "commit", c.commit, "famille",
                groupe.famille, "scene", groupe.scene, "spheres", spheres, "methode", methode.nom, "parametres", methode.parametres,
                "largeur", taille.largeur, "hauteur", taille.hauteur, "fils", taille.fils, "manches", temps.manches, "jetees",
                temps.jetees, "reference_ms", Releve.reel(temps.referenceNs / 1e6), "rapport", Releve.reel(temps.rapport.valeur),
                "rapport_min", Releve.reel(temps.rapport.min), "rapport_max", Releve.reel(temps.rapport.max)));
        String ligne = new Releve(champs).ligne(Releve.COLONNES);
        Files.write(csv, Collections.singletonList(ligne), StandardCharsets.UTF_8, StandardOpenOption.APPEND);
        sortie.println(String.format(Locale.ROOT, "  %-17s %-40s %10.4g × %8.4g – %-8.4g %10.4g ms  %2d/%d", methode.nom,
                methode.parametres, temps.rapport.valeur, temps.rapport.min, temps.rapport.max,
                temps.rapport.valeur * temps.referenceNs / 1e6, temps.manches - temps.jetees, temps.manches));
    }
}
