package lancer.mesures.vitesse;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.Constantes;
import lancer.antialias.Antialias;
import lancer.blinn.Blinn;
import lancer.brume.Brume;
import lancer.mesures.Gabarit;
import lancer.mesures.scenes.Scenes;
import lancer.mesures.stabilite.Formule;
import lancer.mesures.stabilite.Regime;

/** Liste de toutes les mesures. */
final class Catalogue {

    static final String METHODES = "methodes";
    static final String DEMANDES = "demandes";
    static final String SPHERES = "spheres";
    static final String BESOINS = "besoins";

    /** Famille où la scène est un régime de rayons, et la méthode un calcul de distance. */
    static final String INTERSECTIONS = "intersections";

    /** Le programme sans option, référence des temps. */
    static final String UN_RAYON = "un rayon";

    /** Le module antialias sans option, sur une scène qui n'a pas de section {@code [Antialias]}. */
    static final String SANS_SECTION = "coins par défaut";
    static final String GRILLE = "grille";
    static final String COINS = "coins";
    static final String PARTAGE = "partage";
    static final String REFLETS = "reflets";
    static final String POVRAY = "POV-Ray";
    static final String AUTO = "--auto";
    static final String EMBREE = "Embree";
    static final String PROGRAMME = "programme";
    static final String BOUCLES = "boucles du cours";

    /** Le programme sans option, avec les options que « make » donne à la machine virtuelle d'une image. */
    static final String MAKE = "options de make";
    static final List<String> OPTIONS_DE_MAKE = Arrays.asList("-XX:+UseSerialGC", "-Xmn16m");

    static final String COURS = "scene1";

    /** Scènes chronométrées. */
    private static final List<String> CHRONOMETREES = Arrays.asList(COURS, "bowling", "miroirs", "tournesol");

    /** Réglages de « partage » : n, puis le seuil. Leur erreur est mesurée sur toutes les scènes. */
    private static final double[][] PARTAGES = {{3, 0.3}, {4, 0.2}, {8, 0.1}, {8, 0.06}, {16, 0.03}, {16, 0.02}, {16, 0.01}};

    /** Seuil au-dessous duquel « partage » n'est chronométré que sur la scène du cours : ailleurs, il y faudrait des minutes. */
    private static final double SEUIL_LENT = 0.05;

    /** Produit des Ks au-dessous duquel un reflet n'est pas suivi, dans les réglages où leur nombre n'est pas limité. */
    private static final double SEUIL = 1 / 128.0;

    /** Nombre de sphères jusqu'auquel les boucles du cours, puis POV-Ray, sont mesurés : au-delà, il y faudrait des minutes. */
    private static final int BOUCLES_MAX = 1000;
    private static final int POVRAY_MAX = 100_000;

    private Catalogue() {
    }

    /** Des méthodes comparées sur la même scène, à la même référence. */
    static final class Groupe {

        final String famille;
        final String scene;
        final List<Methode> methodes;

        Groupe(String famille, String scene, Methode... methodes) {
            this.famille = famille;
            this.scene = scene;
            this.methodes = new ArrayList<>(Arrays.asList(methodes));
        }
    }

    /** Les réglages dont l'erreur est mesurée, sur les scènes chronométrées puis sur les scènes difficiles. */
    static List<Groupe> reglages() {
        return Stream.concat(CHRONOMETREES.stream(), Scenes.DIFFICILES.stream())
                .map(scene -> new Groupe(METHODES, scene, methodes(scene).toArray(new Methode[0]))).collect(Collectors.toList());
    }

    /** Toutes les mesures chronométrées, dans l'ordre. @param court vrai pour de petites foules seulement */
    static List<Groupe> groupes(boolean court) {
        List<Groupe> groupes = reglages().stream().filter(g -> CHRONOMETREES.contains(g.scene)).collect(Collectors.toList());
        groupes.stream().filter(g -> !g.scene.equals(COURS)).forEach(g -> g.methodes.removeIf(m -> m.nom.equals(PARTAGE)
                && Double.parseDouble(m.parametres.replaceFirst(".*=", "")) < SEUIL_LENT));
        // de ces scènes, seule la première image est mesurée
        for (String scene : new String[] {"brume", "diffus", "ombres"}) {
            groupes.add(new Groupe(BESOINS, scene, new Methode(UN_RAYON, "")));
        }
        Methode lampe = new Methode("une lampe", "de plus");
        lampe.section = "[Lampe de plus]\nposition=300 420 -260\ncouleur=1.12 1.04 0.9\n";
        Methode make = new Methode(MAKE, "");
        make.machine = OPTIONS_DE_MAKE;
        groupes.add(new Groupe(DEMANDES, COURS, make, lampe, new Methode("brume", "").variante("brume", m -> m.setAtmosphere(new Brume())),
                new Methode("Blinn", "").variante("blinn", m -> m.setSpecularite(new Blinn()))));
        for (int n = 1; n <= (court ? 100 : 1_000_000); n *= 10) {
            groupes.add(new Groupe(SPHERES, Scenes.FOULE + "-" + n, spheres(n)));
        }
        return groupes;
    }

