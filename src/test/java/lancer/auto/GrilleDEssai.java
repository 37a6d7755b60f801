package lancer.auto;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import lancer.Couleur;
import lancer.contrat.ReglagePropose;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Modele;
import lancer.contrat.Pave;
import lancer.contrat.Section;
import lancer.contrat.Toile;
import lancer.contrat.Variante;
import lancer.contrat.Vue;
import lancer.scene.SectionLue;

/** Une quatrième variante, d'étudiant : n × n sous-pixels. */
final class GrilleDEssai implements Variante {

    private final List<ReglagePropose> proposes;

    /** @param proposes ce que {@code --auto} peut essayer */
    GrilleDEssai(List<ReglagePropose> proposes) {
        this.proposes = proposes;
    }

    /** Elle seule, à essayer avec ces n. */
    static Map<Variante, Section> seule(String... n) {
        return avec(Arrays.stream(n).map(GrilleDEssai::propose).collect(Collectors.toList()));
    }

    /** Elle seule, à essayer avec ces réglages. */
    static Map<Variante, Section> avec(List<ReglagePropose> proposes) {
        return Collections.singletonMap(new GrilleDEssai(proposes), new SectionLue("Grille"));
    }

    static ReglagePropose propose(String n) {
        return new ReglagePropose(new SectionLue("Grille", "n", n), 0);
    }

    @Override
    public String getSection() {
        return "Grille";
    }

    @Override
    public void installer(Section valeurs, Modele modele) {
        modele.setEchantillonnage(grille(valeurs.entier("n", 2, 1, 16)));
    }

    @Override
    public List<ReglagePropose> getReglagesProposes(Section sienne) {
        return proposes;
    }

    private static Echantillonnage grille(int n) {
        return new Echantillonnage() {
            @Override
            public int tracer(Pave pave, Pave voulus, Vue vue, Toile toile) {
                for (int j = voulus.j0; j < voulus.j1; j++) {
                    for (int i = voulus.i0; i < voulus.i1; i++) {
                        Couleur somme = new Couleur();
                        for (int k = 0; k < n * n; k++) {
                            somme = somme.add(vue.couleur(i + (k % n + 0.5) / n, j + (k / n + 0.5) / n));
                        }
                        toile.drawPixel(somme.div(n * n), i, j);
                    }
                }
                return 0;
            }
        };
    }
}
