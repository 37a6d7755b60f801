package lancer.correction.jugement;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import lancer.correction.Panne;
import lancer.correction.depot.Rendu;
import lancer.correction.enfant.Echange;
import org.apache.commons.io.FileUtils;

/** Le dossier {@code resultats} : un fichier par rendu, numérotés à partir de 001, et la grille du corrigé. Il n'est remplacé qu'entier. */
public final class DossierDeResultats {

    private static final String GRILLE = "corrige.csv";
    private static final Pattern RENDU = Pattern.compile("(\\d{3,9})-[A-Za-z0-9-]*\\.csv");

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
            Map<Integer, Path> fichiers = new TreeMap<>();
            try (Stream<Path> flux = Files.list(dossier)) {
                flux.filter(f -> numero(f) > 0).forEach(f -> fichiers.merge(numero(f), f, (un, autre) -> dossier));
            }
            for (int k = 1; k <= fichiers.size(); k++) {
                lu = fichiers.getOrDefault(k, dossier.resolve("le rendu numéro " + k));
                resultats.put(lu.getFileName().toString().replace(".csv", ""), Resultat.lire(lu));
            }
        } catch (IOException | RuntimeException e) {
            throw new Panne(2, "rien à noter : " + lu + " manque, ou est abîmé ; attendu : les résultats de make corriger, tous");
        }
    }

    /** Ceux de ce dossier, {@code null} s'il n'y en a pas ; s'ils sont abîmés, de même, ou une panne s'ils sont exigés. */
    public static DossierDeResultats chercher(Path classe, boolean exiges) {
        try {
            return new DossierDeResultats(classe);
        } catch (Panne e) {
            if (exiges && Files.exists(classe.resolve("resultats"))) {
                throw e;
            }
            return null;
        }
    }

    private static Path anciens(Path classe) {
        return classe.resolve(".travail").resolve("anciens");
    }

    /** Le numéro du rendu dont ce fichier est le résultat ; 0 pour un autre fichier. */
    private static int numero(Path fichier) {
        Matcher m = RENDU.matcher(fichier.getFileName().toString());
        return m.matches() ? Integer.parseInt(m.group(1)) : 0;
    }

    /**
     * Écrit ces résultats à part, puis les met à la place des anciens. Un résultat que l'on ne peut écrire devient un refus, qui dit
     * pourquoi. Les fichiers de l'enseignant restent.
     *
     * @param gardes les anciens résultats qui restent, sauf ceux des mêmes étudiants ; {@code null} s'il n'en reste aucun
     */
    public static void ecrire(Path classe, GrilleDeNotation grille, List<Rendu> rendus, List<Resultat> juges, DossierDeResultats gardes)
            throws IOException {
        Path dossier = classe.resolve("resultats");
        Path neuf = classe.resolve(".travail").resolve("resultats");
        FileUtils.deleteDirectory(neuf.toFile());
        if (Files.exists(dossier)) {
            FileUtils.copyDirectory(dossier.toFile(), neuf.toFile(), f -> gardes != null || numero(f.toPath()) == 0);
        }
        grille.ecrire(Files.createDirectories(neuf).resolve(GRILLE));
        Map<String, String> noms = new HashMap<>();
        if (gardes != null) {
            gardes.resultats.forEach((nom, resultat) -> noms.put(resultat.id, nom));
        }
        for (int k = 0; k < juges.size(); k++) {
            Resultat juge = juges.get(k);
            Path fichier = neuf.resolve(noms.getOrDefault(juge.id, rendus.get(k).fichier(noms.size())) + ".csv");
            noms.putIfAbsent(juge.id, "");
            try {
                juge.ecrire(fichier);
            } catch (IOException | RuntimeException | Error e) {
                Resultat refus = new Resultat(juge.id, juge.nom);
                refus.refus.add("ses résultats n'ont pas pu être écrits (" + Echange.protege(e.toString()) + ")");
                refus.ecrire(fichier);
            }
        }
        Path anciens = anciens(classe);
        if (Files.exists(dossier)) {
            FileUtils.deleteDirectory(anciens.toFile());
            Files.move(dossier, anciens);
        }
        Files.move(neuf, dossier);
        FileUtils.deleteDirectory(anciens.toFile());
    }
}
