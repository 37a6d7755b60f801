package lancer.commande;

import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import lancer.contrat.Modele;
import lancer.contrat.Parametre;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.systeme.Console;
import lancer.texte.Nombre;

/**
 * Ce qui est demandé : la scène, la valeur de chaque option et, quand la scène est lue, chaque variante présente,
 * branchée ou non, avec sa section. Immuable. Une méthode dont le nom commence par {@code avec} rend les mêmes
 * réglages, à son argument près.
 */
public final class Reglages {

    /** Le nom du fichier de la scène, {@code null} si aucun n'est donné. */
    public final String scene;
    /** Le texte de chaque option donnée, que son option lit. */
    private final Map<Option<?>, String> textes;
    /** La section que le fichier donne à chaque variante présente ; de ligne 0 s'il n'en donne pas. */
    private final Map<Variante, Section> sectionsDuFichier;
    /** La section de chaque variante présente : celle du fichier, ou celle qui la remplace. */
    private final Map<Variante, Section> sections;

    private Reglages(String scene, Map<Option<?>, String> textes, Map<Variante, Section> sectionsDuFichier,
            Map<Variante, Section> sections) {
        this.scene = scene;
        this.textes = textes;
        this.sectionsDuFichier = sectionsDuFichier;
        this.sections = sections;
    }

    /** Ceux de la ligne de commande, pour une scène qui n'est pas encore lue. */
    Reglages(String scene, Map<Option<?>, String> textes) {
        this(scene, textes, Collections.emptyMap(), Collections.emptyMap());
    }

    /**
     * Ces réglages, pour une scène qui vient d'être lue. Une section changée est gardée si celle du fichier est la même
     * qu'à la lecture précédente.
     *
     * @param sectionsLues la section de chaque variante présente
     */
    public Reglages pour(Map<Variante, Section> sectionsLues) {
        Map<Variante, Section> sectionsGardees = new LinkedHashMap<>(sectionsLues);
        for (Variante variante : sectionsLues.keySet()) {
            if (sectionsLues.get(variante).equals(sectionsDuFichier.get(variante))) {
                sectionsGardees.put(variante, sections.get(variante));
            }
        }
        return new Reglages(scene, textes, sectionsLues, sectionsGardees);
    }

    /** La valeur de cette option, donnée ou non. */
    public <T> T get(Option<T> option) {
        return estDonnee(option) ? option.lire(textes.get(option)) : option.absente;
    }

    public boolean estDonnee(Option<?> option) {
        return textes.containsKey(option);
    }

    public <T> Reglages avec(Option<T> option, T valeur) {
        Map<Option<?>, String> nouveauxTextes = new HashMap<>(textes);
        if (Objects.equals(valeur, option.absente)) {
            nouveauxTextes.remove(option);
        } else {
            nouveauxTextes.put(option, option.ecrire(valeur));
        }
        return new Reglages(scene, nouveauxTextes, sectionsDuFichier, sections);
    }

    public Reglages avecVariante(Variante variante, boolean branchee) {
        Set<String> debranchees = new TreeSet<>(String.CASE_INSENSITIVE_ORDER);
        debranchees.addAll(get(Option.SANS));
        debranchees.remove(variante.getSection());
        if (!branchee) {
            debranchees.add(variante.getSection());
        }
        return avec(Option.SANS, Collections.unmodifiableSet(debranchees));
    }

    public Reglages avecSection(Variante variante, Section section) {
        Map<Variante, Section> nouvellesSections = new LinkedHashMap<>(sections);
        nouvellesSections.put(variante, section);
        return new Reglages(scene, textes, sectionsDuFichier, nouvellesSections);
    }

    /** Dit si la demande (fichier, pixel, comparaison) se fait sans fenêtre. */
    public boolean sansFenetre() {
        return estDonnee(Option.IMAGE) || estDonnee(Option.LINEAIRE) || estDonnee(Option.PIXEL)
                || estDonnee(Option.COMPARER);
    }

    /** Les options qui donnent la même image, précédées d'un blanc ; vide s'il n'en faut pas. */
    public String getOptions() {
        return Option.TABLE.stream().filter(option -> option.changeLImage).map(this::ecrire)
                .collect(Collectors.joining());
    }

    private <T> String ecrire(Option<T> option) {
        T valeur = get(option);
        return valeur.equals(option.absente) ? ""
                : " " + option.nom + (option.prendUneValeur() ? " " + Console.mot(option.ecrire(valeur)) : "");
    }

