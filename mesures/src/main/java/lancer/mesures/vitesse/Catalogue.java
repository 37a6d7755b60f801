package lancer.mesures.vitesse;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import lancer.Constantes;
import lancer.Lampe;
import lancer.Point;
import lancer.Scene;
import lancer.blinn.Blinn;
import lancer.brume.Brume;
import lancer.contrat.Modele;
import lancer.mesures.Gabarit;
import lancer.mesures.scenes.Scenes;
import lancer.mesures.stabilite.Formule;
import lancer.mesures.stabilite.Regime;

/** Liste de toutes les mesures. {@code make mesures RAPIDE=1} n'en fait qu'une partie. */
final class Catalogue {

    static final String METHODES = "methodes";
    static final String DEMANDES = "demandes";
    static final String SPHERES = "spheres";
    static final String BESOINS = "besoins";

    /** Famille où la scène est un régime de rayons, et la méthode un calcul de distance. */
    static final String INTERSECTIONS = "intersections";

    static final String UN_RAYON = "un rayon";
    static final String GRILLE = "grille";
    static final String COINS = "coins";
    static final String PARTAGE = "partage";
    static final String REFLETS = "reflets";
    static final String ENSEMBLE = "partage, tous les reflets";
    static final String POVRAY = "POV-Ray";
    static final String AUTO = "--auto";
    static final String EMBREE = "Embree";
    static final String TELLE_QUELLE = "telle quelle";
    static final String PROGRAMME = "programme";
    static final String BOUCLES = "boucles du cours";

    static final String AUTRE = "autre programme";

    static final String COINS_DEFAUT = "n=3 seuil=0.05";

    /** Nombre de sphères jusqu'auquel les boucles du cours sont mesurées : au-delà, elles durent des minutes. */
    private static final int BOUCLES_MAX = 1000;

    private final boolean court;

    Catalogue(boolean court) {
        this.court = court;
    }

    /** Des méthodes comparées sur la même scène, à la même référence. */
    static final class Groupe {

        final String famille;
        final String scene;
        final List<Methode> methodes;

        /** Nombre de machines virtuelles où chaque méthode et la référence sont mesurées ; 1 pour des programmes entiers. */
        final int lancements;

        Groupe(String famille, String scene, List<Methode> methodes, int lancements) {
            this.famille = famille;
            this.scene = scene;
            this.methodes = methodes;
            this.lancements = lancements;
        }

        /** Vrai si une manche est un programme entier, de la commande au PNG ; faux si elle est un dessin de code déjà compilé. */
        boolean estDeProgrammes() {
            return !famille.equals(DEMANDES) && !famille.equals(INTERSECTIONS);
        }
    }

    /** Les réglages comparés sur chaque scène ; le catalogue court n'a que la scène du cours. */
    List<Groupe> reglages() {
        List<Groupe> groupes = new ArrayList<>();
        for (String scene : court ? new String[] {"scene1"} : new String[] {"scene1", "bowling", "miroirs", "tournesol"}) {
            groupes.add(new Groupe(METHODES, scene, methodes(scene), 1));
        }
        return groupes;
    }

    /** Toutes les mesures chronométrées, dans l'ordre ; le catalogue court n'a que la scène du cours et de petites foules. */
    List<Groupe> groupes() {
        List<Groupe> groupes = reglages();
        // de ces scènes, seule la première image est mesurée
        for (String scene : court ? new String[0] : new String[] {"brume", "diffus", "ombres"}) {
            groupes.add(new Groupe(BESOINS, scene, new ArrayList<>(Collections.singletonList(new Methode(UN_RAYON, ""))), 1));
        }
        groupes.add(new Groupe(DEMANDES, "scene1", demandes(), court ? 2 : 5));
        for (int n : court ? new int[] {1, 100} : new int[] {1, 10, 100, 1000, 10000, 100000, 1000000}) {
            groupes.add(new Groupe(SPHERES, Scenes.FOULE + "-" + n, spheres(n <= BOUCLES_MAX), 1));
        }
        return groupes;
    }

    /** De petites scènes, pour le choix de {@link lancer.rapide.Preparation} : les boucles du cours, et d'autres programmes. */
    List<Groupe> processus(List<Path> autres) {
        List<Groupe> groupes = new ArrayList<>();
        String toutes = court ? "scene1 foule-3" : "scene1 tp foule-1 foule-3 foule-10 foule-30 foule-100 foule-300";
        for (String scene : toutes.split(" ")) {
            List<Methode> m = new ArrayList<>(Collections.singletonList(new Methode(BOUCLES, "").enBoucles()));
            for (Path jar : autres) {
                m.add(new Methode(AUTRE, jar.getFileName().toString()));
                m.get(m.size() - 1).jar = jar;
            }
            groupes.add(new Groupe(SPHERES, scene, m, 1));
        }
        return groupes;
    }

    Taille[] tailles() {
        Taille[] tailles = {new Taille(80, 60), new Taille(200, 150), new Taille(800, 600), new Taille(1920, 1080)};
        return court ? Arrays.copyOf(tailles, 2) : tailles;
    }

