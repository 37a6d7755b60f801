package lancer;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import lancer.contrat.Atmosphere;
import lancer.contrat.Compteurs;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Ecoute;
import lancer.contrat.Modele;
import lancer.contrat.Origines;
import lancer.contrat.Recherche;
import lancer.contrat.RechercheSimple;
import lancer.contrat.Specularite;
import lancer.scene.Jumelles;
import lancer.scene.LecteurScene;

/**
 * Les objets, les lampes, et ce qu'un rayon y voit (cours, « Scène de sphères »). Une scène appartient à un seul fil :
 * {@link #pourUnFil()} en donne une vue de plus, sur les mêmes objets.
 */
public final class Scene {

    private final List<Objet3D> objets;
    /** En tableau, que chaque contact parcourt. */
    final Lampe[] lampes;
    /** Qui écoute ce fil calculer ; d'ordinaire {@code null}. */
    final Ecoute ecoute;
    private final Atmosphere atmosphere;
    private final Specularite specularite;
    private final Echantillonnage echantillonnage;
    private final Origines origines;
    private final Compteurs compteurs = new Compteurs();
    private Recherche recherche;
    private double seuil = Constantes.SEUIL;

    /**
     * Lit une scène dans un fichier, et y installe les variantes présentes.
     *
     * @param nomFichier voir {@link lancer.scene.FichierScene#trouver}
     * @throws SceneFautive si le fichier ne peut être utilisé, avec un message d'une ligne
     */
    public Scene(String nomFichier) {
        this(LecteurScene.lire(nomFichier));
    }

    /** La scène d'un fichier déjà lu. */
    public Scene(LecteurScene lu) {
        this(lu.getObjets(), lu.getLampes(), lu.getModele(), lu.getOrigines());
    }

    /** Une scène sans fichier. Une sphère de mêmes centre et rayon qu'une précédente est laissée de côté. */
    public Scene(List<? extends Objet3D> objets, List<Lampe> lampes) {
        this(objets, lampes, new Modele());
    }

    /** Une scène sans fichier, où {@code modele} dit ce que des variantes changent. */
    public Scene(List<? extends Objet3D> objets, List<Lampe> lampes, Modele modele) {
        this(objets, lampes, modele, new Origines());
    }

    private Scene(List<? extends Objet3D> objets, List<Lampe> lampes, Modele modele, Origines origines) {
        this.objets = Collections.unmodifiableList(Jumelles.sans(objets));
        this.lampes = lampes.toArray(new Lampe[0]);
        atmosphere = modele.getAtmosphere();
        specularite = modele.getSpecularite();
        echantillonnage = modele.getEchantillonnage();
        this.origines = origines;
        ecoute = null;
        recherche = new RechercheSimple(this.objets, compteurs);
    }

    private Scene(Scene autre, Atmosphere atmosphere, Specularite specularite, Echantillonnage echantillonnage,
            double seuil, Ecoute ecoute) {
        objets = autre.objets;
        lampes = autre.lampes;
        this.atmosphere = atmosphere;
        this.specularite = specularite;
        this.echantillonnage = echantillonnage;
        recherche = autre.recherche.pourUnFil(compteurs);
        this.seuil = seuil;
        origines = autre.origines;
        this.ecoute = ecoute;
    }

    /** La même scène pour un fil de plus, avec ses propres compteurs. */
    public Scene pourUnFil() {
        return avec(echantillonnage, seuil);
    }

    /**
     * La même scène, à dessiner autrement : ce que compare {@code --auto}.
     *
     * @param seuil voir {@link #setSeuil}
     */
    public Scene avec(Echantillonnage echantillonnage, double seuil) {
        return new Scene(this, atmosphere, specularite, echantillonnage, seuil, ecoute);
    }

    /** La même scène, qui dit à {@code ecoute} ce qu'elle calcule. */
    public Scene ecoutee(Ecoute ecoute) {
        return new Scene(this, atmosphere.ecoutee(ecoute), specularite, echantillonnage, seuil, ecoute);
    }

    /** De même, et ce que des variantes en changent est ce que dit {@code modele}. */
    public Scene avec(Modele modele, double seuil) {
        return new Scene(this, modele.getAtmosphere(), modele.getSpecularite(), modele.getEchantillonnage(), seuil,
                ecoute);
    }

