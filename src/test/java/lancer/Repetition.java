package lancer;

import static org.junit.jupiter.api.Assertions.fail;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;

/**
 * Rien n'est gardé d'un appel à l'autre : chaque méthode du cours est demandée plusieurs fois, d'autres entre deux, et
 * une couleur pendant qu'un autre fil en demande une autre. Une réponse fausse, mais toujours la même, n'est pas une
 * faute ici. Ce fichier est donné : il n'y a rien à y changer.
 */
abstract class Repetition {

    static final String ETAPE = "repetition";

    /** Demandé une fois pour toutes les vérifications : voir {@link Causes}. */
    Supplier<Bilan> bilan;

    @Test @Order(1) @Demande(classe = Vecteur.class) @DisplayName("un vecteur répond toujours de même")
    void unVecteurNeGardeRien() {
        bilan.get().verifier(Vecteur.class);
    }

    @Test @Order(2) @Demande(classe = Point.class) @DisplayName("un point répond toujours de même")
    void unPointNeGardeRien() {
        bilan.get().verifier(Point.class);
    }

    @Test @Order(3) @Demande(classe = Rayon.class) @DisplayName("un rayon répond toujours de même")
    void unRayonNeGardeRien() {
        bilan.get().verifier(Rayon.class);
    }

    @Test @Order(4) @Demande(classe = Camera.class) @DisplayName("la caméra répond toujours de même")
    void laCameraNeGardeRien() {
        bilan.get().verifier(Camera.class);
    }

    @Test @Order(5) @Demande(classe = Sphere.class) @DisplayName("une sphère répond toujours de même")
    void uneSphereNeGardeRien() {
        bilan.get().verifier(Sphere.class);
    }

    @Test @Order(6) @Demande(classe = Scene.class) @DisplayName("une scène répond toujours de même")
    void laSceneNeGardeRien() {
        bilan.get().verifier(Scene.class);
    }

    @Test @Order(7) @Demande(classe = Objet3D.class) @DisplayName("un objet répond toujours de même")
    void unObjetNeGardeRien() {
        bilan.get().verifier(Objet3D.class);
    }

    @Test @Order(8) @Demande(classe = Lancer.class) @DisplayName("un pixel répond toujours de même")
    void unLancerNeGardeRien() {
        bilan.get().verifier(Lancer.class);
    }

    @Test @Order(9) @Demande(classe = Lancer.class) @DisplayName("un pixel n'affiche rien dans la console")
    void unPixelNAfficheRien() {
        if (bilan.get().affiche != null) {
            throw bilan.get().affiche;
        }
    }

    /** Une question à une méthode du cours, et sa réponse, qui doit toujours être la même. */
    private static final class Question {

        interface Reponse {
            Object demander(Monde monde);
        }

        private static final String ECHEC = "échec : ";

        final Class<?> classe;
        final String methode;
        final Reponse reponse;
        String premiere;

        Question(Class<?> classe, String methode, Reponse reponse) {
            this.classe = classe;
            this.methode = methode;
            this.reponse = reponse;
        }

        String poser(Monde monde) {
            try {
                return texte(reponse.demander(monde));
            } catch (RuntimeException | StackOverflowError e) {
                return ECHEC + e.getClass().getSimpleName();
            }
        }

        private static String contact(String lieu, PointContact contact) {
            return lieu + " à " + Valeurs.distance(contact) + (Valeurs.objet(contact) == null ? " de rien" : "");
        }

        private static String texte(Object o) {
            if (o instanceof Tuple) {
                Tuple t = (Tuple) o;
                String lieu = t.x + " " + t.y + " " + t.z;
                return o instanceof PointContact ? contact(lieu, (PointContact) o) : lieu;
            } else if (o instanceof Couleur) {
                Couleur c = (Couleur) o;
                return c.r + " " + c.v + " " + c.b;
            } else if (o instanceof Rayon) {
                return texte(((Rayon) o).getP()) + " " + texte(((Rayon) o).getV());
            }
            return String.valueOf(o);
        }
    }

    /** Les objets à qui les questions sont posées, les mêmes pour tous les fils, et la scène qu'un fil en fait. */
    private static final class Monde {

        private static final double[][] CENTRES = {{0, 0, 6}, {1.5, 0.5, 8}, {-1.5, 0.25, 7}, {0, -101, 6}};
        private static final double[] RAYONS = {1, 1, 0.75, 100};

