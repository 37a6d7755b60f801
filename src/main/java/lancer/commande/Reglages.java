package lancer.commande;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.Collectors;
import lancer.Constantes;
import lancer.contrat.Modele;
import lancer.contrat.Parametre;
import lancer.contrat.Section;
import lancer.contrat.Variante;

/**
 * La façon de dessiner une scène : étape, réflexions, seuil, et chaque variante présente, branchée ou non, avec sa
 * section. Immuable. Une méthode dont le nom commence par {@code avec} rend les mêmes réglages, à son argument près.
 */
public final class Reglages {

    private final Etape etape;
    private final int reflets;
    private final double seuil;
    private final boolean simple;
    /** Types des variantes débranchées, quelle que soit leur casse. */
    private final SortedSet<String> debranchees;
    /** La section de chaque variante présente dans le fichier, de ligne 0 s'il n'en a pas ; puis celle qui sert. */
    private final Map<Variante, Section> lues;
    private final Map<Variante, Section> sections;

    private Reglages(Etape etape, int reflets, double seuil, boolean simple, Collection<String> debranchees,
            Map<Variante, Section> lues, Map<Variante, Section> sections) {
        this.etape = etape;
        this.reflets = reflets;
        this.seuil = seuil;
        this.simple = simple;
        this.debranchees = new TreeSet<>(String.CASE_INSENSITIVE_ORDER);
        this.debranchees.addAll(debranchees);
        this.lues = lues;
        this.sections = sections;
    }

    /** Ceux du cours, pour une scène qui n'est pas encore lue. */
    public Reglages() {
        this(Etape.REFLETS, Constantes.MAX_REFLETS, Constantes.SEUIL, false, Collections.emptySet(),
                Collections.emptyMap(), Collections.emptyMap());
    }

    /**
     * Ces réglages, pour une scène qui vient d'être lue. Une section changée est gardée si celle du fichier est la même
     * qu'à la lecture précédente.
     *
     * @param lues la section de chaque variante présente
     */
    public Reglages pour(Map<Variante, Section> lues) {
        Map<Variante, Section> gardees = new LinkedHashMap<>(lues);
        for (Variante avant : this.lues.keySet()) {
            for (Variante apres : lues.keySet()) {
                if (apres.getSection().equals(avant.getSection()) && lues.get(apres).equals(this.lues.get(avant))) {
                    gardees.put(apres, sections.get(avant));
                }
            }
        }
        return new Reglages(etape, reflets, seuil, simple, debranchees, lues, gardees);
    }

    public Reglages avecEtape(Etape autre) {
        return new Reglages(autre, reflets, seuil, simple, debranchees, lues, sections);
    }

    public Reglages avecReflets(int autres) {
        return new Reglages(etape, autres, seuil, simple, debranchees, lues, sections);
    }

    public Reglages avecSeuil(double autre) {
        return new Reglages(etape, reflets, autre, simple, debranchees, lues, sections);
    }

    /** Les mêmes, avec les boucles du cours au lieu de la recherche rapide. */
    public Reglages avecLesBoucles() {
        return new Reglages(etape, reflets, seuil, true, debranchees, lues, sections);
    }

    /** Les mêmes, sans ces variantes. @param types quelle que soit leur casse, et que les variantes soient présentes */
    public Reglages sans(Collection<String> types) {
        return new Reglages(etape, reflets, seuil, simple, types, lues, sections);
    }

    public Reglages avecVariante(Variante variante, boolean branchee) {
        List<String> autres = new ArrayList<>(debranchees);
        autres.removeIf(variante.getSection()::equalsIgnoreCase);
        if (!branchee) {
            autres.add(variante.getSection());
        }
        return new Reglages(etape, reflets, seuil, simple, autres, lues, sections);
    }

    public Reglages avecSection(Variante variante, Section section) {
        Map<Variante, Section> autres = new LinkedHashMap<>(sections);
        autres.put(variante, section);
        return new Reglages(etape, reflets, seuil, simple, debranchees, lues, autres);
    }

    public Etape getEtape() {
        return etape;
    }

    public int getReflets() {
        return reflets;
    }

    /** Le nombre de réflexions, compte tenu de l'étape du cours. */
    public int getProfondeur() {
        return etape == Etape.REFLETS ? reflets : 0;
    }

    public double getSeuil() {
        return seuil;
    }

    /** Dit si les boucles du cours cherchent les contacts, au lieu de la recherche rapide. */
    public boolean isSimple() {
        return simple;
    }

    /** Les types des variantes débranchées, présentes ou non. */
    public Set<String> getDebranchees() {
        return Collections.unmodifiableSet(debranchees);
    }

    /** Les variantes présentes, branchées ou non. */
    public Set<Variante> getVariantes() {
        return Collections.unmodifiableSet(sections.keySet());
    }

