package lancer.essai;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import lancer.contrat.Modele;
import lancer.contrat.Parametre;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.scene.SectionLue;
import org.junit.jupiter.api.io.TempDir;

/** De quoi essayer une variante par la ligne de commande : sa section, ses images de référence et ses refus. */
public abstract class EssaiVariante {

    @TempDir
    protected Path dossier;

    protected Path scene(String... lignes) throws IOException {
        return Essai.scene(dossier.resolve("scene.ini"), lignes);
    }

    /** Le texte de cette scène de référence. */
    protected static String ini(String nom) throws IOException {
        return Essai.ressource(Essai.class, "/reference/" + nom);
    }

    /** De cette scène et de cette section, le programme donne l'image de référence. */
    protected void verifierReference(String pfm, String ini, String... section) throws IOException {
        Path scene = scene(ini(ini), String.join("\n", section));
        Essai.dessiner(dossier, scene, "--taille", "120x90", "--seuil", "0");
        Essai.verifierReference(pfm, dossier);
    }

    /** Cette scène est refusée, pour ce qu'en dit la fin de la ligne. */
    protected void verifierRefus(String dit, String... lignes) throws IOException {
        Path scene = scene(lignes);
        Essai.executer("--lineaire", dossier.resolve("image.pfm").toString(), scene.toString()).exigerRefus(2, scene + ", " + dit);
    }

    /** La souris règle ces clés, et la section les accepte, du premier cran à leur valeur par défaut, ou chacun de leurs mots. */
    protected static void verifierParametres(Variante variante, String... cles) {
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
