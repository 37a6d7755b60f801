package lancer.correction.jugement;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import lancer.correction.depot.Projet;
import lancer.correction.depot.Source;
import lancer.correction.isolement.Arret;
import lancer.correction.jugement.Chantier.Assemblage;
import lancer.correction.jugement.Verdict.Etat;
import lancer.correction.modele.Modele;

/**
 * Juge un rendu : toutes ses classes ensemble, puis chacune seule parmi celles du corrigé, pour qu'une faute ne cache
 * pas les autres.
 */
final class Juge implements AutoCloseable {

    static final int LARGEUR = 160;
    static final int HAUTEUR = 120;
    static final int PROFONDEUR = 5;

    /** Combien de fois le temps d'une vérification est permis à un dessin. */
    private static final double TEMPS_IMAGE = 4;

    /** Le début de ce que dit une méthode qui ne se compile pas. */
    static final String NE_SE_COMPILE_PAS = "ne se compile pas";

    private final Reference reference;
    private final Chantier chantier;
    private final Machines machines;
    private final Projet projet;
    /** La machine d'un seul assemblage : un rendu n'y a ni le corrigé de ce qu'on y juge, ni ses autres essais. */
    private Machines.Rendue machine;
    private Assemblage enMachine;
    private final Resultat resultat = new Resultat();
    private Assemblage ensemble;
    /** Pourquoi les dernières vérifications n'ont pas toutes été lancées, vide si elles l'ont été. */
    private String coupe = "";
    /** Où une vérification n'a pas fini. */
    private final Set<Assemblage> arretes = new HashSet<>();
    private final Map<String, Assemblage> seules = new HashMap<>();
    /** De quoi dépend une classe qui ne se compile pas seule dans le corrigé. */
    private final Map<String, String> dependances = new HashMap<>();

    Juge(Reference reference, Chantier chantier, Machines machines, Projet projet) {
        this.reference = reference;
        this.chantier = chantier;
        this.machines = machines;
        this.projet = projet;
    }

    private Machines.Rendue machine(Assemblage assemblage) {
        if (machine == null || enMachine != assemblage) {
            close();
            enMachine = assemblage;
            machine = machines.new Rendue(assemblage.classes);
        }
        return machine;
    }

    /** Arrête la machine, s'il y en a une. */
    @Override
    public void close() {
        if (machine != null) {
            machine.close();
            machine = null;
        }
    }

    Resultat juger() throws Arret {
        resultat.remarques.addAll(projet.getRemarques());
        Map<String, String> sources = Chantier.squelette();
        sources.putAll(projet.getBase());
        for (String classe : Modele.A_COMPLETER) {
            if (projet.texte(classe) == null) {
                resultat.remarques.add("la classe " + classe + " manque : celle du projet à compléter en tient lieu");
            }
        }
        ensemble = chantier.assembler(sources);
        for (Faute faute : ensemble.fautes) {
            if (projet.getBase().containsKey(faute.fichier.replaceFirst("\\.java$", ""))) {
                resultat.fautes.add(faute);
            }
        }
        Map<String, Verdict> parEnsemble = lancer(ensemble, reference.getVerifications());
        String sansImage = coupe;
        Map<String, List<Verification>> aReprendre = new LinkedHashMap<>();
        for (Verification v : reference.getVerifications()) {
            if (parEnsemble.get(v.id()).etat != Etat.REUSSI && projet.texte(v.classe) != null && !intacte(v.classe)) {
                aReprendre.computeIfAbsent(v.classe, c -> new ArrayList<>()).add(v);
            }
        }
        Map<String, Verdict> parSeule = new HashMap<>();
        for (Map.Entry<String, List<Verification>> reprise : aReprendre.entrySet()) {
            Assemblage seule = seule(reprise.getKey());
            if (seule != null) {
                parSeule.putAll(lancer(seule, reprise.getValue()));
            }
        }
        for (Verification v : reference.getVerifications()) {
            resultat.verdicts.put(v.id(), conclure(v, parEnsemble.get(v.id()), parSeule.get(v.id())));
        }
        if (!sansImage.isEmpty()) {
            resultat.sansImage = sansImage;
            resultat.verdicts.put(Grille.IMAGE, new Verdict(Etat.RATE, resultat.sansImage));
        } else {
            // une machine neuve : ce que les vérifications ont pu y laisser ne gâte pas l'image
            close();
            new JugeImage(this, reference, projet, resultat).juger();
        }
        variantes();
        return resultat;
    }

