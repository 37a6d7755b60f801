package lancer.rapide;

import java.util.Arrays;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.Atmosphere;
import lancer.contrat.Compteurs;
import lancer.contrat.Vue;

/**
 * Les équations de {@link Scene#getCouleurVue} et {@link Rayon}, et par {@link Eclairage} celles de {@link Objet3D#getColor}, sur
 * des nombres et en boucle : les mêmes opérations dans le même ordre, donc les mêmes bits. Écrites deux fois parce que les vecteurs
 * immuables de la version lisible, que {@code --simple} rappelle, coûtent 40 % d'une image (mesuré avec la même boucle sur les
 * sphères : scène du cours, 800 × 600, deux fils, 90 ms contre 53) ; {@code IdentiteTest} compare les deux sur chaque pixel.
 * Appartient à un fil ; rien n'est alloué par rayon, sauf la couleur rendue. Une première image ne dure que le temps de compiler ce
 * qu'elle exécute : {@link #suivre} et {@link Eclairage#eclairer}, trop longues pour être incorporées à celles qui les appellent, le
 * sont une fois chacune.
 */
final class Traceur implements Vue {

    private final Scene scene;
    private final Camera camera;
    /** Vrai si la caméra est celle de la base, dont on connaît le calcul. */
    private final boolean cameraConnue;
    private final int profondeur;
    private final double seuil;
    private final Atmosphere atmosphere;
    private final boolean claire;
    /** Vrai si un rayon qui ne rencontre aucune sphère peut voir autre chose que le ciel. */
    private final boolean particuliere;
    private final RechercheRapide recherche;
    private final Spheres spheres;
    private final Voisins premiers;
    private final Voisins suivants;
    private final Sonde sonde;
    private final Eclairage eclairage;
    private final Compteurs compteurs;

    /** La dernière ordonnée : les pixels d'une ligne l'ont en commun. */
    private double derniereYe = Double.NaN;
    private double derniereY;

    /** Ce que voit le rayon en cours. */
    private double r;
    private double v;
    private double b;

    /** Par niveau de réflexion : couleur propre du contact, Ks, longueur du rayon qui y mène. */
    private static final int PAS_NIVEAU = 7;
    private double[] niveaux = new double[PAS_NIVEAU * 8];

    Traceur(RechercheRapide recherche, Sonde sonde, Lancer lancer, int profondeur) {
        this.recherche = recherche;
        this.profondeur = profondeur;
        this.sonde = sonde;
        scene = lancer.getScene();
        compteurs = scene.getCompteurs();
        camera = lancer.getCamera();
        cameraConnue = camera.getClass() == Camera.class;
        seuil = scene.getSeuil();
        atmosphere = scene.getAtmosphere();
        claire = atmosphere == Atmosphere.CLAIRE;
        spheres = recherche.getSpheres();
        particuliere = !claire || spheres.autres.length > 0;
        premiers = recherche.premiers(camera);
        suivants = recherche.suivants();
        eclairage = new Eclairage(recherche, sonde, scene);
    }

    @Override
    public Couleur couleur(double xe, double ye) {
        // à part et courte, donc incorporée à la boucle sur les pixels, où la couleur n'est alors plus allouée
        suivre(xe, ye);
        return new Couleur(r, v, b);
    }

