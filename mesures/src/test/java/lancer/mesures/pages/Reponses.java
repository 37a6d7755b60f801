package lancer.mesures.pages;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Formatter;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleBiFunction;
import java.util.stream.IntStream;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.Modele;
import lancer.contrat.Specularite;
import lancer.image.FichierPng;
import lancer.image.ImageMemoire;
import lancer.systeme.Ecriture;

/** La cible reponses d'outils/Makefile : calcule les figures et les nombres de la page des réponses. */
public final class Reponses {

    private static final int[] EXPOSANTS = {1, 8, 32, 128, 1024};
    private static final String[] COULEURS = {"#000000", "#0072B2", "#009E73", "#E69F00", "#D55E00"};

    private static final int LARGEUR = 240;
    private static final int HAUTEUR = 180;

    /** Racine du nombre de rayons par pixel de la figure des étapes ; côté d'un pixel agrandi dans celle des escaliers. */
    private static final int FINESSE = 3;
    private static final int LOUPE = 12;

    private Reponses() {
    }

    /** @param args la page, et le dossier des figures */
    public static void main(String[] args) throws IOException {
        PagesMesurees.reecrire(Path.of(args[0]), valeurs());
        Path figures = Path.of(args[1]);
        Files.writeString(figures.resolve("reponses-cosinus.svg"), cosinus());
        new Ecriture<>(figures.resolve("reponses-etapes.png").toString(), new FichierPng()).ecrire(etapes());
        new Ecriture<>(figures.resolve("reponses-escaliers.png").toString(), new FichierPng()).ecrire(escaliers());
    }

    /** Les nombres de la page, par nom. */
    static Map<String, String> valeurs() {
        Map<String, String> valeurs = new LinkedHashMap<>();
        for (int[] taille : new int[][] {{800, 600}, {1280, 1024}, {1600, 1200}}) {
            Point coin = new Camera(taille[0], taille[1]).getRayon(0, 0).getP();
            valeurs.put("naif." + taille[0], "(" + nombre(-taille[0] / 2.0) + " ; " + nombre(taille[1] / 2.0) + ")");
            valeurs.put("coin." + taille[0], "(" + nombre(coin.x) + " ; " + nombre(coin.y) + " ; 0)");
        }
        Point bas = new Camera(800, 600).getRayon(800, 600).getP();
        valeurs.put("bas.800", "(" + nombre(bas.x) + " ; " + nombre(bas.y) + " ; 0)");
        valeurs.put("focale", nombre(Camera.FOCALE));
        Scene scene = new Scene("scenes/scene1.ini");
        valeurs.put("miroir", String.format(Locale.FRANCE, "%.0e", rang(1, scene, Reponses::ecartDuMiroir))
                .replaceFirst("e-0?(\\d+)", " · 10<sup>−$1</sup>"));
        for (String nom : List.of("diffus", "brume")) {
            Scene vue = new Scene("scenes/" + nom + ".ini");
            valeurs.put(nom + ".distance", nombre(rang(0.5, vue, (rayon, contact) -> contact.distance)));
        }
        for (int n : List.of(32, 128)) {
            double angle = Math.toDegrees(Math.acos(Math.pow(0.5, 1.0 / n)));
            valeurs.put("phong." + n, nombre(angle));
            valeurs.put("blinn." + n, nombre(2 * angle));
        }
        return valeurs;
    }

    private static String nombre(double x) {
        return String.format(Locale.FRANCE, "%.3f", x).replaceFirst(",?0+$", "").replace('-', '−');
    }

    /** Écart de 1 à la longueur du vecteur réfléchi d'un rayon, avant sa normalisation. */
    private static double ecartDuMiroir(Rayon rayon, PointContact contact) {
        Vecteur V = rayon.getV();
        Vecteur N = contact.objet.getNormale(contact);
        return Math.abs(V.sub(N.mul(2 * V.dot(N))).norme() - 1);
    }

    /** Une mesure en chaque contact d'une petite image, au rang {@code part} : 0 pour la plus petite, 0,5 pour la médiane. */
    private static double rang(double part, Scene scene, ToDoubleBiFunction<Rayon, PointContact> mesure) {
        Camera camera = new Camera(200, 150);
        double[] mesures = IntStream.range(0, 200 * 150).mapToDouble(k -> {
            Rayon rayon = camera.getRayon(k % 200 + 0.5, k / 200 + 0.5);
            PointContact contact = scene.getClosestIntersection(rayon);
            return contact == null ? Double.NaN : mesure.applyAsDouble(rayon, contact);
        }).filter(x -> !Double.isNaN(x)).sorted().toArray();
        return mesures[(int) Math.min(part * mesures.length, mesures.length - 1)];
    }

