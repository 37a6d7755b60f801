package lancer.correction.depot;

import java.text.Normalizer;
import java.util.ArrayList;
import java.util.Collection;
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

    static final String DE_COTE = " : laissé de côté, ";

    /** Nombre maximal de copies du projet qui sont comparées. */
    private static final int COPIES_MAX = 3;
    private static final int NOMS_DITS = 5;

    private static final Pattern VARIANTE =
            Pattern.compile("(?i)(?:^|/)[^/]*?(brume|anti[-_ ]?alias|anti[-_ ]?crenelage|blinn)[^/]*/");
    /** Fichiers qui ne sont pas jugés : les tests qui notent sont ceux de la correction. */
    private static final Pattern DE_TEST =
            Pattern.compile("(?s)(?:^|.*/)(?:src/test/.*|(?:Tests|Etapes|module-info|package-info)\\.java)", Pattern.CASE_INSENSITIVE);
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
    /** Les classes du cours, sous les noms de l'étudiant. */
    public final Cours cours;
    /** Les classes du cours que l'étudiant a modifiées, par rapport au projet à compléter. */
    public final Set<String> changees;
    /** Écarts aux consignes de l'énoncé, par consigne. */
    public final Map<String, String> ecarts = new TreeMap<>();
    /** Raisons pour lesquelles l'enseignant doit examiner ce rendu. */
    public final List<String> aRegarder = new ArrayList<>();

    private Projet(Cours cours, Map<String, Type> types, Map<String, Map<String, Type>> autres, List<String> remarques) {
        this.cours = cours;
        this.remarques = new ArrayList<>(remarques);
        this.types = types;
        List<String> signatures = new ArrayList<>();
        base = avecPonts(types, signatures);
        autres.forEach((nom, siens) -> variantes.put(nom, avecPonts(siens, new ArrayList<>())));
        if (!signatures.isEmpty()) {
            dire("jugé comme s'il avait les signatures du cours : " + quelques(signatures));
        }
        changees = SourcesDuCours.classes().stream().filter(c -> texte(c) != null
                && !type(c).empreinte.equals(cours.squelette(c).empreinte)).collect(Collectors.toSet());
    }

    /** Les textes, complétés par les méthodes de forme attendue. Les adaptations sont signalées une fois, sans pénalité. */
    private Map<String, String> avecPonts(Map<String, Type> siens, List<String> signatures) {
        Map<String, String> textes = new TreeMap<>();
        siens.forEach((nom, type) -> textes.put(nom, type.texte));
        SourcesDuCours.classes().stream().filter(c -> !SANS_PONT.contains(c))
                .forEach(c -> textes.computeIfPresent("lancer/" + cours.classe(c),
                        (nom, texte) -> siens.get(nom).avec(Signature.ponts(cours.squelette(c), siens.get(nom), signatures))));
        return textes;
    }

    private static String quelques(Collection<String> noms) {
        return noms.stream().limit(NOMS_DITS).collect(Collectors.joining(", ")) + (noms.size() > NOMS_DITS ? "…" : "");
    }

    /**
     * Les copies du projet que contient un rendu, de la plus modifiée à la moins modifiée.
     *
     * @param commun le cours, sans noms changés ; @param alias noms que l'enseignant déclare changés : celui du cours, puis le sien
     */
    public static List<Projet> copies(Rendu rendu, Cours.LectureDeSources lecture, Cours commun, Map<String, String> alias) throws Arret {
        List<String> remarques = new ArrayList<>(rendu.remarques);
        remarques.addAll(rendu.refus);
        Map<String, byte[]> fichiers = new TreeMap<>(rendu.sources);
        fichiers.keySet().removeIf(chemin -> DE_TEST.matcher(chemin).matches());
        Set<String> duCours = new TreeSet<>(SourcesDuCours.classes());
        duCours.addAll(alias.values());
        List<Type> tous = Source.lire(fichiers, lecture, duCours, remarques);
        Map<String, Map<String, List<Type>>> groupes = new TreeMap<>();
        for (Type type : tous) {
            String intrusion = type.source.intrusion(type.nom);
            if (intrusion != null) {
                remarques.add(type.source.chemin + DE_COTE + intrusion);
                continue;
            }
            Matcher m = VARIANTE.matcher(Normalizer.normalize(type.source.racine, Normalizer.Form.NFD).replaceAll("\\p{M}", ""));
            String partie = m.find() ? m.group(1).toLowerCase(Locale.ROOT).replaceFirst("^anti.*", "antialias") : "";
            groupes.computeIfAbsent(partie, p -> new TreeMap<>()).computeIfAbsent(type.source.racine, r -> new ArrayList<>()).add(type);
        }
        Map<String, Map<String, Type>> variantes = new LinkedHashMap<>();
        SourcesDuCours.VARIANTES.stream().filter(groupes::containsKey)
                .forEach(nom -> variantes.put(nom, choisir(groupes.get(nom)).values().iterator().next()));
        Map<String, Map<String, Type>> bases = choisir(groupes.getOrDefault("", Map.of()));
        if (bases.isEmpty()) {
            // une variante est une copie complète du projet
            String premiere = variantes.isEmpty() ? "" : variantes.keySet().iterator().next();
            remarques.add(premiere.isEmpty() ? "aucune classe à juger"
                    : "pas de projet de base : celui de « " + premiere + " » en tient lieu");
            bases.put("", variantes.getOrDefault(premiere, new TreeMap<>()));
        }
        Map<String, Set<String>> dites = new TreeMap<>();
        Stream.concat(bases.values().stream(), variantes.values().stream()).flatMap(classes -> classes.values().stream()).forEach(type ->
                type.source.remarques.forEach(r -> dites.computeIfAbsent(r, q -> new TreeSet<>()).add(type.source.chemin)));
        dites.forEach((quoi, ou) -> remarques.add((ou.size() == 1 ? ou.iterator().next() + " : " + quoi
                : quoi + " (" + ou.size() + " fichiers)")));
        Map<String, String> declares = new TreeMap<>(alias);
        declares.values().removeIf(nom -> tous.stream().noneMatch(t -> t.nom.equals(nom) || t.nommees().contains(nom)));
        declares.keySet().removeIf(nom -> tous.stream().anyMatch(t -> t.nommees().contains(nom)));
        Cours cours = declares.isEmpty() ? commun : new Cours(lecture, declares);
        return bases.keySet().stream().limit(COPIES_MAX).map(racine -> {
            Projet projet = new Projet(cours, bases.get(racine), variantes, remarques);
            projet.consignes(rendu, dites.keySet());
            remarques.stream().filter(r -> r.contains(DE_COTE)).forEach(r -> projet.aRegarder.add("arrêté : " + r));
            alias.forEach(projet::declarer);
            projet.absences(rendu.id);
            if (bases.size() > 1) {
                projet.dire("plusieurs copies du projet : jugée, « " + racine + " » ; laissée, « " + bases.keySet().stream()
                        .filter(r -> !r.equals(racine)).collect(Collectors.joining(" », « ")) + " »");
            }
            return projet;
        }).sorted(Comparator.comparing(projet -> -projet.changees.size())).collect(Collectors.toList());
    }

    /** Ajoute une remarque pour l'étudiant et pour l'enseignant. */
    private void dire(String quoi) {
        remarques.add(quoi);
        aRegarder.add(quoi);
    }

    private void declarer(String duCours, String sien) {
        if (cours.dans(duCours).equals(sien)) {
            remarques.add(duCours + " s'appelle " + sien);
            noter(NOMS, duCours + " s'appelle " + sien);
        } else {
            aRegarder.add("alias.csv : « " + sien + " » n'est le nom de rien dans ce rendu, ou « " + duCours + " » y est encore");
        }
    }

    /** Signale les classes et les méthodes absentes, avec les noms inconnus qui pourraient les remplacer. L'enseignant décide. */
    private void absences(String id) {
        List<Type> inconnus = types.values().stream().filter(t -> !SourcesDuCours.classes().contains(t.nom)
                && SourcesDuCours.classes().stream().noneMatch(c -> cours.classe(c).equals(t.nom))).collect(Collectors.toList());
        List<String> absentes = new ArrayList<>();
        for (String classe : SourcesDuCours.classes()) {
            Set<String> attendues = cours.squelette(classe).nommees();
            if (texte(classe) != null) {
                (SourcesDuCours.A_COMPLETER.contains(classe) ? attendues : Set.<String>of()).stream()
                        .filter(m -> !type(classe).nommees().contains(m)).forEach(m -> chercher(id, classe, m));
            } else if (SourcesDuCours.A_COMPLETER.contains(classe) || !SANS_PONT.contains(classe) && !inconnus.isEmpty()
                    && types.values().stream().noneMatch(t -> t.noms.contains(classe))) {
                String siens = inconnus.stream().filter(t -> 2 * t.parmi(attendues) > attendues.size()).map(t -> " ; " + t.nom + " a "
                        + t.parmi(attendues) + " de ses " + attendues.size() + " méthodes" + declaration(id, t.nom, classe))
                        .collect(Collectors.joining());
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
        long presentes = SourcesDuCours.A_COMPLETER.stream().filter(c -> type(c).parmi(cours.squelette(c).nommees()) > 0).count();
        List<String> autres = types.values().stream().map(t -> t.nom).filter(n -> !SourcesDuCours.classes().contains(n)).sorted()
                .collect(Collectors.toList());
        if (presentes < 2 && autres.size() > presentes) {
            aRegarder.add(0, "un autre projet : " + (presentes == 0 ? "aucune" : "une") + " des " + SourcesDuCours.A_COMPLETER.size()
                    + " classes à compléter n'y est comme dans le cours ; les siennes sont "
                    + quelques(autres));
        }
    }

    /** Cherche la seule méthode inconnue de mêmes types que la méthode absente ou, à défaut, une autre classe qui contient celle-ci. */
    private void chercher(String id, String classe, String methode) {
        Set<String> connues = cours.squelette(classe).nommees();
        Set<String> semblables = cours.squelette(classe).methodes.stream().filter(m -> m.nom.equals(methode))
                .flatMap(m -> type(classe).methodes.stream().filter(s -> !connues.contains(s.nom) && s.types.equals(m.types)
                && s.rend.equals(m.rend))).map(s -> s.nom).collect(Collectors.toSet());
        List<String> ailleurs = SourcesDuCours.classes().stream().filter(c -> type(c).nommees().contains(methode))
                .collect(Collectors.toList());
        if (semblables.size() == 1) {
            String nom = semblables.iterator().next();
            // si ce nom sert encore ailleurs, il ne peut être changé partout
            String ligne = ailleurs.isEmpty() ? declaration(id, nom, methode) : "";
            if (ligne.isEmpty() || aRegarder.stream().noneMatch(r -> r.endsWith(ligne))) {
                aRegarder.add(classe + "." + methode + " absente ; " + nom + " prend et rend la même chose" + ligne);
            }
        } else if (semblables.isEmpty() && ailleurs.size() == 1 && !cours.squelette(ailleurs.get(0)).nommees().contains(methode)) {
            String dit = "la méthode " + methode + " est dans " + ailleurs.get(0) + ", au lieu de " + classe;
            dire(dit);
            noter(NOMS, dit);
        }
    }

    private static String declaration(String id, String sien, String duCours) {
        return " ; pour la déclarer, dans alias.csv : " + Alias.ligne(id, sien, duCours);
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
     */
    private static Map<String, Map<String, Type>> choisir(Map<String, List<Type>> groupes) {
        List<String> racines = new ArrayList<>(groupes.keySet());
        racines.sort(Comparator.comparing((String r) -> -groupes.get(r).stream()
                .filter(t -> SourcesDuCours.A_COMPLETER.contains(t.nom)).count())
                .thenComparing(String::length));
        Map<String, Map<String, Type>> copies = new LinkedHashMap<>();
        for (String racine : racines) {
            List<Type> siens = groupes.get(racine);
            Map<String, Type> copie = copies.values().stream().filter(c -> siens.stream().filter(t -> c.containsKey("lancer/" + t.nom))
                    .count() <= 2).findFirst().orElseGet(() -> copies.computeIfAbsent(racine, r -> new TreeMap<>()));
            siens.forEach(type -> copie.putIfAbsent(type.chemin(), type));
        }
        return copies;
    }

    /** Le texte d'une classe du cours, sous le nom de l'étudiant ; {@code null} si elle n'est pas rendue. */
    public String texte(String classe) {
        return base.get("lancer/" + cours.classe(classe));
    }

    /** La classe lue ; vide si elle n'est pas rendue, ou si son fichier ne la déclare pas. */
    public Type type(String classe) {
        return types.getOrDefault("lancer/" + cours.classe(classe), Type.rien(""));
    }
}
