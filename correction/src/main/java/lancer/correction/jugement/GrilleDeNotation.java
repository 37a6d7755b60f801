package lancer.correction.jugement;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lancer.correction.modele.SourcesDuCours;

/**
 * Critères de la note, et images du corrigé : les étapes de l'énoncé, dans l'ordre, l'image, les extensions, les consignes. La grille est
 * écrite à côté des résultats, pour refaire les notes et les pages sans juger de nouveau.
 */
public final class GrilleDeNotation {

    /** Une étape et ses critères, ou une ligne libre du barème, sans critère. */
    public static final class Etape {

        public final String nom;
        public final String titre;
        /** Titre court, sans le mot « Extension ». */
        public final String court;
        /** Vrai pour une extension, facultative. */
        public final boolean extension;
        public final List<Verification> criteres = new ArrayList<>();

        public Etape(String nom, String titre) {
            this.nom = nom;
            this.court = titre;
            this.extension = SourcesDuCours.VARIANTES.contains(nom);
            this.titre = (extension ? "Extension : " : "") + titre;
        }

        /** Vrai pour une ligne que l'enseignant a ajoutée au barème, et dont il donne les points. */
        public boolean libre() {
            return criteres.isEmpty();
        }

        /** Vrai pour une étape de l'énoncé. */
        public boolean duCours() {
            return !extension && !libre() && !nom.equals(IMAGE) && !nom.equals(CONSIGNES);
        }
    }

    /** L'étape de l'image : un critère par scène. */
    public static final String IMAGE = "image";
    /** Étape des consignes de rendu : elle enlève des points, au lieu d'en donner. */
    public static final String CONSIGNES = "consignes";
    /** Fin du nom de l'image que la base dessine sur la scène d'une extension. */
    public static final String BASE = " (base)";

    /** Pour chaque extension : titre, ce qu'il faut examiner, scène. */
    static final Map<String, String[]> EXTENSIONS = Map.of(
            "brume", new String[] {"brume",
                "la couleur de la base, mêlée à celle d'une brume, d'autant plus que c'est loin", "brume"},
            "antialias", new String[] {"anticrénelage",
                "les bords approchent la moyenne de plusieurs rayons par pixel, et le reste ne change pas", "scene1"},
            "blinn", new String[] {"reflet de Blinn", "le reflet est (N.H) à la puissance ns, 2 ns ou 4 ns", "bowling"});

    /** Fin du nom d'une image du corrigé dont les rayons passent au centre des pixels. */
    static final String AU_CENTRE = " (au centre)";

    public final List<Etape> etapes = new ArrayList<>();
    /** Images du corrigé : par scène, aux coordonnées entières puis au centre des pixels ; une par extension. */
    final Map<String, Image> images = new LinkedHashMap<>();

    /** Ajoute un critère à la dernière étape si c'est la sienne, sinon à une nouvelle étape. */
    void ajouter(Verification critere) {
        if (etapes.isEmpty() || !etapes.get(etapes.size() - 1).nom.equals(critere.etape)) {
            etapes.add(new Etape(critere.etape, critere.titreEtape));
        }
        etapes.get(etapes.size() - 1).criteres.add(critere);
    }

    /** L'image du corrigé, aux coordonnées entières ou au centre des pixels ; pour une extension, aux coordonnées entières. */
    public Image getImage(String scene, boolean auCentre) {
        return images.get(scene + (auCentre ? AU_CENTRE : ""));
    }
}
