package lancer.scene;

import java.io.IOException;
import java.nio.file.Files;
import lancer.SceneFautive;
import lancer.systeme.Ecriture;
import lancer.systeme.ErreurSysteme;

/** L'écriture d'une scène changée : les clés changées seules, dans son fichier tel qu'il est, ou dans un autre. */
public final class EcritureScene {

    private EcritureScene() {
    }

    /**
     * Écrit dans le fichier de cette scène ce qui y diffère d'elle. Ce que d'autres y ont changé reste.
     *
     * @param avant la scène que contenait le fichier
     * @param connu le texte qu'il contenait
     * @return le texte qu'il contient
     * @throws SceneFautive si le fichier n'est plus une scène, ou plus la même
     * @throws lancer.systeme.Echec s'il ne peut être écrit
     */
    public static TexteScene remplacer(SceneLue voulue, SceneLue avant, TexteScene connu) {
        TexteScene present = relire(voulue);
        boolean autre = !present.getVersion().equals(connu.getVersion());
        if (autre) {
            LecteurScene.verifier(voulue.nom, voulue.chemin, present);
        }
        TexteScene ecrit = voulue.ecrireDans(present, avant);
        if (autre) {
            LecteurScene.verifier(voulue.nom, voulue.chemin, ecrit);
        }
        ecrire(ecrit, voulue.chemin.toString());
        return ecrit;
    }

    private static TexteScene relire(SceneLue lue) {
        try {
            return new TexteScene(Files.readAllBytes(lue.chemin));
        } catch (IOException e) {
            String chemin = lue.chemin.toString();
            throw LecteurScene.inutilisable(chemin, "lecture impossible (" + ErreurSysteme.raison(e, chemin) + ")", e);
        }
    }

    /** Écrit ce texte dans ce fichier, qu'il remplace. @throws lancer.systeme.Echec s'il ne peut être écrit */
    public static void ecrire(TexteScene texte, String fichier) {
        new Ecriture<TexteScene>(fichier, (celui, sortie) -> sortie.write(celui.getOctets())).remplacer(texte);
    }
}
