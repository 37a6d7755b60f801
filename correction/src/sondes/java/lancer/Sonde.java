package lancer;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Interroge les méthodes publiques des classes d'un étudiant : ce qu'elles dessinent, et ce qu'elles répondent en chemin. */
public final class Sonde {

    /** Des noms, chacun suivi de sa valeur. */
    private final List<String> reponses = new ArrayList<>();

    private Sonde() {
    }

    /** Les trois premiers champs d'une couleur, d'un vecteur ou d'un point. */
    private static float[] trois(Object o) {
        Object[] champs = Appels.champs(Objects.requireNonNull(o, "null au lieu d'une couleur, d'un vecteur ou d'un point"));
        return new float[] {((Number) champs[0]).floatValue(), ((Number) champs[1]).floatValue(), ((Number) champs[2]).floatValue()};
    }

    private static Objet3D objet(PointContact contact) {
        return (Objet3D) Appels.champs(contact)[3];
    }

    /** Les couleurs non limitées, en flottants. */
    private static byte[] coder(Couleur[] couleurs) {
        ByteBuffer octets = ByteBuffer.allocate(couleurs.length * 12);
        for (Couleur c : couleurs) {
            for (float composante : trois(c)) {
                octets.putFloat(composante);
            }
        }
        return octets.array();
    }

    /** @param a largeur, hauteur, profondeur ; par getCouleurPixel ou, si rien ici ne l'appelle, par les méthodes qu'il appelle */
    public static byte[] dessiner(String fichier, String... a) throws Exception {
        int largeur = Integer.parseInt(a[0]);
        int profondeur = Integer.parseInt(a[2]);
        Scene scene = new Scene(fichier);
        Camera camera = new Camera(largeur, Integer.parseInt(a[1]));
        Lancer lancer = lancer(scene, camera, profondeur);
        Couleur[] pixels = new Couleur[largeur * Integer.parseInt(a[1])];
        for (int p = 0; p < pixels.length; p++) {
            int xe = p % largeur;
            int ye = p / largeur;
            pixels[p] = lancer != null ? lancer.getCouleurPixel(xe, ye, profondeur) : parRayon(scene, camera.getRayon(xe, ye), profondeur);
        }
        return coder(pixels);
    }

    /** Un seul pour l'image, comme dans le programme ; {@code null} s'il ne peut être appelé comme cela. */
    private static Lancer lancer(Scene scene, Camera camera, int profondeur) throws Exception {
        try {
            Lancer lancer = new Lancer(scene, camera);
            lancer.getCouleurPixel(0, 0, profondeur);
            return lancer;
        } catch (Error e) {
            return null;
        }
    }

    private static Couleur parRayon(Scene scene, Rayon rayon, int profondeur) throws Exception {
        PointContact contact = scene.getClosestIntersection(rayon, null);
        return contact == null ? rayon.getSkyColor() : objet(contact).getColor(scene, rayon, contact, profondeur);
    }

    /** @param a largeur, hauteur, profondeur ; ce que dessine TracerImage, où l'étudiant met l'anticrénelage */
    public static byte[] tracer(String fichier, String... a) throws Exception {
        int largeur = Integer.parseInt(a[0]);
        int hauteur = Integer.parseInt(a[1]);
        Couleur[] pixels = new Couleur[largeur * hauteur];
        Toile toile = new Toile() {
            @Override
            public void drawPixel(Couleur coul, int xe, int ye) {
                pixels[ye * largeur + xe] = coul;
            }

            @Override
            public void avancer(double part) {
                // personne ne regarde
            }
        };
        new Lancer(new Scene(fichier), new Camera(largeur, hauteur)).TracerImage(toile, largeur, hauteur, Integer.parseInt(a[2]));
        return coder(pixels);
    }

    /** @param a largeur, hauteur, xe, ye, profondeur ; rend des noms, chacun suivi de sa valeur, {@code x y z} */
    public static List<String> decrire(String fichier, String... a) throws Exception {
        Sonde chemin = new Sonde();
        try {
            chemin.suivre(fichier, new Camera(Integer.parseInt(a[0]), Integer.parseInt(a[1])), Double.parseDouble(a[2]),
                    Double.parseDouble(a[3]), Integer.parseInt(a[4]));
        } catch (Exception | Error e) {
            chemin.dire("arrêt", e);
        }
        return chemin.reponses;
    }

    private void suivre(String fichier, Camera camera, double xe, double ye, int profondeur) throws Exception {
        Scene scene = new Scene(fichier);
        Rayon rayon = camera.getRayon(xe, ye);
        dire("rayon, départ P", rayon.getP());
        dire("rayon, direction V", rayon.getV());
        PointContact contact = scene.getClosestIntersection(rayon, null);
        if (contact == null) {
            dire("aucun objet rencontré ; couleur du ciel", rayon.getSkyColor());
            return;
        }
        Objet3D objet = objet(contact);
        dire("objet rencontré, sa couleur Kd", objet.getKd());
        dire("distance", ((Number) Appels.champs(contact)[4]).floatValue());
        dire("point de contact", contact);
        dire("normale N", objet.getNormale(contact));
        // une lampe à la fois, par un fichier : une scène n'a pas forcément d'autre constructeur
        String[] sections = new String(Files.readAllBytes(Paths.get(fichier)), StandardCharsets.UTF_8).split("(?m)^(?=\\[)");
        String objets = Stream.of(sections).filter(s -> !s.startsWith("[Lampe")).collect(Collectors.joining());
        int k = 0;
        for (String lampe : sections) {
            if (lampe.startsWith("[Lampe")) {
                k++;
                dire("lampe " + k + " seule, sans Ks", eclairer(fichier, objets.replaceAll("(?m)^K[sr]=.*", "Ks=0 0 0") + lampe,
                        camera, xe, ye));
                dire("lampe " + k + " seule, avec Ks", eclairer(fichier, objets + lampe, camera, xe, ye));
            }
        }
        for (int p = 0; p <= profondeur; p++) {
            dire("toutes les lampes, profondeur " + p, parRayon(scene, camera.getRayon(xe, ye), p));
        }
    }

    private static Couleur eclairer(String fichier, String scene, Camera camera, double xe, double ye) throws Exception {
        Files.write(Paths.get(fichier), scene.getBytes(StandardCharsets.UTF_8));
        return parRayon(new Scene(fichier), camera.getRayon(xe, ye), 0);
    }

    /** Sept chiffres : de quoi comparer, à l'œil aussi. */
    private void dire(String nom, Object valeur) {
        reponses.add(nom);
        if (valeur instanceof Tuple || valeur instanceof Couleur) {
            float[] nombres = trois(valeur);
            reponses.add(nombres[0] + " " + nombres[1] + " " + nombres[2]);
        } else {
            reponses.add(String.valueOf(valeur));
        }
    }
}
