package lancer.fils;

import lancer.texte.Texte;

/** Un calcul que fait un fil, tel qu'un autre fil le voit. */
public interface Calcul {

    /** Noms des classes du programme qui ne sont ni au cours, ni à une variante, ni à une forme. */
    String DU_PROGRAMME = "(lancer\\.(rapide|scene|dessin|fils|texte|fenetre)|org\\.ini4j)\\..*";

    /** Ce qui se calcule : le rang d'un pixel, par exemple. */
    default long getLieu() {
        return 0;
    }

    /**
     * Un nombre qui change tant que ce calcul avance. Par défaut, il change tant que le haut de la pile est du
     * programme, et non d'une classe du cours, d'une forme ou d'une variante.
     */
    default long getProgres(Thread fil) {
        for (StackTraceElement pas : fil.getStackTrace()) {
            if (pas.getClassName().matches(Texte.HORS_DE_JAVA)) {
                return pas.getClassName().matches(DU_PROGRAMME) ? System.nanoTime() : 0;
            }
        }
        return System.nanoTime();
    }

    /** L'échec à dire de ce calcul, qui retient son fil. */
    default RuntimeException nommer(Retenu cause) {
        return cause;
    }

    /** Dit, une fois, que ce calcul est lent, alors que d'autres fils avancent. */
    default void ralentir(Retenu cause) {
    }
}
