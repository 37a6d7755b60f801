package lancer.correction;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import lancer.correction.depot.Depot;
import lancer.correction.depot.Rendu;
import lancer.correction.isolement.Confinement;
import lancer.correction.isolement.Limites;
import lancer.correction.jugement.Grille;
import lancer.correction.jugement.Jury;
import lancer.correction.modele.Modele;
import lancer.correction.modele.Squelette;
import lancer.correction.note.Ajustements;
import lancer.correction.note.Bareme;
import lancer.correction.note.FeuilleMoodle;
import lancer.correction.note.Note;
import lancer.correction.page.Pages;

/** Le programme : note les rendus d'une classe, ou écrit le projet à compléter. */
public final class Correction {

    private final Demande demande;
    private final PrintStream sortie;
    private final PrintStream suivi;

    private Correction(Demande demande, PrintStream sortie, PrintStream suivi) {
        this.demande = demande;
        this.sortie = sortie;
        this.suivi = suivi;
    }

    /** @param args voir {@code --aide} */
    public static void main(String[] args) {
        int code = executer(args, System.out, System.err);
        if (code != 0) {
            System.exit(code);
        }
    }

    /** @return le statut de sortie ; pour 1 et 2, une ligne a été écrite sur {@code erreur} */
    static int executer(String[] args, PrintStream sortie, PrintStream erreur) {
        try {
            Demande demande = new Demande(args);
            if (demande.aide) {
                sortie.print(Modele.ressource("aide.txt"));
            } else if (demande.valeur("--squelette") != null) {
                Squelette.ecrire(demande.valeur("--squelette"), null, sortie);
            } else if (demande.valeur("--corrige") != null) {
                String variante = demande.valeur("--variante");
                Squelette.ecrire(demande.valeur("--corrige"), variante == null ? "" : variante, sortie);
            } else {
                new Correction(demande, sortie, erreur).corriger();
            }
            return 0;
        } catch (Panne e) {
            erreur.println("correction : " + e.getMessage().replaceAll("\\s+", " "));
            return e.getCode();
        } catch (IOException e) {
            erreur.println("correction : lecture ou écriture impossible : " + e);
            return 1;
        }
    }

    private static String qui(Rendu rendu) {
        return rendu.nom + (rendu.nom.equals(rendu.id) ? "" : " (" + rendu.id + ")");
    }

    private void corriger() throws IOException {
        Path dossier = Files.createDirectories(demande.chemin("--sortie", Paths.get("correction", "classe"))).toRealPath();
        Path travail = Files.createDirectories(dossier.resolve(".travail"));
        // une feuille de notes qui ne convient pas se dit tout de suite, pas après avoir tout jugé
        Path notes = demande.chemin("--notes", null);
        FeuilleMoodle feuille = notes == null ? null : new FeuilleMoodle(notes);
        List<Rendu> rendus = Depot.lire(demande.rendus, travail);
        Confinement confinement = Confinement.essayer();
        if (!confinement.confine && !demande.sansConfinement) {
            throw new Panne(1, "rien n'a été exécuté : " + confinement.manque
                    + " ; pour exécuter quand même le code des étudiants, qui pourra lire et écrire vos fichiers : "
                    + "SANS_CONFINEMENT=1 (--sans-confinement)");
        }
        suivi.println("correction : " + rendus.size() + (rendus.size() > 1 ? " rendus" : " rendu")
                + " ; le corrigé d'abord");
        try (Jury jury = new Jury(travail, confinement, Limites.ORDINAIRES)) {
            Grille grille = new Grille(jury.reference);
            Bareme bareme = new Bareme(demande.chemin("--bareme", dossier.resolve("bareme.ini")), grille);
            List<String> criteres = grille.etapes.stream().map(e -> e.nom).collect(Collectors.toList());
            criteres.addAll(bareme.libres);
            Ajustements ajustements = new Ajustements(dossier.resolve("ajustements.csv"),
                    rendus.stream().map(r -> r.id).collect(Collectors.toList()), criteres);
            ajustements.fautes.forEach(f -> suivi.println("correction : " + f));
            Eleve[] classe = new Eleve[rendus.size()];
            AtomicInteger finis = new AtomicInteger();
            jury.juger(rendus, (rang, resultat) -> {
                Rendu rendu = rendus.get(rang);
                classe[rang] = new Eleve(rendu, resultat, new Note(grille, resultat, bareme, ajustements.de(rendu.id)),
                        String.format("%02d-%s.html", rang + 1, rendu.id.replaceAll("[^A-Za-z0-9-]+", "_")));
                suivi.println(String.format(Locale.FRANCE, "correction : %d/%d %s : %s", finis.incrementAndGet(), rendus.size(),
                        qui(rendu), classe[rang].illisible() ? resultat.refus.get(0)
                        : String.format(Locale.FRANCE, "%.2f/%.4g", classe[rang].note.total(), bareme.total())));
            });
            List<Eleve> eleves = List.of(classe);
            String nonCorriges = eleves.stream().filter(e -> e.resultat.nonCorrige).map(e -> qui(e.rendu))
                    .collect(Collectors.joining(", "));
            Eleve.comparer(eleves);
            Collection<Eleve> sansNote = feuille == null ? List.of() : feuille.ecrire(dossier, eleves, bareme);
            new Pages(grille, bareme, jury.reference, confinement).ecrire(dossier, eleves, ajustements.fautes);
            sortie.println("La classe : " + dossier.resolve("index.html"));
            if (feuille != null) {
                FeuilleMoodle.ecrireRetours(dossier, eleves);
                if (!sansNote.isEmpty()) {
                    suivi.println("correction : absents de la feuille, ou que Moodle y a verrouillés : "
                            + sansNote.stream().map(e -> qui(e.rendu)).collect(Collectors.joining(", ")));
                }
                sortie.println("À déposer dans Moodle : " + dossier.resolve("notes-a-deposer.csv") + " et "
                        + dossier.resolve("retours.zip"));
            }
            if (!nonCorriges.isEmpty()) {
                throw new Panne(1, "non corrigés, sans que ce soit de leur faute ; recommencer ne refera qu'eux : " + nonCorriges);
            }
        }
    }
}
