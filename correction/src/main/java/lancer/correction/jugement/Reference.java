package lancer.correction.jugement;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lancer.correction.depot.Cours;
import lancer.correction.depot.Projet;
import lancer.correction.depot.Rendu;
import lancer.correction.isolement.Arret;
import lancer.correction.jugement.Machines.Assemblage;
import lancer.correction.jugement.Verdict.Etat;
import lancer.correction.modele.SourcesDuCours;

/**
 * Référence à laquelle on compare : le corrigé, jugé comme un rendu, et le projet à compléter, qui dit ce que l'on réussit sans
 * rien faire. Une vérification ne compte que si le corrigé la passe et que le projet à compléter ne la passe pas.
 */
public final class Reference implements AutoCloseable {

    /** Les scènes dont on juge l'image : largeur, hauteur, profondeur. */
    public static final Map<String, int[]> SCENES = new LinkedHashMap<>();

    static {
        SCENES.put("scene1", new int[] {160, 120, 5});
        SCENES.put("ombres", new int[] {80, 60, 1});
        SCENES.put("miroirs", new int[] {80, 60, 40});
    }

    /** Les classes du cours, telles que le JDK les lit. */
    final Cours cours;
    final Verifications junit;
    public final List<Verification> verifications;
    /** La source de {@code lancer.Appels}. */
    final String appels;
    /** Verdicts du projet à compléter, par vérification, chaque classe seule parmi celles du corrigé. */
    private final Map<String, Verdict> seules = new HashMap<>();
    private final long graine;
    public final GrilleDeNotation grille;
    /** Le corrigé, compilé, et qui l'interroge. */
    private final Assemblage assemblage;
    private final JugeRendu juge;

    /** @param graine d'où sont tirées les scènes dont on juge l'image */
    Reference(Machines machines, Machines.Compilation compilation, String sansConfinement, long graine) throws Arret {
        this.graine = graine;
        cours = new Cours(compilation::lire, Map.of());
        Rendu squelette = new Rendu("", "");
        SourcesDuCours.tout(SourcesDuCours::squelette).forEach((nom, texte) -> squelette.sources.put(nom + ".java",
                texte.getBytes(StandardCharsets.UTF_8)));
        Projet projet = Projet.copies(squelette, compilation::lire, cours, Map.of()).get(0);
        // les vérifications sont compilées contre les doublures des classes du projet à compléter
        Doublures doublures = new Doublures(compilation.compiler(projet.base).classes);
        appels = doublures.getAppels();
        junit = new Verifications(compilation.compiler(doublures.sources).classes);
        verifications = junit.lister();
        juge = new JugeRendu(this, compilation, machines, projet, new Resultat("", ""));
        assemblage = juge.assembler(SourcesDuCours.tout(SourcesDuCours::corrige));
        Map<String, Verdict> duSquelette = juge.lancer(juge.ensemble, verifications).verdicts;
        verifications.forEach(v -> v.compte = duSquelette.get(v.id()).etat != Etat.REUSSI);
        grille = new GrilleDeNotation(sansConfinement);
        remplir();
        for (String classe : SourcesDuCours.A_COMPLETER) {
            seules.putAll(juge.lancer(juge.seule(classe), juge.verifications(v -> v.classe.equals(classe))).verdicts);
        }
    }

    /** Le texte d'une scène dont on juge l'image. */
    String scene(String nom) {
        return SourcesDuCours.scene(nom, graine);
    }

    /** Remplit la grille : les vérifications, les scènes, les extensions et les consignes, et ce que le corrigé en dessine. */
    private void remplir() throws Arret {
        verifications.forEach(grille::ajouter);
        for (Map.Entry<String, int[]> scene : SCENES.entrySet()) {
            String nom = scene.getKey();
            int[] taille = scene.getValue();
            grille.ajouter(new Verification(GrilleDeNotation.IMAGE, "L'image entière", nom, "",
                    "la scène « " + nom + " », par toutes les classes du rendu, est celle du corrigé"));
            grille.images.put(nom, juge.images.dessiner(assemblage, nom));
            grille.images.put(nom + GrilleDeNotation.AU_CENTRE, juge.images.tracer(assemblage,
                    scene(nom), taille[0], taille[1], taille[2]));
        }
        for (String nom : SourcesDuCours.VARIANTES) {
            String[] titres = GrilleDeNotation.EXTENSIONS.get(nom);
            grille.ajouter(new Verification(nom, titres[0], "image", "", titres[1]));
            grille.images.put(nom, juge.images.etendre(juge.assembler(SourcesDuCours.acheve(nom)), nom, true));
        }
        Projet.CONSIGNES.forEach((nom, titre) ->
                grille.ajouter(new Verification(GrilleDeNotation.CONSIGNES, "Consignes de rendu", nom, "", titre)));
    }

    /** Verdict de la classe du projet à compléter, seule parmi celles du corrigé, à cette vérification. */
    Verdict duSquelette(Verification v) {
        return seules.get(v.id());
    }

    /** Réponses, en chemin, que font les méthodes du corrigé. */
    synchronized String chemin(String scene, double x, double y) throws Arret {
        return juge.images.decrire(assemblage, scene, x, y);
    }

    @Override
    public void close() {
        juge.close();
    }
}