    /** Méthodes que {@code make noyaux} compare à celle des manuels. */
    static List<Groupe> intersections() {
        List<Methode> methodes = Arrays.stream(Formule.values()).map(f -> new Methode(f.name(), "")).collect(Collectors.toList());
        return Arrays.stream(Regime.values()).map(r -> new Groupe(INTERSECTIONS, r.name(), methodes, 5)).collect(Collectors.toList());
    }

    /** @throws IllegalArgumentException si le catalogue n'a pas cette méthode */
    static Methode methode(String famille, String scene, String cle) {
        return new Catalogue(false).groupes().stream().filter(g -> g.famille.equals(famille) && g.scene.equals(scene))
                .flatMap(g -> g.methodes.stream()).filter(m -> m.cle().equals(cle)).findFirst()
                .orElseThrow(() -> new IllegalArgumentException("pas de " + cle + " : " + famille + " " + scene));
    }

    /** Les méthodes de la courbe d'une scène. Dans {@code miroirs}, l'anticrénelage n'a d'intérêt qu'avec tous les reflets. */
    private static List<Methode> methodes(String scene) {
        boolean miroirs = scene.equals("miroirs");
        List<Methode> m = new ArrayList<>();
        m.add(new Methode(UN_RAYON, ""));
        for (int p : miroirs ? new int[] {0, 2, 10, 20, Gabarit.PROFONDEUR} : new int[] {0, 1, 2}) {
            m.add(new Methode(REFLETS, String.valueOf(p)).limitee(p, Constantes.SEUIL));
        }
        for (int n : miroirs ? new int[] {2, 3} : scene.equals("scene1") ? new int[] {2, 3, 4, 8} : new int[] {2, 3, 4}) {
            m.add(new Methode(GRILLE, n + " × " + n).echantillonnee(COINS, n, 0));
        }
        for (int n : scene.equals("scene1") ? new int[] {3, 4, 8} : new int[] {3, 4}) {
            m.add(new Methode(COINS, "n=" + n + " seuil=0.05").echantillonnee(COINS, n, 0.05));
        }
        double[][] partages = {{3, 0.3}, {4, 0.2}, {4, 0.1}, {8, 0.1}, {8, 0.06}, {16, 0.06}, {16, 0.03}};
        for (double[] p : miroirs ? new double[0][] : partages) {
            m.add(new Methode(PARTAGE, "n=" + (int) p[0] + " seuil=" + p[1]).echantillonnee(PARTAGE, (int) p[0], p[1]));
        }
        // seule cette scène demande les deux réglages à la fois
        double[][] ensembles = {{3, 0.3, 16}, {4, 0.2, 16}, {4, 0.2, 128}, {4, 0.1, 128}, {8, 0.06, 128}, {8, 0.06, 512}};
        for (double[] e : miroirs ? ensembles : new double[0][]) {
            m.add(new Methode(ENSEMBLE, "n=" + (int) e[0] + " seuil=" + e[1] + " jusqu'à 1/" + (int) e[2])
                    .echantillonnee(PARTAGE, (int) e[0], e[1]).limitee(Gabarit.PROFONDEUR, 1 / e[2]));
        }
        m.add(new Methode(BOUCLES, "").enBoucles());
        m.add(new Methode(POVRAY, "grille adaptative").parPovRay("+A0.1", "+R3", "+AM2"));
        m.add(new Methode(AUTO, "erreur=1").automatique());
        return m;
    }

    /** La scène du cours avec un seul changement à la fois. */
    private List<Methode> demandes() {
        List<Methode> m = new ArrayList<>(Arrays.asList(new Methode(TELLE_QUELLE, ""),
                new Methode("lampe", "une de plus").sur(Catalogue::uneLampeDePlus),
                new Methode("reflets", "aucun").limitee(0, Constantes.SEUIL),
                new Methode("brume", "").sur(s -> variee(s, v -> v.setAtmosphere(new Brume()))),
                new Methode("Blinn", "").sur(s -> variee(s, v -> v.setSpecularite(new Blinn()))),
                new Methode(COINS, COINS_DEFAUT).echantillonnee(COINS, 3, 0.05)));
        if (!court) {
            m.add(new Methode(PARTAGE, "n=4 seuil=0.1").echantillonnee(PARTAGE, 4, 0.1));
            m.add(new Methode(BOUCLES, "").enBoucles());
        }
        return m;
    }

    /** Le programme entier, les boucles du cours si elles sont mesurées, et d'autres programmes. */
    private static List<Methode> spheres(boolean boucles) {
        List<Methode> m = new ArrayList<>();
        m.add(new Methode(PROGRAMME, ""));
        if (boucles) {
            m.add(new Methode(BOUCLES, "").enBoucles());
        }
        m.add(new Methode(POVRAY, "").parPovRay());
        m.add(new Methode(EMBREE, ""));
        return m;
    }

    private static Scene variee(Scene scene, Consumer<Modele> variante) {
        Modele modele = new Modele();
        variante.accept(modele);
        return scene.avec(modele);
    }

    /** La même scène avec la première lampe dupliquée de l'autre côté. */
    private static Scene uneLampeDePlus(Scene scene) {
        List<Lampe> lampes = new ArrayList<>(scene.getLampes());
        Point p = lampes.get(0).getPosition();
        lampes.add(new Lampe(new Point(-p.x, p.y, p.z), lampes.get(0).getCouleur()));
        return new Scene(scene.getObjets(), lampes);
    }
}
