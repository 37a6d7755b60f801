package lancer.rapide;

/** La liste d'enveloppes que lit une question : leurs rangs, la place du suivant, et celle de la fin. */
final class Liste {

    int[] rangs;
    int place;
    int fin;

    /** Nombre d'enveloppes, de cubes et de nœuds examinés depuis que la question est posée. */
    int examens;

    /** Donne ces rangs à lire, de la place {@code debut} à la place {@code apres}, qui n'en est pas. */
    void donner(int[] tableau, int debut, int apres) {
        rangs = tableau;
        place = debut;
        fin = apres;
    }
}
