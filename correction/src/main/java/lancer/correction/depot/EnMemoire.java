package lancer.correction.depot;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.net.URI;
import javax.tools.SimpleJavaFileObject;

/** Une source à lire, ou une classe à écrire, que le compilateur tient en mémoire. */
final class EnMemoire extends SimpleJavaFileObject {

    /** Le nom du fichier, avec des « / » entre les paquets. */
    final String nom;
    private final String texte;
    private final ByteArrayOutputStream ecrit = new ByteArrayOutputStream();

    /** @param texte {@code null} pour une classe */
    EnMemoire(String nom, String texte) {
        super(URI.create("memoire:///" + nom), texte == null ? Kind.CLASS : Kind.SOURCE);
        this.nom = nom;
        this.texte = texte;
    }

    @Override
    public CharSequence getCharContent(boolean tel) {
        return texte;
    }

    @Override
    public OutputStream openOutputStream() {
        return ecrit;
    }

    byte[] octets() {
        return ecrit.toByteArray();
    }
}
