package lancer.mesures.juge;

/** Pourquoi un pixel n'a pas la couleur que lui donne le juge, alors qu'un rayon voisin du nôtre la donne. */
enum Cause {

    /** Les deux rayons ne rencontrent pas d'abord le même objet. */
    SILHOUETTE("silhouette"),

    /** Le même objet d'abord, mais non les mêmes lampes : une ombre, ou la limite de l'ombre propre, passe entre eux. */
    OMBRE("ombre"),

    /** Leurs reflets ne rencontrent pas les mêmes objets. */
    SILHOUETTE_REFLETEE("silhouette reflétée"),

    /** Les mêmes objets, mais dans un reflet une ombre passe entre eux. */
    OMBRE_REFLETEE("ombre reflétée"),

    /** Ils ne voient pas le même côté de l'horizon. */
    HORIZON("horizon"),

    /** Les mêmes objets et les mêmes lampes : la couleur varie très vite ici, dans un éclat ou un reflet de reflet. */
    PENTE("pente"),

    /** Aucun rayon voisin ne donne la couleur du juge. */
    INEXPLIQUE("inexpliqué");

    final String nom;

    Cause(String nom) {
        this.nom = nom;
    }
}
