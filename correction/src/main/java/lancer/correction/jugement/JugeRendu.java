package lancer.correction.jugement;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.correction.depot.Faute;
import lancer.correction.depot.Projet;
import lancer.correction.depot.Signature;
import lancer.correction.isolement.Arret;
import lancer.correction.jugement.Machines.Assemblage;
import lancer.correction.jugement.Verdict.Etat;
import lancer.correction.modele.SourcesDuCours;

/** Juge un rendu : toutes ses classes ensemble, puis chacune seule avec celles du corrigé. Une faute n'en cache ainsi pas d'autres. */
final class JugeRendu implements AutoCloseable {

    /** Étapes qui complètent une méthode déjà écrite pour une étape précédente. */
    private static final Set<String> DANS_LA_MEME_METHODE = Set.of("phong", "ombres", "reflets");

    final Reference reference;
    private final Machines.Compilation compilation;
    private final Machines machines;
    private final Projet projet;
    /** La machine virtuelle de l'ensemble, et celle d'un autre assemblage. */
    private final Machines.Rendue[] vives;
    final Resultat resultat;
    final JugeImage images;
    final Assemblage ensemble;
    private final Map<String, Assemblage> seules = new HashMap<>();
    /** Classes dont dépend une classe qui ne se compile pas seule avec le corrigé. */
    private final Map<String, String> dependances = new HashMap<>();
    /** Vérifications que la classe visée réussit seule, et rate avec les autres classes du rendu. */
    private final List<Verification> cachees = new ArrayList<>();

    JugeRendu(Reference reference, Machines.Compilation compilation, Machines machines, Projet projet, Resultat resultat)
            throws Arret {
        this.reference = reference;
        this.compilation = compilation;
        this.machines = machines;
        this.projet = projet;
        this.resultat = resultat;
        vives = new Machines.Rendue[] {machines.new Rendue(null), machines.new Rendue(null)};
        images = new JugeImage(this, reference);
        ensemble = assembler(base(Map.of()));
    }

    /** Compile des classes avec celles qui les appellent et les sondent. */
    Assemblage assembler(Map<String, String> classes) throws Arret {
        Map<String, String> sources = new TreeMap<>(classes);
        sources.put("lancer/Appels", reference.appels);
        sources.put("lancer/Sonde", SourcesDuCours.ressource("sondes/lancer/Sonde.java"));
        return compilation.compiler(sources);
    }

    /** Sources du projet à compléter, remplacées par celles du rendu, puis par ces classes. */
    private Map<String, String> base(Map<String, String> enPlus) {
        Map<String, String> sources = SourcesDuCours.tout(SourcesDuCours::squelette);
        sources.putAll(projet.base);
        sources.putAll(enPlus);
        return sources;
    }

    Machines.Rendue machine(Assemblage assemblage) {
        int place = assemblage == ensemble ? 0 : 1;
        if (vives[place].assemblage != assemblage) {
            vives[place].close();
            vives[place] = machines.new Rendue(assemblage);
        }
        return vives[place];
    }

    /** Arrête les machines virtuelles. */
    @Override
    public void close() {
        vives[0].close();
        vives[1].close();
    }

    /** @throws Arret si ces classes ne se compilent pas, ou si une machine virtuelle ne peut les charger */
    void juger() throws Arret {
        machine(ensemble).commencer(1);
        resultat.remarques.addAll(projet.remarques);
        resultat.aRegarder.addAll(projet.aRegarder);
        resultat.formes.putAll(projet.formes);
        SourcesDuCours.A_COMPLETER.stream().filter(c -> projet.texte(c) == null).forEach(c -> resultat.remarques.add("la classe " + c
                + " manque : celle du projet à compléter en tient lieu"));
        Verifications.Bilan toutes = lancer(ensemble, reference.verifications);
        Map<String, Verdict> parSeule = new HashMap<>();
        for (String classe : changees(SourcesDuCours.A_COMPLETER)) {
            List<Verification> aReprendre = verifications(v -> v.classe.equals(classe)
                    && toutes.verdicts.get(v.id()).etat != Etat.REUSSI);
            if (!aReprendre.isEmpty()) {
                parSeule.putAll(lancer(seule(classe), aReprendre).verdicts);
            }
        }
        Set<String> fausses = verifications(v -> toutes.verdicts.get(v.id()).etat != Etat.REUSSI).stream().map(v -> v.classe)
                .collect(Collectors.toSet());
        if (fausses.contains("Objet3D") && projet.changees.contains("Lancer")) {
            // elles prennent pour attendu ce que rend getColor : elles ne valent que s'il est juste
            parSeule.putAll(lancer(seule("Lancer"), verifications(v -> v.classe.equals("Lancer"))).verdicts);
            verifications(v -> v.classe.equals("Lancer")).forEach(v -> toutes.verdicts.put(v.id(), parSeule.get(v.id())));
        }
        for (Verification v : reference.verifications) {
            resultat.verdicts.put(v.id(), conclure(v, toutes.verdicts.get(v.id()), parSeule.get(v.id())));
        }
        imputer();
        if (toutes.coupe()) {
            Reference.SCENES.keySet().forEach(scene -> resultat.verdicts.put(GrilleDeNotation.IMAGE + "." + scene,
                    new Verdict(Etat.FAUSSE, "", "trop de vérifications n'ont pas fini : " + toutes.pourquoi)));
        } else {
            // une nouvelle machine virtuelle : les vérifications ne peuvent avoir d'effet sur l'image
            close();
            images.juger();
        }
        for (Map.Entry<String, Map<String, String>> variante : projet.variantes.entrySet()) {
            // une variante est une copie du projet ; une classe absente est celle de la base
            images.montrer(variante.getKey(), assembler(base(variante.getValue())));
        }
        new Constats(this, projet).dire();
    }

