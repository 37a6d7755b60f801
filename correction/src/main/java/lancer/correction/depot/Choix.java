package lancer.correction.depot;

import java.text.Normalizer;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import lancer.correction.isolement.Arret;
import lancer.correction.modele.SourcesDuCours;

/**
 * Choisit, parmi les fichiers d'un rendu, les classes de la base et celles de chaque extension. Un projet est un dossier : ce qui est hors
 * de lui n'y remplace aucune classe, et n'apporte que celles qui y manquent.
 */
final class Choix {

    /** Nombre de classes qu'un dossier qui complète le projet peut avoir en commun avec lui ; plus, c'est une autre copie. */
    private static final int COMMUNES_MAX = 2;

    private static final Map<String, Pattern> VARIANTE = Map.of("brume", Pattern.compile("(?i)brume"),
            "antialias", Pattern.compile("(?i)anti[-_ ]?(alias|cr.{1,2}nelage)"), "blinn", Pattern.compile("(?i)blinn"));

    /** Les classes de la base, puis de chaque extension, par nom complet. */
    final Map<String, Type> base;
    final Map<String, Map<String, Type>> variantes = new LinkedHashMap<>();
    /** Ce qui est laissé de côté, ou vient d'un autre dossier, et pourquoi. */
    final List<String> dites = new ArrayList<>();

    private final Cours cours;
    private final Source.Lecture lecture;
    private final Map<String, List<Type>> racines = new TreeMap<>();
    private final Map<String, Boolean> compilees = new HashMap<>();
    /** De deux copies, ce qui fait garder la première ; le premier de ces ordres qui les sépare décide. */
    private final Map<String, Comparator<String>> raisons = new LinkedHashMap<>();

    Choix(List<Source> sources, Cours cours, Source.Lecture lecture) {
        this.cours = cours;
        this.lecture = lecture;
        raisons.put("a plus de vos classes", Comparator.comparing(r -> 2 * siennes(r) < racines.keySet().stream()
                .mapToLong(this::siennes).max().getAsLong()));
        raisons.put("n'a pas le texte du corrigé", Comparator.comparing(r -> nombre(racines.get(r), t -> t.provenance == 2)));
        raisons.put("se compile", Comparator.comparing(r -> !seCompile(r)));
        raisons.put("a moins de FIXME", Comparator.comparing(this::aFaire));
        raisons.put("s'appelle « base »", Comparator.comparing(r -> !dossier(r).toLowerCase(Locale.ROOT).contains("base")));
        raisons.put("a plus de texte", Comparator.comparing(r -> -racines.get(r).stream().filter(Choix::duCours)
                .mapToInt(t -> t.texte.length()).sum()));
        raisons.put("vient d'abord, par son nom", Comparator.comparing((String r) -> racines.get(r).stream()
                .mapToInt(t -> t.source.rang(t.nom)).min().getAsInt())
                .thenComparing(String::length).thenComparing(r -> r));
        List<Source> gardees = ecarterLesAutresTravaux(sources);
        Set<String> paquets = gardees.stream().filter(Source::declare).map(f -> f.paquet).collect(Collectors.toCollection(TreeSet::new));
        gardees.forEach(source -> source.classes(paquets).forEach(type -> ranger(source, type)));
        racines.values().forEach(this::situer);
        Map<String, Map<String, List<Type>>> parties = partager();
        SourcesDuCours.VARIANTES.stream().filter(parties::containsKey).forEach(nom -> variantes.put(nom, choisir(parties.get(nom))));
        base = choisir(parties.getOrDefault("", Map.of()));
    }

    /** Nombre de classes à compléter qui sont ici le travail de l'étudiant. */
    private long siennes(String racine) {
        return nombre(racines.get(racine), t -> t.provenance == 0 && cours.ressemble(t));
    }

    /** Nombre de FIXME qui restent ici, ceux du projet à compléter compris pour une classe absente. */
    private long aFaire(String racine) {
        return SourcesDuCours.A_COMPLETER.stream().mapToLong(c -> racines.get(racine).stream().filter(t -> t.nom.equals(c))
                .map(t -> t.texte).findFirst().orElse(SourcesDuCours.squelette(c)).split("FIXME", -1).length - 1).sum();
    }

