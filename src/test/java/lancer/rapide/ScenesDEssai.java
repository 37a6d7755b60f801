package lancer.rapide;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.essai.Plan;

/** Des scènes faites pour nuire : chacune attaque un raccourci. Toujours les mêmes, le hasard a sa graine. */
final class ScenesDEssai {

    private final List<Objet3D> objets = new ArrayList<>();
    private final List<Lampe> lampes = new ArrayList<>();
    private final Random hasard;

    private ScenesDEssai(long graine) {
        hasard = new Random(graine);
    }

    /** Toutes, par leur nom, d'au plus {@code taille} sphères ou à peu près. */
    static Map<String, Scene> toutes(int taille) {
        Map<String, Scene> scenes = new LinkedHashMap<>();
        scenes.put("vide", new ScenesDEssai(0).deuxLampes().scene());
        scenes.put("une sphère", new ScenesDEssai(0).sphere(0, 0, 6, 1).deuxLampes().scene());
        scenes.put("sans lampe", new ScenesDEssai(1).foule(taille, 3, 0.2, 0.5).scene());
        scenes.put("foule", new ScenesDEssai(2).foule(taille, 3, 0.05, 0.2).deuxLampes().scene());
        scenes.put("foule qui s'interpénètre", new ScenesDEssai(3).foule(taille, 2, 0.3, 1).deuxLampes().scene());
        scenes.put("tailles sauvages", new ScenesDEssai(4).taillesSauvages(taille, 3).deuxLampes().scene());
        scenes.put("lampes partout", new ScenesDEssai(5).foule(taille, 2, 0.1, 0.5).lampesPartout().scene());
        scenes.put("sol immense", new ScenesDEssai(6).sphere(0, -1001.5, 8, 1000).foule(taille, 2, 0.05, 0.3).deuxLampes().scene());
        scenes.put("lampe sur le sol", new ScenesDEssai(7).sphere(0, -1001.5, 8, 1000).foule(taille, 2, 0.1, 0.3)
                .lampe(0, -1.5, 8).lampe(0, 30, 8).scene());
        scenes.put("écran dans une sphère", new ScenesDEssai(8).sphere(0, 0, 0, 3).foule(taille, 2, 0.1, 0.3).deuxLampes().scene());
        scenes.put("œil dans une sphère", new ScenesDEssai(9).sphere(0, 0, -3.8, 0.5).foule(taille, 2, 0.1, 0.3).deuxLampes().scene());
        scenes.put("tout dans une sphère", new ScenesDEssai(10).sphere(0, 0, 0, 50).foule(taille, 3, 0.1, 0.3).deuxLampes().scene());
        scenes.put("amas", new ScenesDEssai(11).amas(taille, 4, 0.02).deuxLampes().scene());
        scenes.put("amas dispersés", new ScenesDEssai(12).amas(taille, 40, 0.1).deuxLampes().scene());
        scenes.put("boules tangentes", new ScenesDEssai(13).tangentes(taille).deuxLampes().scene());
        scenes.put("presque jumelles", new ScenesDEssai(14).presqueJumelles(taille).deuxLampes().scene());
        scenes.put("loin de tout", new ScenesDEssai(15).foule(taille, 3, 0.05, 0.3).sphere(1e6, 1e6, 1e6, 10).lampe(1e9, 1e9, -1e9)
                .scene());
        scenes.put("lampe lointaine de quelques contacts", new ScenesDEssai(21).foule(taille, 2, 0.05, 0.3).lampe(1e4, 65000, -1e4)
                .deuxLampes().scene());
        scenes.put("étoiles", foule(20, taille, 1e11).sphere(-3e10, 1e10, 1e11, 1e10).sphere(4e37, 3e37, 1e38, 1e37).scene());
        scenes.put("poussière", new ScenesDEssai(16).foule(taille, 3, 1e-4, 1e-3).sphere(0, 0, 7, 1).deuxLampes().scene());
        scenes.put("un plan d'élève", new ScenesDEssai(17).plan(-1.2).foule(taille, 2, 0.1, 0.4).plan(-1.2).deuxLampes().scene());
        scenes.put("une fille de Sphere", new ScenesDEssai(18).filles().foule(taille, 2, 0.1, 0.4).deuxLampes().scene());
        scenes.put("derrière l'écran", new ScenesDEssai(22).gaussienne(taille, 0, 0, -6, 1.5, 0.4).deuxLampes().scene());
        scenes.put("mates et noires", new ScenesDEssai(19).mates(taille).deuxLampes().scene());
        return scenes;
    }

