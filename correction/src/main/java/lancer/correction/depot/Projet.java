package lancer.correction.depot;

import java.text.Normalizer;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.ToIntFunction;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.correction.isolement.Arret;
import lancer.correction.modele.SourcesDuCours;

/** Les classes d'un rendu : celles de la base et celles de chaque variante, quel que soit leur dossier. */
public final class Projet {

    public static final String NOMS = "noms";
    public static final String OUTILS = "outils";
    public static final String TEXTE = "texte";
    public static final String FIXME = "fixme";
    /** Les consignes de forme, par leur nom. FIXME dépend aussi des vérifications réussies. */
    public static final Map<String, String> CONSIGNES = new TreeMap<>(Map.of(
            NOMS, "le paquet et les noms sont ceux du cours",
            OUTILS, "aucun des fichiers que les outils ajoutent",
            TEXTE, "UTF-8, et des espaces au lieu de tabulations",
            FIXME, "chaque FIXME est enlevé quand c'est fait"));

    /** Nombre maximal de copies du projet qui sont comparées. */
    private static final int COPIES_MAX = 3;
    private static final int NOMS_DITS = 5;

    private static final Map<String, Pattern> VARIANTE = Map.of("brume", Pattern.compile("(?i)brume"),
            "antialias", Pattern.compile("(?i)anti[-_ ]?(alias|crenelage)"), "blinn", Pattern.compile("(?i)blinn"));
    /** Fichiers qui ne sont pas jugés : les tests qui notent sont ceux de la correction. */
    private static final Pattern DE_TEST = Pattern.compile("(?is)(?:^|.*/)(?:src/test/.*|(?:Tests|Causes|Repetition|Valeurs|Etapes"
            + "|module-info|package-info)\\.java)");
    /** Bibliothèques que la correction fournit. */
    private static final Pattern FOURNIE = Pattern.compile("(?i)(ini4j|junit|opentest4j|apiguardian|hamcrest).*");
    /** Classes du cours que les autres classes n'appellent pas : leurs méthodes ne sont pas adaptées. */
    private static final List<String> SANS_PONT = List.of("Toile", "Main", "LecteurScene", "Constantes");

    /** Les classes de la base, par nom complet ({@code lancer/Vecteur}), avec leur texte. */
    public final Map<String, String> base;
    private final Map<String, Type> types;
    /** Sources de chaque variante rendue. */
    public final Map<String, Map<String, String>> variantes = new LinkedHashMap<>();
    public final List<String> remarques;
    /** Les classes du projet à compléter. */
    public final Map<String, Type> squelette;
    /** Les classes du cours que l'étudiant a modifiées, par rapport au projet à compléter. */
    public final Set<String> changees;
    /** Écarts aux consignes de l'énoncé, par consigne. */
    public final Map<String, String> ecarts = new TreeMap<>();
    /** Raisons pour lesquelles l'enseignant doit examiner ce rendu. */
    public final List<String> aRegarder = new ArrayList<>();

    private Projet(Map<String, Type> squelette, Map<String, Type> types, Map<String, Map<String, Type>> autres, List<String> remarques) {
        this.squelette = squelette;
        this.remarques = new ArrayList<>(remarques);
        this.types = types;
        List<String> signatures = new ArrayList<>();
        base = avecPonts(types, signatures);
        autres.forEach((nom, siens) -> variantes.put(nom, avecPonts(siens, new ArrayList<>())));
        if (!signatures.isEmpty()) {
            dire("jugé comme s'il avait les signatures du cours : " + quelques(signatures));
        }
        changees = SourcesDuCours.classes().stream().filter(c -> texte(c) != null
                && !type(c).empreinte.equals(squelette.get(c).empreinte)).collect(Collectors.toSet());
    }

    /** Les textes, complétés par les méthodes de forme attendue. Les adaptations sont signalées une fois, sans pénalité. */
    private Map<String, String> avecPonts(Map<String, Type> siens, List<String> signatures) {
        Map<String, String> textes = new TreeMap<>();
        siens.forEach((nom, type) -> textes.put(nom, type.texte));
        SourcesDuCours.classes().stream().filter(c -> !SANS_PONT.contains(c))
                .forEach(c -> textes.computeIfPresent("lancer/" + c,
                        (nom, texte) -> siens.get(nom).avec(Signature.ponts(squelette.get(c), siens.get(nom), signatures))));
        return textes;
    }

    private static String quelques(Collection<String> noms) {
        return noms.stream().limit(NOMS_DITS).collect(Collectors.joining(", ")) + (noms.size() > NOMS_DITS ? "…" : "");
    }

