package lancer;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import lancer.contrat.Atmosphere;
import lancer.contrat.Compteurs;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Recherche;
import lancer.contrat.RechercheSimple;
import lancer.contrat.Specularite;
import lancer.contrat.Variante;
import lancer.lecture.LecteurScene;
import lancer.lecture.Variantes;

/**
 * Les objets, les lampes, et ce qu'un rayon y voit (cours, « Scène de sphères »). Une scène appartient à un seul fil :
 * {@link #pourUnFil()} en donne une vue de plus, sur les mêmes objets.
 */
public final class Scene {

    private final List<Objet3D> objets;
    private final List<Lampe> lampes;
    /** Les mêmes, en tableau : chaque contact les parcourt. */
    final Lampe[] tableauDesLampes;
    private final List<String> avertissements;
    private final Compteurs compteurs = new Compteurs();
    private List<Variante> variantesLibres = Collections.emptyList();
    private Recherche recherche;
    private double seuil = Constantes.SEUIL;
    private Atmosphere atmosphere = Atmosphere.CLAIRE;
    private Specularite specularite = Specularite.PHONG;
    private Echantillonnage echantillonnage = Echantillonnage.CENTRE;

    /**
     * Lit une scène dans un fichier, et y installe les variantes présentes.
     *
     * @param nomFichier un chemin ; s'il est relatif et n'existe pas ici, cherché aussi dans les quatre dossiers
     *     au-dessus
     * @throws SceneFautive si le fichier ne peut être utilisé, avec un message d'une ligne
     */
    public Scene(String nomFichier) {
        this(new LecteurScene(nomFichier).lire());
    }

    private Scene(LecteurScene lu) {
        this(lu.getObjets(), lu.getLampes(), lu.getAvertissements());
        variantesLibres = Variantes.installer(lu, this);
    }

    /** Une scène sans fichier. Une sphère de mêmes centre et rayon qu'une précédente est laissée de côté. */
    public Scene(List<? extends Objet3D> objets, List<Lampe> lampes) {
        this(objets, lampes, Collections.<String>emptyList());
    }

    private Scene(List<? extends Objet3D> objets, List<Lampe> lampes, List<String> avertissements) {
        this.objets = Collections.unmodifiableList(sansJumelles(objets));
        this.lampes = Collections.unmodifiableList(new ArrayList<>(lampes));
        this.tableauDesLampes = lampes.toArray(new Lampe[0]);
        this.avertissements = avertissements;
        this.recherche = new RechercheSimple(this.objets, compteurs);
    }

    private Scene(Scene autre) {
        objets = autre.objets;
        lampes = autre.lampes;
        tableauDesLampes = autre.tableauDesLampes;
        avertissements = autre.avertissements;
        recherche = autre.recherche.pourUnFil(compteurs);
        seuil = autre.seuil;
        atmosphere = autre.atmosphere;
        specularite = autre.specularite;
        echantillonnage = autre.echantillonnage;
    }

    /** La même scène pour un fil de plus, avec ses propres compteurs. */
    public Scene pourUnFil() {
        return new Scene(this);
    }

    /**
     * La même scène, à dessiner autrement : ce que compare {@code --auto}.
     *
     * @param autreSeuil voir {@link #setSeuil}
     */
    public Scene avec(Echantillonnage autreEchantillonnage, double autreSeuil) {
        Scene scene = new Scene(this);
        scene.echantillonnage = autreEchantillonnage;
        scene.seuil = autreSeuil;
        return scene;
    }

    /** Une sphère confondue avec une autre serait touchée à une distance nulle, à un arrondi près. */
    private static List<Objet3D> sansJumelles(List<? extends Objet3D> objets) {
        List<Objet3D> gardes = new ArrayList<>(objets.size());
        Set<Geometrie> vues = new HashSet<>(2 * objets.size());
        for (Objet3D objet : objets) {
            if (objet.getClass() != Sphere.class || vues.add(new Geometrie((Sphere) objet))) {
                gardes.add(objet);
            }
        }
        return gardes;
    }

    /**
     * Une sphère, égale à toute autre de mêmes centre et rayon. L'ordre est pour la table : des centres choisis pour
     * avoir tous le même code y coûteraient sinon le carré de leur nombre.
     */
    private static final class Geometrie implements Comparable<Geometrie> {

        private final Sphere sphere;

        Geometrie(Sphere sphere) {
            this.sphere = sphere;
        }