    private void variantes() throws Arret {
        for (Map.Entry<String, Map<String, String>> variante : projet.getVariantes().entrySet()) {
            String nom = variante.getKey();
            // une variante est une copie du projet ; ce qui n'y est pas est celui de la base
            Map<String, String> sources = Chantier.squelette();
            sources.putAll(projet.getBase());
            sources.putAll(variante.getValue());
            Map<String, Verdict> verdicts = new Variantes(this, reference, ensemble)
                    .juger(nom, chantier.assembler(sources));
            resultat.verdicts.putAll(verdicts);
            // ce que la variante change, parmi les classes du corrigé : une faute de la base ne la cache pas
            Map<String, String> change = new TreeMap<>(sources);
            change.entrySet().removeIf(c -> Modele.classes().contains(c.getKey().replace("lancer/", ""))
                    && (projet.getBase().get(c.getKey()) == null ? !variante.getValue().containsKey(c.getKey())
                    : Source.memeCode(c.getValue(), projet.getBase().get(c.getKey()))));
            if (!change.isEmpty() && verdicts.values().stream().anyMatch(v -> !v.compte())) {
                Map<String, String> parmi = Chantier.corrige();
                parmi.putAll(change);
                new Variantes(this, reference, reference.getCorrige())
                        .juger(nom, chantier.assembler(parmi)).forEach((id, seule) -> {
                    if (seule.compte() && !verdicts.get(id).compte()) {
                        resultat.verdicts.put(id, new Verdict(Etat.CACHE, verdicts.get(id).message));
                    }
                });
            }
        }
    }

    /** Vrai si la classe de l'étudiant est celle du projet à compléter. */
    boolean intacte(String classe) {
        return Source.memeCode(projet.texte(classe), Modele.squelette(classe));
    }

    /**
     * La classe de l'étudiant parmi celles du corrigé ; avec celles des siennes dont elle a besoin, si elle en a
     * besoin.
     */
    Assemblage seule(String classe) throws Arret {
        if (seules.containsKey(classe)) {
            return seules.get(classe);
        }
        Map<String, String> sources = corrigeAvec(List.of(classe));
        Assemblage seule = chantier.assembler(sources);
        if (fautesNouvelles(seule, classe)) {
            List<String> nommees = new ArrayList<>();
            for (String autre : Modele.classes()) {
                String texte = projet.texte(autre);
                if (texte != null && !autre.equals(classe) && !autre.equals("Main")
                        && Pattern.compile("\\b" + autre + "\\b|\\." + autre.toLowerCase() + "\\b")
                        .matcher(projet.texte(classe)).find()) {
                    nommees.add(autre);
                    sources.put("lancer/" + autre, texte);
                }
            }
            seule = chantier.assembler(sources);
            if (fautesNouvelles(seule, classe) || seule.fautes.size() > seule.fautesDe(classe).size()) {
                TreeSet<String> cassees = new TreeSet<>();
                seule.fautes.stream().map(Faute::classe).filter(nommees::contains).forEach(cassees::add);
                dependances.put(classe, cassees.isEmpty() ? String.join(", ", nommees) : String.join(", ", cassees));
            } else {
                resultat.remarques.add(classe
                        + " a besoin de ce que vous avez ajouté ailleurs : jugée avec vos classes "
                        + String.join(", ", nommees));
            }
        }
        seules.put(classe, seule);
        return seule;
    }

    /** Vrai si la classe a là des fautes qu'elle n'a pas avec toutes celles de l'étudiant. */
    private boolean fautesNouvelles(Assemblage seule, String classe) {
        return seule.fautesDe(classe).size() > (ensemble == null ? 0 : ensemble.fautesDe(classe).size());
    }

    Map<String, Verdict> lancer(Assemblage assemblage, List<Verification> verifications) {
        Verifications.Bilan bilan = reference.getJUnit().lancer(verifications, machine(assemblage));
        if (bilan.arrets > 0) {
            arretes.add(assemblage);
        }
        coupe = bilan.coupe() ? "trop de vérifications n'ont pas fini : " + bilan.pourquoi : "";
        return bilan.verdicts;
    }

