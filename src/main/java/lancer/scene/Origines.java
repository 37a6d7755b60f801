package lancer.scene;

import java.util.ArrayList;
import java.util.List;

/** Les objets et les lampes d'un fichier, dans son ordre, chacun avec le nom et la ligne de sa section. */
public final class Origines {

    private final List<Origine> lues = new ArrayList<>();

    /** Une chose, le nom de sa section et sa ligne. */
    private static final class Origine {
        final Object chose;
        final String nom;
        final int ligne;

        Origine(Object chose, String nom, int ligne) {
            this.chose = chose;
            this.nom = nom;
            this.ligne = ligne;
        }
    }

    void ajouter(Object chose, SectionLue section) {
        lues.add(new Origine(chose, section.nom, section.ligne));
    }

    /** Les mêmes, où une chose en remplace une autre. */
    Origines remplacer(Object ancienne, Object nouvelle) {
        Origines faites = new Origines();
        lues.forEach(lue -> faites.lues.add(
                lue.chose == ancienne ? new Origine(nouvelle, lue.nom, lue.ligne) : lue));
        return faites;
    }

    /** L'origine de cet objet ou de cette lampe ; {@code null} s'il ne vient pas du fichier. */
    private Origine trouver(Object chose) {
        return lues.stream().filter(lue -> lue.chose == chose).findFirst().orElse(null);
    }

    /** Texte de la forme {@code [Sphere ambre] ligne 52} ; {@code null} si cet objet ne vient pas d'un fichier. */
    public String de(Object chose) {
        Origine origine = trouver(chose);
        return origine == null ? null : "[" + origine.nom + "] ligne " + origine.ligne;
    }

    /** La ligne de la section de cet objet ou de cette lampe, qui vient du fichier. */
    int getLigne(Object chose) {
        return trouver(chose).ligne;
    }
}