        @Override
        public int hashCode() {
            Point c = sphere.getCentre();
            // + 0.0 : −0.0 et 0.0 sont la même position
            int h = 31 * Double.hashCode(c.x + 0.0) + Double.hashCode(c.y + 0.0);
            return 31 * (31 * h + Double.hashCode(c.z + 0.0)) + Double.hashCode(sphere.getRayon());
        }

        @Override
        public boolean equals(Object autre) {
            if (!(autre instanceof Geometrie)) {
                return false;
            }
            Sphere s = ((Geometrie) autre).sphere;
            Point c = sphere.getCentre();
            Point d = s.getCentre();
            return c.x == d.x && c.y == d.y && c.z == d.z && sphere.getRayon() == s.getRayon();
        }

        @Override
        public int compareTo(Geometrie autre) {
            Point c = sphere.getCentre();
            Point d = autre.sphere.getCentre();
            int x = Double.compare(c.x + 0.0, d.x + 0.0);
            int y = x != 0 ? x : Double.compare(c.y + 0.0, d.y + 0.0);
            int z = y != 0 ? y : Double.compare(c.z + 0.0, d.z + 0.0);
            return z != 0 ? z : Double.compare(sphere.getRayon(), autre.sphere.getRayon());
        }
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
     * portées »).
     *
     * @param L direction de la lampe vue du contact, de longueur 1
     * @param distance du contact à la lampe
     */
    public boolean estCachee(Lampe lampe, Point contact, Vecteur L, double distance, Objet3D objet) {
        compteurs.ombre++;
        return recherche.estCachee(lampe, contact, L, distance, objet);
    }

    /**
     * Ce que voit un rayon, le premier comme un réfléchi : l'objet le plus proche ou le ciel, à travers l'air.
     *
     * @param saufLui l'objet d'où part le rayon, ou {@code null}
     * @param profondeur nombre de réflexions encore permises
     */
    public Couleur getCouleurVue(Rayon rayon, Objet3D saufLui, int profondeur) {
        PointContact contact = getClosestIntersection(rayon, saufLui);
        if (contact == null) {
            return atmosphere.traverser(rayon.getSkyColor(), Constantes.INFINI);
        }
        Couleur couleur = contact.objet.getColor(this, rayon, contact, profondeur);
        return atmosphere.traverser(couleur, contact.distance);
    }

    /** Les objets, dans l'ordre du fichier ; la liste ne change pas. */
    public List<Objet3D> getObjets() {
        return objets;
    }

    /** Les lampes, dans l'ordre du fichier ; la liste ne change pas. */
    public List<Lampe> getLampes() {
        return lampes;
    }

    /** Ce que la lecture a laissé de côté, une ligne chacun. */
    public List<String> getAvertissements() {
        return avertissements;
    }

    /** Les variantes présentes dont le fichier de la scène n'a pas la section ; aucune pour une scène sans fichier. */
    public List<Variante> getVariantesLibres() {
        return variantesLibres;
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

    /** @throws SceneFautive si une autre variante a déjà changé l'air */
    public void setAtmosphere(Atmosphere atmosphere) {
        this.atmosphere = libre(this.atmosphere, Atmosphere.CLAIRE, atmosphere, "l'air");
    }

    public Specularite getSpecularite() {
        return specularite;
    }

    /** @throws SceneFautive si une autre variante a déjà changé le reflet des lampes */
    public void setSpecularite(Specularite specularite) {
        this.specularite = libre(this.specularite, Specularite.PHONG, specularite, "le reflet des lampes");
    }

    public Echantillonnage getEchantillonnage() {
        return echantillonnage;
    }

    /** @throws SceneFautive si une autre variante a déjà changé l'échantillonnage */
    public void setEchantillonnage(Echantillonnage echantillonnage) {
        this.echantillonnage = libre(this.echantillonnage, Echantillonnage.CENTRE, echantillonnage,
                "l'échantillonnage");
    }

    /** Un contrat ne se prend qu'une fois : deux variantes qui le veulent ne peuvent aller ensemble. */
    private static <T> T libre(T present, T defaut, T nouveau, String quoi) {
        if (present != defaut) {
            throw new SceneFautive("deux variantes veulent changer " + quoi + " : " + nom(present) + " et "
                    + nom(nouveau) + " ; attendu : une seule des deux dans le chemin des classes");
        }
        return nouveau;
    }

    /** Le nom de la classe, sans ce que Java ajoute à celui d'une lambda. */
    private static String nom(Object contrat) {
        return contrat.getClass().getName().replaceAll("\\$\\$Lambda.*", "");
    }
}
