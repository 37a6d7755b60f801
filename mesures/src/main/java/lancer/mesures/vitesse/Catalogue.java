package lancer.mesures.vitesse;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import lancer.Constantes;
import lancer.Lampe;
import lancer.Point;
import lancer.Scene;
import lancer.antialias.Antialias;
import lancer.blinn.Blinn;
import lancer.brume.Brume;
import lancer.contrat.Modele;
import lancer.mesures.Verite;

/** Tout ce qui se mesure. Le catalogue court en est une partie : {@code make mesures RAPIDE=1}. */
final class Catalogue {

    static final String BROUILLON = "brouillon";
    static final String UN_RAYON = "un rayon";
    static final String GRILLE = "grille";
    static final String COINS = "coins";
    static final String PARTAGE = "partage";
    static final String PROFONDEUR = "profondeur";
    static final String SEUIL = "seuil";
    static final String PHONG = "phong";
    static final String BLINN = "blinn";
    static final String PROGRAMME = "programme";
    static final String BOUCLES = "boucles du cours";

    /** La scène telle qu'elle est, à laquelle se comparent toutes celles qui demandent autre chose. */
    static final String TELLE_QUELLE = "telle quelle";

    private static final List<String> SCENES = Arrays.asList("scene1", "bowling", "miroirs", "tournesol");
    private static final List<String> SCENES_COURT = Arrays.asList("scene1", "tournesol");

    /** Celle à qui l'on demande autre chose. */
    static final String SCENE_DEMANDES = "scene1";

    private final boolean court;

    Catalogue(boolean court) {
        this.court = court;
    }

    /** Les scènes des courbes principales. */
    List<String> scenes() {
        return court ? SCENES_COURT : SCENES;
    }

    /** Les anticrénelages, et les deux façons de n'en pas faire. */
    List<Methode> echantillonnages() {
        List<Methode> methodes = new ArrayList<>();
        methodes.add(Methode.de(Famille.ECHANTILLONNAGE, BROUILLON, "4 × 4").enBrouillon());
        methodes.add(Methode.de(Famille.ECHANTILLONNAGE, UN_RAYON, ""));
        for (int n : court ? new int[] {2, 3} : new int[] {2, 3, 4, 8}) {
            methodes.add(Methode.de(Famille.ECHANTILLONNAGE, GRILLE, n + " × " + n).echantillonnee(Antialias.coins(n, 0)));
        }
        double[][] coins = court ? new double[][] {{3, 0.05}, {4, 0.05}}
                : new double[][] {{3, 0.02}, {3, 0.05}, {3, 0.2}, {4, 0.05}, {4, 0.2}, {8, 0.05}, {8, 0.2}};
        for (double[] c : coins) {
            methodes.add(Methode.de(Famille.ECHANTILLONNAGE, COINS, adaptative(c))
                    .echantillonnee(Antialias.coins((int) c[0], c[1])));
        }
        double[][] partages = court ? new double[][] {{4, 0.1}, {8, 0.06}}
                : new double[][] {{4, 0.06}, {4, 0.1}, {4, 0.2}, {8, 0.03}, {8, 0.06}, {8, 0.1}, {8, 0.2}, {16, 0.03}, {16, 0.06},
                    {16, 0.1}};
        for (double[] p : partages) {
            methodes.add(Methode.de(Famille.ECHANTILLONNAGE, PARTAGE, adaptative(p))
                    .partagee(Antialias.partage((int) p[0], p[1])));
        }
        return methodes;
    }

    private static String adaptative(double[] nEtSeuil) {
        return String.format(Locale.ROOT, "n=%.0f seuil=%s", nEtSeuil[0], Double.toString(nEtSeuil[1]));
    }

    /** Les limites de réflexion : la profondeur au seuil par défaut, et le seuil sans limite de profondeur. */
    List<Methode> reflets() {
        List<Methode> methodes = new ArrayList<>();
        for (int p : court ? new int[] {0, 1, 2, 5} : new int[] {0, 1, 2, 3, 5, 10}) {
            methodes.add(Methode.de(Famille.REFLETS, PROFONDEUR, "p=" + p + " seuil=1/1024").limitee(p, Constantes.SEUIL));
        }
        for (int s : court ? new int[] {1024, 16} : new int[] {0, 4096, 1024, 256, 16}) {
            methodes.add(Methode.de(Famille.REFLETS, SEUIL, "p=" + Verite.PROFONDEUR + " seuil=" + (s == 0 ? "0" : "1/" + s))
                    .limitee(Verite.PROFONDEUR, s == 0 ? 0 : 1.0 / s));
        }
        return methodes;
    }

