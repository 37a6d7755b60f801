package lancer.rapide;

import java.util.Arrays;
import java.util.List;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
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
import lancer.contrat.Specularite;
import lancer.contrat.Vue;

/**
 * Les équations de {@link Objet3D#getColor}, {@link Scene#getCouleurVue} et {@link Rayon}, sur des nombres et en boucle : les
 * mêmes opérations dans le même ordre, donc les mêmes bits. Écrites deux fois parce que les vecteurs immuables de la version
 * lisible, que {@code --simple} rappelle, coûtent 40 % d'une image (mesuré avec la même boucle sur les sphères : scène du cours,
 * 800 × 600, deux fils, 90 ms contre 53) ; {@code IdentiteTest} compare les deux sur chaque pixel. Appartient à un fil ; rien
 * n'est alloué par rayon, sauf la couleur rendue. Une première image ne dure que le temps de compiler ce qu'elle exécute :
 * {@link #suivre} et {@link #eclairer}, trop longues pour être incorporées à celles qui les appellent, le sont une fois chacune.
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
    private final Specularite specularite;
    private final boolean phong;

    private final RechercheRapide recherche;
    private final Spheres spheres;
    private final Voisins premiers;
    private final Voisins suivants;
    private final Obstacles[] obstacles;
    private final double[] lampes;
    private final Lampe[] objetsLampes;
    private final Sonde sonde;
    private final Compteurs compteurs;

    /** La dernière ordonnée : les pixels d'une ligne l'ont en commun. */
    private double derniereYe = Double.NaN;
    private double derniereY;

    /** Le rayon qui part du contact. */
    private double rx;
    private double ry;
    private double rz;

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
        specularite = scene.getSpecularite();
        phong = specularite == Specularite.PHONG;
        spheres = recherche.getSpheres();
        particuliere = !claire || spheres.autres.length > 0;
        premiers = recherche.premiers(camera);
        suivants = recherche.suivants();
        obstacles = recherche.obstacles();
        List<Lampe> liste = scene.getLampes();
        objetsLampes = liste.toArray(new Lampe[0]);
        lampes = new double[6 * liste.size()];
        for (int l = 0; l < objetsLampes.length; l++) {
            Point p = objetsLampes[l].getPosition();
            Couleur c = objetsLampes[l].getCouleur();
            double[] nombres = {p.x, p.y, p.z, c.r, c.v, c.b};
            System.arraycopy(nombres, 0, lampes, 6 * l, 6);
        }
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
            eclairer(k, n, px, py, pz, vx, vy, vz);
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
            vx = rx;
            vy = ry;
            vz = rz;
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

    /** La couleur propre du contact et son Ks, au niveau n ; la direction du reflet dans (rx, ry, rz). */
    private void eclairer(int k, int n, double px, double py, double pz, double vx, double vy, double vz) {
        double[] g = spheres.geometrie;
        int s = Spheres.PAS * k;
        double parRayon = 1 / g[s + 3];
        double nx = (px - g[s]) * parRayon;
        double ny = (py - g[s + 1]) * parRayon;
        double nz = (pz - g[s + 2]) * parRayon;
        double carre = nx * nx + ny * ny + nz * nz;
        if (Math.abs(carre - 1) <= Vecteur.PRESQUE_UN) {
            double correction = 1.5 - 0.5 * carre;
            nx *= correction;
            ny *= correction;
            nz *= correction;
        } else {
            Vecteur N = spheres.objet(k).getNormale(new Point(px, py, pz));
            nx = N.x;
            ny = N.y;
            nz = N.z;
        }
        double deuxVN = 2 * (vx * nx + vy * ny + vz * nz);
        double ux = vx - nx * deuxVN;
        double uy = vy - ny * deuxVN;
        double uz = vz - nz * deuxVN;
        double carreR = ux * ux + uy * uy + uz * uz;
        if (Math.abs(carreR - 1) <= Vecteur.PRESQUE_UN) {
            double correction = 1.5 - 0.5 * carreR;
            ux *= correction;
            uy *= correction;
            uz *= correction;
        } else {
            Vecteur R = new Vecteur(ux, uy, uz).normalized();
            ux = R.x;
            uy = R.y;
            uz = R.z;
        }
        rx = ux;
        ry = uy;
        rz = uz;

        double[] m = spheres.matieres;
        int a = spheres.matiere[k];
        double kdR = m[a];
        double kdV = m[a + 1];
        double kdB = m[a + 2];
        double ksR = m[a + 3];
        double ksV = m[a + 4];
        double ksB = m[a + 5];
        boolean mate = ksR == 0 && ksV == 0 && ksB == 0;
        double propreR = 0;
        double propreV = 0;
        double propreB = 0;
        double[] l = lampes;
        for (int i = 0, j = 0; j < l.length; i++, j += 6) {
            double lx = l[j] - px;
            double ly = l[j + 1] - py;
            double lz = l[j + 2] - pz;
            if (!(nx * lx + ny * ly + nz * lz > 0)) {
                continue;
            }
            double carreL = lx * lx + ly * ly + lz * lz;
            double versLampe;
            if (carreL >= Vecteur.NORME2_MIN && carreL <= Vecteur.NORME2_MAX) {
                versLampe = Math.sqrt(carreL);
                double inverse = 1 / versLampe;
                lx *= inverse;
                ly *= inverse;
                lz *= inverse;
            } else {
                Vecteur L = new Vecteur(lx, ly, lz);
                versLampe = L.norme();
                L = L.normalized();
                lx = L.x;
                ly = L.y;
                lz = L.z;
            }
            double diffus = Math.min(1, nx * lx + ny * ly + nz * lz);
            double kR = l[j + 3];
            double kV = l[j + 4];
            double kB = l[j + 5];
            double aR = kdR * kR * diffus;
            double aV = kdV * kV * diffus;
            double aB = kdB * kB * diffus;
            if (!mate) {
                double ns = m[a + 6];
                double eclat = phong ? Specularite.puissance(ux * lx + uy * ly + uz * lz, ns)
                        : specularite.eclat(new Vecteur(vx, vy, vz), new Vecteur(nx, ny, nz), new Vecteur(lx, ly, lz),
                                new Vecteur(ux, uy, uz), ns);
                aR += ksR * kR * eclat;
                aV += ksV * kV * eclat;
                aB += ksB * kB * eclat;
            }
            if (aR == 0 && aV == 0 && aB == 0) {
                continue;
            }
            // le rayon d'ombre part de la lampe, en sens inverse de L : mêmes longueurs, mêmes bits
            compteurs.ombre++;
            if (obstacles[i].cachee(sonde, l[j], l[j + 1], l[j + 2], -lx, -ly, -lz, versLampe, k)
                    || spheres.autres.length > 0
                    && recherche.autreCache(objetsLampes[i].getPosition(), new Point(px, py, pz), versLampe, null)) {
                continue;
            }
            propreR += aR;
            propreV += aV;
            propreB += aB;
        }
        niveaux[n] = propreR;
        niveaux[n + 1] = propreV;
        niveaux[n + 2] = propreB;
        niveaux[n + 3] = ksR;
        niveaux[n + 4] = ksV;
        niveaux[n + 5] = ksB;
    }
}