    private boolean seCompile(String racine) {
        return compilees.computeIfAbsent(racine, r -> {
            Map<String, String> textes = SourcesDuCours.tout(SourcesDuCours::squelette);
            racines.get(r).forEach(t -> textes.put(t.chemin(), t.texte));
            try {
                return lecture.compile(textes);
            } catch (Arret e) {
                return false;
            }
        });
    }

    /** Laisse de côté, hors du dossier qui a le plus de classes du cours, un autre travail. */
    private List<Source> ecarterLesAutresTravaux(List<Source> sources) {
        Map<String, List<Type>> lues = new TreeMap<>();
        sources.forEach(s -> lues.computeIfAbsent(s.racine, r -> new ArrayList<>()).addAll(s.types));
        String principal = lues.keySet().stream().min(Comparator.comparing((String r) -> -nombre(lues.get(r), cours::ressemble))
                .thenComparing(r -> -nombre(lues.get(r), t -> true)).thenComparing(String::length)).orElse("");
        lues.remove(principal);
        lues.values().forEach(types -> types.removeIf(t -> !duCours(t)));
        lues.values().removeIf(types -> types.isEmpty() || types.stream().anyMatch(cours::ressemble));
        lues.forEach((racine, types) -> dites.add(racine + Contenu.DE_COTE + "hors du projet ; " + Projet.noms(types)
                + " n'y est pas du cours"));
        return sources.stream().filter(s -> !lues.containsKey(s.racine)).collect(Collectors.toList());
    }

    private void ranger(Source source, Type type) {
        String intrusion = source.intrusion(type.nom);
        if (intrusion == null) {
            racines.computeIfAbsent(source.racine, r -> new ArrayList<>()).add(type);
        } else {
            dites.add(source.chemin + Contenu.DE_COTE + intrusion);
        }
    }

    /** Nombre de classes à compléter parmi celles-ci. */
    private static long nombre(Collection<Type> types, Predicate<Type> lesquelles) {
        return types.stream().filter(Choix::aCompleter).filter(lesquelles).map(t -> t.nom).distinct().count();
    }

    private static boolean aCompleter(Type type) {
        return SourcesDuCours.A_COMPLETER.contains(type.nom);
    }

    /**
     * Dit d'où viennent les textes d'un dossier. Un étudiant écrit de lui-même quelques classes comme le corrigé : elles n'en viennent que
     * si la plupart de celles du dossier sont celles du corrigé.
     */
    private void situer(List<Type> types) {
        types.forEach(t -> t.provenance = cours.provenance(t));
        if (2 * nombre(types, t -> t.provenance == 2) <= nombre(types, t -> true)) {
            types.stream().filter(t -> t.provenance == 2).forEach(t -> t.provenance = 0);
        }
    }

    /** Les dossiers de la base, puis de chaque extension. */
    private Map<String, Map<String, List<Type>>> partager() {
        Set<String> projets = racines.keySet().stream().filter(r -> nombre(racines.get(r), t -> true) > 0).map(Choix::dossier)
                .collect(Collectors.toSet());
        Map<String, Map<String, List<Type>>> parties = new TreeMap<>();
        racines.forEach((racine, siens) -> parties.computeIfAbsent(partie(racine, projets), p -> new TreeMap<>()).put(racine, siens));
        return parties;
    }

    /** Le dossier du projet, qui contient ce dossier de sources. */
    private static String dossier(String racine) {
        return racine.replaceFirst("(?<![^/])src/(main/java/)?$", "");
    }

    private static String parent(String dossier) {
        return dossier.substring(0, dossier.lastIndexOf('/', dossier.length() - 2) + 1);
    }

