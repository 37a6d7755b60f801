package lancer.correction.jugement;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import lancer.correction.isolement.Arret;
import lancer.correction.jugement.Chantier.Assemblage;
import lancer.correction.jugement.Verdict.Etat;

/**
 * Ce qu'on vérifie des variantes, chacune par rapport à la base du même étudiant : ses fautes, s'il y en a, sont des
 * deux côtés, et ne comptent pas deux fois.
 */
final class Variantes {

    /** Un critère d'une variante. */
    static final class Critere {

        final String variante;
        final String titreVariante;
        final String nom;
        final String titre;

        Critere(String variante, String titreVariante, String nom, String titre) {
            this.variante = variante;
            this.titreVariante = titreVariante;
            this.nom = nom;
            this.titre = titre;
        }

        String id() {
            return variante + "." + nom;
        }
    }

    static final List<Critere> CRITERES = List.of(
            new Critere("brume", "Extension : brume", "bornee", "k est entre 0 et 1, et n'est pas toujours nul"),
            new Critere("brume", "Extension : brume", "croissante", "k croît avec la distance"),
            new Critere("brume", "Extension : brume", "melange",
            "la couleur est k fois celle de la brume, plus (1 - k) fois celle de l'objet"),
            new Critere("brume", "Extension : brume", "reflets",
            "ce que l'on voit dans un miroir est aussi dans la brume"),
            new Critere("antialias", "Extension : anticrénelage", "bords",
            "les bords approchent la moyenne de plusieurs rayons par pixel"),
            new Critere("antialias", "Extension : anticrénelage", "ailleurs", "hors des bords, l'image ne change pas"),
            new Critere("blinn", "Extension : reflet de Blinn", "etalement",
            "pour un même ns, le reflet est plus étalé que celui de Phong"),
            new Critere("blinn", "Extension : reflet de Blinn", "formule",
            "le reflet est (N.H) à la puissance ns, ou 2 ns"));

    /** Distances, sur leur rayon, des boules de la scène de la brume. */
    private static final double[] DISTANCES = {3, 5, 8, 13, 30, 80};

    /** Du k nul au k qui se voit. */
    private static final double PRES = 1e-4;

    private static final double[] DEBUTS = {0, 0.5, -0.5};
    private static final int[] FINESSES = {2, 3, 4};
    private static final int COTE = 80;
    private static final double CONTRASTE = 16;
    private static final double RESTE = 0.4;
    private static final double AILLEURS = 4;

    private final Juge juge;
    private final Reference reference;
    private final Assemblage base;
    private final Map<String, Verdict> verdicts = new HashMap<>();

    Variantes(Juge juge, Reference reference, Assemblage base) {
        this.juge = juge;
        this.reference = reference;
        this.base = base;
    }

    Map<String, Verdict> juger(String variante, Assemblage assemblage) {
        try {
            switch (variante) {
                case "brume":
                    brume(assemblage);
                    break;
                case "antialias":
                    antialias(assemblage);
                    break;
                default:
                    blinn(assemblage);
            }
        } catch (Arret | Dialogue.Echec e) {
            for (Critere critere : CRITERES) {
                if (critere.variante.equals(variante)) {
                    verdicts.putIfAbsent(critere.id(), new Verdict(Etat.RATE, e.getMessage()));
                }
            }
        }
        return verdicts;
    }

    private void dire(String id, boolean juste, String message) {
        verdicts.put(id, juste ? new Verdict(Etat.REUSSI, "") : new Verdict(Etat.RATE, message));
    }

    private Image image(Assemblage assemblage, String scene, int profondeur) throws Arret {
        return Image.lire(Juge.LARGEUR, Juge.HAUTEUR, juge.sonde(assemblage, "SondeImage", "dessiner", scene, ""
                + Juge.LARGEUR, "" + Juge.HAUTEUR,
                "" + profondeur, "0"));
    }

