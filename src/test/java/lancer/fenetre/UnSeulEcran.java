package lancer.fenetre;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardOpenOption;
import org.junit.jupiter.api.extension.AfterAllCallback;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.ExtensionContext;

/**
 * Les tests se partagent entre deux machines virtuelles, qui n'ont qu'un écran, où une fenêtre de l'une prendrait le clavier de
 * l'autre : celle qui ouvre des fenêtres garde un fichier pour elle, et l'autre attend.
 */
final class UnSeulEcran implements BeforeAllCallback, AfterAllCallback {

    private static final Path GARDE = Paths.get("target", "ecran");

    private FileChannel garde;

    @Override
    public void beforeAll(ExtensionContext classe) throws IOException {
        if (Boolean.getBoolean("fenetre.exigee")) {
            garde = FileChannel.open(GARDE, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
            garde.lock();
        }
    }

    @Override
    public void afterAll(ExtensionContext classe) throws IOException {
        if (garde != null) {
            garde.close();
        }
    }
}
