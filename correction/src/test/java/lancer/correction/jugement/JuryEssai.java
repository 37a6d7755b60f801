package lancer.correction.jugement;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import lancer.correction.ClasseEssai;
import lancer.correction.depot.Depot;
import lancer.correction.depot.Rendu;
import lancer.correction.isolement.Confinement;
import lancer.correction.isolement.Limites;
import lancer.correction.modele.SourcesDuCours;

/** De quoi juger des rendus d'essai, sans pages ni notes. */
abstract class JuryEssai extends ClasseEssai {

    /** Pour des rendus dont certains ne finissent pas. */
    static final Limites COURTES = new Limites(0.5, 2, 160);

    /** Pour des rendus dont chacun finit : une machine où d'autres travaillent peut les faire attendre, ou calculer plus. */
    static final Limites PATIENTES = new Limites(10, 60, 160);

    /** Juge tous les rendus de ce dossier ; les résultats par nom. */
    static Map<String, Resultat> juger(Path rendus, Confinement confinement, Limites limites) {
        Jury jury = JuryPartage.de(confinement);
        List<Rendu> liste = Depot.lire(rendus, false);
        jury.reference();
        jury.machines.limites = limites;
        Map<String, Resultat> resultats = new TreeMap<>();
        jury.juger(liste, resultat -> resultats.put(resultat.nom, resultat));
        jury.machines.limites = Limites.ORDINAIRES;
        return resultats;
    }

    /** Le dossier des classes de ce rendu. */
    static Path sources(Path rendu) throws IOException {
        return Files.createDirectories(rendu.resolve("lancer-base/src/main/java/lancer"));
    }

    /** Écrit le corrigé comme un rendu. */
    static Path ecrireCorrige(Path rendu) throws IOException {
        Path sources = sources(rendu);
        for (String classe : SourcesDuCours.A_COMPLETER) {
            Files.writeString(sources.resolve(classe + ".java"), SourcesDuCours.corrige(classe));
        }
        return sources;
    }

    static void ecrire(Path dossier, String classe, String texte) throws IOException {
        Files.writeString(dossier.resolve(classe + ".java"), texte);
    }

    /** Un rendu dont la seule classe est un Vecteur achevé, et dont la soustraction fait d'abord ceci. */
    static Path attaque(Path rendu, String java) throws IOException {
        Path sources = sources(rendu);
        ecrire(sources, "Vecteur", SourcesDuCours.corrige("Vecteur").replaceFirst("(public Vecteur sub\\(Vecteur v\\) \\{)",
                "$1 " + Matcher.quoteReplacement("if (true) { " + java + " }")));
        return sources;
    }

    /** Vrai si les images de toutes les scènes sont celles du corrigé. */
    static boolean imageJuste(Resultat resultat) {
        return Reference.SCENES.keySet().stream().allMatch(scene -> resultat.verdicts.get(GrilleDeNotation.IMAGE + "." + scene).compte());
    }

    /** Les étapes où quelque chose est raté. */
    static TreeSet<String> ratees(Resultat resultat) {
        TreeSet<String> etapes = new TreeSet<>();
        resultat.verdicts.forEach((id, verdict) -> {
            if (verdict.rate()) {
                etapes.add(id.replaceFirst("\\..*", ""));
            }
        });
        return etapes;
    }
}