    /**
     * Attribue à une autre classe les vérifications que la classe visée réussit seule. Si l'autre classe n'a aucune faute par ailleurs, la
     * vérification lui coûte des points ; une classe donnée achevée, que l'étudiant a changée, paie tout ce qu'elle rend faux. Si aucune
     * classe n'échoue seule, la vérification coûte à la classe visée.
     */
    private void imputer() throws Arret {
        List<String> suspectes = new ArrayList<>(SourcesDuCours.A_COMPLETER);
        suspectes.sort(Comparator.comparing(classe -> !aUneFaute(classe)));
        suspectes.addAll(changees(SourcesDuCours.DONNEES));
        for (String classe : suspectes) {
            if (cachees.isEmpty() || seules.containsKey(classe) && seules.get(classe).arrete) {
                continue;
            }
            boolean paie = SourcesDuCours.A_COMPLETER.contains(classe) && aUneFaute(classe);
            Map<String, Verdict> parElle = lancer(seule(classe), cachees).verdicts;
            retirer(parElle).forEach(v -> charger(v, paie ? Etat.REUSSI : Etat.FAUSSE, parElle.get(v.id()).message, classe));
        }
        chercherCeQuiEstGarde();
        // les fautes déjà comptées expliquent les vérifications restantes ; sans faute comptée, l'enseignant doit examiner le rendu
        cachees.removeIf(v -> SourcesDuCours.A_COMPLETER.stream().anyMatch(this::aUneFaute));
        for (Verification v : cachees) {
            charger(v, Etat.FAUSSE, resultat.verdicts.get(v.id()).message, v.classe);
            resultat.regarder("« " + v.titre + " » n'échoue qu'avec toutes les classes ensemble");
        }
    }

    /**
     * Attribue, parmi les vérifications cachées, celles qui échouent quand elles suivent toutes les autres, à la classe dont les réponses
     * changent d'un appel à l'autre.
     */
    private void chercherCeQuiEstGarde() throws Arret {
        List<Verification> changeantes = verifications(v -> v.etape.equals(Verification.REPETITION)
                && resultat.verdicts.get(v.id()).rate());
        changeantes.forEach(v -> resultat.regarder(resultat.verdicts.get(v.id()).message));
        for (String classe : changeantes.stream().map(v -> v.classe).collect(Collectors.toSet())) {
            if (cachees.isEmpty()) {
                break;
            }
            Map<String, Verdict> ensuite = lancer(seule(classe), reference.verifications).verdicts;
            retirer(ensuite).forEach(v -> charger(v, Etat.FAUSSE,
                    "la réponse change d'un appel à l'autre : quelque chose est gardé dans un champ de " + classe, classe));
        }
    }

    /** Retire, des vérifications cachées, celles qui échouent ici. @return celles-là */
    private List<Verification> retirer(Map<String, Verdict> verdicts) {
        List<Verification> echouent = new ArrayList<>(cachees);
        echouent.removeIf(v -> verdicts.get(v.id()).etat == Etat.REUSSI);
        cachees.removeAll(echouent);
        return echouent;
    }

    private void charger(Verification v, Etat etat, String message, String classe) {
        resultat.verdicts.put(v.id(), new Verdict(etat, classe, message + (classe.equals(v.classe) ? ""
                : " ; " + v.classe + " est juste, la faute est dans " + classe)));
        montrer(v, classe);
    }

    boolean aUneFaute(String classe) {
        return !verifications(v -> v.classe.equals(classe) && resultat.verdicts.containsKey(v.id())
                && !resultat.verdicts.get(v.id()).compte()).isEmpty();
    }

