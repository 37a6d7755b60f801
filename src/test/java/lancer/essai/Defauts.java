package lancer.essai;

import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Releve;
import lancer.contrat.Vue;
import lancer.essai.TraceurNaif.Ombre;
import lancer.image.FichierPng;
import lancer.image.ImageMemoire;
import lancer.systeme.Ecriture;

/**
 * De petites scènes dont la géométrie donne l'image, et une façon courante de la fausser.
 */
public final class Defauts {

    /** Un demi-pas de l'écran : ce qui s'en écarte davantage se voit, ou peut se voir. */
    private static final double VISIBLE = 0.5 / 255;

    /** Au milieu d'une scène d'un côté pair, aucun pixel ne regarde exactement l'horizon. */
    private static final int COTE = 100;
    private static final int COTE_IMPAIR = 101;

    /** Une scène, ce que sa géométrie en donne, ce qu'en fait un défaut, et ce qu'en fait le programme. */
    public static final class Defaut {

        public final String nom;
        public final int cote;
        public final Couleur[] naive;
        public final Couleur[] programme;

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
            return (int) IntStream.range(0, attendue.length).filter(k -> estFaux(k, obtenue)).count();
        }

        public boolean estFaux(int k, Couleur[] obtenue) {
            return attendue[k] != null && (differe(attendue[k].r, obtenue[k].r) || differe(attendue[k].v, obtenue[k].v)
                    || differe(attendue[k].b, obtenue[k].b));
        }
    }

    /** Ce que montre une sphère là où la direction V la rencontre, N y étant sa normale. */
    private interface Teinte {
        Couleur en(Vecteur V, Vecteur N);
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

    /** Les défauts que la page montre, par le nom de leur image ; côté d'un pixel agrandi, et blanc entre les deux images. */
    private static final Map<String, String> IMAGES = images();
    private static final int LOUPE = 2;
    private static final int MARGE = 4;

    private final List<Defaut> defauts = new ArrayList<>();
    private Camera camera = new Camera(COTE, COTE);

    private static Map<String, String> images() {
        Map<String, String> images = new LinkedHashMap<>();
        images.put("defaut-surface.png", "une surface s'ombre elle-même");
        images.put("defaut-lampe.png", "b² − 4ac, lampe à 10⁹");
        images.put("defaut-jumelle.png", "sphère jumelle gardée");
        return images;
    }

    /** Écrit les images de la page. @param args leur dossier */
    public static void main(String[] args) {
        dessiner().forEach((nom, image) -> new Ecriture<>(Paths.get(args[0], nom).toString(), new FichierPng()).ecrire(image));
    }

    /** Chaque image, par son nom : celle du défaut à gauche, celle du programme à droite. */
    public static Map<String, ImageMemoire> dessiner() {
        Map<String, Defaut> tous = new Defauts().tous().stream().collect(Collectors.toMap(d -> d.nom, d -> d));
        Map<String, ImageMemoire> dessins = new LinkedHashMap<>();
        IMAGES.forEach((nom, defaut) -> dessins.put(nom, tous.get(defaut).image()));
        return dessins;
    }

    public List<Defaut> tous() {
        Sphere boule = boule(0, 0, 5, 1.5, 1, 0);
        Scene scene = scene(Camera.OEIL, boule);
        noter("une surface s'ombre elle-même", scene, 0, naive(scene, Ombre.SANS_EXCLURE, 0), deLaLampe(boule, 1));
        epsilons();
        voisin();
        jumelle(boule);
        Scene deux = scene(Camera.OEIL, boule, boule(0, 0, -9, 2, 1, 0));
        noter("ombre d'un objet derrière la lampe", deux, 0, naive(deux, Ombre.SANS_DISTANCE, 0), deLaLampe(boule, 1));
        soleil();
        miroir();
        dedans();
        dos();
        Lancer lancer = new Lancer(scene, camera);
        noter("pixels vus en leur coin", scene, 0, image((xe, ye) -> lancer.getCouleurPixel(xe - 0.5, ye - 0.5, 0)),
                deLaLampe(boule, 1));
        limites();
        camera = new Camera(COTE_IMPAIR, COTE_IMPAIR);
        lampePosee();
        return defauts;
    }

    private static Sphere boule(double x, double y, double z, double r, double kd, double ks) {
        Sphere boule = new Sphere(new Point(x, y, z), r);
        boule.setKd(new Couleur(kd));
        boule.setKs(new Couleur(ks));
        return boule;
    }

    private static Scene scene(Point lampe, Sphere... boules) {
        return new Scene(Arrays.asList(boules), Collections.singletonList(new Lampe(lampe, new Couleur(1))));
    }

    private Analytique forme(Sphere boule) {
        return new Analytique(camera, boule.getCentre(), boule.getRayon());
    }

    private Vue deLaLampe(Sphere boule, double lampe) {
        return forme(boule).vueDeLaLampe(lampe);
    }

    /** Vue d'où l'on entre dans la sphère, ou d'où l'on en sort ; le ciel autour. */
    private Vue vue(Sphere boule, boolean sortie, Teinte teinte) {
        Analytique forme = forme(boule);
        return (xe, ye) -> {
            Vecteur V = forme.regard(xe, ye);
            return forme.touche(V) ? teinte.en(V, forme.normale(V, sortie)) : Analytique.ciel(V);
        };
    }

    private Couleur[] naive(Scene scene, Ombre ombre, double epsilon) {
        return image(new TraceurNaif(scene, camera, 0, ombre, epsilon));
    }

    /** Trop court pour un sol de 3·10¹⁰ de rayon, trop long pour ce qui est à 5·10⁻⁵ de l'écran. */
    private void epsilons() {
        double r = 1e11 / 3;
        Sphere sol = boule(0, -r - 1, 5, r, 0.8, 0);
        Scene grande = scene(Camera.OEIL, sol);
        noter("epsilon de 10⁻⁶, sol de rayon 3·10¹⁰", grande, 0, naive(grande, Ombre.SANS_EXCLURE, 1e-6), (xe, ye) -> {
            Vecteur V = forme(sol).regard(xe, ye);
            return V.y < 0 ? new Couleur(-0.8 * V.y) : Analytique.ciel(V);
        });
        Sphere proche = boule(0, 0, 100 + 5e-5, 100, 1, 0);
        Scene petite = scene(Camera.OEIL, proche);
        noter("epsilon de 10⁻⁴, boule à 5·10⁻⁵", petite, 0, naive(petite, Ombre.AUCUNE, 1e-4), deLaLampe(proche, 1));
    }

    /** L'écran est dans deux coques, à 10⁻⁵ l'une de l'autre ; la lampe, dehors, ne doit éclairer que la seconde. */
    private void voisin() {
        Scene scene = scene(new Point(0, 3, 12), boule(0, 0, 2, 4, 1, 0), boule(0, 0, 2, 4 + 1e-5, 1, 0));
        noter("départ exclu par la distance", scene, 0, naive(scene, Ombre.SANS_EXCLURE, 1e-4), (xe, ye) -> new Couleur());
    }

    private void jumelle(Sphere boule) {
        Scene scene = scene(Camera.OEIL, boule, boule(0, 0, 5, 1.5, 1, 0));
        // d'une classe dérivée, elle est gardée
        Scene gardee = scene(Camera.OEIL, boule, new Sphere(boule.getCentre(), boule.getRayon()) { });
        noter("sphère jumelle gardée", scene, 0, image(gardee, 0), deLaLampe(boule, 1));
    }

    /** Une lampe à un milliard : ses rayons sont parallèles. */
    private void soleil() {
        Vecteur soleil = new Vecteur(-1, 2, -3).normalized();
        Sphere boule = boule(0, 0, 5, 1, 0.75, 0);
        Scene scene = scene(new Point().add(soleil.mul(1e9)), boule);
        noter("b² − 4ac, lampe à 10⁹", scene, 0, naive(scene, Ombre.PREMIER_DU_MANUEL, 0),
                vue(boule, false, (V, N) -> new Couleur(0.75 * Math.max(0, N.dot(soleil)))));
    }

    private void miroir() {
        Sphere boule = boule(0, 0, 5, 1.5, 0, 0.5);
        Scene scene = new Scene(Collections.singletonList(boule), Collections.<Lampe>emptyList());
        noter("un miroir se réfléchit lui-même", scene, 1,
                image(new TraceurNaif(scene, camera, 1, Ombre.AUCUNE, 0)), vue(boule, false, (V, N) -> {
                    Vecteur R = V.sub(N.mul(2 * N.dot(V)));
                    // le ciel change d'un coup à l'horizon
                    return Math.abs(R.y) < 1e-9 ? null : Analytique.ciel(R).mul(0.5);
                }));
    }

    /** L'œil dans une sphère, une lampe au-dehors : on voit la paroi par où sort le regard. */
    private void dedans() {
        Sphere boule = boule(0, 0, 0, 9, 1, 0);
        Point lampe = new Point(0, 0, 20);
        Analytique forme = forme(boule);
        noter("première racine seule, vue du dedans", scene(lampe, boule), 0,
                image((xe, ye) -> Analytique.ciel(forme.regard(xe, ye))), vue(boule, true,
                    (V, N) -> new Couleur(Math.max(0, N.dot(new Vecteur(forme.point(N), lampe).normalized())))));
    }

    /** Un poli nul et une lampe derrière : (R·L)⁰ = 1 partout, mais la face que l'on voit ne reçoit rien. */
    private void dos() {
        Sphere boule = boule(0, 0, 5, 1.5, 0, 0.5);
        boule.setNs(0);
        noter("ns = 0 sans regarder N·L", scene(new Point(0, 0, 50), boule), 0,
                image(vue(boule, false, (V, N) -> new Couleur(0.5))), vue(boule, false, (V, N) -> new Couleur()));
    }

    /** Une lampe dix fois trop forte, neuf points par pixel : limiter chacun, ou leur moyenne. */
    private void limites() {
        Sphere boule = boule(0, 0, 6, 1.5, 1, 0);
        Scene scene = new Scene(Collections.singletonList(boule), Collections.singletonList(new Lampe(Camera.OEIL, new Couleur(10))));
        Vue points = deLaLampe(boule, 10);
        noter("limiter avant de moyenner", scene.avec(scene.getModele().avec(NEUF_POINTS, scene.getModele().getSeuil())), 0,
                image((xe, ye) -> moyenne(points, xe, ye, 1)), (xe, ye) -> moyenne(points, xe, ye, Double.MAX_VALUE));
    }

    private static Couleur moyenne(Vue vue, double xe, double ye, double limite) {
        Couleur somme = new Couleur();
        for (int k = 0; k < 9; k++) {
            Couleur c = vue.couleur(xe + (k % 3 - 1) / 3.0, ye + (k / 3 - 1) / 3.0);
            somme = somme.add(new Couleur(Math.min(limite, c.r), Math.min(limite, c.v), Math.min(limite, c.b)));
        }
        return somme.div(9);
    }

    /** La lampe est là où le pixel du milieu voit la boule : L = 0/0. Ailleurs, la boule lui tourne le dos. */
    private void lampePosee() {
        Sphere boule = boule(0, 0, 5, 1, 1, 0);
        Point lampe = new Point(0, 0, 4);
        noter("lampe posée sur une boule : 0/0", scene(lampe, boule), 0, image(vue(boule, false, (V, N) -> {
            Vecteur versLampe = new Vecteur(forme(boule).point(N), lampe);
            return new Couleur(Math.max(0, N.dot(versLampe.div(Math.sqrt(versLampe.norme2())))));
        })), vue(boule, false, (V, N) -> new Couleur()));
    }

    private void noter(String nom, Scene scene, int reflets, Couleur[] naive, Vue juste) {
        defauts.add(new Defaut(nom, camera.getLargeur(), image(juste), naive, image(scene.avec(scene.getModele().avecSeuil(0)), reflets)));
    }

    private Couleur[] image(Scene scene, int reflets) {
        int largeur = camera.getLargeur();
        Couleur[] image = new Couleur[largeur * camera.getHauteur()];
        new Lancer(scene, camera).TracerPixels((couleur, i, j) -> image[largeur * j + i] = couleur, reflets, 1);
        return image;
    }

    private Couleur[] image(Vue vue) {
        int largeur = camera.getLargeur();
        return IntStream.range(0, largeur * camera.getHauteur()).mapToObj(k -> vue.couleur(k % largeur + 0.5, k / largeur + 0.5))
                .toArray(Couleur[]::new);
    }

    /** Ce que montre l'écran, limité à [0, 1] ; NaN n'est jamais juste. */
    private static boolean differe(double attendu, double obtenu) {
        return !(Math.abs(Math.min(1, attendu) - Math.min(1, obtenu)) <= VISIBLE);
    }
}
