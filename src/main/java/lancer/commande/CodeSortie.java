package lancer.commande;

/** Les statuts de sortie du programme. Après Ctrl+C, la machine virtuelle rend 130. */
public final class CodeSortie {

    /** Tout est fait. */
    public static final int FAIT = 0;

    /** La machine n'a pas pu : disque plein, sortie impossible à écrire, mémoire épuisée, pas d'écran. */
    public static final int PANNE = 1;

    /** La demande était fausse : option, valeur, scène. */
    public static final int DEMANDE = 2;

    private CodeSortie() {
    }
}
