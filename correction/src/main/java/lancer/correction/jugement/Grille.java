package lancer.correction.jugement;

import java.util.ArrayList;
import java.util.List;
import lancer.correction.depot.Projet;
import lancer.correction.modele.Modele;

/**
 * Critères qui se notent : les étapes de l'énoncé, dans son ordre, l'image, puis les variantes ; et pour chacune, ce qui
 * compte.
 */
public final class Grille {

    /** Une ligne d'une étape. */
    public static final class Critere {

        public final String id;
        public final String titre;
        public final boolean compte;
        /** La classe du cours dont il parle, vide s'il n'en est pas d'une. */
        public final String classe;

        Critere(String id, String classe, String titre, boolean compte) {
            this.id = id;
            this.classe = classe;
            this.titre = titre;
            this.compte = compte;
        }
    }

    /** Une étape et ses critères. */
    public static final class Etape {

        public final String nom;
        public final String titre;
        /** Son titre là où l'on sait déjà que c'est une extension. */
        public final String court;
        /** Vrai pour une variante, que l'on fait si l'on veut, dans l'ordre que l'on veut. */
        public final boolean extension;
        /** Vrai pour une étape de l'énoncé, que l'on fait dans l'ordre : ni l'image, ni une extension. */
        public final boolean duCours;
        public final List<Critere> criteres = new ArrayList<>();

        Etape(String nom, String titre) {
            this.nom = nom;
            this.court = titre;
            this.extension = Modele.VARIANTES.contains(nom);
            this.titre = (extension ? "Extension : " : "") + titre;
            this.duCours = !extension && !nom.equals(IMAGE) && !nom.equals(CONSIGNES);
        }
    }

    /** L'étape de l'image : un critère par scène. */
    public static final String IMAGE = "image";

    /** Étape de ce que l'énoncé demande de la façon de rendre : enlève des points, au lieu d'en donner. */
    public static final String CONSIGNES = "consignes";

    public final List<Etape> etapes = new ArrayList<>();

    public Grille(Reference reference) {
        for (Verification v : reference.verifications) {
            etape(v.etape, v.titreEtape.replaceFirst("^\\d+\\. ", "")).criteres
                    .add(new Critere(v.id(), v.classe, v.titre, reference.compte(v)));
        }
        Reference.SCENES.keySet().forEach(scene -> etape(IMAGE, "L'image entière").criteres.add(new Critere(IMAGE + "." + scene, "",
                "la scène « " + scene + " », par toutes les classes du rendu, est celle du corrigé", true)));
        Modele.VARIANTES.forEach(nom -> etape(nom, Variante.TITRES.get(nom)[0]).criteres
                .add(new Critere(nom + ".image", "", Variante.TITRES.get(nom)[1], true)));
        Projet.CONSIGNES.forEach((nom, titre) -> etape(CONSIGNES, "Consignes de rendu").criteres
                .add(new Critere(CONSIGNES + "." + nom, "", titre, true)));
    }

    /** La dernière étape, si c'est celle-là, sinon une de plus. */
    private Etape etape(String nom, String titre) {
        if (etapes.isEmpty() || !etapes.get(etapes.size() - 1).nom.equals(nom)) {
            etapes.add(new Etape(nom, titre));
        }
        return etapes.get(etapes.size() - 1);
    }
}
