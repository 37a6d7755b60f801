package lancer;

import java.io.PrintStream;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.FutureTask;
import java.util.function.Function;
import java.util.function.Supplier;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

/**
 * Rien n'est gardé d'un appel à l'autre : les mêmes questions sont posées à deux mondes, dans un ordre puis dans l'autre, et
 * une couleur est demandée au milieu d'une autre. Une réponse fausse, mais toujours la même, n'est pas une faute ici. L'échec
 * nomme la classe en cause. Ce fichier est donné : il n'y a rien à y changer.
 */
@Demande(classe = Object.class)
abstract class Repetition {

    static final String ETAPE = "repetition";

    /** Ce que {@link Causes} a trouvé avant toute autre vérification, {@code null} si ce n'est rien. */
    Supplier<Error> faute;

    @Test @DisplayName("la même question a toujours la même réponse, et rien ne s'affiche")
    void rienNEstGardeNiAffiche() {
        if (faute.get() != null) {
            throw faute.get();
        }
    }

    /** Les objets à qui les questions sont posées. */
    private static final class Monde extends Valeurs {

        {
            devantLaCamera();
        }

        final Point p = new Point(5, 4, -1);
        final Vecteur u = new Vecteur(1.5, 2, -0.25);
        final Vecteur v = new Vecteur(-3, 0.5, 4);
        final Sphere petite = boule(0, 0, 6, 1, gris, gris, 20);
        final Scene scene = new Scene(Arrays.asList(petite, boule(3, 0, 9, 2, gris, gris, 20)), Arrays.asList(new Lampe(p, BLANC) {
            @Override
            public Point getPosition() {
                CompletableFuture.runAsync(pendant).join();
                return super.getPosition();
            }
        }));
        final Camera camera = new Camera(40, 30);
        final Lancer lancer = new Lancer(scene, camera);
        /** Ce que fait un autre fil, une fois, au milieu du calcul d'une couleur. */
        FutureTask<?> pendant = new FutureTask<>(() -> null);

        /** Un rayon neuf, de l'œil vers un point de cette abscisse : une boule est à 0, l'autre à 2. */
        Rayon vers(double x) {
            return rayon(0, 0, 0, x, 0.25, 6);
        }

        Couleur couleur(double x) {
            Rayon rayon = vers(x);
            return petite.getColor(scene, rayon, scene.getClosestIntersection(rayon, null), 3);
        }
    }

    /** Les causes d'abord : de deux réponses qui changent, la première est dite. */
    private enum Question {

        DIFFERENCE(Vecteur.class, "sub", m -> m.u.sub(new Vecteur(0.75, -2, 5))),
        NORMALISE(Vecteur.class, "normalized", m -> m.v.norme2() + " " + m.v.normalized()),
        TRANSLATION(Point.class, "sub", m -> m.p.sub(new Vecteur(0.75, -2, 5))),
        DIRECTION(Rayon.class, "Rayon", m -> m.vers(0).getV()),
        DISTANCE(Sphere.class, "getIntersectionDistance", m -> m.petite.getIntersectionDistance(m.vers(0))),
        CONTACT(Scene.class, "getClosestIntersection", m -> m.scene.getClosestIntersection(m.vers(0), null)),
        AUTRE_CONTACT(Scene.class, "getClosestIntersection", m -> m.scene.getClosestIntersection(m.vers(2), m.petite)),
        NORMALE(Sphere.class, "getNormale", m -> m.petite.getNormale(new Point(0, 0, 5))),
        COULEUR(Objet3D.class, "getColor", m -> m.couleur(0)),
        RAYON(Camera.class, "getRayon", m -> m.camera.getRayon(3, 4).getV()),
        PIXELS(Lancer.class, "getCouleurPixel", m -> m.lancer.getCouleurPixel(19, 14, 2) + " " + m.lancer.getCouleurPixel(23, 12, 2)),
        PIXEL_DU_CIEL(Lancer.class, "getCouleurPixel", m -> m.lancer.getCouleurPixel(1, 1, 2));

        final Class<?> classe;
        final String methode;
        final Function<Monde, Object> reponse;

        Question(Class<?> classe, String methode, Function<Monde, Object> reponse) {
            this.classe = classe;
            this.methode = methode;
            this.reponse = reponse;
        }

        String poser(Monde monde) {
            try {
                return String.valueOf(reponse.apply(monde));
            } catch (RuntimeException | StackOverflowError e) {
                return e.getClass().getSimpleName();
            }
        }
    }

    /** @param ecoute où va ce qui s'affiche ; {@code null} si chaque appel est long, et passe par un autre programme */
    static void chercher(PrintStream ecoute) throws IllegalAccessException {
        Map<Field, String> avant = statiques();
        Monde un = new Monde();
        Monde deux = new Monde();
        System.setOut(ecoute == null ? System.out : ecoute);
        Map<Question, String> reponses = new EnumMap<>(Question.class);
        Arrays.asList(Question.values()).forEach(q -> reponses.put(q, q.poser(un)));
        Question changee = null;
        for (int n = Question.values().length - 1; n >= 0; n--) {
            Question q = Question.values()[n];
            // ce qu'une méthode garde de son premier appel n'est pas le même dans l'autre monde
            changee = q.poser(deux).equals(reponses.get(q)) && q.poser(un).equals(reponses.get(q)) ? changee : q;
        }
        Map<Field, String> apres = statiques();
        apres.entrySet().removeAll(avant.entrySet());
        for (Field champ : apres.keySet()) {
            throw new Demande.Garde("quelque chose est gardé dans un champ : " + champ.getName() + ", static : tous les objets ont le "
                    + "même", champ.getDeclaringClass());
        }
        if (changee != null) {
            throw new Demande.Garde("la réponse change d'un appel à l'autre : quelque chose est gardé dans un champ, "
                    + "ou dans ce qui sert au calcul", changee.classe, changee.methode);
        }
        un.pendant = ecoute == null ? un.pendant : new FutureTask<>(() -> un.couleur(0.5));
        if (!Question.COULEUR.poser(un).equals(reponses.get(Question.COULEUR))) {
            throw new Demande.Garde("la réponse change quand deux fils la demandent à la fois : quelque chose est "
                    + "gardé dans un champ", Objet3D.class, "getColor");
        }
    }

    /** Ce que contiennent les champs {@code static} qui peuvent changer. */
    private static Map<Field, String> statiques() throws IllegalAccessException {
        Map<Field, String> contenus = new LinkedHashMap<>();
        for (Question q : Question.values()) {
            for (Field champ : q.classe.getDeclaredFields()) {
                if (Modifier.isStatic(champ.getModifiers()) && !Modifier.isFinal(champ.getModifiers()) && !champ.isSynthetic()) {
                    champ.setAccessible(true);
                    contenus.put(champ, Arrays.deepToString(new Object[] {champ.get(null)}));
                }
            }
        }
        return contenus;
    }
}