    /** Des longueurs que le carré d'un flottant court ne tient pas. */
    static Map<String, Scene> extremes(int taille) {
        Map<String, Scene> scenes = new LinkedHashMap<>();
        scenes.put("1e100", new ScenesDEssai(30).sphere(0, 0, 1e100, 1e99).sphere(1e99, 1e99, 1e100, 1e98).foule(taille, 2, 0.1, 0.4)
                .lampe(1e100, 1e100, -1e100).lampe(3, 4, -2).scene());
        scenes.put("1e-100", new ScenesDEssai(31).sphere(0, 0, 6, 1e-100).sphere(0, 0, 6.1, 1e-50).sphere(0.1, 0, 7, 1)
                .lampe(1e-100, 1e-90, 1e-80).lampe(3, 4, -2).scene());
        scenes.put("1e30", new ScenesDEssai(32).foule(taille, 2, 0.1, 0.4).sphere(0, -1e30, 0, 1e30).sphere(0, 0, 4e37, 1e37)
                .lampe(0, 1e38, -1e38).lampe(3, 4, -2).scene());
        scenes.put("1e15", new ScenesDEssai(33).foule(taille, 2, 0.1, 0.4).sphere(0, -1e15 - 2, 0, 1e15).lampe(0, 1e16, 0).lampe(3, 4, -2)
                .scene());
        // une foule au bord de deux cubes et de deux boîtes, que les arrondis placent mal, ou dont les tailles débordent
        for (double loin : new double[] {1e16, 1e140}) {
            ScenesDEssai bouts = new ScenesDEssai(74).foule(20, 0.5, 0.1, 0.4);
            for (int k = 0; k < 10; k++) {
                bouts.sphere(k % 2 == 0 ? -loin : loin, 0, 8, 1 + k);
            }
            scenes.put("au milieu de " + loin, bouts.deuxLampes().scene());
        }
        // chaque boule est huit fois plus loin que la précédente : coupé au milieu, l'arbre serait trop profond
        ScenesDEssai file = new ScenesDEssai(36);
        for (double d = 1e-6; d < 1e110; d *= 8) {
            file.sphere(0, 0, d, d / 5);
        }
        scenes.put("en file", file.deuxLampes().scene());
        scenes.put("rayon 1e100", new ScenesDEssai(34).sphere(0, 0, 0, 1e100).sphere(0, 0, 8, 1).deuxLampes().scene());
        return scenes;
    }

    /** Une foule, et une boule ordinaire à cette distance ; s'il n'y en a pas, 0. */
    static ScenesDEssai foule(long graine, int taille, double distance) {
        ScenesDEssai scene = new ScenesDEssai(graine).foule(taille, 3, 0.02, 0.05).deuxLampes();
        return distance == 0 ? scene : scene.sphere(0, 0, distance, 0.1);
    }

