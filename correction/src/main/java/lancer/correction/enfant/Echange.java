package lancer.correction.enfant;

/** Ce que le correcteur et la machine virtuelle où tourne un rendu se disent, une ligne à la fois. */
public final class Echange {

    /** Ce par quoi commence une réponse ; une autre ligne n'en est pas une. Ce n'est pas un secret. */
    public static final String REPONSE = "réponse\t";

    private static final int LONGUEUR_MAX = 2000;

    private Echange() {
    }

    /** Un texte en une ligne, sans tabulation, et pas trop long. */
    public static String protege(String texte) {
        String court = texte.length() > LONGUEUR_MAX ? texte.substring(0, LONGUEUR_MAX) + "…" : texte;
        return court.replaceAll("[\\p{Cntrl}\\s]+", " ").trim();
    }
}