    List<Verification> verifications(Predicate<Verification> lesquelles) {
        return reference.verifications.stream().filter(lesquelles).collect(Collectors.toList());
    }

    /** Les fautes de compilation des classes rendues. */
    List<Faute> siennes() {
        return ensemble.fautes.stream().filter(f -> projet.base.containsKey(f.fichier.replaceFirst("\\.java$", "")))
                .collect(Collectors.toList());
    }

    /** Classes, parmi celles-ci, que l'étudiant a modifiées. */
    List<String> changees(List<String> classes) {
        return classes.stream().filter(projet.changees::contains).collect(Collectors.toList());
    }

    /** Retient, pour la page, les méthodes que vise une vérification. */
    private void montrer(Verification v, String classe) {
        if (projet.texte(classe) != null) {
            Set<String> lesquelles = nommees(v, classe);
            List<Signature> toutes = projet.type(classe).methodes;
            String visees = toutes.stream().filter(m -> lesquelles.contains(m.nom)).map(m -> m.texte + "\n").collect(Collectors.joining());
            // les méthodes privées qu'elles appellent en sont une partie
            resultat.methodes.put(v.id(), visees + toutes.stream().filter(m -> m.privee && !lesquelles.contains(m.nom)
                    && !m.rend.isEmpty() && visees.contains(m.nom + "(")).map(m -> m.texte + "\n").collect(Collectors.joining()));
        }
    }

    /** La classe de l'étudiant, seule avec celles du corrigé ; si elle en a besoin, avec d'autres classes de l'étudiant. */
    Assemblage seule(String classe) throws Arret {
        if (seules.containsKey(classe)) {
            return seules.get(classe);
        }
        // classes ajoutées par l'étudiant, puis corrigé, puis cette classe ; si elle n'est pas rendue, celle du projet à compléter
        Map<String, String> sources = new TreeMap<>(projet.base);
        sources.putAll(SourcesDuCours.tout(SourcesDuCours::corrige));
        sources.put("lancer/" + classe, projet.texte(classe) != null ? projet.texte(classe)
                : SourcesDuCours.squelette(classe));
        Assemblage seule = assembler(sources);
        // les classes de l'étudiant qu'elle utilise, puis celles que ces classes utilisent
        Set<String> avec = new LinkedHashSet<>();
        while (fautesNouvelles(seule, classe)) {
            List<String> deplus = employees(avec.isEmpty() ? Set.of(classe) : avec);
            deplus.remove(classe);
            if (!avec.addAll(deplus)) {
                String cassees = seule.fautes.stream().map(Faute::classe).filter(avec::contains).distinct()
                        .collect(Collectors.joining(", "));
                dependances.put(classe, cassees.isEmpty() ? String.join(", ", avec) : cassees);
                break;
            }
            avec.forEach(c -> sources.put("lancer/" + c, projet.texte(c)));
            seule = assembler(sources);
        }
        if (!avec.isEmpty() && !dependances.containsKey(classe)) {
            resultat.remarques.add(classe + " a besoin de ce que vous avez ajouté ailleurs : jugée avec vos classes "
                    + String.join(", ", avec));
        }
        seules.put(classe, seule);
        return seule;
    }

    /** Les classes rendues que ces classes utilisent, d'après leur nom ou celui d'un champ. */
    private List<String> employees(Set<String> classes) {
        return SourcesDuCours.classes().stream().filter(c -> projet.texte(c) != null && !c.equals("Main")
                && classes.stream().map(projet::type)
                .anyMatch(t -> t.noms.contains(c) || t.noms.contains(c.toLowerCase(Locale.ROOT))))
                .collect(Collectors.toList());
    }

    /** Dit si la classe, avec celles du corrigé, cause des fautes de compilation qu'elle ne cause pas dans le rendu. */
    private boolean fautesNouvelles(Assemblage seule, String classe) {
        // Main, que rien n'appelle ici, peut ignorer une exception que la classe annonce
        return seule.fautesDe(classe).size() > ensemble.fautesDe(classe).size() || seule.fautes.stream().anyMatch(f -> !f.classe()
                .equals("Main") && SourcesDuCours.classes().contains(f.classe()) && !f.classe().equals(classe)
                && ensemble.fautesDe(f.classe()).isEmpty());
    }

    Verifications.Bilan lancer(Assemblage assemblage, List<Verification> verifications) {
        Verifications.Bilan bilan = reference.junit.lancer(verifications, machine(assemblage));
        if (bilan.arrets > 0) {
            assemblage.arrete = true;
            resultat.regarder(bilan.pourquoi);
        }
        return bilan;
    }