    /** Le graphe du cours : l'éclat que calcule le programme, selon l'angle entre R et L. */
    static String cosinus() {
        Formatter svg = new Formatter(Locale.ROOT);
        svg.format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"640\" height=\"360\" font-family=\"sans-serif\" font-size=\"14\">\n"
                + "<rect width=\"640\" height=\"360\" fill=\"white\"/>\n");
        for (int k = 0; k <= 4; k++) {
            svg.format("<path d=\"M60 %dH540\" stroke=\"#ddd\"/><text x=\"52\" y=\"%d\" text-anchor=\"end\">%s</text>\n",
                    320 - 75 * k, 325 - 75 * k, nombre(k / 4.0));
        }
        for (int k = 0; k <= 6; k++) {
            svg.format("<text x=\"%d\" y=\"340\" text-anchor=\"middle\">%s</text>\n", 60 + 80 * k, nombre(k / 4.0));
        }
        svg.format("<text x=\"300\" y=\"357\" text-anchor=\"middle\">angle entre −V et R, en radians</text>\n");
        Vecteur N = new Vecteur(0, 0, -1);
        for (int e = 0; e < EXPOSANTS.length; e++) {
            svg.format("<path fill=\"none\" stroke-width=\"2\" stroke=\"%s\" d=\"", COULEURS[e]);
            for (int k = 0; k <= 240; k++) {
                double angle = k / 160.0;
                Vecteur L = new Vecteur(Math.sin(angle), 0, -Math.cos(angle));
                double eclat = Specularite.PHONG.eclat(N.neg(), N, L, N, EXPOSANTS[e]);
                svg.format("%s%d %.1f", k == 0 ? "M" : "L", 60 + 2 * k, 320 - 300 * eclat);
            }
            svg.format("\"/>\n<text x=\"548\" y=\"%d\" fill=\"%s\">n = %d</text>\n", 40 + 22 * e, COULEURS[e], EXPOSANTS[e]);
        }
        return svg.format("</svg>\n").toString();
    }

    /** La scène des étapes : un sol, une sphère, et une autre qui l'ombre et s'y reflète. */
    private static Scene scene() {
        List<Sphere> boules = List.of(new Sphere(new Point(0.35, 0, 7), 1.1),
                new Sphere(new Point(-1.3, -0.35, 5.8), 0.5), new Sphere(new Point(0, -1001.1, 7), 1000));
        Couleur[] Kd = {new Couleur(0.75, 0.12, 0.1), new Couleur(0.1, 0.3, 0.75), new Couleur(0.6, 0.55, 0.45)};
        for (int k = 0; k < boules.size(); k++) {
            boules.get(k).setKd(Kd[k]);
            boules.get(k).setKs(new Couleur(k == 2 ? 0.1 : 0.35));
            boules.get(k).setNs(60);
        }
        return new Scene(boules, List.of(new Lampe(new Point(-5, 5, -1), new Couleur(0.9)),
                new Lampe(new Point(4, 3, -3), new Couleur(0.25))));
    }

    /** La couleur d'un rayon à une étape du TP : 0, jaune uni ; 1, Lambert ; 2, Phong ; 3, ombres ; 4, reflets. */
    private static Couleur couleur(int etape, Scene scene, Rayon rayon) {
        PointContact contact = scene.getClosestIntersection(rayon);
        if (contact == null) {
            return rayon.getSkyColor();
        }
        if (etape == 0) {
            return new Couleur(1, 1, 0);
        }
        return contact.objet.getColor(scene, rayon, contact, etape < 4 ? 0 : Constantes.MAX_REFLETS);
    }

    /** Les cinq étapes, côte à côte. */
    static ImageMemoire etapes() {
        ImageMemoire image = blanche(5 * LARGEUR + 4 * 4, HAUTEUR);
        Camera camera = new Camera(LARGEUR, HAUTEUR);
        for (int etape = 0; etape < 5; etape++) {
            Modele.Construction modele = new Modele.Construction();
            if (etape < 2) {
                modele.oterSpecularite();
            }
            if (etape < 3) {
                modele.oterOmbres();
            }
            Scene scene = scene().avec(modele.construire());
            for (int p = 0; p < LARGEUR * HAUTEUR; p++) {
                image.drawPixel(moyenne(etape, scene, camera, p % LARGEUR, p / LARGEUR, FINESSE), etape * (LARGEUR + 4) + p % LARGEUR,
                        p / LARGEUR);
            }
        }
        return image;
    }

    private static Couleur moyenne(int etape, Scene scene, Camera camera, int i, int j, int n) {
        Couleur somme = new Couleur();
        for (int k = 0; k < n * n; k++) {
            somme = somme.add(couleur(etape, scene, camera.getRayon(i + (k % n + 0.5) / n, j + (k / n + 0.5) / n)));
        }
        return somme.div(n * n);
    }

    /** Le bord d'une sphère, agrandi : un rayon par pixel, puis 3 × 3. */
    static ImageMemoire escaliers() {
        int cote = 28;
        ImageMemoire image = blanche(2 * cote * LOUPE + 8, cote * LOUPE);
        Camera camera = new Camera(100, 75);
        Scene scene = scene();
        for (int n = 1; n <= 3; n += 2) {
            for (int p = 0; p < cote * cote; p++) {
                Couleur couleur = moyenne(4, scene, camera, 60 + p % cote, 12 + p / cote, n);
                for (int q = 0; q < LOUPE * LOUPE; q++) {
                    image.drawPixel(couleur, (n - 1) / 2 * (cote * LOUPE + 8) + p % cote * LOUPE + q % LOUPE, p / cote * LOUPE + q / LOUPE);
                }
            }
        }
        return image;
    }

    private static ImageMemoire blanche(int largeur, int hauteur) {
        ImageMemoire image = new ImageMemoire(largeur, hauteur, false);
        Arrays.fill(image.codes, -1);
        return image;
    }
}
