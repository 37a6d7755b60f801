package lancer.rapide;

import java.util.Iterator;
import java.util.NoSuchElementException;
import java.util.function.Consumer;
import lancer.Constantes;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;

/**
 * La question d'un rayon : quels objets demander ? Elle lit des listes d'enveloppes, d'abord celle des géants et des
 * objets libres, puis celles d'une {@link Source}, et propose chaque objet dont l'enveloppe est sur le rayon. Elle
 * vérifie la réponse de cet objet avant d'en proposer un autre.
 *
 * <p>Un objet peut être dans plusieurs listes. Il est proposé de nouveau, sauf s'il est le plus proche, le dernier
 * proposé ou celui d'où part le rayon.
 */
final class Question implements Iterable<Objet3D>, Iterator<Objet3D> {

    /** Un peu moins que 1 : l'écart couvre 512 arrondis, dont ceux d'une distance et d'une direction. */
    private static final double PRESQUE_UN = 1 - 0x1p-44;

    /** Écart permis à 1 du carré de la longueur d'une direction. */
    private static final double UNITAIRE = 1e-14;

    /** Départ d'un rayon démesuré : aucune comparaison avec lui n'est vraie, et il peut toucher toute enveloppe. */
    private static final Point N_IMPORTE_OU = new Point(Double.NaN, Double.NaN, Double.NaN);

    private static final int AUCUN = -1;

    /** Ce qui donne les listes : celle des géants d'abord, puis une source, ou plus rien. */
    private enum Etape { DEBUT, POINT_DE_VUE, CELLULES, ARBRE, FIN }

    private final Consumer<Question> suivi;
    private final Structures structures;
    private final Compteurs compteurs;
    private final double[] g;

    /** La liste en main, et les trois sources des suivantes. */
    private final Liste liste = new Liste();
    private final Visee visee = new Visee();
    private final Marche marche;
    private final Descente descente;
    private Etape etape;

    private Rayon rayon;
    private Objet3D depart;
    private Point p;
    private Vecteur v;
    private boolean ombre;
    /** Distance au-delà de laquelle un contact ne compte plus. */
    private double limite;

    /** Le rang de l'objet proposé, s'il est prêt ; {@link #AUCUN} à la fin. */
    private int propose;
    private boolean pret;
    /** Le rang de {@link #depart}, proposé d'abord, s'il est connu. */
    private int rangDepart;

    /** La plus petite distance rendue, le rang de celui qui l'a rendue d'abord, et le plus petit rang à égalité. */
    private double distance;
    private int proche;
    private int premier;

    /** @param suivi reçoit cette question chaque fois qu'elle propose */
    Question(Consumer<Question> suivi, Structures structures, Compteurs compteurs) {
        this.suivi = suivi;
        this.structures = structures;
        this.compteurs = compteurs;
        g = structures.enveloppes.geometrie;
        marche = new Marche(structures.espace);
        descente = new Descente(structures);
    }

    /** Recommence, pour ce rayon. @param rang celui de l'objet de départ, −1 s'il n'est pas connu */
    Question poser(Rayon rayonPose, Objet3D objetDeDepart, int rang, double portee) {
        rayon = rayonPose;
        depart = objetDeDepart;
        ombre = portee < Constantes.INFINI;
        limite = portee;
        rangDepart = rang;
        propose = rang;
        pret = rang != AUCUN;
        distance = Constantes.INFINI;
        proche = AUCUN;
        etape = Etape.DEBUT;
        p = rayon.getP();
        v = rayon.getV();
        liste.examens = 0;
        int[] rangs = structures.enveloppes.dAbord;
        if (!(Math.abs(v.norme2() - 1) < UNITAIRE
                && Math.abs(p.x) + Math.abs(p.y) + Math.abs(p.z) < Enveloppes.LONGUEUR_MAX)) {
            p = N_IMPORTE_OU;
            etape = Etape.FIN;
            rangs = structures.enveloppes.tous;
        }
        liste.donner(rangs, 0, rangs.length);
        return this;
    }

    /** Dit si tous les candidats ont été proposés. */
    boolean estFinie() {
        return pret && propose == AUCUN;
    }

    /** Voir {@link Recherche#limiter}. */
    void limiter(double distanceMax) {
        limite = Math.min(limite, distanceMax);
    }

    /** Le rang du premier, dans la scène, des objets à la distance du plus proche ; −1 si celui-ci n'a pas répondu. */
    int aEgalite(Objet3D plusProche) {
        return proche != AUCUN && structures.enveloppes.objets[proche] == plusProche ? premier : AUCUN;
    }

