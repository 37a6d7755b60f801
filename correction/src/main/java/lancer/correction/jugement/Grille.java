package lancer.correction.jugement;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lancer.correction.depot.Projet;

/**
 * Ce qui se note : les étapes de l'énoncé, dans son ordre, l'image, puis les variantes ; et pour chacune, ce qui
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
        /** Vrai pour une variante, que l'on fait si l'on veut, dans l'ordre que l'on veut. */
        public final boolean extension;
        /** Vrai pour une étape de l'énoncé, que l'on fait dans l'ordre : ni l'image, ni une extension. */
        public final boolean duCours;
        public final List<Critere> criteres = new ArrayList<>();

        Etape(String nom, String titre) {
            this.nom = nom;
            this.titre = titre;
            this.extension = Projet.VARIANTES.contains(nom);
            this.duCours = !extension && !nom.equals(IMAGE) && !nom.equals(CONSIGNES);
        }

        /** Son titre là où l'on sait déjà que c'est une extension. */
        public String court() {
            return titre.replaceFirst("^Extension : ", "");
        }
    }

    /** L'étape de l'image : un critère par scène. */
    public static final String IMAGE = "image";

    /** Ce que l'énoncé demande de la façon de rendre : enlève des points, au lieu d'en donner. */
    public static final String CONSIGNES = "consignes";

    private final Map<String, Etape> etapes = new LinkedHashMap<>();

    public Grille(Reference reference) {
        for (Verification v : reference.getVerifications()) {
            ajouter(v.etape, v.titreEtape.replaceFirst("^\\d+\\. ", ""), v.id(), v.classe, v.titre, reference.compte(v));
        }
        for (String scene : Reference.SCENES.keySet()) {
            ajouter(IMAGE, "L'image entière", IMAGE + "." + scene,
                    "la scène « " + scene + " », par toutes les classes du rendu, est celle du corrigé", true);
        }
        Variante.TITRES.forEach((nom, titre) -> ajouter(nom, "Extension : " + titre[0], nom + ".image", titre[1], true));
        ajouter(CONSIGNES, "Consignes de rendu", consigne(Projet.NOMS), "le paquet et les noms sont ceux du cours", true);
        ajouter(CONSIGNES, "", consigne(Projet.OUTILS), "aucun des fichiers que les outils ajoutent", true);
        ajouter(CONSIGNES, "", consigne(Projet.TEXTE), "UTF-8, et des espaces au lieu de tabulations", true);
        ajouter(CONSIGNES, "", consigne(Projet.FIXME), "chaque FIXME est enlevé quand c'est fait", true);
    }

    static String consigne(String nom) {
        return CONSIGNES + "." + nom;
    }

    private void ajouter(String etape, String titreEtape, String id, String titre, boolean compte) {
        ajouter(etape, titreEtape, id, "", titre, compte);
    }

    private void ajouter(String etape, String titreEtape, String id, String classe, String titre, boolean compte) {
        etapes.computeIfAbsent(etape, e -> new Etape(e, titreEtape)).criteres.add(new Critere(id, classe, titre, compte));
    }

    public List<Etape> getEtapes() {
        return Collections.unmodifiableList(new ArrayList<>(etapes.values()));
    }
}
