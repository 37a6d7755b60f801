package lancer;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.function.BiFunction;
import lancer.contrat.Compteurs;
import lancer.contrat.Ecoute;
import lancer.contrat.Modele;
import lancer.contrat.Recherche;
import lancer.contrat.TousLesObjets;
import lancer.scene.LecteurScene;
import lancer.scene.SceneLue;

/**
 * Les objets, les lampes, et ce qu'un rayon y rencontre (cours, « Scène de sphères »). Une scène appartient à un seul
 * fil d'exécution ; {@link #avec} en crée une autre sur les mêmes objets.
 */
public final class Scene {

    private final Objet3D[] objets;
    final Lampe[] lampes;
    private final BiFunction<Integer, Integer, Camera> cadrage;
    private final Modele modele;
    private final Recherche tous;
    private final Compteurs compteurs = new Compteurs();

    /**
     * Lit une scène dans un fichier, et y installe les variantes présentes.
     *
     * @param nomFichier voir {@link lancer.scene.LecteurScene#trouver}
     * @throws SceneFautive si le fichier ne peut être utilisé, avec un message d'une ligne
     */
    public Scene(String nomFichier) {
        this(LecteurScene.lire(nomFichier, part -> { }));
    }

    private Scene(SceneLue lue) {
        this(new Scene(lue.objets, lue.lampes, lue.getCadrage()), lue.getModele());
    }

    /** Une scène sans fichier. Une sphère de mêmes centre et rayon qu'une précédente en est retirée. */
    public Scene(List<? extends Objet3D> objets, List<Lampe> lampes) {
        this(objets, lampes, Camera::new);
    }

    /** Une scène sans fichier. @param cadrage voir {@link #getCamera} */
    public Scene(List<? extends Objet3D> objets, List<Lampe> lampes, BiFunction<Integer, Integer, Camera> cadrage) {
        this.cadrage = cadrage;
        this.objets = SceneLue.sansConfondues(objets).toArray(new Objet3D[0]);
        this.lampes = lampes.toArray(new Lampe[0]);
        tous = new TousLesObjets(this.objets.length);
        modele = new Modele();
    }

    private Scene(Scene autre, Modele modele) {
        objets = autre.objets;
        lampes = autre.lampes;
        cadrage = autre.cadrage;
        tous = autre.tous.pourUnFil(compteurs);
        this.modele = modele.pourUnFil(compteurs);
    }

    /** La même scène pour un autre fil, avec ses propres compteurs, dessinée selon ce modèle. */
    public Scene avec(Modele autre) {
        return new Scene(this, autre);
    }

    /** La caméra que place la scène, ou celle du cours, pour une image de cette taille. */
    public Camera getCamera(int largeur, int hauteur) {
        return cadrage.apply(largeur, hauteur);
    }

    /** Le premier objet que rencontre ce rayon. Voir {@link #getClosestIntersection(Rayon, Objet3D)}. */
    public PointContact getClosestIntersection(Rayon incident) {
        return getClosestIntersection(incident, null);
    }

    /**
     * Le contact le plus proche sur ce rayon. Le rayon le retient à la place du précédent.
     *
     * @param saufLui l'objet d'où part le rayon, ou {@code null} ; un arrondi pourrait le faire toucher de nouveau
     * @return {@code null} si le rayon ne rencontre rien
     */
    public PointContact getClosestIntersection(Rayon incident, Objet3D saufLui) {
        Recherche.obeir();
        Recherche recherche = getRecherche();
        recherche.commencer(incident.getP(), incident.getV(), saufLui);
        double distance = Constantes.INFINI;
        int plusProche = -1;
        for (int k = recherche.suivant(distance); k >= 0; k = recherche.suivant(distance)) {
            if (objets[k] != saufLui) {
                double d = demander(objets[k], incident);
                // à la même distance, l'objet qui vient d'abord dans la scène
                if (d < distance || d == distance && k < plusProche) {
                    plusProche = k;
                    distance = d;
                }
            }
        }
        incident.setContact(plusProche < 0 ? null : objets[plusProche], distance);
        return incident.calcContact();
    }