    /**
     * Deux boules, l'une claire, l'autre sombre, à chaque distance, face à une lampe placée dans l'œil. De la
     * différence de leurs couleurs, avec brume et sans, on tire k sans connaître la couleur de la brume ; puis cette
     * couleur.
     */
    private void brume(Assemblage assemblage) throws Arret {
        double focale = 1 / Math.tan(Math.toRadians(15));
        StringBuilder texte = new StringBuilder();
        for (int i = 0; i < DISTANCES.length; i++) {
            for (int cote = -1; cote <= 1; cote += 2) {
                double x = cote * 0.5;
                double y = 0.6 - 0.2 * i;
                double norme = Math.sqrt(x * x + y * y + focale * focale);
                double t = DISTANCES[i] / norme;
                texte.append(String.format(Locale.ROOT,
                        "[Sphere %d %d]\ncentre=%.9f %.9f %.9f\nrayon=%.9f\nKd=%s\nKs=0 0 0\nns=1\n", i, cote,
                        x + t * x, y + t * y, t * focale, 0.06 * (1 + t), cote < 0 ? "0.9 0.9 0.9" : "0.1 0.1 0.1"));
            }
        }
        texte.append(String.format(Locale.ROOT, "[Lampe 1]\nposition=0 0 %.9f\ncouleur=1 1 1\n", -focale));
        String scene = texte.toString();
        Image sans = image(base, scene, 0);
        Image avec = image(assemblage, scene, 0);
        double[] k = new double[DISTANCES.length];
        double brumeMin = Double.POSITIVE_INFINITY;
        double brumeMax = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < k.length; i++) {
            int ligne = 12 + 16 * i;
            int clair = ligne * Juge.LARGEUR + 40;
            int sombre = ligne * Juge.LARGEUR + 120;
            k[i] = 1 - (avec.brut(clair, 0) - avec.brut(sombre, 0)) / (sans.brut(clair, 0) - sans.brut(sombre, 0));
            if (k[i] > 0.05) {
                double brume = (avec.brut(sombre, 0) - (1 - k[i]) * sans.brut(sombre, 0)) / k[i];
                brumeMin = Math.min(brumeMin, brume);
                brumeMax = Math.max(brumeMax, brume);
            }
        }
        StringBuilder suite = new StringBuilder();
        boolean bornee = true;
        boolean croissante = true;
        for (int i = 0; i < k.length; i++) {
            suite.append(String.format(Locale.FRANCE, "%sk(%.3g) = %.4f", i > 0 ? ", " : "", DISTANCES[i], k[i]));
            bornee &= k[i] >= -PRES && k[i] <= 1 + PRES;
            croissante &= i == 0 || k[i] >= k[i - 1] - PRES;
        }
        dire("brume.bornee", bornee && k[k.length - 1] > PRES, "attendu : de 0 à 1 ; obtenu, selon la distance : "
                + suite);
        dire("brume.croissante", croissante && k[k.length - 1] > k[0] + PRES,
                "attendu : plus loin, plus de brume ; obtenu : " + suite);
        dire("brume.melange", brumeMin <= brumeMax && brumeMax - brumeMin < 0.02 && brumeMin > -PRES,
                brumeMin > brumeMax ? "pas assez de brume pour en voir la couleur : " + suite
                : String.format(Locale.FRANCE,
                "attendu : une même couleur de brume à toute distance ; obtenu : de %.3f à %.3f", brumeMin, brumeMax));
        double vu = reflet(assemblage) / reflet(base);
        if (!(Math.abs(vu) <= 2) || k[0] > 0.9 || k[k.length - 1] < 0.1) {
            verdicts.put("brume.reflets", new Verdict(Etat.NON_EVALUABLE, "non évaluable : dépend de « Reflets », "
                    + "et d'une brume légère de près, épaisse de loin : " + suite));
        } else {
            double direct = 1 - k[0];
            dire("brume.reflets", vu < direct * (1 - k[k.length - 1] / 2), String.format(Locale.FRANCE,
                    "une boule à 80 d'un miroir à 3 : il en reste %.3f ; attendu : %.3f, obtenu sans brume au-delà du "
                    + "miroir : %.3f", vu, direct * (1 - k[k.length - 1]), direct));
        }
    }

    /** Dans un miroir à la première distance, une boule à la dernière : ce que change sa couleur à celle du pixel. */
    private double reflet(Assemblage assemblage) throws Arret {
        double[] vues = new double[2];
        for (int i = 0; i < 2; i++) {
            vues[i] = image(assemblage, "[Sphere miroir]\ncentre=0 -7.071067812 10.071067812\n"
                    + "rayon=10\nKs=1 1 1\nns=1000\n[Sphere]\ncentre=0 100 3\nrayon=20\nKd="
                    + (i == 0 ? "0.9 0.9 0.9" : "0.1 0.1 0.1") + "\n[Lampe]\nposition=0 40 -40\ncouleur=1 1 1\n", 1)
                    .brut(Juge.HAUTEUR / 2 * Juge.LARGEUR + Juge.LARGEUR / 2, 0);
        }
        return vues[0] - vues[1];
    }

    private void antialias(Assemblage assemblage) throws Arret {
        String scene = juge.scene();
        int hauteur = COTE * 3 / 4;
        Image lui = Image.lire(COTE, hauteur, juge.sonde(assemblage, "SondeVariantes", "tracer", scene, "" + COTE, ""
                + hauteur, "1"));
        Image simple = Image.lire(COTE, hauteur, juge.sonde(base, "SondeVariantes", "tracer", scene, "" + COTE, ""
                + hauteur, "1"));
        double meilleur = Double.POSITIVE_INFINITY;
        double ailleurs = Double.POSITIVE_INFINITY;
        for (int n : FINESSES) {
            for (double debut : DEBUTS) {
                // sous-pixels centrés, pris au coin, ou autour des coordonnées entières
                double depart = debut < 0 ? -0.5 + 0.5 / n : debut / n;
                Image moyenne = Image.lire(COTE, hauteur, juge.sonde(base, "SondeVariantes", "moyenne", scene, ""
                        + COTE, "" + hauteur, "1", "" + n,
                        "" + depart));
                double[] restes = restes(lui, simple, moyenne);
                if (restes[0] < meilleur) {
                    meilleur = restes[0];
                    ailleurs = restes[1];
                }
            }
        }
        dire("antialias.bords", meilleur < RESTE, String.format(Locale.FRANCE,
                "aux bords, il reste %.0f %% de l'écart entre votre image sans anticrénelage et la moyenne de vos "
                + "rayons ; attendu : moins de %.0f %%",
                100 * meilleur, 100 * RESTE));
        dire("antialias.ailleurs", meilleur < RESTE && ailleurs < AILLEURS, meilleur < RESTE
                ? String.format(Locale.FRANCE,
                "hors des bords, l'image change de %.1f niveaux", ailleurs)
                : "sans anticrénelage aux bords, rien à vérifier ailleurs");
    }

    /** La part qui reste de l'écart à la moyenne, là où il y en a ; et l'écart ailleurs. */
    private static double[] restes(Image lui, Image simple, Image moyenne) {
        double avant = 0;
        double apres = 0;
        double autour = 0;
        int reste = 0;
        for (int p = 0; p < lui.pixels(); p++) {
            double d = Ecart.ecart(simple, moyenne, p);
            double e = Ecart.ecart(lui, moyenne, p);
            if (d > CONTRASTE) {
                avant += d * d;
                apres += e * e;
            } else {
                autour += e * e;
                reste++;
            }
        }
        return new double[] {avant > 0 ? Math.sqrt(apres / avant) : Double.POSITIVE_INFINITY,
                Math.sqrt(autour / Math.max(1, reste))};
    }

    private void blinn(Assemblage assemblage) throws Arret {
        String scene =
                "[Sphere 1]\ncentre=0 0 5\nrayon=1.5\nKd=0 0 0\nKs=1 1 1\nns=5\n[Lampe 1]\nposition=-4 3 "
                + "-3\ncouleur=1 1 1\n";
        Image phong = image(base, scene, 0);
        Image lui = image(assemblage, scene, 0);
        int etalePhong = etale(phong);
        int etaleLui = etale(lui);
        dire("blinn.etalement", etaleLui > 1.3 * etalePhong,
                "pixels où le reflet vaut plus de la moitié de son maximum : " + etaleLui
                + ", avec Phong " + etalePhong + " ; attendu : nettement plus");
        boolean juste = false;
        for (int facteur = 1; facteur <= 2; facteur++) {
            for (double decalage : List.of(0.0, 0.5)) {
                Image formule = Image.lire(Juge.LARGEUR, Juge.HAUTEUR, reference.blinn(scene, decalage, facteur));
                juste |= new Ecart(formule, lui).memeImage();
            }
        }
        dire("blinn.formule", juste,
                "l'image d'une boule noire et brillante n'est celle ni de (N.H)^ns, ni de (N.H)^2ns");
    }

    /** Les pixels du milieu, sur la boule, où le reflet vaut plus de la moitié de son maximum. */
    private static int etale(Image image) {
        double max = 0;
        for (int passe = 0; ; passe++) {
            int n = 0;
            for (int y = 35; y < 85; y++) {
                for (int x = 55; x < 105; x++) {
                    double v = image.niveau(y * image.largeur + x, 0);
                    max = Math.max(max, v);
                    n += passe > 0 && v > max / 2 && max > 1 ? 1 : 0;
                }
            }
            if (passe > 0) {
                return n;
            }
        }
    }
}
