package lancer;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BiFunction;
import lancer.contrat.Compteurs;
import lancer.contrat.Modele;
import lancer.contrat.Recherche;
import lancer.contrat.TousLesObjets;
import lancer.scene.LecteurScene;
import lancer.scene.SceneLue;

/**
 * Les objets, les lampes, et ce qu'un rayon y rencontre (cours, « Scène de sphères »). Une scène appartient à un seul
 * fil d'exécution ; {@link #pourUnFil} en crée une autre sur les mêmes objets.
 */
public final class Scene {

    private final List<Objet3D> objets;
    private final List<Lampe> lampes;
    private final BiFunction<Integer, Integer, Camera> cadrage;
    private final Modele modele;
    private final Recherche recherche;
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

    private Scene(SceneLue contenu) {
        this(contenu.objets, contenu.lampes, contenu.getCadrage(), contenu.getModele());
    }

    /** Une scène sans fichier. Une sphère de mêmes centre et rayon qu'une précédente en est retirée. */
    public Scene(List<? extends Objet3D> objets, List<Lampe> lampes) {
        this(objets, lampes, Camera::new, new Modele());
    }

    /** Une scène sans fichier, dessinée selon ce modèle. @param cadrage voir {@link #getCamera} */
    public Scene(List<? extends Objet3D> objets, List<Lampe> lampes, BiFunction<Integer, Integer, Camera> cadrage,
            Modele modele) {
        this.objets = Collections.unmodifiableList(sansConfondues(objets));
        this.lampes = Collections.unmodifiableList(new ArrayList<>(lampes));
        this.cadrage = cadrage;
        this.modele = modele;
        recherche = new TousLesObjets(getObjets()).pourUnFil(compteurs);
    }

    private Scene(Scene scene, Modele modele, Recherche recherche) {
        objets = scene.objets;
        lampes = scene.lampes;
        cadrage = scene.cadrage;
        this.modele = modele;
        this.recherche = recherche.pourUnFil(compteurs);
    }

    /** Les objets, dans le même ordre, sans les sphères de mêmes centre et rayon qu'une précédente. */
    private static List<Objet3D> sansConfondues(List<? extends Objet3D> objets) {
        List<Objet3D> gardes = new ArrayList<>(objets.size());
        Set<Sphere> vues = new TreeSet<>(Scene::comparer);
        for (Objet3D objet : objets) {
            if (objet.getClass() != Sphere.class || vues.add((Sphere) objet)) {
                gardes.add(objet);
            }
        }
        return gardes;
    }

    /** L'ordre des sphères par centre, puis par rayon ; + 0.0 : −0.0 et 0.0 désignent la même position. */
    private static int comparer(Sphere a, Sphere b) {
        int ordre = Double.compare(a.getCentre().x + 0.0, b.getCentre().x + 0.0);
        ordre = ordre != 0 ? ordre : Double.compare(a.getCentre().y + 0.0, b.getCentre().y + 0.0);
        ordre = ordre != 0 ? ordre : Double.compare(a.getCentre().z + 0.0, b.getCentre().z + 0.0);
        return ordre != 0 ? ordre : Double.compare(a.getRayon(), b.getRayon());
    }

    /** La même scène pour un autre fil d'exécution, avec ses propres compteurs. */
    public Scene pourUnFil() {
        return new Scene(this, modele, recherche);
    }

    /** La même scène, dessinée selon cet autre modèle. */
    public Scene avec(Modele autreModele) {
        return new Scene(this, autreModele, recherche);
    }

    /** La même scène, où cette autre recherche propose les objets. */
    public Scene avec(Recherche autreRecherche) {
        return new Scene(this, modele, autreRecherche);
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
     * Le contact le plus proche sur ce rayon, qui le retient à la place du précédent. Si deux objets sont à la même
     * distance, c'est le premier dans l'ordre de la scène.
     *
     * @param saufLui l'objet d'où part le rayon, ou {@code null} ; un arrondi pourrait le faire toucher de nouveau
     * @return {@code null} si le rayon ne rencontre rien
     */
    public PointContact getClosestIntersection(Rayon incident, Objet3D saufLui) {
        compteurs.compter(saufLui);
        Objet3D plusProche = null;
        double distance = Constantes.INFINI;
        for (Objet3D objet : recherche.candidats(incident, saufLui, Constantes.INFINI)) {
            if (objet != saufLui) {
                double d = objet.getIntersectionDistance(incident);
                if (d < distance) {
                    plusProche = objet;
                    distance = d;
                    // un objet plus lointain n'est plus à proposer
                    recherche.limiter(distance);
                }
            }
        }
        // les objets ont pu être proposés dans un autre ordre que celui de la scène
        incident.setContact(recherche.aEgalite(plusProche), distance);
        return incident.calcContact();
    }

    /**
     * Dit si un objet autre que {@code objet} se trouve strictement entre la lampe et le contact (cours, « Ombres
     * portées »). Le rayon d'ombre part de la lampe. Si elle est lointaine, un rayon part de la lampe, un autre du
     * contact, et chacun s'arrête à mi-chemin : ainsi, les arrondis restent petits.
     *
     * @param L direction de la lampe vue du contact, de longueur 1
     * @param distance du contact à la lampe
     */
    public boolean estCachee(Lampe lampe, Point contact, Vecteur L, double distance, Objet3D objet) {
        if (!modele.aDesOmbres()) {
            return false;
        }
        compteurs.ombre++;
        Rayon deLaLampe = Rayon.unitaire(lampe.getPosition(), L.neg());
        if (!estLointaine(lampe, contact)) {
            return estArrete(deLaLampe, distance, objet);
        }
        return estArrete(deLaLampe, distance / 2, objet)
                || estArrete(Rayon.unitaire(contact, L), distance / 2, objet);
    }

    /** Dit si ce rayon d'ombre rencontre avant cette distance un objet autre que celui qu'il éclaire. */
    private boolean estArrete(Rayon ombre, double distance, Objet3D eclaire) {
        for (Objet3D objet : recherche.candidats(ombre, eclaire, distance)) {
            if (objet != eclaire && objet.getIntersectionDistance(ombre) < distance) {
                return true;
            }
        }
        return false;
    }

    /** Dit si une coordonnée de la lampe dépasse {@link Constantes#LOINTAINE} fois chaque coordonnée du contact. */
    public static boolean estLointaine(Lampe lampe, Point contact) {
        return lampe.getPosition().plusGrande() > Constantes.LOINTAINE * contact.plusGrande();
    }

    /**
     * Couleur que voit un rayon, initial ou réfléchi : celle de l'objet le plus proche ou du ciel, à travers l'air.
     *
     * @param saufLui l'objet d'où part le rayon, ou {@code null}
     * @param profondeur nombre de réflexions encore permises
     */
    public Couleur getCouleurVue(Rayon rayon, Objet3D saufLui, int profondeur) {
        PointContact contact = getClosestIntersection(rayon, saufLui);
        if (contact == null) {
            return modele.getAtmosphere().traverser(rayon.getSkyColor(), Constantes.INFINI);
        }
        Couleur couleur = contact.objet.getColor(this, rayon, contact, profondeur);
        return modele.getAtmosphere().traverser(couleur, contact.distance);
    }

    /** Les objets, dans l'ordre du fichier ; la liste ne change pas. */
    public List<Objet3D> getObjets() {
        return objets;
    }

    /** Les lampes, dans l'ordre du fichier ; la liste ne change pas. */
    public List<Lampe> getLampes() {
        return lampes;
    }

    public Compteurs getCompteurs() {
        return compteurs;
    }

    public Modele getModele() {
        return modele;
    }
}
