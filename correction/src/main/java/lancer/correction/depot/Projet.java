package lancer.correction.depot;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.correction.enfant.Texte;
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

    private static final int NOMS_DITS = 5;

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
    /** Les formes des longues méthodes de l'étudiant, par leur nom. */
    public final Map<String, String> formes = new TreeMap<>();
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

    /** Le projet que contient un rendu. */
    public static Projet lire(Rendu rendu, Source.Lecture lecture, Cours cours) throws Arret {
        List<String> remarques = new ArrayList<>(rendu.remarques);
        remarques.addAll(rendu.refus);
        List<String> illisibles = new ArrayList<>();
        Choix choix = new Choix(Source.lire(rendu.sources, lecture, illisibles), cours, lecture);
        choix.dites.addAll(0, illisibles);
        Map<String, Type> base = choix.base;
        if (base.isEmpty() || !choix.variantes.isEmpty()
                && base.values().stream().noneMatch(t -> SourcesDuCours.A_COMPLETER.contains(t.nom))) {
            // une variante est une copie complète du projet
            String premiere = choix.variantes.isEmpty() ? "" : choix.variantes.keySet().iterator().next();
            remarques.add(premiere.isEmpty() ? "aucune classe à juger"
                    : "pas de projet de base : celui de « " + premiere + " » en tient lieu");
            base = choix.variantes.getOrDefault(premiere, new TreeMap<>());
        }
        Projet projet = new Projet(cours.squelette, base, choix.variantes, remarques);
        projet.constater(rendu, choix, cours);
        return projet;
    }

    /** Dit ce que le choix des classes a arrangé, laissé de côté, ou cherché en vain. */
    private void constater(Rendu rendu, Choix choix, Cours cours) {
        choix.dites.forEach(this::dire);
        Map<String, Set<String>> ou = new TreeMap<>();
        Map<String, String> consigne = new TreeMap<>();
        Stream.concat(Stream.of(types), choix.variantes.values().stream()).flatMap(classes -> classes.values().stream()).forEach(type ->
                type.source.remarques.forEach((quoi, laquelle) -> {
                    ou.computeIfAbsent(quoi, q -> new TreeSet<>()).add(type.source.chemin);
                    consigne.put(quoi, laquelle);
                }));
        ou.forEach((quoi, chemins) -> {
            String remarque = chemins.size() == 1 ? chemins.iterator().next() + " : " + quoi : quoi + " (" + chemins.size() + " fichiers)";
            if (consigne.get(quoi).isEmpty()) {
                dire(remarque);
            } else {
                remarques.add(remarque);
                noter(consigne.get(quoi), quoi);
            }
        });
        consignes(rendu);
        absences(rendu);
        cours.ecrites(types.values(), false).forEach((nom, methode) -> formes.put(nom, methode.forme));
        Set<String> duCorrige = cours.commeLeCorrige(types.values());
        if (!duCorrige.isEmpty()) {
            aRegarder.add("écrit comme le corrigé, aux noms et aux commentaires près : " + quelques(duCorrige));
        }
    }

    /** Les noms de ces classes. */
    static String noms(Collection<Type> types) {
        return quelques(types.stream().map(t -> t.nom).distinct().sorted().collect(Collectors.toList()));
    }

    /** Ajoute une remarque pour l'étudiant et pour l'enseignant. */
    private void dire(String quoi) {
        remarques.add(quoi);
        aRegarder.add(quoi);
    }

    /** Signale les classes et les méthodes absentes, avec les noms inconnus qui pourraient les remplacer. L'enseignant décide. */
    private void absences(Rendu rendu) {
        List<Type> inconnus = types.values().stream().filter(t -> !SourcesDuCours.classes().contains(t.nom)).collect(Collectors.toList());
        List<String> absentes = new ArrayList<>();
        Map<String, String> duCours = new TreeMap<>();
        for (String classe : SourcesDuCours.classes()) {
            if (texte(classe) == null && !rendu.vides.containsKey(classe) && (SourcesDuCours.A_COMPLETER.contains(classe)
                    || !SANS_PONT.contains(classe) && !inconnus.isEmpty()
                    && types.values().stream().noneMatch(t -> t.noms.contains(classe)))) {
                Set<String> attendues = squelette.get(classe).nommees();
                Type sienne = inconnus.stream().filter(t -> 2 * t.parmi(attendues) > attendues.size())
                        .max(Comparator.comparing(t -> t.parmi(attendues))).orElse(null);
                if (sienne == null) {
                    absentes.add(classe);
                } else {
                    duCours.put(sienne.nom, classe);
                    noter(NOMS, classe + " s'appelle " + sienne.nom);
                    aRegarder.add(classe + " absente ; " + sienne.nom + " a " + sienne.parmi(attendues) + " de ses " + attendues.size()
                            + " méthodes : pour la juger, remplacez partout " + sienne.nom + " par " + classe
                            + " dans une copie du rendu, et jugez cette copie");
                }
            }
        }
        SourcesDuCours.A_COMPLETER.stream().filter(c -> texte(c) != null).forEach(classe -> squelette.get(classe).nommees().stream()
                .filter(m -> !type(classe).nommees().contains(m)).forEach(m -> absente(classe, m, duCours)));
        // si presque toutes les classes sont absentes, l'étudiant a seulement commencé, ou a rendu autre chose
        if (!absentes.isEmpty() && 2 * absentes.size() < SourcesDuCours.A_COMPLETER.size()) {
            String siennes = inconnus.isEmpty() ? "" : " ; les classes qui ne sont pas du cours : " + noms(inconnus);
            aRegarder.add(String.join(", ", absentes) + (absentes.size() > 1 ? " absentes" : " absente") + siennes);
        }
        long presentes = SourcesDuCours.A_COMPLETER.stream().filter(c -> type(c).parmi(squelette.get(c).nommees()) > 0).count();
        if (presentes < 2 && inconnus.size() > presentes) {
            aRegarder.add(0, "un autre projet : " + (presentes == 0 ? "aucune" : "une") + " des " + SourcesDuCours.A_COMPLETER.size()
                    + " classes à compléter n'y est comme dans le cours ; les siennes sont " + noms(inconnus));
        }
    }

    /**
     * Signale une méthode absente, avec la classe qui la contient à sa place, ou celles de mêmes types dans la sienne.
     *
     * @param duCours les noms des classes du cours, par ceux que l'étudiant leur a donnés
     */
    private void absente(String classe, String methode, Map<String, String> duCours) {
        List<String> ailleurs = SourcesDuCours.classes().stream().filter(c -> type(c).nommees().contains(methode)
                && !squelette.get(c).nommees().contains(methode)).collect(Collectors.toList());
        String siennes = type(classe).methodes.stream().filter(s -> !squelette.get(classe).nommees().contains(s.nom)
                && squelette.get(classe).methodes.stream().anyMatch(m -> m.nom.equals(methode) && s.memesTypes(m, duCours)))
                .map(s -> s.nom).distinct().collect(Collectors.joining(", "));
        if (!siennes.isEmpty()) {
            aRegarder.add(classe + "." + methode + " absente ; prend et rend la même chose : " + siennes);
            noter(NOMS, classe + "." + methode + " s'appelle " + siennes);
        } else if (!ailleurs.isEmpty()) {
            dire("la méthode " + methode + " est dans " + String.join(", ", ailleurs) + ", au lieu de " + classe);
            noter(NOMS, "la méthode " + methode + " n'est pas dans " + classe);
        }
    }

    private void consignes(Rendu rendu) {
        if (!rendu.outils.isEmpty()) {
            ecarts.put(OUTILS, "rendus aussi : " + quelques(rendu.outils));
        }
        long tabulations = base.values().stream().filter(t -> t.contains("\n\t")).count();
        if (tabulations > 0) {
            noter(TEXTE, "des tabulations dans " + Texte.compter(tabulations, "classe"));
        }
        List<String> jointes = rendu.bibliotheques.stream().filter(b -> !FOURNIE.matcher(b).matches()).collect(Collectors.toList());
        if (!jointes.isEmpty()) {
            dire("jugé sans la bibliothèque qu'il joint : " + quelques(jointes));
        }
    }

    /** Note qu'une consigne n'est pas suivie. */
    public void noter(String consigne, String ecart) {
        ecarts.merge(consigne, ecart, (a, b) -> a + " ; " + b);
    }

    /** Dit si cette classe rendue a des méthodes que celle du cours n'a pas. */
    public boolean augmentee(String classe) {
        return !squelette.get(classe).nommees().containsAll(type(classe).nommees());
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