    private Verdict conclure(Verification v, Verdict ensemble, Verdict seule) throws Arret {
        if (ensemble.etat == Etat.REUSSI) {
            return ensemble;
        }
        if (!projet.changees.contains(v.classe)) {
            return new Verdict(Etat.NON_COMMENCE, v.classe, "la classe " + v.classe + (projet.texte(v.classe) == null
                    ? " n'est pas dans le rendu" : " est celle du projet à compléter"));
        }
        if (seule != null && seule.etat == Etat.REUSSI) {
            cachees.add(v);
            return new Verdict(Etat.REUSSI, "", ensemble.message);
        }
        // si elle ne se compile que dans le rendu, elle y est jugée
        Verdict verdict = seule == null || seule.neSeCompilePas() && !ensemble.neSeCompilePas() ? ensemble : seule;
        montrer(v, v.classe);
        if (verdict.etat == Etat.NON_EVALUABLE) {
            return new Verdict(Etat.NON_EVALUABLE, "", verdict.message);
        } else if (verdict.etat == Etat.NON_COMMENCE) {
            return commencee(v, verdict);
        } else if (verdict.neSeCompilePas()) {
            return fauteDeCompilation(v, verdict);
        }
        return verdict.message.equals(reference.duSquelette(v).message)
                && !nommees(v, v.classe).stream().allMatch(methodes(v.classe)::get)
                ? new Verdict(Etat.NON_COMMENCE, v.classe, "rend ce que rend le projet à compléter : " + verdict.message) : verdict;
    }

    private Verdict fauteDeCompilation(Verification v, Verdict verdict) {
        if (dependances.containsKey(v.classe)) {
            return new Verdict(Etat.NON_EVALUABLE, dependances.get(v.classe), "dépend de " + dependances.get(v.classe));
        }
        return !verdict.faute.isEmpty() ? verdict : new Verdict(Etat.FAUSSE, v.classe, verdict.message
                + Stream.concat(ensemble.fautesDe(v.classe).stream(), siennes().stream()).findFirst().map(f -> " ; " + f).orElse(""),
                verdict.faute);
    }

    /** Pour chaque méthode à compléter de cette classe, dit si l'étudiant l'a modifiée. */
    private Map<String, Boolean> methodes(String classe) {
        Map<String, Boolean> noms = new TreeMap<>();
        for (Signature m : projet.squelette.get(classe).methodes) {
            if (m.texte.contains("// FIXME")) {
                noms.merge(m.nom, projet.type(classe).methodes.stream().noneMatch(s -> s.nom.equals(m.nom) && s.arbre.equals(m.arbre)),
                        Boolean::logicalAnd);
            }
        }
        return noms;
    }

    /** Les méthodes à compléter que nomme cette vérification ou, à défaut, toutes celles de la classe. */
    private Set<String> nommees(Verification v, String classe) {
        Set<String> toutes = methodes(classe).keySet();
        Set<String> nommees = toutes.stream().filter(m -> Pattern.compile("\\b" + m + "\\b")
                .matcher(v.titre).find()).collect(Collectors.toCollection(TreeSet::new));
        return nommees.isEmpty() ? toutes : nommees;
    }

    /** Verdict d'une étape sans effet visible, dont la méthode est écrite : la faute est dans cette classe ou dans une autre. */
    private Verdict commencee(Verification v, Verdict verdict) {
        String message = verdict.message;
        String ecrite = changees(SourcesDuCours.A_COMPLETER).stream()
                .filter(c -> !(c.equals(v.classe) && DANS_LA_MEME_METHODE.contains(v.etape))
                && methodes(c).entrySet().stream().anyMatch(m -> m.getValue() && message.contains(m.getKey())))
                .findFirst().orElse(null);
        if (ecrite == null || ecrite.equals(v.classe)) {
            return ecrite == null ? verdict : new Verdict(Etat.FAUSSE, v.classe, message);
        }
        // la classe qui contient la méthode, ou une classe déjà jugée dont elle dépend
        String fautive = Stream.concat(Stream.of(ecrite), SourcesDuCours.A_COMPLETER.stream())
                .filter(c -> !c.equals(v.classe) && aUneFaute(c))
                .findFirst().orElse(ecrite);
        resultat.regarder(message + " : la faute est dans " + fautive + ", et " + v.classe + " n'a pu être évaluée sans elle");
        return new Verdict(Etat.NON_EVALUABLE, fautive, message + " ; la faute est dans " + fautive);
    }

    /** Dit si l'étudiant a écrit cette méthode à compléter. */
    boolean aEcrit(String classe, String methode) {
        return projet.changees.contains(classe) && methodes(classe).getOrDefault(methode, false);
    }
}
