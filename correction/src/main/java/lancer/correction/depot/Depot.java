package lancer.correction.depot;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.text.Collator;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import lancer.correction.Panne;
import lancer.correction.enfant.Texte;

/**
 * Les rendus d'une classe, un dossier ou une archive : chaque entrée est une ligne. Les entrées que Moodle donne à un même numéro, ou
 * Canvas à un même étudiant, sont une seule ligne.
 */
public final class Depot {

    /**
     * Le nom que Moodle donne à un rendu : {@code <nom>_<numéro>_assignsubmission_file}, suivi ou non de « _ », puis, en mode plat, du nom
     * du fichier (moodle, {@code mod/assign/classes/downloader.php}).
     */
    private static final Pattern MOODLE = Pattern.compile("(?s)([^/]*?)_(\\d{1,18})_assignsubmission_([a-z]+)(?:_(.*))?");
    /** Le nom que Canvas donne à un fichier : {@code <nom>[_LATE]_<numéro de l'étudiant>_<numéro du rendu>_<fichier>}. */
    private static final Pattern CANVAS = Pattern.compile("(?s)([^_/]+)(_LATE)?_(\\d{1,18})_\\d{1,18}_(.+)");
    /** Une entrée qui n'est le rendu d'aucun étudiant : la classe entière serait un seul projet. */
    private static final Pattern DE_PROJET = Pattern.compile("(?i)src|pom\\.xml|.*\\.java");

    private static final Collator ALPHABET = Collator.getInstance(Locale.FRENCH);

    /** Les rendus, par identifiant. */
    private final Map<String, Rendu> rendus = new LinkedHashMap<>();

    private Depot() {
    }

    static boolean deMoodle(String nom) {
        return MOODLE.matcher(nom).matches();
    }

    /**
     * @param seul vrai si tout ce lieu est un seul rendu
     * @throws Panne si ce lieu n'a pas de rendu, est illisible, ou n'est qu'un projet
     */
    public static List<Rendu> lire(Path lieu, boolean seul) {
        Depot depot = new Depot();
        String nom = lieu.toAbsolutePath().normalize().getFileName().toString();
        if (!Files.isReadable(lieu)) {
            throw new Panne(2, "aucun rendu à cet endroit : " + lieu + " ; attendu : un dossier, ou un .zip");
        } else if (!Files.isDirectory(lieu) && !nom.matches("(?is).*\\.zip")) {
            throw new Panne(2, "rendus illisibles : " + lieu + Contenu.A_DEPLIER);
        }
        try (Lieu ici = new Lieu(lieu.toRealPath(), !seul)) {
            Map<String, Boolean> noms = ici.noms();
            if (noms.isEmpty()) {
                throw new Panne(2, "aucun rendu dans " + lieu);
            } else if (seul) {
                Matcher moodle = MOODLE.matcher(nom);
                Rendu rendu = moodle.matches() ? depot.rendu(moodle.group(2), moodle.group(1).trim()) : depot.rendu(nom, nom);
                rendu.entrees.put(nom, "");
            } else {
                depot.repartir(lieu, noms);
            }
            depot.rendus.values().forEach(r -> r.lire(ici, seul));
        } catch (IOException | OutOfMemoryError e) {
            throw new Panne(2, "rendus illisibles : " + lieu + " (" + e.getMessage() + ")");
        }
        List<Rendu> liste = new ArrayList<>(depot.rendus.values());
        liste.sort(Comparator.comparing((Rendu r) -> r.nom, Depot::comparer).thenComparing(r -> r.id));
        return liste;
    }

    private void repartir(Path lieu, Map<String, Boolean> noms) {
        Map<String, Matcher> canvas = deCanvas(noms);
        List<String> deProjet = noms.keySet().stream().filter(n -> DE_PROJET.matcher(n).matches() && !deMoodle(n)
                && !canvas.containsKey(n)).collect(Collectors.toList());
        if (2 * deProjet.size() > noms.size() || noms.containsKey("src") && noms.keySet().stream().noneMatch(Depot::deMoodle)) {
            throw new Panne(2, "rien n'est jugé : « " + deProjet.get(0) + " » n'est pas le rendu d'un étudiant ; attendu : une entrée par "
                    + "étudiant ; " + pourUnSeul(lieu));
        }
        noms.forEach((nom, fichier) -> {
            Matcher moodle = MOODLE.matcher(nom);
            Matcher sien = canvas.get(nom);
            if (moodle.matches()) {
                rendu(moodle.group(2), moodle.group(1).trim()).entrees.put(nom, Objects.toString(moodle.group(4), ""));
            } else if (sien != null) {
                Rendu rendu = rendu(sien.group(1) + "_" + sien.group(3), sien.group(1));
                rendu.entrees.put(nom, sien.group(4));
                if (sien.group(2) != null && rendu.remarques.isEmpty()) {
                    rendu.remarques.add("rendu en retard, d'après Canvas");
                }
            } else if (deProjet.contains(nom)) {
                Rendu rendu = rendu(nom, nom);
                rendu.entrees.put(nom, nom);
                rendu.refus.add("un fichier seul n'est le rendu d'aucun étudiant ; " + pourUnSeul(lieu));
            } else {
                // un nom qui serait celui de la ligne d'un autre
                boolean pris = nom.matches("\\d{1,18}") || canvas.values().stream()
                        .anyMatch(m -> nom.equals(m.group(1) + "_" + m.group(3)));
                String id = pris ? nom + "/" : nom;
                rendu(id, nom).entrees.put(nom, fichier ? nom : "");
            }
        });
    }

    private static String pourUnSeul(Path lieu) {
        return "pour un seul rendu : make corriger UN=" + lieu + " (--un)";
    }

    /** Les fichiers que Canvas a nommés, aucun s'ils ont tous le même début, ou si deux noms ont le même numéro : « TP1_2026_11_… ». */
    private static Map<String, Matcher> deCanvas(Map<String, Boolean> noms) {
        Map<String, Matcher> canvas = new HashMap<>();
        noms.forEach((nom, fichier) -> {
            Matcher m = CANVAS.matcher(nom);
            if (fichier && !deMoodle(nom) && m.matches()) {
                canvas.put(nom, m);
            }
        });
        List<String> etudiants = canvas.values().stream().map(m -> m.group(1) + "_" + m.group(3)).distinct().collect(Collectors.toList());
        long numeros = canvas.values().stream().map(m -> m.group(3)).distinct().count();
        return numeros == etudiants.size() && numeros > 1 ? canvas : Map.of();
    }

    private Rendu rendu(String id, String nom) {
        return rendus.computeIfAbsent(id, i -> new Rendu(i, nom.isEmpty() ? i : nom));
    }

    /** Ordre du français, où « Éloïse » vient avant « Zoé », et « Étudiant 2 » avant « Étudiant 10 ». */
    public static int comparer(String a, String b) {
        return ALPHABET.compare(nombres(a), nombres(b));
    }

    private static String nombres(String nom) {
        return Pattern.compile("\\d{1,18}").matcher(Texte.protege(nom)).replaceAll(n -> String.format("%018d", Long.parseLong(n.group())));
    }
}
