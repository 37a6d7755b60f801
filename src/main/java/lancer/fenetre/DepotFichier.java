package lancer.fenetre;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.TransferHandler;

/** Ouvre la scène dont on dépose le fichier sur la fenêtre. */
final class DepotFichier extends TransferHandler {

    private static final long serialVersionUID = 1;

    private final transient Consumer<File> ouvrir;
    private final transient Consumer<String> dire;

    DepotFichier(Consumer<File> ouvrir, Consumer<String> dire) {
        this.ouvrir = ouvrir;
        this.dire = dire;
    }

    @Override
    public boolean canImport(TransferSupport depot) {
        return depot.isDataFlavorSupported(DataFlavor.javaFileListFlavor);
    }

    @Override
    public boolean importData(TransferSupport depot) {
        try {
            List<?> fichiers = (List<?>) depot.getTransferable().getTransferData(DataFlavor.javaFileListFlavor);
            if (fichiers.size() != 1) {
                dire.accept("une scène à la fois : " + fichiers.size() + " fichiers déposés");
                return false;
            }
            ouvrir.accept((File) fichiers.get(0));
            return true;
        } catch (UnsupportedFlavorException | IOException e) {
            return false;
        }
    }
}
