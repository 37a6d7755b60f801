package lancer.commande;

import lancer.texte.Texte;

/** Les étapes du cours, dans son ordre : chacune ajoute à la précédente ; la dernière est le programme entier. */
public enum Etape {
    LAMBERT, PHONG, OMBRES, REFLETS;

    /** Le nom, tel qu'une option l'écrit. */
    @Override
    public String toString() {
        return Texte.minuscules(name());
    }
}
