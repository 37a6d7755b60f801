package lancer.essai;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import lancer.contrat.Modele;
import lancer.contrat.Parametre;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.scene.SectionLue;

/** Ce qu'une variante laisse régler à la souris. */
public final class EssaiParametres {

    private EssaiParametres() {
    }

    /** Ce sont ces clés, et sa section les accepte, du premier cran à leur valeur par défaut, ou chacun de leurs mots. */
    public static void verifier(Variante variante, String... cles) {
        assertEquals(Arrays.asList(cles), variante.getParametres().stream().map(p -> p.cle).collect(Collectors.toList()));
        for (Parametre p : variante.getParametres()) {
            List<String> valeurs = new ArrayList<>(p.mots);
            if (p.estUneCouleur()) {
                valeurs.add(p.defaut);
            } else if (valeurs.isEmpty()) {
                int dernier = p.defaut == null ? p.crans : p.getCran(p.defaut);
                assertEquals(p.defaut, p.defaut == null ? null : p.getValeur(dernier), "un cran est au défaut");
                for (int cran = 0; cran <= dernier; cran++) {
                    valeurs.add(p.getValeur(cran));
                }
            }
            for (String valeur : valeurs) {
                Section section = new SectionLue(variante.getSection(), p.cle, valeur);
                variante.installer(section, new Modele());
                section.verifierCles();
            }
        }
    }
}
