package lancer.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.function.BiFunction;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.Camera;
import lancer.CameraPlacee;
import lancer.Constantes;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.SceneFautive;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.Forme;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.texte.Pile;
import lancer.texte.Texte;

/**
 * Les formes et les variantes présentes dans le chemin des classes, par type de section, en minuscules ; le passage
 * d'une section à son objet ou à sa lampe.
 */
public final class LecteurSections {

    private static final double LUMIERE_MAX = 1e6;
    private static final double NS_MAX = 1e9;

    /** Type de la section de la caméra, et les valeurs du champ, en degrés, l'une et l'autre exclues. */
    static final String CAMERA = "camera";
    private static final double CHAMP_MIN = 0;
    private static final double CHAMP_MAX = 180;

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

    /** Les clés de la matière, permises dans la section de toute forme. */
    public static final List<String> CLES_MATIERE =
            Collections.unmodifiableList(Arrays.asList("Kd", "Ks", "Kr", "ns"));

    final Map<String, Forme> formes = new LinkedHashMap<>();
    final Map<String, Variante> variantes = new LinkedHashMap<>();
    /** Les clés permises dans une section de chaque type, sauf celui d'une variante. */
    final Map<String, List<String>> cles = new LinkedHashMap<>();

    /** Le nom de la classe qui lit chaque type. */
    private final Map<String, String> preneurs = new HashMap<>();

    public static List<String> nomsDesVariantes() {
        return new LecteurSections().variantes.values().stream().map(Variante::getSection).collect(Collectors.toList());
    }

    /** @throws SceneFautive si une classe inscrite ne convient pas, ou si deux classes lisent le même type */
    LecteurSections() {
        ajouter(SPHERE, Sphere.class);
        cles.put(prendre("Lampe", Lampe.class), Arrays.asList("position", "couleur"));
        cles.put(prendre("Camera", Camera.class), Arrays.asList("oeil", "cible", "champ"));
        for (Variante variante : inscrites(Variante.class)) {
            variantes.put(prendre(variante.getSection(), variante.getClass()), variante);
        }
        for (Forme forme : inscrites(Forme.class)) {
            ajouter(forme, forme.getClass());
        }
    }

    private void ajouter(Forme forme, Class<?> lecteur) {
        String type = prendre(forme.getSection(), lecteur);
        formes.put(type, forme);
        List<String> siennes = new ArrayList<>(Arrays.asList(forme.getCles()));
        siennes.addAll(CLES_MATIERE);
        cles.put(type, siennes);
    }

    private static <T> List<T> inscrites(Class<T> contrat) {
        List<T> inscrites = new ArrayList<>();
        try {
            for (T inscrite : ServiceLoader.load(contrat, LecteurSections.class.getClassLoader())) {
                inscrites.add(inscrite);
            }
            return inscrites;
        } catch (ServiceConfigurationError e) {
            throw new SceneFautive("META-INF/services, ligne qui ne convient pas : " + Texte.echappe(e.getMessage()
                    + (e.getCause() == null ? "" : " (" + e.getCause() + ")"))
                    + " ; attendu : une classe publique de ce contrat, à constructeur public sans argument, ou cette "
                    + "ligne ôtée, puis make propre", e);
        }
    }

    /** Réserve un type de section à cette classe, la seule qui le lit. @return ce type, en minuscules */
    private String prendre(String type, Class<?> lecteur) {
        String classe = lecteur.getName();
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
        return Stream.of(formes.values().stream().map(Forme::getSection), Stream.of("Lampe", "Camera"),
                VARIANTES_CONNUES.stream(), variantes.values().stream().map(Variante::getSection))
                .flatMap(sections -> sections).distinct().collect(Collectors.joining(", "));
    }

    /** Le premier mot du nom d'une section. */
    static String mot(String nom) {
        return nom.indexOf(' ') < 0 ? nom : nom.substring(0, nom.indexOf(' '));
    }

    /** L'objet ou la lampe que décrit cette section. @throws SceneFautive si elle est refusée */
    Object lire(SectionLue section) {
        Forme forme = formes.get(Texte.minuscules(mot(section.nom)));
        if (forme == null) {
            return new Lampe(section.point("position"), section.couleur("couleur", LUMIERE_MAX));
        }
        try {
            Objet3D objet = forme.lire(section);
            if (objet == null || objet == forme) {
                throw new IllegalStateException("lire n'a pas rendu un objet neuf");
            }
            lireMatiere(section, objet);
            return objet;
        } catch (SceneFautive e) {
            throw e;
        } catch (RuntimeException e) {
            String classe = forme.getClass().getName();
            throw section.fautive(section.ligne, null, "section que " + classe + " ne sait pas lire : "
                    + Pile.cause(e, Pattern.quote(classe) + ".*"), "des valeurs qui lui conviennent");
        }
    }

    /** La caméra que place cette section, selon la largeur et la hauteur de l'image. */
    static BiFunction<Integer, Integer, Camera> lireCamera(SectionLue section) {
        double champ = section.reel("champ", Constantes.CHAMP, Math.nextUp(CHAMP_MIN), Math.nextDown(CHAMP_MAX));
        if (!section.contient("oeil") && !section.contient("cible")) {
            Point oeil = new Point(0, 0, -CameraPlacee.focale(champ));
            return (largeur, hauteur) -> new CameraPlacee(largeur, hauteur, oeil, new Vecteur(0, 0, 1), champ);
        }
        Point oeil = section.point("oeil");
        Vecteur axe = new Vecteur(oeil, section.point("cible"));
        if (axe.x == 0 && axe.z == 0) {
            throw section.fautive("cible", axe.y == 0 ? "l'œil est sur la cible" : "l'œil vise le long de l'axe y",
                    "une cible qui n'est ni sur l'œil, ni à sa verticale");
        }
        return (largeur, hauteur) -> new CameraPlacee(largeur, hauteur, oeil, axe, champ);
    }

    /** Lit la matière d'un objet. Une clé absente garde la valeur que l'objet a reçue à sa création. */
    private void lireMatiere(SectionLue section, Objet3D lu) {
        lu.setKd(section.couleur("Kd", lu.getKd(), 1));
        if (section.contient("Ks") && section.contient("Kr")) {
            throw section.fautive("Kr", "donnée en même temps que Ks, son synonyme", "Ks ou Kr, pas les deux");
        }
        lu.setKs(section.couleur(section.contient("Kr") ? "Kr" : "Ks", lu.getKs(), 1));
        lu.setNs(section.reel("ns", lu.getNs(), 0, NS_MAX));
    }
}