        private final Point p = new Point(0.25, -0.5, 1);
        private final Point q = new Point(2, 1, -3.5);
        private final Vecteur u = new Vecteur(1.5, 2, -0.25);
        private final Vecteur w = new Vecteur(-3, 0.5, 4);
        private final List<Sphere> boules;
        private final Camera camera;
        private final Scene scene;
        private final Lancer lancer;
        private Rayon rayon;
        /** Ce qu'un autre fil fera au milieu du prochain calcul d'une couleur, {@code null} s'il ne fait rien. */
        private Runnable pendant;

        Monde() {
            this(IntStream.range(0, RAYONS.length).mapToObj(Monde::boule).collect(Collectors.toList()), new Camera(40, 30));
        }

        private Monde(List<Sphere> boules, Camera camera) {
            this.boules = boules;
            this.camera = camera;
            scene = new Scene(boules, Arrays.asList(lampe(-4, 6, -3), lampe(5, 4, 0)));
            lancer = new Lancer(scene, camera);
        }

        Monde pourUnFil() {
            return new Monde(boules, camera);
        }

        /** Tous ses objets, dont les champs pourraient garder quelque chose. */
        Stream<Object> objets() {
            return Stream.concat(boules.stream(), Stream.of(camera, scene, lancer));
        }

        /** Les points et les vecteurs que les questions emploient, et qu'aucune ne change. */
        String triplets() {
            return Stream.of(p, q, u, w).map(Question::texte).collect(Collectors.joining(" ; "));
        }

        /** D'autres objets : ceux d'un monde n'en savent rien. */
        Object autres() {
            Lampe rouge = new Lampe(p, new Couleur(1, 0, 0));
            Sphere verte = new Sphere(q, 3);
            verte.setKd(new Couleur(0, 1, 0));
            verte.setKs(new Couleur(0, 1, 0));
            verte.setNs(3);
            new Lancer(new Scene(Arrays.asList(verte), Arrays.asList(rouge)), new Camera(64, 48));
            return new Rayon(q, p);
        }

        /** Une lampe qui, avant de dire où elle est, laisse un autre fil faire ce qu'il a à faire. */
        private Lampe lampe(double x, double y, double z) {
            return new Lampe(new Point(x, y, z), new Couleur(0.75, 0.5, 0.25)) {
                @Override
                public Point getPosition() {
                    if (pendant != null) {
                        Thread autre = new Thread(pendant);
                        pendant = null;
                        autre.start();
                        try {
                            autre.join();
                        } catch (InterruptedException e) {
                            Thread.currentThread().interrupt();
                        }
                    }
                    return super.getPosition();
                }
            };
        }

        private static Sphere boule(int k) {
            Sphere boule = new Sphere(new Point(CENTRES[k][0], CENTRES[k][1], CENTRES[k][2]), RAYONS[k]);
            boule.setKd(new Couleur(0.5, 0.25, 0.75));
            boule.setKs(new Couleur(0.5, 0.75, 0.25));
            boule.setNs(20);
            return boule;
        }

        /** Un rayon qui ne sert à rien d'autre, fait une fois pour toutes. */
        Rayon rayon() {
            rayon = rayon == null ? new Rayon(p, w) : rayon;
            return rayon;
        }

        /** Un rayon neuf, vers la boule de ce rang ou un peu à côté. */
        Rayon rayon(int k) {
            double[] centre = CENTRES[k % 3];
            return new Rayon(new Point(0, 0, 0), new Vecteur(centre[0] + 0.1 * k, centre[1] + 0.2, centre[2]));
        }

        Couleur couleur(int k, int profondeur) {
            Rayon rayon = rayon(k);
            PointContact contact = scene.getClosestIntersection(rayon, null);
            return contact == null ? null : Valeurs.objet(contact).getColor(scene, rayon, contact, profondeur);
        }
    }

