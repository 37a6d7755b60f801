package lancer.correction;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.channels.FileChannel;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.security.SecureRandom;
import java.time.LocalDateTime;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.IntSummaryStatistics;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lancer.correction.depot.Depot;
import lancer.correction.depot.Rendu;
import lancer.correction.depot.Source;
import lancer.correction.enfant.Texte;
import lancer.correction.isolement.Confinement;
import lancer.correction.jugement.DossierDeResultats;
import lancer.correction.jugement.GrilleDeNotation;
import lancer.correction.jugement.Jury;
import lancer.correction.jugement.Resultat;
import lancer.correction.modele.SourcesDuCours;
import lancer.correction.note.Ajustements;
import lancer.correction.note.Bareme;
import lancer.correction.note.Eleve;
import lancer.correction.note.FeuilleMoodle;
import lancer.correction.note.Ressemblances;
import lancer.correction.note.Sorties;
import lancer.correction.page.Pages;
import org.apache.commons.io.function.IORunnable;
import org.apache.commons.io.function.Uncheck;

/** La ligne de commande : juge les rendus d'une classe et les note, ou écrit le projet à compléter. */
public final class Correction {

    private static final String RENDUS = "RENDUS";
    private static final List<String> AVEC_VALEUR =
            List.of("--notes", "--sortie", "--bareme", "--corrige", "--variante", "--squelette");

    /** Les options données avec leur valeur, vide si elles n'en ont pas ; {@code RENDUS}, les rendus à juger. */
    private final Map<String, String> demande = new HashMap<>();
    private final PrintStream sortie;
    private final PrintStream suivi;
    private final BiFunction<Confinement, Long, Jury> jurys;

    /** @throws Panne si un argument est refusé */
    private Correction(String[] arguments, PrintStream sortie, PrintStream suivi, BiFunction<Confinement, Long, Jury> jurys) {
        this.jurys = jurys;
        this.sortie = sortie;
        this.suivi = suivi;
        for (int k = 0; k < arguments.length && !demande.containsKey("--aide"); k++) {
            String nom = arguments[k];
            if (List.of("--aide", "--help", "-h", "--sans-confinement", "--noter", "--neuf", "--un", "--profil-bwrap").contains(nom)) {
                demande.put(nom.matches("--help|-h") ? "--aide" : nom, "");
            } else if (AVEC_VALEUR.contains(nom)) {
                if (++k >= arguments.length || arguments[k].isEmpty()) {
                    throw new Panne(2, "option sans sa valeur : " + nom);
                }
                demande.put(nom, arguments[k]);
            } else if (nom.startsWith("-")) {
                throw new Panne(2, "option inconnue : « " + nom + " » ; attendu : une de celles que montre --aide");
            } else if (demande.putIfAbsent(RENDUS, nom) != null) {
                throw new Panne(2, "plusieurs rendus : « " + demande.get(RENDUS) + " » et « " + nom
                        + " » ; attendu : un dossier, ou une archive");
            }
        }
        if (Collections.disjoint(demande.keySet(), List.of(RENDUS, "--aide", "--profil-bwrap", "--noter", "--squelette", "--corrige"))) {
            throw new Panne(2, "aucun rendu à noter ; attendu : un dossier, ou l'archive de Moodle");
        } else if (demande.containsKey("--noter") && !Collections.disjoint(demande.keySet(), List.of(RENDUS, "--neuf", "--un"))) {
            throw new Panne(2, "--noter ne prend pas de rendus : il note ceux qui ont été jugés");
        }
    }

    /** @param args voir {@code --aide} */
    public static void main(String[] args) {
        System.exit(executer(args, avecAccents(System.out, "stdout.encoding"), avecAccents(System.err, "stderr.encoding"), Jury::new));
    }

    /** Ce flux ou, si son codage n'a pas les accents (C, POSIX), le même en UTF-8. @param propriete celle qui nomme ce codage */
    private static PrintStream avecAccents(PrintStream flux, String propriete) {
        Charset codage = Charset.forName(System.getProperty(propriete, Charset.defaultCharset().name()));
        return codage.newEncoder().canEncode('é') ? flux : new PrintStream(flux, true, StandardCharsets.UTF_8);
    }

