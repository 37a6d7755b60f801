package lancer.contrat;

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
        int[] ou = new int[1];
        byte[] nom = {};
        int ligne = 0;
        for (Object autre : choses) {
            ligne += lire(ou);
            int commun = lire(ou);
            int propre = lire(ou);
            nom = Arrays.copyOf(nom, commun + propre);
            System.arraycopy(octets, ou[0], nom, commun, propre);
            ou[0] += propre;
            if (autre == chose) {
                return (nom.length == 0 ? "" : "[" + new String(nom, StandardCharsets.UTF_8) + "] ") + "ligne " + ligne;
            }
        }
        return null;
    }

    private int lire(int[] ou) {
        int n = 0;
        int decalage = 0;
        while (octets[ou[0]] < 0) {
            n |= (octets[ou[0]++] & 127) << decalage;
            decalage += 7;
        }
        return n | octets[ou[0]++] << decalage;
    }
}
