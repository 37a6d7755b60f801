package lancer.auto;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import lancer.Couleur;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Modele;
import lancer.contrat.Releve;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.scene.SectionLue;

/** Une quatrième variante, d'étudiant : n × n sous-pixels. */
class GrilleDEssai implements Variante {

    private final Map<Section, Double> proposees;

    /** @param proposees ce que {@code --auto} peut essayer */
    GrilleDEssai(Map<Section, Double> proposees) {
        this.proposees = proposees;
    }

    /** Elle seule, à essayer avec ces n. */
    static Map<Variante, Section> seule(String... n) {
        Map<Section, Double> proposees = new LinkedHashMap<>();
        Arrays.stream(n).forEach(celui -> proposees.put(new SectionLue("Grille", "n", celui), 0.0));
        return avec(proposees);
    }

    /** Elle seule, à essayer avec ces sections. */
    static Map<Variante, Section> avec(Map<Section, Double> proposees) {
        return Map.of(new GrilleDEssai(proposees), new SectionLue("Grille"));
    }

    @Override
    public String getSection() {
        return "Grille";
    }

    @Override
    public void installer(Section valeurs, Modele.Construction modele) {
        modele.setEchantillonnage(grille(valeurs.entier("n", 2, 1, 16)));
    }

    @Override
    public Map<Section, Double> getSectionsProposees(Section sienne) {
        return proposees;
    }

    static Echantillonnage grille(int n) {
        return (pave, voulus, vue, toile) -> {
            for (int j = voulus.j0; j < voulus.j1; j++) {
                for (int i = voulus.i0; i < voulus.i1; i++) {
                    Couleur somme = new Couleur();
                    for (int k = 0; k < n * n; k++) {
                        somme = somme.add(vue.couleur(i + (k % n + 0.5) / n, j + (k / n + 0.5) / n));
                    }
                    toile.drawPixel(somme.div(n * n), i, j);
                }
            }
            return Releve.RIEN;
        };
    }
}