    private static List<Question> questions() {
        List<Question> toutes = new ArrayList<>(Arrays.asList(
                new Question(Vecteur.class, "Vecteur", m -> new Vecteur(m.p, m.q)),
                new Question(Vecteur.class, "sub", m -> m.u.sub(m.w)),
                new Question(Vecteur.class, "dot", m -> m.u.dot(m.w)),
                new Question(Vecteur.class, "norme2", m -> m.w.norme2()),
                new Question(Vecteur.class, "normalized", m -> m.w.normalized()),
                new Question(Vecteur.class, "normalize", m -> Vecteur.normalize(m.w)),
                new Question(Point.class, "sub", m -> m.p.sub(m.u)),
                new Question(Point.class, "sub", m -> m.p.sub(m.q)),
                new Question(Rayon.class, "Rayon", m -> m.rayon()),
                new Question(Rayon.class, "calcContact", m -> m.rayon().calcContact()),
                new Question(Rayon.class, "Rayon", m -> new Rayon(m.p, m.q)),
                new Question(Rayon.class, "getSkyColor", m -> m.rayon(0).getSkyColor()),
                new Question(Camera.class, "getRayon", m -> m.camera.getRayon(10.5, 20.25)),
                new Question(Camera.class, "getRayon", m -> m.camera.getRayon(3, 4))));
        for (int k = 0; k < 3; k++) {
            int q = k;
            toutes.add(new Question(Sphere.class, "getIntersectionDistance", m -> m.boules.get(q).getIntersectionDistance(m.rayon(q))));
            toutes.add(new Question(Sphere.class, "getIntersectionDistance",
                    m -> m.boules.get(q).getIntersectionDistance(m.rayon(q + 1))));
            toutes.add(new Question(Rayon.class, "calcContact", m -> {
                Rayon rayon = m.rayon(q);
                m.boules.get(q).getIntersectionDistance(rayon);
                return rayon.calcContact();
            }));
            toutes.add(new Question(Scene.class, "getClosestIntersection", m -> m.scene.getClosestIntersection(m.rayon(q), null)));
            toutes.add(new Question(Scene.class, "getClosestIntersection",
                    m -> m.scene.getClosestIntersection(m.rayon(q), m.boules.get(q))));
            toutes.add(new Question(Sphere.class, "getNormale", m -> m.boules.get(q).getNormale(m.q)));
            toutes.add(new Question(Objet3D.class, "getColor", m -> m.couleur(q, 3)));
            toutes.add(new Question(Objet3D.class, "getColor", m -> m.couleur(q, 0)));
            toutes.add(new Question(Lancer.class, "getCouleurPixel", m -> m.lancer.getCouleurPixel(10 + 7 * q, 14, 2)));
        }
        toutes.add(new Question(Lancer.class, "getCouleurPixel", m -> m.lancer.getCouleurPixel(1, 1, 1)));
        return toutes;
    }

    /** Ce que les répétitions ont montré. */
    static final class Bilan {

        /** Les classes du cours, les causes d'abord. */
        private static final List<Class<?>> CLASSES = Arrays.asList(Vecteur.class, Point.class, Rayon.class, Camera.class,
                Sphere.class, Scene.class, Objet3D.class, Lancer.class);

        /** Combien de fois chaque question est posée, selon qu'un champ change ou non. */
        private static final int FOIS = 400;
        private static final int FOIS_SANS_CHAMP = 3;

        /** La classe et la méthode dont une réponse change, {@code null} si aucune ne change. */
        Class<?> classe;
        String methode;
        String dit;
        /** La ligne qui affiche quelque chose dans un pixel, {@code null} si aucune ne le fait. */
        Error affiche;

        /** Rien n'a pu être demandé. */
        Bilan() {
        }

        /** @param ecoute où va ce qui s'affiche ; {@code null} si chaque appel est long, et passe par un autre programme */
        Bilan(Ecoute ecoute) {
            // ce qu'une méthode garde de son premier appel n'est pas la même chose dans ces deux mondes, où l'ordre est autre
            Monde[] mondes = {new Monde(), new Monde()};
            Map<Class<?>, Map<String, String>> avant = gardes(mondes);
            Map<Class<?>, Map<String, String>> apres = new HashMap<>(avant);
            List<Question> questions = questions();
            if (ecoute != null) {
                ecoute.ou = null;
            }
            for (Question question : questions) {
                String triplets = mondes[0].triplets();
                question.premiere = question.poser(mondes[0]);
                if (!triplets.equals(mondes[0].triplets())) {
                    dire(question, " : un vecteur ou un point qui sert au calcul en ressort changé ; attendu : un nouveau, et le "
                            + "premier intact");
                    return;
                }
            }
            affiche = ecoute == null ? null : ecoute.erreur();
            // d'autres vérifications le disent
            questions.removeIf(q -> q.premiere.startsWith(Question.ECHEC));
            List<Question> changees = new ArrayList<>();
            for (int fois = 1; fois < (apres.equals(avant) ? FOIS_SANS_CHAMP : FOIS) && changees.isEmpty(); fois++) {
                changees.addAll(changees(questions, mondes[fois % 2]));
                if (ecoute != null && fois < FOIS_SANS_CHAMP) {
                    apres.putAll(gardes(mondes));
                }
            }
            if (!changees.isEmpty()) {
                // celles qui étaient posées quand rien n'avait encore changé
                changees.addAll(changees(questions, mondes[0]));
            }
            String quand = "";
            if (!apres.equals(avant) && changees.isEmpty()) {
                aDeux(mondes[0], changees);
                quand = ", quand deux fils la demandent à la fois";
            }
            if (!changees.isEmpty()) {
                // la première dont la classe a un champ qui change, ou une classe qui en a un ; à défaut, la première
                changees.sort(Comparator.comparing(q -> CLASSES.indexOf(q.classe)));
                Question fautive = Stream.concat(changees.stream(), questions().stream())
                        .filter(q -> !apres.get(q.classe).equals(avant.get(q.classe))).findFirst().orElse(changees.get(0));
                dire(fautive, " : la réponse change d'un appel à l'autre" + quand + " : quelque chose est gardé dans un champ"
                        + noms(avant.get(fautive.classe), apres.get(fautive.classe)));
            }
        }

