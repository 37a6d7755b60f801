package lancer.correction.enfant;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.regex.Pattern;

/**
 * Messages entre le correcteur et une autre machine virtuelle. Chaque message a un numéro et une longueur, écrits avant lui : aucun texte
 * ne peut passer pour la fin d'un message.
 */
public final class Echange {

    /** Taille maximale d'une réponse ordinaire, en octets. */
    public static final int REPONSE_MAX = 1 << 16;
    /** Taille maximale d'une réponse qui contient une image ou des classes, en octets. */
    public static final int GROSSE_REPONSE_MAX = 8 << 20;

    /** Caractères qui commandent un terminal ou changent le sens d'écriture, moitiés de caractères ; ni tabulation, ni fin de ligne. */
    public static final Pattern NUISIBLES = Pattern.compile("[\\p{Cc}\\p{Cf}\\p{Cs}\\p{Zl}\\p{Zp}&&[^\n\t]]");

    private static final int TEXTE_MAX = 2000;
    private static final int LIGNES_MAX = 30;

    private Echange() {
    }

    /** Écriture d'un message. */
    public interface Redaction {
        void ecrire(DataOutputStream message) throws IOException;
    }

    public static byte[] message(Redaction redaction) throws IOException {
        ByteArrayOutputStream octets = new ByteArrayOutputStream();
        redaction.ecrire(new DataOutputStream(octets));
        return octets.toByteArray();
    }

    /** Envoie un message en une seule écriture. */
    public static void envoyer(OutputStream flux, int numero, byte[] message) throws IOException {
        flux.write(message(m -> {
            m.writeInt(numero);
            m.writeInt(message.length);
            m.write(message);
        }));
        flux.flush();
    }

    /** Traitement d'une demande, dont le résultat écrit la réponse. */
    public interface Traitement {
        Redaction traiter(DataInputStream demande) throws IOException;
    }

    /** Répond sans fin aux demandes de l'entrée standard, sur la sortie standard, où rien d'autre n'est plus écrit. */
    public static void servir(Traitement traitement) throws IOException {
        PrintStream sortie = System.out;
        System.setOut(System.err);
        DataInputStream demandes = new DataInputStream(System.in);
        while (true) {
            int numero = demandes.readInt();
            byte[] demande = demandes.readNBytes(demandes.readInt());
            envoyer(sortie, numero, message(traitement.traiter(new DataInputStream(new ByteArrayInputStream(demande)))));
        }
    }

    public static void ecrireTexte(DataOutputStream message, String texte) throws IOException {
        byte[] octets = texte.getBytes(StandardCharsets.UTF_8);
        message.writeInt(octets.length);
        message.write(octets);
    }

    public static String lireTexte(DataInputStream message) throws IOException {
        return new String(lireOctets(message), StandardCharsets.UTF_8);
    }

    /** @throws EOFException si le message est plus court que la longueur annoncée ; aucune mémoire n'est réservée avant */
    public static byte[] lireOctets(DataInputStream message) throws IOException {
        int longueur = message.readInt();
        if (longueur < 0 || longueur > message.available()) {
            throw new EOFException();
        }
        return message.readNBytes(longueur);
    }

    /** Écrit des fichiers, ou des classes, par leur nom. */
    public static void ecrireTout(DataOutputStream message, Map<String, byte[]> tout) throws IOException {
        message.writeInt(tout.size());
        for (Map.Entry<String, byte[]> un : tout.entrySet()) {
            ecrireTexte(message, un.getKey());
            message.writeInt(un.getValue().length);
            message.write(un.getValue());
        }
    }

    public static Map<String, byte[]> lireTout(DataInputStream message) throws IOException {
        Map<String, byte[]> tout = new LinkedHashMap<>();
        for (int reste = message.readInt(); reste > 0; reste--) {
            String nom = lireTexte(message);
            tout.put(nom, lireOctets(message));
        }
        return tout;
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

    /** Écrit un argument, ou un résultat de méthode. @param nommer désigne un objet d'une autre classe */
    public static void ecrireValeur(DataOutputStream message, Object valeur, Function<Object, Objet> nommer) throws IOException {
        if (valeur == null) {
            message.writeChar('n');
        } else if (valeur instanceof Boolean) {
            message.writeChar('b');
            message.writeBoolean((Boolean) valeur);
        } else if (valeur instanceof Integer) {
            message.writeChar('i');
            message.writeInt((Integer) valeur);
        } else if (valeur instanceof Number) {
            message.writeChar('d');
            message.writeDouble(((Number) valeur).doubleValue());
        } else if (valeur instanceof CharSequence) {
            message.writeChar('s');
            ecrireTexte(message, protege(valeur.toString()));
        } else if (valeur instanceof List) {
            message.writeChar('l');
            message.writeInt(((List<?>) valeur).size());
            for (Object element : (List<?>) valeur) {
                ecrireValeur(message, element, nommer);
            }
        } else {
            Objet objet = nommer.apply(valeur);
            message.writeChar('o');
            message.writeInt(objet.numero);
            ecrireTexte(message, objet.classe);
        }
    }

    /** @param trouver rend l'objet désigné */
    public static Object lireValeur(DataInputStream message, Function<Objet, Object> trouver) throws IOException {
        switch (message.readChar()) {
            case 'n':
                return null;
            case 'b':
                return message.readBoolean();
            case 'i':
                return message.readInt();
            case 'd':
                return message.readDouble();
            case 's':
                return protege(lireTexte(message));
            case 'l':
                List<Object> liste = new ArrayList<>();
                for (int reste = message.readInt(); reste > 0; reste--) {
                    liste.add(lireValeur(message, trouver));
                }
                return liste;
            case 'o':
                return trouver.apply(new Objet(message.readInt(), protege(lireTexte(message))));
            default:
                throw new IOException();
        }
    }

    /** Un texte sans caractère nuisible, en une ligne de longueur limitée. */
    public static String protege(String texte) {
        return protege(texte, TEXTE_MAX);
    }

    /** Le même, d'au plus {@code max} caractères, puis « … » s'il est coupé. */
    public static String protege(String texte, int max) {
        String court = texte.length() > max ? couper(texte, max) + "…" : texte;
        return NUISIBLES.matcher(court).replaceAll(" ").replaceAll("\\s+", " ").trim();
    }

    /** Protège un texte qu'un tableur prendrait pour une formule, en tête ou après « ; », qui peut séparer les cases. */
    public static String sansFormule(String texte) {
        return protege(texte, Integer.MAX_VALUE).replaceAll("(^|;)([\\s\"']*)(?=[=+@-])", "$1$2'");
    }

    /** Le début d'un texte, d'au plus {@code max} caractères ; aucun n'est coupé en deux. */
    public static String couper(String texte, int max) {
        return texte.length() <= max ? texte : texte.substring(0, Character.isHighSurrogate(texte.charAt(max - 1)) ? max - 1 : max);
    }

    /** Limite une liste à quelques lignes de longueur limitée, pour une page. */
    public static void abreger(List<String> liste) {
        liste.replaceAll(Echange::protege);
        if (liste.size() > LIGNES_MAX) {
            liste.subList(LIGNES_MAX, liste.size()).clear();
            liste.add("…");
        }
    }
}
