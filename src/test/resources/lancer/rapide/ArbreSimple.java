package lancer.rapide;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import lancer.Constantes;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Sphere;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;

/**
 * L'étalon des comptes : un arbre de boîtes et rien d'autre, écrit sur les classes du cours. Coupes au moindre coût
 * (seize tranches par axe), feuilles de quatre sphères au plus, l'enfant proche d'abord. Ses boîtes sont bien plus larges
 * qu'il ne faut : ce qu'il trouve est ce que trouvent les boucles.
 */
public final class ArbreSimple implements Recherche {

    private static final int TRANCHES = 16;
    private static final double MARGE = 1e-12;

    private final List<Objet3D> objets;
    private final double[][] geometrie;
    private final Noeud racine;
    private final Compteurs compteurs;
    private double distance;
    private int trouve;

    public ArbreSimple(List<Objet3D> objets, Compteurs compteurs) {
        this.objets = objets;
        this.compteurs = compteurs;
        geometrie = new double[objets.size()][];
        List<Integer> tous = new ArrayList<>();
        for (int k = 0; k < objets.size(); k++) {
            tous.add(k);
            Sphere s = (Sphere) objets.get(k);
            Point c = s.getCentre();
            geometrie[k] = new double[] {c.x, c.y, c.z, s.getRayon()};
        }
        racine = tous.isEmpty() ? null : noeud(tous);
    }

    private ArbreSimple(ArbreSimple autre, Compteurs compteurs) {
        objets = autre.objets;
        geometrie = autre.geometrie;
        racine = autre.racine;
        this.compteurs = compteurs;
    }

    private static final class Noeud {
        final double[] bas = {Constantes.INFINI, Constantes.INFINI, Constantes.INFINI};
        final double[] haut = {-Constantes.INFINI, -Constantes.INFINI, -Constantes.INFINI};
        Noeud gauche;
        Noeud droite;
        List<Integer> feuille;

        void unir(Noeud autre) {
            for (int a = 0; a < 3; a++) {
                bas[a] = Math.min(bas[a], autre.bas[a]);
                haut[a] = Math.max(haut[a], autre.haut[a]);
            }
        }

        double aire() {
            double a = haut[0] - bas[0];
            double b = haut[1] - bas[1];
            double c = haut[2] - bas[2];
            return a * b + b * c + c * a;
        }
    }

    private Noeud boite(List<Integer> lesquels) {
        Noeud n = new Noeud();
        for (int k : lesquels) {
            double[] g = geometrie[k];
            for (int a = 0; a < 3; a++) {
                n.bas[a] = Math.min(n.bas[a], g[a] - g[3]);
                n.haut[a] = Math.max(n.haut[a], g[a] + g[3]);
            }
        }
        return n;
    }

    private Noeud noeud(List<Integer> lesquels) {
        Noeud n = boite(lesquels);
        double meilleur = Constantes.INFINI;
        double coupe = 0;
        int axe = -1;
        for (int a = 0; a < 3 && lesquels.size() > 4; a++) {
            double min = Constantes.INFINI;
            double max = -Constantes.INFINI;
            for (int k : lesquels) {
                min = Math.min(min, geometrie[k][a]);
                max = Math.max(max, geometrie[k][a]);
            }
            Noeud[] tranches = new Noeud[TRANCHES];
            int[] nombres = new int[TRANCHES];
            Arrays.setAll(tranches, t -> new Noeud());
            double pas = (max - min) / TRANCHES;
            for (int k : lesquels) {
                int t = pas > 0 ? Math.min(TRANCHES - 1, (int) ((geometrie[k][a] - min) / pas)) : 0;
                tranches[t].unir(boite(Collections.singletonList(k)));
                nombres[t]++;
            }
            for (int t = 1; t < TRANCHES; t++) {
                double cout = 0;
                for (int cote = 0; cote < 2; cote++) {
                    Noeud moitie = new Noeud();
                    int nombre = 0;
                    for (int u = cote == 0 ? 0 : t; u < (cote == 0 ? t : TRANCHES); u++) {
                        moitie.unir(tranches[u]);
                        nombre += nombres[u];
                    }
                    cout += nombre == 0 ? Constantes.INFINI : moitie.aire() * nombre;
                }
                if (cout < meilleur) {
                    meilleur = cout;
                    axe = a;
                    coupe = min + t * pas;
                }
            }
        }
        List<Integer> gauche = new ArrayList<>();
        List<Integer> droite = new ArrayList<>();
        for (int k : lesquels) {
            (axe >= 0 && geometrie[k][axe] < coupe ? gauche : droite).add(k);
        }
        if (gauche.isEmpty() || droite.isEmpty()) {
            n.feuille = lesquels;
        } else {
            n.gauche = noeud(gauche);
            n.droite = noeud(droite);
        }
        return n;
    }

