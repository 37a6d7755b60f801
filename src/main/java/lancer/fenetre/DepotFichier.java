package lancer.fenetre;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.util.List;
import javax.swing.TransferHandler;

/** Ouvre la scène dont on dépose le fichier sur la fenêtre. */
final class DepotFichier extends TransferHandler {

    private static final long serialVersionUID = 1;

    private final transient Fenetre fenetre;

    DepotFichier(Fenetre fenetre) {
        this.fenetre = fenetre;
    }

    @Override
    public boolean canImport(TransferSupport depot) {
        return depot.isDataFlavorSupported(DataFlavor.javaFileListFlavor);
    }

    @Override
    public boolean importData(TransferSupport depot) {
        if (!canImport(depot)) {
            return false;
        }
        try {
            List<?> fichiers = (List<?>) depot.getTransferable().getTransferData(DataFlavor.javaFileListFlavor);
            if (fichiers.size() != 1) {
                fenetre.dire("une scène à la fois : " + fichiers.size() + " fichiers déposés");
                return false;
            }
            fenetre.ouvrirScene((File) fichiers.get(0));
            return true;
        } catch (UnsupportedFlavorException | IOException e) {
            return false;
        }
    }
}