    /** Les copies du projet que contient un rendu ; la base que nomme son dossier d'abord. */
    public static List<Projet> copies(Rendu rendu, Source.Lecture lecture, Cours cours) throws Arret {
        List<String> remarques = new ArrayList<>(rendu.remarques);
        remarques.addAll(rendu.refus);
        Map<String, byte[]> fichiers = new TreeMap<>(rendu.sources);
        fichiers.keySet().removeIf(chemin -> DE_TEST.matcher(chemin).matches());
        Map<String, List<Type>> racines = new TreeMap<>();
        for (Type type : Source.lire(fichiers, lecture, remarques)) {
            String intrusion = type.source.intrusion(type.nom);
            if (intrusion != null) {
                remarques.add(type.source.chemin + Contenu.DE_COTE + intrusion);
            } else {
                racines.computeIfAbsent(type.source.racine, r -> new ArrayList<>()).add(type);
            }
        }
        racines.values().forEach(types -> situer(types, cours));
        Set<String> projets = racines.keySet().stream().filter(r -> racines.get(r).stream().anyMatch(Projet::aCompleter))
                .map(Projet::dossier).collect(Collectors.toSet());
        Map<String, Map<String, List<Type>>> groupes = new TreeMap<>();
        racines.forEach((racine, siens) -> groupes.computeIfAbsent(partie(racine, projets), p -> new TreeMap<>()).put(racine, siens));
        List<String> laisses = new ArrayList<>();
        Map<String, Map<String, Type>> variantes = new LinkedHashMap<>();
        for (String nom : SourcesDuCours.VARIANTES) {
            Map<String, Map<String, Type>> siennes = choisir(groupes.getOrDefault(nom, Map.of()), laisses);
            siennes.values().stream().findFirst().ifPresent(premiere -> variantes.put(nom, premiere));
            if (siennes.size() > 1) {
                laisses.add(plusieurs("de l'extension " + nom + " : montrée", siennes, siennes.keySet().iterator().next()));
            }
        }
        Map<String, Map<String, Type>> bases = choisir(groupes.getOrDefault("", Map.of()), laisses);
        ecarter(bases.values(), laisses);
        if (bases.isEmpty() || !variantes.isEmpty() && bases.values().stream().noneMatch(b -> b.values().stream()
                .anyMatch(Projet::aCompleter))) {
            // une variante est une copie complète du projet
            String premiere = variantes.isEmpty() ? "" : variantes.keySet().iterator().next();
            remarques.add(premiere.isEmpty() ? "aucune classe à juger"
                    : "pas de projet de base : celui de « " + premiere + " » en tient lieu");
            bases = Map.of("", variantes.getOrDefault(premiere, new TreeMap<>()));
        }
        Map<String, Set<String>> dites = new TreeMap<>();
        Stream.concat(bases.values().stream(), variantes.values().stream()).flatMap(classes -> classes.values().stream()).forEach(type ->
                type.source.remarques.forEach(r -> dites.computeIfAbsent(r, q -> new TreeSet<>()).add(type.source.chemin)));
        dites.forEach((quoi, ou) -> remarques.add((ou.size() == 1 ? ou.iterator().next() + " : " + quoi
                : quoi + " (" + ou.size() + " fichiers)")));
        List<Projet> copies = new ArrayList<>();
        Set<Map<String, Type>> differentes = new HashSet<>();
        for (Map.Entry<String, Map<String, Type>> base : bases.entrySet()) {
            if (copies.size() < COPIES_MAX && differentes.add(base.getValue())) {
                Projet projet = new Projet(cours.squelette, base.getValue(), variantes, remarques);
                projet.consignes(rendu, dites.keySet());
                remarques.stream().filter(r -> r.contains(Contenu.DE_COTE)).forEach(projet.aRegarder::add);
                laisses.forEach(projet::dire);
                projet.absences();
                String duCorrige = SourcesDuCours.A_COMPLETER.stream().filter(c -> projet.texte(c) != null
                        && cours.provenance(projet.type(c)) == 2).collect(Collectors.joining(", "));
                if (!duCorrige.isEmpty()) {
                    projet.aRegarder.add("le même texte que le corrigé, aux commentaires près : " + duCorrige);
                }
                if (bases.size() > 1) {
                    projet.dire(plusieurs("du projet : jugée", bases, base.getKey()));
                }
                copies.add(projet);
            }
        }
        return copies;
    }

    /**
     * Dit d'où viennent les textes d'un dossier. Un étudiant écrit de lui-même quelques classes comme le corrigé : elles n'en viennent que
     * si la plupart de celles du dossier sont celles du corrigé.
     */
    private static void situer(List<Type> types, Cours cours) {
        types.forEach(t -> t.provenance = cours.provenance(t));
        long duCorrige = types.stream().filter(t -> aCompleter(t) && t.provenance == 2).count();
        if (2 * duCorrige <= types.stream().filter(Projet::aCompleter).count()) {
            types.stream().filter(t -> t.provenance == 2).forEach(t -> t.provenance = 0);
        }
    }