    /** @return le statut de sortie ; pour 1 et 2, une ligne a été écrite sur {@code erreur} */
    static int executer(String[] args, PrintStream sortie, PrintStream erreur, BiFunction<Confinement, Long, Jury> jurys) {
        try {
            Correction correction = new Correction(args, sortie, erreur, jurys);
            Map<String, String> demande = correction.demande;
            if (demande.containsKey("--aide")) {
                sortie.print(SourcesDuCours.ressource("aide.txt"));
            } else if (demande.containsKey("--profil-bwrap")) {
                sortie.print(SourcesDuCours.ressource("bwrap.apparmor"));
            } else if (demande.containsKey("--squelette")) {
                SourcesDuCours.ecrire(demande.get("--squelette"), null, sortie);
            } else if (demande.containsKey("--corrige")) {
                SourcesDuCours.ecrire(demande.get("--corrige"), demande.getOrDefault("--variante", ""), sortie);
            } else {
                Path dossier = Files.createDirectories(Path.of(demande.getOrDefault("--sortie", "correction/classe"))).toRealPath();
                // une feuille de notes fautive est refusée avant de juger toute la classe
                FeuilleMoodle feuille = demande.containsKey("--notes") ? new FeuilleMoodle(Path.of(demande.get("--notes"))) : null;
                if (demande.containsKey(RENDUS)) {
                    correction.juger(dossier);
                }
                correction.seul(dossier, () -> correction.noter(dossier, feuille));
            }
            return 0;
        } catch (Panne e) {
            erreur.println("correction : " + Texte.protege(e.getMessage(), Integer.MAX_VALUE));
            return e.code;
        } catch (IOException e) {
            erreur.println("correction : lecture ou écriture impossible : " + Texte.protege(Sorties.raison(e)));
            return 1;
        }
    }

