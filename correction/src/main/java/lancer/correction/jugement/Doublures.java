package lancer.correction.jugement;

import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lancer.correction.enfant.Execution;
import lancer.correction.modele.SourcesDuCours;

/**
 * Écrit, d'après les classes du projet à compléter, deux sources qui se correspondent. La doublure de chaque classe sert à compiler les
 * vérifications, et s'exécute ici. {@code lancer.Appels} est compilée avec les classes de l'étudiant, et appelle chaque méthode publique
 * par son numéro. Chaque appel y est dans sa propre méthode : si une signature manque à l'étudiant, seul cet appel échoue.
 */
final class Doublures {

    /** Classes que les vérifications utilisent, une classe avant celles qui en dérivent. Une couleur est transmise par sa valeur. */
    private static final List<String> CLASSES = List.of("Couleur", "Tuple", "Point", "Vecteur", "PointContact", "Rayon",
            "Camera", "Lampe", "Objet3D", "Sphere", "Scene", "Lancer");

    private static final Set<Class<?>> SIMPLES = Set.of(double.class, int.class, boolean.class, Object.class,
            List.class);

    /** Les types qu'un appel rend dans un objet. */
    private static final Map<Class<?>, String> EN_OBJET = Map.of(void.class, "Object", double.class, "Double", int.class, "Integer",
            boolean.class, "Boolean");

    private static final String ENTETE = "package lancer;\nimport lancer.correction.jugement.Dialogue;\n";
    private static final String RECU = "Dialogue.Recu";

    /** Les vérifications, les doublures et les classes nécessaires, par nom complet. */
    final Map<String, String> sources = new LinkedHashMap<>();
    private final StringBuilder appels = new StringBuilder();
    private String noms = "";
    private String champs = "";
    private int nombre;

    /** @param classes les classes compilées du projet à compléter */
    Doublures(Map<String, byte[]> classes) {
        try {
            ClassLoader chargeur = new Execution.Classes(classes, ClassLoader.getPlatformClassLoader());
            SourcesDuCours.VERIFICATIONS.forEach(v -> sources.put(v, SourcesDuCours.ressource("modele/" + v + ".java")));
            // ses valeurs sont recopiées dans les classes qui l'emploient : ce sont elles qui sont jugées
            sources.put("lancer/Constantes", SourcesDuCours.corrige("Constantes"));
            for (String nom : CLASSES) {
                doubler(nom, chargeur.loadClass("lancer." + nom));
            }
        } catch (ClassNotFoundException e) {
            throw new IllegalStateException(e);
        }
    }

    /** La source de {@code lancer.Appels}. */
    String getAppels() {
        return SourcesDuCours.ressource("Appels.txt").replace("NOMS", noms).replace("CHAMPS", champs).replace("APPELS", appels);
    }

