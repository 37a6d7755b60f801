package lancer.mesures.vitesse;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import lancer.Constantes;
import lancer.mesures.scenes.Scenes;

/** La liste de toutes les mesures. */
final class Catalogue {

    /** Ce qui se compare : les réglages que l'on choisit, sur plusieurs scènes. */
    static final String CHOIX = "choix";

    /** L'erreur, avec anticrénelage, selon le nombre de réflexions. */
    static final String REFLETS = "reflets";

    /** Le temps de la commande selon le nombre de lampes, de pixels, de fils, de sphères. */
    static final String LAMPES = "lampes";
    static final String PIXELS = "pixels";
    static final String FILS = "fils";
    static final String SPHERES = "spheres";

    /** Ce que coûte chaque chose, et chaque scène livrée. */
    static final String COUTS = "couts";

    static final String COURS = "scene1";
    static final String PROGRAMME = "programme";

    private static final List<String> CHRONOMETREES = Arrays.asList(COURS, "bowling", "miroirs", "tournesol");

    /** Ceux des réglages qui sont chronométrés aussi hors de la scène du cours : les autres y prendraient dix minutes. */
    private static final List<String> PARTOUT = Arrays.asList(Reglage.UN_RAYON.nom(), Reglage.grille(2).nom(),
            Reglage.coins(3, 0.05).nom(), Reglage.partage(4, 0.2).nom(), Reglage.partage(8, 0.06).nom(), Reglage.auto(1).nom());

    /** Réglages de « partage » : n, puis le seuil. */
    private static final double[][] PARTAGES = {{4, 0.2}, {8, 0.1}, {8, 0.06}, {16, 0.03}, {16, 0.01}};

    private static final int[] PROFONDEURS = {0, 1, 2, 3, 4, 5, 6, 8, 10, 15, 20, 30, 40};

    /** Nombre de sphères jusqu'auquel les boucles du cours, puis POV-Ray, sont mesurés : au-delà, il y faudrait des minutes. */
    private static final int BOUCLES_MAX = 1000;
    private static final int POVRAY_MAX = 100_000;

    private final boolean court;
    final Taille taille;

    /** @param court vrai pour de petites images et de petites foules */
    Catalogue(boolean court) {
        this.court = court;
        taille = court ? new Taille(200, 150) : new Taille(Constantes.LARGEUR_IMAGE, Constantes.HAUTEUR_IMAGE);
    }

    /** Ce dont l'erreur et les rayons sont mesurés. */
    List<Groupe> comptes() throws IOException {
        List<Groupe> groupes = new ArrayList<>();
        for (String scene : CHRONOMETREES) {
            groupes.add(choix(scene));
        }
        for (String scene : Scenes.DIFFICILES) {
            groupes.add(choix(scene));
        }
        for (String scene : livrees()) {
            Groupe reflets = new Groupe(REFLETS, scene, scene);
            for (int p : PROFONDEURS) {
                reflets.avec(Reglage.partage(8, 0.06).par("reflets", String.valueOf(p), "--reflets", String.valueOf(p), "--seuil", "0"),
                        p, taille);
            }
            groupes.add(reflets);
        }
        return groupes;
    }

    /** Ce qui est chronométré. */
    List<Groupe> temps() throws IOException {
        List<Groupe> groupes = CHRONOMETREES.stream().map(this::choix).collect(Collectors.toList());
        groupes.stream().filter(g -> !g.scene.equals(COURS)).forEach(g -> g.essais.removeIf(e -> !PARTOUT.contains(e.reglage.nom())));
        groupes.add(couts());
        groupes.add(lampes());
        groupes.add(pixels());
        groupes.add(fils());
        for (int n = 1; n <= (court ? 100 : 1_000_000); n *= 10) {
            groupes.add(spheres(n));
        }
        return groupes;
    }

    static List<String> livrees() throws IOException {
        return Scenes.livrees().stream().map(f -> f.getFileName().toString().replace(".ini", "")).collect(Collectors.toList());
    }

