package lancer.correction.jugement;

import java.io.IOException;
import java.io.InputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.OutputStream;
import java.io.Serializable;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;

/** Ce qu'on a déjà jugé, d'une fois à l'autre : un fichier chacun, dans notre dossier de travail. */
final class Souvenirs {

    private Souvenirs() {
    }

    /** @return {@code null} s'il n'y en a pas, ou s'il est d'une autre version */
    static Object relire(Path souvenir) {
        try (InputStream flux = Files.newInputStream(souvenir);
                ObjectInputStream objets = new ObjectInputStream(flux)) {
            return objets.readObject();
        } catch (IOException | ClassNotFoundException | RuntimeException e) {
            return null;
        }
    }

    static void ecrire(Path souvenir, Serializable valeur) throws IOException {
        // deux rendus identiques peuvent s'écrire en même temps
        Path neuf = Files.createTempFile(souvenir.getParent(), "neuf", null);
        try (OutputStream flux = Files.newOutputStream(neuf);
                ObjectOutputStream objets = new ObjectOutputStream(flux)) {
            objets.writeObject(valeur);
        }
        Files.move(neuf, souvenir, StandardCopyOption.REPLACE_EXISTING);
    }
}