    /**
     * Dit si un objet autre que {@code objet} se trouve strictement entre la lampe et le contact (cours, « Ombres
     * portées »). Le rayon d'ombre part de la lampe. Si elle est lointaine, un rayon part de chaque extrémité du
     * segment et s'arrête au milieu : ainsi, les arrondis restent petits.
     *
     * @param L direction de la lampe vue du contact, de longueur 1
     * @param distance du contact à la lampe
     */
    public boolean estCachee(Lampe lampe, Point contact, Vecteur L, double distance, Objet3D objet) {
        if (!modele.aDesOmbres()) {
            return false;
        }
        compteurs.ombre++;
        if (modele.getEcoute() != null) {
            modele.getEcoute().ombre(new Vecteur(L.x, L.y, L.z), distance);
        }
        if (estLointaine(lampe, contact)) {
            double milieu = distance / 2;
            return estCacheeDe(contact, L, milieu, objet, lampe)
                    || estCacheeDe(lampe.getPosition(), L.neg(), milieu, objet, lampe);
        }
        return estCacheeDe(lampe.getPosition(), L.neg(), distance, objet, lampe);
    }

    /** Dit si le rayon d'ombre qui part de P dans la direction V rencontre un autre objet avant cette distance. */
    private boolean estCacheeDe(Point P, Vecteur V, double distance, Objet3D objet, Lampe lampe) {
        Recherche.obeir();
        Recherche recherche = getRecherche();
        recherche.commencerOmbre(lampe, P, V, distance, objet);
        Rayon ombre = Rayon.dOmbre(P, V);
        for (int k = recherche.suivant(distance); k >= 0; k = recherche.suivant(distance)) {
            if (objets[k] != objet && demander(objets[k], ombre) < distance) {
                return true;
            }
        }
        return false;
    }

    /** Ce qui propose des objets aux deux boucles : tous, si le modèle n'a pas de recherche. */
    private Recherche getRecherche() {
        Recherche recherche = modele.getRecherche();
        return recherche == null ? tous : recherche;
    }

    /** Distance du contact de cet objet sur ce rayon. */
    private double demander(Objet3D objet, Rayon rayon) {
        compteurs.testsSpheres++;
        double d = objet.getIntersectionDistance(rayon);
        if (Double.isNaN(d)) {
            throw new ArithmeticException(objet.getClass().getName() + ".getIntersectionDistance a rendu NaN");
        }
        return d;
    }

    /** Dit si une coordonnée de la lampe dépasse {@link Constantes#LOINTAINE} fois chaque coordonnée du contact. */
    public static boolean estLointaine(Lampe lampe, Point contact) {
        return plusGrande(lampe.getPosition()) > Constantes.LOINTAINE * plusGrande(contact);
    }

    private static double plusGrande(Point p) {
        return Math.max(Math.abs(p.x), Math.max(Math.abs(p.y), Math.abs(p.z)));
    }

    /**
     * Couleur que voit un rayon, initial ou réfléchi : celle de l'objet le plus proche ou du ciel, à travers l'air.
     *
     * @param saufLui l'objet d'où part le rayon, ou {@code null}
     * @param profondeur nombre de réflexions encore permises
     */
    public Couleur getCouleurVue(Rayon rayon, Objet3D saufLui, int profondeur) {
        PointContact contact = getClosestIntersection(rayon, saufLui);
        Ecoute ecoute = modele.getEcoute();
        if (ecoute != null) {
            ecoute.rayon(new Vecteur(rayon.getV().x, rayon.getV().y, rayon.getV().z), contact);
        }
        Couleur couleur = contact == null ? rayon.getSkyColor()
                : contact.objet.getColor(this, rayon, contact, profondeur);
        Couleur vue = modele.getAtmosphere().traverser(couleur, contact == null ? Constantes.INFINI : contact.distance);
        if (ecoute != null) {
            ecoute.vue(new Couleur(couleur.r, couleur.v, couleur.b), new Couleur(vue.r, vue.v, vue.b));
        }
        return vue;
    }

    /** Les objets, dans l'ordre du fichier ; la liste ne change pas. */
    public List<Objet3D> getObjets() {
        return Collections.unmodifiableList(Arrays.asList(objets));
    }

    /** Les lampes, dans l'ordre du fichier ; la liste ne change pas. */
    public List<Lampe> getLampes() {
        return Collections.unmodifiableList(Arrays.asList(lampes));
    }

    public Compteurs getCompteurs() {
        return compteurs;
    }

    public Modele getModele() {
        return modele;
    }
}