    /** Fait ce travail seul : un autre correcteur du même dossier, ou un autre fil, attend. */
    private void seul(Path dossier, IORunnable travail) throws IOException {
        synchronized (Correction.class) {
            try (FileChannel verrou = FileChannel.open(dossier.resolve(".verrou"), StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
                verrou.lock();
                travail.run();
            }
        }
    }

    /** Juge chaque rendu, et écrit son résultat dès qu'il est jugé. */
    private void juger(Path dossier) throws IOException {
        Confinement confinement = Confinement.essayer();
        if (!confinement.confine && !demande.containsKey("--sans-confinement")) {
            throw new Panne(1, "rien n'a été exécuté : " + confinement.manque
                    + " ; sinon, un conteneur (docs/confinement.md) ; à défaut, pour exécuter quand même le code des étudiants, qui pourra "
                    + "lire et écrire vos fichiers : SANS_CONFINEMENT=1 (--sans-confinement)");
        }
        DossierDeResultats resultats = new DossierDeResultats(dossier);
        long[] graine = new long[1];
        seul(dossier, () -> graine[0] = graine(dossier.resolve("graine.txt")));
        try (Jury jury = jurys.apply(confinement, graine[0])) {
            List<Rendu> rendus = Depot.lire(Path.of(demande.get(RENDUS)), demande.containsKey("--un"));
            suivi.println("correction : " + compter(rendus.stream().mapToInt(r -> r.entrees.size())) + " ; le corrigé d'abord");
            GrilleDeNotation grille = jury.reference().grille;
            seul(dossier, () -> {
                if (demande.containsKey("--neuf")) {
                    mettreDeCote(dossier);
                }
                resultats.ecrire(grille);
            });
            if (!demande.containsKey("--neuf")) {
                resultats.remplaces(rendus).forEach(r -> suivi.println("correction : un autre travail va remplacer celui de « "
                        + Texte.protege(r) + " » ; pour le garder : Ctrl+C, et --sortie (SORTIE=) dans un autre dossier"));
            }
            AtomicInteger finis = new AtomicInteger();
            jury.juger(rendus, resultat -> {
                Uncheck.accept(resultats::ecrire, resultat);
                String fin = resultat.refus.isEmpty() ? "jugé" : Texte.protege(resultat.refus.get(0));
                suivi.println("correction : " + finis.incrementAndGet() + "/" + rendus.size() + " " + resultat.qui() + " : " + fin
                        + (resultat.remplace.isEmpty() ? "" : " ; " + resultat.remplace));
            });
        }
    }

    /** @param entrees le nombre d'entrées de chaque ligne */
    private static String compter(IntStream entrees) {
        IntSummaryStatistics toutes = entrees.summaryStatistics();
        return Texte.compter(toutes.getSum(), "entrée") + ", " + Texte.compter(toutes.getCount(), "ligne");
    }

    /** Met de côté ce qui a été jugé avant. */
    private void mettreDeCote(Path dossier) throws IOException {
        String date = LocalDateTime.now().format(DateTimeFormatter.ofPattern("yyyy-MM-dd HH'h'mm'm'ss"));
        for (String nom : List.of("resultats", "etudiants")) {
            if (Files.exists(dossier.resolve(nom))) {
                Path avant = Files.createDirectories(dossier.resolve("avant " + date));
                Files.move(dossier.resolve(nom), avant.resolve(nom));
            }
        }
    }

    /**
     * Le nombre d'où viennent les rayons, les sphères et les lampes des vérifications. Il est tiré au hasard une fois pour toute la classe,
     * et seul l'enseignant le change.
     */
    private static long graine(Path fichier) throws IOException {
        if (!Files.exists(fichier)) {
            Files.writeString(fichier, new SecureRandom().nextInt(Integer.MAX_VALUE) + "\n");
        }
        String texte = Source.decoder(Files.readAllBytes(fichier)).trim();
        if (!texte.matches("\\d{1,18}")) {
            throw new Panne(2, fichier + " : « " + Texte.protege(texte) + " » ; attendu : un nombre entier");
        }
        return Long.parseLong(texte);
    }

    /** Calcule les notes, les pages et les feuilles, à partir des résultats, du barème, des ajustements et de la feuille donnée. */
    private void noter(Path dossier, FeuilleMoodle feuille) throws IOException {
        DossierDeResultats juges = new DossierDeResultats(dossier);
        GrilleDeNotation grille = juges.grille();
        List<Resultat> resultats = juges.resultats();
        Bareme bareme = new Bareme(Path.of(demande.getOrDefault("--bareme", dossier + "/bareme.ini")), grille,
                feuille == null ? 0 : feuille.sur);
        List<String> ids = resultats.stream().map(r -> r.id).collect(Collectors.toList());
        Ajustements ajustements = new Ajustements(dossier, ids, grille, bareme);
        List<Eleve> eleves = resultats.stream().map(r -> new Eleve(r, DossierDeResultats.nom(r.id) + ".html", grille, bareme,
                ajustements.de(r.id))).collect(Collectors.toList());
        eleves.sort(Comparator.comparing((Eleve e) -> e.resultat.nom, Depot::comparer).thenComparing(e -> e.resultat.id, Depot::comparer));
        List<String> avis = new ArrayList<>();
        Sorties sorties = new Sorties();
        Ressemblances.dire(eleves, avis);
        Collection<Eleve> sansNote = feuille == null ? List.of() : feuille.ecrire(dossier, eleves, avis, sorties);
        ajustements.ecrireARemplir(dossier, eleves, sorties);
        List<Eleve> manques = new Pages(grille, bareme).ecrire(dossier, eleves, compter(resultats.stream()
                .mapToInt(r -> r.entrees.size())), avis, sorties);
        avis.forEach(a -> suivi.println("correction : " + Texte.protege(a)));
        sortie.println("La classe : " + dossier.resolve("index.html"));
        if (eleves.stream().anyMatch(e -> !e.illisible() && !e.aNoter().isEmpty())) {
            sortie.println("À noter vous-même : " + dossier.resolve("ajustements-a-remplir.csv") + ", puis make noter");
        }
        if (feuille != null) {
            FeuilleMoodle.ecrireRetours(dossier, eleves);
            if (!sansNote.isEmpty()) {
                suivi.println("correction : absents de la feuille, ou que Moodle y a verrouillés : "
                        + sansNote.stream().map(e -> e.resultat.qui()).collect(Collectors.joining(", ")));
            }
            sortie.println("À déposer dans Moodle : " + dossier.resolve("notes-a-deposer.csv") + " et "
                    + dossier.resolve("retours.zip"));
        }
        String nonCorriges = eleves.stream().map(e -> e.resultat).filter(r -> r.nonCorrige).map(Resultat::qui)
                .collect(Collectors.joining(", "));
        if (!nonCorriges.isEmpty()) {
            throw new Panne(1, "non corrigés, sans que ce soit de leur faute ; à juger de nouveau : " + nonCorriges);
        } else if (!manques.isEmpty()) {
            throw new Panne(1, "des pages n'ont pas été écrites : " + manques.stream().map(e -> e.resultat.qui())
                    .collect(Collectors.joining(", ")));
        } else if (!sorties.aCote().isEmpty()) {
            throw new Panne(1, String.join(" ; ", sorties.aCote()));
        }
    }
}