    private static boolean aCompleter(Type type) {
        return SourcesDuCours.A_COMPLETER.contains(type.nom);
    }

    private static String plusieurs(String copies, Map<String, Map<String, Type>> toutes, String gardee) {
        return "plusieurs copies " + copies + ", « " + gardee + " » ; laissée, « " + toutes.keySet().stream()
                .filter(r -> !r.equals(gardee)).collect(Collectors.joining(" », « ")) + " »";
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

    /** Ajoute une remarque pour l'étudiant et pour l'enseignant. */
    private void dire(String quoi) {
        remarques.add(quoi);
        aRegarder.add(quoi);
    }

    /** Signale les classes et les méthodes absentes, avec les noms inconnus qui pourraient les remplacer. L'enseignant décide. */
    private void absences() {
        List<Type> inconnus = types.values().stream().filter(t -> !SourcesDuCours.classes().contains(t.nom)).collect(Collectors.toList());
        List<String> absentes = new ArrayList<>();
        for (String classe : SourcesDuCours.classes()) {
            Set<String> attendues = squelette.get(classe).nommees();
            if (texte(classe) != null) {
                (SourcesDuCours.A_COMPLETER.contains(classe) ? attendues : Set.<String>of()).stream()
                        .filter(m -> !type(classe).nommees().contains(m)).forEach(m -> absente(classe, m));
            } else if (SourcesDuCours.A_COMPLETER.contains(classe) || !SANS_PONT.contains(classe) && !inconnus.isEmpty()
                    && types.values().stream().noneMatch(t -> t.noms.contains(classe))) {
                String siens = inconnus.stream().filter(t -> 2 * t.parmi(attendues) > attendues.size()).map(t -> " ; " + t.nom + " a "
                        + t.parmi(attendues) + " de ses " + attendues.size() + " méthodes : pour la juger, remplacez partout " + t.nom
                        + " par " + classe + " dans une copie du rendu, et jugez cette copie").collect(Collectors.joining());
                if (siens.isEmpty()) {
                    absentes.add(classe);
                } else {
                    aRegarder.add(classe + " absente" + siens);
                }
            }
        }
        // si presque toutes les classes sont absentes, l'étudiant a seulement commencé, ou a rendu autre chose
        if (!absentes.isEmpty() && 2 * absentes.size() < SourcesDuCours.A_COMPLETER.size()) {
            aRegarder.add(String.join(", ", absentes) + (absentes.size() > 1 ? " absentes" : " absente") + (inconnus.isEmpty() ? ""
                    : " ; les classes qui ne sont pas du cours : " + inconnus.stream().map(t -> t.nom).collect(Collectors.joining(", "))));
        }
        long presentes = SourcesDuCours.A_COMPLETER.stream().filter(c -> type(c).parmi(squelette.get(c).nommees()) > 0).count();
        if (presentes < 2 && inconnus.size() > presentes) {
            aRegarder.add(0, "un autre projet : " + (presentes == 0 ? "aucune" : "une") + " des " + SourcesDuCours.A_COMPLETER.size()
                    + " classes à compléter n'y est comme dans le cours ; les siennes sont "
                    + quelques(inconnus.stream().map(t -> t.nom).sorted().collect(Collectors.toList())));
        }
    }

    /** Signale une méthode absente, avec la classe qui la contient à sa place, ou celles de mêmes types dans la sienne. */
    private void absente(String classe, String methode) {
        List<String> ailleurs = SourcesDuCours.classes().stream().filter(c -> type(c).nommees().contains(methode)
                && !squelette.get(c).nommees().contains(methode)).collect(Collectors.toList());
        String siennes = type(classe).methodes.stream().filter(s -> !squelette.get(classe).nommees().contains(s.nom)
                && squelette.get(classe).methodes.stream().anyMatch(m -> m.nom.equals(methode) && s.types.equals(m.types)
                && s.rend.equals(m.rend))).map(s -> s.nom).distinct().collect(Collectors.joining(", "));
        if (!siennes.isEmpty()) {
            aRegarder.add(classe + "." + methode + " absente ; prend et rend la même chose : " + siennes);
        } else if (!ailleurs.isEmpty()) {
            dire("la méthode " + methode + " est dans " + String.join(", ", ailleurs) + ", au lieu de " + classe);
            noter(NOMS, "la méthode " + methode + " n'est pas dans " + classe);
        }
    }

    private void consignes(Rendu rendu, Set<String> arrangees) {
        arrangees.forEach(quoi -> noter(quoi.contains("UTF-8") ? TEXTE : NOMS, quoi));
        if (!rendu.outils.isEmpty()) {
            ecarts.put(OUTILS, "rendus aussi : " + quelques(rendu.outils));
        }
        long tabulations = base.values().stream().filter(t -> t.contains("\n\t")).count();
        if (tabulations > 0) {
            noter(TEXTE, "des tabulations dans " + tabulations + (tabulations > 1 ? " classes" : " classe"));
        }
        List<String> jointes = rendu.bibliotheques.stream().filter(b -> !FOURNIE.matcher(b).matches()).collect(Collectors.toList());
        if (!jointes.isEmpty()) {
            dire("jugé sans la bibliothèque qu'il joint : " + String.join(", ", jointes));
        }
    }

    /** Note qu'une consigne n'est pas suivie. */
    public void noter(String consigne, String ecart) {
        ecarts.merge(consigne, ecart, (a, b) -> a + " ; " + b);
    }

    /**
     * Choisit les copies du projet parmi les dossiers qui contiennent des classes. La première est le dossier qui a le plus de classes du
     * cours, complété par les dossiers qui n'ajoutent que des classes absentes. Les autres suivent.
     *
     * @param laisses reçoit les fichiers qui déclarent une classe lue dans un autre fichier
     */
    private static Map<String, Map<String, Type>> choisir(Map<String, List<Type>> groupes, List<String> laisses) {
        ToIntFunction<Type> rang = t -> 8 * t.provenance + t.source.rang(t.nom);
        List<String> racines = new ArrayList<>(groupes.keySet());
        racines.sort(Comparator.comparing((String r) -> -groupes.get(r).stream().filter(Projet::aCompleter).map(t -> t.nom).distinct()
                .count()).thenComparing(r -> !dossier(r).toLowerCase(Locale.ROOT).contains("base")).thenComparing(String::length));
        Map<String, Map<String, Type>> copies = new LinkedHashMap<>();
        for (String racine : racines) {
            List<Type> siens = groupes.get(racine);
            siens.sort(Comparator.comparingInt(rang).thenComparing(t -> t.source.chemin.split("/").length));
            Map<String, Type> copie = copies.values().stream().filter(c -> siens.stream().map(Type::chemin).distinct()
                    .filter(c::containsKey).count() <= 2).findFirst().orElseGet(() -> copies.computeIfAbsent(racine, r -> new TreeMap<>()));
            for (Type type : siens) {
                Type autre = copie.get(type.chemin());
                Type garde = autre == null || rang.applyAsInt(type) < rang.applyAsInt(autre) ? type : autre;
                copie.put(type.chemin(), garde);
                if (autre != null) {
                    laisses.add((garde == type ? autre : type).source.chemin + Contenu.DE_COTE + type.nom + " est dans "
                            + garde.source.chemin);
                }
            }
        }
        return copies;
    }

    /**
     * Un texte du corrigé, ou du projet à compléter, ne prend la place d'aucun autre texte de sa classe. Une copie qui n'a que ces textes
     * disparaît.
     */
    private static void ecarter(Collection<Map<String, Type>> copies, List<String> laisses) {
        Map<String, Type> meilleurs = new TreeMap<>();
        copies.forEach(copie -> copie.forEach((nom, type) -> meilleurs.merge(nom, type, (a, b) -> b.provenance < a.provenance ? b : a)));
        Map<String, String> ecartes = new TreeMap<>();
        copies.removeIf(copie -> {
            List<Type> siennes = SourcesDuCours.classes().stream().map(c -> copie.get("lancer/" + c)).filter(Objects::nonNull)
                    .collect(Collectors.toList());
            List<Type> laissees = siennes.stream().filter(t -> t.provenance > meilleurs.get(t.chemin()).provenance)
                    .collect(Collectors.toList());
            for (Type type : laissees) {
                copie.put(type.chemin(), meilleurs.get(type.chemin()));
                String pourquoi = "c'est le texte " + (type.provenance == 2 ? "du corrigé" : "à compléter") + " ; un autre est jugé";
                ecartes.merge(type.source.chemin.replaceFirst("[^/]*$", "") + Contenu.DE_COTE + pourquoi, type.nom,
                        (a, b) -> a + ", " + b);
            }
            return laissees.stream().anyMatch(Projet::aCompleter)
                    && siennes.stream().filter(Projet::aCompleter).allMatch(laissees::contains);
        });
        ecartes.forEach((pourquoi, classes) -> laisses.add(pourquoi + " : " + classes));
    }

    /** Le texte d'une classe du cours ; {@code null} si elle n'est pas rendue. */
    public String texte(String classe) {
        return base.get("lancer/" + classe);
    }

    /** La classe lue ; vide si elle n'est pas rendue, ou si son fichier ne la déclare pas. */
    public Type type(String classe) {
        return types.getOrDefault("lancer/" + classe, Type.rien(""));
    }
}