    /** La distance d'entrée dans la boîte, +∞ si le rayon n'y passe pas. */
    private double entree(Noeud n, Rayon rayon) {
        compteurs.noeudsVisites++;
        double[] p = {rayon.getP().x, rayon.getP().y, rayon.getP().z};
        double[] v = {rayon.getV().x, rayon.getV().y, rayon.getV().z};
        double entree = 0;
        double sortie = Constantes.INFINI;
        for (int a = 0; a < 3; a++) {
            double m = MARGE * (Math.abs(p[a]) + Math.abs(n.bas[a]) + Math.abs(n.haut[a]) + Math.abs(entree));
            if (v[a] == 0) {
                sortie = p[a] < n.bas[a] - m || p[a] > n.haut[a] + m ? -1 : sortie;
            } else {
                double t0 = (n.bas[a] - m - p[a]) / v[a];
                double t1 = (n.haut[a] + m - p[a]) / v[a];
                entree = Math.max(entree, Math.min(t0, t1));
                sortie = Math.min(sortie, Math.max(t0, t1));
            }
        }
        return entree <= sortie ? entree * (1 - MARGE) : Constantes.INFINI;
    }

    private boolean chercher(Noeud n, Rayon rayon, Objet3D saufLui, boolean premiereVenue) {
        if (n.feuille == null) {
            double eg = entree(n.gauche, rayon);
            double ed = entree(n.droite, rayon);
            Noeud proche = eg <= ed ? n.gauche : n.droite;
            Noeud loin = eg <= ed ? n.droite : n.gauche;
            double e0 = Math.min(eg, ed);
            double e1 = Math.max(eg, ed);
            return e0 <= distance && e0 < Constantes.INFINI && chercher(proche, rayon, saufLui, premiereVenue)
                    || e1 <= distance && e1 < Constantes.INFINI && chercher(loin, rayon, saufLui, premiereVenue);
        }
        for (int k : n.feuille) {
            if (objets.get(k) != saufLui) {
                compteurs.testsSpheres++;
                double d = objets.get(k).getIntersectionDistance(rayon);
                if (d < distance || d == distance && d < Constantes.INFINI && k < trouve) {
                    distance = d;
                    trouve = k;
                    if (premiereVenue) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    /** Ne propose que la réponse, déjà comptée. */
    @Override
    public Iterable<Objet3D> candidats(Rayon rayon, Objet3D depart, double portee) {
        distance = portee;
        trouve = Integer.MAX_VALUE;
        if (racine != null) {
            chercher(racine, rayon, depart, portee < Constantes.INFINI);
        }
        return trouve == Integer.MAX_VALUE ? Collections.emptyList() : Collections.singletonList(objets.get(trouve));
    }

    @Override
    public void limiter(double plusProche) {
        // la réponse seule est proposée
    }

    @Override
    public Objet3D aEgalite(Objet3D plusProche) {
        return plusProche;
    }

    @Override
    public Recherche pourUnFil(Compteurs autres) {
        return new ArbreSimple(this, autres);
    }
}
