package lancer.correction.jugement;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
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

    JugeRendu(Reference reference, Machines.Compilation compilation, Machines machines, Projet projet, Resultat resultat)
            throws Arret {
        this.reference = reference;
        this.compilation = compilation;
        this.machines = machines;
        this.projet = projet;
        this.resultat = resultat;
        vives = new Machines.Rendue[] {machines.new Rendue(null, resultat.depense), machines.new Rendue(null, resultat.depense)};
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
            vives[place] = machines.new Rendue(assemblage, resultat.depense);
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
            Verdict obtenu = toutes.verdicts.get(v.id());
            // ce qui est gardé d'un appel à l'autre est dit, sans classe ni point
            resultat.verdicts.put(v.id(), v.etape.equals(Verification.REPETITION) ? obtenu
                    : conclure(v, obtenu, parSeule.get(v.id())));
        }
        verifications(v -> v.etape.equals(Verification.REPETITION) && resultat.verdicts.get(v.id()).rate())
                .forEach(v -> resultat.regarder(resultat.verdicts.get(v.id()).message));
        imputer(verifications(v -> toutes.verdicts.get(v.id()).etat != Etat.REUSSI && resultat.verdicts.get(v.id()).compte()));
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
     * Impute les vérifications que la classe visée réussit seule, et rate avec les autres. Celles qui réussissent quand le corrigé remplace
     * les classes fautives ne coûtent rien de plus. Les autres coûtent une seule vérification aux classes qui suffisent à l'échec.
     */
    private void imputer(List<Verification> cachees) throws Arret {
        List<String> siennes = changees(SourcesDuCours.classes());
        siennes.removeIf(this::aUneFaute);
        for (List<Verification> restent = ratees(siennes, cachees); !restent.isEmpty(); restent = ratees(siennes, restent)) {
            List<String> reunies = new ArrayList<>(siennes);
            for (String classe : siennes) {
                reunies.remove(classe);
                if (ratees(reunies, restent.subList(0, 1)).isEmpty()) {
                    reunies.add(classe);
                }
            }
            Verification payee = restent.stream().filter(v -> reunies.contains(v.classe)).findFirst().orElse(restent.get(0));
            String fautives = String.join(", ", reunies);
            resultat.verdicts.put(payee.id(), new Verdict(Etat.FAUSSE, fautives, resultat.verdicts.get(payee.id()).message
                    + (reunies.size() == 1 ? " ; " + payee.classe + " est juste, la faute est dans " + fautives : "")));
            montrer(payee, reunies.get(0));
            if (reunies.size() > 1) {
                resultat.regarder("« " + payee.titre + " » n'échoue qu'avec " + fautives + " ensemble");
            }
            siennes.removeAll(reunies);
        }
    }

    /** Celles de ces vérifications qui échouent avec ces seules classes de l'étudiant, à leur place parmi toutes. */
    private List<Verification> ratees(List<String> siennes, List<Verification> lesquelles) throws Arret {
        if (siennes.isEmpty() || lesquelles.isEmpty()) {
            return List.of();
        }
        Map<String, Verdict> verdicts = lancer(avec(siennes), reference.verifications).verdicts;
        return lesquelles.stream().filter(v -> verdicts.get(v.id()).etat != Etat.REUSSI && !verdicts.get(v.id()).neSeCompilePas())
                .collect(Collectors.toList());
    }

    /** Dit si une vérification qui vise cette classe ne rapporte pas ses points. */
    boolean aUneFaute(String classe) {
        return !verifications(v -> v.classe.equals(classe) && !resultat.verdicts.get(v.id()).compte()).isEmpty();
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
            Set<String> lesquelles = visees(v, classe);
            List<Signature> toutes = projet.type(classe).methodes;
            String visees = toutes.stream().filter(m -> lesquelles.contains(m.nom)).map(m -> m.texte + "\n").collect(Collectors.joining());
            // les méthodes privées qu'elles appellent en sont une partie
            resultat.methodes.put(v.id(), visees + toutes.stream().filter(m -> m.privee && !lesquelles.contains(m.nom)
                    && !m.rend.isEmpty() && visees.contains(m.nom + "(")).map(m -> m.texte + "\n").collect(Collectors.joining()));
        }
    }

    /** Cette classe de l'étudiant, ou à défaut celle du projet à compléter, seule avec celles du corrigé. */
    Assemblage seule(String classe) throws Arret {
        if (!seules.containsKey(classe)) {
            seules.put(classe, avec(List.of(classe)));
        }
        return seules.get(classe);
    }

    /** Ces classes de l'étudiant, et celles dont elles ont besoin, avec celles du corrigé. */
    private Assemblage avec(List<String> classes) throws Arret {
        Set<String> siennes = new LinkedHashSet<>(classes);
        Assemblage assemblage;
        do {
            // les classes ajoutées par l'étudiant, puis le corrigé, puis ces classes
            Map<String, String> sources = new TreeMap<>(projet.base);
            sources.putAll(SourcesDuCours.tout(SourcesDuCours::corrige));
            siennes.forEach(c -> sources.put("lancer/" + c, projet.texte(c) != null ? projet.texte(c) : SourcesDuCours.squelette(c)));
            assemblage = assembler(sources);
        } while (siennes.addAll(necessaires(assemblage, siennes)));
        if (classes.size() == 1 && siennes.size() > 1) {
            resultat.remarques.add(classes.get(0) + " a besoin de ce que vous avez ajouté ailleurs : jugée avec vos classes "
                    + siennes.stream().skip(1).collect(Collectors.joining(", ")));
        }
        return assemblage;
    }

    /**
     * Les classes de l'étudiant que demandent les fautes de compilation qui ne sont pas dans le rendu : celle du corrigé qui ne se compile
     * plus ; pour une des siennes, celles qu'elle emploie et qui ont plus de méthodes que le cours ou, à défaut, toutes.
     */
    private Set<String> necessaires(Assemblage assemblage, Set<String> siennes) {
        Set<String> necessaires = new LinkedHashSet<>();
        for (String classe : SourcesDuCours.classes()) {
            // Main, que rien n'appelle ici, peut ignorer une exception que la classe annonce
            if (!classe.equals("Main") && assemblage.fautesDe(classe).size() > ensemble.fautesDe(classe).size()) {
                List<String> employees = siennes.contains(classe) ? employees(classe) : List.of(classe);
                List<String> augmentees = employees.stream().filter(projet::augmentee).collect(Collectors.toList());
                necessaires.addAll(siennes.containsAll(augmentees) ? employees : augmentees);
            }
        }
        necessaires.removeIf(c -> projet.texte(c) == null);
        return necessaires;
    }

    /** Les classes du cours qu'une classe rendue emploie, d'après leur nom ou celui d'un champ. */
    private List<String> employees(String classe) {
        Set<String> noms = projet.type(classe).noms;
        return SourcesDuCours.classes().stream().filter(c -> !c.equals("Main") && (noms.contains(c)
                || noms.contains(c.toLowerCase(Locale.ROOT)))).collect(Collectors.toList());
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
                && !visees(v, v.classe).stream().allMatch(methodes(v.classe)::get)
                ? new Verdict(Etat.NON_COMMENCE, v.classe, "rend ce que rend le projet à compléter : " + verdict.message) : verdict;
    }

    private Verdict fauteDeCompilation(Verification v, Verdict verdict) {
        String autres = siennes().stream().map(Faute::classe).distinct().collect(Collectors.joining(", "));
        if (ensemble.fautesDe(v.classe).isEmpty() && !autres.isEmpty()) {
            return new Verdict(Etat.NON_EVALUABLE, autres, "dépend de " + autres);
        }
        return !verdict.faute.isEmpty() ? verdict : new Verdict(Etat.FAUSSE, v.classe, verdict.message
                + Stream.concat(ensemble.fautesDe(v.classe).stream(), siennes().stream()).findFirst().map(f -> " ; " + f).orElse(""),
                verdict.faute, "");
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

    /** Les méthodes à compléter de cette classe que demande une vérification ; toutes, si elle n'en nomme pas de cette classe. */
    private Set<String> visees(Verification v, String classe) {
        Set<String> toutes = methodes(classe).keySet();
        Set<String> nommees = new TreeSet<>(toutes);
        nommees.retainAll(v.classe.equals(classe) ? v.methodes : List.of());
        return nommees.isEmpty() ? toutes : nommees;
    }

    /** Verdict d'une étape sans effet visible : si la méthode est écrite, la faute est dans cette classe ou dans une autre. */
    private Verdict commencee(Verification v, Verdict verdict) {
        boolean memeMethode = verdict.classe.equals(v.classe) && DANS_LA_MEME_METHODE.contains(v.etape);
        if (memeMethode || !aEcrit(verdict.classe, verdict.methode)) {
            return new Verdict(Etat.NON_COMMENCE, v.classe, verdict.message);
        } else if (verdict.classe.equals(v.classe)) {
            return new Verdict(Etat.FAUSSE, v.classe, verdict.message);
        }
        resultat.regarder(verdict.message + " : la faute est dans " + verdict.classe + ", et " + v.classe
                + " n'a pu être évaluée sans elle");
        return new Verdict(Etat.NON_EVALUABLE, verdict.classe, verdict.message + " ; la faute est dans " + verdict.classe);
    }

    /** Dit si l'étudiant a écrit cette méthode à compléter. */
    boolean aEcrit(String classe, String methode) {
        return projet.changees.contains(classe) && methodes(classe).getOrDefault(methode, false);
    }
}