    /** Le premier objet que rencontre ce rayon. Voir {@link #getClosestIntersection(Rayon, Objet3D)}. */
    public PointContact getClosestIntersection(Rayon incident) {
        return getClosestIntersection(incident, null);
    }

    /**
     * Le contact le plus proche sur ce rayon, qui le retient aussi ; ce que le rayon retenait avant n'a pas d'effet.
     *
     * @param saufLui l'objet d'où part le rayon, ou {@code null} : à un arrondi près, il se toucherait lui-même
     * @return {@code null} si le rayon ne rencontre rien
     */
    public PointContact getClosestIntersection(Rayon incident, Objet3D saufLui) {
        recherche.plusProche(incident, saufLui);
        return incident.calcContact();
    }

    /**
     * Vrai si un objet autre que {@code objet} se trouve strictement entre la lampe et le contact (cours, « Ombres
     * portées »). Le rayon part de la lampe ; si elle est lointaine, chaque moitié du segment se demande de son bout,
     * le seul d'où elle se voit sans arrondi.
     *
     * @param L direction de la lampe vue du contact, de longueur 1
     * @param distance du contact à la lampe
     */
    public boolean estCachee(Lampe lampe, Point contact, Vecteur L, double distance, Objet3D objet) {
        compteurs.ombre++;
        Ecoute.ombre(ecoute, L, distance);
        if (estLointaine(lampe)) {
            double milieu = distance / 2;
            return recherche.estCachee(lampe, contact, L, milieu, objet)
                    || recherche.estCachee(lampe, lampe.getPosition(), L.neg(), milieu, objet);
        }
        return recherche.estCachee(lampe, lampe.getPosition(), L.neg(), distance, objet);
    }

    /** Vrai si une coordonnée de cette lampe dépasse {@link Constantes#LOINTAINE}. */
    public static boolean estLointaine(Lampe lampe) {
        Point p = lampe.getPosition();
        return Math.max(Math.abs(p.x), Math.max(Math.abs(p.y), Math.abs(p.z))) > Constantes.LOINTAINE;
    }

    /**
     * Ce que voit un rayon, le premier comme un réfléchi : l'objet le plus proche ou le ciel, à travers l'air.
     *
     * @param saufLui l'objet d'où part le rayon, ou {@code null}
     * @param profondeur nombre de réflexions encore permises
     */
    public Couleur getCouleurVue(Rayon rayon, Objet3D saufLui, int profondeur) {
        PointContact contact = getClosestIntersection(rayon, saufLui);
        Ecoute.rayon(ecoute, contact);
        Couleur couleur = contact == null ? rayon.getSkyColor()
                : contact.objet.getColor(this, rayon, contact, profondeur);
        Couleur vue = atmosphere.traverser(couleur, contact == null ? Constantes.INFINI : contact.distance);
        Ecoute.vue(ecoute, couleur, vue);
        return vue;
    }

    /** Les objets, dans l'ordre du fichier ; la liste ne change pas. */
    public List<Objet3D> getObjets() {
        return objets;
    }

    /** Les lampes, dans l'ordre du fichier ; la liste ne change pas. */
    public List<Lampe> getLampes() {
        return Collections.unmodifiableList(Arrays.asList(lampes));
    }

    /** De quelles sections viennent les objets et les lampes. */
    public Origines getOrigines() {
        return origines;
    }

    /** Ce que ce fil a compté. */
    public Compteurs getCompteurs() {
        return compteurs;
    }

    /** Un reflet est suivi si le produit des Ks, en sa plus grande composante, atteint ce seuil. */
    public double getSeuil() {
        return seuil;
    }

    /** @param seuil fini, positif ou nul ; 0 : toujours suivre */
    public void setSeuil(double seuil) {
        this.seuil = seuil;
    }

    public Recherche getRecherche() {
        return recherche;
    }

    public void setRecherche(Recherche recherche) {
        this.recherche = recherche;
    }

    public Atmosphere getAtmosphere() {
        return atmosphere;
    }

    public Specularite getSpecularite() {
        return specularite;
    }

    public Echantillonnage getEchantillonnage() {
        return echantillonnage;
    }
}
