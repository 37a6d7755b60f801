package lancer.scene;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.SceneFautive;
import lancer.Sphere;
import lancer.contrat.Forme;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.texte.Texte;

/** Les formes et les variantes présentes dans le chemin des classes, par type de section, en minuscules. */
public final class Services {

    /** Types des sections des trois variantes du projet, présentes ou non. */
    private static final List<String> VARIANTES_CONNUES = Arrays.asList("Brume", "Antialias", "Blinn");

    /** La sphère, forme de la base. Elle n'est dans aucun fichier de services. */
    private static final Forme SPHERE = new Forme() {
        @Override
        public String getSection() {
            return "Sphere";
        }

        @Override
        public String[] getCles() {
            return new String[] {"centre", "rayon"};
        }

        @Override
        public Objet3D lire(Section valeurs) {
            return new Sphere(valeurs.point("centre"), valeurs.longueur("rayon"));
        }
    };

    final Map<String, Forme> formes = new LinkedHashMap<>();
    final Map<String, Variante> variantes = new LinkedHashMap<>();

    private final Map<String, String> preneurs = new HashMap<>();

    public static List<String> nomsDesVariantes() {
        return new Services().variantes.values().stream().map(Variante::getSection).collect(Collectors.toList());
    }

    /** @throws SceneFautive si une classe inscrite ne convient pas, ou si deux classes lisent le même type */
    Services() {
        formes.put(prendre("Sphere", Sphere.class), SPHERE);
        prendre("Lampe", Lampe.class);
        for (Variante variante : inscrites(Variante.class)) {
            variantes.put(prendre(variante.getSection(), variante.getClass()), variante);
        }
        for (String connue : VARIANTES_CONNUES) {
            String type = Texte.minuscules(connue);
            preneurs.putIfAbsent(type, "la variante " + type);
        }
        for (Forme forme : inscrites(Forme.class)) {
            formes.put(prendre(forme.getSection(), forme.getClass()), forme);
        }
    }

    private static <T> List<T> inscrites(Class<T> contrat) {
        List<T> inscrites = new ArrayList<>();
        try {
            for (T inscrite : ServiceLoader.load(contrat, Services.class.getClassLoader())) {
                inscrites.add(inscrite);
            }
            return inscrites;
        } catch (ServiceConfigurationError e) {
            if (e.getCause() instanceof IOException) {
                // JDK-4523159
                throw new SceneFautive("META-INF/services ne peut être lu : Java n'ouvre pas un jar dont le dossier a "
                        + "un nom qui finit par « ! » ; attendu : le même jar dans un autre dossier", e);
            }
            if (e.getCause() != null && !(e.getCause() instanceof ReflectiveOperationException)) {
                // la classe convient : c'est son constructeur qui échoue
                throw e;
            }
            String dit = e.getMessage();
            if (dit.endsWith(" not found")) {
                // forme du message : « contrat: Provider classe not found »
                String[] mots = dit.split(" ");
                throw new SceneFautive("META-INF/services nomme une classe qui n'existe pas, "
                        + Texte.abrege(mots[mots.length - 3]) + " ; attendu : la classe, ou cette ligne ôtée ; si elle "
                        + "l'est, make propre efface ce qui en reste", e);
            }
            throw new SceneFautive("META-INF/services, ligne qui ne convient pas : " + Texte.echappe(dit)
                    + " ; attendu : une classe publique de ce contrat, à constructeur public sans argument", e);
        }
    }

    /** Réserve un type de section à cette classe, la seule qui le lit. @return ce type, en minuscules */
    private String prendre(String type, Class<?> lecteur) {
        String classe = lecteur.getName();
        if (type == null || type.isEmpty() || type.indexOf(' ') >= 0) {
            throw new SceneFautive(classe + " : type de section impossible : " + Texte.cite(String.valueOf(type))
                    + " ; attendu : un mot");
        }
        String deja = preneurs.putIfAbsent(Texte.minuscules(type), classe);
        if (deja != null) {
            throw new SceneFautive("deux classes veulent les sections [" + Texte.abrege(type) + "] : " + deja + " et "
                    + classe + " ; attendu : un type de section pour chacune");
        }
        return Texte.minuscules(type);
    }

    /** Dit si ce type est celui d'une des trois variantes du projet, présente ou non. */
    public static boolean varianteConnue(String type) {
        return VARIANTES_CONNUES.stream().anyMatch(connue -> connue.equalsIgnoreCase(type));
    }

    String types() {
        return Stream.of(formes.values().stream().map(Forme::getSection), Stream.of("Lampe"),
                VARIANTES_CONNUES.stream(), variantes.values().stream().map(Variante::getSection))
                .flatMap(sections -> sections).distinct().collect(Collectors.joining(", "));
    }
}