    /** Phong et Blinn, par le chemin rapide et par les boucles du cours. */
    List<Methode> modeles() {
        List<Methode> methodes = new ArrayList<>();
        for (String chemin : court ? Arrays.asList("rapide") : Arrays.asList("rapide", "lisible")) {
            Methode phong = Methode.de(Famille.MODELE, PHONG, chemin);
            Methode blinn = Methode.de(Famille.MODELE, BLINN, chemin).sur(Catalogue::enBlinn);
            methodes.add(chemin.equals("lisible") ? phong.lisible() : phong);
            methodes.add(chemin.equals("lisible") ? blinn.lisible() : blinn);
        }
        return methodes;
    }

    /** Une chose de plus, ou de moins, à la fois. */
    List<Methode> demandes() {
        List<Methode> methodes = new ArrayList<>(Arrays.asList(
                demande(TELLE_QUELLE, ""),
                demande("lampe", "une de moins").sur(s -> new Scene(s.getObjets(), s.getLampes().subList(1, s.getLampes().size()))),
                demande("lampe", "une de plus").sur(Catalogue::uneLampeDePlus),
                demande("reflets", "aucun").limitee(0, Constantes.SEUIL),
                demande("reflets", "un seul").limitee(1, Constantes.SEUIL),
                demande("brume", "").sur(Catalogue::enBrume),
                demande("blinn", "").sur(Catalogue::enBlinn),
                demande("antialias partage", "n=4 seuil=0.1").partagee(Antialias.partage(4, 0.1)),
                demande("antialias coins", "n=3 seuil=0.05").echantillonnee(Antialias.coins(3, 0.05))));
        if (!court) {
            methodes.add(demande("grille complète", "3 × 3").echantillonnee(Antialias.coins(3, 0)));
        }
        return methodes;
    }

    private static Methode demande(String nom, String parametres) {
        return Methode.de(Famille.DEMANDES, nom, parametres);
    }

    /** Le programme, et tant que cela ne dure pas trop les boucles du cours. */
    List<Methode> spheres(int nombre) {
        List<Methode> methodes = new ArrayList<>();
        methodes.add(Methode.de(Famille.SPHERES, PROGRAMME, ""));
        if (nombre <= (court ? 100 : 1000)) {
            methodes.add(Methode.de(Famille.SPHERES, BOUCLES, "").lisible());
        }
        return methodes;
    }

    /** Combien de sphères. */
    int[] nombres() {
        return court ? new int[] {1, 10, 100, 1000} : new int[] {1, 10, 100, 1000, 10000, 100000, 1000000};
    }

    /** Ce que fait le programme, ou le module antialias, quand on ne lui demande rien. */
    static boolean estParDefaut(Releve r) {
        switch (r.methode) {
            case UN_RAYON:
                return true;
            case COINS:
                return r.parametres.equals("n=3 seuil=0.05");
            case PROFONDEUR:
                return r.parametres.equals("p=" + Constantes.MAX_REFLETS + " seuil=1/1024");
            default:
                return false;
        }
    }

    private static Scene enBrume(Scene scene) {
        Modele modele = new Modele();
        modele.setAtmosphere(new Brume());
        return new Scene(scene.getObjets(), scene.getLampes(), modele);
    }

    private static Scene enBlinn(Scene scene) {
        Modele modele = new Modele();
        modele.setSpecularite(new Blinn());
        return new Scene(scene.getObjets(), scene.getLampes(), modele);
    }

    /** La première lampe, de l'autre côté. */
    private static Scene uneLampeDePlus(Scene scene) {
        List<Lampe> lampes = new ArrayList<>(scene.getLampes());
        Point p = lampes.get(0).getPosition();
        lampes.add(new Lampe(new Point(-p.x, p.y, p.z), lampes.get(0).getCouleur()));
        return new Scene(scene.getObjets(), lampes);
    }
}
