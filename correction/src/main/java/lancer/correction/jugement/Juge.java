package lancer.correction.jugement;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lancer.correction.depot.Projet;
import lancer.correction.depot.Source;
import lancer.correction.enfant.Echange;
import lancer.correction.isolement.Arret;
import lancer.correction.jugement.Machines.Assemblage;
import lancer.correction.jugement.Verdict.Etat;
import lancer.correction.modele.Modele;

/**
 * Juge un rendu : toutes ses classes ensemble, puis chacune seule parmi celles du corrigé, pour qu'une faute ne cache
 * pas les autres.
 */
final class Juge implements AutoCloseable {

    /** Combien de fois le temps d'une vérification est permis à un dessin. */
    private static final double TEMPS_IMAGE = 4;

    /** Pixels où l'on cherche d'où vient la faute. */
    private static final int PIXELS_ESSAYES = 200;

    /** Le début de ce que dit une méthode qui ne se compile pas. */
    static final String NE_SE_COMPILE_PAS = "ne se compile pas";

    /** Ce qui s'ajoute à une méthode déjà écrite pour une étape d'avant. */
    private static final Set<String> DANS_LA_MEME_METHODE = Set.of("phong", "ombres", "reflets");

    private final Reference reference;
    private final Machines.Compilation compilation;
    private final Machines machines;
    private final Projet projet;
    /** La machine d'un seul assemblage : un rendu n'y a ni le corrigé de ce qu'on y juge, ni ses autres essais. */
    private Machines.Rendue machine;
    private Assemblage enMachine;
    private final Resultat resultat = new Resultat();
    /** Toutes les classes de l'étudiant. */
    private Assemblage ensemble;
    /** Les classes du cours qu'il a rendues, et changées. */
    private final Set<String> changees = new HashSet<>();
    /** Pourquoi les dernières vérifications n'ont pas toutes été lancées, vide si elles l'ont été. */
    private String coupe = "";
    /** Où une vérification n'a pas fini. */
    private final Set<Assemblage> arretes = new HashSet<>();
    private final Map<String, Assemblage> seules = new HashMap<>();
    /** De quoi dépend une classe qui ne se compile pas seule dans le corrigé. */
    private final Map<String, String> dependances = new HashMap<>();

    Juge(Reference reference, Machines.Compilation compilation, Machines machines, Projet projet) {
        this.reference = reference;
        this.compilation = compilation;
        this.machines = machines;
        this.projet = projet;
    }

    /** Compile des classes, avec ce qui les appelle et les sonde, où nos noms sont les siens. */
    Assemblage assembler(Map<String, String> classes) throws Arret {
        Map<String, String> sources = new TreeMap<>(classes);
        sources.put("lancer/" + Modele.APPELS, projet.noms.dans(reference.appels));
        sources.put("lancer/" + Modele.SONDE, projet.noms.dans(Modele.sonde()));
        return compilation.compiler(sources);
    }

    /** Ce qu'il a rendu de la base, et pour le reste le projet à compléter, puis ces classes-ci. */
    private Map<String, String> base(Map<String, String> enPlus) {
        Map<String, String> sources = projet.noms.dans(Modele.tout(Modele::squelette));
        sources.putAll(projet.base);
        sources.putAll(enPlus);
        return sources;
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
        Modele.classes().stream().filter(c -> projet.texte(c) != null && !Source.memeCode(projet.texte(c),
                projet.noms.dans(Modele.squelette(c)))).forEach(changees::add);
        resultat.remarques.addAll(projet.remarques);
        resultat.aRegarder.addAll(projet.aRegarder);
        for (String classe : Modele.A_COMPLETER) {
            if (projet.texte(classe) == null) {
                resultat.remarques.add("la classe " + classe + " manque : celle du projet à compléter en tient lieu");
            }
        }
        ensemble = assembler(base(Map.of()));
        for (Faute faute : ensemble.fautes) {
            if (projet.base.containsKey(faute.fichier.replaceFirst("\\.java$", ""))) {
                resultat.fautes.add(faute.toString());
            }
        }
        Map<String, Verdict> parEnsemble = lancer(ensemble, reference.verifications);
        String sansImage = coupe;
        Map<String, Verdict> parSeule = new HashMap<>();
        for (String classe : changees(Modele.A_COMPLETER)) {
            List<Verification> aReprendre = verifications(v -> v.classe.equals(classe)
                    && parEnsemble.get(v.id()).etat != Etat.REUSSI);
            if (!aReprendre.isEmpty()) {
                parSeule.putAll(lancer(seule(classe), aReprendre));
            }
        }
        for (Verification v : reference.verifications) {
            resultat.verdicts.put(v.id(), conclure(v, parEnsemble.get(v.id()), parSeule.get(v.id())));
        }
        imputer();
        if (!sansImage.isEmpty()) {
            Reference.SCENES.keySet().forEach(scene -> resultat.verdicts.put(Grille.IMAGE + "." + scene,
                    new Verdict(Etat.RATE, sansImage)));
        } else {
            // une machine neuve : ce que les vérifications ont pu y laisser ne gâte pas l'image
            close();
            jugerLesImages();
        }
        variantes();
        consignes();
        confronter();
        return resultat;
    }

