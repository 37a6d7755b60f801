package lancer;

import java.io.IOException;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import org.ini4j.Ini;
import org.ini4j.Profile;

/** Lit une scène dans un fichier INI : des sections [Sphere …] et [Lampe …]. */
class LecteurScene {

    private final String fichier;
    private final String texte;
    private final List<Objet3D> objets = new ArrayList<>();
    private final List<Lampe> lampes = new ArrayList<>();
    //<brume
    //+ private final Brume brume = new Brume(0);
    //>

    /** @throws IllegalArgumentException si le fichier ne peut être lu, ou si une clé y manque ou s'y trouve deux fois */
    LecteurScene(String fichier) {
        this.fichier = fichier;
        try {
            texte = new String(Files.readAllBytes(Paths.get(fichier)), StandardCharsets.UTF_8).replace("\uFEFF", "");
            Ini ini = new Ini();
            ini.getConfig().setMultiSection(true);
            ini.load(new StringReader(texte));
            for (Profile.Section section : ini.values()) {
                if (ini.length(section.getName()) > 1) {
                    throw refus(section, "", "un autre nom : celui-ci est déjà pris");
                }
                String nom = section.getName().toLowerCase();
                if (nom.startsWith("sphere")) {
                    objets.add(sphere(section));
                } else if (nom.startsWith("lampe")) {
                    lampes.add(new Lampe(point(section, "position"), couleur(section, "couleur")));
                //<brume
                //+ } else if (nom.startsWith("brume")) {
                //+     brume.couleur = section.containsKey("couleur") ? couleur(section, "couleur") : brume.couleur;
                //+     brume.debut = section.containsKey("debut") ? reels(section, "debut", 1)[0] : brume.debut;
                //+     brume.fin = section.containsKey("fin") ? reels(section, "fin", 1)[0] : brume.fin;
                //+     brume.densite = section.containsKey("densite") ? reels(section, "densite", 1)[0] : brume.densite;
                //>
                }
            }
        } catch (IOException e) {
            throw new IllegalArgumentException("scène illisible : " + fichier + " (" + e.getMessage() + ")", e);
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
        Sphere sphere = new Sphere(point(section, "centre"), reels(section, "rayon", 1)[0]);
        sphere.setKd(section.containsKey("Kd") ? couleur(section, "Kd") : new Couleur());
        String Ks = section.containsKey("Kr") ? "Kr" : "Ks";
        sphere.setKs(section.containsKey(Ks) ? couleur(section, Ks) : new Couleur());
        sphere.setNs(section.containsKey("ns") ? reels(section, "ns", 1)[0] : 1);
        return sphere;
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
        if (section.length(cle) != 1) {
            throw refus(section, cle, attendu + ", une fois");
        }
        String[] mots = section.get(cle).trim().split("\\s+");
        double[] reels = new double[nombre];
        try {
            for (int k = 0; k < nombre; k++) {
                reels[k] = Double.parseDouble(mots[k]);
            }
        } catch (ArrayIndexOutOfBoundsException | NumberFormatException e) {
            throw refus(section, cle, attendu + ", avec un point décimal ; obtenu, « " + section.get(cle) + " »");
        }
        return reels;
    }

    /** Le refus d'une clé de cette section, ou de la section si elle n'y est pas : où elle est, et ce qui est attendu. */
    private IllegalArgumentException refus(Profile.Section section, String cle, String attendu) {
        int ligne = 0;
        int numero = 0;
        boolean dedans = false;
        for (String nue : texte.split("\\R")) {
            numero++;
            dedans = nue.trim().startsWith("[") ? nue.trim().equals("[" + section.getName() + "]") : dedans;
            ligne = dedans && (nue.trim().startsWith("[") || nue.split("[=:]")[0].trim().equals(cle)) ? numero : ligne;
        }
        return new IllegalArgumentException(fichier + ":" + ligne + ", [" + section.getName() + "]"
                + (cle.isEmpty() ? "" : ", " + cle) + " : attendu, " + attendu);
    }
}