    private Verdict conclure(Verification v, Verdict ensemble, Verdict seule) {
        if (ensemble.etat == Etat.REUSSI) {
            return ensemble;
        }
        if (projet.texte(v.classe) == null) {
            return new Verdict(Etat.NON_COMMENCE, "la classe " + v.classe + " n'est pas dans le rendu");
        }
        if (intacte(v.classe)) {
            return new Verdict(Etat.NON_COMMENCE, "la classe " + v.classe + " est celle du projet à compléter");
        }
        if (seule != null && seule.etat == Etat.REUSSI) {
            return new Verdict(Etat.CACHE, ensemble.message);
        }
        Verdict verdict = seule != null ? seule : ensemble;
        if (verdict.etat == Etat.NON_COMMENCE) {
            // le jaune vif : à la première étape de getColor, elle n'est pas commencée ; aux suivantes, elle manque
            String besoin = verdict.message.contains("jaune vif") ? reference.besoin(v.etape) : "";
            return verdict.message.startsWith("étape non évaluable") || !besoin.isEmpty()
                    ? new Verdict(Etat.NON_EVALUABLE,
                    (besoin.isEmpty() ? "" : "non évaluable : dépend de « " + besoin + " » ; ") + verdict.message)
                    : verdict;
        }
        if (dependances.containsKey(v.classe) && verdict.message.startsWith(NE_SE_COMPILE_PAS)) {
            return new Verdict(Etat.NON_EVALUABLE, "non évaluable : dépend de " + dependances.get(v.classe));
        }
        if (verdict.message.startsWith(NE_SE_COMPILE_PAS)) {
            return new Verdict(Etat.RATE, verdict.message + (verdict.message.contains(" : ") ? "" : causes(v.classe)));
        }
        return verdict.message.equals(reference.messageDuSquelette(v)) && !commencee(v) ? new Verdict(Etat.NON_COMMENCE,
                "rend ce que rend le projet à compléter : " + verdict.message) : verdict;
    }

    /** Faux si la méthode dont parle cette vérification, à défaut une de sa classe, est celle du projet à compléter. */
    private boolean commencee(Verification v) {
        Map<String, Boolean> methodes = Source.commencees(projet.texte(v.classe), Modele.squelette(v.classe));
        List<String> nommees = methodes.keySet().stream()
                .filter(m -> Pattern.compile("\\b" + m + "\\b").matcher(v.titre).find()).collect(Collectors.toList());
        return (nommees.isEmpty() ? methodes.keySet() : nommees).stream().allMatch(methodes::get);
    }

    private String causes(String classe) {
        List<Faute> fautes = new ArrayList<>(ensemble.fautesDe(classe));
        if (fautes.isEmpty()) {
            fautes.addAll(resultat.fautes);
        }
        return fautes.isEmpty() ? "" : " ; " + fautes.get(0);
    }

    /** Toutes les classes de l'étudiant. */
    Assemblage ensemble() {
        return ensemble;
    }

    /** Plusieurs classes de l'étudiant parmi celles du corrigé. */
    Assemblage parmiLeCorrige(List<String> classes) throws Arret {
        return chantier.assembler(corrigeAvec(classes));
    }

    /** Vrai si une vérification n'y a pas fini : on n'y dessine pas. */
    boolean estArrete(Assemblage assemblage) {
        return arretes.contains(assemblage);
    }

    /** Le corrigé, avec ces classes de l'étudiant, et celles qu'il a ajoutées. */
    private Map<String, String> corrigeAvec(List<String> classes) {
        Map<String, String> sources = Chantier.corrige();
        projet.getBase().forEach((nom, texte) -> {
            String classe = nom.replace("lancer/", "");
            if (classes.contains(classe) || !Modele.classes().contains(classe)) {
                sources.put(nom, texte);
            }
        });
        return sources;
    }

    /** Le texte de la scène du cours. */
    String scene() {
        return Modele.scene("scene1");
    }

    /** @throws Dialogue.Echec si les classes ne savent pas dessiner, avec pourquoi */
    Image image(Assemblage assemblage, double decalage) throws Arret {
        return Image.lire(LARGEUR, HAUTEUR, sonde(assemblage, "SondeImage", "dessiner", scene(), "" + LARGEUR, ""
                + HAUTEUR, "" + PROFONDEUR,
                "" + decalage));
    }

    /** @param scene le texte de la scène, premier argument de la sonde */
    String sonde(Assemblage assemblage, String sonde, String methode, String scene, String... arguments) throws Arret {
        Machines.Rendue ici = machine(assemblage);
        ici.commencer(TEMPS_IMAGE * ici.calcul());
        try {
            return ici.sonder(sonde, methode, scene, arguments);
        } catch (StackOverflowError e) {
            throw new Dialogue.Echec(e.getMessage());
        }
    }
}
