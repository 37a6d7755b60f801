package lancer.correction.enfant;

import java.io.BufferedInputStream;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;

/**
 * Messages entre le correcteur et une autre machine virtuelle. Chaque message a un numéro et une longueur, écrits avant lui : aucun texte
 * ne peut passer pour la fin d'un message.
 */
public final class Echange {

    /** Taille maximale d'une réponse ordinaire, en octets. */
    public static final int REPONSE_MAX = 1 << 16;
    /** Taille maximale d'une réponse qui contient une image, puis d'une réponse du compilateur, en octets. */
    public static final int IMAGE_MAX = 1 << 20;
    public static final int COMPILATION_MAX = 16 << 20;
    /** Nombre maximal de listes l'une dans l'autre. */
    private static final int PROFONDEUR_MAX = 20;

    private Echange() {
    }

    /** Envoie un message en une seule écriture. */
    public static void envoyer(OutputStream flux, int numero, byte[] message) throws IOException {
        flux.write(ByteBuffer.allocate(2 * Integer.BYTES + message.length).putInt(numero).putInt(message.length).put(message).array());
        flux.flush();
    }

    /** Traitement d'une demande, qui rend la réponse. */
    public interface Traitement {
        byte[] traiter(DataInputStream demande) throws IOException;
    }

    /** Répond sans fin aux demandes de cette entrée. La sortie des réponses ne reçoit plus rien d'autre. */
    public static void servir(InputStream entree, OutputStream reponses, Traitement traitement) throws IOException {
        System.setOut(System.err);
        DataInputStream demandes = new DataInputStream(new BufferedInputStream(entree));
        while (true) {
            int numero = demandes.readInt();
            byte[] demande = demandes.readNBytes(demandes.readInt());
            envoyer(reponses, numero, traitement.traiter(new DataInputStream(new ByteArrayInputStream(demande))));
        }
    }

    private static void ecrireOctets(DataOutputStream message, byte[] octets) throws IOException {
        message.writeInt(octets.length);
        message.write(octets);
    }

    /** @throws EOFException si le message est plus court que la longueur annoncée ; aucune mémoire n'est réservée avant */
    private static byte[] lireOctets(DataInputStream message) throws IOException {
        int longueur = message.readInt();
        if (longueur < 0 || longueur > message.available()) {
            throw new EOFException();
        }
        return message.readNBytes(longueur);
    }

    private static void ecrireTexte(DataOutputStream message, String texte) throws IOException {
        ecrireOctets(message, Texte.protege(texte).getBytes(StandardCharsets.UTF_8));
    }

    private static String lireTexte(DataInputStream message) throws IOException {
        return Texte.protege(new String(lireOctets(message), StandardCharsets.UTF_8));
    }

    /** Désignation d'un objet du rendu : son numéro et sa classe. */
    public static class Objet {

        public final int numero;
        public final String classe;

        public Objet(int numero, String classe) {
            this.numero = numero;
            this.classe = classe;
        }
    }

    /**
     * Écrit une valeur : rien, un booléen, un nombre, un texte d'une ligne, des octets, une liste, ou un objet du rendu.
     *
     * @param nommer désigne un objet d'une autre classe
     */
    public static byte[] message(Object valeur, Function<Object, Objet> nommer) {
        ByteArrayOutputStream octets = new ByteArrayOutputStream();
        try {
            ecrire(new DataOutputStream(octets), valeur, nommer);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return octets.toByteArray();
    }

    private static void ecrire(DataOutputStream message, Object valeur, Function<Object, Objet> nommer) throws IOException {
        if (valeur == null) {
            message.writeByte('n');
        } else if (valeur instanceof Boolean) {
            message.writeByte('b');
            message.writeBoolean((Boolean) valeur);
        } else if (valeur instanceof Integer) {
            message.writeByte('i');
            message.writeInt((Integer) valeur);
        } else if (valeur instanceof Number) {
            message.writeByte('d');
            message.writeDouble(((Number) valeur).doubleValue());
        } else if (valeur instanceof CharSequence) {
            message.writeByte('t');
            ecrireTexte(message, valeur.toString());
        } else if (valeur instanceof byte[]) {
            message.writeByte('x');
            ecrireOctets(message, (byte[]) valeur);
        } else if (valeur instanceof List) {
            message.writeByte('l');
            message.writeInt(((List<?>) valeur).size());
            for (Object element : (List<?>) valeur) {
                ecrire(message, element, nommer);
            }
        } else {
            Objet objet = nommer.apply(valeur);
            message.writeByte('o');
            message.writeInt(objet.numero);
            ecrireTexte(message, objet.classe);
        }
    }

    /** Lit une valeur. @param trouver rend l'objet désigné ; @throws IOException si ce n'en est pas une */
    public static Object lire(DataInputStream message, Function<Objet, Object> trouver) throws IOException {
        return lire(message, trouver, PROFONDEUR_MAX);
    }

    private static Object lire(DataInputStream message, Function<Objet, Object> trouver, int profondeur) throws IOException {
        if (profondeur < 0) {
            throw new IOException();
        }
        switch (message.readByte()) {
            case 'n':
                return null;
            case 'b':
                return message.readBoolean();
            case 'i':
                return message.readInt();
            case 'd':
                return message.readDouble();
            case 't':
                return lireTexte(message);
            case 'x':
                return lireOctets(message);
            case 'l':
                List<Object> liste = new ArrayList<>();
                for (int reste = message.readInt(); reste > 0; reste--) {
                    liste.add(lire(message, trouver, profondeur - 1));
                }
                return liste;
            case 'o':
                return trouver.apply(new Objet(message.readInt(), lireTexte(message)));
            default:
                throw new IOException();
        }
    }
}
