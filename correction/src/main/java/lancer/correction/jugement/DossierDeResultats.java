package lancer.correction.jugement;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.correction.Panne;
import lancer.correction.depot.Rendu;
import lancer.correction.enfant.Compilateur;
import lancer.correction.enfant.Echange;

/** Le dossier {@code resultats} : un fichier par rendu, numérotés à partir de 001, et la grille du corrigé. Il n'est remplacé qu'entier. */
public final class DossierDeResultats {

    private static final String GRILLE = "corrige.csv";
    private static final Pattern RENDU = Pattern.compile("(\\d{3,9})-[A-Za-z0-9-]*");

    public final GrilleDeNotation grille;
    /** Les résultats par le nom de leur fichier, sans « .csv », dans l'ordre de leurs numéros. */
    public final Map<String, Resultat> resultats = new LinkedHashMap<>();

    /** @throws Panne si un résultat manque ou est abîmé */
    public DossierDeResultats(Path classe) {
        Path dossier = classe.resolve("resultats");
        Path lu = dossier.resolve(GRILLE);
        try {
            if (!Files.exists(dossier) && Files.exists(anciens(classe))) {
                // un remplacement interrompu
                Files.move(anciens(classe), dossier);
            }
            grille = GrilleDeNotation.lire(lu);
            try (Stream<Path> flux = Files.list(dossier)) {
                for (Path fichier : flux.filter(f -> numero(f) > 0).sorted(Comparator.comparing(DossierDeResultats::numero))
                        .collect(Collectors.toList())) {
                    lu = fichier;
                    resultats.put(nom(fichier), Resultat.lire(fichier));
                    if (numero(fichier) != resultats.size()) {
                        throw new Panne(2, "rien à noter : dans " + dossier + ", le rendu numéro " + resultats.size()
                                + " manque, ou y est deux fois ; attendu : les résultats de make corriger, tous");
                    }
                }
            }
        } catch (Panne e) {
            throw e;
        } catch (IOException | RuntimeException e) {
            throw new Panne(2, "rien à noter : " + lu + " manque, ou est abîmé ; attendu : les résultats de make corriger, tous");
        }
    }

    /**
     * Les résultats de ce dossier, {@code null} s'il n'y en a pas.
     *
     * @throws Panne si l'un d'eux manque ou est abîmé, et qu'ils doivent tous servir
     */
    public static DossierDeResultats chercher(Path classe, boolean tous) {
        try {
            return Files.exists(classe.resolve("resultats")) || Files.exists(anciens(classe)) ? new DossierDeResultats(classe) : null;
        } catch (Panne e) {
            if (tous) {
                throw e;
            }
            return null;
        }
    }

    private static Path anciens(Path classe) {
        return classe.resolve(".travail").resolve("anciens");
    }

    private static String nom(Path fichier) {
        return fichier.getFileName().toString().replaceFirst("\\.csv$", "");
    }

    /** Le numéro du rendu dont ce fichier est le résultat ; 0 pour un autre fichier. */
    private static int numero(Path fichier) {
        Matcher m = RENDU.matcher(nom(fichier));
        return fichier.toString().endsWith(".csv") && m.matches() ? Integer.parseInt(m.group(1)) : 0;
    }

    /**
     * Écrit ces résultats à part, puis les met à la place des anciens. Un résultat que l'on ne peut écrire devient un refus, qui dit
     * pourquoi. Les fichiers de l'enseignant restent.
     *
     * @param gardes les anciens résultats qui restent, sauf ceux des mêmes étudiants ; {@code null} s'il n'en reste aucun
     */
    public static void ecrire(Path classe, GrilleDeNotation grille, List<Rendu> rendus, List<Resultat> resultats,
            DossierDeResultats gardes) throws IOException {
        Path dossier = classe.resolve("resultats");
        Path neuf = classe.resolve(".travail").resolve("resultats");
        if (Files.exists(neuf)) {
            Compilateur.effacer(neuf);
        }
        grille.ecrire(Files.createDirectories(neuf).resolve(GRILLE));
        Map<String, String> noms = new HashMap<>();
        for (Map.Entry<String, Resultat> garde : gardes == null ? Map.<String, Resultat>of().entrySet() : gardes.resultats.entrySet()) {
            noms.put(garde.getValue().id, garde.getKey());
            Files.copy(dossier.resolve(garde.getKey() + ".csv"), neuf.resolve(garde.getKey() + ".csv"));
        }
        for (int k = 0; k < resultats.size(); k++) {
            Resultat resultat = resultats.get(k);
            String nom = noms.get(resultat.id);
            if (nom == null) {
                nom = rendus.get(k).fichier(noms.size());
                noms.put(resultat.id, nom);
            }
            try {
                resultat.ecrire(neuf.resolve(nom + ".csv"));
            } catch (IOException | RuntimeException | Error e) {
                Resultat refus = new Resultat(resultat.id, resultat.nom);
                refus.refus.add("ses résultats n'ont pas pu être écrits (" + Echange.protege(e.toString()) + ")");
                refus.ecrire(neuf.resolve(nom + ".csv"));
            }
        }
        ranger(anciens(classe), dossier);
        if (Files.exists(dossier)) {
            Files.move(dossier, anciens(classe));
        }
        Files.move(neuf, dossier);
        ranger(anciens(classe), dossier);
    }

    /** Efface d'anciens résultats ; les autres fichiers, qui sont à l'enseignant, vont avec les nouveaux résultats. */
    private static void ranger(Path anciens, Path dossier) throws IOException {
        if (!Files.exists(anciens)) {
            return;
        }
        List<Path> tous;
        try (Stream<Path> flux = Files.list(anciens)) {
            tous = flux.collect(Collectors.toList());
        }
        for (Path fichier : tous) {
            if (numero(fichier) > 0 || fichier.endsWith(GRILLE)) {
                Files.delete(fichier);
            } else {
                Files.move(fichier, Files.createDirectories(dossier).resolve(fichier.getFileName()));
            }
        }
        Files.delete(anciens);
    }
}
