package lancer.correction;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledForJreRange;
import org.junit.jupiter.api.condition.JRE;
import org.junit.jupiter.api.io.TempDir;

/** Les deux programmes du cours, la base et le corrigé, répondent de même classe par classe : la première qui diffère est nommée. */
@EnabledForJreRange(min = JRE.JAVA_17)
class DeuxProgrammesTest {

    private static final int QUESTIONS = 200;
    private static final double TOLERANCE = 1e-9;

    @TempDir
    Path dossier;

    private ClassLoader programme;

    @Test
    void laBaseEtLeCorrigeSontDAccord() throws ReflectiveOperationException {
        assertEquals("", premiereQuiDiffere(new Programme(dossier)));
    }

    @Test
    void laClasseQuiDiffereEstNommee() throws ReflectiveOperationException {
        assertEquals("Vecteur", premiereQuiDiffere(new Programme(dossier).changer("Vecteur", "y * v.y", "0.9 * y * v.y")));
        assertEquals("Camera", premiereQuiDiffere(new Programme(dossier).changer("Camera", "(xe - ", "(xe + 0.5 - ")));
        assertEquals("Rayon", premiereQuiDiffere(new Programme(dossier).changer("Rayon", "1 - V.y", "0.9 - V.y")));
        assertEquals("Sphere", premiereQuiDiffere(new Programme(dossier).changer("Sphere", "new Vecteur(centre, contact)",
                "new Vecteur(contact, centre)")));
        assertEquals("Objet3D", premiereQuiDiffere(new Programme(dossier).changer("Objet3D", "new Couleur()", "new Couleur(0.01)")));
    }

    private String premiereQuiDiffere(Programme corrige) throws ReflectiveOperationException {
        Map<String, List<Double>> attendues = reponses(DeuxProgrammesTest.class.getClassLoader());
        Map<String, List<Double>> siennes = reponses(corrige.chargeur());
        for (String classe : attendues.keySet()) {
            for (int k = 0; k < attendues.get(classe).size(); k++) {
                double attendue = attendues.get(classe).get(k);
                double sienne = siennes.get(classe).get(k);
                if (attendue != sienne && !(Math.abs(attendue - sienne) <= TOLERANCE * (1 + Math.abs(attendue)))) {
                    return classe;
                }
            }
        }
        return "";
    }

