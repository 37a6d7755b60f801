package lancer.lecture;

import java.util.Arrays;
import java.util.Objects;
import java.util.regex.Pattern;
import lancer.Objet3D;
import lancer.SceneFautive;
import lancer.Sphere;
import lancer.contrat.Forme;
import lancer.contrat.Section;
import lancer.texte.Texte;

/** Un type de section qui décrit un objet : la forme qui le lit, et toutes ses clés. */
final class TypeObjet {

    /** Les clés de la matière, que tout objet a. */
    private static final String[] MATIERE = {"Kd", "Ks", "Kr", "ns"};

    /** La forme de la base : lue comme les autres, mais connue d'avance. */
    static final TypeObjet SPHERE = new TypeObjet(new Forme() {
        @Override
        public String getSection() {
            return "Sphere";
        }

        @Override
        public String[] getCles() {
            return new String[] {"centre", "rayon"};
        }

        @Override
        public Objet3D lire(Section valeurs) {
            return new Sphere(valeurs.point("centre"), valeurs.longueur("rayon"));
        }
    });

    private final Forme forme;
    private final String[] cles;

    TypeObjet(Forme forme) {
        this.forme = forme;
        String[] siennes = Objects.requireNonNull(forme.getCles(), forme.getClass().getName()
                + ".getCles a rendu null");
        cles = Arrays.copyOf(siennes, siennes.length + MATIERE.length);
        System.arraycopy(MATIERE, 0, cles, siennes.length, MATIERE.length);
    }

    /** Le premier mot de ses sections. */
    String getNom() {
        return forme.getSection();
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
            String classe = forme.getClass().getName();
            boolean refus = e.getMessage() != null
                    && (e instanceof IllegalArgumentException || e instanceof IllegalStateException);
            throw section.fautive(section.getLigne(), null, "section que " + classe + " ne sait pas lire : "
                    + (refus ? Texte.cite(e.getMessage()) : Texte.cause(e, Pattern.quote(classe) + ".*")),
                    "des valeurs qui lui conviennent");
        }
    }
}
