package lancer.essai;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;

/** De quoi essayer une variante par la ligne de commande : sa section, ses images de référence et ses refus. */
public abstract class EssaiVariante {

    @TempDir
    protected Path dossier;

    protected Path scene(String... lignes) throws IOException {
        return Essai.scene(dossier.resolve("scene.ini"), lignes);
    }

    /** Le texte de cette scène de référence. */
    protected static String ini(String nom) throws IOException {
        return Essai.ressource(Essai.class, "/reference/" + nom);
    }

    /** De cette scène et de cette section, le programme donne l'image de référence. */
    protected void verifierReference(String pfm, String ini, String... section) throws IOException {
        Path scene = scene(ini(ini), String.join("\n", section));
        Essai.dessiner(dossier, scene, "--taille", "120x90", "--seuil", "0");
        Essai.verifierReference(pfm, dossier);
    }

    /** Cette scène est refusée, pour ce qu'en dit la fin de la ligne. */
    protected void verifierRefus(String dit, String... lignes) throws IOException {
        Path scene = scene(lignes);
        Essai.executer("--lineaire", dossier.resolve("image.pfm").toString(), scene.toString()).exigerRefus(2, scene + ", " + dit);
    }
}
