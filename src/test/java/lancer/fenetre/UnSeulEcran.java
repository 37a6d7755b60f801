package lancer.fenetre;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import lancer.essai.Essai;
import org.junit.jupiter.api.extension.AfterAllCallback;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.ExtensionContext;

/**
 * Les tests se partagent entre plusieurs machines virtuelles, qui n'ont qu'un écran, où une fenêtre de l'une prendrait le clavier
 * d'une autre : celle qui ouvre des fenêtres garde un fichier pour elle, et les autres attendent.
 */
final class UnSeulEcran implements BeforeAllCallback, AfterAllCallback {

    /** À côté de cette classe, donc le même pour tous les modules, dont les tests vont ensemble. */
    private static final Path GARDE = Essai.origine(UnSeulEcran.class).resolveSibling("ecran");

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
