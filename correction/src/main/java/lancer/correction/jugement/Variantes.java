package lancer.correction.jugement;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import lancer.correction.isolement.Arret;
import lancer.correction.jugement.Chantier.Assemblage;
import lancer.correction.modele.Modele;

/**
 * Ce que vaut une variante : son image, comparée à celle que l'on prédit de la base du même étudiant, dont les fautes,
 * s'il y en a, sont des deux côtés. La part de l'effet prédit qui manque propose une note ; l'enseignant en décide.
 */
final class Variantes {

    /** Par variante, son titre et ce qu'on y regarde. */
    static final Map<String, String[]> TITRES = new LinkedHashMap<>();

    static {
        TITRES.put("brume", new String[] {"brume",
            "la couleur de la base, mêlée à celle d'une brume, d'autant plus que c'est loin"});
        TITRES.put("antialias", new String[] {"anticrénelage",
            "les bords approchent la moyenne de plusieurs rayons par pixel, et le reste ne change pas"});
        TITRES.put("blinn", new String[] {"reflet de Blinn", "le reflet est (N.H) à la puissance ns, 2 ns ou 4 ns"});
    }

    /** De quoi proposer tous les points, et aucun : la part de l'effet qui manque. */
    private static final double TOUT = 0.4;
    private static final double RIEN = 0.9;

    private static final int LARGEUR = 80;
    private static final int HAUTEUR = 60;

    /** Sur un côté, les rayons de l'image moyenne d'un pixel. */
    private static final int FINESSE = 4;

    /** Distances, sur leur rayon, des boules de la scène de la brume ; et leur demi-côté, en pixels. */
    private static final double[] DISTANCES = {3, 5, 8, 13, 30, 80};
    private static final int DEMI = 3;

    private final Juge juge;
    private final Assemblage base;

    Variantes(Juge juge, Assemblage base) {
        this.juge = juge;
        this.base = base;
    }

    Verdict juger(String variante, Assemblage assemblage) {
        try {
            return variante.equals("brume") ? brume(assemblage) : variante.equals("antialias") ? antialias(assemblage)
                    : blinn(assemblage);
        } catch (Arret | Dialogue.Echec e) {
            return new Verdict(Verdict.Etat.RATE, e.getMessage());
        }
    }

    /** La scène du cours, telle que cette variante la dessine. */
    Image montrer(Assemblage assemblage) throws Arret {
        return dessin(assemblage, "tracer", Modele.scene("scene1"), LARGEUR, HAUTEUR, "1");
    }

    private Image dessin(Assemblage assemblage, String methode, String scene, int largeur, int hauteur, String... suite)
            throws Arret {
        List<String> tout = new ArrayList<>(List.of("" + largeur, "" + hauteur));
        tout.addAll(List.of(suite));
        return Image.lire(largeur, hauteur, juge.sonde(assemblage, "SondeImage", methode, scene, tout.toArray(new String[0])));
    }

    /** @param reste la part de l'effet prédit qui manque */
    private static Verdict mesure(double reste, String quoi) {
        double part = reste <= TOUT ? 1 : reste < RIEN ? Math.round(4 * (RIEN - reste) / (RIEN - TOUT)) / 4.0 : 0;
        return Verdict.mesure(Math.min(1, part), String.format(Locale.FRANCE,
                "mesuré : il manque %.0f %% de l'effet attendu de votre base (%s) ; tous les points jusqu'à %.0f %%, aucun à "
                + "partir de %.0f %%, sauf avis de l'enseignant", 100 * Math.min(9.99, reste), quoi, 100 * TOUT, 100 * RIEN));
    }

    /** Ce qui sépare encore une image de celle qu'on prédit, par rapport à ce qui en séparait la base. */
    private static double reste(Image lui, Image sans, Image predite) {
        double apres = lui.distance(predite);
        double avant = sans.distance(predite);
        return avant > 0 ? apres / avant : 1;
    }

    /** La moyenne des rayons d'un pixel vient d'une image plus fine de la base, où rien n'est tronqué à l'entier. */
    private Verdict antialias(Assemblage assemblage) throws Arret {
        Image lui = montrer(assemblage);
        Image sans = montrer(base);
        Image fine = dessin(base, "dessiner", Modele.scene("scene1"), FINESSE * LARGEUR, FINESSE * HAUTEUR, "1", "0.5");
        double reste = 1;
        // autour du centre du pixel, ou de ses coordonnées entières
        for (int debut = 0; debut >= -FINESSE / 2; debut--) {
            reste = Math.min(reste, reste(lui, sans, fine.moyenne(FINESSE, debut)));
        }
        return mesure(reste, "l'escalier des bords, effacé par la moyenne de " + FINESSE + " x " + FINESSE + " rayons");
    }

