package lancer.mesures.vitesse;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.zip.CRC32;
import lancer.mesures.Circonstances;

/** De quoi reconnaître une mesure interrompue que l'on peut reprendre : même programme à l'octet, même machine, même Java. */
final class Empreinte {

    private Empreinte() {
    }

    /** Une ligne ; vide si le programme n'est pas un fichier que l'on puisse lire, et rien ne se reprend alors. */
    static String de(Circonstances c) throws IOException {
        Path jar = Paths.get(System.getProperty("java.class.path"));
        if (!Files.isRegularFile(jar)) {
            return "";
        }
        CRC32 somme = new CRC32();
        byte[] tampon = new byte[1 << 16];
        try (InputStream entree = Files.newInputStream(jar)) {
            for (int lus = entree.read(tampon); lus > 0; lus = entree.read(tampon)) {
                somme.update(tampon, 0, lus);
            }
        }
        return Long.toHexString(somme.getValue()) + " " + c.machine + " " + c.coeurs + " " + c.jvm;
    }

    /** Vrai si ce fichier contient cette empreinte. */
    static boolean est(Path fichier, String empreinte) throws IOException {
        return !empreinte.isEmpty() && Files.exists(fichier)
                && new String(Files.readAllBytes(fichier), StandardCharsets.UTF_8).equals(empreinte);
    }
}
