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
 * Les objets que peut rencontrer un rayon. Viennent d'abord les géants et les objets libres. Puis, si le rayon vient de
 * l'œil ou d'une lampe, ceux qui se voient dans sa direction ; sinon, ceux des cellules qu'il traverse (Amanatides et
 * Woo, <i>A Fast Voxel Traversal Algorithm for Ray Tracing</i>, 1987). Là où elles donnent trop d'objets, l'arbre les
 * remplace.
 */
// chercher et ouvrir sont d'un seul tenant : HotSpot recopie dans chaque boucle ce qui a moins de 325 octets
final class Question implements Iterable<Objet3D>, Iterator<Objet3D> {

    /** Nombre d'examens au-delà duquel l'arbre remplace les cellules, et d'objets d'un cube trop plein. */
    private static final int EXAMENS_MAX = 100;
    private static final int PLEINE = 30;

    /** Un peu moins que 1 : l'écart couvre 512 arrondis, dont ceux d'une distance et d'une direction. */
    private static final double PRESQUE_UN = 1 - 0x1p-44;

    /** Plus petite composante de la direction dont l'inverse sert, à la place d'une plus petite : rien n'y déborde. */
    private static final double COMPOSANTE_MIN = 1e-180;

    /** Écart permis à 1 du carré de la longueur d'une direction. */
    private static final double UNITAIRE = 1e-14;

    /** Ce qui donne la suite : rien encore, les cellules de l'espace, l'arbre, plus rien. */
    private static final int DEBUT = 0;
    private static final int ESPACE = 1;
    private static final int ARBRE = 2;
    private static final int FIN = 3;

    private final Consumer<Question> suivi;
    private final Structures structures;
    private final Compteurs compteurs;
    private final double[] g;
    private Rayon rayon;
    private Objet3D depart;
    private boolean ombre;
    private double px;
    private double py;
    private double pz;
    private double vx;
    private double vy;
    private double vz;
    /** Les inverses de la direction, une fois l'arbre ouvert. */
    private double ix;
    private double iy;
    private double iz;
    private double limite;

    private int etape;
    private int examens;

    /** La liste en cours, la place suivante, la place de fin. */
    private int[] liste;
    private int place;
    private int fin;
    /** Dit si la liste va de l'enveloppe la plus proche d'un point de vue à la plus lointaine. */
    private boolean triee;
    /** Ce que l'erreur du tri ajoute à la limite. */
    private double lache;

    /** L'objet proposé, s'il est prêt ; −1 à la fin. */
    private int propose;
    private boolean pret;
    /** Le rang de {@link #depart}, proposé d'abord ; −1 s'il n'est pas connu. */
    private int rangDepart;
    /** Le premier proposé des plus proches, le premier d'entre eux dans la scène, et leur distance. */
    private int proche;
    private int premier;
    private double distance;

    /** Le cube en cours ; par axe, la distance du bord suivant, celle entre deux bords, le pas, les cubes de reste. */
    private int cube;
    private double tx;
    private double ty;
    private double tz;
    private double dx;
    private double dy;
    private double dz;
    private int pasX;
    private int pasY;
    private int pasZ;
    private int resteX;
    private int resteY;
    private int resteZ;

    /** Nœuds à visiter, bornes inférieures de leurs distances, hauteur de la pile. */
    private int[] pile;
    private double[] entrees;
    private int haut;

    /** @param suivi reçoit cette question chaque fois qu'elle propose */
    Question(Consumer<Question> suivi, Structures structures, Compteurs compteurs) {
        this.suivi = suivi;
        this.structures = structures;
        this.compteurs = compteurs;
        g = structures.enveloppes.geometrie;
    }

    /** Recommence, pour ce rayon. @param rang celui de l'objet de départ, −1 s'il n'est pas connu */
    Question poser(Rayon nouveau, Objet3D objet, int rang, double portee) {
        rayon = nouveau;
        depart = objet;
        rangDepart = rang;
        propose = rang;
        pret = rang >= 0;
        proche = -1;
        distance = Constantes.INFINI;
        ombre = portee < Constantes.INFINI;
        limite = portee;
        Point p = nouveau.getP();
        Vecteur v = nouveau.getV();
        vx = v.x;
        vy = v.y;
        vz = v.z;
        boolean mesure = Math.abs(vx * vx + vy * vy + vz * vz - 1) < UNITAIRE
                && Math.abs(p.x) + Math.abs(p.y) + Math.abs(p.z) < Enveloppes.LONGUEUR_MAX;
        px = mesure ? p.x : Double.NaN;
        py = p.y;
        pz = p.z;
        etape = DEBUT;
        examens = 0;
        triee = false;
        lache = 0;
        haut = -1;
        lire(structures.enveloppes.dAbord, 0, structures.enveloppes.dAbord.length);
        return this;
    }

    /** Dit si tous les candidats ont été proposés. */
    boolean estFinie() {
        return pret && propose < 0;
    }