    /**
     * Ce que sa classe réussit seule échoue par une autre. Si celle-là n'a par ailleurs aucune faute à elle, c'est à elle
     * que la vérification coûte ; si aucune n'échoue seule, à celle dont elle parle.
     */
    private void imputer() throws Arret {
        List<Verification> cachees = verifications(v -> resultat.verdicts.get(v.id()).etat == Etat.CACHE);
        List<String> suspectes = new ArrayList<>(Modele.A_COMPLETER);
        suspectes.sort(Comparator.comparing(classe -> !aUneFaute(classe)));
        suspectes.addAll(changees(Modele.DONNEES));
        for (String classe : suspectes) {
            if (cachees.isEmpty() || arretes.contains(seules.get(classe))) {
                continue;
            }
            boolean paie = aUneFaute(classe);
            Map<String, Verdict> parElle = lancer(seule(classe), cachees);
            for (Verification v : List.copyOf(cachees)) {
                if (parElle.get(v.id()).etat != Etat.REUSSI) {
                    cachees.remove(v);
                    if (!paie) {
                        charger(v, parElle.get(v.id()).message, classe);
                    }
                }
            }
        }
        // si une seule faute n'y suffit pas, celles qui sont déjà comptées l'expliquent ; s'il n'y en a pas, il y a à voir
        cachees.removeIf(v -> Modele.A_COMPLETER.stream().anyMatch(this::aUneFaute));
        for (Verification v : cachees) {
            charger(v, resultat.verdicts.get(v.id()).message, v.classe);
            resultat.regarder("« " + v.titre + " » n'échoue qu'avec toutes les classes ensemble");
        }
    }

    private void charger(Verification v, String message, String classe) {
        resultat.verdicts.put(v.id(), new Verdict(Etat.RATE, message + (classe.equals(v.classe) ? ""
                : " ; " + v.classe + " est juste, la faute est dans " + classe)));
        montrer(v, classe);
    }

    private boolean aUneFaute(String classe) {
        return !verifications(v -> v.classe.equals(classe) && !resultat.verdicts.get(v.id()).compte()).isEmpty();
    }

    private List<Verification> verifications(Predicate<Verification> lesquelles) {
        return reference.verifications.stream().filter(lesquelles).collect(Collectors.toList());
    }

    /** Celles de ces classes qu'il a rendues, et changées. */
    private List<String> changees(List<String> classes) {
        return classes.stream().filter(changees::contains).collect(Collectors.toList());
    }

    /** Celles des siennes où ce mot est employé. */
    private String emploient(String mot) {
        return changees(Modele.classes()).stream().filter(c -> Pattern.compile(mot)
                .matcher(Source.sansCommentaires(projet.texte(c))).find()).collect(Collectors.joining(", "));
    }

    /** Garde, pour la page, la méthode qui répond d'une vérification. */
    private void montrer(Verification v, String classe) {
        if (projet.texte(classe) != null) {
            resultat.methodes.put(v.id(), (classe.equals(v.classe) ? nommees(v) : methodes(classe).keySet()).stream()
                    .map(m -> Source.methode(projet.texte(classe), m)).collect(Collectors.joining()));
        }
    }

    private void consignes() {
        changees(Modele.A_COMPLETER).stream().filter(c -> !aUneFaute(c) && projet.texte(c).contains("FIXME"))
                .forEach(c -> projet.noter(Projet.FIXME, "reste dans " + c));
        for (String consigne : Projet.CONSIGNES.keySet()) {
            String ecart = projet.ecarts.get(consigne);
            resultat.verdicts.put(Grille.consigne(consigne), ecart == null ? new Verdict(Etat.REUSSI, "")
                    : new Verdict(Etat.RATE, ecart));
        }
        changees(Modele.classes()).forEach(c -> resultat.empreintes.put(c, Source.empreinte(projet.texte(c))));
    }