    private Verdict blinn(Assemblage assemblage) throws Arret {
        String boule = "[Sphere 1]\ncentre=0 0 5\nrayon=1.5\nKd=0 0 0\nKs=0.4 0.4 0.4\nns=5\n"
                + "[Lampe 1]\nposition=-4 3 -3\ncouleur=";
        String scene = boule + "1 1 1\n";
        Image lui = dessin(assemblage, "dessiner", scene, LARGEUR, HAUTEUR, "1", "0");
        Image phong = dessin(base, "dessiner", scene, LARGEUR, HAUTEUR, "1", "0");
        Image eteinte = dessin(base, "dessiner", boule + "0 0 0\n", LARGEUR, HAUTEUR, "1", "0");
        double reste = 1;
        for (String facteur : new String[] {"1", "2", "4"}) {
            for (String decalage : new String[] {"0", "0.5"}) {
                Image predite = eteinte.plus(dessin(base, "blinn", scene, LARGEUR, HAUTEUR, decalage, facteur));
                reste = Math.min(reste, reste(lui, phong, predite));
            }
        }
        return mesure(reste, "le passage de Phong à (N.H)^ns, ^2ns ou ^4ns");
    }

    /**
     * À chaque distance, une boule face à une lampe placée dans l'œil, claire au centre et sombre au bord : de ses
     * couleurs sans brume et avec, on tire k et k fois la couleur de la brume ; puis l'image d'une brume de même couleur
     * partout, dont le k ne décroît pas et reste entre 0 et 1.
     */
    private Verdict brume(Assemblage assemblage) throws Arret {
        double focale = 1 / Math.tan(Math.toRadians(15));
        StringBuilder texte = new StringBuilder();
        for (int i = 0; i < DISTANCES.length; i++) {
            double y = 0.6 - 0.2 * i;
            double t = DISTANCES[i] / Math.sqrt(0.25 + y * y + focale * focale);
            texte.append(String.format(Locale.ROOT, "[Sphere %d]\ncentre=%.9f %.9f %.9f\nrayon=%.9f\nKd=0.9 0.9 0.9\n", i,
                    0.5 + 0.5 * t, y + t * y, t * focale, 0.06 * (1 + t)));
        }
        texte.append(String.format(Locale.ROOT, "[Lampe 1]\nposition=0 0 %.9f\ncouleur=1 1 1\n", -focale));
        String scene = texte.toString();
        Image sans = dessin(base, "dessiner", scene, 2 * LARGEUR, 2 * HAUTEUR, "1", "0");
        Image avec = dessin(assemblage, "dessiner", scene, 2 * LARGEUR, 2 * HAUTEUR, "1", "0");
        double[] k = new double[DISTANCES.length];
        double[] brume = new double[3];
        double sommeK = 0;
        StringBuilder suite = new StringBuilder();
        for (int i = 0; i < k.length; i++) {
            double[] droite = sans.regression(avec, 120 - DEMI, 12 + 16 * i - DEMI, 2 * DEMI + 1);
            suite.append(String.format(Locale.FRANCE, "%sk(%.3g) = %.2f", i > 0 ? ", " : "", DISTANCES[i], 1 - droite[3]));
            k[i] = Math.max(i > 0 ? k[i - 1] : 0, Math.min(1, 1 - droite[3]));
            sommeK += 1 - droite[3];
            for (int c = 0; c < 3; c++) {
                brume[c] += droite[c];
            }
        }
        double apres = 0;
        double avant = 0;
        for (int i = 0; i < k.length; i++) {
            for (int p = 0; p < (2 * DEMI + 1) * (2 * DEMI + 1); p++) {
                int pixel = (12 + 16 * i - DEMI + p / (2 * DEMI + 1)) * sans.largeur + 120 - DEMI + p % (2 * DEMI + 1);
                for (int c = 0; c < 3; c++) {
                    double predite = k[i] * brume[c] / sommeK + (1 - k[i]) * sans.brut(pixel, c);
                    apres += Math.pow(avec.brut(pixel, c) - predite, 2);
                    avant += Math.pow(avec.brut(pixel, c) - sans.brut(pixel, c), 2);
                }
            }
        }
        boolean croit = k[k.length - 1] > k[0] + 1e-3;
        double reste = croit && avant > 1e-9 ? Math.sqrt(apres / avant) : 1;
        // dans un miroir, une boule au loin : ce que sa couleur change doit avoir traversé la brume deux fois
        double vu = reflet(assemblage) / reflet(base);
        boolean reflets = !(vu > (1 - k[0]) * (1 - k[k.length - 1] / 2));
        return mesure(reflets ? reste : Math.max(reste, TOUT + 0.1), "selon la distance : " + suite + (croit ? ""
                : " ; plus loin, il en faut plus") + (reflets ? "" : " ; ce que montre un miroir n'est pas dans la brume"));
    }

    /** Dans un miroir à la première distance, une boule à la dernière : ce que change sa couleur à celle du pixel. */
    private double reflet(Assemblage assemblage) throws Arret {
        double[] vues = new double[2];
        for (int i = 0; i < 2; i++) {
            vues[i] = dessin(assemblage, "dessiner", "[Sphere miroir]\ncentre=0 -7.071067812 10.071067812\n"
                    + "rayon=10\nKs=1 1 1\nns=1000\n[Sphere]\ncentre=0 100 3\nrayon=20\nKd="
                    + (i == 0 ? "0.9 0.9 0.9" : "0.1 0.1 0.1") + "\n[Lampe]\nposition=0 40 -40\ncouleur=1 1 1\n", LARGEUR,
                    HAUTEUR, "2", "0").brut(HAUTEUR / 2 * LARGEUR + LARGEUR / 2, 0);
        }
        return vues[0] - vues[1];
    }
}
