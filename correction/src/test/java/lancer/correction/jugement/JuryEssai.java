package lancer.correction.jugement;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import lancer.correction.ClasseEssai;
import lancer.correction.depot.Depot;
import lancer.correction.depot.Rendu;
import lancer.correction.isolement.Confinement;
import lancer.correction.isolement.Limites;
import lancer.correction.modele.Modele;

/** De quoi juger des rendus d'essai, sans pages ni notes. */
abstract class JuryEssai extends ClasseEssai {

    /** Pour des rendus dont certains ne finissent pas. */
    static final Limites COURTES = new Limites(1, 2, 160, 60);

    /** Pour des rendus dont chacun finit : une machine où d'autres travaillent peut les faire attendre, ou calculer plus. */
    static final Limites PATIENTES = new Limites(10, 60, 160, 60);

    /** Juge tous les rendus de ce dossier ; les résultats par nom. */
    static Map<String, Resultat> juger(Path rendus, Path travail, Confinement confinement, Limites limites) throws IOException {
        Files.createDirectories(travail);
        List<Rendu> liste = Depot.lire(rendus, travail);
        Map<String, Resultat> resultats = new LinkedHashMap<>();
        try (Jury jury = new Jury(travail.toRealPath(), confinement, limites)) {
            List<Resultat> tous = jury.juger(liste, (rang, resultat) -> { });
            for (int k = 0; k < tous.size(); k++) {
                resultats.put(liste.get(k).nom, tous.get(k));
            }
        }
        return resultats;
    }

    /** Écrit le corrigé comme un rendu. */
    static Path ecrireCorrige(Path dossier) throws IOException {
        Path sources = Files.createDirectories(dossier.resolve("lancer-base/src/main/java/lancer"));
        for (String classe : Modele.A_COMPLETER) {
            Files.write(sources.resolve(classe + ".java"), Modele.corrige(classe).getBytes(StandardCharsets.UTF_8));
        }
        return sources;
    }

    /** Vrai si les images de toutes les scènes sont celles du corrigé. */
    static boolean imageJuste(Resultat resultat) {
        return Reference.SCENES.keySet().stream().allMatch(scene -> resultat.verdicts.get(Grille.IMAGE + "." + scene).compte());
    }

    /** Les étapes où quelque chose est raté. */
    static TreeSet<String> ratees(Resultat resultat) {
        TreeSet<String> etapes = new TreeSet<>();
        resultat.verdicts.forEach((id, verdict) -> {
            if (verdict.etat == Verdict.Etat.RATE) {
                etapes.add(id.replaceFirst("\\..*", ""));
            }
        });
        return etapes;
    }
}
