package lancer.essai;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
        assertEquals(List.of(cles), variante.getParametres().stream().map(p -> p.cle).collect(Collectors.toList()));
        for (Parametre p : variante.getParametres()) {
            List<String> valeurs = p.estUnTexte() ? List.of(p.defaut) : p.valeurs;
            int dernier = p.defaut == null || !p.estUnNombre() ? valeurs.size() - 1 : p.getRang(p.defaut);
            assertTrue(p.defaut == null || valeurs.contains(p.defaut), "une valeur est celle par défaut");
            for (String valeur : valeurs.subList(0, dernier + 1)) {
                Section section = new SectionLue(variante.getSection(), p.cle, valeur);
                variante.installer(section, new Modele.Construction());
                section.verifierCles();
            }
        }
    }
}
