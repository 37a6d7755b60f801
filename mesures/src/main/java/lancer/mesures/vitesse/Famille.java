package lancer.mesures.vitesse;

import java.util.Locale;

/** Ce qui se compare : dans une famille, même scène, même vérité. */
enum Famille {

    /** La vérité elle-même : ce qu'elle a coûté, et ce qui lui manque encore. */
    VERITE,

    /** Combien de rayons par pixel, et où. */
    ECHANTILLONNAGE,

    /** Jusqu'où suivre les reflets. */
    REFLETS,

    /** Phong ou Blinn : deux modèles, aucun n'est l'erreur de l'autre. */
    MODELE,

    /** Ce que coûte chaque chose qu'une scène peut demander. */
    DEMANDES,

    /** De une à un million de sphères. */
    SPHERES;

    /** Son nom dans le CSV. */
    String nom() {
        return name().toLowerCase(Locale.ROOT);
    }
}
