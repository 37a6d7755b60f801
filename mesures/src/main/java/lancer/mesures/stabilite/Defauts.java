package lancer.mesures.stabilite;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.antialias.Antialias;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;
import lancer.contrat.RechercheSimple;
import lancer.contrat.Vue;
import lancer.essai.Analytique;
import lancer.essai.RechercheNaive.Ombre;
import lancer.essai.RechercheNaive;
import lancer.mesures.trace.Style;

/**
 * De petites scènes dont la géométrie donne l'image, et une façon courante de la fausser. Les mêmes défauts sont dans les classes
 * {@code Limites…Test}, où chacun est expliqué.
 */
final class Defauts {

    /** La figure, dans le CSV : x = rang du défaut. */
    static final String FIGURE = "defauts";
    static final String PROGRAMME = "programme";

    /** Un demi-pas de l'écran : ce qui s'en écarte davantage se voit, ou peut se voir. */
    private static final double VISIBLE = 0.5 / 255;

    /** Nombre de pixels faux au-dessous duquel chacun est grossi. */
    private static final int RARES = 10;

    /** Au milieu d'une scène d'un côté pair, aucun pixel ne regarde exactement l'horizon. */
    private static final int COTE = 100;
    private static final int COTE_IMPAIR = 101;

    /** Une scène, ce que sa géométrie en donne, ce qu'en fait un défaut, et ce qu'en fait le programme. */
    static final class Defaut {

        /** Dans le CSV, puis en français. */
        final String cle;
        final String nom;
        private final int cote;
        private final Couleur[] attendue;
        private final Couleur[] naive;
        private final Couleur[] programme;

        Defaut(String cle, String nom, int cote, Couleur[] attendue, Couleur[] naive, Couleur[] programme) {
            this.cle = cle;
            this.nom = nom;
            this.cote = cote;
            this.attendue = attendue;
            this.naive = naive;
            this.programme = programme;
        }

        private Exactitude comparer(String methode, int rang, Couleur[] obtenue) {
            int juges = 0;
            int faux = 0;
            for (int k = 0; k < attendue.length; k++) {
                juges += attendue[k] != null ? 1 : 0;
                faux += estFaux(k, obtenue) ? 1 : 0;
            }
            return new Exactitude(FIGURE, methode, rang, 0, juges, faux, 0, 0);
        }

        private boolean estFaux(int k, Couleur[] obtenue) {
            return attendue[k] != null && (differe(attendue[k].r, obtenue[k].r) || differe(attendue[k].v, obtenue[k].v)
                    || differe(attendue[k].b, obtenue[k].b));
        }

        /** L'image juste, celle du défaut, et où celle-ci est fausse ; de rares pixels sont grossis. */
        BufferedImage image() {
            BufferedImage image = new BufferedImage(3 * cote + 4, cote, BufferedImage.TYPE_INT_RGB);
            Graphics2D g = image.createGraphics();
            g.setColor(Style.BANDE);
            g.fillRect(2 * cote + 4, 0, cote, cote);
            g.setColor(Style.VERMILLON);
            int bord = comparer(cle, 0, naive).faux < RARES ? 2 : 0;
            for (int k = 0; k < attendue.length; k++) {
                image.setRGB(k % cote, k / cote, programme[k].getCode());
                image.setRGB(k % cote + cote + 2, k / cote, naive[k].getCode());
                if (estFaux(k, naive)) {
                    g.fillRect(k % cote + 2 * cote + 4 - bord, k / cote - bord, 2 * bord + 1, 2 * bord + 1);
                }
            }
            return image;
        }
    }

    /** Ce que montre une sphère là où la direction V la rencontre, N y étant sa normale. */
    private interface Teinte {
        Couleur en(Vecteur V, Vecteur N);
    }

    private final List<Defaut> defauts = new ArrayList<>();
    private Camera camera = new Camera(COTE, COTE);

    List<Defaut> tous() {
        Sphere boule = boule(0, 0, 5, 1.5, 1, 0);
        Scene scene = scene(Camera.OEIL, boule);
        noter("acne", "une surface s'ombre elle-même", scene, 0, naive(scene, Ombre.SANS_EXCLURE, 0), deLaLampe(boule, 1));
        epsilons();
        voisin();
        jumelle(boule);
        Scene deux = scene(Camera.OEIL, boule, boule(0, 0, -9, 2, 1, 0));
        noter("au-dela", "ombre d'un objet derrière la lampe", deux, 0, naive(deux, Ombre.SANS_DISTANCE, 0), deLaLampe(boule, 1));
        soleil();
        miroir();
        dedans();
        dos();
        Lancer lancer = new Lancer(scene, camera);
        noter("demi-pixel", "pixels vus en leur coin", scene, 0, image((xe, ye) -> lancer.getCouleurPixel(xe - 0.5, ye - 0.5, 0)),
                deLaLampe(boule, 1));
        limites();
        camera = new Camera(COTE_IMPAIR, COTE_IMPAIR);
        lampePosee();
        return defauts;
    }

    /** De chacun, les pixels faux, puis ceux du programme. */
    static List<Exactitude> compter(List<Defaut> defauts) {
        List<Exactitude> exactitudes = new ArrayList<>();
        for (Defaut d : defauts) {
            int rang = exactitudes.size() / 2;
            exactitudes.add(d.comparer(d.cle, rang, d.naive));
            exactitudes.add(d.comparer(PROGRAMME, rang, d.programme));
        }
        return exactitudes;
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
        return naive(scene, 0, new RechercheNaive(scene.getObjets(), ombre, epsilon));
    }

