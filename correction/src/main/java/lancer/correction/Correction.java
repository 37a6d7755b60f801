package lancer.correction;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import lancer.correction.depot.Depot;
import lancer.correction.depot.Rendu;
import lancer.correction.enfant.Echange;
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

    private static final String RENDUS = "RENDUS";
    private static final List<String> AVEC_VALEUR =
            List.of("--notes", "--sortie", "--bareme", "--corrige", "--variante", "--squelette");

    /** Les options données, et ce qui suit chacune, vide si rien ne doit la suivre ; {@code RENDUS}, ce qu'il faut noter. */
    private final Map<String, String> demande = new HashMap<>();
    private final PrintStream sortie;
    private final PrintStream suivi;

    /** @throws Panne si un argument ne va pas */
    private Correction(String[] arguments, PrintStream sortie, PrintStream suivi) {
        this.sortie = sortie;
        this.suivi = suivi;
        for (int k = 0; k < arguments.length && !demande.containsKey("--aide"); k++) {
            String nom = arguments[k];
            if (List.of("--aide", "--help", "-h", "--sans-confinement").contains(nom)) {
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
        if (Collections.disjoint(demande.keySet(), List.of(RENDUS, "--aide", "--squelette", "--corrige"))) {
            throw new Panne(2, "aucun rendu à noter ; attendu : un dossier, ou l'archive de Moodle");
        }
    }

    /** @param args voir {@code --aide} */
    public static void main(String[] args) {
        System.exit(executer(args, System.out, System.err));
    }

    /** @return le statut de sortie ; pour 1 et 2, une ligne a été écrite sur {@code erreur} */
    static int executer(String[] args, PrintStream sortie, PrintStream erreur) {
        try {
            Correction correction = new Correction(args, sortie, erreur);
            Map<String, String> demande = correction.demande;
            if (demande.containsKey("--aide")) {
                sortie.print(Modele.ressource("aide.txt"));
            } else if (demande.containsKey("--squelette")) {
                Squelette.ecrire(demande.get("--squelette"), null, sortie);
            } else if (demande.containsKey("--corrige")) {
                Squelette.ecrire(demande.get("--corrige"), demande.getOrDefault("--variante", ""), sortie);
            } else {
                correction.corriger();
            }
            return 0;
        } catch (Panne e) {
            erreur.println("correction : " + Echange.protege(e.getMessage()));
            return e.code;
        } catch (IOException e) {
            erreur.println("correction : lecture ou écriture impossible : " + Echange.protege(e.toString()));
            return 1;
        }
    }

    private static String qui(Rendu rendu) {
        return rendu.nom + (rendu.nom.equals(rendu.id) ? "" : " (" + rendu.id + ")");
    }

    private void corriger() throws IOException {
        Path dossier = Files.createDirectories(Paths.get(demande.getOrDefault("--sortie", "correction/classe"))).toRealPath();
        Path travail = Files.createDirectories(dossier.resolve(".travail"));
        // une feuille de notes qui ne convient pas se dit tout de suite, pas après avoir tout jugé
        FeuilleMoodle feuille = demande.containsKey("--notes") ? new FeuilleMoodle(Paths.get(demande.get("--notes"))) : null;
        List<Rendu> rendus = Depot.lire(Paths.get(demande.get(RENDUS)), travail);
        Confinement confinement = Confinement.essayer();
        if (!confinement.confine && !demande.containsKey("--sans-confinement")) {
            throw new Panne(1, "rien n'a été exécuté : " + confinement.manque
                    + " ; pour exécuter quand même le code des étudiants, qui pourra lire et écrire vos fichiers : "
                    + "SANS_CONFINEMENT=1 (--sans-confinement)");
        }
        suivi.println("correction : " + rendus.size() + (rendus.size() > 1 ? " rendus" : " rendu")
                + " ; le corrigé d'abord");
        try (Jury jury = new Jury(travail, confinement, Limites.ORDINAIRES)) {
            Grille grille = new Grille(jury.reference);
            Bareme bareme = new Bareme(Paths.get(demande.getOrDefault("--bareme", dossier + "/bareme.ini")), grille);
            List<String> criteres = grille.etapes.stream().map(e -> e.nom).collect(Collectors.toList());
            criteres.addAll(bareme.libres);
            Ajustements ajustements = new Ajustements(dossier.resolve("ajustements.csv"),
                    rendus.stream().map(r -> r.id).collect(Collectors.toList()), criteres);
            ajustements.fautes.forEach(f -> suivi.println("correction : " + Echange.protege(f)));
            Eleve[] classe = new Eleve[rendus.size()];
            AtomicInteger finis = new AtomicInteger();
            jury.juger(rendus, (rang, resultat) -> {
                Rendu rendu = rendus.get(rang);
                classe[rang] = new Eleve(rendu, resultat, new Note(grille, resultat, bareme, ajustements.de(rendu.id)),
                        rendu.fichier(rang) + ".html");
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