    /** Méthodes que {@code make noyaux} compare à celle des manuels. */
    static List<Groupe> intersections() {
        return Arrays.stream(Regime.values()).map(r -> new Groupe(INTERSECTIONS, r.name(), Arrays.stream(Formule.values())
                .map(f -> new Methode(f.name(), "")).toArray(Methode[]::new))).collect(Collectors.toList());
    }

    /** @throws IllegalArgumentException si le catalogue n'a pas cette méthode */
    static Methode methode(String famille, String scene, String cle) {
        return Stream.concat(groupes(false).stream(), reglages().stream()).filter(g -> g.famille.equals(famille) && g.scene.equals(scene))
                .flatMap(g -> g.methodes.stream()).filter(m -> m.cle().equals(cle)).findFirst()
                .orElseThrow(() -> new IllegalArgumentException("pas de " + cle + " : " + famille + " " + scene));
    }

    /** Les méthodes mesurées sur une scène ; sur une scène difficile, celles que l'on peut conseiller. */
    private static List<Methode> methodes(String scene) {
        List<Methode> m = new ArrayList<>();
        m.add(new Methode(UN_RAYON, ""));
        m.add(new Methode(SANS_SECTION, "").sansSection(Antialias.coins(3, 0.05)));
        for (double[] p : PARTAGES) {
            m.add(tousLesReflets(PARTAGE, "n=" + (int) p[0] + " seuil=" + p[1], (int) p[0], p[1]));
        }
        m.add(new Methode(AUTO, "erreur=1").automatique());
        if (Scenes.DIFFICILES.contains(scene)) {
            return m;
        }
        for (int p : scene.equals("miroirs") ? new int[] {0, 2, 10, Gabarit.PROFONDEUR} : new int[] {0, 1, 2}) {
            m.add(new Methode(REFLETS, String.valueOf(p)).limitee(p, Constantes.SEUIL));
        }
        for (int n : scene.equals(COURS) ? new int[] {2, 3, 4, 8} : scene.equals("miroirs") ? new int[] {2} : new int[] {2, 3}) {
            m.add(tousLesReflets(GRILLE, n + " × " + n, n, 0));
        }
        for (int n : scene.equals(COURS) ? new int[] {3, 4, 8} : scene.equals("miroirs") ? new int[] {3} : new int[] {3, 4}) {
            m.add(tousLesReflets(COINS, "n=" + n + " seuil=0.05", n, 0.05));
        }
        if (scene.equals("tournesol")) {
            // mille boules : deux minutes à elles deux
            return m;
        }
        m.add(new Methode(BOUCLES, "").enBoucles());
        m.add(new Methode(POVRAY, "grille adaptative").parPovRay("+A0.1", "+R3", "+AM2"));
        return m;
    }

    private static Methode tousLesReflets(String nom, String parametres, int n, double contraste) {
        return new Methode(nom, parametres).echantillonnee(nom.equals(PARTAGE) ? PARTAGE : COINS, n, contraste)
                .limitee(Gabarit.PROFONDEUR, SEUIL);
    }

    /** Le programme entier, et d'autres tant qu'ils ne sont pas trop longs. */
    private static Methode[] spheres(int n) {
        List<Methode> m = new ArrayList<>(Collections.singletonList(new Methode(PROGRAMME, "")));
        if (n <= BOUCLES_MAX) {
            m.add(new Methode(BOUCLES, "").enBoucles());
        }
        if (n <= POVRAY_MAX) {
            m.add(new Methode(POVRAY, "").parPovRay());
        }
        m.add(new Methode(EMBREE, ""));
        return m.toArray(new Methode[0]);
    }
}
