package lancer.lecture;

import java.util.Arrays;
import java.util.Objects;
import lancer.Objet3D;
import lancer.SceneFautive;
import lancer.contrat.Forme;
import lancer.contrat.Section;
import lancer.texte.Texte;

/** Un type de section qui décrit un objet : la forme qui le lit, et toutes ses clés. */
final class TypeObjet {

    /** Les clés de la matière, que tout objet a. */
    private static final String[] MATIERE = {"Kd", "Ks", "Kr", "ns"};

    private final Forme forme;
    private final String nom;
    private final String[] cles;

    TypeObjet(Forme forme) {
        this.forme = forme;
        nom = forme.getSection();
        String classe = forme.getClass().getName();
        String[] siennes = Objects.requireNonNull(forme.getCles(), classe + ".getCles a rendu null");
        cles = Arrays.copyOf(siennes, siennes.length + MATIERE.length);
        System.arraycopy(MATIERE, 0, cles, siennes.length, MATIERE.length);
    }

    /** Le premier mot de ses sections. */
    String getNom() {
        return nom;
    }

    /** Les seules clés permises dans ses sections. */
    String[] getCles() {
        return cles;
    }

    /** L'objet que décrit cette section, encore sans matière. Une exception de la forme est une section refusée. */
    Objet3D lire(Section section) {
        try {
            Objet3D objet = forme.lire(section);
            if (objet == null || objet == forme) {
                throw new IllegalStateException("lire n'a pas rendu un objet neuf");
            }
            return objet;
        } catch (SceneFautive e) {
            throw e;
        } catch (RuntimeException e) {
            String dit = e.getMessage() != null ? e.getMessage() : e.toString();
            throw section.fautive(section.getLigne(), null, "section que " + forme.getClass().getName()
                    + " ne sait pas lire : " + Texte.cite(dit), "des valeurs qui lui conviennent");
        }
    }
}