    /** L'image et les étapes doivent dire la même chose. */
    private void confronter() {
        List<Verification> perdues = verifications(v -> reference.compte(v) && !resultat.verdicts.get(v.id()).compte());
        List<String> autres = Reference.SCENES.keySet().stream().filter(scene -> !resultat.verdicts
                .get(Grille.IMAGE + "." + scene).compte()).collect(Collectors.toList());
        if (autres.isEmpty() && !perdues.isEmpty()) {
            resultat.regarder("image juste, mais " + perdues.size() + (perdues.size() > 1 ? " vérifications perdues, dont"
                    : " vérification perdue :") + " « " + perdues.get(0).titre + " »");
        } else if (perdues.isEmpty() && !autres.isEmpty()) {
            resultat.regarder("étapes toutes réussies, mais une autre image : « " + String.join(" », « ", autres) + " »"
                    + (resultat.classesFautives.isEmpty() ? "" : ", par " + String.join(", ", resultat.classesFautives)));
        }
        String enFloat = emploient("\\bfloat\\b");
        if (!enFloat.isEmpty() && (!autres.isEmpty() || !perdues.isEmpty())) {
            String grain = "des calculs en float (" + enFloat + ") : de là peut venir du grain, que le cours évite par des double";
            resultat.remarques.add(0, grain);
            resultat.regarder(grain);
        }
        String lisent = emploient("\\bSystem\\s*\\.\\s*in\\b");
        if (!lisent.isEmpty()) {
            resultat.regarder("lit l'entrée standard (" + lisent + ") : elle est vide ici, ce qu'il y attend n'a pas été essayé");
        }
    }

    private void variantes() throws Arret {
        for (Map.Entry<String, Map<String, String>> variante : projet.variantes.entrySet()) {
            String nom = variante.getKey();
            // une variante est une copie du projet ; ce qui n'y est pas est celui de la base
            Variante juge = new Variante(this, nom);
            resultat.verdicts.put(nom + ".image", juge.juger(ensemble, assembler(base(variante.getValue())),
                    assembler(base(projet.noms.dans(Modele.ajoutees(nom))))));
            resultat.images.putAll(juge.image);
        }
    }

    /**
     * La classe de l'étudiant parmi celles du corrigé ; avec celles des siennes dont elle a besoin, si elle en a
     * besoin.
     */
    Assemblage seule(String classe) throws Arret {
        if (seules.containsKey(classe)) {
            return seules.get(classe);
        }
        Map<String, String> sources = corrigeAvec(classe);
        Assemblage seule = assembler(sources);
        if (fautesNouvelles(seule, classe)) {
            List<String> nommees = new ArrayList<>();
            for (String autre : Modele.classes()) {
                String texte = projet.texte(autre);
                String sien = projet.noms.classe(autre);
                if (texte != null && !autre.equals(classe) && !autre.equals("Main")
                        && Pattern.compile("\\b" + sien + "\\b|\\." + autre.toLowerCase() + "\\b")
                        .matcher(projet.texte(classe)).find()) {
                    nommees.add(autre);
                    sources.put("lancer/" + sien, texte);
                }
            }
            seule = assembler(sources);
            if (fautesNouvelles(seule, classe)) {
                Set<String> cassees = seule.fautes.stream().map(Faute::classe).filter(nommees::contains)
                        .collect(Collectors.toCollection(TreeSet::new));
                dependances.put(classe, String.join(", ", cassees.isEmpty() ? nommees : cassees));
            } else {
                resultat.remarques.add(classe
                        + " a besoin de ce que vous avez ajouté ailleurs : jugée avec vos classes "
                        + String.join(", ", nommees));
            }
        }
        seules.put(classe, seule);
        return seule;
    }

    /** Vrai si là, parmi celles du corrigé, elle ne se compile plus comme avec celles de l'étudiant, ou les en empêche. */
    private boolean fautesNouvelles(Assemblage seule, String classe) {
        String sienne = projet.noms.classe(classe);
        return seule.fautesDe(sienne).size() > (ensemble == null ? 0 : ensemble.fautesDe(sienne).size())
                || seule.fautes.stream().anyMatch(f -> Modele.classes().contains(f.classe()) && !f.classe().equals(sienne)
                && ensemble != null && ensemble.fautesDe(f.classe()).isEmpty());
    }

