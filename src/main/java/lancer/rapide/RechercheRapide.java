package lancer.rapide;

import java.util.ArrayList;
import java.util.List;
import lancer.Camera;
import lancer.Constantes;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;
import lancer.contrat.Sondable;

/**
 * Recherche par les structures d'une {@link Preparation}. Chaque sorte de rayon a sa structure, qui vérifie d'abord si
 * elle accepte le rayon. Les fils partagent les structures ; chacun a son {@link EtatDeRecherche}.
 */
public final class RechercheRapide implements Recherche, Sondable {

    private static final String SUITE = " : ce sont les boucles du cours qui dessinent ; si l'image change d'un essai "
            + "à l'autre, essayez --fils 1";

    /** Nombre d'objets au-delà duquel il y en a beaucoup ; nombre de ceux qui répondent à leur place. */
    private static final int BEAUCOUP = 1000;
    private static final int QUELQUES = 64;

    /** Nombre des premiers objets : un rayon d'ombre examine d'abord ceux d'entre eux qui ne sont pas des sphères. */
    private static final int PREMIERS = 8;

    final Structures structures;
    /** Nombre d'objets qui ne sont pas des sphères, parmi les {@link #PREMIERS}. */
    private final int dAbord;
    private final Spheres spheres;
    private final Intersections premiers;
    private final Intersections suivants;
    private final Lampe[] lampes;
    private final Occultations[] ombres;
    private final EtatDeRecherche etat;

    /** Numéro de la dernière sphère rencontrée, ou -1 : en général la sphère éclairée, d'où part le rayon suivant. */
    private int derniere = -1;
    private Objet3D rencontree;

    /** Rang de la dernière lampe demandée ; en général, la suivante vient juste après. */
    private int lampe;

    RechercheRapide(Structures structures, Compteurs compteurs) {
        this.structures = structures;
        spheres = structures.spheres;
        premiers = structures.premiers;
        suivants = structures.suivants;
        lampes = structures.lampes;
        ombres = structures.ombres;
        etat = new EtatDeRecherche(compteurs);
        int n = 0;
        while (n < spheres.autres.length && spheres.rangAutres[n] < PREMIERS) {
            n++;
        }
        dAbord = n;
    }

    @Override
    public void plusProche(Rayon incident, Objet3D saufLui) {
        Point P = incident.getP();
        Vecteur V = incident.getV();
        if (saufLui == null) {
            etat.ouvrir();
            derniere = premiers.plusProche(etat, P.x, P.y, P.z, V.x, V.y, V.z, -1);
        } else {
            // avant un rayon de l'écran, Lancer a déjà lu la demande d'arrêt
            Recherche.obeir();
            derniere = suivants.plusProche(etat, P.x, P.y, P.z, V.x, V.y, V.z, numero(saufLui));
        }
        rencontree = derniere < 0 ? null : spheres.objets[derniere];
        if (spheres.autres.length > 0) {
            avecLesAutres(incident, saufLui);
        } else {
            incident.setContact(rencontree, etat.distance);
        }
    }

    private int numero(Objet3D objet) {
        return objet == rencontree ? derniere : spheres.numero(objet);
    }

    @Override
    public boolean estCachee(Lampe lampe, Point P, Vecteur V, double distance, Objet3D objet) {
        return spheres.autres.length > 0
                ? cacheeAvecLesAutres(lampe, Rayon.dOmbre(P, new Vecteur(V.x, V.y, V.z)), distance, objet)
                : ombresDe(lampe).cachee(etat, P.x, P.y, P.z, V.x, V.y, V.z, distance, numero(objet));
    }

    /** Structure des ombres de cette lampe ; l'arbre si la lampe n'est pas de la scène. */
    private Occultations ombresDe(Lampe demandee) {
        for (int reste = lampes.length; reste > 0; reste--) {
            if (lampes[lampe] == demandee) {
                return ombres[lampe];
            }
            lampe = lampe + 1 < lampes.length ? lampe + 1 : 0;
        }
        return structures.arbre;
    }

