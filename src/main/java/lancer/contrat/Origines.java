package lancer.contrat;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * D'où vient chaque objet et chaque lampe : le nom de sa section, et sa ligne. De chaque nom n'est gardé que ce qu'il
 * n'a pas en commun avec celui d'avant ; s'ils ne se ressemblent pas, les lignes seules : jamais plus de seize octets
 * par objet, un million de boules en ont cinq.
 */
public final class Origines {

    private static final int OCTETS_PAR_NOM = 8;
    /** Quelques noms longs ont toujours leur place. */
    private static final int OCTETS_OFFERTS = 1 << 14;

    private final List<Object> choses = new ArrayList<>();
    private byte[] octets = new byte[64];
    private int taille;
    private byte[] nomDAvant = {};
    private int ligneDAvant;

    /** @param ligne celle des crochets, qui ne décroît pas */
    public void ajouter(Object chose, String nom, int ligne) {
        choses.add(chose);
        byte[] complet = nom.getBytes(StandardCharsets.UTF_8);
        if (taille + complet.length > OCTETS_OFFERTS + OCTETS_PAR_NOM * choses.size()) {
            complet = new byte[0];
        }
        int commun = 0;
        while (commun < Math.min(complet.length, nomDAvant.length) && complet[commun] == nomDAvant[commun]) {
            commun++;
        }
        noter(ligne - ligneDAvant);
        noter(commun);
        noter(complet.length - commun);
        for (int k = commun; k < complet.length; k++) {
            octet(complet[k]);
        }
        nomDAvant = complet;
        ligneDAvant = ligne;
    }

    /** Sept bits par octet, le huitième s'il y en a d'autres. */
    private void noter(int n) {
        int reste = n;
        for (; reste >= 128; reste >>>= 7) {
            octet((byte) (reste | 128));
        }
        octet((byte) reste);
    }

    private void octet(byte b) {
        if (taille == octets.length) {
            octets = Arrays.copyOf(octets, taille + (taille >> 1));
        }
        octets[taille++] = b;
    }

    /** Tout est ajouté : rend la place d'avance. */
    public void finir() {
        octets = Arrays.copyOf(octets, taille);
        ((ArrayList<?>) choses).trimToSize();
    }

    /** Par exemple {@code [Sphere ambre] ligne 52} ; {@code null} si cet objet ne vient pas d'un fichier. */
    public String de(Object chose) {
        ByteBuffer lus = ByteBuffer.wrap(octets);
        byte[] nom = {};
        int ligne = 0;
        for (Object autre : choses) {
            ligne += lire(lus);
            int commun = lire(lus);
            int propre = lire(lus);
            nom = Arrays.copyOf(nom, commun + propre);
            lus.get(nom, commun, propre);
            if (autre == chose) {
                return (nom.length == 0 ? "" : "[" + new String(nom, StandardCharsets.UTF_8) + "] ") + "ligne " + ligne;
            }
        }
        return null;
    }

    private static int lire(ByteBuffer lus) {
        byte octet = lus.get();
        return octet >= 0 ? octet : octet & 127 | lire(lus) << 7;
    }
}
