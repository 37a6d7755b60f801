package lancer;

import java.io.File;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.ini4j.Ini;
import org.ini4j.Profile;

/** Lit une scène dans un fichier INI : des sections [Sphere …] et [Lampe …]. */
class LecteurScene {

    private final String fichier;
    private final List<Objet3D> objets = new ArrayList<>();
    private final List<Lampe> lampes = new ArrayList<>();
    //<brume
    //+ private final Brume brume = new Brume(0);
    //>

    /** @throws IllegalArgumentException si le fichier ne peut être lu, ou s'il y manque quelque chose */
    LecteurScene(String fichier) {
        this.fichier = fichier;
        try {
            for (Profile.Section section : new Ini(new File(fichier)).values()) {
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
        String[] mots = section.get(cle) == null ? new String[0] : section.get(cle).trim().split("\\s+");
        double[] reels = new double[nombre];
        try {
            for (int k = 0; k < nombre; k++) {
                reels[k] = Double.parseDouble(mots[k]);
            }
        } catch (ArrayIndexOutOfBoundsException | NumberFormatException e) {
            throw new IllegalArgumentException(fichier + ", [" + section.getName() + "], " + cle + " : attendu, "
                    + "" + nombre + " nombre(s)", e);
        }
        return reels;
    }
}
