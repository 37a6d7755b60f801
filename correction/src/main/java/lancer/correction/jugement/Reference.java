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
 * Références d'un jugement : le corrigé, jugé comme un rendu, et le projet à compléter, qui donne les vérifications déjà réussies. Une
 * vérification ne compte que si le corrigé la réussit et que le projet à compléter la rate.
 */
public final class Reference implements AutoCloseable {

    /** Les scènes dont l'image est jugée : largeur, hauteur, profondeur. */
    public static final Map<String, int[]> SCENES = new LinkedHashMap<>();

    static {
        SCENES.put("scene1", new int[] {160, 120, 5});
        SCENES.put("ombres", new int[] {80, 60, 1});
        SCENES.put("miroirs", new int[] {80, 60, 40});
    }

    /** Les classes du cours, lues par le JDK. */
    final Cours cours;
    final Verifications junit;
    public final List<Verification> verifications;
    /** La source de {@code lancer.Appels}. */
    final String appels;
    /** Verdicts de chaque classe du projet à compléter, seule avec celles du corrigé, dès qu'un rendu les demande. */
    private final Map<String, Map<String, Verdict>> seules = new HashMap<>();
    private final Map<String, List<?>> chemins = new HashMap<>();
    private final long graine;
    public final GrilleDeNotation grille;
    /** Le corrigé compilé, et le juge qui l'exécute. */
    private final Assemblage assemblage;
    private final JugeRendu juge;

    /** @param graine le nombre d'où viennent les scènes jugées */
    Reference(Machines machines, Machines.Compilation compilation, long graine) throws Arret {
        this.graine = graine;
        cours = new Cours(compilation);
        Rendu squelette = new Rendu("", "");
        SourcesDuCours.tout(SourcesDuCours::squelette).forEach((nom, texte) -> squelette.sources.put(nom + ".java",
                texte.getBytes(StandardCharsets.UTF_8)));
        Projet projet = Projet.lire(squelette, compilation, cours);
        // les vérifications sont compilées avec les doublures des classes du projet à compléter
        Doublures doublures = new Doublures(compilation.compiler(projet.base).classes);
        appels = doublures.getAppels();
        junit = new Verifications(compilation.compiler(doublures.sources).classes, graine);
        verifications = junit.lister();
        juge = new JugeRendu(this, compilation, machines, projet, new Resultat(squelette, ""));
        assemblage = juge.assembler(SourcesDuCours.tout(SourcesDuCours::corrige));
        Map<String, Verdict> duSquelette = juge.lancer(juge.ensemble, verifications).verdicts;
        verifications.forEach(v -> v.compte = duSquelette.get(v.id()).etat != Etat.REUSSI);
        grille = new GrilleDeNotation();
        remplir();
        for (String classe : SourcesDuCours.A_COMPLETER) {
            // compilées ici, où personne d'autre ne compile encore
            juge.seule(classe);
        }
    }

    /** Le texte d'une scène jugée. */
    String scene(String nom) {
        return SourcesDuCours.scene(nom, graine);
    }

    /** Remplit la grille : vérifications, scènes, extensions, consignes, images du corrigé. */
    private void remplir() throws Arret {
        verifications.stream().filter(v -> !v.etape.equals(Verification.REPETITION)).forEach(grille::ajouter);
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

    /** Verdict de la classe du projet à compléter, seule avec celles du corrigé, à cette vérification. */
    synchronized Verdict duSquelette(Verification v) throws Arret {
        if (!seules.containsKey(v.classe)) {
            seules.put(v.classe, juge.lancer(juge.seule(v.classe), juge.verifications(w -> w.classe.equals(v.classe))).verdicts);
        }
        return seules.get(v.classe).get(v.id());
    }

    /** Réponses intermédiaires des méthodes du corrigé : les rendus les demandent aux mêmes pixels. */
    synchronized List<?> chemin(String scene, double x, double y) throws Arret {
        String ici = scene + " " + x + " " + y;
        if (!chemins.containsKey(ici)) {
            chemins.put(ici, juge.images.decrire(assemblage, scene, x, y));
        }
        return chemins.get(ici);
    }

    @Override
    public void close() {
        juge.close();
    }
}
