package lancer.correction.jugement;

import java.util.List;

/** Ce qu'on vérifie des variantes. */
public final class Variantes {

    /** Un critère d'une variante. */
    static final class Critere {

        final String variante;
        final String titreVariante;
        final String nom;
        final String titre;

        Critere(String variante, String titreVariante, String nom, String titre) {
            this.variante = variante;
            this.titreVariante = titreVariante;
            this.nom = nom;
            this.titre = titre;
        }

        String id() {
            return variante + "." + nom;
        }
    }

    static final List<Critere> CRITERES = List.of(
            new Critere("brume", "Extension : brume", "bornee", "k reste entre 0 et 1"),
            new Critere("brume", "Extension : brume", "croissante", "k croît avec la distance"),
            new Critere("antialias", "Extension : anticrénelage", "bords", "les bords sont la moyenne de sous-pixels"),
            new Critere("blinn", "Extension : reflet de Blinn", "etalement", "le reflet est plus étalé que celui de Phong"));

    private Variantes() {
    }
}
