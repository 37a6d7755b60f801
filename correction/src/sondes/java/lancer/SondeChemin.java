package lancer;

import java.util.Collections;
import java.util.List;

/**
 * Ce que répondent, en chemin, les méthodes publiques du cours, pour un point de l'écran : de quoi trouver où deux
 * programmes se séparent.
 */
public final class SondeChemin {

    private final StringBuilder texte = new StringBuilder();

    private SondeChemin() {
    }

    /**
     * @param a scène, largeur, hauteur, xe, ye, profondeur ; rend {@code nom=x y z} pour chaque réponse, séparés par
     * des tabulations
     */
    public static String decrire(String... a) {
        SondeChemin chemin = new SondeChemin();
        try {
            chemin.suivre(new Scene(a[0]), new Camera(Integer.parseInt(a[1]), Integer.parseInt(a[2])),
                    Double.parseDouble(a[3]),
                    Double.parseDouble(a[4]), Integer.parseInt(a[5]));
        } catch (Exception | Error e) {
            chemin.dire("arrêt", e);
        }
        return chemin.texte.toString();
    }

    private void suivre(Scene scene, Camera camera, double xe, double ye, int profondeur) {
        Rayon rayon = camera.getRayon(xe, ye);
        dire("rayon, départ P", rayon.getP());
        dire("rayon, direction V", rayon.getV());
        PointContact contact = scene.getClosestIntersection(rayon, null);
        if (contact == null) {
            dire("aucun objet rencontré ; couleur du ciel", rayon.getSkyColor());
            return;
        }
        Objet3D objet = contact.objet;
        dire("objet rencontré, son rang dans la scène", scene.getObjets().indexOf(objet) + 1);
        dire("distance", contact.distance);
        dire("point de contact", contact);
        dire("normale N", objet.getNormale(contact));
        Couleur Ks = objet.getKs();
        List<Lampe> lampes = scene.getLampes();
        for (int k = 0; k < lampes.size(); k++) {
            Scene seule = new Scene(scene.getObjets(), Collections.singletonList(lampes.get(k)));
            objet.setKs(new Couleur(0, 0, 0));
            dire("lampe " + (k + 1) + " seule, sans Ks", couleur(seule, camera, xe, ye, 0));
            objet.setKs(Ks);
            dire("lampe " + (k + 1) + " seule, avec Ks", couleur(seule, camera, xe, ye, 0));
        }
        for (int p = 0; p <= profondeur; p++) {
            dire("toutes les lampes, profondeur " + p, couleur(scene, camera, xe, ye, p));
        }
    }

    private static Couleur couleur(Scene scene, Camera camera, double xe, double ye, int profondeur) {
        return SondeImage.parRayon(scene, camera.getRayon(xe, ye), profondeur);
    }

    private void dire(String nom, Object valeur) {
        String nombres;
        if (valeur instanceof Tuple) {
            Tuple t = (Tuple) valeur;
            nombres = t.x + " " + t.y + " " + t.z;
        } else if (valeur instanceof Couleur) {
            Couleur c = (Couleur) valeur;
            nombres = c.r + " " + c.v + " " + c.b;
        } else {
            nombres = String.valueOf(valeur).replaceAll("[\\p{Cntrl}=]", " ");
        }
        texte.append(texte.length() > 0 ? "\t" : "").append(nom).append('=').append(nombres);
    }
}
