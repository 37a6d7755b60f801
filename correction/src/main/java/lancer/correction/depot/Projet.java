package lancer.correction.depot;

import java.text.Normalizer;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import lancer.correction.modele.Modele;

/**
 * Les classes d'un rendu : celles de la base, et celles de chaque variante, retrouvées où que l'étudiant les ait mises.
 */
public final class Projet {

    public static final String NOMS = "noms";
    public static final String OUTILS = "outils";
    public static final String TEXTE = "texte";
    public static final String FIXME = "fixme";
    /** Les consignes ; la dernière dépend de ce qui est juste. */
    public static final Map<String, String> CONSIGNES = new LinkedHashMap<>();

    static {
        CONSIGNES.put(NOMS, "le paquet et les noms sont ceux du cours");
        CONSIGNES.put(OUTILS, "aucun des fichiers que les outils ajoutent");
        CONSIGNES.put(TEXTE, "UTF-8, et des espaces au lieu de tabulations");
        CONSIGNES.put(FIXME, "chaque FIXME est enlevé quand c'est fait");
    }

    private static final String DE_COTE = " : laissé de côté, ";

    /** Nombre au-delà duquel on ne cherche plus laquelle est la meilleure. */
    private static final int COPIES_MAX = 3;

    private static final Pattern VARIANTE =
            Pattern.compile("(?i)(?:^|/)[^/]*?(brume|anti[-_ ]?alias|anti[-_ ]?crenelage|blinn)[^/]*/");
    private static final Pattern DE_TEST = Pattern.compile("(?:^|.*/)src/test/.*");

    /** Les classes de la base : {@code lancer/Vecteur} et son texte. */
    public final Map<String, String> base;
    /** Sources de chaque variante rendue. */
    public final Map<String, Map<String, String>> variantes;
    public final List<String> remarques;
    /** Changements des noms du cours. */
    public final Renommage noms;
    /** Les classes du cours qui ne sont plus celles du projet à compléter, parmi celles qu'il a rendues. */
    public final Set<String> changees;
    /** Écarts à ce que l'énoncé demande : par consigne, ce qu'on en dit. */
    public final Map<String, String> ecarts = new TreeMap<>();
    /** Raisons pour lesquelles l'enseignant doit regarder ce rendu lui-même. */
    public final List<String> aRegarder = new ArrayList<>();

    /** @param base texte de chaque fichier, par nom de classe complet : {@code lancer/Vecteur} */
    public Projet(Map<String, String> base, Map<String, Map<String, String>> variantes, List<String> remarques) {
        this.base = base;
        this.variantes = variantes;
        this.remarques = new ArrayList<>(remarques);
        noms = new Renommage(base);
        this.remarques.addAll(noms.changes);
        aRegarder.addAll(noms.changes);
        noms.changes.forEach(c -> noter(NOMS, c));
        changees = Modele.classes().stream().filter(c -> texte(c) != null
                && !Source.memeCode(texte(c), noms.dans(Modele.squelette(c)))).collect(Collectors.toSet());
    }