    private void doubler(String nom, Class<?> classe) {
        // les champs de la classe mère d'abord : leurs rangs sont les mêmes dans toutes ses classes filles
        List<Field> publics = Arrays.stream(classe.getFields()).filter(f -> !Modifier.isStatic(f.getModifiers()))
                .sorted(Comparator.comparing(f -> f.getDeclaringClass() == classe)).collect(Collectors.toList());
        noms = "if (o instanceof " + nom + ") return \"" + nom + "\";\n" + noms;
        if (!publics.isEmpty()) {
            String noms = publics.stream().map(c -> "\"" + c.getName() + "\"").collect(Collectors.joining(", "));
            champs = "if (o instanceof " + nom + ") try { return champs((" + nom + ") o); } catch (Error e) { return lire(o, e, " + noms
                    + "); }\n" + champs;
            appels.append("static Object[] champs(" + nom + " o) { return new Object[] {" + publics.stream()
                    .map(c -> "o." + c.getName()).collect(Collectors.joining(", ")) + "}; }\n");
        }
        if (nom.equals("Couleur")) {
            // seul son code est demandé à celle du rendu
            int code = numeroter("couleur(a[0]).getCode()", false);
            sources.put("lancer/" + nom, SourcesDuCours.corrige(nom).replaceFirst("(int getCode\\(\\) \\{)[^}]*",
                    "$1 return lancer.correction.jugement.Dialogue.appeler(Integer.class, " + code + ", java.util.List.of(r, v, b)); "));
            return;
        }
        StringBuilder relire = new StringBuilder();
        StringBuilder source = new StringBuilder(ENTETE + "import java.util.List;\npublic class " + nom + " extends "
                + (classe.getSuperclass() == Object.class ? "Dialogue.Doublure"
                : classe.getSuperclass().getSimpleName()) + " {\npublic " + nom + "(" + RECU + " r) { super(r); }\n");
        for (int k = 0; k < publics.size(); k++) {
            Field champ = publics.get(k);
            if (champ.getDeclaringClass() == classe) {
                String type = champ.getType().getSimpleName();
                source.append("public " + type + " " + champ.getName() + ";\n");
                relire.append(champ.getName() + " = " + (champ.getType() == double.class ? "r.reel(\"" + nom + "\", "
                        + k + ")" : "r.champ(" + type + ".class, " + k + ")") + ";\n");
            }
        }
        source.append("@Override protected void relire(" + RECU + " r) {\nsuper.relire(r);\n" + relire + "}\n");
        for (Constructor<?> c : classe.getConstructors()) {
            if (!Modifier.isAbstract(classe.getModifiers()) && passent(c)) {
                // le cours ne demande pas le constructeur d'une scène par deux listes
                boolean listes = nom.equals("Scene") && c.getParameterTypes()[0] == List.class;
                int numero = numeroter((listes ? "scene(" : "new " + nom + "(") + passes(c, 0) + ")", false);
                source.append("public " + nom + "(" + parametres(c) + ") { this(Dialogue.appeler(" + RECU + ".class, "
                        + numero + arguments(c) + ")); }\n");
            }
        }
        Method[] methodes = classe.getDeclaredMethods();
        Arrays.sort(methodes, Comparator.comparing(Method::toString));
        for (Method m : methodes) {
            Class<?> rend = m.getReturnType();
            if (Modifier.isPublic(m.getModifiers()) && !m.isSynthetic() && passent(m)
                    && (rend == void.class || rend == String.class || passe(rend))) {
                source.append(methode(nom, m, rend));
            }
        }
        sources.put("lancer/" + nom, source + "}\n");
    }

    private String methode(String nom, Method m, Class<?> rend) {
        boolean statique = Modifier.isStatic(m.getModifiers());
        String sur = statique ? nom : "((" + nom + ") a[0])";
        int numero = numeroter(sur + "." + m.getName() + "(" + passes(m, statique ? 0 : 1) + ")", rend == void.class);
        String type = rend.getSimpleName();
        String passe = (statique ? "" : ", this") + arguments(m);
        String appel = "Dialogue.appeler(" + EN_OBJET.getOrDefault(rend, type) + ".class, " + numero + passe + ")";
        return "public " + Modifier.toString(m.getModifiers() & Modifier.STATIC) + " " + type + " " + m.getName() + "(" + parametres(m)
                + ") { " + (rend == void.class ? appel : "return " + appel) + "; }\n";
    }

    /** Ajoute un appel. @return son numéro */
    private int numeroter(String appel, boolean muet) {
        appels.append("public static Object m" + nombre + "(Object[] a) throws Throwable { " + (muet ? appel + "; return null"
                : "return " + appel) + "; }\n");
        return nombre++;
    }

    private static boolean passe(Class<?> type) {
        return SIMPLES.contains(type) || CLASSES.contains(type.getSimpleName());
    }

    private static boolean passent(Executable e) {
        return Arrays.stream(e.getParameterTypes()).allMatch(Doublures::passe);
    }

    /** Les arguments d'un appel, lus dans le tableau {@code a}. */
    private static String passes(Executable e, int premier) {
        return chacun(e, (type, k) -> (type.equals("Couleur") ? "couleur(a[" : "(" + type + ") (a[") + (premier + k) + "])")
                .collect(Collectors.joining(", "));
    }

    private static String parametres(Executable e) {
        return chacun(e, (type, k) -> type + " a" + k).collect(Collectors.joining(", "));
    }

    private static String arguments(Executable e) {
        return chacun(e, (type, k) -> ", a" + k + (type.equals("Couleur") ? " == null ? null : List.of(a" + k + ".r, a" + k + ".v, a" + k
                + ".b)" : "")).collect(Collectors.joining());
    }

    private static Stream<String> chacun(Executable e, BiFunction<String, Integer, String> ecrire) {
        return IntStream.range(0, e.getParameterCount()).mapToObj(k -> ecrire.apply(e.getParameterTypes()[k].getSimpleName(), k));
    }
}