    /** Scènes hostiles aux grilles et aux cartes, pour leurs comptes. */
    static Map<String, Scene> hostiles(int taille) {
        Map<String, Scene> scenes = new LinkedHashMap<>();
        scenes.put("sol immense", new ScenesDEssai(40).sphere(0, -1001.5, 8, 1000).foule(taille, 2, 0.01, 0.05).deuxLampes().scene());
        scenes.put("six amas sur 80", new ScenesDEssai(41).amas(taille, 40, 0.4).deuxLampes().scene());
        scenes.put("deux amas minuscules", new ScenesDEssai(42).amas(taille, 4, 0.005).deuxLampes().scene());
        scenes.put("boules mêlées, lampes partout", new ScenesDEssai(43).foule(taille, 2, 0.2, 0.6).lampesPartout().scene());
        scenes.put("tailles sauvages", new ScenesDEssai(44).taillesSauvages(taille, 4).deuxLampes().scene());
        scenes.put("un sol et une boîte lointaine", new ScenesDEssai(45).foule(taille, 2, 0.01, 0.05).sphere(500, 0, 900, 3)
                .sphere(0, -1e4 - 2, 8, 1e4).lampe(0, 5000, 0).lampe(3, 4, -2).scene());
        scenes.put("vingt grosses", new ScenesDEssai(46).foule(20, 4, 1, 3).foule(taille, 3, 0.005, 0.02).lampesPartout().scene());
        scenes.put("foule", new ScenesDEssai(47).foule(taille, 3, 0.02, 0.05).deuxLampes().scene());
        scenes.put("un seul point", new ScenesDEssai(50).gaussienne(taille, 0, 0, 8, 1e-3, 1).deuxLampes().scene());
        scenes.put("nuage de boules mêlées", new ScenesDEssai(51).foule(taille, 3, 0.5, 1.5).deuxLampes().scene());
        scenes.put("aiguilles", new ScenesDEssai(52).aiguilles(taille).deuxLampes().scene());
        scenes.put("coquilles", new ScenesDEssai(53).coquilles(taille, 8).deuxLampes().scene());
        scenes.put("œil dans mille coquilles", new ScenesDEssai(54).coquilles(taille, -3).deuxLampes().scene());
        scenes.put("amas de quatre échelles", new ScenesDEssai(55).echelles(taille).deuxLampes().scene());
        scenes.put("tailles exponentielles", new ScenesDEssai(56).taillesSauvages(taille, 30).deuxLampes().scene());
        scenes.put("places exponentielles", new ScenesDEssai(57).placesExponentielles(taille).deuxLampes().scene());
        scenes.put("une énorme et des minuscules", new ScenesDEssai(58).sphere(0, 0, 30, 20).foule(taille, 3, 1e-4, 1e-3).deuxLampes()
                .scene());
        scenes.put("neuf étoiles", new ScenesDEssai(59).foule(taille, 2, 0.01, 0.05).gaussienne(9, 0, 0, 0, 1e12, 1).deuxLampes().scene());
        scenes.put("cent étoiles", new ScenesDEssai(60).foule(taille, 2, 0.01, 0.05).gaussienne(100, 0, 0, 0, 1e15, 1).deuxLampes()
                .scene());
        scenes.put("ciel miroir", new ScenesDEssai(61).foule(taille, 2, 0.01, 0.05).sphere(0, 0, 0, 1e5).deuxLampes().scene());
        scenes.put("lampes lointaines", new ScenesDEssai(62).foule(taille, 2, 0.01, 0.05).lampe(1e12, 1e12, -1e12).lampe(0, 1e8, 0)
                .lampe(1e16, 1e3, 2).scene());
        scenes.put("soleils", new ScenesDEssai(68).foule(taille, 2, 0.01, 0.05).lampe(1e4, 65000, -1e4).lampe(1e6, 1e6, -1e6).scene());
        scenes.put("lampes dans les amas", new ScenesDEssai(63).amas(taille, 4, 0.02).lampesPartout().scene());
        scenes.put("mille lampes", new ScenesDEssai(64).foule(taille / 10, 2, 0.05, 0.2).lampes(1000).scene());
        scenes.put("tout derrière l'œil", new ScenesDEssai(65).gaussienne(taille, 0, 0, -30, 3, 0.1).deuxLampes().scene());
        scenes.put("amas entre les semis", new ScenesDEssai(66).entreLesSemis(taille).deuxLampes().scene());
        scenes.put("un amas de quelques pixels", new ScenesDEssai(67).gaussienne(taille, 0.3, 0.2, 20, 0.05, 0.01).sphere(900, 0, 4000, 1)
                .deuxLampes().scene());
        return scenes;
    }

    /** Deux miroirs face à face, et une foule qu'on ne voit que par eux. */
    static Scene entreDeuxMiroirs(int taille) {
        ScenesDEssai essai = new ScenesDEssai(70).sphere(0, 0, 1020, 1000).sphere(0, 0, -1010, 1000);
        for (Objet3D miroir : essai.objets) {
            miroir.setKs(new Couleur(1));
        }
        for (int k = 0; k < taille; k++) {
            essai.sphere(essai.entre(5, 11), essai.entre(-3, 3), essai.entre(2, 14), 0.02);
        }
        return essai.lampe(0, 5, 0).scene();
    }