    @Override
    public Iterator<Objet3D> iterator() {
        return this;
    }

    @Override
    public boolean hasNext() {
        if (!pret) {
            chercher();
        }
        // une autre question a pu être posée, ou proposer, depuis la précédente
        suivi.accept(this);
        return propose != AUCUN;
    }

    @Override
    public Objet3D next() {
        if (!hasNext()) {
            throw new NoSuchElementException();
        }
        pret = false;
        Objet3D objet = structures.enveloppes.objets[propose];
        if (objet != depart) {
            compteurs.testsSpheres++;
        }
        rayon.setContact(null, Double.NaN);
        return objet;
    }

    /** Vérifie la réponse de l'objet proposé. La boucle ne demande pas celui d'où part le rayon. */
    private void noterLaReponse() {
        Objet3D objet = structures.enveloppes.objets[propose];
        double d = rayon.getDistance();
        if (Double.isNaN(d) && objet != depart) {
            d = Recherche.getDistance(objet, rayon);
        }
        if (d < distance) {
            distance = d;
            proche = propose;
            premier = propose;
        } else if (d == distance && propose < premier) {
            premier = propose;
        }
    }

    /**
     * Note la réponse, puis cherche dans les listes l'objet suivant dont le rayon peut toucher l'enveloppe. Soit
     * f = C − P et b = f·V : l'erreur sur f² − b² est au plus 512 u f². Coupée en méthodes plus courtes, recopiées dans
     * chaque boucle, celle-ci ralentirait une première image de 1,18 à 1,36 fois.
     */
    private void chercher() {
        if (propose != AUCUN) {
            noterLaReponse();
        }
        pret = true;
        int avant = liste.examens;
        double px = p.x;
        double py = p.y;
        double pz = p.z;
        double vx = v.x;
        double vy = v.y;
        double vz = v.z;
        do {
            int[] rangs = liste.rangs;
            int fin = liste.fin;
            for (int place = liste.place; place < fin; place++) {
                int rang = rangs[place];
                int s = Enveloppes.PAS * rang;
                double fx = g[s] - px;
                double fy = g[s + 1] - py;
                double fz = g[s + 2] - pz;
                double r = g[s + 3];
                double b = fx * vx + fy * vy + fz * vz;
                double f2 = fx * fx + fy * fy + fz * fz;
                // NaN, d'un objet libre ou d'un rayon démesuré, rend tout faux : il peut tout toucher
                if (!(b * PRESQUE_UN - r > limite || f2 * PRESQUE_UN - b * b > r * r || b < -r)
                        && rang != rangDepart && rang != proche && rang != propose) {
                    liste.examens += place - liste.place;
                    liste.place = place + 1;
                    compteurs.noeudsVisites += liste.examens - avant;
                    propose = rang;
                    return;
                }
            }
            liste.examens += fin - liste.place;
        } while (ouvrir());
        compteurs.noeudsVisites += liste.examens - avant;
        propose = AUCUN;
    }

    /**
     * Demande la liste suivante à la source la moins chère pour ce rayon. La coupe ralentirait comme celle de
     * {@link #chercher}.
     *
     * @return faux s'il n'y en a plus
     */
    private boolean ouvrir() {
        if (etape == Etape.DEBUT) {
            PointDeVue vue = ombre ? structures.vues.get(p) : structures.oeil;
            if (vue != null && (ombre || depart == null && vue.envoie(p, v))) {
                etape = Etape.POINT_DE_VUE;
                visee.viser(vue, p, v);
            } else if (structures.espace != null
                    && Math.abs(p.x) + Math.abs(p.y) + Math.abs(p.z) <= structures.portee) {
                etape = Etape.CELLULES;
                marche.entrer(p, v);
            } else {
                etape = Etape.ARBRE;
                descente.commencer(p, v);
            }
        }
        Source.Suite suite = Source.Suite.FIN;
        if (etape == Etape.POINT_DE_VUE) {
            suite = visee.suivante(liste, limite);
        } else if (etape == Etape.CELLULES) {
            suite = marche.suivante(liste, limite);
        }
        if (suite == Source.Suite.TROP) {
            etape = Etape.ARBRE;
            descente.commencer(p, v);
        }
        if (etape == Etape.ARBRE) {
            suite = descente.suivante(liste, limite);
        }
        return suite == Source.Suite.LISTE;
    }
}
