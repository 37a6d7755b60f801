package lancer.rapide;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Objet3D;
import lancer.Point;
import lancer.Sphere;

/**
 * Les sphères d'une scène recopiées à plat, chacune sous un numéro : 32 octets de géométrie, qui tiennent dans une moitié de
 * ligne de cache, et le rang de sa matière dans une palette. La copie date de la préparation : une matière changée ensuite
 * n'est vue qu'à la préparation suivante. Les objets d'une autre classe, filles de {@link Sphere} comprises, sont à part.
 */
final class Spheres {

    /** Nombres par sphère dans {@link #geometrie} : centre, rayon. */
    static final int PAS = 4;

    /** Nombres par matière dans {@link #matieres} : Kd, Ks, ns. */
    static final int PAS_MATIERE = 7;

    final int nombre;
    double[] geometrie;
    /** Rang dans {@link #matieres}, déjà multiplié par {@link #PAS_MATIERE}. */
    int[] matiere;
    /** Rang dans la scène : il départage deux contacts à la même distance. */
    int[] rang;
    double[] matieres = new double[PAS_MATIERE * 16];
    private int nombreMatieres;

    /** Les objets qui ne sont pas exactement des sphères, et leur rang dans la scène. */
    final Objet3D[] autres;
    final int[] rangAutres;

    private final List<Objet3D> objets;
    private Map<Objet3D, Integer> numeros;

    Spheres(List<Objet3D> objets) {
        this.objets = objets;
        int n = 0;
        for (Objet3D objet : objets) {
            if (objet.getClass() == Sphere.class) {
                n++;
            }
        }
        nombre = n;
        geometrie = new double[PAS * n];
        matiere = new int[n];
        rang = new int[n];
        autres = new Objet3D[objets.size() - n];
        rangAutres = new int[autres.length];
        Map<Matiere, Integer> palette = new HashMap<>();
        Matiere derniere = null;
        int derniereAdresse = 0;
        int k = 0;
        int a = 0;
        int r = 0;
        for (Objet3D objet : objets) {
            if (objet.getClass() != Sphere.class) {
                autres[a] = objet;
                rangAutres[a++] = r++;
                continue;
            }
            Sphere s = (Sphere) objet;
            Point c = s.getCentre();
            geometrie[PAS * k] = c.x;
            geometrie[PAS * k + 1] = c.y;
            geometrie[PAS * k + 2] = c.z;
            geometrie[PAS * k + 3] = s.getRayon();
            rang[k] = r++;
            if (derniere == null || !derniere.estCelleDe(s)) {
                derniere = new Matiere(s);
                Integer adresse = palette.get(derniere);
                if (adresse == null) {
                    adresse = ajouter(derniere);
                    palette.put(derniere, adresse);
                }
                derniereAdresse = adresse;
            }
            matiere[k++] = derniereAdresse;
        }
    }

    private int ajouter(Matiere m) {
        int adresse = PAS_MATIERE * nombreMatieres++;
        if (adresse + PAS_MATIERE > matieres.length) {
            matieres = java.util.Arrays.copyOf(matieres, 2 * matieres.length);
        }
        matieres[adresse] = m.Kd.r;
        matieres[adresse + 1] = m.Kd.v;
        matieres[adresse + 2] = m.Kd.b;
        matieres[adresse + 3] = m.Ks.r;
        matieres[adresse + 4] = m.Ks.v;
        matieres[adresse + 5] = m.Ks.b;
        matieres[adresse + 6] = m.ns;
        return adresse;
    }

    /** Range les sphères dans un ordre nouveau : la sphère {@code ordre[k]} devient la k-ième. */
    void ranger(int[] ordre) {
        double[] g = new double[geometrie.length];
        int[] m = new int[nombre];
        int[] r = new int[nombre];
        for (int k = 0; k < nombre; k++) {
            System.arraycopy(geometrie, PAS * ordre[k], g, PAS * k, PAS);
            m[k] = matiere[ordre[k]];
            r[k] = rang[ordre[k]];
        }
        geometrie = g;
        matiere = m;
        rang = r;
    }

    /** Vrai si un contact à {@code d} avec la sphère k passe avant celui à {@code distance} avec la sphère {@code autre}. */
    boolean avant(double d, int k, double distance, int autre) {
        return d < distance || d == distance && d != Constantes.INFINI && rang[k] < rang[autre];
    }

    /** La sphère de ce numéro. */
    Objet3D objet(int k) {
        return objets.get(rang[k]);
    }

    /** Le numéro de cet objet, -1 si ce n'en est pas un. La table n'est faite que si un autre objet la demande. */
    synchronized int numero(Objet3D objet) {
        if (objet == null || objet.getClass() != Sphere.class) {
            return -1;
        }
        if (numeros == null) {
            numeros = new IdentityHashMap<>(2 * nombre);
            for (int k = 0; k < nombre; k++) {
                numeros.put(objet(k), k);
            }
        }
        Integer k = numeros.get(objet);
        return k == null ? -1 : k;
    }

    /** Une matière, égale à toute autre de mêmes nombres. */
    private static final class Matiere {

        private final Couleur Kd;
        private final Couleur Ks;
        private final double ns;

        Matiere(Sphere s) {
            Kd = s.getKd();
            Ks = s.getKs();
            ns = s.getNs();
        }

        boolean estCelleDe(Sphere s) {
            return s.getKd() == Kd && s.getKs() == Ks && s.getNs() == ns;
        }

        @Override
        public int hashCode() {
            return 31 * (31 * Kd.hashCode() + Ks.hashCode()) + Double.hashCode(ns);
        }

        @Override
        public boolean equals(Object autre) {
            if (!(autre instanceof Matiere)) {
                return false;
            }
            Matiere m = (Matiere) autre;
            return Kd.equals(m.Kd) && Ks.equals(m.Ks) && Double.compare(ns, m.ns) == 0;
        }
    }
}