    /** Voir {@link Recherche#limiter}. */
    void limiter(double distanceMax) {
        limite = Math.min(limite, distanceMax);
    }

    /** Si l'objet de ce rang est le plus proche, le rang du premier, dans la scène, des objets à la même distance. */
    int aEgalite(Objet3D plusProche) {
        return proche >= 0 && structures.enveloppes.objets[proche] == plusProche ? premier : -1;
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
        return propose >= 0;
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
     * Note la réponse, puis cherche l'objet suivant dont le rayon peut toucher l'enveloppe. L'erreur sur f² − b² est au
     * plus 512 u f². NaN, d'un objet libre ou d'un rayon démesuré, peut tout toucher.
     */
    private void chercher() {
        if (propose >= 0) {
            noterLaReponse();
        }
        pret = true;
        int avant = examens;
        do {
            int[] rangs = liste;
            double auPlus = limite + lache;
            while (place < fin) {
                int k = rangs[place++];
                examens++;
                int s = Enveloppes.PAS * k;
                double fx = g[s] - px;
                double fy = g[s + 1] - py;
                double fz = g[s + 2] - pz;
                double r = g[s + 3];
                double b = fx * vx + fy * vy + fz * vz;
                if (b * (1 - PointDeVue.ARRONDI_DU_TRI) - r > auPlus) {
                    if (triee) {
                        // les suivants sont encore plus loin
                        place = fin;
                        etape = FIN;
                    }
                } else if (k != rangDepart && k != proche && k != propose
                        && !((fx * fx + fy * fy + fz * fz) * PRESQUE_UN - b * b > r * r || b < -r)) {
                    compteurs.noeudsVisites += examens - avant - 1;
                    propose = k;
                    return;
                }
            }
        } while (ouvrir());
        compteurs.noeudsVisites += examens - avant;
        propose = -1;
    }

    /** Ouvre la liste suivante. @return faux s'il n'y en a plus */
    private boolean ouvrir() {
        examens++;
        if (etape == DEBUT) {
            PointDeVue vue = null;
            if (ombre) {
                vue = structures.vues.get(rayon.getP());
            } else if (depart == null && structures.oeil != null && structures.oeil.envoie(px, py, pz, vx, vy, vz)) {
                vue = structures.oeil;
            }
            if (Double.isNaN(px)) {
                etape = FIN;
                lire(structures.enveloppes.petits, 0, structures.enveloppes.petits.length);
            } else if (vue != null) {
                Cellules c = vue.cellules;
                int direction = c.cubeDe(vx, vy, vz);
                etape = FIN;
                if (direction >= 0) {
                    triee = true;
                    lache = vue.erreur(px, py, pz);
                    lire(c.objets, c.debut[direction], c.debut[direction + 1]);
                    if (fin - place > EXAMENS_MAX) {
                        fin = place + EXAMENS_MAX;
                        etape = ARBRE;
                    }
                }
            } else {
                boolean pres = Math.abs(px) + Math.abs(py) + Math.abs(pz) <= structures.portee;
                etape = structures.espace != null && pres ? ESPACE : ARBRE;
                if (etape == ESPACE) {
                    entrer();
                }
            }
            if (place < fin) {
                return true;
            }
        }
        if (etape == ESPACE) {
            if (avancer()) {
                return true;
            }
            etape = etape == ARBRE || examens > EXAMENS_MAX ? ARBRE : FIN;
        }
        return etape == ARBRE && descendre();
    }

    private void lire(int[] celle, int debut, int apres) {
        liste = celle;
        place = debut;
        fin = apres;
    }

    private static double inverse(double v) {
        return 1 / (Math.abs(v) < COMPOSANTE_MIN ? COMPOSANTE_MIN : v);
    }

    /** Place le rayon dans le premier cube qu'il traverse, et en ouvre la liste. */
    private void entrer() {
        Cellules c = structures.espace;
        double wx = inverse(vx);
        double wy = inverse(vy);
        double wz = inverse(vz);
        double ax = (c.x0 - px) * wx;
        double ay = (c.y0 - py) * wy;
        double az = (c.z0 - pz) * wz;
        dx = c.cote * wx;
        dy = c.cote * wy;
        dz = c.cote * wz;
        double bx = ax + c.nx * dx;
        double by = ay + c.ny * dy;
        double bz = az + c.nz * dz;
        double entree = Math.max(0, Math.max(Math.min(ax, bx), Math.max(Math.min(ay, by), Math.min(az, bz))));
        double sortie = Math.min(Math.max(ax, bx), Math.min(Math.max(ay, by), Math.max(az, bz)));
        if (entree > Math.min(sortie, limite) + c.marge) {
            etape = FIN;
            return;
        }
        int i = Math.max(0, Math.min((int) ((px + entree * vx - c.x0) * c.parCote), c.nx - 1));
        int j = Math.max(0, Math.min((int) ((py + entree * vy - c.y0) * c.parCote), c.ny - 1));
        int l = Math.max(0, Math.min((int) ((pz + entree * vz - c.z0) * c.parCote), c.nz - 1));
        tx = ax + (wx > 0 ? i + 1 : i) * dx;
        ty = ay + (wy > 0 ? j + 1 : j) * dy;
        tz = az + (wz > 0 ? l + 1 : l) * dz;
        resteX = wx > 0 ? c.nx - 1 - i : i;
        resteY = wy > 0 ? c.ny - 1 - j : j;
        resteZ = wz > 0 ? c.nz - 1 - l : l;
        pasX = wx > 0 ? c.ny * c.nz : -c.ny * c.nz;
        pasY = wy > 0 ? c.nz : -c.nz;
        pasZ = wz > 0 ? 1 : -1;
        dx = Math.abs(dx);
        dy = Math.abs(dy);
        dz = Math.abs(dz);
        cube = (i * c.ny + j) * c.nz + l;
        ouvrirLeCube(c);
    }

    /** Ouvre la liste de ce cube ou, si elle est trop pleine, passe à l'arbre. */
    private void ouvrirLeCube(Cellules c) {
        lire(c.objets, c.debut[cube], c.debut[cube + 1]);
        if (fin - place > PLEINE) {
            place = fin;
            etape = ARBRE;
        }
    }

    /** Va au cube suivant qui n'est pas vide. @return faux si le rayon sort, a sa réponse ou a trop cherché */
    private boolean avancer() {
        Cellules c = structures.espace;
        double jusque = limite + c.marge;
        while (etape == ESPACE && examens <= EXAMENS_MAX) {
            examens++;
            if (tx <= ty && tx <= tz) {
                if (tx > jusque || resteX-- == 0) {
                    return false;
                }
                cube += pasX;
                tx += dx;
            } else if (ty <= tz) {
                if (ty > jusque || resteY-- == 0) {
                    return false;
                }
                cube += pasY;
                ty += dy;
            } else {
                if (tz > jusque || resteZ-- == 0) {
                    return false;
                }
                cube += pasZ;
                tz += dz;
            }
            ouvrirLeCube(c);
            if (place < fin) {
                return true;
            }
        }
        return false;
    }

    /** Cherche la feuille suivante de l'arbre, de la boîte la plus proche à la plus lointaine. @return faux à la fin */
    private boolean descendre() {
        Arbre arbre = structures.getArbre();
        if (pile == null) {
            pile = new int[Arbre.PROFONDEUR_MAX];
            entrees = new double[Arbre.PROFONDEUR_MAX];
        }
        if (haut < 0) {
            triee = false;
            ix = inverse(vx);
            iy = inverse(vy);
            iz = inverse(vz);
            haut = arbre.feuilles.length == 0 ? 0 : 1;
            pile[0] = 0;
            entrees[0] = 0;
        }
        double[] q = arbre.boites;
        double marge = Arbre.MARGE * Enveloppes.plusGrande(px, py, pz);
        while (haut > 0) {
            if (entrees[--haut] > limite) {
                continue;
            }
            int n = pile[haut];
            // descend par l'enfant le plus proche jusqu'à une feuille ; l'autre enfant va dans la pile
            while (n >= 0 && arbre.compte[n] == 0) {
                examens += 2;
                int s = arbre.suite[n];
                double e0 = entree(q, Arbre.PAS * s, marge);
                double e1 = entree(q, Arbre.PAS * s + Arbre.PAS, marge);
                if (e0 <= limite && e1 <= limite) {
                    boolean gauche = e0 <= e1;
                    pile[haut] = gauche ? s + 1 : s;
                    entrees[haut++] = gauche ? e1 : e0;
                    n = gauche ? s : s + 1;
                } else {
                    n = e0 <= limite ? s : e1 <= limite ? s + 1 : -1;
                }
            }
            if (n >= 0) {
                lire(arbre.feuilles, arbre.suite[n], arbre.suite[n] + arbre.compte[n]);
                return true;
            }
        }
        return false;
    }

    /** La distance où le rayon entre dans cette boîte, arrondie par défaut ; NaN s'il ne la rencontre pas. */
    private double entree(double[] q, int b, double marge) {
        double x = (q[b] - px) * ix;
        double y = (q[b + 1] - py) * iy;
        double z = (q[b + 2] - pz) * iz;
        double ex = (q[b + 3] + marge) * Math.abs(ix);
        double ey = (q[b + 4] + marge) * Math.abs(iy);
        double ez = (q[b + 5] + marge) * Math.abs(iz);
        double entree = Math.max(x - ex, Math.max(y - ey, z - ez));
        double sortie = Math.min(x + ex, Math.min(y + ey, z + ez));
        return entree <= sortie && sortie >= 0 ? entree : Double.NaN;
    }
}
