package lancer;

import static org.junit.jupiter.api.Assertions.fail;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Tag;
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

    @Test @Order(1) @Tag("Vecteur") @DisplayName("un vecteur répond toujours de même")
    void unVecteurNeGardeRien() {
        bilan.get().verifier("Vecteur");
    }

    @Test @Order(2) @Tag("Point") @DisplayName("un point répond toujours de même")
    void unPointNeGardeRien() {
        bilan.get().verifier("Point");
    }

    @Test @Order(3) @Tag("Rayon") @DisplayName("un rayon répond toujours de même")
    void unRayonNeGardeRien() {
        bilan.get().verifier("Rayon");
    }

    @Test @Order(4) @Tag("Camera") @DisplayName("la caméra répond toujours de même")
    void laCameraNeGardeRien() {
        bilan.get().verifier("Camera");
    }

    @Test @Order(5) @Tag("Sphere") @DisplayName("une sphère répond toujours de même")
    void uneSphereNeGardeRien() {
        bilan.get().verifier("Sphere");
    }

    @Test @Order(6) @Tag("Scene") @DisplayName("une scène répond toujours de même")
    void laSceneNeGardeRien() {
        bilan.get().verifier("Scene");
    }

    @Test @Order(7) @Tag("Objet3D") @DisplayName("un objet répond toujours de même")
    void unObjetNeGardeRien() {
        bilan.get().verifier("Objet3D");
    }

    @Test @Order(8) @Tag("Lancer") @DisplayName("un pixel répond toujours de même")
    void unLancerNeGardeRien() {
        bilan.get().verifier("Lancer");
    }

    @Test @Order(9) @Tag("Lancer") @DisplayName("un pixel n'affiche rien dans la console")
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

        final String classe;
        final String methode;
        final Reponse reponse;
        String premiere;

        Question(String classe, String methode, Reponse reponse) {
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
            return lieu + " à " + contact.distance + (contact.objet == null ? " de rien" : "");
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
        private static final Point P = new Point(0.25, -0.5, 1);
        private static final Point Q = new Point(2, 1, -3.5);
        private static final Vecteur U = new Vecteur(1.5, 2, -0.25);
        private static final Vecteur W = new Vecteur(-3, 0.5, 4);

        private final List<Sphere> boules;
        private final Camera camera;
        private final Scene scene;
        private final Lancer lancer;
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

        /** Un rayon neuf, vers la boule de ce rang ou un peu à côté. */
        Rayon rayon(int k) {
            double[] centre = CENTRES[k % 3];
            return new Rayon(new Point(0, 0, 0), new Vecteur(centre[0] + 0.1 * k, centre[1] + 0.2, centre[2]));
        }

        Couleur couleur(int k, int profondeur) {
            Rayon rayon = rayon(k);
            PointContact contact = scene.getClosestIntersection(rayon, null);
            return contact == null ? null : contact.objet.getColor(scene, rayon, contact, profondeur);
        }
    }

    private static List<Question> questions() {
        List<Question> toutes = new ArrayList<>(Arrays.asList(
                new Question("Vecteur", "Vecteur", m -> new Vecteur(Monde.P, Monde.Q)),
                new Question("Vecteur", "sub", m -> Monde.U.sub(Monde.W)),
                new Question("Vecteur", "dot", m -> Monde.U.dot(Monde.W)),
                new Question("Vecteur", "norme2", m -> Monde.W.norme2()),
                new Question("Vecteur", "normalized", m -> Monde.W.normalized()),
                new Question("Vecteur", "normalize", m -> Vecteur.normalize(Monde.W)),
                new Question("Point", "sub", m -> Monde.P.sub(Monde.U)),
                new Question("Point", "sub", m -> Monde.P.sub(Monde.Q)),
                new Question("Rayon", "<init>", m -> new Rayon(Monde.P, Monde.Q)),
                new Question("Rayon", "<init>", m -> new Rayon(Monde.P, Monde.W)),
                new Question("Rayon", "getSkyColor", m -> m.rayon(0).getSkyColor()),
                new Question("Camera", "getRayon", m -> m.camera.getRayon(10.5, 20.25)),
                new Question("Camera", "getRayon", m -> m.camera.getRayon(3, 4))));
        for (int k = 0; k < 3; k++) {
            int q = k;
            toutes.add(new Question("Sphere", "getIntersectionDistance", m -> m.boules.get(q).getIntersectionDistance(m.rayon(q))));
            toutes.add(new Question("Sphere", "getIntersectionDistance", m -> m.boules.get(q).getIntersectionDistance(m.rayon(q + 1))));
            toutes.add(new Question("Rayon", "calcContact", m -> {
                Rayon rayon = m.rayon(q);
                m.boules.get(q).getIntersectionDistance(rayon);
                return rayon.calcContact();
            }));
            toutes.add(new Question("Scene", "getClosestIntersection", m -> m.scene.getClosestIntersection(m.rayon(q), null)));
            toutes.add(new Question("Sphere", "getNormale", m -> m.boules.get(q).getNormale(Monde.Q)));
            toutes.add(new Question("Objet3D", "getColor", m -> m.couleur(q, 3)));
            toutes.add(new Question("Objet3D", "getColor", m -> m.couleur(q, 0)));
            toutes.add(new Question("Lancer", "getCouleurPixel", m -> m.lancer.getCouleurPixel(10 + 7 * q, 14, 2)));
        }
        return toutes;
    }

    /** Ce que les répétitions ont montré. */
    static final class Bilan {

        /** Les classes du cours, les causes d'abord, et leurs champs qui changent. */
        private static final List<String> CLASSES =
                Arrays.asList("Vecteur", "Point", "Rayon", "Camera", "Sphere", "Scene", "Objet3D", "Lancer");
        private static final List<String> DU_COURS =
                Arrays.asList("Objet3D.Kd", "Objet3D.Ks", "Objet3D.ns", "Rayon.distance", "Rayon.objet");

        /** Combien de fois chaque question est posée, selon qu'un champ peut changer ou non. */
        private static final int FOIS = 200;
        private static final int FOIS_SANS_CHAMP = 3;

        /** La classe et la méthode dont une réponse change, {@code null} si aucune ne change. */
        final String classe;
        final String methode;
        final String dit;
        /** La ligne qui affiche quelque chose dans un pixel, {@code null} si aucune ne le fait. */
        Error affiche;

        /** Rien n'a pu être demandé. */
        Bilan() {
            classe = null;
            methode = null;
            dit = null;
        }

        /** @param ici faux si chaque appel est long, et passe par un autre programme */
        Bilan(boolean ici) {
            Question fautive = null;
            String quand = "";
            Monde monde = new Monde();
            List<Question> questions = questions();
            questions.forEach(q -> q.premiere = q.poser(monde));
            // d'autres vérifications le disent
            questions.removeIf(q -> q.premiere.startsWith(Question.ECHEC));
            boolean champ = ici && CLASSES.stream().anyMatch(Bilan::peutChanger);
            for (int fois = 1; fois < (champ ? FOIS : FOIS_SANS_CHAMP) && fautive == null; fois++) {
                Collections.reverse(questions);
                fautive = fautive(questions.stream().filter(q -> !q.premiere.equals(q.poser(monde))).collect(Collectors.toList()));
            }
            if (champ && fautive == null) {
                fautive = aDeux(monde);
                quand = ", quand deux fils la demandent à la fois";
            }
            if (ici) {
                ecouter(monde);
            }
            classe = fautive == null ? null : fautive.classe;
            methode = fautive == null ? null : fautive.methode;
            dit = fautive == null ? null : classe + "." + methode.replace("<init>", "Rayon")
                    + " : la réponse change d'un appel à l'autre" + quand + " : quelque chose est gardé dans un champ" + champs();
        }

        /**
         * La faute de ces changements : la première, dans l'ordre des causes, dont la classe a un champ qui puisse
         * changer, ou une classe qui a un tel champ ; à défaut, la première.
         */
        private static Question fautive(List<Question> changees) {
            if (changees.isEmpty()) {
                return null;
            }
            List<Question> candidates = new ArrayList<>(changees);
            candidates.addAll(questions());
            for (String classe : CLASSES) {
                for (Question q : candidates) {
                    if (q.classe.equals(classe) && !champs(classe).isEmpty()) {
                        return q;
                    }
                }
            }
            return changees.stream().min(Comparator.comparing(q -> CLASSES.indexOf(q.classe))).get();
        }

        /** Au milieu du calcul d'une couleur, un autre fil en calcule une autre, de la même boule. */
        private static Question aDeux(Monde monde) {
            List<Question> changees = new ArrayList<>();
            for (int k = 0; k < 3; k++) {
                int q = k;
                Question couleur = new Question("Objet3D", "getColor", m -> m.couleur(q, 0));
                Question autre = new Question("Objet3D", "getColor", m -> m.couleur(q + 3, 0));
                couleur.premiere = couleur.poser(monde);
                monde.pendant = () -> autre.poser(monde.pourUnFil());
                if (!couleur.premiere.equals(couleur.poser(monde))) {
                    changees.add(couleur);
                }
            }
            return fautive(changees);
        }

        /** Dessine quelques pixels en écoutant la sortie. */
        private void ecouter(Monde monde) {
            PrintStream sortie = System.out;
            Throwable[] ou = new Throwable[1];
            System.setOut(new PrintStream(new ByteArrayOutputStream()) {
                @Override
                public void write(byte[] octets, int debut, int combien) {
                    ou[0] = ou[0] == null ? new Throwable() : ou[0];
                }
            });
            try {
                for (int xe = 0; xe < 40; xe += 3) {
                    monde.lancer.getCouleurPixel(xe, 15, 1);
                }
            } catch (RuntimeException | StackOverflowError e) {
                // d'autres vérifications le disent
            } finally {
                System.setOut(sortie);
            }
            if (ou[0] != null) {
                affiche = new Error("dessiner un pixel affiche du texte dans la console : une image en a 480 000");
                affiche.setStackTrace(Arrays.stream(ou[0].getStackTrace()).filter(Causes::deLEtudiant).toArray(StackTraceElement[]::new));
            }
        }

        /** Les champs de cette classe qui peuvent changer, sans ceux du cours. */
        private static List<String> champs(String classe) {
            List<String> noms = new ArrayList<>();
            try {
                for (Field champ : Class.forName("lancer." + classe, false, Bilan.class.getClassLoader()).getDeclaredFields()) {
                    if (!Modifier.isFinal(champ.getModifiers()) && !champ.isSynthetic()
                            && !DU_COURS.contains(classe + "." + champ.getName())) {
                        noms.add(champ.getName());
                    }
                }
            } catch (ClassNotFoundException e) {
                // une classe renommée ne se compilerait pas avec Tests
            }
            return noms;
        }

        /** Dit si cette classe a un champ qui puisse changer, même si son nom désigne toujours le même tableau. */
        private static boolean peutChanger(String classe) {
            try {
                return !champs(classe).isEmpty() || Arrays.stream(Class.forName("lancer." + classe, false, Bilan.class.getClassLoader())
                        .getDeclaredFields()).anyMatch(c -> c.getType().isArray() || Modifier.isStatic(c.getModifiers())
                        && (Collection.class.isAssignableFrom(c.getType()) || Map.class.isAssignableFrom(c.getType())));
            } catch (ClassNotFoundException e) {
                return false;
            }
        }

        private String champs() {
            List<String> noms = champs(classe);
            return noms.isEmpty() ? "" : " : " + String.join(", ", noms);
        }

        /** Échoue si une réponse de cette classe change. */
        void verifier(String laquelle) {
            if (laquelle.equals(classe)) {
                fail(dit);
            }
        }
    }
}