    private Couleur[] naive(Scene scene, int reflets, Recherche recherche) {
        Scene naive = new Scene(scene.getObjets(), scene.getLampes());
        naive.setRecherche(recherche);
        naive.setSeuil(0);
        return image(naive, reflets);
    }

    /** Trop court pour un sol de 3·10¹⁰ de rayon, trop long pour ce qui est à 5·10⁻⁵ de l'écran. */
    private void epsilons() {
        double r = 1e11 / 3;
        Sphere sol = boule(0, -r - 1, 5, r, 0.8, 0);
        Scene grande = scene(Camera.OEIL, sol);
        noter("epsilon-court", "epsilon de 10⁻⁶, sol de rayon 3·10¹⁰", grande, 0, naive(grande, Ombre.SANS_EXCLURE, 1e-6), (xe, ye) -> {
            Vecteur V = forme(sol).regard(xe, ye);
            return V.y < 0 ? new Couleur(-0.8 * V.y) : Analytique.ciel(V);
        });
        Sphere proche = boule(0, 0, 100 + 5e-5, 100, 1, 0);
        Scene petite = scene(Camera.OEIL, proche);
        noter("epsilon-long", "epsilon de 10⁻⁴, boule à 5·10⁻⁵", petite, 0, naive(petite, Ombre.AUCUNE, 1e-4), deLaLampe(proche, 1));
    }

    /** L'écran est dans deux coques, à 10⁻⁵ l'une de l'autre ; la lampe, dehors, ne doit éclairer que la seconde. */
    private void voisin() {
        Scene scene = scene(new Point(0, 3, 12), boule(0, 0, 2, 4, 1, 0), boule(0, 0, 2, 4 + 1e-5, 1, 0));
        noter("voisin", "départ exclu par la distance", scene, 0, naive(scene, Ombre.SANS_EXCLURE, 1e-4), (xe, ye) -> new Couleur());
    }

    private void jumelle(Sphere boule) {
        Sphere jumelle = boule(0, 0, 5, 1.5, 1, 0);
        Scene scene = scene(Camera.OEIL, boule, jumelle);
        noter("jumelle", "sphère jumelle gardée", scene, 0,
                naive(scene, 0, new RechercheSimple(Arrays.<Objet3D>asList(boule, jumelle), new Compteurs())), deLaLampe(boule, 1));
    }

    /** Une lampe à un milliard : ses rayons sont parallèles. */
    private void soleil() {
        Vecteur soleil = new Vecteur(-1, 2, -3).normalized();
        Sphere boule = boule(0, 0, 5, 1, 0.75, 0);
        Scene scene = scene(new Point().add(soleil.mul(1e9)), boule);
        noter("lampe-lointaine", "b² − 4ac, lampe à 10⁹", scene, 0, naive(scene, Ombre.PREMIER_DU_MANUEL, 0),
                vue(boule, false, (V, N) -> new Couleur(0.75 * Math.max(0, N.dot(soleil)))));
    }

    private void miroir() {
        Sphere boule = boule(0, 0, 5, 1.5, 0, 0.5);
        Scene scene = new Scene(Collections.singletonList(boule), Collections.<Lampe>emptyList());
        noter("miroir", "un miroir se réfléchit lui-même", scene, 1,
                naive(scene, 1, new RechercheNaive(scene.getObjets(), Ombre.AUCUNE, 0)), vue(boule, false, (V, N) -> {
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
        noter("dedans", "première racine seule, vue du dedans", scene(lampe, boule), 0,
                image((xe, ye) -> Analytique.ciel(forme.regard(xe, ye))), vue(boule, true,
                    (V, N) -> new Couleur(Math.max(0, N.dot(new Vecteur(forme.point(N), lampe).normalized())))));
    }

    /** Un poli nul et une lampe derrière : (R·L)⁰ = 1 partout, mais la face que l'on voit ne reçoit rien. */
    private void dos() {
        Sphere boule = boule(0, 0, 5, 1.5, 0, 0.5);
        boule.setNs(0);
        noter("dos", "ns = 0 sans regarder N·L", scene(new Point(0, 0, 50), boule), 0,
                image(vue(boule, false, (V, N) -> new Couleur(0.5))), vue(boule, false, (V, N) -> new Couleur()));
    }

    /** Une lampe dix fois trop forte, neuf points par pixel : limiter chacun, ou leur moyenne. */
    private void limites() {
        Sphere boule = boule(0, 0, 6, 1.5, 1, 0);
        Scene scene = new Scene(Collections.singletonList(boule), Collections.singletonList(new Lampe(Camera.OEIL, new Couleur(10))));
        Vue points = deLaLampe(boule, 10);
        noter("limiter", "limiter avant de moyenner", scene.avec(Antialias.coins(3, 0), scene.getSeuil()), 0,
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
        noter("nan", "lampe posée sur une boule : 0/0", scene(lampe, boule), 0, image(vue(boule, false, (V, N) -> {
            Vecteur versLampe = new Vecteur(forme(boule).point(N), lampe);
            return new Couleur(Math.max(0, N.dot(versLampe.div(Math.sqrt(versLampe.norme2())))));
        })), vue(boule, false, (V, N) -> new Couleur()));
    }

    private void noter(String cle, String nom, Scene scene, int reflets, Couleur[] naive, Vue juste) {
        scene.setSeuil(0);
        defauts.add(new Defaut(cle, nom, camera.getLargeur(), image(juste), naive, image(scene, reflets)));
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
