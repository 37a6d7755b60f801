package lancer.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import lancer.Camera;
import lancer.CameraPlacee;
import lancer.Constantes;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.SceneFautive;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.Cause;
import lancer.contrat.Forme;
import lancer.contrat.Variante;
import lancer.texte.Texte;

/**
 * Les types de sections d'un fichier de scène : ceux de la base, ceux des formes et des variantes présentes dans le
 * chemin des classes. Une section devient un objet, une lampe, la caméra ou les valeurs d'une variante.
 */
public final class LecteurSections {

    private static final double LUMIERE_MAX = 1e6;
    private static final double NS_MAX = 1e9;

    /** Le plus grand champ de la caméra, en degrés, exclu. */
    private static final double CHAMP_MAX = 180;

    /** Les clés de la matière, permises dans la section de toute forme. */
    public static final List<String> CLES_MATIERE =
            Collections.unmodifiableList(Arrays.asList("Kd", "Ks", "Kr", "ns"));

    /** Un type de section. */
    static final class Type {
        final String nom;
        /** La classe qui le lit ; {@code null} si elle est absente : la section est alors laissée de côté. */
        final Class<?> classe;
        /** Les clés permises ; {@code null} pour une variante : celles qu'elle demandera. */
        final List<String> cles;
        /** Vrai si un fichier n'en a qu'une section. */
        final boolean unique;
        /** Ajoute à la scène ce que dit une section. */
        final BiConsumer<SectionLue, SceneLue> lecture;

        Type(String nom, Class<?> classe, List<String> cles, BiConsumer<SectionLue, SceneLue> lecture) {
            this.nom = nom;
            this.classe = classe;
            this.cles = cles;
            unique = cles == null || classe == Camera.class;
            this.lecture = lecture;
        }
    }

    private static LecteurSections unique;

    private final Map<String, Type> types = new LinkedHashMap<>();
    /** Les variantes présentes, les mêmes pour toutes les lectures. */
    final List<Variante> variantes = inscrites(Variante.class);

    private LecteurSections() {
        ajouter(new Type("Sphere", Sphere.class, avecMatiere("centre", "rayon"), LecteurSections::lireSphere));
        ajouter(new Type("Lampe", Lampe.class, Arrays.asList("position", "couleur"), LecteurSections::lireLampe));
        ajouter(new Type("Camera", Camera.class, Arrays.asList("oeil", "cible", "champ"),
                (section, lue) -> lue.cadrage = lireCamera(section)));
        for (String absente : Arrays.asList("Brume", "Antialias", "Blinn")) {
            ajouter(new Type(absente, null, null, (section, lue) -> laisser(absente, section, lue)));
        }
        for (Variante variante : variantes) {
            ajouter(new Type(variante.getSection(), variante.getClass(), null,
                    (section, lue) -> lue.variantes.put(variante, section)));
        }
        for (Forme forme : inscrites(Forme.class)) {
            ajouter(new Type(forme.getSection(), forme.getClass(), avecMatiere(forme.getCles()),
                    (section, lue) -> lireForme(forme, section, lue)));
        }
    }

    /** @throws SceneFautive si une classe inscrite ne convient pas, ou si deux classes lisent le même type */
    static synchronized LecteurSections getUnique() {
        unique = unique == null ? new LecteurSections() : unique;
        return unique;
    }

    public static List<String> nomsDesVariantes() {
        return getUnique().variantes.stream().map(Variante::getSection).collect(Collectors.toList());
    }

    /** Dit si ce type est celui d'une variante, présente, ou du projet. */
    public static boolean estUneVariante(String type) {
        Type connu = getUnique().trouver(type);
        return connu != null && connu.cles == null;
    }

    private static List<String> avecMatiere(String... cles) {
        List<String> toutes = new ArrayList<>(Arrays.asList(cles));
        toutes.addAll(CLES_MATIERE);
        return toutes;
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

    /** Ajoute ce type, qu'une seule classe lit. */
    private void ajouter(Type type) {
        Type deja = types.put(Texte.minuscules(type.nom), type);
        if (deja != null && deja.classe != null) {
            throw new SceneFautive("deux classes veulent les sections [" + Texte.abrege(type.nom) + "] : "
                    + deja.classe.getName() + " et " + type.classe.getName()
                    + " ; attendu : un type de section pour chacune");
        }
    }

    /** Le type de ce nom, quelle que soit sa casse ; {@code null} s'il est inconnu. */
    Type trouver(String nom) {
        return types.get(Texte.minuscules(nom));
    }

    String noms() {
        return types.values().stream().map(type -> type.nom).collect(Collectors.joining(", "));
    }

    private static void lireForme(Forme forme, SectionLue section, SceneLue lue) {
        lue.ajouter(lire(forme, section), section, (autre, celle) -> lireForme(forme, autre, celle));
    }

    private static void lireSphere(SectionLue section, SceneLue lue) {
        Sphere sphere = new Sphere(section.point("centre"), section.longueur("rayon"));
        lireMatiere(section, sphere);
        lue.ajouter(sphere, section, LecteurSections::lireSphere);
    }

    private static void lireLampe(SectionLue section, SceneLue lue) {
        Lampe lampe = new Lampe(section.point("position"), section.couleur("couleur", LUMIERE_MAX));
        lue.ajouter(lampe, section, LecteurSections::lireLampe);
    }

    /** Avertit que cette section, d'une variante absente, est laissée de côté. */
    private static void laisser(String variante, SectionLue section, SceneLue lue) {
        String module = Texte.minuscules(variante);
        lue.avertissements.add(section.fautive(section.ligne, null, "section laissée de côté",
                "la variante qui la lit, java -jar " + module + "/target/" + module + ".jar").getMessage());
    }

    /** L'objet que cette forme lit dans cette section. @throws SceneFautive si elle est refusée */
    private static Objet3D lire(Forme forme, SectionLue section) {
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
            throw section.fautive(section.ligne, null, "section que " + forme.getClass().getName()
                    + " ne sait pas lire : " + Cause.dire(e), "des valeurs qui lui conviennent");
        }
    }

    /** La caméra que place cette section, selon la largeur et la hauteur de l'image. */
    static BiFunction<Integer, Integer, Camera> lireCamera(SectionLue section) {
        double champ = section.reel("champ", Constantes.CHAMP, 0, CHAMP_MAX);
        if (champ == 0 || champ == CHAMP_MAX) {
            throw section.fautive("champ", "hors limites : " + Texte.cite(section.mot("champ", "")),
                    "un nombre plus grand que 0 et plus petit que " + (int) CHAMP_MAX);
        }
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
    private static void lireMatiere(SectionLue section, Objet3D lu) {
        lu.setKd(section.couleur("Kd", lu.getKd(), 1));
        if (section.contient("Ks") && section.contient("Kr")) {
            throw section.fautive("Kr", "donnée en même temps que Ks, son synonyme", "Ks ou Kr, pas les deux");
        }
        lu.setKs(section.couleur(section.contient("Kr") ? "Kr" : "Ks", lu.getKs(), 1));
        lu.setNs(section.reel("ns", lu.getNs(), 0, NS_MAX));
    }
}
