package lancer.rapide;

import java.util.List;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Scene;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.Specularite;

/** L'éclairage d'un contact par les lampes ({@link Objet3D#getColor}), sur des nombres : voir {@link Traceur}. Appartient à un fil. */
final class Eclairage {

    private final RechercheRapide recherche;
    private final Spheres spheres;
    private final Sonde sonde;
    private final Compteurs compteurs;
    private final Specularite specularite;
    private final boolean phong;
    private final Obstacles[] obstacles;
    private final double[] lampes;
    private final Lampe[] objetsLampes;

    /** Le rayon qui part du contact. */
    double rx;
    double ry;
    double rz;

    Eclairage(RechercheRapide recherche, Sonde sonde, Scene scene) {
        this.recherche = recherche;
        this.sonde = sonde;
        spheres = recherche.getSpheres();
        compteurs = scene.getCompteurs();
        specularite = scene.getSpecularite();
        phong = specularite == Specularite.PHONG;
        obstacles = recherche.obstacles();
        List<Lampe> liste = scene.getLampes();
        objetsLampes = liste.toArray(new Lampe[0]);
        lampes = new double[6 * objetsLampes.length];
        for (int l = 0; l < objetsLampes.length; l++) {
            Point p = objetsLampes[l].getPosition();
            Couleur c = objetsLampes[l].getCouleur();
            double[] nombres = {p.x, p.y, p.z, c.r, c.v, c.b};
            System.arraycopy(nombres, 0, lampes, 6 * l, 6);
        }
    }

    /**
     * Écrit à partir du rang n la couleur propre d'un contact puis son Ks, et dans (rx, ry, rz) la direction du reflet.
     *
     * @param k la sphère touchée
     * @param px le contact
     * @param vx la direction du rayon qui y mène
     */
    void eclairer(int k, double[] niveaux, int n, double px, double py, double pz, double vx, double vy, double vz) {
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