    /** Les réponses de ces classes aux mêmes questions, chaque classe ne se servant que de celles qui précèdent. */
    private Map<String, List<Double>> reponses(ClassLoader celui) throws ReflectiveOperationException {
        programme = celui;
        Map<String, List<Double>> reponses = new LinkedHashMap<>();
        for (String classe : new String[] {"Vecteur", "Camera", "Rayon", "Sphere", "Scene", "Objet3D", "Lancer"}) {
            reponses.put(classe, new ArrayList<>());
        }
        SplittableRandom hasard = new SplittableRandom(9);
        List<Object> spheres = new ArrayList<>();
        for (int k = 0; k < 12; k++) {
            Object sphere = creer("Sphere", creer("Point", 4 * hasard.nextDouble() - 2, 4 * hasard.nextDouble() - 2,
                    4 + 4 * hasard.nextDouble()), 0.2 + hasard.nextDouble());
            if (k > 0) {
                appeler(sphere, "setKd", creer("Couleur", hasard.nextDouble(), hasard.nextDouble(), 0.2));
                appeler(sphere, "setKs", creer("Couleur", 0.3, hasard.nextDouble(), 0.5));
                appeler(sphere, "setNs", 1 + 50 * hasard.nextDouble());
            }
            spheres.add(sphere);
        }
        Object scene = creer("Scene", spheres, Arrays.asList(
                creer("Lampe", creer("Point", -3.0, 4.0, -2.0), creer("Couleur", 0.9, 0.8, 0.7)),
                creer("Lampe", creer("Point", 5.0, 1.0, 0.0), creer("Couleur", 0.2, 0.3, 0.4))));
        Object camera = creer("Camera", 40, 30);
        Object lancer = creer("Lancer", scene, camera);
        for (int k = 0; k < QUESTIONS; k++) {
            Object u = creer("Vecteur", hasard.nextDouble() - 0.5, hasard.nextDouble() - 0.5, hasard.nextDouble());
            Object v = creer("Vecteur", hasard.nextDouble(), hasard.nextDouble() - 0.5, 0.3);
            noter(reponses.get("Vecteur"), appeler(u, "normalized"), appeler(u, "dot", v), appeler(u, "add", v), appeler(u, "norme"));
            double xe = 40 * hasard.nextDouble();
            double ye = 30 * hasard.nextDouble();
            Object vu = appeler(camera, "getRayon", xe, ye);
            noter(reponses.get("Camera"), appeler(vu, "getP"), appeler(vu, "getV"));
            Object rayon = creer("Rayon", creer("Point", hasard.nextDouble(), hasard.nextDouble(), 0.0), u);
            noter(reponses.get("Rayon"), appeler(rayon, "getP"), appeler(rayon, "getV"), appeler(rayon, "getSkyColor"));
            Object sphere = spheres.get(k % spheres.size());
            noter(reponses.get("Sphere"), appeler(sphere, "getIntersectionDistance", rayon), appeler(sphere, "getNormale",
                    appeler(appeler(sphere, "getCentre"), "add", appeler(appeler(u, "normalized"), "mul", appeler(sphere, "getRayon")))));
            Object contact = appeler(scene, "getClosestIntersection", vu);
            noter(reponses.get("Scene"), contact == null ? -1.0 : contact, contact == null ? -1.0 : appeler(vu, "getDistance"));
            if (contact != null) {
                noter(reponses.get("Objet3D"), appeler(appeler(vu, "getObjet"), "getColor", scene, vu, contact, k % 4));
            }
            noter(reponses.get("Lancer"), appeler(lancer, "getCouleurPixel", xe, ye, k % 4));
        }
        return reponses;
    }

    private Object creer(String classe, Object... arguments) throws ReflectiveOperationException {
        for (Constructor<?> c : programme.loadClass("lancer." + classe).getConstructors()) {
            if (conviennent(c.getParameterTypes(), arguments)) {
                return c.newInstance(arguments);
            }
        }
        throw new NoSuchMethodException(classe + Arrays.toString(arguments));
    }

    private static Object appeler(Object objet, String methode, Object... arguments) throws ReflectiveOperationException {
        for (Method m : objet.getClass().getMethods()) {
            if (m.getName().equals(methode) && conviennent(m.getParameterTypes(), arguments)) {
                return m.invoke(objet, arguments);
            }
        }
        throw new NoSuchMethodException(objet.getClass() + "." + methode + Arrays.toString(arguments));
    }

    private static boolean conviennent(Class<?>[] types, Object[] arguments) {
        boolean conviennent = types.length == arguments.length;
        for (int k = 0; conviennent && k < types.length; k++) {
            conviennent = types[k].isInstance(arguments[k]) || types[k] == double.class && arguments[k] instanceof Double
                    || types[k] == int.class && arguments[k] instanceof Integer;
        }
        return conviennent;
    }

    /** Note ces nombres, ou les nombres de ces objets : coordonnées ou composantes. */
    private static void noter(List<Double> reponses, Object... objets) throws ReflectiveOperationException {
        for (Object objet : objets) {
            if (objet instanceof Double) {
                reponses.add((Double) objet);
                continue;
            }
            for (String nom : objet.getClass().getSimpleName().equals("Couleur") ? new String[] {"r", "v", "b"}
                    : new String[] {"x", "y", "z"}) {
                Class<?> classe = objet.getClass();
                while (Arrays.stream(classe.getDeclaredFields()).noneMatch(champ -> champ.getName().equals(nom))) {
                    classe = classe.getSuperclass();
                }
                Field champ = classe.getDeclaredField(nom);
                champ.setAccessible(true);
                reponses.add(champ.getDouble(objet));
            }
        }
    }
}
