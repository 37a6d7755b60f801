package lancer.correction.jugement;

import java.io.BufferedReader;
import java.io.IOException;
import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Ce qu'on a déjà jugé, d'une fois à l'autre : un fichier de texte chacun, dans notre dossier de travail. Une valeur par
 * ligne : sa sorte, puis elle-même ; d'un de nos objets, sa classe, puis ses champs dans leur ordre.
 */
final class Souvenirs {

    private static final String PAQUET = Souvenirs.class.getPackageName() + ".";
    private static final char FIN_DE_LIGNE = '\u2028';

    private Souvenirs() {
    }

    /** @return {@code null} s'il n'y en a pas, ou s'il est d'une autre version */
    static Object relire(Path souvenir) {
        try (BufferedReader lignes = Files.newBufferedReader(souvenir)) {
            return lire(lignes);
        } catch (IOException | ReflectiveOperationException | RuntimeException e) {
            return null;
        }
    }

    static void ecrire(Path souvenir, Object valeur) throws IOException {
        StringBuilder texte = new StringBuilder();
        try {
            ecrire(valeur, texte);
        } catch (IllegalAccessException e) {
            throw new IllegalStateException(e);
        }
        // deux rendus identiques peuvent s'écrire en même temps
        Path neuf = Files.createTempFile(souvenir.getParent(), "neuf", null);
        Files.write(neuf, texte.toString().getBytes(StandardCharsets.UTF_8));
        Files.move(neuf, souvenir, StandardCopyOption.REPLACE_EXISTING);
    }

    private static void ecrire(Object valeur, StringBuilder texte) throws IllegalAccessException {
        List<Object> suite = new ArrayList<>();
        String ligne = String.valueOf(valeur).replace('\n', FIN_DE_LIGNE).replace('\r', ' ');
        String sorte = valeur == null ? "rien" : valeur.getClass().getSimpleName();
        if (valeur instanceof List) {
            sorte = "liste";
            suite.addAll((List<?>) valeur);
            ligne = "" + suite.size();
        } else if (valeur instanceof Map) {
            sorte = "table";
            ((Map<?, ?>) valeur).forEach((cle, element) -> suite.addAll(Arrays.asList(cle, element)));
            ligne = "" + suite.size() / 2;
        } else if (valeur instanceof float[]) {
            ByteBuffer octets = ByteBuffer.allocate(4 * ((float[]) valeur).length);
            octets.asFloatBuffer().put((float[]) valeur);
            ligne = Base64.getEncoder().encodeToString(octets.array());
        } else if (valeur instanceof byte[]) {
            ligne = Base64.getEncoder().encodeToString((byte[]) valeur);
        } else if (valeur != null && valeur.getClass().getName().startsWith(PAQUET) && !(valeur instanceof Enum)) {
            sorte = "objet";
            ligne = valeur.getClass().getName().substring(PAQUET.length());
            for (Field champ : champs(valeur.getClass())) {
                suite.add(champ.get(valeur));
            }
        }
        texte.append(sorte).append(' ').append(ligne).append('\n');
        for (Object element : suite) {
            ecrire(element, texte);
        }
    }

    private static Object lire(BufferedReader lignes) throws IOException, ReflectiveOperationException {
        String[] ligne = lignes.readLine().split(" ", 2);
        String suite = ligne[1];
        switch (ligne[0]) {
            case "liste":
                List<Object> liste = new ArrayList<>();
                for (int reste = Integer.parseInt(suite); reste > 0; reste--) {
                    liste.add(lire(lignes));
                }
                return liste;
            case "table":
                Map<Object, Object> table = new LinkedHashMap<>();
                for (int reste = Integer.parseInt(suite); reste > 0; reste--) {
                    Object cle = lire(lignes);
                    table.put(cle, lire(lignes));
                }
                return table;
            case "objet":
                Object objet = vide(Class.forName(PAQUET + suite));
                for (Field champ : champs(objet.getClass())) {
                    champ.set(objet, lire(lignes));
                }
                return objet;
            case "float[]":
                float[] reels = new float[suite.length() * 3 / 16];
                ByteBuffer.wrap(Base64.getDecoder().decode(suite)).asFloatBuffer().get(reels);
                return reels;
            case "byte[]":
                return Base64.getDecoder().decode(suite);
            case "Integer":
                return Integer.valueOf(suite);
            case "Double":
                return Double.valueOf(suite);
            case "Boolean":
                return Boolean.valueOf(suite);
            case "Etat":
                return Verdict.Etat.valueOf(suite);
            default:
                return ligne[0].equals("rien") ? null : suite.replace(FIN_DE_LIGNE, '\n');
        }
    }

    /** Un objet dont aucun constructeur n'a été appelé : le service qu'a le JDK pour qui relit des objets. */
    private static Object vide(Class<?> classe) throws ReflectiveOperationException {
        Class<?> usine = Class.forName("sun.reflect.ReflectionFactory");
        Constructor<?> constructeur = (Constructor<?>) usine.getMethod("newConstructorForSerialization", Class.class,
                Constructor.class).invoke(usine.getMethod("getReflectionFactory").invoke(null), classe,
                Object.class.getDeclaredConstructor());
        return constructeur.newInstance();
    }

    private static List<Field> champs(Class<?> classe) {
        List<Field> champs = new ArrayList<>(List.of(classe.getDeclaredFields()));
        champs.removeIf(c -> Modifier.isStatic(c.getModifiers()));
        champs.forEach(c -> c.setAccessible(true));
        return champs;
    }
}