    /** Un nuage, et toutes les lampes dans la sphère de ce rang, loin au-dessus. */
    static Scene lampesDansUneSphere(int taille, int rang, int lampes) {
        ScenesDEssai essai = new ScenesDEssai(71).foule(rang, 3, 0.05, 0.3).sphere(0, 20, 0, 3).foule(taille, 3, 0.05, 0.3);
        for (int k = 0; k < lampes; k++) {
            essai.lampe(essai.entre(-1, 1), essai.entre(19, 21), essai.entre(-1, 1));
        }
        return essai.scene();
    }

    Scene scene() {
        return new Scene(objets, lampes);
    }

    private double entre(double a, double b) {
        return a + (b - a) * hasard.nextDouble();
    }

    private <T extends Objet3D> T peint(T objet) {
        objet.setKd(new Couleur(hasard.nextDouble(), hasard.nextDouble(), hasard.nextDouble()));
        objet.setKs(new Couleur(0.3 + 0.1 * hasard.nextInt(4)));
        objet.setNs(hasard.nextInt(3) == 0 ? 7.5 : hasard.nextInt(100));
        return objet;
    }

    private ScenesDEssai sphere(double x, double y, double z, double rayon) {
        objets.add(peint(new Sphere(new Point(x, y, z), rayon)));
        return this;
    }

    private ScenesDEssai lampe(double x, double y, double z) {
        lampes.add(new Lampe(new Point(x, y, z), new Couleur(entre(0.3, 1), entre(0.3, 1), entre(0.3, 1))));
        return this;
    }

    private ScenesDEssai deuxLampes() {
        return lampe(-10, 15, -12).lampe(12, 8, -5);
    }

    /** Au milieu, au centre d'une boule, à sa surface, à l'œil, sur l'écran, au loin, derrière. */
    private ScenesDEssai lampesPartout() {
        Sphere s = (Sphere) objets.get(objets.size() / 2);
        Point c = s.getCentre();
        return lampe(0, 0, 8).lampe(c.x, c.y, c.z).lampe(c.x + s.getRayon(), c.y, c.z).lampe(c.x, c.y + s.getRayon() / 2, c.z)
                .lampe(0, 0, -3.7320508075688776).lampe(0.1, 0.2, 0).lampe(-300, 20, 40).lampe(0.5, 0.5, 30);
    }

    private ScenesDEssai foule(int n, double cote, double rMin, double rMax) {
        for (int k = 0; k < n; k++) {
            sphere(entre(-cote, cote), entre(-0.75 * cote, 0.75 * cote), entre(8 - cote, 8 + cote), entre(rMin, rMax));
        }
        return this;
    }

    private ScenesDEssai taillesSauvages(int n, double decades) {
        for (int k = 0; k < n; k++) {
            sphere(entre(-3, 3), entre(-2, 2), entre(5, 12), Math.pow(10, -entre(0, decades)));
        }
        return this;
    }

    private ScenesDEssai amas(int n, double cote, double etendue) {
        for (int k = 0; k < 6; k++) {
            double x = entre(-cote, cote);
            double y = entre(-cote, cote);
            double z = 6 + entre(0, 2 * cote);
            for (int i = 0; i < n / 6; i++) {
                sphere(x + etendue * cote * hasard.nextGaussian() / 2, y + etendue * cote * hasard.nextGaussian() / 2,
                        z + etendue * cote * hasard.nextGaussian() / 2, cote * etendue * entre(0.02, 0.1));
            }
        }
        return this;
    }

    private ScenesDEssai gaussienne(int n, double x, double y, double z, double ecart, double rayon) {
        for (int k = 0; k < n; k++) {
            sphere(x + ecart * hasard.nextGaussian(), y + ecart * hasard.nextGaussian(), z + ecart * hasard.nextGaussian(), rayon);
        }
        return this;
    }

    /** Des boules minuscules, alignées vers le fond. */
    private ScenesDEssai aiguilles(int n) {
        for (int k = 0; k < n; k++) {
            int aiguille = k % 30;
            sphere(aiguille % 6 - 2.5 + 1e-4 * k / n, aiguille / 6 * 0.8 - 1.6, 5 + 20.0 * k / n, 0.01);
        }
        return this;
    }

