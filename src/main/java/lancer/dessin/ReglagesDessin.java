package lancer.dessin;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.Collectors;
import lancer.Constantes;
import lancer.commande.Echec;
import lancer.commande.Etape;
import lancer.commande.Options;
import lancer.contrat.Modele;
import lancer.contrat.Parametre;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.scene.LecteurSections;
import lancer.texte.Texte;

/** Réglages d'une scène lue : étape, réflexions, seuil, et chaque variante, branchée ou non. Immuable. */
public final class ReglagesDessin {

    private final Etape etape;
    private final int reflets;
    private final double seuil;
    /** Section du fichier pour chaque variante présente ; sa ligne est 0 si le fichier n'en a pas. */
    private final Map<Variante, Section> lues;
    /** Sections qui remplacent celles du fichier, par type. */
    private final Map<String, Section> changees;
    /** Types des variantes débranchées, quelle que soit leur casse. */
    private final SortedSet<String> debranchees;

    /** Réglages de la ligne de commande et du fichier ; {@code null} si ce sont ceux-ci. */
    private final ReglagesDessin initiaux;

    private ReglagesDessin(Etape etape, int reflets, double seuil, Map<Variante, Section> lues,
            Map<String, Section> changees, SortedSet<String> debranchees, ReglagesDessin initiaux) {
        this.etape = etape;
        this.reflets = reflets;
        this.seuil = seuil;
        this.lues = lues;
        this.changees = changees;
        this.debranchees = debranchees;
        this.initiaux = initiaux;
    }

    /** Réglages de la ligne de commande et du fichier. @param lues la section de chaque variante présente */
    ReglagesDessin(Map<Variante, Section> lues, Options options) {
        this(options.etape, options.reflets, options.seuil, lues, new HashMap<>(),
                new TreeSet<>(String.CASE_INSENSITIVE_ORDER), null);
        debranchees.addAll(options.sans);
    }

    /** @throws Echec si {@code --sans} nomme une variante qui n'existe pas */
    void verifier(Options options) {
        for (String type : options.sans) {
            if (!LecteurSections.varianteConnue(type)
                    && lues.keySet().stream().noneMatch(presente -> presente.getSection().equalsIgnoreCase(type))) {
                throw Echec.demande("valeur impossible pour --sans : " + Texte.cite(type)
                        + " ; attendu : une variante, par exemple Brume");
            }
        }
    }

    /** Réglages de la ligne de commande et du fichier, avant tout changement. */
    public ReglagesDessin initiaux() {
        return initiaux == null ? this : initiaux;
    }

    public int getReflets() {
        return reflets;
    }

    public Etape getEtape() {
        return etape;
    }

    /** Le nombre de réflexions, compte tenu de l'étape du cours. */
    public int getProfondeur() {
        return etape == Etape.REFLETS ? reflets : 0;
    }

    public double getSeuil() {
        return seuil;
    }

    /** Les variantes présentes, branchées ou non. */
    public Set<Variante> getVariantes() {
        return lues.keySet();
    }

    /** La variante de cette section. Chaque lecture de la scène crée de nouvelles variantes. */
    public Variante getVariante(String section) {
        return lues.keySet().stream().filter(presente -> presente.getSection().equals(section)).findFirst().get();
    }

    public boolean estBranchee(Variante variante) {
        return !debranchees.contains(variante.getSection());
    }

    /** La section de cette variante, branchée ou non. */
    public Section getSection(Variante variante) {
        return changees.getOrDefault(variante.getSection(), lues.get(variante));
    }

    /** La section de cette variante, valeurs par défaut comprises, sauf celle d'une couleur. */
    public Section getSectionEntiere(Variante variante) {
        Section entiere = getSection(variante);
        for (Parametre parametre : variante.getParametres()) {
            String valeur = parametre.estUneCouleur() ? null : getValeur(variante, parametre);
            entiere = valeur == null || valeur.equals(entiere.valeur(parametre.cle)) ? entiere
                    : entiere.avec(parametre.cle, valeur, null);
        }
        return entiere;
    }