    /** Le nombre de réflexions, compte tenu de l'étape du cours. */
    public int getProfondeur() {
        return get(Option.ETAPE) == Etape.REFLETS ? get(Option.REFLETS) : 0;
    }

    /** Les variantes présentes, branchées ou non. */
    public Set<Variante> getVariantes() {
        return Collections.unmodifiableSet(sections.keySet());
    }

    public boolean estBranchee(Variante variante) {
        return !get(Option.SANS).contains(variante.getSection());
    }

    /** La section de cette variante, branchée ou non. */
    public Section getSection(Variante variante) {
        return sections.get(variante);
    }

    /** La section de cette variante, valeurs par défaut comprises, sauf celle d'une couleur. */
    public Section getSectionEntiere(Variante variante) {
        Section entiere = getSection(variante);
        for (Parametre parametre : variante.getParametres()) {
            String valeur = parametre.estUnTexte() ? null : getValeur(variante, parametre);
            entiere = valeur == null ? entiere : entiere.avec(parametre.cle, valeur, null);
        }
        return entiere;
    }

    /** La valeur de ce paramètre, donnée ou par défaut ; {@code null} si une autre clé le remplace. */
    public String getValeur(Variante variante, Parametre parametre) {
        Section section = getSection(variante);
        String donnee = section.mot(parametre.cle, null);
        String incompatible = parametre.cleIncompatible;
        boolean remplacee = incompatible != null && section.mot(incompatible, null) != null;
        return donnee != null || remplacee ? donnee : parametre.defaut;
    }

    /** La variante branchée, absente du fichier, dont des essais choisissent la section ; ou {@code null}. */
    public Variante getEssayee() {
        return sections.keySet().stream()
                .filter(v -> estBranchee(v) && sectionsDuFichier.get(v).ligne == 0)
                .filter(v -> !v.getSectionsProposees(getSection(v)).isEmpty()).findFirst().orElse(null);
    }

    /** Les sections à écrire dans le fichier, à la place des siennes, pour obtenir ces réglages. */
    public List<Section> getSectionsChangees() {
        return sections.keySet().stream().filter(this::estBranchee)
                .filter(v -> !getSection(v).equals(sectionsDuFichier.get(v))).map(this::getSection)
                .collect(Collectors.toList());
    }

    /**
     * Le modèle qu'appliquent ces réglages : chaque variante branchée y est installée. La section d'une variante
     * débranchée est vérifiée aussi.
     *
     * @throws lancer.SceneFautive si une section est refusée
     */
    public Modele getModele() {
        Modele.Construction modele = new Modele.Construction();
        modele.setSeuil(get(Option.SEUIL));
        for (Variante variante : sections.keySet()) {
            variante.installer(getSection(variante), estBranchee(variante) ? modele : new Modele.Construction());
            getSection(variante).verifierCles();
        }
        if (get(Option.ETAPE) == Etape.LAMBERT) {
            modele.oterSpecularite();
        }
        if (get(Option.ETAPE).compareTo(Etape.OMBRES) < 0) {
            modele.oterOmbres();
        }
        return modele.construire();
    }

    /** Deux réglages égaux donnent la même image d'une même scène. */
    @Override
    public boolean equals(Object autre) {
        return autre instanceof Reglages && getOptions().equals(((Reglages) autre).getOptions())
                && sections.equals(((Reglages) autre).sections);
    }

    @Override
    public int hashCode() {
        return sections.hashCode();
    }

    /** Texte lisible, par exemple {@code 5 réflexions, [Brume] densite=0.1 debut=0, [Blinn] facteur=1}. */
    @Override
    public String toString() {
        int reflets = get(Option.REFLETS);
        String reflexions = reflets + (reflets > 1 ? " réflexions" : " réflexion");
        String etape = get(Option.ETAPE) == Etape.REFLETS ? reflexions : "étape " + get(Option.ETAPE);
        String seuil = get(Option.SEUIL).equals(Option.SEUIL.absente) ? ""
                : ", seuil " + Nombre.enFraction(get(Option.SEUIL));
        return etape + seuil + sections.keySet().stream().filter(this::estBranchee)
                .map(v -> ", " + getSectionEntiere(v)).collect(Collectors.joining());
    }
}
