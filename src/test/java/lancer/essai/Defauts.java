package lancer.essai;

import static lancer.essai.Triplets.dot;
import static lancer.essai.Triplets.fois;
import static lancer.essai.Triplets.gris;
import static lancer.essai.Triplets.moins;
import static lancer.essai.Triplets.plus;
import static lancer.essai.Triplets.t;
import static lancer.essai.Triplets.unite;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Releve;
import lancer.contrat.Vue;
import lancer.essai.TraceurNaif.Ombre;
import lancer.image.FichierPng;
import lancer.image.ImageMemoire;
import lancer.systeme.Ecriture;

/**
 * De petites scènes dont la géométrie donne l'image, et une façon courante de la fausser. Ni l'image juste ni la fausse ne prennent une
 * ligne du programme : il peut changer d'arrondis.
 */
public final class Defauts {

    /** Un demi-pas de l'écran : ce qui s'en écarte davantage se voit, ou peut se voir. */
    private static final double VISIBLE = 0.5 / 255;

    /** Côté d'un pixel agrandi, et blanc entre les deux images. */
    private static final int LOUPE = 2;
    private static final int MARGE = 4;

    private static final Lampe A_L_OEIL = new Lampe(Camera.OEIL, new Couleur(1));

    /** Les défauts que la page montre, par le nom de leur image. */
    private static final Map<String, String> IMAGES = Map.of("defaut-surface.png", "une surface s'ombre elle-même",
            "defaut-lampe.png", "b² − 4ac, lampe à 10⁹", "defaut-jumelle.png", "sphère jumelle gardée");

    /** Une scène, ce que sa géométrie en donne, ce qu'en fait un défaut, et ce qu'en fait le programme. */
    public static final class Defaut {

        public final String nom;
        public final Couleur[] naive;
        public final Couleur[] programme;
        private final int cote;

        /** {@code null} là où la géométrie ne décide pas. */
        private final Couleur[] attendue;

        Defaut(String nom, int cote, Couleur[] attendue, Couleur[] naive, Couleur[] programme) {
            this.nom = nom;
            this.cote = cote;
            this.attendue = attendue;
            this.naive = naive;
            this.programme = programme;
        }

        private ImageMemoire image() {
            int large = LOUPE * cote;
            ImageMemoire image = new ImageMemoire(2 * large + MARGE, large, false);
            Arrays.fill(image.codes, new Couleur(1).getCode());
            for (int k = 0; k < large * large; k++) {
                int pixel = cote * (k / large / LOUPE) + k % large / LOUPE;
                image.drawPixel(naive[pixel], k % large, k / large);
                image.drawPixel(programme[pixel], k % large + large + MARGE, k / large);
            }
            return image;
        }

        public int faux(Couleur[] obtenue) {
            return (int) IntStream.range(0, attendue.length).filter(k -> attendue[k] != null && (differe(attendue[k].r, obtenue[k].r)
                    || differe(attendue[k].v, obtenue[k].v) || differe(attendue[k].b, obtenue[k].b))).count();
        }
    }

    /** Ce que montre une boule là où la direction V la rencontre, N y étant sa normale. */
    private interface Teinte {
        double[] en(double[] V, double[] N);
    }

    /** La moyenne de neuf points par pixel, à un tiers de pixel l'un de l'autre. */
    private static final Echantillonnage NEUF_POINTS = (pave, voulus, vue, toile) -> {
        for (int j = pave.j0; j < pave.j1; j++) {
            for (int i = pave.i0; i < pave.i1; i++) {
                toile.drawPixel(moyenne(vue, i + 0.5, j + 0.5, Double.MAX_VALUE), i, j);
            }
        }
        return Releve.RIEN;
    };

    private final List<Defaut> defauts = new ArrayList<>();

    /** Au milieu d'une scène d'un côté pair, aucun pixel ne regarde exactement l'horizon. */
    private int cote = 100;

    /** Écrit les images de la page. @param args leur dossier */
    public static void main(String[] args) {
        dessiner().forEach((nom, image) -> new Ecriture<>(Path.of(args[0], nom).toString(), new FichierPng()).ecrire(image));
    }

    /** Chaque image, par son nom : celle du défaut à gauche, celle du programme à droite. */
    public static Map<String, ImageMemoire> dessiner() {
        List<Defaut> tous = new Defauts().tous();
        Map<String, ImageMemoire> dessins = new HashMap<>();
        IMAGES.forEach((nom, defaut) -> dessins.put(nom, tous.stream().filter(d -> d.nom.equals(defaut)).findFirst().get().image()));
        return dessins;
    }

