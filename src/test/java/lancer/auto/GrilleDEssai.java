package lancer.auto;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;
import lancer.Couleur;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Modele;
import lancer.contrat.Pave;
import lancer.contrat.Reglable;
import lancer.contrat.Section;
import lancer.contrat.Toile;
import lancer.contrat.Variante;
import lancer.contrat.Vue;

/** Une quatrième variante, d'étudiant : n × n sous-pixels. */
final class GrilleDEssai implements Reglable {

    private final List<Section> reglages;

    /** @param reglages ceux que {@code --auto} peut essayer */
    GrilleDEssai(List<Section> reglages) {
        this.reglages = reglages;
    }

    /** Elle seule, à essayer avec ces n. */
    static List<Variante> seule(String... n) {
        return Collections.singletonList(new GrilleDEssai(
                Arrays.stream(n).map(x -> Section.reglage("Grille", "n", x)).collect(Collectors.toList())));
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
    public List<Section> getReglages() {
        return reglages;
    }

    private static Echantillonnage grille(int n) {
        return new Echantillonnage() {
            @Override
            public int tracer(Pave pave, Vue vue, Toile toile) {
                for (int j = pave.j0; j < pave.j1; j++) {
                    for (int i = pave.i0; i < pave.i1; i++) {
                        Couleur somme = new Couleur();
                        for (int k = 0; k < n * n; k++) {
                            somme = somme.add(vue.couleur(i + (k % n + 0.5) / n, j + (k / n + 0.5) / n));
                        }
                        toile.drawPixel(somme.div(n * n), i, j);
                    }
                }
                return 0;
            }

            @Override
            public int tracer(Pave pave, Pave voulus, Vue vue, Toile toile) {
                return tracer(voulus, vue, toile);
            }
        };
    }
}
