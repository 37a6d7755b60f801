package lancer.correction.jugement;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import lancer.correction.depot.Projet;
import lancer.correction.depot.Renommage;
import lancer.correction.isolement.Arret;
import lancer.correction.jugement.Chantier.Assemblage;
import lancer.correction.jugement.Verdict.Etat;
import lancer.correction.modele.Modele;

/**
 * À quoi l'on compare : le corrigé, jugé comme un rendu, et le projet à compléter, qui dit ce que l'on réussit sans
 * rien faire. Une vérification ne compte que si le corrigé la passe et que le projet à compléter ne la passe pas.
 */
public final class Reference implements AutoCloseable {

    private static final Map<String, String> BESOINS = Map.of("phong", "lambert", "ombres", "lambert", "reflets",
            "lambert");

    /** Les scènes dont on juge l'image : largeur, hauteur, profondeur. */
    public static final Map<String, int[]> SCENES = new LinkedHashMap<>();

    static {
        SCENES.put("scene1", new int[] {160, 120, 5});
        SCENES.put("ombres", new int[] {80, 60, 1});
        SCENES.put("miroirs", new int[] {80, 60, 40});
    }

    /** Ce qu'on en garde d'une fois à l'autre. */
    private static final class Memoire {

        private List<Verification> verifications;
        /** Les vérifications et les doublures, compilées, et ce qui leur répond, à compiler avec chaque rendu. */
        private final HashMap<String, byte[]> classes = new HashMap<>();
        private String appels;
        private final HashMap<String, Verdict> duSquelette = new HashMap<>();
        private final HashMap<String, Image> coins = new HashMap<>();
        private final HashMap<String, Image> centres = new HashMap<>();
    }

    private final Machines machines;
    private final Map<String, String> titres = new HashMap<>();
    private final Memoire memoire;
    private Verifications junit;

    /** Le corrigé, compilé, et qui l'interroge : quand on en a besoin. */
    private Juge corrige;
    private Assemblage assemblage;

    /** @param souvenir fichier où se trouve, ou sera mis, ce qui n'est pas à refaire */
    Reference(Machines machines, Path souvenir) throws Arret, IOException {
        this.machines = machines;
        Object connue = Souvenirs.relire(souvenir);
        if (connue instanceof Memoire) {
            memoire = (Memoire) connue;
            junit = new Verifications(memoire.classes);
        } else {
            memoire = new Memoire();
            apprendre();
            Souvenirs.ecrire(souvenir, memoire);
        }
        memoire.verifications.forEach(v -> titres.put(v.etape, v.titreEtape.replaceFirst("^\\d+\\. ", "")));
    }

    private void apprendre() throws Arret {
        Projet projet = new Projet(Chantier.squelette(), Collections.emptyMap(), new ArrayList<>());
        try (Machines.Compilation compilation = machines.new Compilation()) {
            compilerVerifications(new Chantier(compilation, projet.getNoms(), ""));
            memoire.verifications = junit.lister();
            preparer();
            for (String scene : SCENES.keySet()) {
                memoire.coins.put(scene, corrige.image(assemblage, scene, 0));
                memoire.centres.put(scene, corrige.image(assemblage, scene, 0.5));
            }
            Chantier sien = new Chantier(compilation, projet.getNoms(), memoire.appels);
            try (Juge juge = new Juge(this, sien, machines, projet)) {
                memoire.duSquelette.putAll(juge.lancer(sien.assembler(projet.getBase()),
                        memoire.verifications));
                for (String classe : Modele.A_COMPLETER) {
                    List<Verification> siennes = memoire.verifications.stream().filter(v -> v.classe.equals(classe)
                            && memoire.duSquelette.get(v.id()).etat != Etat.REUSSI).collect(Collectors.toList());
                    memoire.duSquelette.putAll(juge.lancer(juge.seule(classe), siennes));
                }
            }
        }
    }

    /** Compile les vérifications contre les doublures des classes du projet à compléter. */
    private void compilerVerifications(Chantier sien) throws Arret {
        Doublures doublures = new Doublures(sien.compiler(Chantier.squelette()).classes);
        memoire.appels = doublures.getAppels();
        Map<String, String> sources = new HashMap<>();
        doublures.getSources().forEach((nom, texte) -> sources.put("lancer/" + nom, texte));
        sources.put("lancer/Tests", Modele.tests());
        Assemblage tests = sien.compiler(sources);
        if (!tests.fautes.isEmpty()) {
            throw new IllegalStateException("les vérifications ne se compilent pas : " + tests.fautes.get(0));
        }
        memoire.classes.putAll(tests.classes);
        junit = new Verifications(memoire.classes);
    }

    private void preparer() throws Arret {
        if (assemblage != null) {
            return;
        }
        Chantier chantier;
        try (Machines.Compilation compilation = machines.new Compilation()) {
            chantier = new Chantier(compilation, new Renommage(Map.of()), memoire.appels);
            assemblage = chantier.assembler(Chantier.corrige());
        }
        if (!assemblage.fautes.isEmpty()) {
            throw new IllegalStateException("le corrigé ne se compile pas : " + assemblage.fautes.get(0));
        }
        corrige = new Juge(this, chantier, machines, null);
    }

    Verifications getJUnit() {
        return junit;
    }

    /** Le corrigé, compilé. */
    synchronized Assemblage getCorrige() throws Arret {
        preparer();
        return assemblage;
    }

    /** La source de {@code lancer.Appels}. */
    String getAppels() {
        return memoire.appels;
    }

    public List<Verification> getVerifications() {
        return Collections.unmodifiableList(memoire.verifications);
    }

    /** Vrai si le projet à compléter ne la passe pas : elle compte. */
    public boolean compte(Verification v) {
        return memoire.duSquelette.get(v.id()).etat != Etat.REUSSI;
    }

    String messageDuSquelette(Verification v) {
        return memoire.duSquelette.get(v.id()).message;
    }

    /** Le titre de l'étape dont celle-ci dépend, vide si elle ne dépend que des classes des étudiants. */
    String besoin(String etape) {
        return BESOINS.containsKey(etape) ? titres.get(BESOINS.get(etape)) : "";
    }

    /** L'image du corrigé, aux coordonnées entières ou au centre des pixels. */
    public Image getImage(String scene, boolean auCentre) {
        return (auCentre ? memoire.centres : memoire.coins).get(scene);
    }

    /** Ce que répondent, en chemin, les méthodes du corrigé. */
    synchronized String chemin(String scene, double x, double y) throws Arret {
        preparer();
        return corrige.chemin(assemblage, scene, x, y);
    }

    @Override
    public void close() {
        if (corrige != null) {
            corrige.close();
        }
    }
}