    private ScenesDEssai coquilles(int n, double z) {
        for (int k = 0; k < n; k++) {
            sphere(0, 0, z, 4.0 * (k + 1) / n);
        }
        return this;
    }

    private ScenesDEssai echelles(int n) {
        for (int k = 0; k < n; k++) {
            double x = 0;
            double y = 0;
            double z = 8;
            double pas = 2;
            for (int e = 0; e < 4; e++, pas /= 30) {
                int branche = hasard.nextInt(6);
                x += pas * Math.cos(branche);
                y += pas * Math.sin(branche);
                z += pas * (branche % 3 - 1);
            }
            sphere(x + pas * hasard.nextGaussian(), y + pas * hasard.nextGaussian(), z + pas * hasard.nextGaussian(), pas);
        }
        return this;
    }

    private ScenesDEssai placesExponentielles(int n) {
        for (int k = 0; k < n; k++) {
            double d = Math.pow(2, 60.0 * k / n - 20);
            sphere(d * entre(-0.2, 0.2), d * entre(-0.2, 0.2), d, 0.05 * d);
        }
        return this;
    }

    ScenesDEssai lampes(int n) {
        for (int k = 0; k < n; k++) {
            lampe(entre(-5, 5), entre(-5, 5), entre(-5, 15));
        }
        return this;
    }

    private ScenesDEssai entreLesSemis(int n) {
        for (int k = 0; k < n; k++) {
            int i = k % 24;
            int j = k / 24 % 24;
            // à 10 de l'œil, l'écran est large de 10 / FOCALE fois 2 ; les amas sont aux coins des carrés du semis
            sphere((i / 12.0 - 1) * 2.68 + 0.004 * hasard.nextGaussian(), (j / 12.0 - 1) * 2.01 + 0.004 * hasard.nextGaussian(),
                    10 - 3.732 + 0.004 * hasard.nextGaussian(), 0.002);
        }
        return this;
    }

    /** Un empilement cubique de boules qui se touchent exactement. */
    private ScenesDEssai tangentes(int n) {
        int c = (int) Math.ceil(Math.cbrt(n));
        for (int k = 0; k < c * c * c; k++) {
            sphere(k % c * 0.5 - 1.5, k / c % c * 0.5 - 1.5, 6 + k / (c * c) * 0.5, 0.25);
        }
        return this;
    }

    /** Mêmes distances en des points entiers : l'ordre de la scène départage. */
    private ScenesDEssai presqueJumelles(int n) {
        for (int k = 0; k < n / 4 + 1; k++) {
            double x = Math.rint(entre(-8, 8)) / 4;
            double y = Math.rint(entre(-8, 8)) / 4;
            sphere(x, y, 8, 0.5).sphere(x, y, 8.25, 0.75).sphere(x, y, 8, 0.5).sphere(x, y, 8 + 1e-15, 0.5);
        }
        return this;
    }

    private ScenesDEssai plan(double hauteur) {
        objets.add(peint(new Plan(new Point(0, hauteur, 0), new Vecteur(0, 1, 0))));
        return this;
    }

    private ScenesDEssai filles() {
        objets.add(peint(new Demie(new Point(0, 0, 6), 1)));
        objets.add(peint(new Demie(new Point(1, 0.3, 7), 1)));
        return this;
    }

    private ScenesDEssai mates(int n) {
        foule(n, 2, 0.2, 0.5);
        for (int k = 0; k < objets.size(); k++) {
            objets.get(k).setKs(k % 3 == 0 ? new Couleur() : k % 3 == 1 ? new Couleur(1, 0, 0) : new Couleur(1e-3));
            if (k % 5 == 0) {
                objets.get(k).setKd(new Couleur());
            }
            objets.get(k).setNs(k % 4 == 0 ? 0 : 5);
        }
        return this;
    }

    /** Une sphère dont on ne voit que le haut. */
    static final class Demie extends Sphere {
        Demie(Point centre, double rayon) {
            super(centre, rayon);
        }

        @Override
        public double getIntersectionDistance(Rayon incident) {
            double d = super.getIntersectionDistance(incident);
            if (d < Double.POSITIVE_INFINITY && incident.getP().y + d * incident.getV().y < getCentre().y) {
                d = Double.POSITIVE_INFINITY;
                incident.setContact(this, d);
            }
            return d;
        }
    }
}