    Map<String, Verdict> lancer(Assemblage assemblage, List<Verification> verifications) {
        Verifications.Bilan bilan = reference.junit.lancer(verifications, machine(assemblage));
        if (bilan.arrets > 0) {
            arretes.add(assemblage);
            resultat.regarder(bilan.pourquoi);
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
        if (!changees.contains(v.classe)) {
            return new Verdict(Etat.NON_COMMENCE, "la classe " + v.classe + " est celle du projet à compléter");
        }
        if (seule != null && seule.etat == Etat.REUSSI) {
            return new Verdict(Etat.CACHE, ensemble.message);
        }
        // si elle ne se compile que parmi les siennes, c'est là qu'on la juge
        Verdict verdict = seule == null || seule.message.startsWith(NE_SE_COMPILE_PAS)
                && !ensemble.message.startsWith(NE_SE_COMPILE_PAS) ? ensemble : seule;
        montrer(v, v.classe);
        if (verdict.etat == Etat.NON_COMMENCE) {
            return verdict.message.startsWith("étape non évaluable") ? new Verdict(Etat.NON_EVALUABLE, verdict.message)
                    : ecrite(v, verdict.message) ? new Verdict(Etat.RATE, verdict.message.replace("étape non commencée : ", ""))
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

    private Map<String, Boolean> methodes(String classe) {
        return Source.commencees(projet.texte(classe), projet.noms.dans(Modele.squelette(classe)));
    }

    /** Les méthodes à compléter dont parle cette vérification, à défaut toutes celles de sa classe. */
    private Set<String> nommees(Verification v) {
        Set<String> toutes = methodes(v.classe).keySet();
        Set<String> nommees = toutes.stream().filter(m -> Pattern.compile("\\b" + m + "\\b")
                .matcher(projet.noms.dans(v.titre)).find()).collect(Collectors.toCollection(TreeSet::new));
        return nommees.isEmpty() ? toutes : nommees;
    }

    /** Faux si la méthode dont parle cette vérification, à défaut une de sa classe, est celle du projet à compléter. */
    private boolean commencee(Verification v) {
        return nommees(v).stream().allMatch(methodes(v.classe)::get);
    }

    /** Vrai si la méthode qui, dit ce message, ne rend encore rien, est une des siennes, et qu'il l'a écrite. */
    private boolean ecrite(Verification v, String message) {
        return !DANS_LA_MEME_METHODE.contains(v.etape) && methodes(v.classe).entrySet().stream()
                .anyMatch(m -> m.getValue() && projet.noms.dans(message).contains(m.getKey()));
    }

    private String causes(String classe) {
        return Stream.concat(ensemble.fautesDe(projet.noms.classe(classe)).stream().map(Faute::toString),
                resultat.fautes.stream()).findFirst().map(f -> " ; " + f).orElse("");
    }

    /** Le corrigé, avec cette classe de l'étudiant, et celles qu'il a ajoutées ; celle qu'il n'a pas rendue, à compléter. */
    private Map<String, String> corrigeAvec(String classe) {
        Map<String, String> sources = new TreeMap<>(projet.base);
        sources.putAll(projet.noms.dans(Modele.tout(Modele::corrige)));
        sources.put("lancer/" + projet.noms.classe(classe), projet.texte(classe) != null ? projet.texte(classe)
                : projet.noms.dans(Modele.squelette(classe)));
        return sources;
    }

    /** @throws Dialogue.Echec si les classes ne savent pas dessiner, avec pourquoi */
    Image image(Assemblage assemblage, String scene, double decalage) throws Arret {
        int[] taille = Reference.SCENES.get(scene);
        // un petit dessin profond a moins de temps : si chaque reflet en demande deux, il ne finira pas
        return Image.lire(taille[0], taille[1], sonder(assemblage, taille[2] > 5 ? 1 : TEMPS_IMAGE, "dessiner",
                Modele.scene(scene), taille[0], taille[1], taille[2], decalage));
    }

    /** Une scène, par la méthode {@code TracerImage} de ces classes. */
    Image tracer(Assemblage assemblage, String texteDeScene, int largeur, int hauteur) throws Arret {
        return Image.lire(largeur, hauteur, sonder(assemblage, TEMPS_IMAGE, "tracer", texteDeScene, largeur, hauteur, 1));
    }

    /** Ce que répondent, en chemin, les méthodes de ces classes. */
    String chemin(Assemblage assemblage, String scene, double x, double y) throws Arret {
        int[] taille = Reference.SCENES.get(scene);
        return sonder(assemblage, TEMPS_IMAGE, "decrire", Modele.scene(scene), taille[0], taille[1], x, y, Math.min(5, taille[2]));
    }

    private String sonder(Assemblage assemblage, double temps, String methode, String scene, Object... arguments) throws Arret {
        Machines.Rendue ici = machine(assemblage);
        ici.commencer(temps * ici.calcul());
        try {
            return ici.sonder(methode.equals("decrire") ? Echange.REPONSE_MAX : Echange.GROSSE_REPONSE_MAX, methode, scene, arguments);
        } catch (StackOverflowError e) {
            throw new Dialogue.Echec(e.getMessage());
        }
    }

    /** Dessine chaque scène et compare ; de la première qui diffère, cherche d'où cela vient. */
    private void jugerLesImages() {
        String fausse = null;
        for (String scene : Reference.SCENES.keySet()) {
            Verdict verdict = jugerLImage(scene);
            resultat.verdicts.put(Grille.IMAGE + "." + scene, verdict);
            fausse = fausse == null && verdict.etat == Etat.RATE && resultat.images.containsKey(scene) ? scene : fausse;
        }
        if (fausse != null) {
            try {
                chercherLaFaute(fausse);
            } catch (Arret | Dialogue.Echec e) {
                resultat.remarques.add("la recherche de la faute dans l'image s'est arrêtée : " + e.getMessage());
            }
        }
    }

    private Verdict jugerLImage(String scene) {
        Image image;
        try {
            image = image(ensemble, scene, 0);
        } catch (Arret e) {
            resultat.regarder(e.getMessage() + " (en dessinant « " + scene + " »)");
            return new Verdict(Etat.RATE, e.getMessage());
        } catch (Dialogue.Echec e) {
            return new Verdict(Etat.RATE, e.getMessage());
        }
        // là où le rendu a raison, au ciel au moins, il l'a à un demi-pixel près : c'est là qu'on voit lequel
        resultat.centre = resultat.images.isEmpty() ? image.pareils(reference.getImage(scene, true))
                > image.pareils(reference.getImage(scene, false)) : resultat.centre;
        resultat.images.put(scene, image);
        Ecart ecart = new Ecart(reference.getImage(scene, resultat.centre), image);
        return ecart.memeImage() ? new Verdict(Etat.REUSSI, "") : new Verdict(commencee(image) ? Etat.RATE
                : Etat.NON_COMMENCE, ecart.combien());
    }

    /** Faux pour l'image d'une seule couleur du projet à compléter. */
    private static boolean commencee(Image image) {
        return IntStream.range(1, image.pixels()).anyMatch(p -> image.code(p % image.largeur, p / image.largeur) != image.code(0, 0));
    }

    private void chercherLaFaute(String scene) throws Arret {
        Image image = resultat.images.get(scene);
        Image attendue = reference.getImage(scene, resultat.centre);
        Ecart ecart = new Ecart(attendue, image);
        resultat.chemin = chemin(scene, ecart.pire % image.largeur, ecart.pire / image.largeur);
        // un pixel très faux l'est souvent par ce qu'il reflète : un autre, moins faux, montre mieux d'où cela vient
        int pas = Math.max(1, image.pixels() / PIXELS_ESSAYES);
        for (int p = pas / 2; p < image.pixels(); p += pas) {
            if (Ecart.ecart(attendue, image, p) > 1) {
                Chemin autre = chemin(scene, p % image.largeur, p / image.largeur);
                resultat.chemin = autre.rangDuPremierEcart() < resultat.chemin.rangDuPremierEcart() ? autre : resultat.chemin;
            }
        }
        for (String classe : changees(Modele.A_COMPLETER)) {
            if (changentLImage(scene, seule(classe))) {
                resultat.classesFautives.add(classe);
            }
        }
    }

    /** Vrai si cet assemblage ne dessine pas l'image du corrigé. */
    private boolean changentLImage(String scene, Assemblage assemblage) {
        try {
            Image image = arretes.contains(assemblage) ? null : image(assemblage, scene, 0);
            return image == null || !new Ecart(reference.getImage(scene, false), image).memeImage()
                    && !new Ecart(reference.getImage(scene, true), image).memeImage();
        } catch (Arret | Dialogue.Echec e) {
            return true;
        }
    }

    private Chemin chemin(String scene, int x, int y) throws Arret {
        double decalage = resultat.centre ? 0.5 : 0;
        return new Chemin(x, y, reference.chemin(scene, x + decalage, y + decalage), chemin(ensemble, scene, x, y));
    }
}
