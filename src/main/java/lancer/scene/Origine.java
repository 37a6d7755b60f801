package lancer.scene;

/** Origine d'un objet ou d'une lampe d'un fichier : le nom d'une section, et sa ligne. */
public final class Origine {

    final String nom;
    final int ligne;

    Origine(String nom, int ligne) {
        this.nom = nom;
        this.ligne = ligne;
    }

    /** Texte de la forme {@code [Sphere ambre] ligne 52}. */
    @Override
    public String toString() {
        return "[" + nom + "] ligne " + ligne;
    }
}