    /** Chaque copie du projet que contient un rendu, de celle où il y a le plus de travail à celle où il y en a le moins. */
    public static List<Projet> copies(Rendu rendu) {
        List<String> remarques = new ArrayList<>(rendu.remarques);
        Map<String, Set<String>> dites = new TreeMap<>();
        Map<String, Map<String, List<Source>>> groupes = new TreeMap<>();
        for (Map.Entry<String, byte[]> fichier : rendu.sources.entrySet()) {
            for (Source source : Source.lire(fichier.getKey(), fichier.getValue())) {
                // Tests, Etapes : ce sont les nôtres qui notent, pas la copie de l'étudiant
                if (!DE_TEST.matcher(source.chemin).matches()
                        && !List.of("Tests", "Etapes", "module-info", "package-info").contains(source.classe)) {
                    Matcher m = VARIANTE.matcher(Normalizer.normalize(source.racine, Normalizer.Form.NFD)
                            .replaceAll("\\p{M}", ""));
                    String partie = m.find() ? m.group(1).toLowerCase(Locale.ROOT).replaceFirst("^anti.*", "antialias") : "";
                    groupes.computeIfAbsent(partie, p -> new TreeMap<>())
                            .computeIfAbsent(source.racine, r -> new ArrayList<>()).add(source);
                }
            }
        }
        Map<String, Map<String, String>> variantes = new LinkedHashMap<>();
        for (String nom : Modele.VARIANTES) {
            if (groupes.containsKey(nom)) {
                variantes.put(nom, choisir(groupes.get(nom), remarques, dites).values().iterator().next());
            }
        }
        Map<String, Map<String, String>> bases = choisir(groupes.getOrDefault("", Collections.emptyMap()), remarques, dites);
        if (bases.isEmpty()) {
            // une variante est une copie complète du projet
            String premiere = variantes.isEmpty() ? "" : variantes.keySet().iterator().next();
            remarques.add(premiere.isEmpty() ? "aucune classe à juger"
                    : "pas de projet de base : celui de « " + premiere + " » en tient lieu");
            bases.put("", variantes.getOrDefault(premiere, new TreeMap<>()));
        }
        dites.forEach((quoi, ou) -> remarques.add((ou.size() == 1 ? ou.iterator().next() + " : " + quoi
                : quoi + " (" + ou.size() + " fichiers)")));
        List<Projet> copies = new ArrayList<>();
        bases.forEach((racine, base) -> {
            Projet projet = new Projet(base, variantes, remarques);
            projet.consignes(rendu, dites);
            remarques.stream().filter(r -> r.contains(DE_COTE)).forEach(r -> projet.aRegarder.add("arrêté : " + r));
            if (bases.size() > 1) {
                String dit = "plusieurs copies du projet : jugée, « " + racine + " » ; laissée, « " + bases.keySet().stream()
                        .filter(r -> !r.equals(racine)).collect(Collectors.joining(" », « ")) + " »";
                projet.remarques.add(dit);
                projet.aRegarder.add(dit);
            }
            copies.add(projet);
        });
        copies.sort(Comparator.comparing((Projet p) -> -p.changees.size()));
        return copies;
    }

    private void consignes(Rendu rendu, Map<String, Set<String>> dites) {
        dites.keySet().forEach(quoi -> noter(quoi.contains("UTF-8") ? TEXTE : NOMS, quoi));
        if (!rendu.outils.isEmpty()) {
            ecarts.put(OUTILS, "rendus aussi : " + String.join(", ", rendu.outils));
        }
        long tabulations = base.values().stream().filter(t -> t.contains("\n\t")).count();
        if (tabulations > 0) {
            noter(TEXTE, "des tabulations dans " + tabulations + (tabulations > 1 ? " classes" : " classe"));
        }
    }

    /** Une consigne n'est pas suivie. */
    public void noter(String consigne, String ecart) {
        ecarts.merge(consigne, ecart, (a, b) -> a + " ; " + b);
    }

    /**
     * Des dossiers qui contiennent des classes, les copies du projet, par leur dossier : celui qui a le plus de classes
     * du cours, et ceux qui n'ajoutent que ce qui lui manque ; puis les autres.
     */
    private static Map<String, Map<String, String>> choisir(Map<String, List<Source>> groupes, List<String> remarques,
            Map<String, Set<String>> dites) {
        List<String> racines = new ArrayList<>(groupes.keySet());
        racines.sort(Comparator.comparing((String r) -> -groupes.get(r).stream().filter(s -> Modele.A_COMPLETER.contains(s.classe)).count())
                .thenComparing(String::length));
        Map<String, Map<String, String>> copies = new LinkedHashMap<>();
        for (String racine : racines) {
            Map<String, String> classes = copies.values().stream().filter(c -> groupes.get(racine).stream()
                    .filter(s -> c.containsKey("lancer/" + s.classe)).count() <= 2).findFirst().orElse(null);
            if (classes == null) {
                if (copies.size() == COPIES_MAX) {
                    remarques.add("une copie de plus du projet, laissée : « " + racine + " »");
                    continue;
                }
                classes = copies.computeIfAbsent(racine, r -> new TreeMap<>());
            }
            for (Source source : groupes.get(racine)) {
                String nom = source.paquet.isEmpty() ? source.classe : source.paquet.replace('.', '/') + "/"
                        + source.classe;
                String intrusion = source.intrusion();
                if (intrusion != null) {
                    remarques.add(source.chemin + DE_COTE + intrusion);
                } else if (!classes.containsKey(nom)) {
                    classes.put(nom, source.paquet.equals("lancer") && Modele.A_COMPLETER.contains(source.classe)
                            ? Methode.avecPonts(source.classe, source.texte, remarques) : source.texte);
                    if (source.remarque != null) {
                        dites.computeIfAbsent(source.remarque, r -> new TreeSet<>()).add(source.chemin);
                    }
                }
            }
        }
        return copies;
    }

    /** Le texte d'une classe du cours, sous le nom qu'il lui donne ; {@code null} si elle n'est pas rendue. */
    public String texte(String classe) {
        return base.get("lancer/" + noms.classe(classe));
    }
}