    public List<Defaut> tous() {
        Sphere boule = boule(0, 0, 5, 1.5, 1, 0);
        Vue juste = deLOeil(boule);
        noter("une surface s'ombre elle-même", A_L_OEIL, Ombre.SANS_EXCLURE, 0, juste, boule);
        // trop court pour un sol de 3·10¹⁰ de rayon, trop long pour ce qui est à 5·10⁻⁵ de l'écran
        double r = 1e11 / 3;
        noter("epsilon de 10⁻⁶, sol de rayon 3·10¹⁰", A_L_OEIL, Ombre.SANS_EXCLURE, 1e-6, (xe, ye) -> {
            double[] V = regard(xe, ye);
            return TraceurPlat.couleur(V[1] < 0 ? gris(-0.8 * V[1]) : TraceurPlat.ciel(V));
        }, boule(0, -r - 1, 5, r, 0.8, 0));
        Sphere proche = boule(0, 0, 100 + 5e-5, 100, 1, 0);
        noter("epsilon de 10⁻⁴, boule à 5·10⁻⁵", A_L_OEIL, Ombre.AUCUNE, 1e-4, deLOeil(proche), proche);
        // l'écran est dans deux coques, à 10⁻⁵ l'une de l'autre ; la lampe, dehors, ne doit éclairer que la seconde
        noter("départ exclu par la distance", new Lampe(new Point(0, 3, 12), new Couleur(1)), Ombre.SANS_EXCLURE, 1e-4,
                (xe, ye) -> new Couleur(), boule(0, 0, 2, 4, 1, 0), boule(0, 0, 2, 4 + 1e-5, 1, 0));
        noter("ombre d'un objet derrière la lampe", A_L_OEIL, Ombre.SANS_DISTANCE, 0, juste, boule, boule(0, 0, -9, 2, 1, 0));
        Sphere jumelle = boule(0, 0, 5, 1.5, 1, 0);
        noter("sphère jumelle gardée", scene(A_L_OEIL, boule, jumelle), 0, new TraceurPlat(List.of(boule, jumelle), List.of(A_L_OEIL), cote,
                cote, 0), juste);
        // une lampe à un milliard : ses rayons sont parallèles
        double[] soleil = unite(new double[] {-1, 2, -3});
        Sphere lune = boule(0, 0, 5, 1, 0.75, 0);
        noter("b² − 4ac, lampe à 10⁹", new Lampe(new Point(1e9 * soleil[0], 1e9 * soleil[1], 1e9 * soleil[2]), new Couleur(1)),
                Ombre.PREMIER_VU, 0, vue(lune, false, (V, N) -> gris(0.75 * Math.max(0, dot(N, soleil)))), lune);
        // le ciel change d'un coup à l'horizon
        Sphere miroir = boule(0, 0, 5, 1.5, 0, 0.5);
        noter("un miroir se réfléchit lui-même", new Scene(List.of(miroir), List.of()), 1,
                new TraceurNaif(List.of(miroir), List.of(), cote, 1, Ombre.AUCUNE, 0), vue(miroir, false, (V, N) -> {
                    double[] R = plus(V, -2 * dot(N, V), N);
                    return Math.abs(R[1]) < 1e-9 ? null : fois(gris(0.5), TraceurPlat.ciel(R));
                }));
        // l'œil dans une sphère, une lampe au-dehors : on voit la paroi par où sort le regard
        Sphere paroi = boule(0, 0, 0, 9, 1, 0);
        double[] dehors = {0, 0, 20};
        noter("première racine seule, vue du dedans", scene(new Lampe(new Point(0, 0, 20), new Couleur(1)), paroi), 0,
                (xe, ye) -> TraceurPlat.couleur(TraceurPlat.ciel(regard(xe, ye))),
                vue(paroi, true, (V, N) -> gris(Math.max(0, dot(N, unite(moins(dehors, fois(gris(9), N))))))));
        // un poli nul et une lampe derrière : (R·L)⁰ = 1 partout, mais la face que l'on voit ne reçoit rien
        Sphere mate = boule(0, 0, 5, 1.5, 0, 0.5);
        mate.setNs(0);
        noter("ns = 0 sans regarder N·L", scene(new Lampe(new Point(0, 0, 50), new Couleur(1)), mate), 0,
                vue(mate, false, (V, N) -> gris(0.5)), vue(mate, false, (V, N) -> gris(0)));
        noter("pixels vus en leur coin", scene(A_L_OEIL, boule), 0, (xe, ye) -> juste.couleur(xe - 0.5, ye - 0.5), juste);
        // une lampe dix fois trop forte, neuf points par pixel : limiter chacun, ou leur moyenne
        Sphere vive = boule(0, 0, 6, 1.5, 1, 0);
        Vue points = vue(vive, false, (V, N) -> gris(-10 * dot(N, V)));
        Scene forte = scene(new Lampe(Camera.OEIL, new Couleur(10)), vive);
        noter("limiter avant de moyenner", forte.avec(forte.getModele().avec(NEUF_POINTS, 0)), 0,
                (xe, ye) -> moyenne(points, xe, ye, 1), (xe, ye) -> moyenne(points, xe, ye, Double.MAX_VALUE));
        // la lampe est là où le pixel du milieu voit la boule : L = 0/0 ; ailleurs, la boule lui tourne le dos
        cote++;
        Sphere touchee = boule(0, 0, 5, 1, 1, 0);
        double[] posee = {0, 0, -1};
        noter("lampe posée sur une boule : 0/0", scene(new Lampe(new Point(0, 0, 4), new Couleur(1)), touchee), 0,
                vue(touchee, false, (V, N) -> gris(Math.max(0, dot(N, unite(moins(posee, N)))))), vue(touchee, false, (V, N) -> gris(0)));
        return defauts;
    }