        private void dire(Question fautive, String quoi) {
            classe = fautive.classe;
            methode = fautive.methode;
            dit = classe.getSimpleName() + "." + methode + quoi;
        }

        /** Les champs dont le contenu change. */
        private static String noms(Map<String, String> avant, Map<String, String> apres) {
            List<String> noms = avant.keySet().stream().filter(c -> !avant.get(c).equals(apres.get(c))).collect(Collectors.toList());
            return noms.isEmpty() ? "" : " : " + String.join(", ", noms);
        }

        /** Les questions dont la réponse change, posées dans l'autre ordre. */
        private static List<Question> changees(List<Question> questions, Monde monde) {
            Collections.reverse(questions);
            new Question(Lancer.class, "new", Monde::autres).poser(monde);
            return questions.stream().filter(q -> !q.premiere.equals(q.poser(monde))).collect(Collectors.toList());
        }

        /** Au milieu du calcul d'une couleur, un autre fil en calcule une autre, de la même boule. */
        private static void aDeux(Monde monde, List<Question> changees) {
            for (int k = 0; k < 3; k++) {
                int q = k;
                Question couleur = new Question(Objet3D.class, "getColor", m -> m.couleur(q, 0));
                Question autre = new Question(Objet3D.class, "getColor", m -> m.couleur(q + 3, 0));
                couleur.premiere = couleur.poser(monde);
                monde.pendant = () -> autre.poser(monde.pourUnFil());
                if (!couleur.premiere.equals(couleur.poser(monde))) {
                    changees.add(couleur);
                }
            }
        }

        /** Ce que contiennent les champs de chaque classe du cours, et ceux des objets de ces mondes. */
        private static Map<Class<?>, Map<String, String>> gardes(Monde... mondes) {
            List<Object> objets = Arrays.stream(mondes).flatMap(Monde::objets).collect(Collectors.toList());
            Map<Class<?>, Map<String, String>> gardes = new HashMap<>();
            for (Class<?> classe : CLASSES) {
                Map<String, String> champs = new TreeMap<>();
                for (Field champ : classe.getDeclaredFields()) {
                    champ.setAccessible(true);
                    champs.put(champ.getName(), Modifier.isStatic(champ.getModifiers()) ? contenu(champ, null)
                            : objets.stream().filter(classe::isInstance).map(o -> contenu(champ, o)).collect(Collectors.joining(" ")));
                }
                gardes.put(classe, champs);
            }
            return gardes;
        }

        private static String contenu(Field champ, Object objet) {
            try {
                return Arrays.deepToString(new Object[] {champ.get(objet)});
            } catch (IllegalAccessException | RuntimeException | StackOverflowError e) {
                // ce qu'un champ ne sait pas dire
                return "";
            }
        }

        /** Échoue si une réponse de cette classe change. */
        void verifier(Class<?> laquelle) {
            if (laquelle == classe) {
                fail(dit);
            }
        }
    }

    /** Ce qui s'affiche n'y va pas : la ligne qui, la première, a affiché quelque chose est gardée. */
    static final class Ecoute extends PrintStream {

        private Throwable ou;

        Ecoute() {
            super(new ByteArrayOutputStream());
        }

        @Override
        public void write(byte[] octets, int debut, int combien) {
            ou = ou == null ? new Throwable() : ou;
        }

        private Error erreur() {
            if (ou == null) {
                return null;
            }
            Error erreur = new Error("dessiner un pixel affiche du texte dans la console : une image en a 480 000");
            erreur.setStackTrace(Arrays.stream(ou.getStackTrace()).filter(Causes::deLEtudiant).toArray(StackTraceElement[]::new));
            return erreur;
        }
    }
}
