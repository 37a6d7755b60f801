package lancer.correction.depot;

import java.io.IOException;
import java.io.InputStream;

/** Un fichier, un dossier ou un lien de ce qui est rendu, du disque ou d'une archive. */
abstract class Entree {

    /** Depuis le dossier, ou dans l'archive ; celui d'un dossier finit par « / ». */
    final String chemin;
    final boolean lien;
    /** En octets, telle qu'elle est annoncée ; négative si elle ne l'est pas. */
    final long taille;

    Entree(String chemin, boolean lien, long taille) {
        this.chemin = chemin;
        this.lien = lien;
        this.taille = taille;
    }

    abstract InputStream ouvrir() throws IOException;

    /** Le premier nom de son chemin. */
    String premier() {
        return chemin.replaceFirst("(?s)/.*", "");
    }

    boolean estDossier() {
        return chemin.endsWith("/");
    }
}
