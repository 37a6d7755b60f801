package lancer.mesures.vitesse;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import lancer.mesures.scenes.Scenes;

/** La liste de toutes les mesures. */
final class Catalogue {

    /** Ce qui se compare : les réglages que l'on choisit, sur plusieurs scènes. */
    static final String CHOIX = "choix";

    /** L'erreur, avec anticrénelage, selon le nombre de réflexions. */
    static final String REFLETS = "reflets";

    /** Le temps de la commande selon le nombre de fils, de sphères. */
    static final String FILS = "fils";
    static final String SPHERES = "spheres";

    /** Ce que coûte chaque chose, et chaque scène livrée. */
    static final String COUTS = "couts";

    static final String COURS = "scene1";
    static final String PROGRAMME = "programme";

    /** Réglages de « partage » : n, puis le seuil. */
    private static final double[][] PARTAGES = {{2, 0.15}, {3, 0.12}, {4, 0.07}, {6, 0.06}, {12, 0.045}, {16, 0.03}, {16, 0.02},
        {16, 0.01}};

    /** Les réglages chronométrés sur une scène difficile. */
    private static final List<String> PETITS = Arrays.asList("un rayon", "grille 2 × 2", "grille 3 × 3", "coins n=3 seuil=0.05",
            "partage n=2 seuil=0.15", "partage n=4 seuil=0.07", "partage n=12 seuil=0.045", "partage n=16 seuil=0.03");

    /** Celui qui tient un niveau sur toutes les scènes. */
    static final Reglage UN_NIVEAU = Reglage.partage(12, 0.045);

    /** Plus grand n des grilles de n × n rayons par pixel. */
    private static final int GRILLE_MAX = 5;

    private static final int[] PROFONDEURS = {0, 1, 2, 3, 4, 5, 6, 8, 10, 15, 20, 30, 40};

    /** Nombre de sphères jusqu'auquel les boucles du cours, puis POV-Ray, sont mesurés : au-delà, il y faudrait des minutes. */
    private static final int BOUCLES_MAX = 1000;
    private static final int POVRAY_MAX = 10_000;
    private static final int SPHERES_MAX = 1_000_000;

    private Catalogue() {
    }

    /** Ce dont l'erreur et les rayons sont mesurés. */
    static List<Groupe> comptes() throws IOException {
        List<Groupe> groupes = new ArrayList<>();
        for (String scene : livrees()) {
            groupes.add(choix(scene));
            Groupe reflets = new Groupe(REFLETS, scene, scene);
            for (int p : PROFONDEURS) {
                reflets.avec(UN_NIVEAU.par("reflets", String.valueOf(p), "--reflets", String.valueOf(p), "--seuil", "0"), p);
            }
            groupes.add(reflets);
        }
        Scenes.DIFFICILES.forEach(scene -> groupes.add(choix(scene)));
        return groupes;
    }

    /** Ce qui est chronométré. */
    static List<Groupe> temps() throws IOException {
        List<Groupe> groupes = new ArrayList<>(Collections.singletonList(fils()));
        groupes.add(choix(COURS));
        for (String scene : Scenes.DIFFICILES) {
            Groupe difficile = choix(scene);
            difficile.essais.removeIf(e -> !PETITS.contains(e.reglage.nom()));
            groupes.add(difficile);
        }
        groupes.add(couts());
        for (int n = 1; n <= SPHERES_MAX; n *= 10) {
            groupes.add(spheres(n));
        }
        return groupes;
    }

    /** Dit d'une mesure si elle est encore demandée. */
    static Predicate<Mesure> demandees() throws IOException {
        List<Groupe> tous = new ArrayList<>(comptes());
        tous.addAll(temps());
        return m -> tous.stream().anyMatch(g -> g.volet.equals(m.volet) && g.scene.equals(m.scene)
                && g.essais.stream().anyMatch(e -> m.estDe(e.reglage)));
    }

    static List<String> livrees() throws IOException {
        return Scenes.livrees().stream().map(f -> f.getFileName().toString().replace(".ini", "")).collect(Collectors.toList());
    }

    private static Groupe choix(String scene) {
        Groupe choix = new Groupe(CHOIX, scene, scene).avec(Reglage.UN_RAYON, 0);
        for (int n = 2; n <= GRILLE_MAX; n++) {
            choix.avec(Reglage.grille(n), 0);
        }
        choix.avec(Reglage.coins(3, 0.05), 0).avec(Reglage.coins(4, 0.05), 0);
        for (double[] p : PARTAGES) {
            choix.avec(Reglage.partage((int) p[0], p[1]), 0);
        }
        return choix;
    }

    private static Groupe couts() {
        return new Groupe(COUTS, COURS, COURS).avec(Reglage.UN_RAYON, 0).avec(Reglage.MAKE, 0)
                .avec(Reglage.UN_RAYON.par("reflets", "0", "--reflets", "0"), 0)
                .avec(new Reglage("brume", "", "brume", ""), 0).avec(new Reglage("Blinn", "", "blinn", ""), 0)
                .avec(Reglage.COINS_PAR_DEFAUT, 0).avec(Reglage.BOUCLES, 0);
    }

    /** De quoi occuper chaque fil longtemps : une grille de 3 × 3 rayons par pixel. */
    private static Groupe fils() {
        Groupe groupe = new Groupe(FILS, COURS, COURS);
        for (int n = 1; n <= 2 * Taille.PUBLIEE.fils; n++) {
            groupe.avec(Reglage.grille(3).par("fils", String.valueOf(n), "--fils", String.valueOf(n)), n);
        }
        return groupe;
    }

    private static Groupe spheres(int n) {
        Groupe groupe = new Groupe(SPHERES, Scenes.FOULE + "-" + n, Scenes.FOULE + "-1")
                .avec(new Reglage(PROGRAMME, "", "lancer", ""), n);
        if (n <= BOUCLES_MAX) {
            groupe.avec(Reglage.BOUCLES, n);
        }
        if (n <= POVRAY_MAX) {
            groupe.avec(new Reglage(Reglage.POVRAY, "", "", ""), n);
        }
        return groupe.avec(new Reglage(Reglage.EMBREE, "", "", ""), n);
    }

    /** Le réglage d'une mesure de {@link #CHOIX}. */
    static Reglage reglage(Mesure mesure) {
        return choix(mesure.scene).essais.stream().map(e -> e.reglage).filter(mesure::estDe).findFirst()
                .orElseThrow(() -> new IllegalArgumentException("le catalogue n'a plus " + mesure.nom()));
    }
}