    /** L'extension que nomme le dossier d'un projet ou, à défaut, le plus proche qui le contient, sans contenir tous les projets. */
    private static String partie(String racine, Set<String> projets) {
        String commun = projets.stream().findFirst().orElse("");
        while (!commun.isEmpty() && (projets.contains(commun) || !tousDans(commun, projets))) {
            commun = parent(commun);
        }
        for (String d = dossier(racine); d.length() > commun.length(); d = parent(d)) {
            String nom = Normalizer.normalize(d.substring(parent(d).length()), Normalizer.Form.NFD).replaceAll("\\p{M}", "");
            List<String> dites = VARIANTE.keySet().stream().filter(v -> VARIANTE.get(v).matcher(nom).find()).collect(Collectors.toList());
            if (dites.size() == 1) {
                return dites.get(0);
            }
        }
        return "";
    }

    private static boolean tousDans(String dossier, Set<String> projets) {
        return projets.stream().allMatch(p -> p.startsWith(dossier));
    }

    /** Le premier dossier est le projet ; les autres n'apportent que ce qui lui manque, ou ce qu'il n'a pas commencé. */
    private Map<String, Type> choisir(Map<String, List<Type>> groupes) {
        Map<String, Type> projet = new TreeMap<>();
        List<String> racines = ranges(groupes);
        for (String racine : racines) {
            List<Type> siens = uneParNom(groupes.get(racine));
            boolean copie = siens.stream().filter(t -> projet.containsKey(t.chemin())).count() > COMMUNES_MAX;
            List<Type> apportes = siens.stream().filter(t -> {
                Type autre = projet.get(t.chemin());
                return autre == null ? !copie || duCours(t) : t.provenance < autre.provenance;
            }).collect(Collectors.toList());
            apportes.forEach(t -> projet.put(t.chemin(), t));
            siens.removeAll(apportes);
            if (!copie) {
                siens.forEach(t -> laisser(t, projet.get(t.chemin())));
            } else if (!siens.isEmpty()) {
                String pourquoi = raisons.entrySet().stream().filter(e -> e.getValue().compare(racines.get(0), racine) != 0)
                        .map(Map.Entry::getKey).findFirst().get();
                dites.add(racine + Contenu.DE_COTE + (siens.stream().allMatch(t -> t.provenance == 2) ? "c'est le texte du corrigé"
                        : "le projet est dans " + racines.get(0) + ", qui " + pourquoi) + " : " + Projet.noms(siens));
            }
            apportes.removeIf(t -> !duCours(t));
            if (!racine.startsWith(racines.get(0)) && !apportes.isEmpty()) {
                dites.add(racine + " : hors du projet, le complète par " + Projet.noms(apportes));
            }
        }
        return projet;
    }

    private static boolean duCours(Type type) {
        return SourcesDuCours.classes().contains(type.nom);
    }

    /** Les dossiers, du plus sûr au moins sûr. */
    private List<String> ranges(Map<String, List<Type>> groupes) {
        return groupes.keySet().stream().sorted(raisons.values().stream().reduce(Comparator::thenComparing).get())
                .collect(Collectors.toList());
    }

    /**
     * De plusieurs fichiers qui déclarent une même classe sous un dossier : celui du dossier des classes à compléter, que l'étudiant a
     * écrit, qui en a le nom, le plus proche.
     */
    private List<Type> uneParNom(List<Type> types) {
        Map<String, Long> parDossier = types.stream().filter(Choix::aCompleter)
                .collect(Collectors.groupingBy(t -> t.source.dossier, Collectors.counting()));
        String principal = parDossier.isEmpty() ? "" : Collections.max(parDossier.entrySet(), Map.Entry.comparingByValue()).getKey();
        types.sort(Comparator.comparing((Type t) -> !t.source.dossier.equals(principal)).thenComparing(t -> t.provenance > 0)
                .thenComparing(t -> t.source.rang(t.nom)).thenComparing(t -> t.source.chemin.split("/").length));
        Map<String, Type> gardes = new LinkedHashMap<>();
        for (Type type : types) {
            Type autre = gardes.putIfAbsent(type.chemin(), type);
            if (autre != null) {
                laisser(type, autre);
            }
        }
        return new ArrayList<>(gardes.values());
    }

    private void laisser(Type laisse, Type garde) {
        dites.add(laisse.source.chemin + Contenu.DE_COTE + laisse.nom + " est dans " + garde.source.chemin);
    }
}
