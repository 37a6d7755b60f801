package lancer.mesures.vitesse;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UnsupportedEncodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.SceneFautive;
import lancer.commande.Pannes;
import lancer.lecture.LecteurScene;
import lancer.mesures.Circonstances;
import lancer.mesures.stabilite.Stabilite;

/**
 * La vitesse face à la précision : mesure tout ce que dit le {@link Catalogue}, puis dessine les courbes et écrit les tableaux.
 *
 * <pre>
 * java -cp mesures/target/mesures.jar lancer.mesures.vitesse.Vitesse [--rapide] [--dessiner | --stabilite] [--dossier DOSSIER]
 * </pre>
 *
 * Chaque mesure est notée dès qu'elle est finie ; interrompue, la même commande reprend où elle en était. Statut de sortie : 0
 * tout est juste ; 1 une image est fausse, ou la machine n'a pas pu ; 2 la demande était fausse.
 */
public final class Vitesse {

    private static final String EMPREINTE = "empreinte.txt";
    private static final String SCENE = "scenes/scene1.ini";
    private static final String BESOINS = "besoins.csv";
    private static final Taille TAILLE_BESOINS = new Taille(800, 600, Runtime.getRuntime().availableProcessors());
    private static final Taille TAILLE_BESOINS_RAPIDE = new Taille(200, 150, Runtime.getRuntime().availableProcessors());

    private final OptionsVitesse options;
    private final PrintStream sortie;

    private Vitesse(OptionsVitesse options, PrintStream sortie) {
        this.options = options;
        this.sortie = sortie;
    }

    /** @param args voir la description de la classe */
    public static void main(String[] args) throws UnsupportedEncodingException {
        System.exit(executer(args, new PrintStream(System.out, true, "UTF-8"), new PrintStream(System.err, true, "UTF-8")));
    }

    /** Ce que fait {@link #main}, sans quitter Java. */
    static int executer(String[] args, PrintStream sortie, PrintStream erreurs) {
        // les courbes ne demandent pas d'écran, et un écran qui ne répond pas ne doit pas les empêcher
        System.setProperty("java.awt.headless", "true");
        try {
            return new Vitesse(OptionsVitesse.lire(args), sortie).faire();
        } catch (SceneFautive e) {
            erreurs.println("Vitesse : " + e.getMessage() + " ; à lancer à la racine du projet");
            return 2;
        } catch (IllegalArgumentException e) {
            erreurs.println("Vitesse : " + e.getMessage());
            return 2;
        } catch (IOException e) {
            erreurs.println("Vitesse : " + (e.getClass() == IOException.class ? e.getMessage() : e));
            return 1;
        } catch (RuntimeException | OutOfMemoryError e) {
            erreurs.println("Vitesse : " + Pannes.message(e));
            return 1;
        }
    }

    private int faire() throws IOException {
        if (options.dessiner) {
            new Rapport(options.resultats, options.atelier, sortie).ecrire(options.montres());
            return 0;
        }
        if (options.stabilite) {
            Files.createDirectories(options.resultats);
            Stabilite.mesurer(options.resultats, options.rapide);
            new Rapport(options.resultats, options.atelier, sortie).ecrire(options.montres());
            return 0;
        }
        long debut = System.nanoTime();
        commencer();
        if (!mesurer()) {
            return 1;
        }
        compterLesBesoins();
        sortie.println("stabilité");
        Stabilite.mesurer(options.atelier, options.rapide);
        if (!options.resultats.equals(options.atelier)) {
            Files.createDirectories(options.resultats);
            for (String nom : new String[] {Ouvrier.CSV, BESOINS, Stabilite.CSV}) {
                Files.copy(options.atelier.resolve(nom), options.resultats.resolve(nom), StandardCopyOption.REPLACE_EXISTING);
            }
        }
        new Rapport(options.resultats, options.atelier, sortie).ecrire(options.montres());
        // la prochaine fois, tout sera mesuré à nouveau
        Files.deleteIfExists(options.atelier.resolve(EMPREINTE));
        sortie.println("Fait en " + (System.nanoTime() - debut) / 1_000_000_000 + " s : " + options.resultats);
        return 0;
    }

    /** Reprend une mesure interrompue si elle est de ce programme et de cette machine ; sinon la met de côté. */
    private void commencer() throws IOException {
        // avant d'écrire quoi que ce soit : sommes-nous dans le projet ?
        LecteurScene.trouver(SCENE);
        Path empreinte = options.atelier.resolve(EMPREINTE);
        Path csv = options.atelier.resolve(Ouvrier.CSV);
        Circonstances circonstances = new Circonstances();
        String sienne = Empreinte.de(circonstances);
        Files.createDirectories(options.atelier);
        sortie.println(circonstances.machine + ", " + circonstances.jvm + ", commit " + circonstances.commit);
        if (Files.exists(csv) && Empreinte.est(empreinte, sienne)) {
            sortie.println("Reprise : " + new Journal(csv).lire().size() + " mesures déjà faites dans " + csv);
            return;
        }
        if (Files.exists(csv)) {
            Files.move(csv, options.atelier.resolve("vitesse-precedente.csv"), StandardCopyOption.REPLACE_EXISTING);
        }
        Files.write(empreinte, sienne.getBytes(StandardCharsets.UTF_8));
    }

    /** @return faux si une image est fausse, ou si une machine virtuelle s'est arrêtée */
    private boolean mesurer() throws IOException {
        boolean juste = true;
        List<Travail> travaux = Travail.tous(options.rapide);
        Journal journal = new Journal(options.atelier.resolve(Ouvrier.CSV));
        for (int k = 0; k < travaux.size(); k++) {
            Travail travail = travaux.get(k);
            Set<String> faites = journal.clesFaites();
            if (travail.methodes().stream().allMatch(m -> faites.contains(travail.scene + "/" + m.cle()))) {
                continue;
            }
            sortie.println(travail.nom() + " (" + (k + 1) + "/" + travaux.size() + ")");
            juste &= lancer(k) == 0;
        }
        return juste;
    }

    /** Chaque travail a sa machine virtuelle : le code n'y est compilé que pour lui. */
    private int lancer(int rang) throws IOException {
        Process processus = new ProcessBuilder(Paths.get(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
                System.getProperty("java.class.path"), Ouvrier.class.getName(), String.valueOf(rang), String.valueOf(options.rapide),
                options.atelier.toString()).inheritIO().start();
        try {
            return processus.waitFor();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("mesure interrompue");
        } finally {
            processus.destroy();
        }
    }

    /** Toutes les scènes livrées, dans l'ordre de leurs noms. */
    private void compterLesBesoins() throws IOException {
        List<Path> scenes = new ArrayList<>();
        try (Stream<Path> fichiers = Files.list(LecteurScene.trouver(SCENE).getParent())) {
            scenes.addAll(fichiers.filter(f -> f.toString().endsWith(".ini")).sorted().collect(Collectors.toList()));
        }
        List<String> lignes = new ArrayList<>();
        lignes.add(String.join(",", Besoin.COLONNES));
        for (Path scene : scenes) {
            lignes.add(new Besoin(scene, options.rapide ? TAILLE_BESOINS_RAPIDE : TAILLE_BESOINS).ligne());
            sortie.println("besoins de " + scene.getFileName());
        }
        Files.write(options.atelier.resolve(BESOINS), lignes, StandardCharsets.UTF_8);
    }
}