    private Groupe choix(String scene) {
        Groupe choix = new Groupe(CHOIX, scene, scene).avec(Reglage.UN_RAYON, 0, taille).avec(Reglage.COINS_PAR_DEFAUT, 0, taille);
        for (int n = 2; n <= 4; n++) {
            choix.avec(Reglage.grille(n), 0, taille);
        }
        choix.avec(Reglage.coins(3, 0.05), 0, taille).avec(Reglage.coins(4, 0.05), 0, taille);
        for (double[] p : PARTAGES) {
            choix.avec(Reglage.partage((int) p[0], p[1]), 0, taille);
        }
        return choix.avec(Reglage.auto(1), 0, taille);
    }

    private Groupe couts() {
        return new Groupe(COUTS, COURS, COURS).avec(Reglage.UN_RAYON, 0, taille).avec(Reglage.MAKE, 0, taille)
                .avec(Reglage.UN_RAYON.par("reflets", "0", "--reflets", "0"), 0, taille)
                .avec(new Reglage("brume", "", "brume", ""), 0, taille).avec(new Reglage("Blinn", "", "blinn", ""), 0, taille)
                .avec(Reglage.COINS_PAR_DEFAUT, 0, taille).avec(Reglage.BOUCLES, 0, taille);
    }

    /** Des lampes de plus, autour de la scène du cours, qui en a deux. */
    private Groupe lampes() {
        Groupe groupe = new Groupe(LAMPES, COURS, COURS);
        for (int n : new int[] {2, 4, 8, 16, 32}) {
            StringBuilder sections = new StringBuilder();
            for (int k = 2; k < n; k++) {
                double angle = 2 * Math.PI * k / n;
                sections.append("[Lampe de plus " + k + "]\nposition=" + Math.round(400 * Math.cos(angle)) + " 420 "
                        + Math.round(400 * Math.sin(angle)) + "\ncouleur=0.1 0.1 0.1\n");
            }
            groupe.avec(new Reglage("lampes", String.valueOf(n), "lancer", sections.toString()), n, taille);
        }
        return groupe;
    }

    private Groupe pixels() {
        Groupe groupe = new Groupe(PIXELS, COURS, COURS);
        for (int n : new int[] {1, 2, 3, 4}) {
            Taille grande = new Taille(n * taille.largeur, n * taille.hauteur);
            groupe.avec(new Reglage("pixels", grande.toString(), "lancer", ""), grande.pixels() / 1e6, grande);
        }
        return groupe;
    }

    /** De quoi occuper chaque fil longtemps : une grille de 4 × 4 rayons par pixel. */
    private Groupe fils() {
        Groupe groupe = new Groupe(FILS, COURS, COURS);
        for (int n = 1; n <= 2 * taille.fils; n++) {
            groupe.avec(Reglage.grille(4).par("fils", String.valueOf(n), "--fils", String.valueOf(n)), n, taille);
        }
        return groupe;
    }

    private Groupe spheres(int n) {
        Groupe groupe = new Groupe(SPHERES, Scenes.FOULE + "-" + n, Scenes.FOULE + "-1")
                .avec(new Reglage(PROGRAMME, "", "lancer", ""), n, taille);
        if (n <= BOUCLES_MAX) {
            groupe.avec(Reglage.BOUCLES, n, taille);
        }
        if (n <= POVRAY_MAX) {
            groupe.avec(new Reglage(Reglage.POVRAY, "", "", ""), n, taille);
        }
        return groupe.avec(new Reglage(Reglage.EMBREE, "", "", ""), n, taille);
    }

    /** Le réglage d'une mesure de {@link #CHOIX}. */
    static Reglage reglage(Mesure mesure) {
        return new Catalogue(false).choix(mesure.scene).essais.stream().map(e -> e.reglage).filter(mesure::estDe).findFirst()
                .orElseThrow(() -> new IllegalArgumentException("le catalogue n'a plus " + mesure.nom()));
    }
}
