package lancer.correction.jugement;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import lancer.correction.depot.Renommage;
import lancer.correction.isolement.Arret;
import lancer.correction.modele.Modele;

/** Les assemblages de classes qu'on compile d'un rendu : tout ensemble, ou une classe seule dans le corrigé. */
final class Chantier {

    private final Machines.Compilation compilation;
    private final Renommage noms;
    private final String appels;

    /** @param noms ceux que prennent nos propres classes ; @param appels la source de {@code lancer.Appels} */
    Chantier(Machines.Compilation compilation, Renommage noms, String appels) {
        this.compilation = compilation;
        this.noms = noms;
        this.appels = appels;
    }

    /** Un assemblage compilé : les octets de chaque classe, par son nom, et les fautes. */
    static final class Assemblage {

        final Map<String, byte[]> classes;
        final List<Faute> fautes;

        Assemblage(Map<String, byte[]> classes, List<Faute> fautes) {
            this.classes = classes;
            this.fautes = fautes;
        }

        List<Faute> fautesDe(String classe) {
            return fautes.stream().filter(f -> f.classe().equals(classe)).collect(Collectors.toList());
        }
    }

    /** Toutes les classes du corrigé : {@code lancer/Vecteur} et son texte. */
    static Map<String, String> corrige() {
        Map<String, String> sources = new TreeMap<>();
        Modele.classes().forEach(c -> sources.put("lancer/" + c, Modele.corrige(c)));
        return sources;
    }

    static Map<String, String> squelette() {
        Map<String, String> sources = new TreeMap<>();
        Modele.classes().forEach(c -> sources.put("lancer/" + c, Modele.squelette(c)));
        return sources;
    }

    /** Compile les classes d'un rendu, avec ce qui les appelle et les sonde. */
    Assemblage assembler(Map<String, String> classes) throws Arret {
        Map<String, String> sources = new TreeMap<>(classes);
        sources.put("lancer/" + Modele.APPELS, noms.dans(appels));
        Modele.SONDES.forEach(s -> sources.put("lancer/" + s, noms.dans(Modele.sonde(s))));
        return compiler(sources);
    }

    /** Compile ces sources, et rien d'autre. */
    Assemblage compiler(Map<String, String> sources) throws Arret {
        return compilation.compiler(sources);
    }
}