    /** La variante de cette section. Chaque lecture de la scène crée de nouvelles variantes. */
    public Variante getVariante(String section) {
        return sections.keySet().stream().filter(presente -> presente.getSection().equals(section)).findFirst().get();
    }

    public boolean estBranchee(Variante variante) {
        return !debranchees.contains(variante.getSection());
    }

    /** La section de cette variante, branchée ou non. */
    public Section getSection(Variante variante) {
        return sections.get(variante);
    }

    /** La section de cette variante, valeurs par défaut comprises, sauf celle d'une couleur. */
    public Section getSectionEntiere(Variante variante) {
        Section entiere = getSection(variante);
        for (Parametre parametre : variante.getParametres()) {
            String valeur = parametre.estUneCouleur() ? null : getValeur(variante, parametre);
            entiere = valeur == null || valeur.equals(entiere.mot(parametre.cle, null)) ? entiere
                    : entiere.avec(parametre.cle, valeur, null);
        }
        return entiere;
    }

    /** La valeur de ce paramètre, donnée ou par défaut ; {@code null} si une autre clé le remplace. */
    public String getValeur(Variante variante, Parametre parametre) {
        Section section = getSection(variante);
        String donnee = section.mot(parametre.cle, null);
        boolean ailleurs = parametre.autre != null && section.mot(parametre.autre, null) != null;
        return donnee != null || ailleurs ? donnee : parametre.defaut;
    }

    /** La variante branchée, absente du fichier, dont des essais choisissent la section ; ou {@code null}. */
    public Variante getEssayee() {
        return sections.keySet().stream().filter(variante -> estBranchee(variante) && lues.get(variante).ligne == 0
                && !getSectionsProposees(variante).isEmpty()).findFirst().orElse(null);
    }

    /** Voir {@link Variante#getSectionsProposees}. */
    public Map<Section, Double> getSectionsProposees(Variante variante) {
        return Objects.requireNonNull(variante.getSectionsProposees(lues.get(variante)),
                variante.getClass().getName() + ".getSectionsProposees a rendu null");
    }

    /** Les sections à écrire dans le fichier, à la place des siennes, pour obtenir ces réglages. */
    public List<Section> getSectionsChangees() {
        return sections.keySet().stream().filter(this::estBranchee).filter(v -> !getSection(v).equals(lues.get(v)))
                .map(this::getSection).collect(Collectors.toList());
    }

    /**
     * Le modèle qu'appliquent ces réglages : chaque variante branchée y est installée. Si le fichier contient la
     * section d'une variante débranchée, elle est vérifiée aussi.
     *
     * @throws lancer.SceneFautive si une section est refusée
     */
    public Modele getModele() {
        Modele modele = new Modele();
        modele.setSeuil(seuil);
        for (Variante variante : sections.keySet()) {
            Section section = sections.get(variante);
            if (estBranchee(variante) || section == lues.get(variante)) {
                variante.installer(section, estBranchee(variante) ? modele : new Modele());
                section.verifierCles();
            }
        }
        if (etape == Etape.LAMBERT) {
            modele.oterSpecularite();
        }
        if (etape.compareTo(Etape.OMBRES) < 0) {
            modele.oterOmbres();
        }
        return modele;
    }

    /** Les options de la ligne de commande qui donnent ces réglages, précédées d'un blanc ; vide s'il n'en faut pas. */
    public String getOptions() {
        StringBuilder options = new StringBuilder();
        ajouter(options, etape != Etape.REFLETS, " --etape " + etape);
        ajouter(options, reflets != Constantes.MAX_REFLETS, " --reflets " + reflets);
        ajouter(options, seuil != Constantes.SEUIL, " --seuil " + seuil);
        ajouter(options, simple, " --simple");
        ajouter(options, !debranchees.isEmpty(), " --sans " + String.join(",", debranchees));
        return options.toString();
    }

    private static void ajouter(StringBuilder options, boolean donnee, String option) {
        options.append(donnee ? option : "");
    }

    /** Deux réglages égaux donnent la même image d'une même scène. */
    @Override
    public boolean equals(Object autre) {
        return autre instanceof Reglages && cle().equals(((Reglages) autre).cle());
    }

    @Override
    public int hashCode() {
        return Objects.hash(etape, reflets, seuil);
    }

    private List<Object> cle() {
        return Arrays.asList(etape, reflets, seuil, simple, debranchees, new ArrayList<>(sections.values()));
    }

    /** Texte lisible, par exemple {@code 5 réflexions, [Brume] densite=0.1 debut=0, [Blinn] facteur=1}. */
    @Override
    public String toString() {
        String permises = reflets + (reflets > 1 ? " réflexions" : " réflexion");
        String choisi = etape != Etape.REFLETS ? "étape " + etape : permises;
        return choisi + (seuil == Constantes.SEUIL ? "" : ", seuil " + seuil)
                + sections.keySet().stream().filter(this::estBranchee).map(v -> ", " + getSectionEntiere(v))
                .collect(Collectors.joining());
    }
}
