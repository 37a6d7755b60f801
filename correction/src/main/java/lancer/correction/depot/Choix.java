package lancer.correction.depot;

import java.text.Normalizer;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import lancer.correction.modele.SourcesDuCours;

/**
 * Choisit, parmi les fichiers d'un rendu, les classes de la base et celles de chaque extension. Un projet est un dossier : ce qui est hors
 * de lui n'y remplace aucune classe, et n'apporte que celles qui y manquent.
 */
final class Choix {

    /** Nombre de classes d'un dossier sans classe du cours au-delà duquel c'est une bibliothèque. */
    private static final int BIBLIOTHEQUE = 200;
    /** Nombre de classes qu'un dossier peut avoir en commun avec une copie du projet, qu'il complète. */
    private static final int COMMUNES_MAX = 2;

    private static final Map<String, Pattern> VARIANTE = Map.of("brume", Pattern.compile("(?i)brume"),
            "antialias", Pattern.compile("(?i)anti[-_ ]?(alias|cr.{1,2}nelage)"), "blinn", Pattern.compile("(?i)blinn"));

    /** Les copies de la base, par dossier, puis celle de chaque extension ; les classes de chacune, par nom complet. */
    final Map<String, Map<String, Type>> bases;
    final Map<String, Map<String, Type>> variantes = new LinkedHashMap<>();
    /** Ce qui est laissé de côté, ou vient d'un autre dossier, et pourquoi. */
    final List<String> dites = new ArrayList<>();

    private final Cours cours;
    private final Map<String, List<Type>> racines = new TreeMap<>();

    Choix(List<Source> sources, Cours cours) {
        this.cours = cours;
        List<Source> gardees = ecarterLesAutresTravaux(sources);
        Set<String> paquets = gardees.stream().filter(Source::declare).map(f -> f.paquet).collect(Collectors.toCollection(TreeSet::new));
        gardees.forEach(source -> source.classes(paquets).forEach(type -> ranger(source, type)));
        racines.values().forEach(this::situer);
        Map<String, Map<String, List<Type>>> parties = partager();
        for (String nom : SourcesDuCours.VARIANTES) {
            Map<String, Map<String, Type>> siennes = choisir(parties.getOrDefault(nom, Map.of()));
            siennes.values().stream().findFirst().ifPresent(premiere -> variantes.put(nom, premiere));
            if (siennes.size() > 1) {
                dites.add(plusieurs("de l'extension " + nom + " : montrée", siennes.keySet(), siennes.keySet().iterator().next()));
            }
        }
        bases = choisir(parties.getOrDefault("", Map.of()));
        ecarter(bases.values());
    }

