package lancer.fenetre;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import lancer.commande.CodeSortie;
import lancer.commande.Echec;

/** L'écran, s'il y en a un. */
final class Ecran {

    private Ecran() {
    }

    /** @throws Echec s'il n'y a pas d'écran où ouvrir une fenêtre */
    static void exiger() {
        boolean present;
        try {
            present = !GraphicsEnvironment.isHeadless()
                    && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
        } catch (HeadlessException | AWTError | LinkageError e) {
            // un DISPLAY sans serveur derrière, ou un Java sans ses bibliothèques d'écran
            present = false;
        }
        if (!present) {
            throw new Echec(CodeSortie.PANNE,
                    "pas d'écran pour ouvrir une fenêtre ; attendu : un écran, ou --image FICHIER.png");
        }
    }
}
