package lancer;

/** Interroge les variantes d'un étudiant. */
public final class SondeVariantes {

    private SondeVariantes() {
    }
}
