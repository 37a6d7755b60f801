import java.io.IOException;
import java.io.RandomAccessFile;

/** Tient un fichier ouvert, comme une visionneuse sous Windows, jusqu'à la fin de l'entrée standard. */
public final class Tenir {

    private Tenir() {
    }

    public static void main(String[] args) throws IOException {
        try (RandomAccessFile tenu = new RandomAccessFile(args[0], "r")) {
            System.out.println("tenu : " + tenu.length() + " octets");
            while (System.in.read() >= 0) {
                // encore
            }
        }
    }
}
