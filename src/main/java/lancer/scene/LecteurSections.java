package lancer.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.regex.Pattern;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.SceneFautive;
import lancer.contrat.Forme;
import lancer.texte.Pile;
import lancer.texte.Texte;

/** Passage d'une section à son objet ou à sa lampe, à la lecture du fichier comme après un changement. */
public final class LecteurSections {

    private static final String LAMPE = "lampe";
    private static final double LUMIERE_MAX = 1e6;
    private static final double NS_MAX = 1e9;

    /** Nombre maximal de couleurs dans la palette. */
    private static final int PALETTE_MAX = 256;

    /** Les clés de la matière, permises dans la section de toute forme. */
    public static final List<String> CLES_MATIERE =
            Collections.unmodifiableList(Arrays.asList("Kd", "Ks", "Kr", "ns"));

    private final Map<String, Forme> formes;
    /** Les clés de chaque type d'objets déjà lu, et celles d'une lampe. */
    private final Map<String, List<String>> cles = new LinkedHashMap<>();
    /** Couleurs déjà lues, à partager : une scène d'un million de sphères n'en a que quelques-unes. */
    private final Map<Couleur, Couleur> palette = new HashMap<>();

    LecteurSections(Map<String, Forme> formes) {
        this.formes = formes;
        cles.put(LAMPE, Arrays.asList("position", "couleur"));
    }

    /** Le type d'une section : le premier mot de son nom, en minuscules. */
    static String type(String nom) {
        return Texte.minuscules(nom.indexOf(' ') < 0 ? nom : nom.substring(0, nom.indexOf(' ')));
    }

    /** Dit si les sections de ce type sont celles d'un objet ou d'une lampe. */
    boolean connait(String type) {
        return type.equals(LAMPE) || formes.containsKey(type);
    }

    /** Les clés permises dans une section de ce type ; {@code null} pour une variante. */
    List<String> cles(String type) {
        Forme forme = formes.get(type);
        if (forme != null && !cles.containsKey(type)) {
            List<String> siennes = new ArrayList<>(Arrays.asList(Objects.requireNonNull(forme.getCles(),
                    forme.getClass().getName() + ".getCles a rendu null")));
            siennes.addAll(CLES_MATIERE);
            cles.put(type, siennes);
        }
        return cles.get(type);
    }

    /** Les clés de tous les types lus. */
    Collection<List<String>> cles() {
        return cles.values();
    }

    /** L'objet ou la lampe que décrit cette section. @throws SceneFautive si elle est refusée */
    Object lire(SectionLue section) {
        String type = type(section.nom);
        if (type.equals(LAMPE)) {
            return new Lampe(section.point("position"), section.couleur("couleur", LUMIERE_MAX));
        }
        Objet3D objet = lireForme(section, formes.get(type));
        lireMatiere(section, objet);
        return objet;
    }

    /** Lit l'objet de la section, sans sa matière. Une exception de la forme devient un refus de la section. */
    private static Objet3D lireForme(SectionLue section, Forme forme) {
        try {
            Objet3D objet = forme.lire(section);
            if (objet == null || objet == forme) {
                throw new IllegalStateException("lire n'a pas rendu un objet neuf");
            }
            return objet;
        } catch (SceneFautive e) {
            throw e;
        } catch (RuntimeException e) {
            String classe = forme.getClass().getName();
            boolean refus = e.getMessage() != null
                    && (e instanceof IllegalArgumentException || e instanceof IllegalStateException);
            throw section.fautive(section.ligne, null, "section que " + classe + " ne sait pas lire : "
                    + (refus ? Texte.cite(e.getMessage()) : Pile.cause(e, Pattern.quote(classe) + ".*")),
                    "des valeurs qui lui conviennent");
        }
    }

    /** Lit la matière d'un objet. Une clé absente garde la valeur que l'objet a reçue à sa création. */
    private void lireMatiere(SectionLue section, Objet3D lu) {
        lu.setKd(commune(section.couleur("Kd", lu.getKd(), 1)));
        if (section.contient("Ks") && section.contient("Kr")) {
            throw section.ensemble("Ks", "Kr", "synonyme de", "Ks ou Kr, pas les deux");
        }
        lu.setKs(commune(section.couleur(section.contient("Kr") ? "Kr" : "Ks", lu.getKs(), 1)));
        lu.setNs(section.reel("ns", lu.getNs(), 0, NS_MAX));
    }

    private Couleur commune(Couleur couleur) {
        if (palette.size() == PALETTE_MAX) {
            palette.clear();
        }
        Couleur deja = palette.putIfAbsent(couleur, couleur);
        return deja != null ? deja : couleur;
    }
}
