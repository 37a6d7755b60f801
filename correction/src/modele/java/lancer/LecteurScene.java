package lancer;

import java.io.IOException;
import java.io.StringReader;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import org.ini4j.Ini;
import org.ini4j.Profile;

/**
 * Lit une scène dans un fichier INI : des sections [Sphere …] et [Lampe …]. Une section, une clé ou un nombre que l'on ne
 * sait pas lire est un refus, qui dit où.
 */
class LecteurScene {

    private static final int DOSSIERS_AU_DESSUS = 4;
    private static final Pattern NOMBRE = Pattern.compile("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?");

    private final String fichier;
    private final String texte;
    private final List<Objet3D> objets = new ArrayList<>();
    private final List<Lampe> lampes = new ArrayList<>();
    //<brume
    //+ private final Brume brume = new Brume(0);
    //>

    /** @throws IllegalArgumentException si le fichier n'est pas celui d'une scène */
    LecteurScene(String fichier) {
        this.fichier = fichier;
        try {
            byte[] octets = Files.readAllBytes(trouver(fichier));
            texte = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(octets)).toString().replace("\uFEFF", "");
            Ini ini = new Ini();
            ini.getConfig().setMultiSection(true);
            ini.getConfig().setLowerCaseOption(true);
            ini.load(new StringReader(texte));
            for (Profile.Section section : ini.values()) {
                if (ini.length(section.getName()) > 1) {
                    throw refus(section, "", "un autre nom : celui-ci est déjà pris");
                }
                lire(section);
            }
        } catch (NoSuchFileException e) {
            throw new IllegalArgumentException("scène introuvable, ici et dans les " + DOSSIERS_AU_DESSUS + " dossiers au-dessus : " + fichier, e);
        } catch (CharacterCodingException e) {
            throw new IllegalArgumentException("scène illisible : " + fichier + " n'est pas enregistré en UTF-8", e);
        } catch (IOException e) {
            throw new IllegalArgumentException("scène illisible : " + fichier + ", "
                    + String.valueOf(e.getMessage()).replace("parse error (at line: ", "ni section ni clé=valeur (ligne "), e);
        }
    }

    /** Ce fichier, ici ou dans l'un des dossiers au-dessus : les copies du projet peuvent avoir les mêmes scènes. */
    private static Path trouver(String fichier) {
        Path dossier = Paths.get("").toAbsolutePath();
        for (int k = 0; k <= DOSSIERS_AU_DESSUS && dossier != null; k++) {
            if (Files.exists(dossier.resolve(fichier))) {
                return dossier.resolve(fichier);
            }
            dossier = dossier.getParent();
        }
        return Paths.get(fichier);
    }

    private void lire(Profile.Section section) {
        switch (section.getName().trim().split("\\s+")[0].toLowerCase(Locale.ROOT)) {
            case "sphere":
                objets.add(sphere(section));
                break;
            case "lampe":
                connues(section, "position", "couleur");
                lampes.add(new Lampe(point(section, "position"), couleur(section, "couleur")));
                break;
            case "brume":
                //<brume
                //+ connues(section, "couleur", "debut", "fin", "densite");
                //+ brume.couleur = section.containsKey("couleur") ? couleur(section, "couleur") : brume.couleur;
                //+ brume.debut = section.containsKey("debut") ? reels(section, "debut", 1)[0] : brume.debut;
                //+ brume.fin = section.containsKey("fin") ? reels(section, "fin", 1)[0] : brume.fin;
                //+ brume.densite = section.containsKey("densite") ? reels(section, "densite", 1)[0] : brume.densite;
                //+ break;
                //>
            case "antialias":
            case "blinn":
                System.err.println(lieu(section, "") + " : section laissée de côté, que seule la copie de cette extension peut lire");
                break;
            default:
                throw refus(section, "", "une section [Sphere …] ou [Lampe …]");
        }
    }

    List<Objet3D> getObjets() {
        return objets;
    }

    List<Lampe> getLampes() {
        return lampes;
    }

    //<brume
    //+ Brume getBrume() {
    //+     return brume;
    //+ }
    //+
    //>
    private Sphere sphere(Profile.Section section) {
        connues(section, "centre", "rayon", "Kd", "Ks", "Kr", "ns");
        double rayon = reels(section, "rayon", 1)[0];
        if (rayon <= 0) {
            throw refus(section, "rayon", "un nombre positif ; obtenu, « " + rayon + " »");
        }
        Sphere sphere = new Sphere(point(section, "centre"), rayon);
        sphere.setKd(section.containsKey("kd") ? couleur(section, "Kd") : new Couleur());
        String Ks = section.containsKey("kr") ? "Kr" : "Ks";
        if (section.containsKey("kr") && section.containsKey("ks")) {
            throw refus(section, "Ks", "Ks ou Kr, qui sont deux noms de la même clé");
        }
        sphere.setKs(section.containsKey(Ks.toLowerCase(Locale.ROOT)) ? couleur(section, Ks) : new Couleur());
        sphere.setNs(section.containsKey("ns") ? reels(section, "ns", 1)[0] : 1);
        return sphere;
    }

    /** Refuse une clé qui n'est pas l'une de celles-ci. */
    private void connues(Profile.Section section, String... cles) {
        for (String cle : section.keySet()) {
            if (Arrays.stream(cles).noneMatch(cle::equalsIgnoreCase)) {
                throw refus(section, cle, "l'une des clés " + String.join(", ", cles));
            }
        }
    }

    private Point point(Profile.Section section, String cle) {
        double[] t = reels(section, cle, 3);
        return new Point(t[0], t[1], t[2]);
    }

    private Couleur couleur(Profile.Section section, String cle) {
        double[] t = reels(section, cle, 3);
        return new Couleur(t[0], t[1], t[2]);
    }

    private double[] reels(Profile.Section section, String cle, int nombre) {
        String attendu = nombre == 1 ? "un nombre" : nombre + " nombres séparés par des blancs";
        String ecrite = cle.toLowerCase(Locale.ROOT);
        if (section.length(ecrite) != 1) {
            throw refus(section, cle, attendu + ", une fois");
        }
        String[] mots = section.get(ecrite).trim().split("\\s+");
        double[] reels = new double[nombre];
        for (int k = 0; k < nombre; k++) {
            if (mots.length != nombre || !NOMBRE.matcher(mots[k]).matches() || Double.isInfinite(Double.parseDouble(mots[k]))) {
                throw refus(section, cle, attendu + ", avec un point décimal ; obtenu, « " + section.get(ecrite) + " »");
            }
            reels[k] = Double.parseDouble(mots[k]);
        }
        return reels;
    }

    private IllegalArgumentException refus(Profile.Section section, String cle, String attendu) {
        return new IllegalArgumentException(lieu(section, cle) + " : attendu, " + attendu);
    }

    /** Où est cette clé d'une section, ou la section si la clé n'y est pas. */
    private String lieu(Profile.Section section, String cle) {
        int ligne = 0;
        int numero = 0;
        boolean dedans = false;
        for (String nue : texte.split("\\R")) {
            numero++;
            dedans = nue.trim().startsWith("[") ? nue.trim().equals("[" + section.getName() + "]") : dedans;
            ligne = dedans && (nue.trim().startsWith("[") || nue.split("[=:]")[0].trim().equalsIgnoreCase(cle)) ? numero : ligne;
        }
        return fichier + ":" + ligne + ", [" + section.getName() + "]" + (cle.isEmpty() ? "" : ", " + cle);
    }
}
