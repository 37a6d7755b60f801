package lancer.fenetre;

import java.awt.Image;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.datatransfer.UnsupportedFlavorException;

/** Une image dans le presse-papiers. */
final class ImageCopiee implements Transferable {

    private final Image image;

    ImageCopiee(Image image) {
        this.image = image;
    }

    @Override
    public DataFlavor[] getTransferDataFlavors() {
        return new DataFlavor[] {DataFlavor.imageFlavor};
    }

    @Override
    public boolean isDataFlavorSupported(DataFlavor sorte) {
        return DataFlavor.imageFlavor.equals(sorte);
    }

    @Override
    public Object getTransferData(DataFlavor sorte) throws UnsupportedFlavorException {
        if (!isDataFlavorSupported(sorte)) {
            throw new UnsupportedFlavorException(sorte);
        }
        return image;
    }
}
