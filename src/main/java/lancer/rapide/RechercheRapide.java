package lancer.rapide;

import lancer.Constantes;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;
import lancer.contrat.RechercheSimple;

/**
 * La recherche qui s'aide des structures d'une {@link Preparation} : pour chaque sorte de rayon, celle qui lui va, et
 * qui vérifie d'abord que ce rayon est de ceux pour qui elle est faite. Les structures sont partagées ; chaque fil a sa
 * {@link Parcours}.
 */
public final class RechercheRapide implements Recherche {

    final Structures structures;
    private final Spheres spheres;
    private final Intersections premiers;
    private final Intersections suivants;
    private final Lampe[] lampes;
    private final Occultations[] ombres;
    private final Parcours parcours;

    /**
     * Celle qui répond à la place de celle-ci, d'ordinaire {@code null}. Sous cette forme la recherche d'une scène est
     * toujours de cette classe, et quelques témoins ne coûtent rien aux autres rayons.
     */
    private final Recherche remplacante;

    /**
     * Le numéro de la sphère rencontrée en dernier, -1 si aucune : c'est elle qu'on éclaire, et d'où part le rayon
     * suivant.
     */
    private int derniere = -1;

    /** Le rang de la lampe de la dernière question : d'ordinaire, la suivante est celle de la prochaine. */
    private int lampe;

    RechercheRapide(Structures structures, Compteurs compteurs) {
        this(structures, compteurs, null);
    }

    private RechercheRapide(Structures structures, Compteurs compteurs, Recherche remplacante) {
        this.structures = structures;
        spheres = structures.spheres;
        premiers = structures.premiers;
        suivants = structures.suivants;
        lampes = structures.lampes;
        ombres = structures.ombres;
        parcours = new Parcours(compteurs);
        this.remplacante = remplacante;
    }

    /** La même, qui laisse toujours répondre l'autre. */
    public RechercheRapide remplacee(Recherche autre) {
        return new RechercheRapide(structures, parcours.compteurs, autre);
    }

    @Override
    public void plusProche(Rayon incident, Objet3D saufLui) {
        if (remplacante != null) {
            remplacante.plusProche(incident, saufLui);
            return;
        }
        Point P = incident.getP();
        Vecteur V = incident.getV();
        int k = saufLui == null ? premiers.plusProche(parcours, P.x, P.y, P.z, V.x, V.y, V.z, -1)
                : suivants.plusProche(parcours, P.x, P.y, P.z, V.x, V.y, V.z, numero(saufLui));
        derniere = k;
        if (spheres.autres.length > 0) {
            avecLesAutres(incident, k, saufLui);
        } else {
            incident.setContact(k < 0 ? null : spheres.objets[k], parcours.distance);
        }
    }

    private int numero(Objet3D objet) {
        return derniere >= 0 && objet == spheres.objets[derniere] ? derniere : spheres.numero(objet);
    }

    @Override
    public boolean estCachee(Lampe lampe, Point P, Vecteur V, double distance, Objet3D objet) {
        if (remplacante != null) {
            // une copie : V n'a sinon pas à exister hors des registres
            return remplacante.estCachee(lampe, P, new Vecteur(V.x, V.y, V.z), distance, objet);
        }
        return ombresDe(lampe).cachee(parcours, P.x, P.y, P.z, V.x, V.y, V.z, distance, numero(objet))
                || spheres.autres.length > 0
                && unAutreCache(Rayon.dOmbre(P, new Vecteur(V.x, V.y, V.z)), distance, objet);
    }

    /** Ce qui cache cette lampe ; si elle n'est pas de la scène, ce qui les cache toutes. */
    private Occultations ombresDe(Lampe demandee) {
        for (int reste = lampes.length; reste > 0; reste--) {
            if (lampes[lampe] == demandee) {
                return ombres[lampe];
            }
            lampe = lampe + 1 < lampes.length ? lampe + 1 : 0;
        }
        return structures.arbre;
    }

    /**
     * Retient dans le rayon, de la sphère k et des objets qui ne sont pas des sphères, celui qu'il rencontre d'abord.
     *
     * @param k numéro de la sphère à {@code parcours.distance}, ou -1
     */
    private void avecLesAutres(Rayon incident, int k, Objet3D saufLui) {
        Objet3D plusProche = k < 0 ? null : spheres.objets[k];
        double distance = parcours.distance;
        int rang = k < 0 ? Integer.MAX_VALUE : spheres.rang[k];
        for (int a = 0; a < spheres.autres.length; a++) {
            Objet3D autre = spheres.autres[a];
            if (autre != saufLui) {
                parcours.compteurs.testsSpheres++;
                double d = RechercheSimple.verifier(autre.getIntersectionDistance(incident), autre);
                if (d < distance || d == distance && d != Constantes.INFINI && spheres.rangAutres[a] < rang) {
                    plusProche = autre;
                    distance = d;
                    rang = spheres.rangAutres[a];
                }
            }
        }
        incident.setContact(plusProche, distance);
    }

    private boolean unAutreCache(Rayon ombre, double distance, Objet3D objet) {
        for (Objet3D autre : spheres.autres) {
            if (autre != objet) {
                parcours.compteurs.testsSpheres++;
                if (RechercheSimple.verifier(autre.getIntersectionDistance(ombre), autre) < distance) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Sphères et cases examinées pour choisir les structures. */
    public long getEssais() {
        return structures.essais;
    }

    @Override
    public Recherche pourUnFil(Compteurs compteurs) {
        return new RechercheRapide(structures, compteurs);
    }

    /** Ce que {@link Preparation} a choisi pour cette scène. */
    @Override
    public String toString() {
        return structures.toString();
    }
}