    /** La valeur de ce paramètre, donnée ou par défaut ; {@code null} si une autre clé le remplace. */
    public String getValeur(Variante variante, Parametre parametre) {
        Section section = getSection(variante);
        String donnee = section.valeur(parametre.cle);
        boolean ailleurs = parametre.autre != null && section.valeur(parametre.autre) != null;
        return donnee != null || ailleurs ? donnee : parametre.defaut;
    }

    /** Variantes branchées qui proposent des réglages, et dont la section n'est pas dans le fichier de scène. */
    public Map<Variante, Section> getEssayees() {
        Map<Variante, Section> essayees = new LinkedHashMap<>(lues);
        essayees.entrySet().removeIf(lue -> !estBranchee(lue.getKey()) || lue.getValue().ligne != 0
                || lue.getKey().getReglagesProposes(lue.getValue()).isEmpty());
        return essayees;
    }

    /** Section entière de la première variante dont des essais choisissent les valeurs ; {@code null} sinon. */
    public Section getSectionEssayee() {
        return getEssayees().keySet().stream().map(this::getSectionEntiere).findFirst().orElse(null);
    }

    /** Les sections à écrire dans le fichier, à la place des siennes, pour obtenir ces réglages. */
    public List<Section> getSectionsChangees() {
        return lues.keySet().stream().filter(this::estBranchee).map(Variante::getSection).map(changees::get)
                .filter(Objects::nonNull).collect(Collectors.toList());
    }

    /** Réglages identiques, sauf ceux des arguments. Les trois méthodes suivantes font de même. */
    public ReglagesDessin avec(int autresReflets, double autreSeuil) {
        return new ReglagesDessin(etape, autresReflets, autreSeuil, lues, changees, debranchees, initiaux());
    }

    public ReglagesDessin avec(Etape autre) {
        return new ReglagesDessin(autre, reflets, seuil, lues, changees, debranchees, initiaux());
    }

    public ReglagesDessin avec(Variante variante, boolean branchee) {
        SortedSet<String> autres = new TreeSet<>(debranchees);
        if (branchee) {
            autres.remove(variante.getSection());
        } else {
            autres.add(variante.getSection());
        }
        return new ReglagesDessin(etape, reflets, seuil, lues, changees, autres, initiaux());
    }

    public ReglagesDessin avec(Variante variante, Section section) {
        Map<String, Section> autres = new HashMap<>(changees);
        autres.put(variante.getSection(), section);
        return new ReglagesDessin(etape, reflets, seuil, lues, autres, debranchees, initiaux());
    }

    /** Les réglages d'une scène relue : une section changée est gardée si celle du fichier est la même qu'avant. */
    public ReglagesDessin pour(ReglagesDessin luesApres) {
        Map<String, Section> gardees = new HashMap<>(changees);
        for (Variante apres : luesApres.lues.keySet()) {
            Section avant = lues.get(getVariante(apres.getSection()));
            if (!avant.toString().equals(luesApres.lues.get(apres).toString())) {
                gardees.remove(apres.getSection());
            }
        }
        return new ReglagesDessin(etape, reflets, seuil, luesApres.lues, gardees, debranchees, luesApres);
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
        for (Variante variante : lues.keySet()) {
            Section section = getSection(variante);
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
        return (etape == Etape.REFLETS ? "" : " --etape " + etape)
                + (reflets == Constantes.MAX_REFLETS ? "" : " --reflets " + reflets)
                + (seuil == Constantes.SEUIL ? "" : " --seuil " + seuil)
                + (debranchees.isEmpty() ? "" : " --sans " + String.join(",", debranchees));
    }

    /** Texte lisible, par exemple {@code 5 réflexions, [Brume] densite=0.1 debut=0, [Blinn] facteur=1}. */
    @Override
    public String toString() {
        StringBuilder s = new StringBuilder(etape != Etape.REFLETS ? "étape " + etape
                : reflets + (reflets > 1 ? " réflexions" : " réflexion"));
        if (seuil != Constantes.SEUIL) {
            s.append(", seuil ").append(seuil);
        }
        for (Variante variante : lues.keySet()) {
            if (estBranchee(variante)) {
                s.append(", ").append(getSectionEntiere(variante));
            }
        }
        return s.toString();
    }
}
