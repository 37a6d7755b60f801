package lancer.essai;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.stream.Collectors;
import lancer.contrat.Modele;
import lancer.contrat.Parametre;
import lancer.contrat.Section;
import lancer.contrat.Variante;

/** Ce qu'une variante laisse régler à la souris. */
public final class EssaiParametres {

    private EssaiParametres() {
    }

    /** Ce sont ces clés, et sa section les accepte, du premier cran à leur valeur par défaut. */
    public static void verifier(Variante variante, String... cles) {
        assertEquals(Arrays.asList(cles), variante.getParametres().stream().map(Parametre::getCle).collect(Collectors.toList()));
        for (Parametre p : variante.getParametres()) {
            int dernier = p.getCrans();
            if (p.getDefaut() != null) {
                dernier = p.getCran(p.getDefaut());
                assertEquals(p.getDefaut(), p.getValeur(dernier), "un cran est au défaut");
            }
            for (int cran = 0; cran <= dernier; cran++) {
                Section section = Section.reglage(variante.getSection(), p.getCle(), p.getValeur(cran));
                variante.installer(section, new Modele());
                section.verifierCles();
            }
        }
    }
}