    private static Sphere boule(double x, double y, double z, double r, double kd, double ks) {
        return Ressources.boule(x, y, z, r, kd, ks, 1);
    }

    private static Scene scene(Lampe lampe, Sphere... boules) {
        return new Scene(List.of(boules), List.of(lampe));
    }

    private double[] regard(double xe, double ye) {
        return unite(moins(TraceurPlat.ecran(cote, cote, xe, ye), TraceurPlat.OEIL));
    }

    /** Vue de l'œil, sans intersection calculée, d'où l'on entre dans la boule ou d'où l'on en sort ; le ciel autour. */
    private Vue vue(Sphere boule, boolean sortie, Teinte teinte) {
        double[] f = moins(t(boule.getCentre()), TraceurPlat.OEIL);
        return (xe, ye) -> {
            double[] V = regard(xe, ye);
            double[] perpendiculaire = plus(f, -dot(f, V), V);
            double r = boule.getRayon();
            double h2 = r * r - dot(perpendiculaire, perpendiculaire);
            double h = sortie ? Math.sqrt(h2) : -Math.sqrt(h2);
            double[] vue = h2 < 0 ? TraceurPlat.ciel(V) : teinte.en(V, fois(gris(1 / r), moins(fois(gris(h), V), perpendiculaire)));
            return vue == null ? null : TraceurPlat.couleur(vue);
        };
    }

    /** La lampe est à l'œil. */
    private Vue deLOeil(Sphere boule) {
        return vue(boule, false, (V, N) -> fois(t(boule.getKd()), gris(-dot(N, V))));
    }

    private static Couleur moyenne(Vue vue, double xe, double ye, double limite) {
        Couleur somme = new Couleur();
        for (int k = 0; k < 9; k++) {
            Couleur c = vue.couleur(xe + (k % 3 - 1) / 3.0, ye + (k / 3 - 1) / 3.0);
            somme = somme.add(new Couleur(Math.min(limite, c.r), Math.min(limite, c.v), Math.min(limite, c.b)));
        }
        return somme.div(9);
    }

    private void noter(String nom, Lampe lampe, Ombre ombre, double epsilon, Vue juste, Sphere... boules) {
        noter(nom, scene(lampe, boules), 0, new TraceurNaif(List.of(boules), List.of(lampe), cote, 0, ombre, epsilon), juste);
    }

    private void noter(String nom, Scene scene, int reflets, Vue naive, Vue juste) {
        Couleur[] image = new Couleur[cote * cote];
        new Lancer(scene.avec(scene.getModele().avecSeuil(0)), new Camera(cote, cote))
                .TracerImage((couleur, i, j) -> image[cote * j + i] = couleur, reflets, 1);
        defauts.add(new Defaut(nom, cote, image(juste), image(naive), image));
    }

    private Couleur[] image(Vue vue) {
        return IntStream.range(0, cote * cote).mapToObj(k -> vue.couleur(k % cote + 0.5, k / cote + 0.5)).toArray(Couleur[]::new);
    }

    /** Ce que montre l'écran, limité à [0, 1] ; NaN n'est jamais juste. */
    private static boolean differe(double attendu, double obtenu) {
        return !(Math.abs(Math.min(1, attendu) - Math.min(1, obtenu)) <= VISIBLE);
    }
}