    /** Laisse de côté, hors du dossier qui a le plus de classes du cours, un autre travail, ou une bibliothèque. */
    private List<Source> ecarterLesAutresTravaux(List<Source> sources) {
        Map<String, List<Type>> lues = new TreeMap<>();
        sources.forEach(s -> s.types.forEach(t -> lues.computeIfAbsent(s.racine, r -> new ArrayList<>()).add(t)));
        String principal = lues.keySet().stream().min(Comparator.comparing((String r) -> -nombre(lues.get(r), cours::ressemble))
                .thenComparing(r -> -nombre(lues.get(r), t -> true)).thenComparing(String::length)).orElse("");
        Map<String, String> autres = new TreeMap<>();
        lues.forEach((racine, types) -> {
            List<Type> duCours = types.stream().filter(t -> SourcesDuCours.classes().contains(t.nom)).collect(Collectors.toList());
            if (!racine.equals(principal) && (duCours.isEmpty() ? types.size() > BIBLIOTHEQUE
                    : duCours.stream().noneMatch(cours::ressemble))) {
                autres.put(racine, duCours.isEmpty() ? types.size() + " classes d'une bibliothèque"
                        : "hors du projet ; " + Projet.noms(duCours) + " n'y est pas du cours");
            }
        });
        autres.forEach((racine, pourquoi) -> dites.add(racine + Contenu.DE_COTE + pourquoi));
        return sources.stream().filter(s -> !autres.containsKey(s.racine)).collect(Collectors.toList());
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

    static String plusieurs(String copies, Collection<String> toutes, String gardee) {
        return "plusieurs copies " + copies + ", « " + gardee + " » ; laissée, « " + toutes.stream()
                .filter(r -> !r.equals(gardee)).collect(Collectors.joining(" », « ")) + " »";
    }

    /**
     * Choisit les copies du projet parmi ces dossiers. La première est celui qui a le plus de classes écrites par l'étudiant ; un dossier
     * qui n'a presque aucune de ses classes la complète, un autre est une copie de plus.
     */
    private Map<String, Map<String, Type>> choisir(Map<String, List<Type>> groupes) {
        Map<String, Map<String, Type>> copies = new LinkedHashMap<>();
        for (String racine : ranges(groupes)) {
            List<Type> siens = uneParNom(groupes.get(racine));
            String projet = copies.keySet().stream().filter(p -> siens.stream().map(Type::chemin)
                    .filter(copies.get(p)::containsKey).count() <= COMMUNES_MAX).findFirst().orElse(racine);
            Map<String, Type> copie = copies.computeIfAbsent(projet, r -> new TreeMap<>());
            List<Type> apportees = new ArrayList<>();
            for (Type type : siens) {
                Type autre = copie.get(type.chemin());
                boolean remplace = autre != null && type.provenance < autre.provenance;
                if (autre == null || remplace) {
                    copie.put(type.chemin(), type);
                    apportees.add(type);
                }
                if (autre != null) {
                    laisser(remplace ? autre : type, remplace ? type : autre);
                }
            }
            apportees.removeIf(t -> !SourcesDuCours.classes().contains(t.nom));
            if (!racine.startsWith(projet) && !apportees.isEmpty()) {
                dites.add(racine + " : hors du projet, le complète par " + Projet.noms(apportees));
            }
        }
        return copies;
    }

    /** Les dossiers, du plus sûr au moins sûr. */
    private List<String> ranges(Map<String, List<Type>> groupes) {
        Function<Predicate<Type>, Comparator<String>> leursClasses = lesquelles -> Comparator.comparing(r -> -nombre(groupes.get(r), lesquelles));
        return groupes.keySet().stream().sorted(leursClasses.apply(t -> t.provenance != 1 && cours.ressemble(t))
                .thenComparing(leursClasses.apply(t -> true))
                .thenComparing(r -> !dossier(r).toLowerCase(Locale.ROOT).contains("base"))
                .thenComparing(r -> groupes.get(r).stream().mapToInt(t -> t.source.rang(t.nom)).min().getAsInt())
                .thenComparing(String::length)).collect(Collectors.toList());
    }

    /**
     * De plusieurs fichiers qui déclarent une même classe sous un dossier : celui du dossier des classes à compléter, que l'étudiant a
     * écrit, qui en a le nom, le plus proche.
     */
    private List<Type> uneParNom(List<Type> types) {
        Map<String, Long> parDossier = types.stream().filter(Choix::aCompleter)
                .collect(Collectors.groupingBy(t -> t.source.dossier, Collectors.counting()));
        String principal = parDossier.isEmpty() ? "" : Collections.max(parDossier.entrySet(), Map.Entry.comparingByValue()).getKey();
        types.sort(Comparator.comparing((Type t) -> !t.source.dossier.equals(principal)).thenComparing(t -> t.provenance)
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

    /**
     * Un texte du corrigé, ou du projet à compléter, ne prend la place d'aucun autre texte de sa classe. Une copie qui n'a que ces textes
     * disparaît.
     */
    private void ecarter(Collection<Map<String, Type>> copies) {
        Map<String, Type> meilleurs = new TreeMap<>();
        copies.forEach(copie -> copie.forEach((nom, type) -> meilleurs.merge(nom, type, (a, b) -> b.provenance < a.provenance ? b : a)));
        Map<String, String> ecartes = new TreeMap<>();
        copies.removeIf(copie -> {
            List<Type> siennes = SourcesDuCours.A_COMPLETER.stream().map(c -> copie.get("lancer/" + c)).filter(Objects::nonNull)
                    .collect(Collectors.toList());
            List<Type> laissees = siennes.stream().filter(t -> t.provenance > meilleurs.get(t.chemin()).provenance)
                    .collect(Collectors.toList());
            for (Type type : laissees) {
                copie.put(type.chemin(), meilleurs.get(type.chemin()));
                String pourquoi = "c'est le texte " + (type.provenance == 2 ? "du corrigé" : "à compléter") + " ; un autre est jugé";
                ecartes.merge(type.source.dossier + Contenu.DE_COTE + pourquoi, type.nom, (a, b) -> a + ", " + b);
            }
            return !laissees.isEmpty() && laissees.containsAll(siennes);
        });
        ecartes.forEach((pourquoi, classes) -> dites.add(pourquoi + " : " + classes));
    }
}