    /** Le rayon d'un pixel et ses reflets, jusqu'à la couleur vue, dans (r, v, b). */
    private void suivre(double xe, double ye) {
        compteurs.primaires++;
        double px;
        double py;
        double pz;
        double vx;
        double vy;
        double vz;
        if (cameraConnue) {
            if (ye != derniereYe) {
                derniereYe = ye;
                derniereY = camera.getY(ye);
            }
            px = camera.getX(xe);
            py = derniereY;
            pz = 0;
            vx = px - Camera.OEIL.x;
            vy = py - Camera.OEIL.y;
            vz = 0 - Camera.OEIL.z;
            // la focale garde cette norme loin des extrêmes
            double inverse = 1 / Math.sqrt(vx * vx + vy * vy + vz * vz);
            vx *= inverse;
            vy *= inverse;
            vz *= inverse;
        } else {
            Rayon rayon = camera.getRayon(xe, ye);
            Point P = rayon.getP();
            Vecteur V = rayon.getV();
            px = P.x;
            py = P.y;
            pz = P.z;
            vx = V.x;
            vy = V.y;
            vz = V.z;
        }
        int k = premiers.plusProche(sonde, px, py, pz, vx, vy, vz, -1);
        if (k < 0 && !particuliere) {
            ciel(vy);
            return;
        }
        double produitR = 1;
        double produitV = 1;
        double produitB = 1;
        int niveau = 0;
        while (true) {
            double distance = sonde.distance;
            if (spheres.autres.length > 0 && autre(k, niveau, new Rayon(new Point(px, py, pz), new Vecteur(vx, vy, vz),
                    new Couleur(produitR, produitV, produitB)))) {
                break;
            }
            if (k < 0) {
                ciel(vy);
                traverser(Constantes.INFINI);
                break;
            }
            px += vx * distance;
            py += vy * distance;
            pz += vz * distance;
            double[] g = spheres.geometrie;
            int s = Spheres.PAS * k;
            double nx = px - g[s];
            double ny = py - g[s + 1];
            double nz = pz - g[s + 2];
            double carre = nx * nx + ny * ny + nz * nz;
            if (carre >= Vecteur.NORME2_MIN && carre <= Vecteur.NORME2_MAX) {
                double ecart = Sphere.ecart(carre, g[s + 3]);
                px -= nx * ecart;
                py -= ny * ecart;
                pz -= nz * ecart;
            } else {
                Point p = spheres.objet(k).getPointDeSurface(new Point(px, py, pz));
                px = p.x;
                py = p.y;
                pz = p.z;
            }
            int n = PAS_NIVEAU * niveau;
            if (n == niveaux.length) {
                niveaux = Arrays.copyOf(niveaux, 2 * n);
            }
            niveaux[n + 6] = distance;
            eclairage.eclairer(k, niveaux, n, px, py, pz, vx, vy, vz);
            double ksR = niveaux[n + 3];
            double ksV = niveaux[n + 4];
            double ksB = niveaux[n + 5];
            produitR *= ksR;
            produitV *= ksV;
            produitB *= ksB;
            if (niveau >= profondeur || ksR == 0 && ksV == 0 && ksB == 0
                    || !(Math.max(produitR, Math.max(produitV, produitB)) >= seuil)) {
                r = niveaux[n];
                v = niveaux[n + 1];
                b = niveaux[n + 2];
                traverser(distance);
                break;
            }
            compteurs.reflechis++;
            niveau++;
            vx = eclairage.rx;
            vy = eclairage.ry;
            vz = eclairage.rz;
            k = suivants.plusProche(sonde, px, py, pz, vx, vy, vz, k);
        }
        if (niveau > 0) {
            replier(niveau);
        }
    }

    /**
     * Vrai si le rayon rencontre d'abord un objet que ce paquet ne connaît pas : sa couleur est son affaire, réflexions
     * comprises.
     */
    private boolean autre(int k, int niveau, Rayon rayon) {
        Objet3D autre = recherche.autrePlusProche(rayon, sonde.distance, k, null);
        if (autre == null) {
            return false;
        }
        PointContact contact = rayon.calcContact();
        poser(atmosphere.traverser(autre.getColor(scene, rayon, contact, profondeur - niveau), contact.distance));
        return true;
    }

    /** {@link Rayon#getSkyColor}. */
    private void ciel(double vy) {
        if (vy > 0) {
            double bas = 1 - vy;
            r = 0.7 * bas;
            v = 0.7 * bas;
            b = bas + vy;
        } else {
            r = 0.5;
            v = 0.4 + 0.2 * vy;
            b = 0.1;
        }
    }

    private void traverser(double distance) {
        if (!claire) {
            poser(atmosphere.traverser(new Couleur(r, v, b), distance));
        }
    }

    private void poser(Couleur c) {
        r = c.r;
        v = c.v;
        b = c.b;
    }

    /** Du dernier contact au premier, dans l'ordre où la récursion le ferait. */
    private void replier(int niveau) {
        double[] t = niveaux;
        int n = PAS_NIVEAU * niveau;
        while (n != 0) {
            n -= PAS_NIVEAU;
            r = t[n] + t[n + 3] * r;
            v = t[n + 1] + t[n + 4] * v;
            b = t[n + 2] + t[n + 5] * b;
            traverser(t[n + 6]);
        }
    }
}
