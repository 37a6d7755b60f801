package lancer.mesures.vitesse;

import lancer.mesures.FichierCsv;
import lancer.mesures.Intervalle;
import lancer.mesures.Nombres;

/** Un réglage sur une scène : ce qui se compte, le même sur toute machine, et ce qui se chronomètre. NaN où rien n'est mesuré. */
final class Mesure {

    static final String COLONNES = "volet,scene,methode,parametres,x,rayons,examens,erreur,erreur_min,erreur_max,visibles,compte,"
            + "unite_s,processeurs_s,mur_s,memoire_mo,chronometre,machine";

    /** Ce que la mesure compare, et où. */
    final String volet;
    final String scene;
    final String methode;
    final String parametres;

    /** Abscisse de la courbe de ce volet, s'il en a une. */
    final double x;

    /** Rayons de toutes sortes d'une image ; distances et nœuds examinés. */
    double rayons = Double.NaN;
    double examens = Double.NaN;

    /** Erreur, en niveaux ; part des pixels visiblement faux. */
    Intervalle erreur = Intervalle.exact(Double.NaN);
    double visibles = Double.NaN;

    /** Secondes de tous les cœurs, les moindres de plusieurs manches, de l'unité du groupe et de cette commande. */
    double unite = Double.NaN;
    double processeurs = Double.NaN;

    /** Secondes écoulées, les moindres, et plus grande mémoire résidente, en Mo. */
    double mur = Double.NaN;
    double memoire = Double.NaN;

    /** Commit et jour des comptes, puis des temps ; machine des temps, et ce qui l'occupait. Vides si rien n'est mesuré. */
    String compte = "";
    String chronometre = "";
    String machine = "";

    Mesure(String volet, String scene, String methode, String parametres, double x) {
        this.volet = volet;
        this.scene = scene;
        this.methode = methode;
        this.parametres = parametres;
        this.x = x;
    }

    String nom() {
        return (methode + " " + parametres).trim();
    }

    boolean estDe(Reglage reglage) {
        return methode.equals(reglage.methode) && parametres.equals(reglage.parametres);
    }

    /** Les secondes de processeur de la commande, divisées par celles de l'unité ; NaN si elle n'est pas chronométrée. */
    double rapport() {
        return processeurs / unite;
    }

    /** Oublie ce qui se chronomètre. */
    void oublierLesTemps() {
        unite = Double.NaN;
        processeurs = Double.NaN;
        mur = Double.NaN;
        memoire = Double.NaN;
        chronometre = "";
        machine = "";
    }

    String ligne() {
        return FichierCsv.ligne(volet, scene, methode, parametres, Nombres.champ(x), Nombres.champ(rayons), Nombres.champ(examens),
                Nombres.champ(erreur.valeur), Nombres.champ(erreur.min), Nombres.champ(erreur.max), Nombres.champ(visibles), compte,
                Nombres.champ(unite), Nombres.champ(processeurs), Nombres.champ(mur), Nombres.champ(memoire), chronometre, machine);
    }

    static Mesure lire(String... c) {
        Mesure m = new Mesure(c[0], c[1], c[2], c[3], Nombres.champ(c[4]));
        m.rayons = Nombres.champ(c[5]);
        m.examens = Nombres.champ(c[6]);
        m.erreur = new Intervalle(Nombres.champ(c[7]), Nombres.champ(c[8]), Nombres.champ(c[9]));
        m.visibles = Nombres.champ(c[10]);
        m.compte = c[11];
        m.unite = Nombres.champ(c[12]);
        m.processeurs = Nombres.champ(c[13]);
        m.mur = Nombres.champ(c[14]);
        m.memoire = Nombres.champ(c[15]);
        m.chronometre = c[16];
        m.machine = c[17];
        return m;
    }
}
