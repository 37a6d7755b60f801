package lancer.fils;

import lancer.texte.Texte;

/** Un calcul qu'exécute un fil et qu'observe un autre fil. */
public interface Calcul {

    /** Noms des classes du programme qui n'appartiennent ni au cours, ni à une variante, ni à une forme. */
    String DU_PROGRAMME = "(lancer\\.(rapide|scene|dessin|fils|texte|fenetre)|org\\.ini4j)\\..*";

    /** Repère de ce qui est calculé, par exemple le rang d'un pixel. */
    default long getLieu() {
        return 0;
    }

    /**
     * Un nombre qui change tant que le calcul avance. Par défaut, il change tant que la première classe de la pile,
     * hors celles de Java, n'est ni du cours, ni d'une forme, ni d'une variante.
     */
    default long getProgres(Thread fil) {
        for (StackTraceElement pas : fil.getStackTrace()) {
            if (pas.getClassName().matches(Texte.HORS_DE_JAVA)) {
                return pas.getClassName().matches(DU_PROGRAMME) ? System.nanoTime() : 0;
            }
        }
        return System.nanoTime();
    }

    /** L'échec à lever si ce calcul retient son fil. */
    default RuntimeException nommer(Retenu cause) {
        return cause;
    }

    /** Méthode appelée une fois si ce calcul est lent pendant que d'autres fils avancent. */
    default void ralentir(Retenu cause) {
    }
}
