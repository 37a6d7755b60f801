package lancer.lecture;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import lancer.Lampe;
import lancer.SceneFautive;
import lancer.Sphere;
import lancer.contrat.Forme;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.texte.Texte;

/**
 * Les formes et les variantes présentes dans le chemin des classes. Elles sont cherchées dans un fil à part : Java
 * fouille aussi ses propres modules, et la scène se lit pendant ce temps.
 */
public final class Services implements Runnable {

    /** Les types que lisent des variantes de la maison, présentes ou non. */
    private static final String[] VARIANTES_CONNUES = {"Brume", "Antialias", "Blinn"};

    /** La forme de la base : lue comme les autres, mais sans attendre qu'elles soient trouvées. */
    private static final TypeObjet SPHERE = new TypeObjet(new FormeSphere());

    private List<TypeObjet> formes;
    private List<Variante> variantes;

    Services() {
        Thread avance = new Thread(this, "lancer-services");
        avance.setDaemon(true);
        avance.start();
    }

    @Override
    public void run() {
        try {
            chercher();
        } catch (RuntimeException | Error e) {
            // celui qui les demandera cherchera à son tour, et le dira
        }
    }

    private synchronized void chercher() {
        if (variantes != null) {
            return;
        }
        Map<String, String> preneurs = new HashMap<>();
        prendre("Sphere", Sphere.class.getName(), preneurs);
        prendre("Lampe", Lampe.class.getName(), preneurs);
        List<Variante> trouvees = inscrites(Variante.class);
        for (Variante variante : trouvees) {
            prendre(variante.getSection(), variante.getClass().getName(), preneurs);
        }
        List<TypeObjet> types = new ArrayList<>();
        for (Forme forme : inscrites(Forme.class)) {
            String type = forme.getSection();
            String classe = forme.getClass().getName();
            prendre(type, classe, preneurs);
            if (varianteConnue(type)) {
                throw deuxFois(type, "la variante " + Texte.minuscules(type), classe);
            }
            types.add(new TypeObjet(forme));
        }
        formes = types;
        variantes = trouvees;
    }

    private static <T> List<T> inscrites(Class<T> contrat) {
        List<T> inscrites = new ArrayList<>();
        try {
            for (T inscrite : ServiceLoader.load(contrat, Services.class.getClassLoader())) {
                inscrites.add(inscrite);
            }
        } catch (ServiceConfigurationError e) {
            throw new SceneFautive("META-INF/services, ligne qui ne convient pas : " + Texte.echappe(e.getMessage())
                    + " ; attendu : une classe publique de ce contrat, à constructeur public sans argument", e);
        }
        return inscrites;
    }

    /** Un type de section n'a qu'un lecteur. */
    private static void prendre(String type, String classe, Map<String, String> preneurs) {
        if (type == null || !type.equals(Section.type(type)) || type.isEmpty()) {
            throw new SceneFautive(classe + " : type de section impossible : " + Texte.cite(String.valueOf(type))
                    + " ; attendu : un mot");
        }
        String deja = preneurs.putIfAbsent(Texte.minuscules(type), classe);
        if (deja != null) {
            throw deuxFois(type, deja, classe);
        }
    }

    private static SceneFautive deuxFois(String type, String classe, String autre) {
        return new SceneFautive("deux classes veulent les sections [" + Texte.abrege(type) + "] : " + classe
                + " et " + autre + " ; attendu : un type de section pour chacune");
    }

    /** Ce que décrit ce type de section, {@code null} si ce n'est pas un objet. */
    TypeObjet objet(String type) {
        if (Texte.memeMot(SPHERE.getNom(), type)) {
            return SPHERE;
        }
        chercher();
        for (TypeObjet forme : formes) {
            if (Texte.memeMot(forme.getNom(), type)) {
                return forme;
            }
        }
        return null;
    }

    List<Variante> variantes() {
        chercher();
        return variantes;
    }

    /** Les noms des variantes présentes. */
    public static List<String> nomsDesVariantes() {
        List<String> noms = new ArrayList<>();
        for (Variante variante : new Services().variantes()) {
            noms.add(variante.getSection());
        }
        return noms;
    }

    /** Vrai si une variante présente lit ce type de section. */
    boolean variantePresente(String type) {
        for (Variante variante : variantes()) {
            if (Texte.memeMot(variante.getSection(), type)) {
                return true;
            }
        }
        return false;
    }

    /** Vrai si ce type de section est celui d'une variante de la maison, présente ou non. */
    static boolean varianteConnue(String type) {
        for (String connue : VARIANTES_CONNUES) {
            if (Texte.memeMot(connue, type)) {
                return true;
            }
        }
        return false;
    }

    /** Tous les types de section que l'on peut écrire. */
    String types() {
        chercher();
        List<String> types = new ArrayList<>();
        types.add(SPHERE.getNom());
        for (TypeObjet forme : formes) {
            types.add(forme.getNom());
        }
        types.add("Lampe");
        types.addAll(Arrays.asList(VARIANTES_CONNUES));
        for (Variante variante : variantes) {
            if (!varianteConnue(variante.getSection())) {
                types.add(variante.getSection());
            }
        }
        return String.join(", ", types);
    }
}
