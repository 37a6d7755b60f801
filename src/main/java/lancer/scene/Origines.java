package lancer.scene;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** Les objets et les lampes d'un fichier, dans son ordre, chacun avec sa section. */
public final class Origines {

    final List<Origine> lues = new ArrayList<>();
    /** Pour la fenêtre. */
    final LecteurSections lecteur;
    private final boolean avecTexte;

    /** Une chose et sa section : son nom, sa ligne et, pour la fenêtre, son texte, ou {@code null}. */
    static final class Origine {
        final Object chose;
        final String nom;
        final int ligne;
        final byte[] texte;

        Origine(Object chose, String nom, int ligne, byte[] texte) {
            this.chose = chose;
            this.nom = nom;
            this.ligne = ligne;
            this.texte = texte;
        }

        @Override
        public String toString() {
            return "[" + nom + "] ligne " + ligne;
        }
    }

    /** Celles d'une scène sans fichier. */
    public Origines() {
        this(null, false);
    }

    /** @param avecTexte vrai pour garder le texte des sections */
    Origines(LecteurSections lecteur, boolean avecTexte) {
        this.lecteur = lecteur;
        this.avecTexte = avecTexte;
    }

    void ajouter(Object chose, SectionLue section) {
        byte[] texte = avecTexte ? section.ecrire("\n").getBytes(StandardCharsets.UTF_8) : null;
        lues.add(new Origine(chose, section.nom, section.ligne, texte));
    }

    public int getNombre() {
        return lues.size();
    }

    public Object getChose(int rang) {
        return lues.get(rang).chose;
    }

    /** Le rang de cet objet ou de cette lampe dans le fichier ; −1 s'il n'en vient pas. */
    public int getRang(Object chose) {
        return IntStream.range(0, lues.size()).filter(k -> lues.get(k).chose == chose).findFirst().orElse(-1);
    }

    /** Nom de cette section ; si elle n'a que son type, sa ligne la situe. */
    public String getNom(int rang) {
        Origine lue = lues.get(rang);
        return lue.nom.indexOf(' ') < 0 ? lue.toString() : "[" + lue.nom + "]";
    }

    /** Texte de la forme {@code [Sphere ambre] ligne 52} ; {@code null} si cet objet ne vient pas d'un fichier. */
    public String de(Object chose) {
        int rang = getRang(chose);
        return rang < 0 ? null : lues.get(rang).toString();
    }

    /** La ligne de la section de cet objet ou de cette lampe, qui vient du fichier. */
    int getLigne(Object chose) {
        return lues.get(getRang(chose)).ligne;
    }
}
