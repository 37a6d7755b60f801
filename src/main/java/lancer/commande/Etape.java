package lancer.commande;

import lancer.texte.Texte;

/** Les étapes du cours, dans l'ordre. Chacune ajoute à la précédente ; la dernière est le programme entier. */
public enum Etape {
    LAMBERT, PHONG, OMBRES, REFLETS;

    @Override
    public String toString() {
        return Texte.minuscules(name());
    }
}