    /** Retient le contact le plus proche : celui de la sphère trouvée, ou celui d'un autre objet. */
    private void avecLesAutres(Rayon incident, Objet3D saufLui) {
        Objet3D plusProche = rencontree;
        double distance = etat.distance;
        int rang = derniere < 0 ? Integer.MAX_VALUE : spheres.rang[derniere];
        for (int a = 0; a < spheres.autres.length; a++) {
            Objet3D autre = spheres.autres[a];
            if (autre != saufLui) {
                etat.compteurs.testsSpheres++;
                double d = Recherche.verifier(autre.getIntersectionDistance(incident), autre);
                if (d < distance || d == distance && d != Constantes.INFINI && spheres.rangAutres[a] < rang) {
                    plusProche = autre;
                    distance = d;
                    rang = spheres.rangAutres[a];
                }
            }
        }
        incident.setContact(plusProche, distance);
    }

    private boolean cacheeAvecLesAutres(Lampe lampe, Rayon ombre, double distance, Objet3D objet) {
        Point P = ombre.getP();
        Vecteur V = ombre.getV();
        return unAutreCache(0, dAbord, ombre, distance, objet)
                || ombresDe(lampe).cachee(etat, P.x, P.y, P.z, V.x, V.y, V.z, distance, numero(objet))
                || unAutreCache(dAbord, spheres.autres.length, ombre, distance, objet);
    }

    /** Dit si un des objets qui ne sont pas des sphères, de {@code debut} à {@code fin} exclu, cache la lampe. */
    private boolean unAutreCache(int debut, int fin, Rayon ombre, double distance, Objet3D objet) {
        for (int a = debut; a < fin; a++) {
            Objet3D autre = spheres.autres[a];
            if (autre != objet) {
                etat.compteurs.testsSpheres++;
                if (Recherche.verifier(autre.getIntersectionDistance(ombre), autre) < distance) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Temps de construction de l'arbre, avant ou pendant le dessin, en nanosecondes. */
    public long getConstructionNs() {
        return structures.arbre.constructionNs;
    }

    @Override
    public Recherche pourUnFil(Compteurs compteurs) {
        return structures.ecart == null ? new RechercheRapide(structures, compteurs) : null;
    }

    @Override
    public void verifier() {
        if (!spheres.sontEnPlace()) {
            structures.ecart = "une sphère a changé de place ou de rayon après la préparation" + SUITE;
        } else if (structures.ecart == null) {
            String ecart = Sondage.avant(spheres);
            structures.ecart = ecart == null ? null : ecart + SUITE;
        }
    }

    /**
     * {@inheritDoc} Les boucles de beaucoup d'objets sont lentes : elles répondent à peu de rayons, et une scène de
     * quelques-uns de ces objets répond aux autres. Les réponses ne sont comparées qu'une fois.
     */
    @Override
    public boolean differe(Scene dessinee, Camera camera) {
        verifier();
        if (structures.ecart == null && !structures.sondees) {
            structures.sondees = true;
            String ecart = Sondage.ecart(dessinee, spheres, camera);
            List<Objet3D> objets = dessinee.getObjets();
            if (ecart == null && objets.size() > BEAUCOUP) {
                List<Objet3D> quelques = new ArrayList<>();
                for (long k = 0; k < QUELQUES; k++) {
                    quelques.add(objets.get((int) ((2 * k + 1) * objets.size() / (2 * QUELQUES))));
                }
                Scene petite = new Scene(quelques, dessinee.getLampes());
                Structures siennes = new Structures(new Spheres(petite.getObjets()), petite.getLampes());
                petite.getModele().setRecherche(new RechercheRapide(siennes, new Compteurs()));
                ecart = Sondage.ecart(petite, siennes.spheres, camera);
            }
            structures.ecart = ecart == null ? null : ecart + SUITE;
        }
        return structures.ecart != null;
    }

    @Override
    public String getEcart() {
        return structures.ecart;
    }

    /** Nomme les structures que {@link Preparation} a choisies pour cette scène. */
    @Override
    public String toString() {
        return structures.toString();
    }
}
