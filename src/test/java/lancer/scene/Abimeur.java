package lancer.scene;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import lancer.essai.Ressources;

/** Des fichiers de scène comme personne n'en écrit : du hasard, de vrais fichiers coupés, changés, mêlés. */
final class Abimeur {

    /** Au-delà, un vrai fichier n'est pris que par morceaux : c'est le nombre d'essais qui compte. */
    private static final int MORCEAU = 1500;

    private static final int LONGUEUR_MAX = 6000;

    /** De quoi tomber juste plus souvent que des octets quelconques. */
    private static final String[] MOTS = {"\n", "\r", "\r\n", "\t", " ", "=", ":", ";", "#", "[", "]", "[]", "\\", "\\\n", "\0",
        "\u001b[31m", "\ufeff", "\u2028", "\u00a0", "\u0131", "\u212a", "\ud83d\ude00", "${a/b}", "${@env/HOME}", "<autre.ini>",
        "[Sphere 1]\n", "[sphere]\n", "[Lampe 1]\n", "[Brume]\n", "[Antialias]\n", "[Blinn]\n", "[Cube]\n", "[Sphere", "centre=0 0.5 6\n",
        "rayon=1\n", "Kd=0.9 0.15 0.1\n", "Ks=", "Kr=0 0 1\n", "ns=40\n", "position=-4 6 -3\n", "couleur=0.8 0.8 0.75\n", "NaN", "Infinity",
        "1e308", "1e309", "-1e100", "1e-100", "1e-101", "1e-400", "0x1p3", "1d", "1,5", "١", ".", "-.5", "+5.", "1e", "1e+",
        "99999999999999999999", "0.1000000000000000055511151231257827021181583404541015625"};

    /** Ce qu'un décodeur UTF-8 trop confiant laisserait passer : tronqué, trop long, moitié de paire, hors d'Unicode. */
    private static final byte[][] OCTETS_FAUX = {{(byte) 0xC3}, {(byte) 0xE2, (byte) 0x82}, {(byte) 0xF0, (byte) 0x9F, (byte) 0x98},
        {(byte) 0xC0, (byte) 0x8A}, {(byte) 0xED, (byte) 0xA0, (byte) 0x80}, {(byte) 0xF5, (byte) 0x80, (byte) 0x80, (byte) 0x80},
        {(byte) 0xFF}, {(byte) 0xFE, (byte) 0xFF}, {(byte) 0xFF, (byte) 0xFE}, {(byte) 0xEF, (byte) 0xBB},
        {(byte) 0xEF, (byte) 0xBB, (byte) 0xBF}};

    private final List<byte[]> vrais = new ArrayList<>();

    /** Part de tous les fichiers de ces dossiers, toujours dans le même ordre. */
    Abimeur(Path... dossiers) throws IOException {
        for (Path dossier : dossiers) {
            for (Path chemin : Ressources.scenes(dossier)) {
                vrais.add(Files.readAllBytes(chemin));
            }
        }
    }

    /** Les scènes livrées et celles des tests de lecture. */
    static Abimeur deToutesLesScenes() throws IOException {
        return new Abimeur(Path.of("scenes"), Path.of(Ressources.chemin("valides")), Path.of(Ressources.chemin("fautives")),
                Path.of(Ressources.chemin("reference")));
    }

    /** Le fichier de cette graine, et d'elle seule. */
    byte[] fichier(long graine) {
        SplittableRandom hasard = new SplittableRandom(graine);
        byte[] fichier = vrai(hasard);
        for (int fois = 1 + hasard.nextInt(1 + hasard.nextInt(8)); fois > 0; fois--) {
            fichier = abimer(fichier, hasard);
        }
        return fichier;
    }

    private byte[] vrai(SplittableRandom hasard) {
        byte[] fichier = vrais.get(hasard.nextInt(vrais.size()));
        if (fichier.length <= MORCEAU) {
            return fichier;
        }
        int debut = hasard.nextInt(fichier.length - MORCEAU);
        while (debut > 0 && fichier[debut] != '[') {
            debut--;
        }
        return Arrays.copyOfRange(fichier, debut, Math.min(fichier.length, debut + MORCEAU));
    }

    private static byte[] octets(SplittableRandom hasard, int longueur) {
        byte[] octets = new byte[longueur];
        for (int k = 0; k < longueur; k++) {
            octets[k] = (byte) hasard.nextInt();
        }
        return octets;
    }

    private static byte[] mot(SplittableRandom hasard) {
        int sorte = hasard.nextInt(12);
        return sorte == 0 ? octets(hasard, 1 + hasard.nextInt(3))
                : sorte == 1 ? OCTETS_FAUX[hasard.nextInt(OCTETS_FAUX.length)]
                : sorte == 2 ? texte(Double.toString(Double.longBitsToDouble(hasard.nextLong())))
                : texte(MOTS[hasard.nextInt(MOTS.length)]);
    }

    private static byte[] texte(String s) {
        return s.getBytes(StandardCharsets.UTF_8);
    }

    /** Remplace un morceau du fichier par un autre, l'un ou l'autre peut-être vide. */
    private static byte[] abimer(byte[] f, SplittableRandom hasard) {
        int a = hasard.nextInt(f.length + 1);
        int b = Math.min(f.length, a + (hasard.nextBoolean() ? hasard.nextInt(3) : hasard.nextInt(200)));
        byte[] milieu = hasard.nextInt(3) > 0 ? mot(hasard) : repete(Arrays.copyOfRange(f, a, b), hasard.nextInt(6));
        ByteArrayOutputStream s = new ByteArrayOutputStream();
        s.write(f, 0, a);
        s.write(milieu, 0, milieu.length);
        s.write(f, b, f.length - b);
        return s.size() <= LONGUEUR_MAX ? s.toByteArray() : Arrays.copyOf(s.toByteArray(), LONGUEUR_MAX);
    }

    /** {@code fois} fois de suite ce morceau. */
    static byte[] repete(byte[] morceau, int fois) {
        byte[] tout = new byte[morceau.length * fois];
        for (int k = 0; k < tout.length; k++) {
            tout[k] = morceau[k % morceau.length];
        }
        return tout;
    }
}
